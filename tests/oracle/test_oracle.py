"""Tests of the exact oracle against closed forms and against geometry written anew."""

import json
import math
import random

import mpmath
import pytest

from . import exact, reference
from .exact import simulate

ELASTIC = {"ball_ball": {"law": "elastic"}, "ball_cushion": {"law": "elastic"}}


def scenario(table, balls, physics=None, **end):
    return {"table": table, "balls": balls, "physics": physics or ELASTIC, **end}


def rectangle(width, length, **more):
    return {"shape": "rectangle", "width": width, "length": length, **more}


def polygon(*points):
    """The pieces of a closed polygon."""
    return [{"line": [a, b]} for a, b in zip(points, [*points[1:], points[0]], strict=True)]


def ball(radius, position, velocity=(0, 0), **more):
    return {"radius": radius, "position": list(position), "velocity": list(velocity), **more}


def field(ax, ay, **physics):
    return {**ELASTIC, "flight": {"law": "field", "acceleration": [ax, ay]}, **physics}


def close(value, expected, tolerance=1e-45):
    return abs(value - expected) <= tolerance


def of_kind(run, kind):
    return [event for event in run.events if event.kind == kind]


# --- two discs -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("offset", "printed"),
    [(0.0, 8), (0.5, 8.051001), (1.0, 8.217824), (1.5, 8.563984), (1.9, 9.193341), (1.99, 9.600245)],
)
def test_two_discs_meet_at_the_time_of_the_closed_form(offset, printed):
    balls = [ball(1, (50, 50), (1, 0)), ball(1, (60, 50 + offset))]
    run = simulate(scenario(rectangle(200, 200), balls, collisions=1))
    p = run.system.ctx.mpf(50 + offset) - 50
    distance = run.system.ctx.sqrt(100 + p * p)  # d = 10 is along the velocity in this set-up
    expected = run.system.ctx.sqrt(distance**2 - p * p) - run.system.ctx.sqrt(4 - p * p)
    assert run.events[0].kind == "ball_ball"
    assert close(run.events[0].time, expected)
    shifted = math.sqrt(100 - offset**2) - 10 + float(run.events[0].time)  # the printed table has centres 10 apart
    assert close(shifted, printed, 1e-6)


@pytest.mark.parametrize(("offset", "speed"), [(2.0001, 1), (2.0, 1), (0.5, -1)])
def test_discs_that_miss_graze_or_part_do_not_collide(offset, speed):
    balls = [ball(1, (50, 50), (speed, 0)), ball(1, (60, 50 + offset))]
    run = simulate(scenario(rectangle(200, 200), balls, duration=40))
    assert not of_kind(run, "ball_ball")


def test_unequal_masses_and_restitution_follow_the_impulse_formula():
    physics = {**ELASTIC, "ball_ball": {"law": "restitution", "normal": 0.5}}
    balls = [ball(0.5, (2, 5), (2, 0), mass=3), ball(0.25, (5, 5), (-1, 0.5), mass=0.5)]
    run = simulate(scenario(rectangle(10, 10), balls, physics, collisions=1))
    event, m1, m2 = run.events[0], 3, run.system.ctx.mpf("0.5")
    (v1, v2), n, reduced = run.velocities, event.normal, 3 * m2 / (3 + m2)
    assert close(m1 * v1[0] + m2 * v2[0], 6 - m2) and close(m1 * v1[1] + m2 * v2[1], m2 / 2)
    after = (v2[0] - v1[0]) * n[0] + (v2[1] - v1[1]) * n[1]
    assert close(after, event.closing_speed / 2)
    assert close(event.impulse, 1.5 * reduced * event.closing_speed)
    lost = 6 + m2 * (1 + 0.25) / 2 - run.energy()
    assert close(lost, reduced * (1 - 0.25) * event.closing_speed**2 / 2)


def test_an_elastic_collision_of_equal_discs_swaps_normal_velocities():
    run = simulate(scenario(rectangle(10, 10), [ball(1, (2, 5), (1, 0)), ball(1, (6, 5))], duration=3))
    assert run.velocities == [(0, 0), (1, 0)] and run.events[0].time == 2


# --- cushions of a rectangle ---------------------------------------------------------------------------------------


