"""A snapshot holds what it was given, or says what is wrong with it."""

import pickle
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from gases import gas

from carom.errors import RecordError
from carom.records import Snapshot

GOOD: dict[str, Any] = {
    "time": 0.5,
    "events": 3,
    "size": (4, 3),
    "periodic": (True, False),
    "positions": [[1, 1], [2, 1]],
    "velocities": [[1, 0], [0, 0]],
    "radii": [0.5, 0.0],
    "masses": [1, 2],
}


def test_arrays_are_copies_that_cannot_be_written_to() -> None:
    positions = np.ones((1, 2))
    snapshot = Snapshot(0.0, 0, (4, 3), (True, True), positions, np.zeros((1, 2)), [0.5], [1.0])
    positions[0, 0] = 2.0
    assert snapshot.positions.tolist() == [[1.0, 1.0]]
    for name in ("size", "periodic", "positions", "velocities", "radii", "masses"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(snapshot, name)[...] = 0


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({"time": np.nan}, "time: must be finite, got nan"),
        ({"time": "now"}, "time: must be a number, got 'now'"),
        ({"events": -1}, "events: must be a whole number from 0 on, got -1"),
        ({"events": 1.5}, "events: must be a whole number from 0 on, got 1.5"),
        ({"size": (4, 0)}, "size[1]: must be positive and finite, got 0.0"),
        ({"size": 4.0}, "size: must be of shape (2,), got ()"),
        ({"periodic": (1, 0)}, "periodic: must be two of True and False, got (1, 0)"),
        ({"positions": [[1, 1], [2, np.nan]]}, "positions[1, 1]: must be finite, got nan"),
        (
            {"positions": np.zeros((0, 2)), "velocities": np.zeros((0, 2)), "radii": [], "masses": []},
            "at least one disc",
        ),
        ({"velocities": [[1, 0, 0], [0, 0, 0]]}, "velocities: must be of shape (2, 2), got (2, 3)"),
        ({"velocities": [["a", "b"], ["c", "d"]]}, "velocities: must be real numbers, got <U1"),
        ({"radii": [0.5, -0.1]}, "radii[1]: must be zero or positive and finite, got -0.1"),
        ({"masses": [0, 1]}, "masses[0]: must be positive and finite, got 0.0"),
        ({"images": [[0, 0], [2**31, 0]]}, "images[1, 0]: must be within 32 bits, got 2147483648"),
        ({"images": [[0.0, 0], [1, 0]]}, "images: must be whole numbers, got float64"),
        ({"ids": ["a"]}, "ids: must be 2, got 1"),
        ({"ids": ["a", "a"]}, "ids: must be different, 'a' is there twice"),
        ({"ids": ["a", ""]}, "ids[1]: must be a text that is not empty, got ''"),
    ],
)
def test_what_is_no_snapshot_is_refused_with_its_field(change: dict[str, Any], problem: str) -> None:
    with pytest.raises(RecordError) as caught:
        Snapshot(**{**GOOD, **change})
    assert problem in str(caught.value)


def test_every_problem_is_told_at_once() -> None:
    with pytest.raises(RecordError) as caught:
        Snapshot(**{**GOOD, "time": np.inf, "masses": [1, -1]})
    assert [place for place, _ in caught.value.problems] == ["time", "masses[1]"]


def test_snapshots_are_equal_by_their_bits() -> None:
    one = Snapshot(**{**GOOD, "velocities": [[1, 0], [0, 0.0]]})
    assert one == Snapshot(**GOOD, single_precision=["radii"])
    assert one != Snapshot(**{**GOOD, "velocities": [[1, 0], [0, -0.0]]})
    assert one != Snapshot(**GOOD, images=[[0, 0], [0, 0]])
    assert one != Snapshot(**GOOD, ids=["a", "b"])
    assert one != "something else"


def test_snapshots_pickle_and_are_changed_by_replacing() -> None:
    one = gas(3, ids=True)
    assert pickle.loads(pickle.dumps(one)) == one
    assert replace(one, time=7.0).time == 7.0
    assert replace(one, time=7.0) != one
