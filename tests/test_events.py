"""Event tables: rows, columns and parts."""

import pytest

import carom
from carom.events import COLUMNS


def test_columns_are_those_of_an_event_in_order(run: carom.Run) -> None:
    assert run.events.names == list(COLUMNS)
    assert {name: run.events[name].dtype.kind for name in COLUMNS} == {
        **dict.fromkeys(["index", "cluster"], "i"),
        **dict.fromkeys(["kind", "ball_a", "ball_b", "cushion", "pocket"], "O"),
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


def test_head_on_contact_is_where_arithmetic_puts_it() -> None:
    """The centres are 1 apart and close at speed 2; the surfaces meet after (1 − 0.25) / 2, at x = 0.375 + 0.125."""
    balls = [
        carom.Ball("a", radius=0.125, position=(0, 1), velocity=(1, 0)),
        carom.Ball("b", radius=0.125, position=(1, 1), velocity=(-1, 0)),
    ]
    run = carom.Scenario(carom.Table.circle(radius=4), balls, duration=0.5).run()
    assert list(run.events) == [carom.Event(0, 0.375, "ball_ball", "a", "b", None, 0.5, 1.0, 1.0, 0.0, 2.0, 2.0, None)]
    assert run.events[0].position == (0.5, 1.0)
    assert run.events[0].normal == (1.0, 0.0)
    assert run.events[0].balls == ("a", "b")


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
    with pytest.raises(ValueError, match="unknown cushion 'lfet'; known are bottom, right, top, left"):
        run.events.by_cushion("lfet")
    with pytest.raises(ValueError, match="unknown cushion"):
        run.events.by_kind("ball_cushion").by_cushion("lfet")
    with pytest.raises(ValueError, match="unknown kind of event 'bal'; known are ball_ball"):
        run.events.by_kind("bal")


def test_same_words_are_shared_strings(run: carom.Run) -> None:
    kinds = run.events.by_kind("ball_cushion")["kind"]
    assert len({id(kind) for kind in kinds}) == 1
