"""What commands print: tables, JSON, and errors as ``error: place: message``."""

from __future__ import annotations

import json
import re
import shutil
import sys
import textwrap
import warnings
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import typer

from carom.cli import INTERRUPTED, is_closed_pipe
from carom.errors import CaromError, ListedError

PROBLEM = 1
TROUBLE = 2
"""The exit code of a comparison that could not be made, as of ``diff`` and ``cmp``; of wrong usage everywhere."""
LEAST_WORDS = 8
"""A column of words is folded, where it must be, into lines of so many letters."""


@contextmanager
def reporting(code: int = PROBLEM) -> Iterator[None]:
    """Turn what can go wrong in a command into lines on stderr and an exit code; also a decorator."""
    try:
        with _warning_plainly():
            yield
    except ListedError as error:
        for place, message in error.problems:
            say_error(place, message)
        raise typer.Exit(code) from None
    except CaromError as error:
        say_error("", str(error))
        raise typer.Exit(code) from None
    except OSError as error:
        if is_closed_pipe(error):
            raise
        say_error(str(error.filename or ""), error.strerror or str(error))
        raise typer.Exit(code) from None
    except KeyboardInterrupt:
        raise typer.Exit(INTERRUPTED) from None


@contextmanager
def _warning_plainly() -> Iterator[None]:
    """Print what Python and matplotlib warn of as lines without a place in their source, glyphs in one.

    What is meant for those who develop libraries goes where it went before, which is nowhere unless it was asked for.
    """
    lacking: dict[str, None] = {}
    before = warnings.showwarning

    def show(message: Warning | str, category: type[Warning], *place: Any, **more: Any) -> None:
        if issubclass(category, DeprecationWarning | PendingDeprecationWarning):
            before(message, category, *place, **more)
            return
        glyph = re.match(r"Glyph (\d+) ", str(message))
        if glyph:
            lacking[chr(int(glyph[1]))] = None
        else:
            print(f"warning: {message}", file=sys.stderr)

    with warnings.catch_warnings():
        warnings.showwarning = show
        try:
            yield
        finally:
            if lacking:
                print(f"warning: the figures' font lacks {' '.join(lacking)}; boxes stand there", file=sys.stderr)


def say_error(place: str, message: str) -> None:
    """Print one problem on stderr."""
    print(": ".join(filter(None, ("error", place, message))), file=sys.stderr)


def print_json(value: Any) -> None:
    """Print a value as JSON; a number that is not finite becomes null."""
    print(json.dumps(_finite(value), indent=2, ensure_ascii=False))


def _finite(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and value - value != 0.0 else value


def print_paragraphs(paragraphs: Sequence[tuple[str, str]]) -> None:
    """Print texts, each after its mark; on a terminal they are wrapped to its width, else a line each."""
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else 0
    for mark, text in paragraphs:
        lines = textwrap.wrap(text, max(width - len(mark), 40), break_long_words=False) if width else [text]
        for number, line in enumerate(lines):
            print((" " * len(mark) if number else mark) + line)


def print_table(
    columns: Mapping[str, Sequence[Any]], *, title: str = "", most: int | None = None, small: Collection[str] = ()
) -> None:
    """Print columns: on a terminal as a table of at most so many rows, else complete and tab separated.

    On a terminal a value that is only round-off beside the largest of its column is zero, but for columns of small
    values: those whose values are themselves errors.
    """
    rows = list(zip(*columns.values(), strict=True))
    if not sys.stdout.isatty():
        for row in [tuple(columns), *rows]:
            print("\t".join(_exact_text(value) for value in row))
        return
    from rich import box
    from rich.console import Console
    from rich.table import Table

    texts = (_short_texts(values, small=name in small) for name, values in columns.items())
    shown = list(zip(*texts, strict=True))[:most]
    numeric = [all(isinstance(value, (int, float)) for value in values) for values in columns.values()]
    heads = [name.replace("_", " ") if number else name for name, number in zip(columns, numeric, strict=True)]
    console = Console(highlight=False, markup=False, emoji=False)
    widths = _widths(heads, list(columns.values()), shown, console.width)
    # Where the numbers do not fit, lines are longer than the terminal: nothing is cut, and no column is left out.
    console.width = max(console.width, sum(widths) + _between(widths))
    table = Table(title=title or None, title_justify="left", box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False)
    for head, number, width in zip(heads, numeric, widths, strict=True):
        table.add_column(head, justify="right" if number else "left", width=width, overflow="fold")
    for row in shown:
        table.add_row(*row)
    if len(shown) < len(rows):
        table.caption = f"and {len(rows) - len(shown)} more"
    console.print(table)


def _widths(
    heads: Sequence[str], columns: Sequence[Sequence[Any]], shown: Sequence[Sequence[str]], room: int
) -> list[int]:
    """Choose the widths of columns: heads of two words become narrow first, then words, numbers never."""
    from rich.cells import cell_len

    cells = [[row[place] for row in shown] for place in range(len(heads))]
    contents = [max(map(cell_len, texts), default=0) for texts in cells]
    least = [
        max(
            max(map(cell_len, head.split()), default=0),
            *(len(text) for text, value in zip(texts, values, strict=False) if isinstance(value, (int, float))),
            min(content, LEAST_WORDS),
        )
        for head, texts, values, content in zip(heads, cells, columns, contents, strict=True)
    ]
    widths = [max(cell_len(head), content) for head, content in zip(heads, contents, strict=True)]
    while sum(widths) + _between(widths) > room:
        wide = [place for place, width in enumerate(widths) if width > least[place]]
        if not wide:
            break
        widths[max(wide, key=lambda place: (widths[place] > contents[place], widths[place]))] -= 1
    return widths


def _between(widths: Sequence[int]) -> int:
    """Give the room that the table takes beside its columns: two spaces for each, and one at the end."""
    return 2 * len(widths) + 1


def _exact_text(value: Any) -> str:
    """Give a value in full: floats so that they read back to the same bits, nothing for what is absent."""
    return "" if value is None else str(value)


def _short_texts(column: Sequence[Any], *, small: bool) -> list[str]:
    """Give a column to look at: six digits, and zero for what is only round-off beside the column's largest."""
    if small:
        return [f"{value:.3g}" if isinstance(value, float) else _exact_text(value) for value in column]
    floats = [abs(value) for value in column if isinstance(value, float)]
    least = 1e-12 * max(floats) if len(floats) == len(column) and floats else 0.0
    return [_short_text(0.0 if isinstance(value, float) and abs(value) < least else value) for value in column]


def _short_text(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else _exact_text(value)
