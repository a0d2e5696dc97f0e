"""How far something has come: who is told, and the bar that shows it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress as Bar

Progress = Callable[[int, int], object]
"""Told now and then of how many are done and of all; ends the work by what is true."""


@contextmanager
def telling(progress: Progress | bool | None, words: str) -> Iterator[Progress]:
    """Give what is to be told how many runs are done: the function that was given, a bar for true, or nobody."""
    if callable(progress):
        yield progress
    elif progress is True:
        with counting(words, "runs") as tell:
            yield tell
    elif not progress:
        yield _tell_nobody
    else:
        raise TypeError(f"progress: must be true, false or a function, got {progress!r}")


@contextmanager
def counting(words: str, unit: str) -> Iterator[Progress]:
    """Show on a terminal or in a notebook how many of all are done, at what speed, and how long the rest will take."""
    bar = new_bar()
    if not (sys.stderr.isatty() or bar.console.is_jupyter):
        yield _tell_nobody
        return
    with bar:
        task = bar.add_task(words, total=None, speed="")
        first: list[tuple[float, int]] = []

        def tell(done: int, of: int) -> None:
            now = bar.get_time()
            if not first:
                first.append((now, done))
            rate = (done - first[0][1]) / max(now - first[0][0], 1e-9)
            bar.update(task, completed=done, total=of, speed=f"{done:,} of {of:,}, {rate:,.0f} {unit}/s")

        yield tell


def new_bar() -> Bar:
    """Give a bar on stderr with words, a speed and the time left, which goes when it is done."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TaskProgressColumn(),
        TextColumn("{task.fields[speed]}"),
        TimeRemainingColumn(),
    )
    return Progress(*columns, console=Console(stderr=True), transient=True)


def _tell_nobody(done: int, of: int) -> None: ...