def test_an_elastic_disc_follows_the_unfolded_line():
    run = simulate(scenario(rectangle(1, 2), [ball(0.05, (0.3, 0.4), (0.7, 0.45))], duration=100))
    sides = [event.cushion_id in ("left", "right") for event in run.events]
    assert (sides.count(True), sides.count(False)) == (78, 23)
    assert close(run.positions[0][0], 0.1, 1e-10) and close(run.positions[0][1], 0.3, 1e-10)


def test_a_lossy_wall_stretches_the_times_geometrically():
    physics = {**ELASTIC, "ball_cushion": {"law": "restitution", "normal": 0.8}}
    run = simulate(scenario(rectangle(1, 1), [ball(0.05, (0.05, 0.5), (1, 0))], physics, collisions=2))
    assert [event.cushion_id for event in run.events] == ["right", "left"]
    assert close(run.events[0].time, 0.9, 1e-15) and close(run.events[1].time, 2.025, 1e-15)


def test_a_shot_into_a_corner_returns_on_its_own_line_after_two_events_at_one_time():
    run = simulate(scenario(rectangle(1, 1), [ball(0.0625, (0.25, 0.25), (1, 1))], collisions=4))
    assert [event.cushion_id for event in run.events] == ["right", "top", "left", "bottom"]
    assert run.events[0].time == run.events[1].time == 0.6875
    x, y = run.positions[0]
    assert x == y


def test_laws_of_single_cushions_override_the_common_one():
    law = {"law": "damping", "factor": 0.5, "cushions": {"right": {"law": "restitution", "normal": 0.25}}}
    physics = {**ELASTIC, "ball_cushion": law}
    run = simulate(scenario(rectangle(2, 2), [ball(0.5, (1, 1), (1, 0.25))], physics, collisions=2))
    assert run.events[0].cushion_id == "right" and run.events[1].cushion_id == "top"
    assert run.velocities[0] == (-0.125, -0.125)


def test_speed_and_direction_are_turned_into_doubles():
    entry = {"radius": 0.1, "position": [0.5, 0.5], "speed": 2.0, "direction_deg": 30.0}
    run = simulate(scenario(rectangle(1, 1), [entry], duration=0.01))
    angle = math.radians(30.0)
    assert run.velocities[0] == (2.0 * math.cos(angle), 2.0 * math.sin(angle))


def test_events_at_the_duration_happen_and_the_state_there_is_that_after_them():
    run = simulate(scenario(rectangle(4, 4), [ball(1, (2, 2), (1, 0))], duration=1))
    assert len(run.events) == 1 and run.velocities[0] == (-1, 0) and run.state_at(0.5)[0] == [(2.5, 2)]


# --- the midterm ---------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def midterm():
    return simulate(reference.MIDTERM)


def test_the_midterm_has_twelve_events_and_the_known_first_times(midterm):
    assert len(midterm.events) == 12 and midterm.status == "time_limit"
    third = 0.5015625 + 0.30625 / 1.92
    for event, expected in zip(midterm.events, (0.275, 0.5015625, third, 0.86472550082018593), strict=False):
        assert close(event.time, expected, 1e-15)
    assert close(midterm.state_at(0.275)[0][0][0], 0.925, 1e-15)
    assert [event.kind for event in midterm.events].index("ball_ball") == 3


def test_the_midterm_loses_energy_only_at_cushions_and_by_the_factor_squared(midterm):
    expected = midterm.kinetic_energy(0)
    assert expected == 12.5
    for event in midterm.events:
        if event.kind == "ball_cushion":
            vx, vy = midterm._states[event.index][2][event.ball_a]
            expected -= (1 - midterm.system.ctx.mpf(0.8) ** 2) * (vx * vx + vy * vy) / 2
    assert close(midterm.energy(), expected)


def test_the_committed_reference_is_what_a_run_with_other_digits_gives(midterm):
    stored = json.loads(reference.EXACT_FILE.read_text())
    assert stored["scenario"] == reference.MIDTERM
    context = midterm.system.ctx
    for event, row in zip(midterm.events, stored["events"], strict=True):
        assert close(event.time, context.mpf(row["time"]), 1e-48)
        assert (event.kind, event.cushion_id) == (row["kind"], row["cushion"])
        assert close(event.closing_speed, context.mpf(row["closing_speed"]), 1e-48)
    for k, name in enumerate(("red", "blue")):
        for ours, key in ((midterm.positions, "position"), (midterm.velocities, "velocity")):
            for number, text in zip(ours[k], stored["final"]["balls"][name][key], strict=True):
                assert close(number, context.mpf(text), 1e-48)


