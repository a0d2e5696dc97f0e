"""Execution noise, and how sure a shot is under it."""

import signal
import threading
from typing import Any

import numpy as np
import pytest

import carom

NOISE = carom.ExecutionNoise.preset("pool_tournament")
BREAK = carom.load("nine_ball_break")


def straight_in(distance: float = 0.4) -> carom.Scenario:
    """Give a ball before the upper right corner, and the cue ball behind it on the line into the pocket."""
    table = carom.Table.preset("pool_9ft")
    corner = np.array([1.27, 2.54])
    back = -np.array([1.0, 1.0]) / np.sqrt(2)
    one, cue = corner + back * 0.5, corner + back * (0.5 + distance)
    balls = [carom.Ball("cue", position=tuple(cue)), carom.Ball("1", position=tuple(one))]
    return carom.Scenario(table, balls, shot=carom.Shot(V0=2, phi_deg=45))


def test_the_preset_is_the_published_one() -> None:
    assert carom.ExecutionNoise(speed=0.075, direction_deg=0.125, elevation_deg=0.1, left=5e-4, top=5e-4) == NOISE
    with pytest.raises(ValueError, match="no execution noise 'pub'; known: pool_tournament"):
        carom.ExecutionNoise.preset("pub")


def test_noise_is_laid_around_the_shot_in_its_own_words() -> None:
    varied = NOISE.around(BREAK)
    shot = BREAK.to_dict()["shot"]
    assert list(varied) == ["shot.V0", "shot.phi_deg", "shot.theta_deg", "shot.a", "shot.b"]
    assert varied["shot.V0"] == carom.Normal(shot["V0"], 0.075, low=0.0)
    assert varied["shot.b"] == carom.Normal(shot["b"], 5e-4 / 0.028575)
    assert varied["shot.theta_deg"] == carom.Normal(0.0, 0.1, low=0.0, high=90.0)
    plain = straight_in().with_shot(carom.Shot(cue_speed=2, direction_deg=45, left=0.1))
    assert list(carom.ExecutionNoise(speed=0.1, left=1e-3, top=1e-3).around(plain)) == [
        "shot.cue_speed",
        "shot.left",
        "shot.top",
    ]
    assert carom.ExecutionNoise().around(plain) == {}
    with pytest.raises(carom.ScenarioError, match="shot: missing: only a shot has execution noise"):
        NOISE.around(carom.load("midterm"))


def test_strokes_scatter_as_they_should() -> None:
    table = BREAK.ensemble(NOISE.around(BREAK), [], runs=4000, seed=2)
    for path, normal in NOISE.around(BREAK).items():
        drawn = table[path]
        if path == "shot.theta_deg":  # half a bell
            assert drawn.min() >= 0
            assert drawn.mean() == pytest.approx(0.1 * np.sqrt(2 / np.pi), rel=0.05)
        else:
            assert drawn.mean() == pytest.approx(normal.mean, abs=4 * normal.standard_deviation / np.sqrt(4000))
            assert drawn.std() == pytest.approx(normal.standard_deviation, rel=0.05)


def test_the_surer_hand_pots_more_often() -> None:
    pots = [straight_in().success("1", NOISE.times(factor), runs=400) for factor in (0.0, 0.5, 1.0, 4.0, 12.0)]
    shares = [pot.probability for pot in pots]
    assert shares[0] == 1.0
    assert shares == sorted(shares, reverse=True)
    assert shares[-1] < 0.5
    assert all(pot.low <= pot.probability <= pot.high for pot in pots)
    assert pots[2].runs == len(pots[2].table) == 400


def test_runs_that_were_not_run_are_neither_hits_nor_misses() -> None:
    def misses(table: carom.Ensemble) -> Any:
        return np.array([pocket is None for pocket in table["1.pocket"]])

    options: dict[str, Any] = {"noise": NOISE.times(6), "runs": 30_000, "seed": 3}
    whole = straight_in().success(misses, **options)
    part = straight_in().success(misses, **options, progress=lambda done, of: done > 5000)
    is_run = part.table.has_outcome
    assert part.runs == is_run.sum() and 0 < part.runs < 30_000
    assert part.hits == misses(whole.table)[is_run].sum()
    assert part.low < part.probability == part.hits / part.runs < part.high


def test_success_is_what_single_runs_say() -> None:
    shot = straight_in(0.6)
    pot = shot.success("1", NOISE.times(6), runs=60, seed=5)
    results = [pot.table.scenario_of(row).run().shot for row in range(60)]
    met = ["1" in result.pocketed and not result.is_cue_ball_pocketed for result in results]
    assert (pot.hits, pot.probability) == (sum(met), sum(met) / 60)
    assert 0 < sum(met) < 60


def test_any_question_to_the_runs_may_be_the_goal() -> None:
    def stops_short(table: carom.Ensemble) -> Any:
        return table["cue.distance"] < 1.0

    found = straight_in().success(stops_short, NOISE, runs=100, outcomes=["distance"])
    assert found.hits == int((found.table["cue.distance"] < 1.0).sum())
    assert repr(found).startswith(f"Success: {found.probability:.4f}, ")
    with pytest.raises(
        TypeError, match=r"goal: must give 10 booleans, one for each run; got float64 of the shape \(10,\)"
    ):
        straight_in().success(lambda table: table["end_time"], NOISE, runs=10, outcomes=["end_time"])
    with pytest.raises(carom.ScenarioError, match="goal: there is no ball '7'; known: cue, 1"):
        straight_in().success("7", NOISE, runs=10)
    with pytest.raises(ValueError, match="level: must be between 0 and 1, got 95"):
        straight_in().success("1", NOISE, runs=10, level=95)


def test_the_interval_is_wilsons() -> None:
    from carom.noise import _wilson

    # In closed form: z²/(n + z²) where nothing was met, 1/2 ± z/2√(n + z²) where half was.
    z = 1.959964
    assert _wilson(0, 10, z) == pytest.approx((0.0, z**2 / (10 + z**2)), rel=1e-14)
    assert _wilson(10, 10, z) == pytest.approx((10 / (10 + z**2), 1.0), rel=1e-14)
    half = z / 2 / np.sqrt(10 + z**2)
    assert _wilson(5, 10, z) == pytest.approx((0.5 - half, 0.5 + half), rel=1e-14)


def test_after_ctrl_c_only_finished_strokes_count() -> None:
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    pot = straight_in().success(lambda table: np.ones(len(table), dtype=bool), NOISE, runs=300_000, outcomes=[])
    timer.join()
    assert not pot.table.is_complete
    assert 0 < pot.runs == pot.table.has_outcome.sum() < 300_000
    assert (pot.hits, pot.probability, pot.high) == (pot.runs, 1.0, 1.0)
