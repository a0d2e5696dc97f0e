"""The best aim on a grid: each point is as sure as `success` says, whatever is run at once and whenever it ends."""

import signal
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest
from test_maps import cells_of
from test_noise import NOISE, straight_in
from test_tolerance import DIRECTION, SPEED, half_window_deg, is_in_hole, to_a_hole

import carom
from carom import best_aim as module

SHOT = straight_in()
# From a cue that hardly moves, whose scatter is cut off at none, to one that pots; and so for its direction.
AIMS = {SPEED: [0.05, 0.6, 2.0], DIRECTION: [44.2, 45.0, 45.9, 46.1]}


@pytest.fixture(scope="module")
def best() -> carom.BestAim:
    return SHOT.best_aim(AIMS, "1", NOISE, runs=60, seed=3)


def successes(aims: dict[str, Any], goal: Any = "1", **options: Any) -> list[carom.Success]:
    points = [(speed, direction) for speed in aims[SPEED] for direction in aims[DIRECTION]]
    shots = (SHOT.with_values({SPEED: speed, DIRECTION: direction}) for speed, direction in points)
    return [shot.success(goal, NOISE, **options) for shot in shots]


def test_each_point_is_as_sure_as_success_says(best: carom.BestAim) -> None:
    table, expected = best.table, successes(AIMS, runs=60, seed=3)
    assert table.names == [SPEED, DIRECTION, "probability", "low", "high", "hits", "runs"]
    assert table["hits"].tolist() == [pot.hits for pot in expected]
    assert len(set(table["hits"])) > 4
    rows = list(zip(table["probability"], table["low"], table["high"], strict=True))
    assert rows == [(pot.probability, pot.low, pot.high) for pot in expected]
    assert table[SPEED].tolist() == [speed for speed in AIMS[SPEED] for _ in AIMS[DIRECTION]]
    assert table[DIRECTION].tolist() == AIMS[DIRECTION] * 3


def test_the_strokes_are_those_of_success_also_where_they_are_cut_off() -> None:
    noise = carom.ExecutionNoise(speed=0.5, elevation_deg=2.0, top=1e-3)
    grid = carom.Grid({"shot.V0": [0.01, 0.4, 2], "shot.theta_deg": [0, 89.5]})
    strokes = module._strokes(SHOT, grid, noise, range(6), 50, seed=8)
    for point in range(6):
        speed, elevation = grid["shot.V0"][point // 2], grid["shot.theta_deg"][point % 2]
        shot = SHOT.with_values({"shot.V0": float(speed), "shot.theta_deg": float(elevation)})
        table = shot.success("1", noise, runs=50, seed=8).table
        for path, numbers in strokes.items():
            assert np.array_equal(numbers[50 * point : 50 * (point + 1)], table[path])
    assert strokes["shot.V0"].min() >= 0.0


def test_the_best_point_is_there_to_be_played(best: carom.BestAim) -> None:
    assert best.probability == best.table["probability"].max() == best.hits / best.runs
    assert best.scenario == SHOT.with_values(best.point)
    assert best.scenario.success("1", NOISE, runs=60, seed=3).hits == best.hits
    place = f"shot.V0 = {best.point[SPEED]:g}, shot.phi_deg = {best.point[DIRECTION]:g}"
    assert repr(best) == (
        f"BestAim: {place}: {best.probability:.4f}, {best.low:.4f} to {best.high:.4f} (95%), {best.hits} of 60 runs; "
        "best of 12 points"
    )


def test_of_equally_good_points_it_is_the_one_in_their_middle() -> None:
    sure = carom.ExecutionNoise(direction_deg=1e-6)
    directions = 45 + np.array([-0.4, -0.3, -0.2, -0.1, 0.0, -2.0, -3.0])
    best = SHOT.best_aim({DIRECTION: directions}, "1", sure, runs=3)
    assert best.table["hits"].tolist() == [3, 3, 3, 3, 3, 0, 0]
    assert best.point == {DIRECTION: directions[2]}


def test_the_probability_is_that_of_a_bell_over_the_window() -> None:
    # The ball goes along the line of centres, so it falls for directions within the window, and for no others.
    shot, window = to_a_hole(), half_window_deg()
    noise = carom.ExecutionNoise(direction_deg=window)
    off = window * np.array([-1.5, -1.0, 0.0, 1.0, 1.5])
    best = shot.best_aim({DIRECTION: 90 + off}, is_in_hole, noise, runs=2000, seed=1)
    bell = NormalDist(0.0, window)
    exact = np.array([bell.cdf(window - mean) - bell.cdf(-window - mean) for mean in off])
    assert best.point == {DIRECTION: 90.0}
    deviation = np.sqrt(exact * (1 - exact) / 2000)
    assert (abs(best.table["probability"] - exact) < 4 * deviation).all()
    for mean, hits in zip(off, best.table["hits"], strict=True):
        drawn = shot.with_values({DIRECTION: float(90 + mean)}).success(is_in_hole, noise, runs=2000, seed=1).table
        assert hits == (abs(drawn[DIRECTION] - 90) < window).sum()


def test_functions_judge_the_runs_of_many_points_row_by_row() -> None:
    def stops_short(table: carom.Ensemble) -> Any:
        return table["cue.distance"] < 1.0

    best = SHOT.best_aim(AIMS, stops_short, NOISE, runs=20, outcomes=["distance"])
    expected = successes(AIMS, stops_short, runs=20, outcomes=["distance"])
    assert best.table["hits"].tolist() == [pot.hits for pot in expected]
    assert 0 < best.table["hits"].sum() < 240


def test_what_is_run_at_once_changes_nothing(best: carom.BestAim, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[int, int]] = []
    monkeypatch.setattr(module, "RUNS_AT_ONCE", 170)
    grid = carom.Grid(AIMS)
    pieces = SHOT.best_aim(
        grid, "1", NOISE, runs=60, seed=3, threads=1, progress=lambda done, of: told.append((done, of))
    )
    assert pieces.table == best.table
    assert pieces.point == best.point
    assert told == sorted(told)
    assert {of for _, of in told} <= {12 * 60}
    monkeypatch.setattr(module, "RUNS_AT_ONCE", 1)
    assert SHOT.best_aim(grid, "1", NOISE, runs=60, seed=3).table == best.table


def test_without_noise_every_stroke_is_the_meant_one() -> None:
    best = SHOT.best_aim(AIMS, "1", carom.ExecutionNoise(), runs=2)
    assert set(best.table["hits"]) == {0, 2}


MANY = {SPEED: np.linspace(1, 3, 8), DIRECTION: np.linspace(44.2, 45.8, 5)}


def ends_early(stop: Any) -> carom.BestAim:
    return SHOT.best_aim(MANY, "1", NOISE, runs=500, progress=lambda done, of: done > 3000 and stop())


def press_ctrl_c() -> None:
    signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize("stop", [lambda: True, press_ctrl_c], ids=["progress", "ctrl_c"])
def test_what_is_finished_early_is_kept_whole(stop: Any) -> None:
    best = ends_early(stop)
    table, finished = best.table, best.table.has_outcome
    assert not table.is_complete
    assert 0 < finished.sum() < 40
    assert set(table["runs"]) == {0, 500}
    assert np.array_equal(np.isnan(table["probability"]), ~finished)
    assert (table["hits"][~finished] == 0).all()
    assert repr(best).endswith(f"best of {finished.sum()} finished points of 40")
    row = int(np.flatnonzero(finished)[-1])
    shot = SHOT.with_values({path: float(table[path][row]) for path in MANY})
    assert shot.success("1", NOISE, runs=500).hits == table["hits"][row]
    assert np.isnan(cells_of(best.map()).filled(np.nan)).sum() == 40 - finished.sum()


def test_ctrl_c_between_two_ensembles_keeps_those_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "RUNS_AT_ONCE", 10)
    calls = iter(range(10))

    def goal(table: carom.Ensemble) -> Any:
        if next(calls) == 2:
            press_ctrl_c()
        return np.ones(len(table), dtype=bool)

    best = SHOT.best_aim(AIMS, goal, NOISE, runs=5, outcomes=[])
    assert best.table["runs"].tolist() == [5] * 4 + [0] * 8


