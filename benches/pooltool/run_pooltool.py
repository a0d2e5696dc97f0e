"""Plays shots with pooltool, for `pooltool_process`: one JSON request a line in, one JSON answer a line out.

    {"do": "play", "shot": {...}, "spacer": 1e-6}    the shot's events, where its balls end, and what is wrong with it
    {"do": "time", "shot": {...}, "plays": n}        seconds of each of n times `simulate`
    {"do": "strokes", "shot": {...}, "strokes": [...], "clock": "process_time"}   see `play_strokes`
    {"do": "cold", "shot": {...}}                    seconds of the import, and of this process's first `simulate`
    {"do": "system", "shot": {...}, "path": "..."}   writes the shot as pooltool's `System.save` does, not yet played

Run by the Python of pooltool's own virtual environment.
"""

import itertools
import json
import random
import sys
import time

STARTED = time.perf_counter()
import numpy as np  # noqa: E402
import pooltool as pt  # noqa: E402
from pooltool.physics.resolve import Resolver  # noqa: E402
from pooltool.serialize import SerializeFormat, conversion  # noqa: E402

IMPORT_SECONDS = time.perf_counter() - STARTED

import shots  # noqa: E402

APART = 1.01
"""Balls whose centres are further apart than this many diameters do not touch."""

INSIDE = 2e-6
"""Balls deeper in each other than this, in m, have been missed by the search."""

ERRORS = (ArithmeticError, AssertionError, RuntimeError, ValueError)
"""What `simulate` raises at shots that it cannot play."""


def engine_of(laws):
    values = shots.resolver_of(laws)
    return pt.physics.PhysicsEngine(resolver=conversion[SerializeFormat.JSON].structure(values, Resolver))


def system_of(shot):
    table = pt.Table.default()
    balls = rack(table, shot["rack"]) if "rack" in shot else {}
    balls |= {name: pt.Ball.create(name, xy=place) for name, place in shot.get("balls", {}).items()}
    system = pt.System(table=table, balls=balls, cue=pt.Cue.default())
    system.strike(**shot["cue"])
    return system


def rack(table, seed):
    random.seed(seed)
    np.random.seed(seed)  # noqa: NPY002, as pooltool draws from NumPy's old global generator
    return pt.get_rack(pt.GameType.NINEBALL, table=table)


def play(shot, spacer=1e-6):
    """Play a shot, with balls moved `spacer` apart at each contact (pooltool's own: 1e-6 m)."""
    pt.constants.MIN_DIST = spacer
    system = system_of(shot)
    places = {name: ball.xyz[:2].tolist() for name, ball in system.balls.items()}
    try:
        pt.simulate(system, engine=engine_of(shot["laws"]), inplace=True)
    except ERRORS as error:
        return {"balls": places, "events": [], "end": {}, "faults": [f"raises {type(error).__name__}"]}
    return {
        "balls": places,
        "events": [[float(event.time), event.event_type.value, *event.ids] for event in system.events[1:-1]],
        "end": {name: end_of(ball) for name, ball in system.balls.items()},
        "faults": faults(system, mathavan=shots.LAWS[shot["laws"]][0] == "mathavan"),
    }


def end_of(ball):
    """Where a ball lies at the end, or None in a pocket."""
    return None if ball.state.s == pt.constants.pocketed else ball.xyz[:2].tolist()


def faults(system, mathavan):
    """What pooltool got wrong: contacts of balls apart or parting, a slip of the wrong sign, balls in each other."""
    found = []
    for event in system.events:
        if event.event_type == pt.EventType.BALL_BALL:
            one, other = (agent.initial for agent in event.agents)
            found += phantom(one, other)
            if mathavan and presses_moving_ball(one, other):
                found.append("slip sign")
    deepest = max(overlap(states) for states in zip(*(ball.history for ball in system.balls.values()), strict=True))
    return found + (["overlap"] if deepest > INSIDE else [])


def phantom(one, other):
    gap, speed = other.xyz - one.xyz, other.vel - one.vel
    if np.linalg.norm(gap) > APART * (one.params.R + other.params.R):
        return ["apart"]
    return ["opening"] if gap @ speed >= 0 else []


def presses_moving_ball(one, other):
    """Tell whether the friction between two balls presses one on the cloth that moves.

    In pooltool's law of Mathavan the slip of such a ball on its cloth has the wrong sign.
    """
    normal = other.xyz - one.xyz
    aside = np.array([normal[1], -normal[0], 0])
    pressed = one if (one.avel + other.avel) @ aside > 0 else other
    return bool(pressed.vel.any() or pressed.avel.any())


def overlap(states):
    """How deep the deepest two balls on the table lie in each other."""
    places = [state.rvw[0] for state in states if state.s != pt.constants.pocketed]
    return max((2 * shots.RADIUS - np.linalg.norm(a - b) for a, b in itertools.combinations(places, 2)), default=-1)


def seconds(shot):
    system, engine = system_of(shot), engine_of(shot["laws"])
    start = time.perf_counter()
    pt.simulate(system, engine=engine, inplace=True)
    return time.perf_counter() - start


def play_strokes(shot, strokes, clock):
    """Play other strokes of a shot: the seconds of each, and its `end_of_break`, None where there is an error."""
    base, engine = system_of(shot), engine_of(shot["laws"])
    return [play_stroke(base.copy(), stroke, engine, getattr(time, clock)) for stroke in strokes]


def play_stroke(system, stroke, engine, now):
    system.strike(**stroke)
    start = now()
    try:
        pt.simulate(system, engine=engine, inplace=True)
        return now() - start, end_of_break(system)
    except ERRORS:
        return now() - start, None


def end_of_break(system):
    """How many balls are in pockets, and when the last one came to rest."""
    return sum(end_of(ball) is None for ball in system.balls.values()), system.t


def answer(request):
    shot = request["shot"]
    if request["do"] == "play":
        return play(shot, request.get("spacer", 1e-6))
    if request["do"] == "time":
        return [seconds(shot) for _ in range(request["plays"])]
    if request["do"] == "strokes":
        return play_strokes(shot, request["strokes"], request["clock"])
    if request["do"] == "cold":
        return {"import": IMPORT_SECONDS, "first": seconds(shot)}
    system_of(shot).save(request["path"])
    return request["path"]


def main():
    answers, sys.stdout = sys.stdout, sys.stderr
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line))), file=answers, flush=True)


if __name__ == "__main__":
    main()
