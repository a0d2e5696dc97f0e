"""One's own trajectory against Carom's: agreement, and what is wrong where."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import course_scheme as course
import numpy as np
import pytest

import carom
from carom import ColumnTable, Scenario, TrajectoryComparison, TrajectoryError, compare_trajectory
from carom.comparison.scheme import READINGS
from carom.report.words import choices

COLUMNS = "t,xr,yr,xb,yb"
Compared = Callable[..., TrajectoryComparison]


@pytest.fixture
def compared(scheme: Scenario, tmp_path: Path) -> Compared:
    """Write rows to a file and compare them."""

    def compare(rows: list[course.Row], scenario: Scenario = scheme, **options: Any) -> TrajectoryComparison:
        form = options.pop("form", "%r")
        path = course.write(tmp_path / "mine.csv", rows, form=form)
        return compare_trajectory(scenario, path, columns=COLUMNS, **options)

    return compare


def rows_of(run: carom.Run, times: Any) -> list[Any]:
    """Give a run's own rows."""
    return [(t, *places.ravel().tolist()) for t, places in zip(times.tolist(), run.positions(times), strict=True)]


def said(comparison: TrajectoryComparison) -> str:
    return "\n".join([comparison.verdict, *comparison.reasons])


# Verdicts


def test_the_course_scheme_agrees(compared: Compared, right: list[course.Row]) -> None:
    comparison = compared(right)
    assert comparison
    assert comparison.reasons == []
    assert comparison.first_difference is None
    assert comparison.largest < 1e-12
    assert len(comparison.times) == len(right) == 168


@pytest.mark.parametrize("normal", ["before", "contact"])
@pytest.mark.parametrize("restart", [False, True])
@pytest.mark.parametrize("full", [False, True])
def test_a_student_finds_his_reading(compared: Compared, normal: str, restart: bool, full: bool) -> None:
    comparison = compared(course.simulate(normal=normal, restart=restart, full=full))
    readings = comparison.readings
    assert readings is not None
    mine = ("restart" if restart else "wait", normal, "full" if full else "short")
    agreeing = [
        tuple(readings[name][row] for name in ("after_hit", "normal", "last_step"))
        for row in np.flatnonzero(readings["agrees"])
    ]
    assert agreeing == [mine]
    own = mine == ("wait", "before", "short")
    assert bool(comparison) == own
    told = [reason for reason in comparison.reasons if reason.startswith("it agrees with another reading")]
    assert len(told) == (0 if own else 1)
    settings = dict(re.findall(r"--set (\S+?)=(\w+)", "".join(told)))
    changed = comparison.run.scenario.with_values(settings)
    assert compare_trajectory(changed, comparison_table(comparison), columns=None)


def comparison_table(comparison: TrajectoryComparison) -> ColumnTable:
    """The trajectory as a table with Carom's own names, all its rows."""
    rows = comparison._fit.rows
    columns = {"time": rows.times}
    for ball, name in enumerate(comparison.balls):
        columns |= {f"{name}.x": rows.places[:, ball, 0], f"{name}.y": rows.places[:, ball, 1]}
    return ColumnTable(columns)


def test_a_reading_may_be_of_a_scenario_with_a_number_of_steps(compared: Compared, scheme: Scenario) -> None:
    comparison = compared(course.simulate(duration=0.6), scheme.with_values({"method.steps": 20}))
    assert comparison
    assert comparison.readings is not None
    assert "last_step" not in comparison.readings.names


@pytest.mark.parametrize("mistake", course.MISTAKES)
def test_a_mistake_is_no_agreement(compared: Compared, mistake: str) -> None:
    comparison = compared(course.simulate(mistake=mistake))
    assert not comparison
    assert comparison.first_difference is not None
    assert comparison.readings is not None
    assert not comparison.readings["agrees"].any()


def test_the_first_row_that_differs_is_named(compared: Compared, right: list[course.Row]) -> None:
    rows = list(right)
    t, *red, x, y = rows[50]
    rows[50] = (t, *red, x, y + 1e-3)  # type: ignore[assignment]
    comparison = compared(rows)
    first = comparison.first_difference
    assert first is not None
    assert (first.row, first.where, first.ball) == (50, "line 52", "blue")
    assert first.time == pytest.approx(1.5)
    assert first.distance == pytest.approx(1e-3)
    assert first.position == (x, y + 1e-3)
    assert first.expected == pytest.approx((x, y))
    assert "line 52, t = 1.5: blue is at" in said(comparison)
    assert "up to line 51 (t = 1.47) it agrees to" in said(comparison)
    assert comparison.verdict.startswith("differs: 167 of 168 rows")


