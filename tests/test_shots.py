"""Shots on a cloth from Python: what a run gives of them, what came of a shot, and the next one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import carom

RADIUS = 0.028575
GRAVITY = 9.81


def on_pool(balls: list[carom.Ball], **more: Any) -> carom.Scenario:
    return carom.Scenario(carom.Table.preset("pool_9ft"), balls, **more)


@pytest.fixture(scope="module")
def rolled() -> carom.Run:
    """Play a ball with 1 m/s and no spin."""
    return on_pool([carom.Ball("cue", position=(0.6, 0.3), velocity=(0, 1))]).run(duration=0.2)


@pytest.fixture(scope="module")
def potted() -> carom.Run:
    """Play a straight pot of the 1 into the upper right corner."""
    table = carom.Scenario(carom.Table.preset("pool_9ft"), [carom.Ball("cue", position=(0.5, 0.5))]).outline()
    hole = np.array(next(pocket["center"] for pocket in table["pockets"] if pocket["id"] == "rt"))
    way = np.array([1, 1]) / np.sqrt(2)
    balls = [
        carom.Ball("cue", position=tuple(hole - 0.9 * way)),
        carom.Ball("1", position=tuple(hole - 0.5 * way)),
        carom.Ball("2", position=(0.3, 0.6)),
    ]
    return on_pool(balls, shot=carom.Shot(V0=1.2, phi_deg=45)).run()


def test_a_sliding_ball_rolls_after_two_sevenths_of_its_braking_time(rolled: carom.Run) -> None:
    # 2 v / (7 μ g), and 5/7 of the speed is left.
    event = rolled.events.by_kind("slide_to_roll")[0]
    assert event.time == pytest.approx(2 / (7 * 0.2 * GRAVITY), rel=1e-12)
    assert rolled.velocities(event.time)[0] == pytest.approx([0, 5 / 7, 0], rel=1e-12)


def test_places_are_in_space_and_spins_those_of_rolling(rolled: carom.Run) -> None:
    times = np.array([0.0, 0.1, 0.19])
    assert rolled.positions(times).shape == rolled.velocities(times).shape == rolled.spins(times).shape == (3, 1, 3)
    assert rolled.positions(times)[:, 0, 2] == pytest.approx([RADIUS] * 3)
    assert rolled.spins(0.19)[0, 0] == pytest.approx(-rolled.velocities(0.19)[0, 1] / RADIUS, rel=1e-12)
    assert rolled.motion(times)[:, 0].tolist() == ["sliding", "sliding", "rolling"]


def test_a_trajectory_on_a_cloth_has_heights_spins_and_motions(rolled: carom.Run) -> None:
    names = ["x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "motion"]
    assert rolled.trajectory([0.0]).names == ["time", *(f"cue.{name}" for name in names)]


def test_a_pot_is_told_with_its_pocket(potted: carom.Run) -> None:
    assert potted.shot is not None
    assert potted.shot.first_ball_hit == "1"
    assert potted.shot.pocketed[0] == ("1", "rt")
    assert potted.shot.cushions_before == ()
    assert not potted.shot.is_miscue
    assert potted.shot.to_dict()["first_ball_hit"] == "1"
    assert potted.events.by_kind("ball_pocket")[0].pocket == "rt"


def test_a_ball_in_a_pocket_has_no_place(potted: carom.Run) -> None:
    capture = potted.events.by_kind("ball_pocket")[0].time
    ball = potted.ball_ids.index("1")
    assert np.isfinite(potted.positions(capture - 1e-6)[ball]).all()
    assert np.isnan(potted.positions(capture)[ball]).all()
    assert potted.motion(capture)[ball] == "pocketed"


def test_the_next_shot_is_played_from_where_the_balls_lie(potted: carom.Run) -> None:
    assert potted.shot is not None
    left = [name for name in potted.ball_ids if name not in dict(potted.shot.pocketed)]
    final = potted.final_scenario()
    assert final.ball_ids == left
    assert "shot" not in final.to_dict()
    assert "2" in left
    run = potted.next(cue_ball="2", V0=0.5, phi_deg=200)
    there = potted.positions(potted.end_time)[potted.ball_ids.index("2")]
    assert run.positions(0.0)[left.index("2")].tolist() == there.tolist()
    assert run.events[0].kind == "cue_ball"


def test_a_cushion_before_the_ball_counts_as_before() -> None:
    balls = [carom.Ball("cue", position=(0.6, 1.6)), carom.Ball("1", position=(0.6, 0.6))]
    run = on_pool(balls, shot=carom.Shot(V0=1.5, phi_deg=90)).run()
    assert run.shot is not None
    assert run.shot.cushions_before == ("top",)
    assert run.shot.first_ball_hit == "1"


def test_a_miscue_ends_the_run_at_once() -> None:
    run = on_pool([carom.Ball("cue", position=(0.6, 0.6))], shot=carom.Shot(V0=2, phi_deg=90, a=0.6)).run()
    assert (run.status, run.end_time) == ("miscue", 0.0)
    assert run.shot is not None
    assert run.shot.is_miscue


def test_discs_have_no_spin_and_no_shot() -> None:
    run = carom.load("midterm").run()
    assert run.shot is None
    with pytest.raises(carom.RunError, match="cloth"):
        run.spins(0.0)
    with pytest.raises(carom.RunError, match="resume"):
        run.final_scenario()


@pytest.mark.parametrize(
    ("shot", "place"),
    [
        ({"V0": 1, "cue_speed": 1, "phi_deg": 0}, "shot"),
        ({"V0": -1, "phi_deg": 0}, "shot.V0"),
        ({"V0": 1, "phi_deg": 0, "a": 0.8, "b": 0.8}, "shot"),
        ({"V0": 1, "phi": 0}, "shot.phi"),
        ({"V0": 1, "phi_deg": 0, "cue_ball": "white"}, "shot.cue_ball"),
    ],
)
def test_a_shot_that_cannot_be_played_is_named(shot: dict[str, Any], place: str) -> None:
    with pytest.raises(carom.ScenarioError) as caught:
        on_pool([carom.Ball("cue", position=(0.6, 0.6))], shot=shot)
    assert any(found.startswith(place) for found, _ in caught.value.problems)


def test_racks_differ_by_their_seed_only() -> None:
    def places(seed: int) -> list[Any]:
        scenario = carom.Scenario(carom.Table.preset("pool_9ft"), rack=carom.Rack("nine_ball", seed=seed))
        return sorted((ball.id, *ball.position) for ball in scenario.balls if ball.position is not None)

    assert places(7) == places(7)
    assert places(7) != places(8)
