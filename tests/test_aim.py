"""Aiming in Python: what the engine computes comes over whole, and what cannot be aimed at is said."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import carom
from carom import aim

TABLE = {"preset": "pool_9ft"}
CUE = {"id": "cue", "position": [0.635, 0.6]}
ONE = {"id": "1", "position": [0.9, 1.4]}
SHOT = {"V0": 2.5, "phi_deg": 90}


def lying(*balls: dict[str, object], **more: object) -> carom.Scenario:
    return carom.Scenario.from_dict({"table": TABLE, "balls": [CUE, *balls], **more})


def test_directions_are_degrees_from_the_x_axis() -> None:
    scenario = lying(ONE)
    assert aim.at_point(scenario, (0.635, 2.0)) == 90.0
    assert aim.at_point(scenario, np.array([0.1, 0.6])) == 180.0
    assert aim.at_ball(scenario, "1") == aim.at_point(scenario, (0.9, 1.4))
    distance = math.hypot(0.9 - 0.635, 1.4 - 0.6)
    off = math.degrees(math.asin(2 * 0.028575 / distance * 0.5))
    assert aim.at_ball(scenario, "1", cut_deg=30) == pytest.approx(aim.at_ball(scenario, "1") - off, abs=1e-12)


def test_the_cue_ball_is_that_of_the_shot_or_the_one_that_is_named() -> None:
    white = {"id": "white", "position": [0.2, 1.4]}
    assert aim.at_ball(lying(ONE, white), "1", cue_ball="white") == 0.0
    assert aim.at_ball(lying(ONE, white, shot={**SHOT, "cue_ball": "white"}), "1") == 0.0


def test_a_ghost_ball_agrees_with_its_cut() -> None:
    scenario = lying(ONE)
    ghost = aim.ghost_ball(scenario, "1", "rt")
    assert aim.at_point(scenario, ghost.center) == pytest.approx(ghost.direction_deg, abs=1e-12)
    assert aim.at_ball(scenario, "1", cut_deg=ghost.cut_deg) == pytest.approx(ghost.direction_deg, abs=1e-12)
    to_pocket = np.subtract(aim.aiming_point(scenario, "rt"), (0.9, 1.4))
    assert math.degrees(math.atan2(to_pocket[1], to_pocket[0])) == pytest.approx(ghost.direction_deg + ghost.cut_deg)


def test_pots_are_the_same_alone_and_listed() -> None:
    scenario = lying(ONE, {"id": "2", "position": [0.4, 1.9]})
    pots = aim.open_pots(scenario)
    assert {pot.ball for pot in pots} == {"1", "2"}
    assert pots == sorted(pots, key=lambda pot: -pot.precision_deg)
    for pot in pots:
        assert aim.pot(scenario, pot.ball, pot.pocket) == pot
        assert aim.at_pot(scenario, pot.ball, pot.pocket) == pot.direction_deg
        assert aim.required_precision(scenario, pot.ball, pot.pocket) == pot.precision_deg > 0
        assert sum(pot.window_deg) / 2 == pytest.approx(pot.direction_deg)
        assert all(isinstance(value, (str, float, tuple)) for value in dataclasses.astuple(pot))
    assert aim.easiest_pot(scenario) == pots[0]


def test_an_easy_pot_drops() -> None:
    scenario = lying({"id": "1", "position": [1.0, 2.2]}, shot=SHOT)
    pot = aim.easiest_pot(scenario)
    assert pot is not None
    run = scenario.with_values({"shot.phi_deg": pot.direction_deg}).run()
    (drop,) = run.events.by_kind("ball_pocket").by_ball("1")
    (hole,) = (hole for hole in scenario.outline()["pockets"] if hole["id"] == pot.pocket)
    assert math.dist((drop.x, drop.y), hole["center"]) == pytest.approx(hole["radius"])


def test_no_pot_is_none() -> None:
    assert aim.easiest_pot(lying()) is None
    assert aim.open_pots(lying()) == []


def test_the_stick_meets_a_ball_and_the_rail() -> None:
    behind = {"id": "1", "position": [0.635, 0.45]}
    ball, rail = aim.obstructions(lying(behind, shot=SHOT))
    assert (ball.kind, ball.id, rail.kind, rail.id) == ("ball", "1", "cushion", "bottom")
    assert ball.clear_from_deg is not None
    assert aim.least_elevation(lying(behind, shot=SHOT)) == ball.clear_from_deg
    raised = {**SHOT, "theta_deg": ball.clear_from_deg}
    assert aim.obstructions(lying(behind, shot=raised)) == []
    assert aim.least_elevation(lying(behind, shot=raised)) == ball.clear_from_deg, "whatever the shot's elevation"


def test_what_cannot_be_aimed_at_is_said() -> None:
    scenario = lying(ONE)
    asked = {
        "ball": lambda: aim.at_ball(scenario, "9"),
        "cut_deg": lambda: aim.at_ball(scenario, "1", cut_deg=90),
        "cue_ball": lambda: aim.open_pots(scenario, cue_ball="9"),
        "point": lambda: aim.at_point(scenario, (0.635, 0.6)),
        "pocket": lambda: aim.ghost_ball(scenario, "1", "top"),
        "shot": lambda: aim.obstructions(scenario),
    }
    for place, ask in asked.items():
        with pytest.raises(carom.ScenarioError) as error:
            ask()
        assert [found for found, _ in error.value.problems] == [place]
    with pytest.raises(carom.ScenarioError, match='ball "1" has no free way into "lb"'):
        aim.pot(scenario, "1", "lb")
    with pytest.raises(ValueError, match="unpack"):
        aim.at_point(scenario, (1, 2, 3))