def test_a_tolerance_is_kept_to_the_bit(midterm: Scenario) -> None:
    table = midterm.run().trajectory([0.0, 1.0, 2.5, 5.0]).to_dict()
    moved = {**table, "red.x": table["red.x"] + np.array([0.0, 0.0, 0.25, 0.0])}
    off = float(abs(moved["red.x"] - table["red.x"])[2])
    assert compare_trajectory(midterm, moved, tolerance=off)
    assert not compare_trajectory(midterm, moved, tolerance=np.nextafter(off, 0.0))


# What is wrong


@pytest.mark.parametrize(
    ("mistake", "words"),
    [
        (
            "swapped",
            r"normal of this collision is turned by 0\.191 degrees .* the normal with its components exchanged",
        ),
        ("swapped", r"along that direction the velocities are exchanged as they should be"),
        ("tangent", r"both balls hardly move from line 34 to line 169, .* or of another direction"),
        ("not unit", r"both balls hardly move from line 34 to line \d+, .* a normal that is not of length 1"),
        (
            "normal only",
            r"by -0\.8 \(Carom: -0\.8\), the tangential one by 1 \(Carom: 0\.8\): only the normal component",
        ),
        ("undamped", r"by -1 \(Carom: -0\.8\), the tangential one by 1 \(Carom: 0\.8\): nothing is damped"),
        ("missed", r"both balls go straight on: this collision is missing"),
        ("whole", r"the balls exchange their whole velocities"),
        ("one only", r"momentum is not kept in the file: \(1\.536, -2\.048\) before this collision, \(3\.33"),
        (
            "full clock",
            r"places of after_hit = restart, normal = before, but its clock goes on by 0\.03 in every step",
        ),
        (
            "full clock",
            r"the contact of blue with the right cushion at t = 1\.16683, in step 38, .* red stops at that time too",
        ),
        (
            "no radius",
            r"goes past x = 0\.925, .* the right cushion, to x = 1 in line \d+, .*, as if the ball had no radius",
        ),
        ("past", r"past x = 0\.925, .* to x = 1 in line 12, and comes back: it goes straight on until then"),
        ("not turned", r"red stays at the right cushion, x = 0\.925, from line 12 on, as when .* is not turned back"),
        ("long t", r"tangential component of red is multiplied by 2\.00668 = \|t\|\^2 for t = \[1, -n1/n2\]"),
        (
            "long n and t",
            r"normal component .* by 0\.04397\d* = \|n\|\^2 .* by 2\.00668 = \|t\|\^2 .* n and t of length 1",
        ),
        ("exact time", r"the balls meet where they touch exactly, 0\.000341 later than the formula"),
        ("one only", r"blue's velocity goes from \(0, 0\) to \(1\.79\d+, -1\.78\d+\) \(as in Carom's run\)"),
    ],
)
def test_a_mistake_is_named(compared: Compared, mistake: str, words: str) -> None:
    assert re.search(words, said(compared(course.simulate(mistake=mistake))))


@pytest.mark.parametrize("mistake", ["swapped", "tangent", "not unit", "missed", "whole", "one only"])
def test_a_mistake_between_balls_is_placed_at_their_collision(compared: Compared, mistake: str) -> None:
    text = said(compared(course.simulate(mistake=mistake)))
    assert "the collision of red and blue at t = 0.923317, in step 30" in text
    assert "cushion" not in text


@pytest.mark.parametrize("mistake", ["normal only", "undamped"])
def test_a_mistake_at_a_cushion_is_placed_there(compared: Compared, mistake: str) -> None:
    text = said(compared(course.simulate(mistake=mistake)))
    assert "the contact of red with the right cushion at t = 0.275, in step 9" in text
    assert "collision" not in text


def test_six_digits_are_enough_to_name_a_mistake(compared: Compared) -> None:
    text = said(compared(course.simulate(mistake="swapped"), form="%.6f", tolerance=2e-6))
    assert "it is the normal with its components exchanged" in text