# --- many balls ----------------------------------------------------------------------------------------------------


def gas(count, radius, seed):
    """Discs that do not touch in a 1 x 2 box, at speed 1."""
    rng, balls = random.Random(seed), []
    while len(balls) < count:
        x, y = rng.uniform(radius, 1 - radius), rng.uniform(radius, 2 - radius)
        if all(math.hypot(x - b["position"][0], y - b["position"][1]) > 2.02 * radius for b in balls):
            angle = rng.uniform(0, 2 * math.pi)
            balls.append(ball(radius, (x, y), (math.cos(angle), math.sin(angle))))
    return balls


def test_a_gas_keeps_its_energy_and_comes_back_when_reversed():
    balls = gas(10, 0.06, seed=1)
    forth = simulate(scenario(rectangle(1, 2), balls, duration=1.5))
    assert len(of_kind(forth, "ball_ball")) >= 10
    assert close(forth.energy(), forth.energy(0))
    turned = [ball(0.06, x, (-v[0], -v[1])) for x, v in zip(forth.positions, forth.velocities, strict=True)]
    back = simulate(scenario(rectangle(1, 2), turned, duration=1.5))
    assert len(back.events) == len(forth.events)
    for k, start in enumerate(balls):
        for i in (0, 1):
            assert close(back.positions[k][i], start["position"][i], 1e-40)
            assert close(back.velocities[k][i], -start["velocity"][i], 1e-40)


def test_more_digits_change_nothing_that_matters():
    entry = scenario(rectangle(1, 2), gas(10, 0.06, seed=2), collisions=60)
    coarse, fine = simulate(entry, dps=40), simulate(entry, dps=70)
    assert [e.kind for e in coarse.events] == [e.kind for e in fine.events]
    assert close(coarse.end_time, fine.end_time, 1e-22)


def test_a_rectangle_drawn_as_a_path_gives_the_same_events():
    balls = gas(6, 0.08, seed=3)
    pieces = polygon([0, 0], [1, 0], [1, 2], [0, 2])
    plain = simulate(scenario(rectangle(1, 2), balls, collisions=40))
    drawn = simulate(scenario({"shape": "path", "pieces": pieces}, balls, collisions=40))
    names = {"bottom": "0", "right": "1", "top": "2", "left": "3", None: None}
    assert [names[e.cushion_id] for e in plain.events] == [e.cushion_id for e in drawn.events]
    assert all(close(a.time, b.time) for a, b in zip(plain.events, drawn.events, strict=True))


# --- other shapes --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("angle", [0.3, 1.2, 1.5])
def test_a_ball_in_a_circle_hits_at_equal_steps_of_angle(angle):
    """Launched from the contact circle, R - r = 0.75, at `angle` to the normal: chords 1.5 cos, turns pi - 2 angle."""
    table = {"shape": "circle", "radius": 1.0}
    with mpmath.workdps(70):
        velocity = (-mpmath.cos(angle), mpmath.sin(angle))
        run = simulate(scenario(table, [ball(0.25, (0.75, 0), velocity)], collisions=25))
        for k, event in enumerate(run.events, start=1):
            assert close(event.time, k * 1.5 * mpmath.cos(angle))
            turned = k * (mpmath.pi - 2 * mpmath.mpf(angle))
            assert close(event.point[0], mpmath.cos(turned)) and close(event.point[1], mpmath.sin(turned))
            assert close(event.closing_speed, mpmath.cos(angle))


def l_shape():
    return {"shape": "path", "pieces": polygon([0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4])}


def test_a_disc_hits_a_reflex_corner_at_the_time_of_the_closed_form():
    """The corner is (2, 2); the disc comes along the diagonal with an offset of sqrt(1/2)/4 = 0.176..."""
    run = simulate(scenario(l_shape(), [ball(0.5, (0.75, 1), (1, 1))], collisions=1))
    event, sqrt = run.events[0], run.system.ctx.sqrt
    offset, ahead, speed = 0.25 / sqrt(2), 2.25 / sqrt(2), sqrt(2)
    assert event.corner and event.point == (2, 2) and event.cushion == 2
    assert close(event.time, (ahead - sqrt(0.25 - offset**2)) / speed)
    x, n = run.positions[0], event.normal
    assert close(n[0], (x[0] - 2) * 2) and close(n[1], (x[1] - 2) * 2)
    dot = n[0] + n[1]
    assert close(run.velocities[0][0], 1 - 2 * dot * n[0]) and close(run.velocities[0][1], 1 - 2 * dot * n[1])


