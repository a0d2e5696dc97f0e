"""What came out of a run, as sentences and rows to read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from carom.report import words
from carom.report.rows import Row
from carom.report.text import column, counted, exact, head, listed, short, with_unit
from carom.units import unit_of

if TYPE_CHECKING:
    from carom.run import Run
    from carom.shot import ShotResult

MOST_EVENTS = 1000
WORDS = ("kind", "ball_a", "ball_b", "cushion", "pocket")
NUMBERS = {"x": "length", "y": "length", "closing_speed": "speed", "impulse": "momentum"}


def count_events(run: Run) -> int:
    """Give the number of events, kept or not."""
    return sum(run.diagnostics["events"].values())


def name_events(run: Run) -> str:
    """Give the events by kind: ``1 ball_ball and 11 ball_cushion``; empty where there are none."""
    kinds = [f"{exact(number)} {kind}" for kind, number in run.diagnostics["events"].items() if number]
    return listed(kinds) if kinds else ""


def verdict(run: Run) -> str:
    """Say in a sentence or two how the run ended, and how right it is by its own audit."""
    unit = run.scenario.units.get("time")
    ended = f"{words.STATUSES.get(run.status, run.status)}, at t = {with_unit(short(run.end_time), unit)}"
    count = count_events(run)
    events = f"{counted(count, 'event')}: {name_events(run)}" if count else "Nothing was hit"
    return f"{ended}. {events}. {_energy_kept(run)}." if count else f"{ended}. {events}."


def _energy_kept(run: Run) -> str:
    error = run.diagnostics["energy_error"]
    if error == 0.0:
        return "Every event changed the energy exactly as its law says"
    limit = with_unit(short(error, 2), unit_of(run.scenario.units, "energy"))
    return f"No event changed the energy by more than {limit} beyond what its law says"


def facts(run: Run) -> list[Row]:
    """Give the few numbers that are looked for first."""
    units, found = run.scenario.units, run.diagnostics
    energy = unit_of(units, "energy")
    rows = [
        Row("end", with_unit(short(run.end_time), units.get("time")), run.status),
        Row("events", exact(count_events(run)), name_events(run)),
        Row(
            "energy at the end",
            with_unit(short(found["final_energy"], 4), energy),
            f"of {with_unit(short(found['initial_energy'], 4), energy)} at the start",
        ),
        Row("energy error", with_unit(short(found["energy_error"], 2), energy), "the largest in one event"),
    ]
    if found["lost_time"] > 0.0:
        rows.append(Row("lost time", with_unit(short(found["lost_time"], 3), units.get("time")), "waiting for steps"))
    return rows


def event_table(run: Run) -> dict[str, Any] | None:
    """Give the first `MOST_EVENTS` events as a table, None where none were kept.

    It has ``heads``, ``rows``, the places of the columns that are ``words``, and the ``count`` of all events.
    """
    if run.record == "none":
        return None
    kept, units = run.events, run.scenario.units
    shown = kept[:MOST_EVENTS]
    heads = {name: head(name, unit_of(units, quantity)) for name, quantity in NUMBERS.items()}
    named = [name for name in WORDS if name != "pocket" or run.pocket_ids]
    columns: list[list[str]] = [[exact(index) for index in shown["index"].tolist()], column(shown["time"])]
    columns += [["" if word is None else word for word in shown[name]] for name in named]
    columns += [column(shown[name]) for name in NUMBERS]
    names = ["index", head("time", units.get("time")), *named, *heads.values()]
    if np.any(kept["cluster"] >= 0):
        names.append("cluster")
        columns.append(["" if number < 0 else exact(number) for number in shown["cluster"].tolist()])
    rows = list(zip(*columns, strict=True))
    return {"heads": names, "rows": rows, "words": range(2, 2 + len(named)), "count": len(kept)}


def outcome_rows(run: Run) -> list[Row]:
    """Give what came of the shot; none where there was none, or where no events were kept."""
    if run.record == "none" or "shot" not in run.scenario.to_dict():
        return []
    shot, unit = run.shot, run.scenario.units.get("time")
    if shot.is_miscue:
        return [Row("miscue", "yes", "the tip slipped off, and no law says what happens then")]
    falls = zip(shot.pocketed, shot.pockets, shot.pocket_times, strict=True)
    texts = [f"{ball} in {pocket} at {with_unit(short(time, 4), unit)}" for ball, pocket, time in falls]
    first = f"at {with_unit(short(shot.first_hit_time, 4), unit)}" if shot.first_hit_time is not None else ""
    counts = [f"{len(before)} before, {len(after)} after" for before, after in _before_and_after(shot)]
    rows = [
        Row("first ball hit", shot.first_ball_hit or "none", first),
        Row("pocketed", listed(texts) if texts else "none", "the cue ball too" if shot.is_cue_ball_pocketed else ""),
        Row("cushions of the cue ball", counts[0], "before and after that first contact"),
        Row("cushions of all balls", counts[1]),
        Row("balls to a cushion", listed(shot.balls_to_cushion) if shot.balls_to_cushion else "none", "after it"),
    ]
    return [*rows, Row("off the table", listed(shot.off_table))] if shot.off_table else rows


def _before_and_after(shot: ShotResult) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    return [
        (shot.cushions_before, shot.cushions_after),
        (shot.all_cushions_before, shot.all_cushions_after),
    ]


def step_rows(run: Run) -> list[Row]:
    """Give a stepped run's steps in a few numbers; none for an exact run, and where they were not kept."""
    if run.record != "all" or run.steps is None:
        return []
    steps = run.steps
    unit = run.scenario.units.get("time")
    lengths = np.diff(steps["time"])
    hits = np.array([steps[f"{ball}.hit"] != None for ball in run.ball_ids])  # noqa: E711 - of each entry
    rows = [
        Row("steps", exact(len(lengths))),
        Row("steps with a hit", exact(int(hits.any(axis=0).sum()))),
        Row("balls that waited", exact(int(hits.sum())), "over all steps, each ball by itself"),
    ]
    if len(lengths):
        rows.append(Row("last step", with_unit(short(float(lengths[-1])), unit)))
    return rows


def diagnostic_rows(run: Run) -> list[Row]:
    """Give all that the run measured of itself, each with what it means."""
    units = run.scenario.units
    found = dict(run.diagnostics)
    rows = [Row(kind, exact(count), words.KINDS.get(kind, "")) for kind, count in found.pop("events").items()]
    for name, value in found.items():
        text = short(value, 6 if name.endswith(("_energy", "_loss", "_time")) else 2)
        unit = unit_of(units, words.QUANTITIES.get(name, ""))
        rows.append(Row(name, with_unit(text, unit), words.DIAGNOSTICS.get(name, "")))
    return rows
