"""The shots that Carom and pooltool both play, as plain data.

A shot is a dictionary:

- ``name``: what to call it;
- ``laws``: a key of `LAWS`;
- ``balls``: id to (x, y); or ``rack``: the seed of a nine-ball rack, which pooltool lays;
- ``cue``: V0, phi, theta (degrees), a and b, pooltool's own names and signs.

All are played on pooltool's seven-foot table with its pool balls. This module needs neither of the two programs, so
that both import it.
"""

import math
import random

WIDTH, LENGTH, RADIUS = 0.9906, 1.9812, 0.028575
ALCIATORE = {"a": 0.009951, "b": 0.108, "c": 1.088, "model": "alciatore"}

BALL_BALL = {
    "frictional": {"friction": ALCIATORE, "model": "frictional_inelastic"},
    "average": {"friction": {"model": "average"}, "model": "frictional_inelastic"},
    "mathavan": {"friction": ALCIATORE, "num_iterations": 200_000, "model": "frictional_mathavan"},
    "elastic": {"model": "frictionless_elastic"},
}
"""pooltool's ball-ball laws, as its resolver files write them; Mathavan's in 200 times as many steps as by default."""

CUSHION = {
    "stronge": {"omega_ratio": 1.8, "model": "stronge_compliant"},
    "mathavan": {"max_steps": 100_000_000, "delta_p": 1e-6, "model": "mathavan_2010"},
    "han": {"model": "han_2005"},
    "impulse": {"model": "impulse_frictional_inelastic"},
    "unrealistic": {"restitution": True, "model": "unrealistic"},
}
"""pooltool's cushion laws; Mathavan's in steps a thousandth of the default ones."""

LAWS = {f"{first}-{second}": (first, second) for first in BALL_BALL for second in CUSHION}
"""Every pair of a ball-ball law and a cushion law."""

DEFAULT_LAWS = "frictional-stronge"

EXAMPLE = {
    "name": "two-ball example",
    "laws": DEFAULT_LAWS,
    "balls": {"cue": [0.4953, 0.9906], "1": [0.4953, 1.4859]},
    "cue": {"V0": 1.5, "phi": 94.0, "theta": 0.0, "a": -0.3, "b": -0.3},
}
"""What pooltool calls `System.example()`."""


def resolver_of(laws):
    """Give the resolver of a pair of laws in the form in which pooltool writes it to a file."""
    first, second = LAWS[laws]
    return {
        "ball_ball": BALL_BALL[first],
        "ball_linear_cushion": CUSHION[second],
        "ball_circular_cushion": CUSHION[second],
        "ball_pocket": {"model": "canonical"},
        "stick_ball": {"english_throttle": 1.0, "squirt_throttle": 1.0, "model": "instantaneous_point"},
        "transition": {"model": "canonical"},
        "version": 9,
    }


def two_ball_shots(each, seed=1):
    """Give `each` random shots of two balls for every pair of laws."""
    rng = random.Random(seed)
    return [two_balls(rng, laws, f"{laws}-{k}") for laws in LAWS for k in range(each)]


def two_balls(rng, laws, name):
    """A random shot: three in four aimed at the ball, with any cut; the others anywhere, by the cushions."""
    cue, ball = place(rng), place(rng)
    while math.dist(cue, ball) < 5 * RADIUS:
        ball = place(rng)
    return {"name": name, "laws": laws, "balls": {"cue": cue, "1": ball}, "cue": strike(rng, aim(rng, cue, ball))}


def place(rng):
    return [round(rng.uniform(0.08, side - 0.08), 6) for side in (WIDTH, LENGTH)]


def aim(rng, cue, ball):
    if rng.random() < 0.25:
        return rng.uniform(0, 360)
    distance = math.dist(cue, ball)
    towards = math.atan2(ball[1] - cue[1], ball[0] - cue[0])
    return math.degrees(towards + math.asin(2 * RADIUS / distance) * rng.uniform(-0.95, 0.95))


def strike(rng, phi):
    """A strike of any speed and spin within the limit of a miscue; one in four with the butt up."""
    offset, side = 0.45 * math.sqrt(rng.random()), rng.uniform(0, 2 * math.pi)
    theta = rng.choice([0, 0, 0, rng.uniform(1, 30)])
    numbers = {"V0": rng.uniform(0.3, 3), "phi": phi % 360, "theta": theta}
    numbers |= {"a": offset * math.cos(side), "b": offset * math.sin(side)}
    return {name: round(value, 6) for name, value in numbers.items()}


def breaks(count, seed=2):
    """Give nine-ball breaks from pooltool's own racks, each with its rack, speed, direction and offset."""
    rng = random.Random(seed)
    return [
        {
            "name": f"break-{k}",
            "laws": DEFAULT_LAWS,
            "rack": k,
            "cue": {
                "V0": round(rng.uniform(6, 9), 6),
                "phi": round(108.6 + rng.uniform(-1.5, 1.5), 6),
                "theta": 0.0,
                "a": round(rng.uniform(-0.1, 0.1), 6),
                "b": round(rng.uniform(0, 0.2), 6),
            },
        }
        for k in range(count)
    ]
