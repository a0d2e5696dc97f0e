"""Two runs side by side: the first event that differs, how far the balls come apart, and what else differs."""

import re

import numpy as np
import pytest

import carom
from carom import Ball, RunError, Scenario, Stepped, Table, compare


@pytest.fixture(scope="module")
def nudged() -> Scenario:
    return carom.load("midterm").with_values({"balls.red.velocity[0]": 3.1})


def test_a_run_and_itself_are_the_same_bits(midterm: Scenario, run: carom.Run) -> None:
    comparison = compare(midterm, run)
    assert comparison.same_bits
    assert comparison.largest == 0.0
    assert comparison.first_over(0.0) is None
    assert comparison.parting.event is None
    assert comparison.parting.same == len(run.events)
    assert len(comparison.changes) == 0
    assert comparison.verdict.startswith("the same bits")


def test_the_first_event_that_differs_is_the_first_of_another_sort(
    run: carom.Run, midterm: Scenario, nudged: Scenario
) -> None:
    comparison = compare(midterm, nudged)
    parting = comparison.parting
    other = nudged.run()
    mine, theirs = (
        [(event.kind, event.balls, event.cushion) for event in each.events.by_ball("red")] for each in (run, other)
    )
    assert parting.ball == "red"
    place = next(place for place, (a, b) in enumerate(zip(mine, theirs, strict=False)) if a != b)
    assert parting.event_a == run.events.by_ball("red")[place]
    assert parting.event_b == other.events.by_ball("red")[place]
    assert parting.time == min(parting.event_a.time, parting.event_b.time)
    assert not comparison.same_bits


def test_the_order_of_events_without_a_common_ball_does_not_count() -> None:
    """Two balls bounce between their own walls; in the second run the one that was first is second."""
    table = Table.rectangle(width=2, length=2)

    def scenario(late: float) -> Scenario:
        a = Ball("a", radius=0.1, position=(1.0, 0.5), velocity=(1.0, 0.0))
        b = Ball("b", radius=0.1, position=(1.0 - late, 1.5), velocity=(1.0, 0.0))
        return Scenario(table, [a, b], duration=5)

    comparison = compare(scenario(0.01), scenario(-0.01))
    assert comparison.a.events["ball_a"].tolist() != comparison.b.events["ball_a"].tolist()
    assert comparison.parting.event is None
    assert comparison.largest == pytest.approx(0.02)


def test_events_are_counted_that_agree_for_all_their_balls(midterm: Scenario) -> None:
    short = midterm.with_values({"duration": 1.0})
    missed = short.with_values({"balls.blue.position": [0.9, 0.2]})
    parting = compare(short, missed).parting
    assert parting.same == 3
    assert parting.event_a is not None
    assert parting.event_a.kind == "ball_ball"
    assert parting.ball == "red"


def test_an_event_may_have_no_counterpart(midterm: Scenario) -> None:
    still = midterm.with_values({"balls.red.velocity": [0.0, 0.0]})
    comparison = compare(midterm, still)
    parting = comparison.parting
    assert comparison.b.status == "at_rest"
    assert comparison.end_time == 5.0
    assert parting.event_b is None
    assert parting.event_a is not None
    assert parting.event_a.index == 0
    assert "the right cushion at t = 0.275 in a, nothing more in b" in parting.speak(("a", "b"))


def test_distances_are_those_of_the_runs(run: carom.Run, midterm: Scenario, nudged: Scenario) -> None:
    comparison = compare(midterm, nudged, samples=11)
    other = nudged.run()
    assert set(comparison.times) == {*np.linspace(0, 5, 11), *run.events["time"], *other.events["time"]}
    apart = np.linalg.norm(run.positions(comparison.times) - other.positions(comparison.times), axis=-1)
    assert comparison.distances == pytest.approx(apart, abs=1e-15)
    assert comparison.table.names == ["time", "red.distance", "blue.distance"]
    assert comparison.largest == comparison.distances.max()
    by_ball = comparison.by_ball
    assert by_ball["at"][0] == comparison.times[apart[:, 0].argmax()]
    over = comparison.times[np.argmax(apart[:, 1] > 1e-6)]
    assert by_ball["over_1e-06"][1] == over
    assert comparison.first_over(1e-6) == min(by_ball["over_1e-06"])
    assert comparison.first_over(comparison.largest) is None
    assert np.isnan(compare(midterm, midterm).by_ball["over_1e-12"]).all()


def test_what_differs_between_the_scenarios_is_listed(midterm: Scenario) -> None:
    changed = midterm.with_values({"balls.red.radius": 0.05, "table.length": 3.0, "title": "Another"})
    changes = compare(midterm, changed).changes
    rows = set(zip(changes["value"], changes["a"], changes["b"], strict=True))
    assert rows == {("balls.red.radius", None, 0.05), ("table.length", 2.0, 3.0)}
    text = repr(compare(midterm, midterm.run(method=Stepped(dt=0.03))))
    assert "method.dt: absent | 0.03" in text


def test_balls_are_matched_by_id(midterm: Scenario) -> None:
    values = midterm.to_dict()
    red, blue = values["balls"]
    green = {**blue, "id": "green", "position": [0.8, 1.8]}
    turned = compare(midterm, Scenario.from_dict({**values, "balls": [blue, red]}))
    assert turned.largest == 0.0
    assert turned.parting.event is None
    more = compare(midterm, Scenario.from_dict({**values, "balls": [green, blue]}))
    assert (more.balls, more.only_in_a, more.only_in_b) == (["blue"], ["red"], ["green"])
    assert {"only in a: red", "only in b: green"} <= set(more.notes)
    with pytest.raises(RunError, match=re.escape("no ball is in both: a has red, blue; b has green")):
        compare(midterm, Scenario.from_dict({**values, "balls": [green]}))


def test_runs_are_compared_to_the_earlier_end(midterm: Scenario, run: carom.Run) -> None:
    comparison = compare(midterm.run(duration=2.0), run, names=("short", "long"))
    assert comparison.end_time == 2.0
    assert comparison.times.max() == 2.0
    assert comparison.parting.event is None
    assert comparison.largest == 0.0
    assert not comparison.same_bits
    assert "long goes on to t = 5 (time_limit); not compared" in comparison.notes


def test_runs_that_kept_no_flights_cannot_be_compared(midterm: Scenario) -> None:
    little = midterm.with_values({"record": "none"})
    assert compare(little, midterm).largest == 0.0
    with pytest.raises(RunError, match=r"^mine: the run kept no flights"):
        compare(midterm, little.run(), names=("yours", "mine"))
    with pytest.raises(ValueError, match="samples"):
        compare(midterm, midterm, samples=1)


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_ready_made_scenario_is_the_same_as_itself(name: str) -> None:
    scenario = carom.load(name)
    comparison = compare(scenario, scenario.run(), samples=20)
    assert comparison.same_bits
    assert len(repr(comparison).splitlines()) < 25