def collided(run: carom.Run, turn: float, factor: float) -> list[Any]:
    """Rows of the exact exercise to t = 1.08, where the impulse of its collision is turned, in degrees, and scaled."""
    event = run.events.by_kind("ball_ball")[0]
    times = np.linspace(0.0, 1.08, 109)
    places = run.positions(times)
    before = run.velocities(np.nextafter(event.time, 0.0))
    x, y = event.normal
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    normal = np.array([c * x - s * y, s * x + c * y])
    impulse = factor * ((before[0] - before[1]) @ normal) * normal
    late = times > event.time
    for ball, sign in ((0, -1.0), (1, 1.0)):
        velocity = before[ball] + sign * impulse
        places[late, ball] = run.positions(event.time)[ball] + np.outer(times[late] - event.time, velocity)
    return [(t, *place.ravel().tolist()) for t, place in zip(times.tolist(), places, strict=True)]


@pytest.mark.parametrize("columns", [COLUMNS, "time=t,blue.x=xb,blue.y=yb", "time=t,red.x=xr,red.y=yr"])
def test_a_turned_normal_and_a_weak_impulse_are_measured(
    midterm: Scenario, run: carom.Run, tmp_path: Path, columns: str
) -> None:
    for turn, factor, words in (
        (23.1, 1.0, "the normal of this collision is turned by 23.1 degrees in the file"),
        (-50.0, 1.0, "turned by 50 degrees"),
        (90.0, 1.0, "turned by 90 degrees"),
        (0.0, 0.9, "has Carom's direction but is too weak: 0.9 times Carom's"),
        (0.0, 2.0, "too strong: 2 times"),
        (0.0, -1.0, "drives the balls together: it is -1 times Carom's"),
    ):
        path = course.write(tmp_path / "mine.csv", collided(run, turn, factor))
        comparison = compare_trajectory(midterm, path, columns=columns, duration=1.08)
        text = said(comparison)
        assert words in text
        assert ("exchanged as they should be" in text) == (turn != 0.0)
        assert ("it is the tangent" in text) == (turn == 90.0)
        path = course.write(tmp_path / "right.csv", collided(run, 0.0, 1.0))
        assert compare_trajectory(midterm, path, columns=columns, duration=1.08)


def test_a_wrong_tolerance_does_not_make_up_a_cause(compared: Compared) -> None:
    """Beyond a coarse tolerance velocities are too uncertain, so that nothing is said of them."""
    text = said(compared(course.simulate(mistake="swapped"), form="%.2f", tolerance=0.02))
    assert "degrees" not in text
    assert "factor" not in text


def test_a_scheme_with_waiting_is_late_beside_the_exact_run(
    compared: Compared, midterm: Scenario, right: list[course.Row]
) -> None:
    comparison = compared(right, midterm)
    assert "the contact of red with the right cushion at t = 0.275" in said(comparison)
    assert "the same velocity as in Carom's run, 0.025 behind in time" in said(comparison)
    assert any("--method stepped --dt 0.03" in note for note in comparison.notes)


def test_another_velocity_at_the_start_is_named(compared: Compared, midterm: Scenario) -> None:
    run = midterm.with_values({"balls.red.velocity[0]": 2.5}).run()
    times = np.linspace(0.0, 0.25, 11)
    rows = rows_of(run, times)
    text = said(compared(rows, midterm, duration=0.25))
    assert "from the start red moves with the velocity (2.5, 4) in the file, (3, 4) in Carom's run" in text


