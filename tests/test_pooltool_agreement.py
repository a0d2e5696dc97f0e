"""Carom and pooltool 0.6.0 agree on the shots that pooltool played; reference/pooltool/README.md says what they are."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import _engine
from carom.pooltool import physics_of_resolver, read_system

REFERENCE = json.loads(
    (Path(__file__).parents[1] / "reference" / "pooltool" / "shots.json").read_text(encoding="utf-8")
)
SHOTS = REFERENCE["shots"]
Row = tuple[float, str, list[str]]
"""An event: time, kind and balls."""

KINDS = ("cue_ball", "slide_to_roll", "ball_ball", "ball_cushion", "ball_pocket")

TIME = 1e-6
"""Largest difference of times up to the first ball-ball contact, in s; without one, up to the first other contact."""

CONTACTS = ("ball_ball", "ball_cushion", "ball_pocket")

LIMIT = 1e-7
"""Largest difference of times in s and of ends in m from those of pooltool without its spacer, where that is exact."""

PLACE = {0: 1e-4, 1: 1e-4, 2: 2e-3}
"""Largest difference of ends, in m, by the number of ball-ball contacts: pooltool moves balls 1e-6 m at each."""

needs_cue_balls = pytest.mark.skipif("cue_ball" not in _engine.EVENT_KINDS, reason="the engine has no cue balls")


def names(shots: list[dict[str, Any]]) -> list[str]:
    return [shot["name"] for shot in shots]


def scenario(shot: dict[str, Any]) -> carom.Scenario:
    physics = REFERENCE["laws"][shot["laws"]]["physics"]
    return carom.Scenario.from_dict(
        {**REFERENCE["scenario"], "physics": physics, "balls": shot["balls"], "shot": shot["shot"]}
    )


def contacts(shot: dict[str, Any]) -> int:
    return sum(event[1] == "ball_ball" for event in shot["events"])


def theirs_up_to_the_first_contact(shot: dict[str, Any]) -> list[Row]:
    rows = [
        (time, kind, sorted(words if kind == "ball_ball" else words[:1]))
        for time, kind, *words in shot["events"]
        if kind in KINDS and (shot.get("valid_until") is None or time <= shot["valid_until"])
    ]
    return up_to_the_first_contact(rows)


def up_to_the_first_contact(rows: list[Row]) -> list[Row]:
    kinds = [kind for _, kind, _ in rows]
    ending = {"ball_ball"} if "ball_ball" in kinds else {"ball_cushion", "ball_pocket"}
    return rows[: next((k + 1 for k, kind in enumerate(kinds) if kind in ending), None)]


@needs_cue_balls
@pytest.mark.parametrize("shot", SHOTS, ids=names(SHOTS))
def test_times_up_to_the_first_contact_of_balls(shot: dict[str, Any]) -> None:
    run = scenario(shot).run()
    rows = [(event.time, event.kind, sorted(event.balls)) for event in run.events if event.kind in KINDS]
    theirs = theirs_up_to_the_first_contact(shot)
    ours = up_to_the_first_contact(rows)[: len(theirs)]
    assert [row[1:] for row in ours] == [row[1:] for row in theirs]
    assert [row[0] for row in ours] == pytest.approx([row[0] for row in theirs], abs=TIME, rel=0)


def is_integrated(shot: dict[str, Any]) -> bool:
    """Tell whether pooltool goes through a blow of the shot in steps."""
    return "mathavan" in shot["laws"]


EXACT = [shot for shot in SHOTS if shot.get("valid_until") is None and not is_integrated(shot)]


@needs_cue_balls
@pytest.mark.parametrize("shot", EXACT, ids=names(EXACT))
def test_contacts_are_those_of_pooltool_without_its_spacer(shot: dict[str, Any]) -> None:
    run = scenario(shot).run()
    theirs = [
        (kind, words[0], time, known)
        for (_, kind, *words), (time, known) in zip(shot["events"], shot["limit"]["times"], strict=True)
        if kind in CONTACTS
    ]
    ours = [event for event in run.events if event.kind in CONTACTS][: len(theirs)]
    for event, (kind, ball, time, known) in zip(ours, theirs, strict=True):
        assert event.kind == kind
        assert ball in event.balls
        assert abs(event.time - time) <= LIMIT + 3 * known
    for place, name in zip(run.positions(run.end_time), run.ball_ids, strict=True):
        if name in shot["limit"].get("end", {}):
            x, y, known = shot["limit"]["end"][name]
            assert math.dist(place[:2], (x, y)) <= LIMIT + 3 * known, name


ENDING = [shot for shot in SHOTS if "end" in shot and shot["valid_until"] is None]


@needs_cue_balls
@pytest.mark.parametrize("shot", ENDING, ids=names(ENDING))
def test_ends(shot: dict[str, Any]) -> None:
    run = scenario(shot).run()
    assert run.status == "at_rest"
    for place, name in zip(run.positions(run.end_time), run.ball_ids, strict=True):
        end = shot["end"][name]
        assert np.isnan(place[0]) == isinstance(end, str), name
        if not isinstance(end, str):
            assert math.dist(place[:2], end) <= PLACE[contacts(shot)], name


@needs_cue_balls
@pytest.mark.parametrize("name", ["nine_ball", "snooker", "three_cushion", "simulated"])
def test_a_saved_system_runs_until_it_rests(name: str) -> None:
    run = read_system(Path(__file__).parent / "pooltool" / f"{name}.json").run()
    assert run.status == "at_rest"
    assert run.events.by_kind("cue_ball")[0].time == 0


def test_the_reference_holds_together() -> None:
    assert len(SHOTS) > 60
    for shot in SHOTS:
        times = [event[0] for event in shot["events"]]
        assert times == sorted(times), shot["name"]
        assert shot["events"][0] == [0.0, "cue_ball", "cue"]
        ends = [place for place in shot.get("end", {}).values() if not isinstance(place, str)]
        assert all(0 < x < 0.9906 and 0 < y < 1.9812 for x, y in ends), shot["name"]


def test_the_laws_of_the_reference_are_those_that_are_read_today() -> None:
    params = {"cue": REFERENCE["pooltool_ball"]}
    for name, laws in REFERENCE["laws"].items():
        assert physics_of_resolver(laws["pooltool"], params) == laws["physics"], name


def test_every_law_and_every_kind_of_shot_occurs() -> None:
    assert {shot["laws"] for shot in SHOTS} == set(REFERENCE["laws"])
    wanted = {"no cushion", "one cushion", "cushions", "cushion first", "jaw", "pocket", "draw", "follow", "stun"}
    assert wanted | {"side", "elevated", "break"} <= {word for shot in SHOTS for word in shot["shows"]}
    assert {contacts(shot) for shot in SHOTS} >= {0, 1, 2}
