"""``carom compare SCENARIO --with FILE``: one's own trajectory against a run."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from carom.cli import options
from carom.cli.comparing import MARK, Destination, show, write
from carom.cli.output import PROBLEM
from carom.cli.run import MethodName, choose_method

if TYPE_CHECKING:
    from carom.comparison import TrajectoryComparison
    from carom.run import Run
    from carom.scenario import Scenario

DELIMITERS = {"tab": "\t", "\\t": "\t", "space": " "}


@dataclass(frozen=True)
class TrajectoryFile:
    """A trajectory in a file, and how it is to be read and judged."""

    path: Path
    columns: str | None
    delimiter: str | None
    decimal: str | None
    tolerance: float | None


@dataclass(frozen=True)
class Asked:
    """What to compare it with: a scenario or saved run, and what is asked of it."""

    source: str
    method: MethodName | None
    dt: list[str] | None
    duration: float | None
    settings: list[str] | None


def compare_trajectory(asked: Asked, file: TrajectoryFile, place: Destination) -> None:
    """Compare the trajectory in a file with a run; exit with 1 where it does not agree."""
    from carom.comparison.trajectory import DEFAULT_TOLERANCE, compare_trajectory

    delimiter = _read_delimiter(file.delimiter)
    comparison = compare_trajectory(
        _load(asked),
        file.path,
        columns=file.columns,
        tolerance=DEFAULT_TOLERANCE if file.tolerance is None else file.tolerance,
        delimiter=delimiter,
        decimal=_read_decimal(file.decimal, delimiter),
        duration=asked.duration,
    )
    tables = {MARK: comparison.table, "balls.csv": comparison.by_ball}
    if comparison.readings is not None:
        tables["readings.csv"] = comparison.readings
    drawings = {"distance": comparison.plot_distance, "overlay": comparison.plot_overlay}
    _show(comparison, place, write(place, tables, drawings))
    if not comparison:
        raise typer.Exit(PROBLEM)


def _read_step(dt: list[str] | None) -> float | None:
    if dt is None:
        return None
    try:
        (step,) = map(float, ",".join(dt).split(","))
    except ValueError:
        raise typer.BadParameter("with --with it is one time step", param_hint="--dt") from None
    return step


def _read_delimiter(text: str | None) -> str:
    delimiter = DELIMITERS.get(text or ",", text or ",")
    if len(delimiter) != 1 or delimiter in '"\r\n':
        raise typer.BadParameter(f"{text!r} is none: one character, tab or space", param_hint="--delimiter")
    return delimiter


def _read_decimal(text: str | None, delimiter: str) -> str:
    if text not in (None, ".", ","):
        raise typer.BadParameter(f"{text!r} is neither . nor ,", param_hint="--decimal")
    if text == delimiter:
        raise typer.BadParameter(f"{text!r} is the delimiter already; --delimiter sets another", param_hint="--decimal")
    return text or "."


def _load(asked: Asked) -> Scenario | Run:
    import carom

    step = _read_step(asked.dt)
    if options.is_saved_run(asked.source):
        for name, value in {"--set": asked.settings, "--method": asked.method, "--dt": step}.items():
            if value is not None:
                raise typer.BadParameter(f"{asked.source} is a saved run, which stays as it is", param_hint=name)
        return carom.load_run(asked.source)
    scenario = options.load_with(asked.source, asked.settings)
    chosen = choose_method(scenario, asked.method, step)
    return scenario if chosen is None else scenario.with_values({"method": chosen})


def _show(comparison: TrajectoryComparison, place: Destination, written: list[str]) -> None:
    from carom.columns import ColumnTable

    first = comparison.first_difference
    facts = {
        "agrees": comparison.agrees,
        "verdict": comparison.verdict,
        "file": comparison.name,
        "columns": comparison.columns,
        "tolerance": comparison.tolerance,
        "rows": len(comparison.times),
        "largest": comparison.largest,
        "first_difference": None if first is None else asdict(first),
        "reasons": comparison.reasons,
        "notes": comparison.notes,
    }
    said = [("", comparison.verdict)]
    said += [("- ", reason) for reason in comparison.reasons]
    said += [("  ", note) for note in comparison.notes]
    tables = {"balls": comparison.by_ball}
    if comparison.readings is not None:
        readings = comparison.readings.to_dict()
        # In words it is among the notes.
        tables["readings"] = ColumnTable({name: readings[name] for name in readings if place.as_json or name != "why"})
    show(place, written, facts=facts, tables=tables, paragraphs=said)