def test_a_change_without_an_event_is_named(compared: Compared, midterm: Scenario) -> None:
    """A ball of another radius turns before it is at the cushion."""
    run = midterm.with_values({"balls.red.radius": 0.0999}).run()
    times = np.linspace(0.0, 5.0, 501)
    rows = rows_of(run, times)
    text = said(compared(rows, midterm))
    assert "Carom's run has no event of red, but in the file its velocity becomes (-2.4, 3.2)" in text
    assert "its next event there is the contact of red with the right cushion at t = 0.275" in text


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda t, a, b, c, d: (t, c, d, a, b), "red is where Carom has blue"),
        (lambda t, a, b, c, d: (t, b, a, d, c), "x and y are exchanged"),
        (lambda t, a, b, c, d: (t, 100 * a, 100 * b, 100 * c, 100 * d), "100 times Carom's: another unit"),
        (lambda t, a, b, c, d: (t, a - 0.5, b - 1, c - 0.5, d - 1), r"moved by \(-0.5, -1\): another origin"),
        (lambda t, a, b, c, d: (t, a, c, b, d), "in the order red.x, blue.x, red.y, blue.y: are they named"),
        (lambda t, a, b, c, d: (t + 0.03, a, b, c, d), "0.03 earlier in time: its clock is off"),
    ],
)
def test_rows_wrong_from_the_first_are_explained(
    compared: Compared, right: list[course.Row], change: Callable[..., course.Row], words: str
) -> None:
    assert re.search(words, said(compared([change(*row) for row in right[:-2]])))


# Clocks


@pytest.mark.parametrize(
    ("clock", "words"),
    [
        (lambda t: 1000 * t, "its times are 1000 times Carom's: milliseconds?"),
        (lambda t: round(t / 0.03), "its times count steps; Carom's are 0.03 times that."),
        (lambda t: round(t / 0.03) + 1, "its times count steps, from 1 on; Carom's are 0.03 times that."),
        (lambda t: t + 0.06, "its clock starts at 0.06, Carom's at 0."),
        (lambda t: 1000 * (t + 0.03), "its times are 1000 times Carom's, from 30 on: milliseconds?"),
        (lambda t: 60 * t, "its times are 60 times Carom's: another unit of time"),
    ],
)
def test_a_clock_that_runs_past_the_end_is_named(
    scheme: Scenario, right: list[course.Row], tmp_path: Path, clock: Callable[[float], float], words: str
) -> None:
    for rows, end in ((right, "every row agrees"), (course.simulate(mistake="swapped"), "agree up to line 33")):
        path = course.write(tmp_path / "mine.csv", [(clock(row[0]), *row[1:]) for row in rows])
        with pytest.raises(TrajectoryError) as error:
            compare_trajectory(scheme, path, columns=COLUMNS)
        ((_, message),) = error.value.problems
        assert words in message
        assert end in message


def test_without_a_time_step_a_clock_is_estimated(midterm: Scenario, tmp_path: Path) -> None:
    rows = [(50.0 * t, *places) for t, *places in rows_of(midterm.run(), np.arange(0.0, 5.0, 0.02))]
    course.write(tmp_path / "mine.csv", rows)
    with pytest.raises(
        TrajectoryError, match=r"its times are 50 times Carom's: .* With that set right, every row agrees"
    ):
        compare_trajectory(midterm, tmp_path / "mine.csv", columns=COLUMNS)


def test_a_slow_ball_is_no_clock(compared: Compared, right: list[course.Row]) -> None:
    text = said(compared([(t, 0.1 + 0.6 * t, 0.1 + 0.8 * t, 0.5, 1.0) for t, *_ in right]))
    assert "from the start red moves with the velocity (0.6, 0.8) in the file, (3, 4) in Carom's run" in text


def test_a_clock_too_slow_is_named(compared: Compared, right: list[course.Row]) -> None:
    text = said(compared([(0.03 * row[0], *row[1:]) for row in right]))
    assert "its times are 0.03 times Carom's, as when the time step is multiplied twice" in text


def test_rows_that_are_wrong_make_up_no_clock(scheme: Scenario, tmp_path: Path) -> None:
    rows = [(1000.0 * place, 0.1, 0.1, 0.5, 1.0) for place in range(100)]
    course.write(tmp_path / "mine.csv", rows)
    with pytest.raises(TrajectoryError, match="--duration sets another end"):
        compare_trajectory(scheme, tmp_path / "mine.csv", columns=COLUMNS)


@pytest.mark.parametrize("normal", ["before", "contact"])
def test_restarts_on_a_full_clock_are_told_with_their_reading(compared: Compared, normal: str) -> None:
    rows = course.simulate(restart=True, full=True, normal=normal)[:168]
    text = said(compared([(0.03 * place, *row[1:]) for place, row in enumerate(rows)]))
    assert f"after_hit = restart, normal = {normal}, but its clock" in text
    assert ("--set method.normal=contact" in text) == (normal == "contact")
    astray = [(row[0], row[1] + 1e-3 * (place > 100), *row[2:]) for place, row in enumerate(rows)]
    assert "but its clock" not in said(compared([(0.03 * place, *row[1:]) for place, row in enumerate(astray)]))


