"""What commands print: tables, JSON, and errors as ``error: place: message``."""

from __future__ import annotations

import json
import shutil
import sys
import textwrap
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import typer

from carom.cli import INTERRUPTED
from carom.errors import CaromError, ListedError

PROBLEM = 1
TROUBLE = 2
"""The exit code of a comparison that could not be made, as of ``diff`` and ``cmp``; of wrong usage everywhere."""


@contextmanager
def reporting(code: int = PROBLEM) -> Iterator[None]:
    """Turn what can go wrong in a command into lines on stderr and an exit code; also a decorator."""
    try:
        yield
    except ListedError as error:
        for place, message in error.problems:
            say_error(place, message)
        raise typer.Exit(code) from None
    except CaromError as error:
        say_error("", str(error))
        raise typer.Exit(code) from None
    except BrokenPipeError:
        raise
    except OSError as error:
        say_error(str(error.filename or ""), error.strerror or str(error))
        raise typer.Exit(code) from None
    except KeyboardInterrupt:
        raise typer.Exit(INTERRUPTED) from None


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
    table = Table(title=title or None, title_justify="left", box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False)
    for name, values in columns.items():
        numeric = all(isinstance(value, (int, float)) for value in values)
        # What becomes narrow first is a head of two words; no value is cut while there is room for all.
        head = name.replace("_", " ") if numeric else name
        whole = " " not in head and name != list(columns)[-1]
        table.add_column(head, justify="right" if numeric else "left", no_wrap=whole, overflow="fold")
    for row in shown:
        table.add_row(*row)
    if len(shown) < len(rows):
        table.caption = f"and {len(rows) - len(shown)} more"
    Console(highlight=False).print(table)


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
