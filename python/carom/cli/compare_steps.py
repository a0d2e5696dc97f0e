"""``carom compare SCENARIO``: the stepped method against the exact run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from carom.cli import options
from carom.cli.comparing import MARK, Destination, check_place, rows_of, write
from carom.cli.output import print_json, print_table

if TYPE_CHECKING:
    from carom.comparison import StepComparison
    from carom.scenario import Scenario


def compare_steps(
    source: str, dt: list[str] | None, duration: float | None, settings: list[str] | None, place: Destination
) -> None:
    """Compare the stepped method with the exact run, for some time steps."""
    from carom.comparison.steps import DEFAULT_STEPS, compare_steps

    steps = _read_steps(",".join(dt)) if dt else DEFAULT_STEPS
    check_place(place)
    comparison = compare_steps(_load(source, settings), steps, duration=duration)
    written = write(place, {MARK: comparison.table}, {"errors": comparison.plot_errors})
    _print(comparison, place, written)


def _load(source: str, settings: list[str] | None) -> Scenario:
    if options.is_saved_run(source):
        raise typer.BadParameter(f"{source} is a saved run; name a second one, or --with FILE", param_hint="A")
    return options.load_with(source, settings)


def _read_steps(text: str) -> tuple[float, ...]:
    try:
        steps = tuple(float(word) for word in text.split(","))
    except ValueError:
        steps = ()
    if not steps or not all(0.0 < step < float("inf") for step in steps):
        raise typer.BadParameter(f"{text!r} is not a list of positive numbers", param_hint="--dt")
    return steps


def _print(comparison: StepComparison, place: Destination, written: list[str]) -> None:
    facts = {"exact_events": len(comparison.exact.events), "order": comparison.order}
    out = None if place.out is None else str(place.out)
    if place.as_json:
        print_json({**facts, "steps": rows_of(comparison.table), "out": out, "files": written})
        return
    columns = {name: column.tolist() for name, column in comparison.table.to_dict().items()}
    print_table(columns, title=comparison.exact.scenario.title)
    print()
    shown = {**facts, **({} if out is None else {"out": out, "files": " ".join(written)})}
    print_table({"comparison": list(shown), "value": list(shown.values())})