def test_a_disc_that_passes_a_reflex_corner_by_a_hair_goes_on():
    """Moving along x = 1.5 - 2^-40 with radius 1/2, past the corner at (2, 2)."""
    table = l_shape()
    run = simulate(scenario(table, [ball(0.5, (1.5 - 2**-40, 1), (0, 1))], duration=2))
    assert not run.events
    run = simulate(scenario(table, [ball(0.5, (1.5 + 2**-40, 1), (0, 1))], duration=2))
    assert run.events[0].corner


def test_the_sinai_billiard_gives_the_digit_loss_orbit():
    """Unit torus, disc of 1/4 at the origin, from (0.5, 0.1) heading 2.5 rad, folded into a quarter of its cell."""
    pieces = [
        {"line": [[0.25, 0], [0.5, 0]]},
        {"line": [[0.5, 0], [0.5, 0.5]]},
        {"line": [[0.5, 0.5], [0, 0.5]]},
        {"line": [[0, 0.5], [0, 0.25]]},
        {"arc": {"center": [0, 0], "radius": 0.25, "from_deg": 90, "to_deg": 0}},
    ]
    with mpmath.workdps(60):
        heading = (mpmath.cos(2.5), mpmath.sin(2.5))
        start = ball(0, (0.5, mpmath.mpf("0.1")), heading)
    run = simulate(scenario({"shape": "path", "pieces": pieces}, [start], collisions=60))
    hits = [event for event in run.events if event.cushion == 4]
    expected = {
        1: (1.5634659785874780, 0.247439213129803, 0.0356908364388385),
        3: (3.4562402539625070, 0.148148597383859, 0.201375254421181),
        5: (6.3137926171724941, 0.219258328056534, 0.120107391853513),
    }
    for hit, (time, x, y) in expected.items():
        event = hits[hit - 1]
        assert close(event.time, time, 2e-15)
        assert close(event.point[0], x, 2e-15) and close(event.point[1], y, 2e-15)


def test_the_long_axis_of_a_stadium_is_a_periodic_orbit():
    arcs = [((1, 0.5), -90, 90), ((0, 0.5), 90, 270)]
    right, left = ({"arc": {"center": list(c), "radius": 0.5, "from_deg": a, "to_deg": b}} for c, a, b in arcs)
    pieces = [{"line": [[0, 0], [1, 0]]}, right, {"line": [[1, 1], [0, 1]]}, left]
    run = simulate(scenario({"shape": "path", "pieces": pieces}, [ball(0.25, (0.5, 0.5), (1, 0))], collisions=5))
    assert [event.cushion for event in run.events] == [1, 3, 1, 3, 1]
    assert all(close(event.time, 0.75 + 1.5 * k) for k, event in enumerate(run.events))


def test_a_disc_that_meets_a_smooth_joint_bounces_once():
    arc = {"arc": {"center": [1, 0.5], "radius": 0.5, "from_deg": -90, "to_deg": 90}}
    pieces = [{"line": [[0, 0], [1, 0]]}, arc, {"line": [[1, 1], [0, 1]]}, {"line": [[0, 1], [0, 0]]}]
    for radius in (0.25, 0):
        run = simulate(scenario({"shape": "path", "pieces": pieces}, [ball(radius, (1, 0.5), (0, 1))], duration=0.6))
        assert len(run.events) == 1 and close(run.velocities[0][1], -1)


@pytest.mark.parametrize("radius", [0.25, 0])
def test_nothing_slips_through_a_smooth_joint_of_rounded_numbers(radius):
    """Capsules turned by odd angles, each shot from the centre of an arc at the joint of that arc and a line."""
    for k in range(40):
        turn = 1 + 8.7 * k
        ux, uy = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        a, b, c, d = ([x * ux - y * uy, x * uy + y * ux] for x, y in [(0.1, -0.5), (1.3, -0.5), (1.3, 0.5), (0.1, 0.5)])
        right, left = [1.3 * ux, 1.3 * uy], [0.1 * ux, 0.1 * uy]
        pieces = [
            {"line": [a, b]},
            {"arc": {"center": right, "radius": 0.5, "from_deg": turn - 90, "to_deg": turn + 90}},
            {"line": [c, d]},
            {"arc": {"center": left, "radius": 0.5, "from_deg": turn + 90, "to_deg": turn + 270}},
        ]
        start = ball(radius, right, (b[0] - right[0], b[1] - right[1]))
        run = simulate(scenario({"shape": "path", "pieces": pieces}, [start], duration=1.2), dps=40)
        assert len(run.events) == 1 and run.events[0].cushion in (0, 1)


