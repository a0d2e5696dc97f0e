"""``carom run``: compute a run, print it, write it."""

from __future__ import annotations

from dataclasses import asdict
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom.cli import options
from carom.cli.folder import check_free, filling
from carom.cli.output import PROBLEM, print_json, print_table, reporting, say_error
from carom.errors import ScenarioError
from carom.extras import needed

if TYPE_CHECKING:
    from carom.run import Run
    from carom.scenario import Scenario

FIGURES = ("filmstrip", "paths", "energy", "speed", "spin", "height", "momentum")
TABLES = ("events.csv", "trajectory.csv", "steps.csv")
FILMS = ("animation.gif", "animation.mp4")
REPORT = "report.html"
MARK = "run.json"
NAMES = (*TABLES, *FILMS, REPORT, MARK, *(f"{name}.{kind}" for name in FIGURES for kind in ("png", "svg", "pdf")))

SAMPLES = 500
MOST_SAMPLES = 1e7
LONGEST_FILM = 20.0
MOST_ROWS = 50
SHOWN = ("time", "kind", "ball_a", "ball_b", "cushion", "pocket", "x", "y", "closing_speed")


class MethodName(str, Enum):
    """The words after ``--method``."""

    exact = "exact"
    stepped = "stepped"


class FilmFormat(str, Enum):
    """The words after ``--animation``."""

    gif = "gif"
    mp4 = "mp4"


@reporting()
def run(
    scenario: options.ScenarioName,
    method: Annotated[MethodName | None, typer.Option(help="How to compute it.", show_default=False)] = None,
    dt: Annotated[float | None, typer.Option(metavar="H", help="Time step; means --method stepped.")] = None,
    duration: options.Duration = None,
    collisions: Annotated[int | None, typer.Option(metavar="N", min=0, help="End after N collisions.")] = None,
    max_events: options.MaxEvents = None,
    settings: options.Settings = None,
    sample: Annotated[
        float | None, typer.Option(metavar="H", help="Time between rows of trajectory.csv.  [default: T/500]")
    ] = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    no_figures: Annotated[bool, typer.Option("--no-figures", help="Write no figures.")] = False,
    animation: Annotated[FilmFormat, typer.Option(help="Kind of film; mp4 needs carom[movie].")] = FilmFormat.gif,
    no_animation: Annotated[bool, typer.Option("--no-animation", help="Write no animation.")] = False,
    as_json: options.Json = False,
) -> None:
    """Compute a run; print its events and its diagnostics.

    With --out also write report.html (all of it in one page), events.csv, trajectory.csv, steps.csv (stepped),
    run.json, figures (filmstrip, paths, energy, speed, momentum) and an animation. Without it nothing is
    written. A run longer than 20 is filmed faster than it is; animation_speed says how much.
    """
    kinds = options.read_formats(formats)
    if sample is not None and not 0.0 < sample < float("inf"):
        raise typer.BadParameter("must be positive and finite", param_hint="--sample")
    if out is not None:
        check_free(out, NAMES, overwrite=overwrite)
        if animation is FilmFormat.mp4 and not no_animation:
            needed("imageio_ffmpeg", "movie")
    chosen = options.load_with(scenario, settings)
    result = chosen.run(
        method=choose_method(chosen, method, dt), duration=duration, collisions=collisions, max_events=max_events
    )
    asked = {"--set": settings, "--method": method, "--dt": dt, "--duration": duration}
    command = options.command_line("run", scenario, {**asked, "--collisions": collisions, "--max-events": max_events})
    written: list[str] = []
    film_speed = None if out is None or no_animation else _film_speed(result)
    if out is not None:
        with filling(out, NAMES, MARK) as folder:
            written = _write_data(result, folder, sample)
            pictures: dict[str, bytes] = {}
            written += [] if no_figures else _write_figures(result, folder, kinds, pictures)
            written += [] if film_speed is None else _write_film(result, folder, animation, film_speed)
            written += _write_report(result, folder, pictures, written, command)
    facts = {"out": None if out is None else str(out), "files": written, "animation_speed": film_speed}
    _print_json(result, facts) if as_json else _print_tables(result, facts)
    if result.status in ("collapsed", "miscue") or (result.status == "event_limit" and max_events is None):
        why = ": the tip slips off so far from the middle, see cue.miscue_offset" if result.status == "miscue" else ""
        say_error("run", f"ended by {result.status} at t = {result.end_time:g}, before its time{why}")
        raise typer.Exit(PROBLEM)


def choose_method(scenario: Scenario, name: MethodName | None, dt: float | None) -> dict[str, Any] | None:
    """Choose the method: None leaves the scenario's own; a stepped one keeps the readings it has there."""
    if name is MethodName.exact:
        if dt is not None:
            raise typer.BadParameter("belongs to --method stepped", param_hint="--dt")
        return {"kind": "exact"}
    if name is None and dt is None:
        return None
    own = scenario.to_dict().get("method", {})
    stepped = own if own.get("kind") == "stepped" else {"kind": "stepped"}
    if dt is None and "dt" not in stepped:
        raise typer.BadParameter("--method stepped needs it", param_hint="--dt")
    return stepped if dt is None else {**stepped, "dt": dt}


