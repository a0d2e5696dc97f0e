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
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from carom_docs import drawings
from carom_docs.blocks import DOCS, follow


def write(folder: Path) -> None:
    """Make every picture that a page shows, into `folder`, which is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "drawn").mkdir(parents=True)
    drawings.draw_all(folder / "drawn")
    pages = [page for page in sorted(DOCS.rglob("*.md")) if shown_files(page)]
    # Each page in a process, since it works in a folder of its own.
    with ProcessPoolExecutor() as pool:
        for _ in pool.map(_keep_what_it_writes, pages, [folder] * len(pages)):
            pass


def shown_files(page: Path) -> list[str]:
    """Give the files that a page shows of those that its own blocks write."""
    own = re.escape(f"pictures/{page.relative_to(DOCS).with_suffix('').as_posix()}/")
    return re.findall(rf"\((?:\.\./)*{own}([^)\s]+)\)", page.read_text(encoding="utf-8"))


def _keep_what_it_writes(page: Path, folder: Path) -> None:
    """Follow a page, and copy the files that it shows."""
    kept = folder / page.relative_to(DOCS).with_suffix("")
    with tempfile.TemporaryDirectory() as place, _working_in(Path(place)):
        follow(page)
        for file in shown_files(page):
            (kept / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, kept / file)


@contextmanager
def _working_in(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
