"""``carom compare A B``: two runs side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from carom.cli import options
from carom.cli.comparing import MARK, Destination, show, write
from carom.cli.output import PROBLEM

if TYPE_CHECKING:
    from carom.comparison import RunComparison
    from carom.events import Event
    from carom.run import Run
    from carom.scenario import Scenario


def compare_runs(
    sources: tuple[str, str],
    duration: float | None,
    settings: tuple[list[str], list[str], list[str]],
    tolerance: float | None,
    place: Destination,
) -> None:
    """Compare two runs; exit with 1 where they are farther apart than a tolerance.

    Parameters
    ----------
    sources : (str, str)
        Each a scenario or a saved run.
    duration : float or None
        Where the runs of scenarios end.
    settings : three lists of str
        What ``--set``, ``--set-a`` and ``--set-b`` say.
    tolerance : float or None
        The largest distance that is no difference.
    place : Destination
        Where the results go.
    """
    from carom.comparison import compare

    both, of_a, of_b = settings
    one = _load(sources[0], [("--set", both), ("--set-a", of_a)], duration)
    two = _load(sources[1], [("--set", both), ("--set-b", of_b)], duration)
    comparison = compare(one, two, names=_names(sources, (of_a, of_b)))
    tables = {MARK: comparison.table, "balls.csv": comparison.by_ball, "changes.csv": comparison.changes}
    drawings = {"distance": comparison.plot_distance, "overlay": comparison.plot_overlay}
    written = write(place, tables, drawings)
    beyond = None if tolerance is None else not comparison.largest <= tolerance
    _show(comparison, place, written, tolerance)
    if beyond:
        raise typer.Exit(PROBLEM)


def _load(source: str, settings: list[tuple[str, list[str]]], duration: float | None) -> Scenario | Run:
    """Load a scenario, changed and cut as is asked for, or a saved run, which stays as it is."""
    import carom

    if options.is_saved_run(source):
        asked = {"--duration": duration, **dict(settings)}
        for name in (name for name, value in asked.items() if value not in (None, [])):
            raise typer.BadParameter(f"{source} is a saved run, which stays as it is", param_hint=name)
        return carom.load_run(source)
    scenario = options.load_with(source, [each for _, more in settings for each in more])
    return scenario if duration is None else scenario.with_values({"duration": duration})


def _names(sources: tuple[str, str], settings: tuple[list[str], list[str]]) -> tuple[str, str]:
    """Name the two by their sources, by what is set in them where these are the same, and else by letters."""
    one, two = sources
    if one == two:
        one, two = (" ".join([source, *more]) for source, more in zip(sources, settings, strict=True))
    elif Path(one).name != Path(two).name:
        one, two = Path(one).name, Path(two).name
    return (one, two) if one != two else ("a", "b")


def _show(comparison: RunComparison, place: Destination, written: list[str], tolerance: float | None) -> None:
    parting = comparison.parting
    facts = {
        "a": comparison.names[0],
        "b": comparison.names[1],
        "same_bits": comparison.same_bits,
        "largest": comparison.largest,
        "tolerance": tolerance,
        "within": None if tolerance is None else bool(comparison.largest <= tolerance),
        "end_time": comparison.end_time,
        "same_events": parting.same,
        "first_difference": None
        if parting.ball is None
        else {"ball": parting.ball, "a": _event(parting.event_a), "b": _event(parting.event_b)},
        "only_in_a": comparison.only_in_a,
        "only_in_b": comparison.only_in_b,
        "changes": [dict(zip(("value", "a", "b"), row, strict=True)) for row in _rows(comparison)],
    }
    said = [("", comparison.verdict)]
    if tolerance is not None:
        time = comparison.first_over(tolerance)
        over = "never farther apart" if time is None else f"farther apart from t = {time:.6g} on"
        said.append(("", f"tolerance {tolerance:g}: {over}"))
    said.append(("- ", f"events: {parting.speak(comparison.names)}"))
    said += [("- ", note) for note in comparison.notes]
    show(place, written, facts=facts, tables={"balls": comparison.by_ball}, paragraphs=said)


def _rows(comparison: RunComparison) -> list[tuple[Any, ...]]:
    return list(zip(*(column.tolist() for column in comparison.changes.to_dict().values()), strict=True))


def _event(event: Event | None) -> dict[str, Any] | None:
    from dataclasses import asdict

    return None if event is None else asdict(event)
