"""Tests of the stepped oracle: by hand, on the midterm, and against the exact oracle."""

import json
import math

import pytest

from . import exact, reference
from .stepped import simulate

DT = reference.DT


def box(balls, duration, width=1.0, length=1.0, cushion=None):
    physics = {"ball_cushion": cushion or {"law": "elastic"}}
    return {
        "table": {"shape": "rectangle", "width": width, "length": length},
        "physics": physics,
        "balls": balls,
        "duration": duration,
    }


def ball(radius, position, velocity=(0.0, 0.0), **more):
    return {"radius": radius, "position": position, "velocity": velocity, **more}


# --- by hand (all numbers are exact in binary) ---------------------------------------------------------------------


def test_a_ball_that_hits_a_wall_waits_for_the_end_of_its_step():
    run = simulate(box([ball(0.125, (0.5, 0.5), (1.0, 0.25))], 1.0), 0.25)
    assert [row.time for row in run.steps] == [0, 0.25, 0.5, 0.75, 1.0]
    assert [row.positions[0] for row in run.steps][1:3] == [(0.75, 0.5625), (0.875, 0.59375)]
    assert [(e.step, e.time, e.cushion) for e in run.events] == [(1, 0.375, "right")]
    assert [row.hit for row in run.steps] == [[False], [False], [True], [False], [False]]
    assert run.positions[0] == (0.375, 0.71875) and run.lost_time == 0.125


def test_with_restart_no_time_is_lost():
    run = simulate(box([ball(0.125, (0.5, 0.5), (1.0, 0.25))], 1.0), 0.25, after_hit="restart")
    assert [row.time for row in run.steps] == [0, 0.25, 0.375, 0.625, 0.875, 1.0]
    assert run.positions[0] == (0.25, 0.75) and run.lost_time == 0


def test_the_state_between_steps_is_straight_then_waiting():
    run = simulate(box([ball(0.125, (0.5, 0.5), (1.0, 0.25))], 1.0), 0.25)
    assert run.state_at(0.3125) == ([(0.8125, 0.578125)], [(1.0, 0.25)])
    for time in (0.375, 0.4375, 0.5):
        assert run.state_at(time) == ([(0.875, 0.59375)], [(-1.0, 0.25)])
    assert run.state_at(0.625) == ([(0.75, 0.625)], [(-1.0, 0.25)])


def test_only_one_axis_of_a_corner_is_resolved_per_step():
    run = simulate(box([ball(0.25, (0.5, 0.625), (1.0, 1.0))], 1.0), 0.5)
    assert [(e.step, e.time, e.cushion) for e in run.events] == [(0, 0.125, "top"), (1, 0.625, "right")]


def test_a_tie_between_the_axes_goes_to_x():
    run = simulate(box([ball(0.25, (0.5, 0.5), (1.0, 1.0))], 1.0), 0.5)
    assert [(e.time, e.cushion) for e in run.events] == [(0.25, "right"), (0.5, "top")]


def test_two_balls_meet_head_on_and_swap_their_velocities():
    balls = [ball(0.125, (0.25, 0.5), (1.0, 0.0)), ball(0.125, (0.75, 0.5))]
    run = simulate(box(balls, 0.5), 0.5)
    assert [(e.kind, e.time, e.ball_a, e.ball_b) for e in run.events] == [("ball_ball", 0.25, 0, 1)]
    assert run.positions == [(0.5, 0.5), (0.75, 0.5)] and run.velocities == [(0, 0), (1, 0)]
    assert run.lost_time == 0.5


def test_at_equal_times_ball_ball_comes_before_wall_and_takes_both_balls():
    balls = [ball(0.125, (0.25, 0.5), (-1.0, 0.0)), ball(0.125, (0.75, 0.5), (-3.0, 0.0))]
    run = simulate(box(balls, 0.25), 0.25)
    assert [(e.kind, e.time) for e in run.events] == [("ball_ball", 0.125)]
    assert run.positions == [(0.125, 0.5), (0.375, 0.5)] and run.velocities == [(-3, 0), (-1, 0)]


