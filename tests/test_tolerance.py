"""How far off a shot may be: against the geometry of a hole, single runs, and what cannot be asked."""

import math
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_hex
from test_maps import cells_of
from test_noise import NOISE, straight_in

import carom
from carom import aim

SPEED, DIRECTION = "shot.V0", "shot.phi_deg"
RADIUS, CUE_DISTANCE, HOLE_DISTANCE, HOLE = 0.028575, 0.5, 0.6, 0.05


def to_a_hole() -> carom.Scenario:
    """Give a straight shot up the table into a hole in the cloth, with balls that do not rub on each other."""
    table = carom.Table.rectangle(width=1, length=2, pockets=[carom.Pocket("hole", (0.5, 1.5), HOLE)])
    places = {"1": 1.5 - HOLE_DISTANCE, "cue": 1.5 - HOLE_DISTANCE - CUE_DISTANCE}
    balls = [carom.Ball(ball, radius=RADIUS, mass=0.17, position=(0.5, y)) for ball, y in places.items()]
    physics = carom.Physics(flight=carom.Cloth(), ball_ball=carom.Elastic(), ball_cushion=carom.Elastic())
    return carom.Scenario(table, balls, physics=physics, shot=carom.Shot(V0=2, phi_deg=90))


def half_window_deg() -> float:
    """Give how far off the cue ball may start for the other ball to get over the hole.

    Seen from the ball, whose centre has to pass the hole's within its radius, that is sin β = r / L. The cue ball's
    line passes its centre at D sin δ = 2 R sin(δ + β).
    """
    beta = math.asin(HOLE / HOLE_DISTANCE)
    return math.degrees(math.atan2(2 * RADIUS * math.sin(beta), CUE_DISTANCE - 2 * RADIUS * math.cos(beta)))


def legend_of(ax: Any) -> list[str]:
    """Give the words of a legend, in order."""
    return [text.get_text() for text in ax.get_legend().get_texts()]


def is_in_hole(table: carom.Ensemble) -> Any:
    """Say of each run whether the ball is in the hole; the cue ball may follow it."""
    return table["1.pocket"] == "hole"


@pytest.fixture(scope="module")
def found() -> carom.Tolerance:
    return to_a_hole().tolerance({SPEED: 2.5, DIRECTION: 1.2}, is_in_hole, NOISE, cells=12, steps=400)


def test_the_margin_of_the_direction_is_that_of_geometry(found: carom.Tolerance) -> None:
    margin, half = found.margins[DIRECTION], half_window_deg()
    assert aim.pot(to_a_hole(), "1", "hole").precision_deg / 2 == pytest.approx(half, rel=1e-9)
    assert (margin.meant, margin.resolution) == (90.0, 1.2 / 400)
    for side in (margin.below, margin.above):
        assert side < half < side + margin.resolution
    assert (margin.is_missed_below, margin.is_missed_above) == (True, True)
    assert found.is_met


def test_jaws_give_a_ball_more_room_than_a_straight_line_has() -> None:
    shot = straight_in()
    margin = shot.tolerance({SPEED: 0.1, DIRECTION: 1.2}, "1", cells=1).margins[DIRECTION]
    # Up to the window's ends the ball touches no jaw, and drops whatever the rubber does.
    assert aim.pot(shot, "1", "rt").precision_deg / 2 < margin.below + margin.resolution
    # The shot is its own mirror image; but for round-off both sides lose the goal in the same step.
    assert margin.below == pytest.approx(margin.above, abs=1.01 * margin.resolution)


def test_a_margin_ends_where_single_runs_miss(found: carom.Tolerance) -> None:
    shot, margin = to_a_hole(), found.margins[SPEED]
    assert (margin.is_missed_below, margin.is_missed_above) == (True, False)
    assert margin.above == 2.5
    for steps, potted in ((0, True), (1, False)):
        speed = 2.0 + 2.5 * (-(margin.below / margin.resolution + steps) / 400)
        assert ("1" in shot.with_values({SPEED: speed}).run().shot.pocketed) == potted


def test_a_margin_is_read_from_the_meant_shot_outwards() -> None:
    shot, seen = straight_in(), []

    def goal(table: carom.Ensemble) -> Any:
        seen.append(table)
        off = np.round((table[DIRECTION] - 45) * 10)
        return (abs(off) != 2) & (off < 4)

    found = shot.tolerance({SPEED: 1, DIRECTION: 1}, goal, cells=2, steps=10, outcomes=[])
    direction, speed = found.margins[DIRECTION], found.margins[SPEED]
    assert direction == carom.Margin(45.0, 0.1, 0.1, 0.1, is_missed_below=True, is_missed_above=True)
    assert speed == carom.Margin(2.0, 1.0, 1.0, 0.1, is_missed_below=False, is_missed_above=False)
    assert repr(found) == (
        "Tolerance: shot.V0: 2, at least 1 below and at least 1 above, in steps of 0.1; "
        "shot.phi_deg: 45, 0.1 below and 0.1 above, in steps of 0.1"
    )
    assert [len(table) for table in seen] == [42, 25]


