"""Reading texts, and writing files so that an interrupted run leaves no half file."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from carom.errors import CaromError


@contextmanager
def replacing(path: str | os.PathLike[str], *, durable: bool = False) -> Iterator[Path]:
    """Give a temporary path beside `path`; when the block ends well, it is renamed to `path`.

    The temporary name keeps the suffix, so that writers which choose a format by it work. When the block
    raises, the temporary file is removed and an older file at `path` stays as it was. A link stays a link: the
    file that it leads to is replaced.

    Parameters
    ----------
    path : path-like
        Where the file is to be. Its folder must exist.
    durable : bool
        Whether it is on the disk, and not in its cache only, before it takes the place of an older one.

    Raises
    ------
    OSError
        When the file cannot be written there; it speaks of `path`, not of the temporary name.
    """
    target = Path(os.path.realpath(path))
    _check_place(path, target)
    temporary = target.with_name(f".{target.stem[:32]}.{os.urandom(4).hex()}{target.suffix}")
    try:
        with speaking_of(temporary, path):
            yield temporary
            if durable:
                _sync(temporary)
            temporary.replace(target)
            if durable and os.name == "posix":  # elsewhere a folder cannot be opened
                _sync(target.parent)
    finally:
        with suppress(OSError):
            temporary.unlink()


def sweep(path: str | os.PathLike[str]) -> None:
    """Remove temporary files that a killed process left of `path`."""
    target = Path(os.path.realpath(path))
    name = re.compile(rf"\.{re.escape(target.stem[:32])}\.[0-9a-f]{{8}}{re.escape(target.suffix)}")
    for left in target.parent.iterdir():
        if name.fullmatch(left.name):
            left.unlink(missing_ok=True)


def _sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextmanager
def speaking_of(temporary: Path, path: str | os.PathLike[str]) -> Iterator[None]:
    """Make errors about a temporary file, or files in a temporary folder, speak of the place it is meant for."""
    try:
        yield
    except OSError as error:
        named = Path(error.filename) if isinstance(error.filename, (str, os.PathLike)) else None
        if named is None or not named.is_relative_to(temporary):
            raise
        place = Path(path) / named.relative_to(temporary)
        raise OSError(error.errno, error.strerror, str(place)) from None


def read_text(path: str | os.PathLike[str], problem: type[CaromError], wanted: str) -> str:
    """Read a text in UTF-8, leaving out a byte order mark; what is none is a `problem` that names the file."""
    if Path(path).is_dir():  # asked beforehand: Windows has no error of its own for it
        raise problem(f"{path}: a folder, not {wanted}")
    try:
        return Path(path).read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise problem(f"{path}: no such file") from None
    except UnicodeDecodeError as error:
        raise problem(f"{path}: not a text in UTF-8 (byte {error.start})") from None


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write `text` to `path` in UTF-8, with the same line ends on every system."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def _check_place(path: str | os.PathLike[str], target: Path) -> None:
    """Refuse what is there and no file: a folder, and a device, which a file would take the place of."""
    if target.is_dir():
        raise OSError(errno.EISDIR, "a folder, not a file", os.fspath(path))
    if target.exists() and not target.is_file():
        raise OSError(errno.EINVAL, "a device or pipe, not a file", os.fspath(path))
    if not target.parent.is_dir():
        raise OSError(errno.ENOENT, f"the folder {Path(path).parent} does not exist", os.fspath(path))