def test_unequal_masses_follow_the_elastic_formula_and_momentum_is_kept():
    balls = [ball(0.125, (0.25, 0.5), (1.0, 0.125), mass=3.0), ball(0.125, (0.75, 0.5625), (0.0, 0.0))]
    for normal in ("before", "contact"):
        run = simulate(box(balls, 0.5), 0.5, normal=normal)
        (ua, va), (ub, vb) = run.velocities
        assert math.isclose(3 * ua + ub, 3) and math.isclose(3 * va + vb, 0.375)
        assert math.isclose(run.energy(), run.energy(0))


def test_the_normal_is_taken_before_or_after_the_move():
    balls = [ball(0.125, (0.25, 0.5), (1.0, 0.0)), ball(0.125, (0.75, 0.625))]
    before, contact = (simulate(box(balls, 0.5), 0.5, normal=n) for n in ("before", "contact"))
    at_contact = before.positions
    for run, (a, b) in ((before, [(0.25, 0.5), (0.75, 0.625)]), (contact, at_contact)):
        along = math.atan2(b[1] - a[1], b[0] - a[0])
        assert math.isclose(math.atan2(*reversed(run.velocities[1])), along)


# --- the midterm ---------------------------------------------------------------------------------------------------


def test_the_midterm_in_the_default_reading_has_the_known_hits():
    run = simulate(reference.MIDTERM, DT)
    known = [(9, 0.275), (17, 0.5265625), (23, 0.6995052083333335), (30, 0.9233165816803252)]
    for event, (step, time) in zip(run.events, known, strict=False):
        assert event.step == step and math.isclose(event.time, time, rel_tol=1e-14)
    assert [event.kind for event in run.events].index("ball_ball") == 3
    assert run.end_time == 5.0 and run.deepest_overlap == 0


def test_the_committed_readings_are_what_the_method_gives():
    stored = json.loads(reference.STEPPED_FILE.read_text())
    assert stored == json.loads(json.dumps(reference.stepped_reference()))


def test_a_full_last_step_goes_past_the_duration_and_a_given_number_of_steps_ignores_it():
    assert simulate(reference.MIDTERM, DT, last_step="full").end_time == 167 * DT
    assert simulate(reference.MIDTERM, DT, steps=10).end_time == 10 * DT
    assert simulate(reference.MIDTERM, 0.01).steps[-1].step == 500
    assert simulate(reference.MIDTERM, 0.01, last_step="full").steps[-1].step == 500


def mean_error(dt, **reading):
    """Distance of red from its exact place at t = 5, averaged over steps a little longer than dt."""
    truth = [float(c) for c in exact.simulate(reference.MIDTERM, dps=30).positions[0]]
    runs = [simulate(reference.MIDTERM, dt * (1 + k / 20), **reading) for k in range(8)]
    return sum(math.dist(run.positions[0], truth) for run in runs) / len(runs)


@pytest.mark.parametrize("after_hit", ["wait", "restart"])
@pytest.mark.parametrize("normal", ["before", "contact"])
def test_the_method_converges_to_the_exact_run_at_first_order(after_hit, normal):
    coarse, fine = (mean_error(dt, after_hit=after_hit, normal=normal) for dt in (4e-3, 5e-4))
    assert fine < 0.01
    assert 4 < coarse / fine < 16  # 8 at first order; the hits' places within their steps scatter about it


# --- what is refused -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "change",
    [
        {"table": {"shape": "circle", "radius": 1.0}},
        {"table": {"shape": "rectangle", "width": 1, "length": 1, "obstacles": []}},
        {"physics": {"ball_ball": {"law": "restitution", "normal": 0.9}}},
        {"physics": {"flight": {"law": "field", "acceleration": [0, -1]}}},
    ],
)
def test_what_the_method_cannot_do_is_refused(change):
    with pytest.raises(ValueError):
        simulate({**box([ball(0.1, (0.5, 0.5))], 1.0), **change}, 0.1)