def test_where_no_point_was_finished_there_is_no_best() -> None:
    with pytest.raises(KeyboardInterrupt):
        SHOT.best_aim({DIRECTION: [44, 45]}, "1", NOISE, runs=20_000, progress=lambda done, of: True)


def test_what_is_wrong_with_an_aim_is_said() -> None:
    def error(aims: Any, scenario: carom.Scenario = SHOT, goal: Any = "1", **options: Any) -> str:
        with pytest.raises((carom.ScenarioError, ValueError, TypeError)) as raised:
            scenario.best_aim(aims, goal, NOISE, **{"runs": 5, **options})
        return str(raised.value)

    assert "shot: missing: only a shot is aimed" in error({DIRECTION: [1]}, carom.load("midterm"))
    known = "known: shot.V0, shot.cue_speed, shot.phi_deg, shot.direction_deg"
    for path in ("shot.phi", "balls.1.position[0]", "shot.cue_ball"):
        assert f"{path}: is no number of a shot to aim with; {known}" in error({path: [0.1, 0.2]})
    assert "shot.cue_speed: the shot says it in the other word, shot.V0" in error({"shot.cue_speed": [1]})
    assert "aims: an empty grid: give numbers for a path such as shot.phi_deg" in error({})
    assert "shot.V0: an axis of 0 numbers gives no grid" in error({DIRECTION: [1, 2], SPEED: []})
    assert "shot.V0: must be zero or positive and finite, got -0.01" in error({SPEED: [1, -0.01]})
    assert ": this stroke makes no scenario: shot: misses the ball" in error({"shot.a": [0.5, 0.99]})
    assert "goal: there is no ball '7'; known: cue, 1" in error({DIRECTION: [45]}, goal="7")
    assert "goal: must give 10 booleans, one for each run; got float64" in error(
        {DIRECTION: [44, 45]}, goal=lambda table: table["end_time"], outcomes=["end_time"]
    )
    assert "level: must be between 0 and 1, got 95" in error({DIRECTION: [45]}, level=95)
    assert "runs" in error({DIRECTION: [45]}, runs=0)


def test_the_map_shows_the_probabilities_and_the_best(best: carom.BestAim) -> None:
    ax = best.map()
    assert np.array_equal(cells_of(ax), best.table["probability"].reshape(3, 4))
    assert (ax.get_xlabel(), ax.get_ylabel()) == (DIRECTION, "shot.V0 (m/s)")
    (mark,) = ax.lines
    assert mark.get_xydata().tolist() == [[best.point[DIRECTION], best.point[SPEED]]]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [f"best: {best.probability:.3g}"]
    turned = best.map("low", x=SPEED)
    assert np.array_equal(cells_of(turned), best.table["low"].reshape(3, 4).T)
    assert turned.lines[0].get_xydata().tolist() == [[best.point[SPEED], best.point[DIRECTION]]]
    with pytest.raises(KeyError, match="no column 'blue'"):
        best.map("blue")
    with pytest.raises(ValueError, match="a map needs a grid with two axes of more than one number"):
        SHOT.best_aim({DIRECTION: [44, 45]}, "1", NOISE, runs=2).map()
