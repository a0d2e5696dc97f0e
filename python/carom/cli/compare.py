"""``carom compare``: the stepped method against the exact run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from carom.cli import options
from carom.cli.folder import check_free, filling
from carom.cli.output import print_json, print_table, reporting

if TYPE_CHECKING:
    from pathlib import Path

    from carom.comparison import Comparison

MARK = "comparison.csv"
NAMES = (MARK, "errors.png", "errors.svg", "errors.pdf")


@reporting()
def compare(
    scenario: options.ScenarioName,
    dt: Annotated[
        list[str] | None,
        typer.Option(metavar="LIST", help="Time steps, comma separated.  [default: 0.1 down to 0.00001]"),
    ] = None,
    duration: options.Duration = None,
    settings: options.Settings = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    as_json: options.Json = False,
) -> None:
    """Compare the stepped method with the exact run.

    For each of some time steps: how many events the stepped run has, how many of the exact run's it misses
    and how many it adds; the time that balls lost waiting at contacts; the deepest overlap of two balls, within
    steps too; how far from its exact place the worst ball ends. With --out also write comparison.csv and a
    log-log figure of that error.
    """
    from carom.comparison import DEFAULT_STEPS, compare

    steps = _read_steps(",".join(dt)) if dt else DEFAULT_STEPS
    kinds = options.read_formats(formats)
    if out is not None:
        check_free(out, NAMES, overwrite=overwrite)
    comparison = compare(options.load_with(scenario, settings), steps, duration=duration)
    written: list[str] = []
    if out is not None:
        with filling(out, NAMES, MARK) as folder:
            written = _write(comparison, folder, kinds)
    _print(comparison, out, written, as_json=as_json)


def _read_steps(text: str) -> tuple[float, ...]:
    try:
        steps = tuple(float(word) for word in text.split(","))
    except ValueError:
        steps = ()
    if not steps or not all(0.0 < step < float("inf") for step in steps):
        raise typer.BadParameter(f"{text!r} is not a list of positive numbers", param_hint="--dt")
    return steps


def _write(comparison: Comparison, folder: Path, kinds: list[str]) -> list[str]:
    from carom import figures

    comparison.table.to_csv(folder / MARK)
    figure = figures.figure_of(figures.plot_errors(comparison))
    for kind in kinds:
        figures.save_figure(figure, folder / f"errors.{kind}")
    return [MARK, *(f"errors.{kind}" for kind in kinds)]


def _print(comparison: Comparison, out: Path | None, written: list[str], *, as_json: bool) -> None:
    columns = {name: column.tolist() for name, column in comparison.table.to_dict().items()}
    facts = {"exact_events": len(comparison.exact.events), "order": comparison.order}
    if as_json:
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        print_json({**facts, "steps": rows, "out": None if out is None else str(out), "files": written})
        return
    print_table(columns, title=comparison.exact.scenario.title)
    print()
    shown = {**facts, **({} if out is None else {"out": str(out), "files": " ".join(written)})}
    print_table({"comparison": list(shown), "value": list(shown.values())})
