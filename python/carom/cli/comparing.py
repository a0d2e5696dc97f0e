"""What the three kinds of comparison share: where results go, and how they are printed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom.cli.folder import check_free, filling
from carom.cli.output import print_json, print_paragraphs, print_table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.columns import ColumnTable

MARK = "comparison.csv"
TABLES = (MARK, "balls.csv", "changes.csv", "readings.csv")
FIGURES = ("errors", "distance", "overlay")
NAMES = (*TABLES, *(f"{name}.{kind}" for name in FIGURES for kind in ("png", "svg", "pdf")))


@dataclass(frozen=True)
class Destination:
    """Where a comparison goes: a folder or None, the formats of figures, and how it is printed."""

    out: Path | None
    kinds: list[str]
    overwrite: bool
    as_json: bool


def check_place(place: Destination) -> None:
    """Refuse a folder that holds results already, before anything is computed."""
    if place.out is not None:
        check_free(place.out, NAMES, overwrite=place.overwrite)


def write(
    place: Destination, tables: Mapping[str, ColumnTable], drawings: Mapping[str, Callable[[], Axes]]
) -> list[str]:
    """Write tables and figures where they are asked for; give the names of the files."""
    if place.out is None:
        return []
    from carom import figures

    written: list[str] = []
    with filling(place.out, NAMES, MARK) as folder:
        for name, table in tables.items():
            table.to_csv(folder / name)
            written.append(name)
        for name, draw in drawings.items():
            figure = figures.figure_of(draw())
            for kind in place.kinds:
                figures.save_figure(figure, folder / f"{name}.{kind}")
                written.append(f"{name}.{kind}")
    return written


def show(
    place: Destination,
    written: list[str],
    *,
    facts: Mapping[str, Any],
    tables: Mapping[str, ColumnTable],
    paragraphs: Sequence[tuple[str, str]],
) -> None:
    """Print a comparison: as JSON all facts and tables, else the paragraphs and then the tables.

    Parameters
    ----------
    place : Destination
        Where the results went.
    written : list of str
        The files there.
    facts : mapping
        What JSON says beside the tables.
    tables : mapping of str to ColumnTable
        The tables, by their names in JSON.
    paragraphs : sequence of (str, str)
        What is said in words: each with the mark before it.
    """
    out = None if place.out is None else str(place.out)
    if place.as_json:
        print_json({**facts, **{name: rows_of(table) for name, table in tables.items()}, "out": out, "files": written})
        return
    print_paragraphs([*paragraphs, *([("", f"written to {out}: {' '.join(written)}")] if written else [])])
    for table in tables.values():
        if len(table):
            print()
            print_table(lists_of(table), small=("largest",))


def lists_of(table: ColumnTable) -> dict[str, list[Any]]:
    """Give a table as lists; a number that is not one, as a time that never comes, is absent."""
    columns = {name: column.tolist() for name, column in table.to_dict().items()}
    return {name: [None if value != value else value for value in column] for name, column in columns.items()}


def rows_of(table: ColumnTable) -> list[dict[str, Any]]:
    """Give a table as rows."""
    columns = lists_of(table)
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
