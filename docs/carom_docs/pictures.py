"""The pictures of the pages.

A page may show what its own code blocks write: ``pictures/<page>/<file>``; for those the build follows the blocks as
the tests do. All others, ``pictures/drawn/<name>.svg``, are those of `drawings`.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from carom_docs import drawings
from carom_docs.blocks import DOCS, follow


def write(folder: Path) -> None:
    """Make every picture that a page shows, into `folder`, which is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "drawn").mkdir(parents=True)
    drawings.draw_all(folder / "drawn")
    for page in sorted(DOCS.rglob("*.md")):
        files = shown_files(page)
        if files:
            _keep_what_it_writes(page, files, folder / page.relative_to(DOCS).with_suffix(""))


def shown_files(page: Path) -> list[str]:
    """Give the files that a page shows of those that its own blocks write."""
    own = re.escape(f"pictures/{page.relative_to(DOCS).with_suffix('').as_posix()}/")
    return re.findall(rf"\((?:\.\./)*{own}([^)\s]+)\)", page.read_text(encoding="utf-8"))


def _keep_what_it_writes(page: Path, files: list[str], folder: Path) -> None:
    with tempfile.TemporaryDirectory() as place, _working_in(Path(place)):
        follow(page)
        for file in files:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, folder / file)


@contextmanager
def _working_in(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
