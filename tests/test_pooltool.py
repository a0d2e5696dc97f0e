"""What pooltool saved becomes a scenario; the files in tests/pooltool are pooltool 0.6.0's own, without white space."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import carom
from carom.pooltool import DEFAULT_RESOLVER, physics_of_resolver, read_system, scenario_of_system

SYSTEMS = Path(__file__).parent / "pooltool"

SEVEN_FOOT = {
    "shape": "pocket_table",
    "width": 0.9906,
    "length": 1.9812,
    "nose_height": 0.036576,
    "nose_contact": "plan",
    "cushion_width": 0.0508,
    "corner": {"width": 0.118, "angle_deg": 5.3, "depth": 0.0417, "radius": 0.062, "jaw_radius": 0.02095},
    "side": {"width": 0.137, "angle_deg": 7.14, "depth": 0.0685, "radius": 0.0645, "jaw_radius": 0.00795},
}


def system(name: str) -> dict[str, Any]:
    values: dict[str, Any] = json.loads((SYSTEMS / f"{name}.json").read_text(encoding="utf-8"))
    return values


def test_a_table_is_read_back_to_the_numbers_it_was_built_from() -> None:
    assert scenario_of_system(system("nine_ball"))["table"] == SEVEN_FOOT
    snooker = scenario_of_system(system("snooker"))["table"]
    assert (snooker["width"], snooker["length"], snooker["corner"]["angle_deg"]) == (1.7465, 3.5445, 0)
    assert snooker["side"]["depth"] == 0.02413
    three_cushion = scenario_of_system(system("three_cushion"))["table"]
    size = {"width": 1.42, "length": 2.84, "nose_height": 0.037, "nose_contact": "plan"}
    assert three_cushion == {"shape": "rectangle", **size}


def test_jaws_without_rounding_are_read_too() -> None:
    values = system("nine_ball")
    cushions = values["table"]["cushion_segments"]
    assert scenario_of_system(sharpened(values, cushions))["table"]["side"] == {**SEVEN_FOOT["side"], "jaw_radius": 0.0}


def sharpened(values: dict[str, Any], cushions: dict[str, Any]) -> dict[str, Any]:
    """The table with sharp side jaws: rails and facings go on to where they meet."""
    for y, names in ((0.9221, ("3", "15", "4", "14", "4t", "14t")), (1.0591, ("6", "12", "5", "13", "5t", "13t"))):
        for name in names:
            x = 0.0 if name in ("3", "4", "4t", "6", "5", "5t") else 0.9906
            if name.endswith("t"):
                cushions["circular"][name] |= {"center": [x, y, 0.036576], "radius": 0.0}
            else:
                end = "p1" if name in ("6", "12") else "p2"
                cushions["linear"][name][end] = [x, y, 0.036576]
    return values


def test_balls_cue_and_shot_are_carried_over() -> None:
    scenario = scenario_of_system(system("simulated"))
    assert scenario["ball_defaults"] == {
        "radius": 0.028575,
        "mass": 0.170097,
        "sliding_friction": 0.2,
        "rolling_friction": 0.01,
        "spin_decay": pytest.approx(10.9, rel=1e-15),
    }
    assert scenario["balls"] == [
        {"id": "cue", "position": [0.4953, 0.9906]},
        {"id": "1", "position": [0.4953, pytest.approx(1.4859)]},
    ]
    shot = {"cue_ball": "cue", "V0": 1.5, "phi_deg": 94.0, "theta_deg": 0.0, "a": -0.3, "b": -0.3}
    assert scenario["shot"] == shot
    assert (scenario["cue"]["mass"], scenario["cue"]["end_mass"]) == (0.567, 0.170097 / 30)
    assert scenario_of_system(system("three_cushion"))["shot"]["cue_ball"] == "white"


def test_of_a_simulated_system_the_beginning_is_read_and_that_is_said() -> None:
    scenario = scenario_of_system(system("simulated"))
    assert scenario["description"].endswith("It had been simulated; its 7 events are left out.")


def test_moving_balls_go_on_and_are_not_struck() -> None:
    values = system("simulated")
    for ball in values["balls"].values():
        ball["history"]["states"] = []
    values |= {"events": [], "t": 0}
    scenario = scenario_of_system(values)
    assert "shot" not in scenario
    assert scenario["description"].endswith("No shot, as cue, 1 moved already.")
    rvw = values["balls"]["cue"]["state"]["rvw"]
    cue_ball = scenario["balls"][0]
    assert (cue_ball["velocity"], cue_ball["spin"]) == (rvw[1][:2], rvw[2])


def test_balls_in_pockets_and_a_cue_at_rest_are_noted() -> None:
    values = system("nine_ball")
    values["balls"]["3"]["state"]["s"] = 4
    values["cue"]["V0"] = 0.0
    scenario = scenario_of_system(values)
    assert len(scenario["balls"]) == 9
    assert scenario["description"].endswith("In pockets, and left out: 3. No shot, as the cue's speed was 0.")


def test_a_parameter_of_one_ball_is_its_own() -> None:
    values = system("nine_ball")
    values["balls"]["9"]["params"]["u_r"] = 0.02
    scenario = scenario_of_system(values)
    assert "rolling_friction" not in scenario["ball_defaults"]
    assert {ball["rolling_friction"] for ball in scenario["balls"]} == {0.01, 0.02}


PARAMS = {"cue": {"e_b": 0.95, "u_b": 0.05, "e_c": 0.85, "f_c": 0.2, "g": 9.81}}
CLING = 2 * 0.95 / 1.95
FIT = {"a": 0.009951, "b": 0.108, "c": 1.088}


@pytest.mark.parametrize(
    ("law", "values"),
    [
        ({"model": "frictional_inelastic"}, {"law": "frictional", "normal": 0.95, "friction": FIT, "cling": CLING}),
        (
            {"model": "frictional_inelastic", "friction": {"model": "average"}},
            {"law": "frictional", "normal": 0.95, "friction": 0.05, "cling": CLING},
        ),
        ({"model": "frictional_mathavan"}, {"law": "mathavan_2014", "normal": 0.95, "friction": FIT}),
        ({"model": "frictionless_elastic"}, {"law": "elastic"}),
    ],
)
def test_ball_ball_laws_by_name(law: dict[str, Any], values: dict[str, Any]) -> None:
    physics = physics_of_resolver({**DEFAULT_RESOLVER, "ball_ball": law}, PARAMS)
    assert physics["ball_ball"] == values
    assert physics["flight"] == {"law": "cloth", "gravity": 9.81, "air": False}


@pytest.mark.parametrize(
    ("law", "values"),
    [
        (
            {"model": "stronge_compliant", "omega_ratio": 1.8},
            {"law": "stronge_compliant", "normal": 0.85, "friction": 0.2, "frequency_ratio": 1.8},
        ),
        ({"model": "mathavan_2010", "max_steps": 9}, {"law": "mathavan_2010", "normal": 0.85, "friction": 0.2}),
        ({"model": "han_2005"}, {"law": "han_2005", "normal": 0.85, "friction": 0.2}),
        ({"model": "impulse_frictional_inelastic"}, {"law": "frictional", "normal": 0.85, "friction": 0.2}),
        ({"model": "unrealistic"}, {"law": "restitution", "normal": 1.0, "tangential": 1.0}),
        ({"model": "unrealistic", "restitution": True}, {"law": "restitution", "normal": 0.85, "tangential": 1.0}),
    ],
)
def test_cushion_laws_by_name(law: dict[str, Any], values: dict[str, Any]) -> None:
    resolver = {**DEFAULT_RESOLVER, "ball_linear_cushion": law, "ball_circular_cushion": law}
    assert physics_of_resolver(resolver, PARAMS)["ball_cushion"] == values


def test_a_squirt_of_zero_is_an_end_without_mass() -> None:
    resolver = {"stick_ball": {"model": "instantaneous_point", "squirt_throttle": 0.0}}
    assert scenario_of_system(system("nine_ball"), resolver=resolver)["cue"]["end_mass"] == 0


Change = Callable[[dict[str, Any]], object]


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (lambda s: s.pop("cue"), "cue: is missing from pooltool's file"),
        (lambda s: s["cue"].pop("phi"), "cue.phi: is missing"),
        (lambda s: s["balls"]["4"].pop("state"), "no system as pooltool saves it: KeyError: 'state'"),
        (lambda s: s.update(t=1.5), "t: must be 0, as nothing was simulated, got 1.5"),
        (lambda s: s["cue"].update(cue_ball_id="white"), "cue.cue_ball_id: 'white' must be a ball on the table"),
        (lambda s: s["balls"]["4"]["state"]["rvw"][0].__setitem__(0, float("nan")), "balls.4.state.rvw: has no place"),
        (lambda s: s["balls"]["4"]["state"]["rvw"][0].__setitem__(2, 0.1), "balls.4.state.rvw: must lie on the cloth"),
        (lambda s: s["balls"]["4"]["params"].update(e_c=0.8), r"balls.\*.params.e_c: must be the same for all balls"),
        (lambda s: s["balls"]["4"]["params"].update(g=1.6), r"balls.\*.params.g: must be the same"),
        (lambda s: s["table"]["pockets"].pop("lc"), "table: must be one that pooltool builds"),
        (lambda s: s["table"]["pockets"]["rt"].update(radius=0.07), "table: must be one that pooltool builds"),
        (lambda s: cushions(s)["6"]["p1"].__setitem__(1, 1.1), "table: must be one that pooltool builds"),
        (lambda s: cushions(s)["6"]["p1"].__setitem__(2, 0.03), "table: must be one that pooltool builds"),
    ],
)
def test_what_has_no_counterpart_is_an_error(change: Change, problem: str) -> None:
    values = system("nine_ball")
    change(values)
    with pytest.raises(carom.ScenarioError, match=problem):
        scenario_of_system(values)


def cushions(values: dict[str, Any]) -> dict[str, Any]:
    lines: dict[str, Any] = values["table"]["cushion_segments"]["linear"]
    return lines


@pytest.mark.parametrize(
    ("resolver", "problem"),
    [
        ({"ball_ball": {"model": "mine"}}, "ball_ball.model: must be one of .*, got 'mine'"),
        ({"ball_circular_cushion": {"model": "han_2005"}}, "ball_circular_cushion: must be the same law"),
        ({"stick_ball": {"english_throttle": 0.5}}, "stick_ball.english_throttle: must be 1"),
        ({"stick_ball": {"squirt_throttle": 0.5}}, "stick_ball.squirt_throttle: must be 1 or 0"),
    ],
)
def test_laws_without_a_counterpart_are_errors(resolver: dict[str, Any], problem: str) -> None:
    with pytest.raises(carom.ScenarioError, match=problem):
        scenario_of_system(system("nine_ball"), resolver=resolver)


def test_a_number_that_the_law_does_not_use_may_differ() -> None:
    values = system("nine_ball")
    values["balls"]["4"]["params"] |= {"e_b": 0.9, "u_b": 0.06}
    elastic = {"ball_ball": {"model": "frictionless_elastic"}}
    assert scenario_of_system(values, resolver=elastic)["physics"]["ball_ball"] == {"law": "elastic"}


def test_files_that_are_none_are_errors(tmp_path: Path) -> None:
    with pytest.raises(carom.ScenarioError, match=re.escape("save the system as .json")):
        read_system(tmp_path / "shot.msgpack")
    (tmp_path / "half.json").write_text('{"cue": ', encoding="utf-8")
    with pytest.raises(carom.ScenarioError, match=re.escape("half.json: line 1")):
        read_system(tmp_path / "half.json")
    (tmp_path / "list.json").write_text("[]", encoding="utf-8")
    with pytest.raises(carom.ScenarioError, match="is missing from pooltool's file"):
        read_system(tmp_path / "list.json")


def test_the_system_is_left_as_it_was() -> None:
    values = system("simulated")
    before = copy.deepcopy(values)
    scenario_of_system(values)
    assert values == before
