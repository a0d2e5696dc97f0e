"""The engine against the high-precision oracle, event by event, as far as chaos allows.

How far that is, is measured, not assumed: the engine also runs twins, the same start with every number of it moved by a
few parts in 2^52. Where a twin has parted from the run by d, the run may have parted from the truth by a multiple of d.
"""

import math
import random

import numpy as np
import pytest
from oracle import exact

import carom

LOST = 1e-7  # relative: once the twin has parted so far, the remaining digits say little
TWINS = 4
MARGIN = 200.0  # round-off enters at every event, the twin's nudge only once; N events add up to this at most
FLOOR = 2e-13  # relative: the round-off of a single flight, some hundreds of units in the last place

L_SHAPE = {
    "shape": "path",
    "pieces": [
        {"line": [start, end]}
        for start, end in [
            ([0, 0], [2, 0]),
            ([2, 0], [2, 1]),
            ([2, 1], [1, 1]),
            ([1, 1], [1, 2]),
            ([1, 2], [0, 2]),
            ([0, 2], [0, 0]),
        ]
    ],
}
STADIUM = {
    "shape": "path",
    "pieces": [
        {"line": [[0, 0], [1.5, 0]]},
        {"arc": {"center": [1.5, 0.75], "radius": 0.75, "from_deg": -90, "to_deg": 90}},
        {"line": [[1.5, 1.5], [0, 1.5]]},
        {"arc": {"center": [0, 0.75], "radius": 0.75, "from_deg": 90, "to_deg": 270}},
    ],
}
PILLARS = {
    "shape": "rectangle",
    "width": 2.0,
    "length": 1.5,
    "obstacles": [
        {"circle": {"center": [0.7, 0.8], "radius": 0.2}},
        {
            "path": [
                {"line": line}
                for line in ([[1.4, 0.4], [1.3, 0.8]], [[1.3, 0.8], [1.7, 0.7]], [[1.7, 0.7], [1.4, 0.4]])
            ]
        },
        {"wall": [[0.2, 1.1], [0.4, 1.5]]},
    ],
}
TABLES = {
    "rectangle": {"shape": "rectangle", "width": 1.0, "length": 2.0},
    "circle": {"shape": "circle", "radius": 1.0},
    "l_shape": L_SHAPE,
    "stadium": STADIUM,
    "pillars": PILLARS,
}
LAWS = {
    "elastic": {},
    "lossy": {
        "ball_ball": {"law": "restitution", "normal": 0.9},
        "ball_cushion": {"law": "restitution", "normal": 0.8, "tangential": 0.95},
    },
    "field": {
        "ball_cushion": {"law": "restitution", "normal": 0.97},
        "flight": {"law": "field", "acceleration": [0.3, -1.1]},
    },
}


def scenario_of(table: str, laws: str, balls: int, seed: int) -> dict:
    """A random scenario whose balls, of unequal radii and masses, are placed where the engine accepts them."""
    rng = random.Random(f"{table} {laws} {balls} {seed}")
    scenario = {"table": TABLES[table], "physics": LAWS[laws], "collisions": 12 * balls, "balls": []}
    while len(scenario["balls"]) < balls:
        radius = 0.0 if rng.random() < 0.1 else rng.uniform(0.01, 0.3 / math.sqrt(balls))
        ball = {
            "id": f"b{len(scenario['balls'])}",
            "radius": radius,
            "mass": rng.uniform(0.2, 5.0),
            "position": [rng.uniform(-1.0, 2.3), rng.uniform(-1.0, 2.3)],
            "velocity": [rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)],
        }
        candidate = {**scenario, "balls": [*scenario["balls"], ball]}
        try:
            carom.Scenario.from_dict(candidate)
        except carom.ScenarioError:
            continue
        scenario = candidate
    return scenario


def nudged(scenario: dict, twin: int) -> dict:
    """The same start, every position and velocity moved by up to four parts in 2^52."""
    rng = random.Random(twin)

    def move(vector: list) -> list:
        return [x * (1.0 + rng.randint(-4, 4) * 2.0**-52) for x in vector]

    balls = [
        {**ball, "position": move(ball["position"]), "velocity": move(ball["velocity"])} for ball in scenario["balls"]
    ]
    return {**scenario, "balls": balls}


def collisions(scenario: dict) -> list:
    """The collisions of a run of the engine."""
    run = carom.Scenario.from_dict(scenario).run()
    return [event for event in run.events if event.kind in ("ball_ball", "ball_cushion")]


def numbers(event) -> np.ndarray:
    """What is compared of an event of the engine."""
    return np.array([event.time, event.x, event.y, event.normal_x, event.normal_y, event.closing_speed, event.impulse])


def words(event) -> tuple:
    """What must be equal in an event."""
    return event.kind, event.ball_a, event.ball_b


CASES = [
    *[
        (table, laws, balls, seed)
        for table in TABLES
        for laws in ("elastic", "lossy")
        for balls, seed in ((2, 1), (5, 2))
    ],
    *[(table, "field", 3, 3) for table in ("rectangle", "l_shape", "circle", "pillars")],
    ("rectangle", "elastic", 50, 4),
    ("pillars", "lossy", 20, 5),
]


@pytest.mark.parametrize(("table", "laws", "balls", "seed"), CASES)
def test_events_agree_with_the_oracle_as_far_as_chaos_allows(table, laws, balls, seed):
    scenario = scenario_of(table, laws, balls, seed)
    ours = collisions(scenario)
    twins = [collisions(nudged(scenario, twin)) for twin in range(TWINS)]
    truth = exact.simulate(scenario, dps=50).events
    ids = [ball["id"] for ball in scenario["balls"]]
    spread = 0.0
    compared = 0
    for event, reference, *others in zip(ours, truth, *twins, strict=False):
        if any(words(event) != words(other) for other in others):
            break
        spread = max(spread, *(float(np.max(np.abs(numbers(event) - numbers(other)))) for other in others))
        if spread > LOST:
            break
        ball_b = None if reference.ball_b is None else ids[reference.ball_b]
        assert words(event) == (reference.kind, ids[reference.ball_a], ball_b), f"event {compared}, spread {spread}"
        expected = [reference.time, *reference.point, *reference.normal, reference.closing_speed, reference.impulse]
        allowed = FLOOR * max(1.0, event.time) + MARGIN * spread
        assert numbers(event) == pytest.approx([float(x) for x in expected], rel=0, abs=allowed), f"event {compared}"
        compared += 1
    assert compared >= min(len(truth), 10), f"only {compared} of {len(truth)} events could be compared"