def test_restarts_on_a_full_clock_may_run_past_the_end(scheme: Scenario, tmp_path: Path) -> None:
    rows = [(0.03 * place, *row[1:]) for place, row in enumerate(course.simulate(restart=True, full=True))]
    assert rows[-1][0] > 5.03
    path = course.write(tmp_path / "mine.csv", rows)
    with pytest.raises(TrajectoryError, match=r"places of after_hit = restart, normal = before, but its clock"):
        compare_trajectory(scheme, path, columns=COLUMNS)


def test_another_time_step_than_the_scenario_s_is_named(compared: Compared, right: list[course.Row]) -> None:
    note = "its times go in steps of 0.01, the scenario's method in steps of 0.03; --dt 0.01 compares it so"
    assert note in compared(course.simulate(0.01)).notes
    assert note not in compared(course.simulate(mistake="swapped")).notes


# Digits


@pytest.mark.parametrize(
    ("form", "digits", "tolerance"),
    [
        ("%.4g", "4 significant digits", 1e-3),
        ("%.5g", "5 significant digits", 1e-4),
        ("%.2f", "2 decimals", 1e-2),
        ("%.4f", "4 decimals", 1e-4),
    ],
)
def test_few_digits_are_named_and_not_taken_for_physics(
    compared: Compared, right: list[course.Row], form: str, digits: str, tolerance: float
) -> None:
    comparison = compared(right, form=form)
    assert not comparison
    assert comparison.reasons[-1] == (
        f"its numbers have {digits}, and rounding explains every difference; --tolerance {tolerance:g} compares it so"
    )
    assert "cushion" not in said(comparison)
    assert compared(right, form=form, tolerance=tolerance)
    if form == "%.2f":
        return  # with two decimals some times of a restart stand twice
    told = said(compared(course.simulate(restart=True), form=form))
    assert "agrees with another reading of the method, after_hit = restart (" in told


def test_a_mistake_is_found_below_few_digits(compared: Compared) -> None:
    text = said(compared(course.simulate(mistake="one only"), form="%.4f"))
    assert "its numbers have 4 decimals, so that rounding explains differences of up to 7.1e-05 (--tol" in text
    assert "the first row that differs by more is line 34, t = 0.96" in text
    assert "collision of red and blue at t = 0.923317" in text


@pytest.mark.parametrize("form", ["%.4g", "%.5g"])
@pytest.mark.parametrize("mistake", course.MISTAKES)
def test_few_digits_make_up_no_other_mistake(compared: Compared, mistake: str, form: str) -> None:
    """What is said of a rounded file is said of the whole one, or nothing is."""
    rounded, whole = (said(compared(course.simulate(mistake=mistake), form=each)) for each in (form, "%r"))
    for words in ("turned by", "exactly", "same velocity", "hardly move", "exchange their whole", "stops at that time"):
        assert words not in rounded or words in whole
    assert ("nothing is damped" in rounded) == (mistake == "undamped")
    assert ("only the normal component is damped" in rounded) == (mistake == "normal only")


def test_two_decimals_are_too_few_for_a_velocity(compared: Compared) -> None:
    text = said(compared(course.simulate(mistake="swapped"), form="%.2f"))
    assert text.endswith("its numbers have 2 decimals, too few to tell what happens there")


def test_a_few_round_numbers_are_no_rounding(compared: Compared, right: list[course.Row]) -> None:
    assert "its numbers have" not in said(compared([(row[0], 0.1, 0.1, 0.5, 1.0) for row in right]))


def test_two_places_never_look_the_same(compared: Compared, right: list[course.Row]) -> None:
    rows = [(*row[:4], row[4] + 1e-9) for row in right]
    first = next(reason for reason in compared(rows, tolerance=1e-10).reasons if "first row that differs" in reason)
    assert "blue is at (0.5, 1.000000001), in Carom's run at (0.5, 1), 1e-09 apart" in first


# Numbers that end


