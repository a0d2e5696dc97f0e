"""The JSON Schema of scenarios, tried by a validator that knows nothing of the engine."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

import carom

Values = dict[str, Any]


@pytest.fixture(scope="module")
def validator() -> Draft202012Validator:
    schema = json.loads(carom.schema())
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


@pytest.mark.parametrize("name", carom.scenarios())
def test_ready_made_scenario_is_valid(validator: Draft202012Validator, name: str) -> None:
    assert list(validator.iter_errors(carom.load(name).to_dict())) == []


def _unknown_key(values: Values) -> None:
    values["balls"][0]["colour"] = "red"


def _negative_radius(values: Values) -> None:
    values["ball_defaults"]["radius"] = -0.075


def _unknown_shape(values: Values) -> None:
    values["table"]["shape"] = "hexagon"


def _position_in_spacetime(values: Values) -> None:
    values["balls"][1]["position"] = [0.5, 1.0, 0.0, 0.0]


def _duration_in_words(values: Values) -> None:
    values["duration"] = "five seconds"


def _no_balls(values: Values) -> None:
    del values["balls"]


def _unknown_law(values: Values) -> None:
    values["physics"]["ball_cushion"] = {"law": "damping", "normal": 0.8}


def _unknown_preset(values: Values) -> None:
    values["table"] = {"preset": "pool_10ft"}


def _shot_into_the_cloth(values: Values) -> None:
    values["shot"] = {"V0": 1.0, "phi_deg": 90.0, "theta_deg": 91.0}


def _friction_of_a_word(values: Values) -> None:
    values["physics"]["ball_ball"] = {"law": "frictional", "normal": 0.9, "friction": "small"}


def _axis_of_depth(values: Values) -> None:
    values["table"]["periodic"] = ["z"]


def _axis_twice(values: Values) -> None:
    values["table"]["periodic"] = ["x", "x"]


def _gas_of_nothing(values: Values) -> None:
    values["gas"] = {"n": 0, "packing_fraction": 0.5}


def _rack_of_no_game(values: Values) -> None:
    values["rack"] = {"seed": 1}


BREAKS = [
    _unknown_key,
    _negative_radius,
    _unknown_shape,
    _position_in_spacetime,
    _duration_in_words,
    _no_balls,
    _unknown_law,
    _unknown_preset,
    _shot_into_the_cloth,
    _friction_of_a_word,
    _rack_of_no_game,
    _axis_of_depth,
    _axis_twice,
    _gas_of_nothing,
]


@pytest.mark.parametrize("break_it", BREAKS)
def test_what_the_schema_refuses_the_engine_refuses(
    validator: Draft202012Validator, break_it: Callable[[Values], None]
) -> None:
    values = carom.load("midterm").to_dict()
    assert validator.is_valid(values)
    break_it(values)
    assert not validator.is_valid(values)
    with pytest.raises(carom.ScenarioError):
        carom.Scenario.from_dict(values)


def test_balls_may_be_left_out_where_there_is_a_rack(validator: Draft202012Validator) -> None:
    values = {"table": {"preset": "pool_9ft"}, "rack": {"game": "nine_ball"}}
    assert validator.is_valid(values)
    assert carom.Scenario.from_dict(values).to_dict() == {"format": 1} | values


def test_a_gas_stands_in_place_of_a_table_and_balls(validator: Draft202012Validator) -> None:
    values = {"duration": 1.0, "gas": {"n": 20, "packing_fraction": 0.3}}
    assert validator.is_valid(values)
    assert carom.Scenario.from_dict(values).to_dict() == {"format": 1} | values
    assert not validator.is_valid({"duration": 1.0, "balls": carom.load("midterm").to_dict()["balls"]})


def test_files_are_valid_as_they_are_written(validator: Draft202012Validator) -> None:
    tomllib = pytest.importorskip("tomllib")
    folder = Path(__file__).parent.parent / "scenarios"
    files = sorted(folder.glob("*.toml"))
    if not files:
        pytest.skip("the ready-made scenarios are not beside the tests")
    for path in files:
        assert validator.is_valid(tomllib.loads(path.read_text(encoding="utf-8"))), path.name
