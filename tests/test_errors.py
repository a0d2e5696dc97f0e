"""Exceptions: what they are, what they say, and that they pickle."""

import pickle

import pytest

import carom
from carom.errors import RecordError

ERRORS = [
    carom.CaromError("anything"),
    carom.ScenarioError([("balls[1].radius", "must be finite"), ("", "and more")]),
    carom.ScenarioError("one line"),
    carom.SimulationError("overlap at time 1", "{}"),
    carom.TrajectoryError([("mine.csv, line 3, xr", "is empty")]),
    RecordError([("gas.gsd, frame 3, positions[1, 0]", "must be finite, got nan")]),
    carom.RunError("time 9 is outside the run"),
    carom.MissingExtraError("pandas is not installed: needs carom[data]"),
]


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_error_pickles_whole(error: carom.CaromError) -> None:
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error)
    assert str(again) == str(error)
    assert vars(again) == vars(error)


def test_scenario_error_is_a_value_error_with_one_line_for_each_problem() -> None:
    error = ERRORS[1]
    assert isinstance(error, ValueError)
    assert str(error) == "balls[1].radius: must be finite\nand more"
    assert error.problems == [("balls[1].radius", "must be finite"), ("", "and more")]


def test_simulation_error_is_a_runtime_error_that_carries_the_scenario() -> None:
    error = ERRORS[3]
    assert isinstance(error, RuntimeError)
    assert (str(error), error.scenario) == ("overlap at time 1", "{}")