def test_rows_up_to_the_first_without_a_place_are_compared(compared: Compared, right: list[course.Row]) -> None:
    for place, told in ((32, True), (60, False)):
        rows = right[:place] + [(row[0], *4 * (float("nan"),)) for row in right[place:]]
        comparison = compared(rows)
        text = said(comparison)
        assert not comparison
        assert len(comparison.times) == place
        assert f"it has no place in line {place + 2}, t = {rows[place][0]:g}: xr = nan, yr = nan" in text
        assert "the last event of red before it is the collision of red and blue at t = 0.923317" in text
        assert ("t = [1, -n1/n2] gives infinity or NaN where n2 = 0" in text) == told
        assert compared(rows, duration=0.9)
        assert not compared(rows, duration=3.0)


# Rows that are lost


def test_a_hole_in_the_times_is_named(compared: Compared, right: list[course.Row]) -> None:
    comparison = compared(course.without(right, 40))
    assert not comparison
    assert comparison.first_difference is None
    assert "a row is missing between line 41 and line 42: the time goes from 1.17 to 1.23" in said(comparison)
    assert "they do not cover the run" in comparison.verdict


def test_holes_are_counted(compared: Compared, right: list[course.Row]) -> None:
    rows = [row for place, row in enumerate(right) if place not in (20, 21, 50, 70, 90, 110)]
    reasons = compared(rows).reasons
    assert reasons[0].startswith("2 rows are missing between line 21 and line 22")
    assert reasons[-1] == "and 2 more holes in its times"


@pytest.mark.parametrize("place", [5, 40, 100])
def test_a_lost_row_is_found_though_the_clock_goes_on(compared: Compared, right: list[course.Row], place: int) -> None:
    comparison = compared(course.lost(right, place))
    assert not comparison
    assert f"from line {place + 2} on every row agrees with Carom one row later" in said(comparison)
    assert "it ends at t = 4.98" in said(comparison)


def test_a_row_too_many_is_found(compared: Compared, right: list[course.Row]) -> None:
    doubled = right[:41] + right[40:]
    rows = [(row[0], *other[1:]) for row, other in zip(right, doubled, strict=False)]
    assert "from line 43 on every row agrees with Carom one row earlier" in said(compared(rows))


def test_a_part_does_not_cover_the_run_unless_it_is_asked_for(compared: Compared, right: list[course.Row]) -> None:
    comparison = compared(right[:81])
    assert not comparison
    assert "it ends at t = 2.4 (line 82), the run at 5; --duration 2.4 compares that part" in said(comparison)
    assert compared(right[:81], duration=2.4)
    part = compared(right, duration=2.4)
    assert part
    assert "compared up to t = 2.4: 81 of 168 rows" in part.notes
    assert "it starts at t = 0.03 (line 2), the run at 0" in said(compared(right[1:]))


@pytest.mark.parametrize("step", [0.01, 0.05, 0.0371])
def test_other_time_grids_are_compared_at_their_own_times(midterm: Scenario, step: float) -> None:
    run = midterm.run()
    assert compare_trajectory(midterm, run.trajectory(run.sample_times(step)))
    irregular = np.union1d(run.events["time"], [0.0, 5.0])
    assert compare_trajectory(midterm, run.trajectory(irregular))


def test_a_clock_that_was_added_up_may_end_a_hair_late(midterm: Scenario) -> None:
    run = midterm.run()
    table = run.trajectory(run.sample_times(0.5)).to_dict()
    late = {**table, "time": table["time"] * (1 + 5e-10)}
    assert compare_trajectory(midterm, late, tolerance=1e-7)
    with pytest.raises(TrajectoryError, match="after the run's end"):
        compare_trajectory(midterm, {**table, "time": table["time"] * (1 + 5e-9)})


def test_balls_at_rest_may_be_followed_for_longer() -> None:
    scenario = carom.load("damped_drop")
    run = scenario.run()
    assert run.status == "at_rest"
    table = run.trajectory(np.linspace(0.0, 2.0 * run.end_time, 200))
    assert compare_trajectory(scenario, table)
    assert not compare_trajectory(scenario, run.trajectory(np.linspace(0.0, 0.5 * run.end_time, 200)))


# Tables in memory