def test_no_stroke_is_slower_than_none_or_lower_than_level() -> None:
    found = straight_in().tolerance({SPEED: 5, "shot.theta_deg": 4}, "1", cells=5, steps=20)
    assert found.table.grid is not None
    assert found.table.grid.shape == (8, 6)
    assert min(found.table[SPEED]) == 0.0
    assert found.margins["shot.theta_deg"].below == 0.0
    assert not found.margins["shot.theta_deg"].is_missed_below


def test_strokes_that_miss_the_ball_are_no_strokes() -> None:
    shot = straight_in().with_values({"shot.a": 0.9})
    found = shot.tolerance({"shot.a": 0.3, DIRECTION: 1}, lambda table: np.ones(len(table), bool), cells=2, steps=3)
    margin = found.margins["shot.a"]
    assert (margin.below, margin.above) == pytest.approx((0.3, 0.0))
    assert (margin.is_missed_below, margin.is_missed_above) == (False, False)
    assert found.table["met"].reshape(5, 5).all(axis=1).tolist() == [True, True, True, False, False]
    assert legend_of(found.map()) == ["met", "missed", "no outcome", "meant"]


def test_a_missed_shot_has_a_map_and_no_margins() -> None:
    found = straight_in().with_values({DIRECTION: 43}).tolerance({SPEED: 1, DIRECTION: 3}, "1", cells=12, steps=2)
    assert not found.is_met
    assert math.isnan(found.margins[SPEED].below)
    assert repr(found.margins[SPEED]) == "Margin: 2, missed as meant, in steps of 0.5"
    assert 0 < found.table["met"].sum() < 625


def test_each_cell_is_one_run_without_noise(found: carom.Tolerance) -> None:
    assert found.table.grid is not None
    shape = found.table.grid.shape
    # At a speed of 2 the cells below none are cut off: 2 + 2.5 k/12 > 0 from k = -9 on.
    assert shape == (22, 25)
    for row in (0, 9 * 25 + 12, 9 * 25, 21 * 25 + 8):
        run = found.table.scenario_of(row).run()
        assert found.table["met"][row] == ("1" in run.shot.pocketed)
    middle = found.table.scenario_of(9 * 25 + 12)
    assert middle == to_a_hole()


def test_the_map_marks_the_meant_shot_and_the_noise(found: carom.Tolerance) -> None:
    ax = found.map()
    one, two, mark = ax.lines
    assert mark.get_xydata().tolist() == [[90.0, 2.0]]
    for sigmas, ellipse in ((1, one), (2, two)):
        x, y = ellipse.get_xydata().T
        off = ((x - 90) / (sigmas * 0.125)) ** 2 + ((y - 2) / (sigmas * 0.075)) ** 2
        assert off == pytest.approx(1.0)
    assert legend_of(ax) == ["met", "missed", "1 sigma", "2 sigma", "meant"]
    met = found.table["met"].reshape(22, 25)
    assert np.array_equal(cells_of(ax), np.where(met, 0, 1))
    colours = {to_hex(patch.get_facecolor()) for patch in ax.get_legend().get_patches()}
    assert len(colours) == 2
    turned = found.map(x=SPEED)
    assert turned.lines[2].get_xydata().tolist() == [[2.0, 90.0]]
    assert turned.lines[0].get_xdata().max() == pytest.approx(2.075)


def test_noise_that_does_not_scatter_has_no_ellipse() -> None:
    shot = straight_in()
    still = shot.tolerance({SPEED: 1, DIRECTION: 1}, "1", carom.ExecutionNoise(left=1e-3), cells=1, steps=1)
    assert [line.get_label() for line in still.map().lines] == ["meant"]
    of_speed = shot.tolerance({SPEED: 1, DIRECTION: 1}, "1", carom.ExecutionNoise(speed=0.1), cells=1, steps=1)
    assert np.ptp(of_speed.map().lines[0].get_xdata()) == 0.0


def test_what_is_wrong_with_a_tolerance_is_said() -> None:
    def error(reach: Any, scenario: carom.Scenario | None = None, goal: Any = "1", **options: Any) -> str:
        with pytest.raises((carom.ScenarioError, ValueError)) as raised:
            (scenario or straight_in()).tolerance(reach, goal, **{"cells": 1, "steps": 1, **options})
        return str(raised.value)

    both = {SPEED: 1, DIRECTION: 1}
    assert "shot: missing: only a shot is aimed" in error(both, carom.load("midterm"))
    assert "reach: must have two numbers of the shot, got 1 (shot.V0)" in error({SPEED: 1})
    assert "balls.1.mass: is no number of a shot to aim with" in error({SPEED: 1, "balls.1.mass": 0.1})
    assert "shot.direction_deg: the shot says it in the other word" in error({SPEED: 1, "shot.direction_deg": 1})
    for wrong in (0, -1, math.nan, math.inf):
        assert f"shot.V0: how far to look must be positive and finite, got {wrong}" in error({**both, SPEED: wrong})
    assert "cells: must be 1 at least, got 0" in error(both, cells=0)
    assert "steps: must be 1 at least, got 0" in error(both, steps=0)
    assert "goal: there is no ball '7'; known: cue, 1" in error(both, goal="7")
