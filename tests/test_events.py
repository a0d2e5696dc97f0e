"""Event tables: rows, columns and parts."""

import numpy as np
import pytest

import carom
from carom.events import COLUMNS


def test_columns_are_those_of_an_event_in_order(run: carom.Run) -> None:
    assert run.events.names == list(COLUMNS)
    assert {name: run.events[name].dtype.kind for name in COLUMNS} == {
        **dict.fromkeys(["index", "cluster"], "i"),
        **dict.fromkeys(["kind", "ball_a", "ball_b", "cushion"], "O"),
        **dict.fromkeys(["time", "x", "y", "normal_x", "normal_y", "closing_speed", "impulse"], "f"),
    }


def test_row_says_what_the_columns_say(run: carom.Run) -> None:
    for row, event in enumerate(run.events):
        for name in COLUMNS:
            value = run.events[name][row]
            assert getattr(event, name) == (None if name == "cluster" and value == -1 else value)


def test_rows_hold_plain_python_values(run: carom.Run) -> None:
    event = run.events[0]
    assert [type(getattr(event, name)) for name in ("index", "time", "kind", "x")] == [int, float, str, float]


def test_first_contact_of_the_exercise_is_right(run: carom.Run) -> None:
    """Red meets blue head-on at distance 2r: |(0.4, 0.9)| is passed at speed 5, a little off centre."""
    first = run.events.by_kind("ball_ball")[0]
    assert first.balls == ("red", "blue")
    # The relative position (0.4, 0.9) − (3, 4) t has length 0.15: 25 t² − 9.6 t + 0.9475 = 0.
    time = (9.6 - np.sqrt(9.6**2 - 4 * 25 * 0.9475)) / 50
    assert first.time == pytest.approx(time, rel=1e-14)
    assert np.hypot(*first.normal) == pytest.approx(1, abs=1e-15)


def test_parts_compose_in_any_order(run: carom.Run) -> None:
    events = run.events
    one = events.by_kind("ball_cushion").by_ball("red").by_time(1, 2)
    other = events.by_time(1, 2).by_ball("red").by_kind("ball_cushion")
    assert one == other
    assert list(one) == [e for e in events if e.kind == "ball_cushion" and "red" in e.balls and 1 <= e.time <= 2]


def test_several_words_mean_any_of_them(run: carom.Run) -> None:
    assert run.events.by_kind("ball_ball", "ball_cushion") == run.events
    assert len(run.events.by_cushion("left", "right")) == sum(e.cushion in ("left", "right") for e in run.events)


def test_time_range_includes_both_ends(run: carom.Run) -> None:
    times = run.events["time"]
    assert list(run.events.by_time(times[1], times[3])["index"]) == [1, 2, 3]


def test_slices_and_masks_give_tables(run: carom.Run) -> None:
    assert list(run.events[2:5]["index"]) == [2, 3, 4]
    assert list(run.events[run.events["time"] < 0]) == []
    assert run.events[-1] == run.events[len(run.events) - 1]


def test_no_event_is_none(run: carom.Run) -> None:
    nothing = run.events.by_time(-2, -1)
    assert nothing.first() is None
    assert run.events.first() == run.events[0]
    with pytest.raises(IndexError, match="no event 0; the table has 0"):
        nothing[0]


def test_unknown_words_name_the_known_ones(run: carom.Run) -> None:
    with pytest.raises(ValueError, match="unknown ball 'rde'; known are red, blue"):
        run.events.by_ball("rde")
    with pytest.raises(ValueError, match="unknown kind of event 'bal'; known are ball_ball"):
        run.events.by_kind("bal")


def test_same_words_are_shared_strings(run: carom.Run) -> None:
    kinds = run.events.by_kind("ball_cushion")["kind"]
    assert len({id(kind) for kind in kinds}) == 1