def test_tables_of_every_kind_are_taken(midterm: Scenario) -> None:
    table = midterm.run().trajectory(np.linspace(0.0, 5.0, 20))
    frame, arrow = table.to_pandas(), table.to_arrow()
    for source in (table, table.to_dict(), {name: list(x) for name, x in table.to_dict().items()}, frame, arrow):
        assert compare_trajectory(midterm, source)
    with pytest.raises(TypeError, match="must be a path, or a table of columns, got int"):
        compare_trajectory(midterm, 3)


def test_wrong_tables_are_errors(midterm: Scenario) -> None:
    good = midterm.run().trajectory([0.0, 1.0, 5.0]).to_dict()
    for change, words in (
        ({"red.x": ["a", 1.0, 2.0]}, "row 0, red.x: 'a' is not a number"),
        ({"red.x": [1.0, 2.0]}, "columns of different length: time 3, red.x 2"),
        ({"red.x": [[1.0], [2.0], [3.0]]}, "must be one column"),
        ({"red.x": [np.nan, 1.0, 2.0]}, "row 0, red.x: must be finite, got nan"),
    ):
        with pytest.raises(TrajectoryError, match=re.escape(words)):
            compare_trajectory(midterm, {**good, **change})


# The result


def test_a_saved_run_is_compared_as_it_is(scheme: Scenario, right: list[course.Row], tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", right)
    run = scheme.run()
    assert compare_trajectory(run, path, columns=COLUMNS)
    assert compare_trajectory(run, path, columns=COLUMNS, duration=3.0)
    with pytest.raises(carom.RunError, match="duration: 6 is after the end of the run at 5"):
        compare_trajectory(run, path, columns=COLUMNS, duration=6.0)
    with pytest.raises(carom.RunError, match="duration: must be zero or positive and finite, got nan"):
        compare_trajectory(run, path, columns=COLUMNS, duration=float("nan"))
    with pytest.raises(carom.RunError, match="kept no flights"):
        compare_trajectory(scheme.run(record="events"), path, columns=COLUMNS)


def test_the_tables_hold_what_was_compared(compared: Compared, right: list[course.Row], tmp_path: Path) -> None:
    comparison = compared(course.simulate(mistake="whole"))
    table = comparison.table
    assert table.names[:6] == ["time", "red.x", "red.y", "red.carom_x", "red.carom_y", "red.distance"]
    carom_x, carom_y = (np.array([row[c] for row in right]) for c in (1, 2))
    assert table["red.carom_x"] == pytest.approx(carom_x, abs=1e-12)
    apart = np.hypot(table["red.x"] - carom_x, table["red.y"] - carom_y)
    assert table["red.distance"] == pytest.approx(apart, abs=1e-12)
    by_ball = comparison.by_ball
    assert by_ball["ball"].tolist() == ["red", "blue"]
    assert by_ball["within"].tolist() == [int((table[f"{name}.distance"] <= 1e-6).sum()) for name in ("red", "blue")]
    assert by_ball["largest"].max() == comparison.largest
    table.to_csv(tmp_path / "table.csv")


def test_it_says_itself_on_one_screen(compared: Compared) -> None:
    text = repr(compared(course.simulate(mistake="one only")))
    assert text.startswith("TrajectoryComparison of ")
    assert len(text.splitlines()) < 20


def test_a_tolerance_below_zero_and_a_long_delimiter_are_refused(midterm: Scenario, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="tolerance"):
        compare_trajectory(midterm, {}, tolerance=-1.0)
    with pytest.raises(ValueError, match="delimiter"):
        compare_trajectory(midterm, tmp_path, delimiter=";;")


def test_in_a_field_the_factor_of_a_cushion_is_measured_too() -> None:
    scenario = carom.load("damped_drop")
    other = scenario.with_values({"physics.ball_cushion.normal": 0.7}).run()
    text = said(compare_trajectory(scenario, other.trajectory(np.arange(0.0, 2.0, 0.01)), duration=1.99))
    assert "the contact of ball with the bottom cushion at t = 1" in text
    assert "multiplies the normal component of ball's velocity by -0.7 (Carom: -0.8)" in text


def test_the_readings_tried_are_those_of_the_schema() -> None:
    kinds = {"after_hit": "AfterHit", "normal": "NormalTaken", "last_step": "LastStep"}
    assert {name: tuple(choices(kind)) for name, kind in kinds.items()} == READINGS
