"""``carom gas``: measure a gas of hard discs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom.cli import options
from carom.cli.folder import check_free, made
from carom.cli.measuring import bar, count, finish, interruptible, result_names, waiting
from carom.cli.output import reporting
from carom.errors import ScenarioError
from carom.recording import CHECKPOINT, EVERY, Checkpoints, EventStream, Snapshots

if TYPE_CHECKING:
    from carom.scenario import Scenario

AXES = {"xy": ["x", "y"], "x": ["x"], "y": ["y"], "none": []}
FORMS = ("gsd", "xyz", "parquet")
EVENTS = "events.parquet"


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
        int | None, typer.Option(parser=count, metavar="N", help="End after N collisions, such as 1e6.")
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
    snapshots: Annotated[
        str | None, typer.Option(metavar="FORM", help="Write snapshots into DIR while it runs, as gsd, xyz or parquet.")
    ] = None,
    snapshot_interval: Annotated[float | None, typer.Option(metavar="T", help="Time between snapshots.")] = None,
    snapshot_collisions: Annotated[
        int | None, typer.Option(parser=count, metavar="N", help="Collisions between snapshots, such as 1e5.")
    ] = None,
    snapshot_times: Annotated[
        str | None, typer.Option(metavar="LIST", help="Times of snapshots, comma separated.")
    ] = None,
    events: Annotated[
        tuple[float, float] | None,
        typer.Option(metavar="T0 T1", help="Write all events from T0 to T1 into DIR while it runs, as Parquet."),
    ] = None,
    checkpoint_every: Annotated[
        float | None,
        typer.Option(metavar="SECONDS", min=0.0, help=f"Write a checkpoint into DIR so often.  [default: {EVERY:g}]"),
    ] = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    no_figures: Annotated[bool, typer.Option("--no-figures", help="Write no figures.")] = False,
    as_json: options.Json = False,
) -> None:
    """Measure a gas of hard discs: print numbers with their errors, and what theory expects.

    The gas is made from --n and --packing-fraction, or is a scenario of discs in a rectangle. With --out also write
    observables.json (all numbers), a CSV file and a figure for each curve, run.json, and on the way checkpoint.carom,
    from which carom resume goes on. Ctrl-C ends the run, and what was measured so far is printed and written.
    """
    kinds = [] if no_figures else options.read_formats(formats)
    names = [word.strip() for word in ",".join(observe or ["pressure"]).split(",")]
    when = {"every_time": snapshot_interval, "every_collisions": snapshot_collisions, "at": _times(snapshot_times)}
    files = _files(out, snapshots, when, events, checkpoint_every, overwrite=overwrite)
    recipe = {"n": n, "packing_fraction": packing_fraction, "periodic": periodic, "start": start}
    recipe |= {"velocities": velocities, "temperature": temperature, "seed": seed}
    limits: dict[str, Any] = {
        name: value for name, value in (("collisions", collisions), ("duration", duration)) if value is not None
    }
    with waiting("placing the discs"):
        chosen = _scenario(scenario, recipe, limits, settings)
    ends = {**chosen.to_dict(), **limits}
    with made(out), interruptible() as interrupted, bar(ends.get("collisions"), ends.get("duration")) as told:
        run = chosen.run(
            **limits,
            record="none",
            observe=names,
            equilibrate=equilibrate,
            sample_interval=sample_interval,
            progress=lambda *now: told(*now) or interrupted(),
            **files,
        )
    written = [Path(file.path).name for file in files.values() if Path(file.path).exists()]
    if out is not None and overwrite:
        _remove_others(out, written)
    finish(run, out, written, kinds, as_json=as_json)


def _times(text: str | None) -> list[float] | None:
    """Read times, comma separated."""
    if text is None:
        return None
    try:
        return [float(word) for word in text.split(",")]
    except ValueError:
        message = f"{text!r} are no times, such as 0,1.5,20"
        raise typer.BadParameter(message, param_hint="--snapshot-times") from None


def _files(
    out: Path | None,
    form: str | None,
    when: dict[str, Any],
    window: tuple[float, float] | None,
    every: float | None,
    *,
    overwrite: bool,
) -> dict[str, Any]:
    """Say what the run writes into its folder while it goes on; refuse a folder that holds another."""
    given = {"snapshots": form, "events": window, "checkpoint_every": every}
    if out is None:
        for name, value in given.items():
            if value is not None:
                raise typer.BadParameter("needs --out, the folder to write into", param_hint=_option(name))
        return {}
    if (out / CHECKPOINT).exists() and not overwrite:
        advice = f"carom resume {out} goes on with it, --overwrite replaces it"
        raise ScenarioError([("--out", f"{out} holds a run already; {advice}")])
    check_free(out, [*result_names(), *_written_names()], overwrite=overwrite)
    files: dict[str, Any] = {}
    if form is not None:
        if form not in FORMS:
            raise typer.BadParameter(f"must be one of {', '.join(FORMS)}", param_hint="--snapshots")
        if sum(value is not None for value in when.values()) != 1:
            message = "needs one of --snapshot-interval, --snapshot-collisions and --snapshot-times"
            raise typer.BadParameter(message, param_hint="--snapshots")
        files["snapshots"] = Snapshots(out / f"snapshots.{form}", overwrite=overwrite, **when)
    elif any(value is not None for value in when.values()):
        raise typer.BadParameter("is missing, and it is said when they come", param_hint="--snapshots")
    if window is not None:
        files["events"] = EventStream(out / EVENTS, window, overwrite)
    files["checkpoints"] = Checkpoints(out / CHECKPOINT, EVERY if every is None else every, overwrite)
    return files


def _written_names() -> list[str]:
    """Give the names of all that a run may write into its folder while it goes on, but for folders."""
    return [CHECKPOINT, *(f"snapshots.{form}" for form in FORMS if form != "parquet")]


def _remove_others(out: Path, written: list[str]) -> None:
    """Remove what another run, which was overwritten, had written on its way."""
    from carom.records import cut_events, cut_frames

    for name in (f"snapshots.{form}" for form in FORMS):
        if name not in written:
            cut_frames(out / name, 0)
    if EVENTS not in written:
        cut_events(out / EVENTS, 0)


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
    if not limits:
        raise typer.BadParameter("a new gas needs it, or --duration", param_hint="--collisions")
    if "periodic" in given:
        if given["periodic"] not in AXES:
            raise typer.BadParameter(f"must be one of {', '.join(AXES)}", param_hint="--periodic")
        given["periodic"] = AXES[given["periodic"]]
    gas: Scenario = carom.gas(**given, **limits)
    return gas.with_values(dict(map(options.read_setting, settings))) if settings else gas


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"
