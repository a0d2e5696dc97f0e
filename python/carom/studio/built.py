"""What is built of the page, as far as this installation has it."""

from __future__ import annotations

from pathlib import Path

from carom.errors import CaromError

HERE = Path(__file__).parent
PAGE = HERE / "page"
PLAYER = HERE / "player.html"


class MissingPageError(CaromError):
    """The installation holds no built page."""


def missing() -> MissingPageError:
    """Say how to get the page."""
    return MissingPageError(
        "this installation has no built page: wheels of Carom have it, and in a copy of the repository "
        "make package-page builds it, with Node.js"
    )


def page_files() -> dict[str, Path]:
    """Give the files of the page by their paths within it, such as ``assets/index.css``; links are none of them.

    Raises
    ------
    MissingPageError
        When there is no page.
    """
    found = {
        path.relative_to(PAGE).as_posix(): path
        for path in sorted(PAGE.rglob("*"))
        if path.is_file() and not _through_link(path)
    }
    if "index.html" not in found:
        raise missing()
    return found


def _through_link(path: Path) -> bool:
    return any(part.is_symlink() for part in (path, *path.parents) if part.is_relative_to(PAGE) and part != PAGE)


def player_template() -> str:
    """Give the page that plays a run, without a run in it.

    Raises
    ------
    MissingPageError
        When it was not built.
    """
    try:
        return PLAYER.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise missing() from None
