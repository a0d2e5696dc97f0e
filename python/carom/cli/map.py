"""``carom map``: an outcome over two varied numbers, as a picture."""

from __future__ import annotations

import difflib
import hashlib
import json
import math
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom.cli import INTERRUPTED, options
from carom.cli.folder import check_free, filling
from carom.cli.output import print_json, print_table, reporting
from carom.errors import ScenarioError

if TYPE_CHECKING:
    from carom.ensemble import Ensemble, Grid
    from carom.scenario import Scenario

MARK = "map.json"
NAMES = (MARK, *(f"map.{kind}" for kind in ("png", "svg", "pdf")))
AXIS = "PATH=FROM:TO:COUNT"
LISTED = 12
"""So many columns of an outcome are listed in an error."""


@reporting()
def map_(
    scenario: options.ScenarioName,
    x: Annotated[str, typer.Option("--x", metavar=AXIS, help="The numbers along x.", show_default=False)],
    y: Annotated[str, typer.Option("--y", metavar=AXIS, help="The numbers along y.", show_default=False)],
    show: Annotated[str, typer.Option(metavar="COLUMN", help="The column to draw.", show_default=False)],
    settings: options.Settings = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    threads: Annotated[
        int | None, typer.Option(metavar="N", min=1, help="On N threads.  [default: as many as there are cores]")
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Run a scenario at each point of a grid of two numbers, and draw what becomes of it, a cell for each run.

    COLUMN is status, end_time, first_event, last_event, events.ball_ball and other kinds of events, red.x or red.vx
    of a ball, and on a cloth cue.wx or 1.pocket. A wrong one is answered with those that there are.

    With --out write the map and map.json; without it print the facts only. Where the numbers make no scenario the map
    is grey.
    """
    kinds = options.read_formats(formats)
    axes = dict((_read_axis("--x", x), _read_axis("--y", y)))
    if len(axes) < 2:
        raise typer.BadParameter("must name another path than --x", param_hint="--y")
    if out is not None:
        check_free(out, NAMES, overwrite=overwrite)
    chosen = options.load_with(scenario, settings)
    path_x, path_y = axes
    grid = _grid({path_y: axes[path_y], path_x: axes[path_x]})
    outcomes = _outcomes_of(chosen, grid, show)
    table = chosen.ensemble(grid, outcomes, threads=threads, invalid="keep", progress=True)
    if not table.is_complete:
        raise typer.Exit(INTERRUPTED)
    if not table.has_outcome.any():
        raise ScenarioError(
            [("", f"none of {len(table)} runs has an outcome; run 0: {' '.join(table['problem'][0].split())}")]
        )
    found = _facts(scenario, axes, table, show)
    written: list[str] = []
    if out is not None:
        asked = {"--x": x, "--y": y, "--show": show, "--set": settings}
        whole = {**found, "command": options.command_line("map", scenario, asked), "content": chosen.to_dict()}
        with filling(out, NAMES, MARK) as folder:
            written = _write(table, show, folder, kinds, whole)
    found |= {"out": None if out is None else str(out), "files": written}
    print_json(found) if as_json else _print_tables(found)


def _read_axis(option: str, text: str) -> tuple[str, tuple[float, float, int]]:
    """Read ``PATH=FROM:TO:COUNT``."""
    path, _, said = text.rpartition("=")
    try:
        first, last, count = said.split(":")
        axis = float(first), float(last), int(count)
    except ValueError:
        axis = math.nan, math.nan, 0
    if not path or not all(map(math.isfinite, axis)):
        words = f"{text!r} is not {AXIS}, such as balls.red.speed=1:8:200"
        raise typer.BadParameter(words, param_hint=option)
    if axis[2] < 2 or axis[0] == axis[1]:
        words = f"{text!r}: COUNT must be 2 at least, and FROM another number than TO"
        raise typer.BadParameter(words, param_hint=option)
    return path, axis


def _grid(axes: dict[str, tuple[float, float, int]]) -> Grid:
    import numpy as np

    from carom.ensemble import Grid

    return Grid({path: np.linspace(*axis) for path, axis in axes.items()})


def _outcomes_of(scenario: Scenario, grid: Grid, column: str) -> list[str]:
    """Give the outcome that a column belongs to; the status belongs to none, as it is always there."""
    from carom.ensemble import columns_of

    if column == "status":
        return []
    if column.startswith("closest_approach."):
        return [column]
    columns = columns_of(scenario, grid)
    for outcome, names in columns.items():
        if column in names:
            return [outcome]
    near = difflib.get_close_matches(column, [name for names in columns.values() for name in names], n=1)
    advice = f"; did you mean {near[0]}?" if near else ";"
    listed = "; ".join(["status", *map(_listed, columns.values())])
    raise ScenarioError([("--show", f"no column {column!r}{advice} known: {listed}")])


def _listed(names: list[str]) -> str:
    more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
    return ", ".join(names[:LISTED]) + more


def _facts(source: str, axes: dict[str, tuple[float, float, int]], table: Ensemble, column: str) -> dict[str, Any]:
    """Give what a map shows in numbers, and the SHA-256 of its column."""
    import numpy as np

    from carom.figures.maps import Cells

    cells = Cells.of(table, column)
    shown = {
        name: {"path": path, "from": first, "to": last, "count": count}
        for name, (path, (first, last, count)) in zip("xy", axes.items(), strict=True)
    }
    facts: dict[str, Any] = {"scenario": source, **shown, "column": column, "runs": len(table)}
    facts["statuses"] = dict(sorted(Counter(table["status"]).items()))
    if cells.categories is not None:
        facts["counts"] = dict(zip(cells.categories, cells.counts, strict=True))
    elif cells.values.count():
        known = cells.values.compressed()
        facts |= {"min": float(known.min()), "median": float(np.median(known)), "max": float(known.max())}
    facts["without"] = int(np.ma.getmaskarray(cells.values).sum())
    return {**facts, "digest": _digest(table[column])}


def _digest(column: Any) -> str:
    """Give the SHA-256 of a column: its numbers' bytes, little-endian, or its words, each on a line."""
    words = "".join(f"{'' if word is None else word}\n" for word in column) if column.dtype.kind == "O" else None
    numbers = b"" if words is not None else column.astype(column.dtype.newbyteorder("<")).tobytes()
    return hashlib.sha256(numbers if words is None else words.encode()).hexdigest()


def _write(table: Ensemble, column: str, folder: Path, kinds: list[str], facts: dict[str, Any]) -> list[str]:
    from carom.figures import figure_of, save_figure

    figure = figure_of(table.map(column))
    written = [save_figure(figure, folder / f"map.{kind}").name for kind in kinds]
    (folder / MARK).write_text(json.dumps(facts, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    return [*written, MARK]


def _print_tables(facts: dict[str, Any]) -> None:
    """Print how often what came up, if these are categories, and then the facts."""
    if "counts" in facts:
        print_table({facts["column"]: list(facts["counts"]), "runs": list(facts["counts"].values())})
        print()
    axes = {name: "{path} = {from:g} to {to:g}, {count}".format(**facts[name]) for name in "xy"}
    statuses = ", ".join(f"{word} {count}" for word, count in facts["statuses"].items())
    shown = {**facts, **axes, "statuses": statuses, "files": " ".join(facts["files"]) or None}
    shown = {name: value for name, value in shown.items() if value is not None and name != "counts"}
    print_table({"map": list(shown), "value": list(shown.values())})