def _write_data(run: Run, folder: Path, sample: float | None) -> list[str]:
    """Write what the run kept as tables, and the run itself."""
    record = run.record
    run.save(folder / MARK)
    written = [MARK]
    if record != "none":
        run.events.to_csv(folder / "events.csv")
        written.append("events.csv")
    if record == "all":
        step = sample or run.end_time / SAMPLES or 1.0
        if run.end_time / step > MOST_SAMPLES:
            raise ScenarioError([("--sample", f"{step:g} would make more than {MOST_SAMPLES:g} rows")])
        run.trajectory(run.sample_times(step)).to_csv(folder / "trajectory.csv")
        written.append("trajectory.csv")
        if run.steps is not None:
            run.steps.to_csv(folder / "steps.csv")
            written.append("steps.csv")
    return written


def _write_figures(run: Run, folder: Path, kinds: list[str], pictures: dict[str, bytes]) -> list[str]:
    """Write the figures that the run has something for, and put each as PNG among the `pictures`."""
    if run.record != "all":
        return []
    from carom.figures import save_figure
    from carom.report import drawn, figures_of

    written = []
    for name, figure in figures_of(run):
        for kind in kinds:
            save_figure(figure, folder / f"{name}.{kind}")
            written.append(f"{name}.{kind}")
        pictures[name] = (folder / f"{name}.png").read_bytes() if "png" in kinds else drawn(figure)
    return written


def _film_speed(run: Run) -> float | None:
    """Choose a film's speed: true, or so fast that it lasts twenty seconds; None where there is nothing to film."""
    return max(1.0, run.end_time / LONGEST_FILM) if run.record == "all" and run.end_time > 0.0 else None


def _write_film(run: Run, folder: Path, kind: FilmFormat, speed: float) -> list[str]:
    from carom.animation import animate

    film = f"animation.{kind.value}"
    animate(run, folder / film, speed=speed)
    return [film]


def _write_report(run: Run, folder: Path, pictures: dict[str, bytes], files: list[str], command: str) -> list[str]:
    from carom.report import write_report

    write_report(run, folder / REPORT, pictures=pictures, command=command, files=files)
    return [REPORT]


def _print_json(run: Run, facts: dict[str, Any]) -> None:
    """Print a run and the facts about its files; its events are null where it kept none."""
    events = None if run.record == "none" else [asdict(event) for event in run.events]
    print_json(
        {
            "status": run.status,
            "end_time": run.end_time,
            "digest": run.digest,
            "physics_version": run.physics_version,
            "diagnostics": run.diagnostics,
            "references": [asdict(reference) for reference in run.references],
            "record": run.record,
            "shot": _shot(run),
            "events": events,
            **facts,
        }
    )


def _print_tables(run: Run, facts: dict[str, Any]) -> None:
    """Print the events and the diagnostics, the facts about the run's files among them."""
    record = run.record
    if record == "none":
        print("no events: the run kept none (record = none)")
    else:
        shown = [name for name in SHOWN if name != "pocket" or run.pocket_ids]
        print_table({name: run.events[name].tolist() for name in shown}, title=run.scenario.title, most=MOST_ROWS)
    print()
    outcome = _shot(run)
    if outcome is not None:
        words = {name: " ".join(value) if isinstance(value, list) else value for name, value in _told(outcome).items()}
        print_table({"shot": list(words), "value": list(words.values())})
        print()
    found = {"status": run.status, "end_time": run.end_time, "digest": run.digest} | _flat(run.diagnostics)
    found |= {} if record == "all" else {"record": record}
    found |= _flat({**facts, "files": " ".join(facts["files"]) or None})
    print_table({"diagnostic": list(found), "value": list(found.values())})


def _shot(run: Run) -> dict[str, Any] | None:
    """Give what came of the shot; None where there was none, or where no events were kept."""
    if run.record == "none" or "shot" not in run.scenario.to_dict():
        return None
    return run.shot.to_dict()


def _told(outcome: dict[str, Any]) -> dict[str, Any]:
    """Give what came of a shot as a row each, without what was not; times and counts beside what they are of."""
    pairs = zip(outcome["pocketed"], outcome["pockets"], strict=True)
    return {
        "cue_ball": outcome["cue_ball"],
        "first_ball_hit": outcome["first_ball_hit"],
        "pocketed": [f"{ball}:{pocket}" for ball, pocket in pairs],
        "cushions_before": outcome["cushions_before"],
        "cushions_after": outcome["cushions_after"],
        "balls_to_cushion": outcome["balls_to_cushion"],
        "off_table": outcome["off_table"],
    }


def _flat(values: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    """Give nested values under dotted names."""
    flat: dict[str, Any] = {}
    for name, value in values.items():
        if isinstance(value, dict):
            flat |= _flat(value, f"{prefix}{name}.")
        elif value is not None:
            flat[f"{prefix}{name}"] = value
    return flat
