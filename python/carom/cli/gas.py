"""``carom gas``: measure a gas of hard discs."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom.cli import INTERRUPTED, options
from carom.cli.folder import check_free, filling
from carom.cli.output import print_json, print_table, reporting, say_error

if TYPE_CHECKING:
    from types import FrameType

    from carom.observables import Observable, Observables
    from carom.run import Run
    from carom.scenario import Scenario

MARK = "run.json"
QUANTITIES = "observables.json"
AXES = {"xy": ["x", "y"], "x": ["x"], "y": ["y"], "none": []}


def _count(text: str) -> int:
    """Read a whole number, also as ``1e6``."""
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if number < 0.0 or number != int(number):
        raise typer.BadParameter(f"{text!r} is no whole number from 0 on, such as 1000000 or 1e6")
    return int(number)


@reporting()
def gas(
    scenario: Annotated[
        str | None,
        typer.Argument(
            metavar="SCENARIO", help="Measure this scenario of discs, and make no new gas.", show_default=False
        ),
    ] = None,
    n: Annotated[int | None, typer.Option("--n", metavar="N", min=1, help="Number of discs.")] = None,
    packing_fraction: Annotated[
        float | None, typer.Option(metavar="F", help="The part of the box that discs cover.")
    ] = None,
    periodic: Annotated[
        str | None, typer.Option(metavar="AXES", help="Periodic axes: xy, x, y or none.  [default: xy]")
    ] = None,
    start: Annotated[str | None, typer.Option(metavar="WORD", help="How discs are placed at the start.")] = None,
    velocities: Annotated[
        str | None, typer.Option(metavar="WORD", help="How velocities are drawn: maxwell or equal_speed.")
    ] = None,
    temperature: Annotated[float | None, typer.Option(metavar="KT", min=0.0, help="kT.  [default: 1]")] = None,
    seed: Annotated[int | None, typer.Option(metavar="S", min=0, help="All that is random follows from it.")] = None,
    collisions: Annotated[
        int | None, typer.Option(parser=_count, metavar="N", help="End after N collisions, such as 1e6.")
    ] = None,
    duration: options.Duration = None,
    observe: Annotated[
        list[str] | None, typer.Option(metavar="LIST", help="What to measure, comma separated.  [default: pressure]")
    ] = None,
    equilibrate: Annotated[
        float, typer.Option(metavar="C", min=0.0, help="Collisions of each disc before measuring begins.")
    ] = 0.0,
    sample_interval: Annotated[
        float | None, typer.Option(metavar="T", help="Time between samples.  [default: ten collisions of each disc]")
    ] = None,
    settings: options.Settings = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    no_figures: Annotated[bool, typer.Option("--no-figures", help="Write no figures.")] = False,
    as_json: options.Json = False,
) -> None:
    """Measure a gas of hard discs: print numbers with their errors, and what theory expects.

    The gas is made from --n and --packing-fraction, or is a scenario of discs in a rectangle. With --out also write
    observables.json (all numbers), a CSV file and a figure for each curve, and run.json. Ctrl-C ends the run, and what
    was measured so far is printed and written.
    """
    kinds = options.read_formats(formats)
    names = [word.strip() for word in ",".join(observe or ["pressure"]).split(",")]
    if out is not None:
        check_free(out, _names(), overwrite=overwrite)
    recipe = {"n": n, "packing_fraction": packing_fraction, "periodic": periodic, "start": start}
    recipe |= {"velocities": velocities, "temperature": temperature, "seed": seed}
    chosen = _scenario(scenario, recipe, {"collisions": collisions, "duration": duration}, settings)
    with _interruptible() as interrupted, _bar(chosen, collisions, duration) as told:
        run = chosen.run(
            collisions=collisions,
            duration=duration,
            record="none",
            observe=names,
            equilibrate=equilibrate,
            sample_interval=sample_interval,
            progress=lambda *now: told(*now) or interrupted(),
        )
    files: list[str] = []
    if out is not None and run.observables:
        with filling(out, _names(), MARK) as folder:
            files = _write(run, folder, [] if no_figures else kinds)
    facts = {"status": run.status, "end_time": run.end_time, "digest": run.digest, "collisions": _collisions(run)}
    facts |= {"out": None if out is None else str(out), "files": files}
    if as_json:
        print_json({**facts, "observables": run.observables.to_dict()})
    else:
        _print_tables(run.observables, facts)
    if run.status == "interrupted":
        if not run.observables:
            say_error("gas", f"interrupted at t = {run.end_time:g}, before measuring began")
        raise typer.Exit(INTERRUPTED)


def _scenario(
    source: str | None, recipe: dict[str, Any], limits: dict[str, Any], settings: list[str] | None
) -> Scenario:
    """Load a scenario, or make the gas that the options describe."""
    import carom

    given = {name: value for name, value in recipe.items() if value is not None}
    if source is not None:
        for name in given:
            raise typer.BadParameter("belongs to a new gas, and a scenario is given", param_hint=_option(name))
        return options.load_with(source, settings)
    for name in ("n", "packing_fraction"):
        if name not in given:
            raise typer.BadParameter("a new gas needs it", param_hint=_option(name))
    if limits["collisions"] is None and limits["duration"] is None:
        raise typer.BadParameter("a new gas needs it, or --duration", param_hint="--collisions")
    if "periodic" in given:
        if given["periodic"] not in AXES:
            raise typer.BadParameter(f"must be one of {', '.join(AXES)}", param_hint="--periodic")
        given["periodic"] = AXES[given["periodic"]]
    made: Scenario = carom.gas(**given, **{name: value for name, value in limits.items() if value is not None})
    return made.with_values(dict(map(options.read_setting, settings))) if settings else made


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"


@contextmanager
def _interruptible() -> Iterator[Callable[[], bool]]:
    """Give a function that says whether Ctrl-C was pressed; a second one ends the command."""
    pressed = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield pressed.is_set
        return

    def press(_number: int, _frame: FrameType | None) -> None:
        pressed.set()
        signal.signal(signal.SIGINT, before)

    before = signal.signal(signal.SIGINT, press)
    try:
        yield pressed.is_set
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def _bar(scenario: Scenario, collisions: int | None, duration: float | None) -> Iterator[Callable[..., None]]:
    """Show on a terminal how far the run has come, at what speed, and how long it will take."""
    if not sys.stderr.isatty():
        yield lambda *_: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    values = scenario.to_dict()
    most = collisions if collisions is not None else values.get("collisions")
    end = duration if duration is not None else values.get("duration")
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TaskProgressColumn(),
        TextColumn("{task.fields[speed]}"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("to equilibrium", total=1.0, speed="")
        events = progress.get_time()

        def tell(time: float, done: int, samples: int) -> None:
            share = max(done / most if most else 0.0, time / end if end else 0.0)
            rate = done / max(progress.get_time() - events, 1e-9)
            words = f"{samples} samples" if samples else "to equilibrium"
            progress.update(task, completed=share, description=words, speed=f"{rate:,.0f} events/s")

        yield tell


def _names() -> list[str]:
    """Give the names of all files that this command may write into a folder."""
    from carom import _engine
    from carom.figures import FORMATS

    kinds = ["csv", *(kind.removeprefix(".") for kind in FORMATS)]
    return [MARK, QUANTITIES, *(f"{name}.{kind}" for name in _engine.OBSERVABLES for kind in kinds)]


def _write(run: Run, folder: Path, kinds: list[str]) -> list[str]:
    """Write the numbers, the curves, their figures and the run."""
    written = [path.name for path in run.observables.save(folder)]
    for name, observable in run.observables.items():
        written += _write_figure(name, observable, folder, kinds)
    run.save(folder / MARK)
    return [*written, MARK]


def _write_figure(name: str, observable: Observable, folder: Path, kinds: list[str]) -> list[str]:
    if not kinds or not observable.has_figure:
        return []
    from carom.figures import figure_of, save_figure

    figure = figure_of(observable.plot())
    return [save_figure(figure, folder / f"{name}.{kind}").name for kind in kinds]


def _collisions(run: Run) -> int:
    events = run.diagnostics["events"]
    return int(events.get("ball_ball", 0) + events.get("ball_cushion", 0))


def _print_tables(observables: Observables, facts: dict[str, Any]) -> None:
    rows = [(name, each) for name, found in observables.items() for each in found.quantities.values()]
    if rows:
        print_table(
            {
                "observable": [name for name, _ in rows],
                "quantity": [each.name for _, each in rows],
                "value": [each.value for _, each in rows],
                "error": [each.error for _, each in rows],
                "expected": [each.expected for _, each in rows],
                "unit": [each.unit for _, each in rows],
            },
            small=("error",),
        )
        print()
    shown = {**facts, "files": " ".join(facts["files"]) or None}
    shown = {name: value for name, value in shown.items() if value is not None}
    print_table({"run": list(shown), "value": list(shown.values())})