def test_without_restitution_a_ball_slides_along_a_cushion_to_the_next():
    """Squares turned by odd angles: a steep hit at the first side, then a slow slide along it into the second."""
    for k in range(20):
        ux, uy = math.cos(math.radians(7 + 17 * k)), math.sin(math.radians(7 + 17 * k))
        corners = ([x * ux - y * uy, x * uy + y * ux] for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)])
        table = {"shape": "path", "pieces": polygon(*corners)}
        physics = {**ELASTIC, "ball_cushion": {"law": "restitution", "normal": 0, "tangential": 1}}
        start = ball(0.1, (0.3 * ux - 0.3 * uy, 0.3 * uy + 0.3 * ux), (ux / 64 + uy, uy / 64 - ux))
        run = simulate(scenario(table, [start], physics, collisions=2))
        assert [event.cushion for event in run.events] == [0, 1]
        assert close(run.events[0].time, 0.2, 1e-14) and close(run.events[1].time, 0.6 * 64, 1e-12)


@pytest.mark.parametrize("radius", [0, 0.125])
def test_a_thin_wall_is_hit_from_both_sides_and_never_through(radius):
    table = rectangle(4, 2, obstacles=[{"wall": [[2, 0], [2, 2]]}])
    balls = [ball(radius, (1, 0.5), (1, 0)), ball(radius, (3, 1.5), (-1, 0))]
    run = simulate(scenario(table, balls, duration=7))
    assert [e.cushion for e in run.events if e.ball_a == 0] == [4, 0] * (len(run.events) // 4)
    assert [e.cushion for e in run.events if e.ball_a == 1] == [5, 1] * (len(run.events) // 4)
    assert all(run.state_at(t / 8)[0][0][0] <= 2 <= run.state_at(t / 8)[0][1][0] for t in range(56))


def test_the_end_of_a_thin_wall_is_a_point():
    table = rectangle(4, 4, obstacles=[{"wall": [[2, 0], [2, 2]]}])
    run = simulate(scenario(table, [ball(0.5, (2.25, 3.5), (0, -1))], collisions=1))
    event = run.events[0]
    assert event.corner and event.point == (2, 2)
    assert close(event.time, 1.5 - run.system.ctx.sqrt(0.25 - 0.0625))


# --- fields --------------------------------------------------------------------------------------------------------


def test_a_ball_dropped_in_a_field_bounces_for_ever():
    run = simulate(scenario(rectangle(1, 4), [ball(0.125, (0.5, 1.125))], field(0, -2), collisions=5))
    assert [event.time for event in run.events] == [1, 3, 5, 7, 9]
    assert close(run.energy(), run.energy(0)) and close(run.energy(4.3), run.energy(0))
    assert run.state_at(4)[0][0] == (0.5, 1.125)


def test_a_lossy_bounce_dies_geometrically_and_ends_as_a_lasting_contact():
    physics = field(0, -2, ball_cushion={"law": "restitution", "normal": 0.5})
    entry = scenario(rectangle(1, 4), [ball(0.125, (0.5, 1.125))], physics, collisions=8)
    run = simulate(entry)
    assert [e.time for e in run.events] == [3 - 2.0 ** (1 - k) for k in range(8)]
    assert run.events[-1].closing_speed == 2 * 0.5**7
    with pytest.raises(exact.OracleError, match="stays on cushion bottom"):
        simulate({**entry, "collisions": 10_000})


@pytest.mark.parametrize("gap", [0.0, 2**-50, -(2**-50)])
def test_a_ball_at_rest_on_a_cushion_in_a_field_is_an_error(gap):
    physics = field(0, -2, ball_cushion={"law": "restitution", "normal": 0.0})
    with pytest.raises(exact.OracleError, match="stays on"):
        simulate(scenario(rectangle(1, 4), [ball(0.125, (0.5, 0.125 + gap))], physics, duration=1))


def test_a_ball_dropped_on_a_round_obstacle_lands_where_geometry_says():
    """Centres 1/4 apart across, radii 1/2 + 1/4: contact sqrt(9/16 - 1/16) above the obstacle's centre."""
    table = rectangle(4, 4, obstacles=[{"circle": {"center": [2, 1], "radius": 0.5}}])
    run = simulate(scenario(table, [ball(0.25, (2.25, 3.5))], field(0, -2), collisions=1))
    height = run.system.ctx.sqrt(run.system.ctx.mpf(1) / 2)
    assert close(run.events[0].time, run.system.ctx.sqrt(2.5 - height))
    assert run.events[0].cushion == 4 and not run.events[0].corner


def test_a_parabola_meets_a_round_obstacle_at_the_first_root_of_its_quartic():
    table = rectangle(4, 4, obstacles=[{"circle": {"center": [2.3, 0.9], "radius": 0.4}}])
    run = simulate(scenario(table, [ball(0.1, (0.5, 1.5), (1.5, 0.8))], field(0.1, -1.7), collisions=1))
    mpf = mpmath.mpf

    def gap(t):
        x = mpf(0.5) + mpf(1.5) * t + mpf(0.1) * t * t / 2
        y = mpf(1.5) + mpf(0.8) * t - mpf(1.7) * t * t / 2
        return (x - mpf(2.3)) ** 2 + (y - mpf(0.9)) ** 2 - (mpf(0.4) + mpf(0.1)) ** 2

    with mpmath.workdps(60):
        after = next(k for k in range(4000) if gap(mpf(k) / 1000) < 0)
        first = mpmath.findroot(gap, (mpf(after - 1) / 1000, mpf(after) / 1000), solver="anderson")
        assert run.events[0].cushion == 4 and close(run.events[0].time, first)


def test_a_point_lands_on_a_thin_shelf_it_flew_around():
    """Thrown up past the end of the shelf at y = 1, it comes down on top, and bounces there."""
    table = rectangle(4, 6, obstacles=[{"wall": [[1, 1], [2, 1]]}])
    run = simulate(scenario(table, [ball(0, (1.875, 0.5), (1, 3))], field(-0.75, -2), duration=4))
    hits = [e for e in run.events if e.cushion_id in ("4", "5")]
    assert {e.cushion_id for e in hits} == {"4"} and hits[0].normal == (0, 1)
    first = run.events[0]
    assert first is hits[0] and close(first.time, (3 + run.system.ctx.sqrt(7)) / 2)


def test_random_quartics_fall_where_their_known_roots_say():
    context, rng = mpmath.MPContext(), random.Random(7)
    context.dps = 60
    for _ in range(50):
        roots = sorted(context.mpf(rng.choice([-1, 1, 1]) * rng.random() ** 4) for _ in range(4))
        polynomial = [context.mpf(rng.choice([-1, 1]))]
        for root in roots:
            polynomial = [a - root * b for a, b in zip([0, *polynomial], [*polynomial, 0], strict=True)]
        slopes = [polynomial[-1] * math.prod(root - other for other in roots if other != root) for root in roots]
        expected = [root for root, slope in zip(roots, slopes, strict=True) if root > 0 and slope < 0]
        found = exact._falls(context, polynomial, None)
        assert len(found) == len(expected)
        assert all(close(a, b, 1e-40) for a, b in zip(found, expected, strict=True))


# --- nothing is missed ---------------------------------------------------------------------------------------------


def arc(center, radius, from_deg, to_deg):
    return {"arc": {"center": list(center), "radius": radius, "from_deg": from_deg, "to_deg": to_deg}}


def line(start, end):
    return {"line": [list(start), list(end)]}


BOUNDARY = [
    line((0, 0), (0.6, 0)),
    arc((0.8, 0), 0.2, 180, 0),  # a bump
    line((1, 0), (1.4, 0)),
    line((1.4, 0), (1.4, 0.5)),  # ends in a reflex corner
    line((1.4, 0.5), (2, 0.5)),
    line((2, 0.5), (2, 1)),
    arc((1.5, 1), 0.5, 0, 180),  # a dome, smooth on the right, on a reflex corner on the left
    line((1, 1), (1, 1.3)),
    arc((0.5, 1.3), 0.5, 0, 90),
    line((0.5, 1.8), (0, 1.8)),
    line((0, 1.8), (0, 0)),
]
CONE = [line((0.2, 1.2), (0.3, 1.4)), line((0.3, 1.4), (0.4, 1.2)), arc((0.3, 1.2), 0.1, 0, -180)]
PIN, WALL = ((1.5, 0.95), 0.1), ((0.3, 0.5), (0.5, 0.9))


def line_distance(point, start, end):
    dx, dy = end[0] - start[0], end[1] - start[1]
    s = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / (dx * dx + dy * dy)
    s = min(1.0, max(0.0, s))
    return math.hypot(point[0] - start[0] - s * dx, point[1] - start[1] - s * dy)


def piece_distance(point, piece):
    """To a line or an arc; the ends of an arc count with the pieces they belong to as well."""
    if "line" in piece:
        return line_distance(point, *piece["line"])
    (x, y), radius = piece["arc"]["center"], piece["arc"]["radius"]
    low, high = sorted((piece["arc"]["from_deg"], piece["arc"]["to_deg"]))
    angle = math.degrees(math.atan2(point[1] - y, point[0] - x))
    if any(low <= angle + turn <= high for turn in (-360, 0, 360)):
        return abs(math.hypot(point[0] - x, point[1] - y) - radius)
    ends = [math.radians(low), math.radians(high)]
    return min(math.hypot(point[0] - x - radius * math.cos(e), point[1] - y - radius * math.sin(e)) for e in ends)


def clearance(positions, radii):
    """The least distance between any two things, in doubles."""
    clearances = []
    for k, (x, r) in enumerate(zip(positions, radii, strict=True)):
        clearances += [piece_distance(x, piece) - r for piece in [*BOUNDARY, *CONE]]
        clearances += [math.dist(x, PIN[0]) - r - PIN[1], line_distance(x, *WALL) - r]
        clearances += [math.dist(x, positions[j]) - r - radii[j] for j in range(k)]
    return min(clearances)


@pytest.mark.parametrize(("acceleration", "seed"), [((0, 0), 1), ((0.2, -1.0), 2), ((-0.5, 0.8), 3)])
def test_no_ball_ever_enters_anything(acceleration, seed):
    """A missed contact would show as an overlap: between two samples a ball moves by less than its radius."""
    obstacles = [{"circle": {"center": list(PIN[0]), "radius": PIN[1]}}, {"path": CONE}, {"wall": list(WALL)}]
    rng = random.Random(seed)
    places = [(0.15, 0.15), (1.2, 0.2), (0.7, 0.5), (0.15, 1.0), (1.7, 0.7), (0.2, 1.6), (0.6, 1.5)]
    radii = [0.03, 0.05, 0.04, 0.06, 0.05, 0.03, 0.07]
    balls = [
        ball(r, p, (rng.uniform(-1, 1), rng.uniform(-1, 1)), mass=r * r) for p, r in zip(places, radii, strict=True)
    ]
    table = {"shape": "path", "pieces": BOUNDARY, "obstacles": obstacles}
    run = simulate(scenario(table, balls, field(*acceleration), duration=4), dps=40)
    assert len({event.cushion_id for event in run.events}) >= 8 and of_kind(run, "ball_ball")
    assert close(run.energy(), run.energy(0), 1e-20)
    for k in range(401):
        positions = [(float(x), float(y)) for x, y in run.state_at(k * 4 / 400)[0]]
        assert clearance(positions, radii) > -1e-14


# --- what is refused -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "change",
    [
        {"table": {"shape": "ellipse"}},
        {"physics": {"ball_ball": {"law": "hertz"}}},
        {"physics": {"ball_cushion": {"law": "damping", "factor": 0.8, "spin": 1}}},
        {"balls": [{"radius": 0.1}]},
        {"balls": [{"radius": 0.1, "position": [0.5, 0.5], "sped": 1}]},
        {"table": {"shape": "path", "pieces": polygon([0, 0], [0, 1], [1, 1], [1, 0])}},
        {"table": {"shape": "path", "pieces": [{"line": [[0, 0], [1, 0]]}, {"line": [[1, 0], [1, 1]]}]}},
        {"table": rectangle(1, 1, obstacles=[{"path": polygon([0.4, 0.4], [0.6, 0.4], [0.5, 0.6])}])},
    ],
)
def test_what_the_oracle_does_not_know_is_refused(change):
    good = scenario(rectangle(1, 1), [ball(0.1, (0.5, 0.5))], duration=1)
    simulate(good)
    with pytest.raises(exact.ScenarioError):
        simulate({**good, **change})


def test_overlapping_balls_are_refused():
    with pytest.raises(exact.OracleError, match="overlap"):
        simulate(scenario(rectangle(1, 1), [ball(0.1, (0.4, 0.5)), ball(0.1, (0.5, 0.5))], duration=1))
