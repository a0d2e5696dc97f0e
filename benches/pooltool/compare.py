"""Plays the same shots with Carom and with pooltool 0.6.0, the same laws and parameters, in one run.

    make bench-pooltool

First how far they agree, for every pair of laws, then how fast they are, also at breaks by the thousand. The exit
status is 1 where they do not agree as they should.
"""

import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from itertools import chain
from pathlib import Path

import breaks
import pooltool_process
import shots
from agreement import PLACE, TIME, agreement

import carom
from carom.pooltool import read_system

EACH = 12
"""Shots for each pair of laws."""

TURNS, PLAYS = 9, 10
"""Carom and pooltool take turns, and each plays the shot so many times in a turn: neither finds the other's memory."""

WORDS = {
    "cue_ball": "stick_ball",
    "ball_ball": "ball_ball",
    "ball_cushion": "ball_linear_cushion",
    "ball_pocket": "ball_pocket",
    "slide_to_roll": "sliding_rolling",
}
"""Carom's kinds of events in pooltool's words, of those that are compared."""


def main():
    with pooltool_process.started() as pooltool, tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "shot.json"
        pooltool.ask("cold", shots.EXAMPLE)
        found = [compared(pooltool, shot, path) for shot in shots.two_ball_shots(EACH)]
        agreed = print_agreement(found)
        print_speeds(pooltool, path)
        shot = shots.breaks(1)[0]
        agreed &= breaks.print_breaks(scenario_of(pooltool, shot, path), shot)
    print_first_shots(path)
    sys.exit(not agreed)


def compared(pooltool, shot, path):
    theirs, finer = pooltool.ask("play", shot), pooltool.ask("play", shot, spacer=1e-7)
    return agreement(shot, theirs, finer, played(scenario_of(pooltool, shot, path)))


def scenario_of(pooltool, shot, path):
    """The shot as Carom reads it from the file that pooltool saves."""
    pooltool.ask("system", shot, path=str(path))
    return read_system(path, resolver=shots.resolver_of(shot["laws"]))


def played(scenario):
    """Carom's run in the words of `agreement`."""
    run = scenario.run()
    events = [
        [event.time, WORDS[event.kind], *(["cue_stick"] if event.kind == "cue_ball" else []), *event.balls]
        for event in run.events
        if event.kind in WORDS
    ]
    places = run.positions(run.end_time)[:, :2]
    end = {name: None if math.isnan(place[0]) else place for name, place in zip(run.ball_ids, places, strict=True)}
    return {"events": events, "end": end, "faults": []}


def print_agreement(found):
    """Print what agrees how well; tell whether all of it does as it should."""
    print(f"{len(found)} shots of two balls; n: how many were compared; then the largest difference")
    print(f"{'laws':24} {'times to the first contact':>28} {'ends, 1 contact':>24} {'ends, 2 contacts':>24}")
    for laws in shots.LAWS:
        mine = [shot for shot in found if shot.laws == laws]
        places = [largest([shot.place for shot in mine if shot.contacts == n], "m") for n in PLACE]
        print(f"{laws:24} {largest([shot.time for shot in mine], 's'):>28} {places[0]:>24} {places[1]:>24}")
    bounds = [f"{TIME:.0e} s", *(f"{tolerance:.0e} m" for tolerance in PLACE.values())]
    print(f"{'to be within':24} {bounds[0]:>28} {bounds[1]:>24} {bounds[2]:>24}")
    print_left_out("times", [shot.time_left_out for shot in found])
    print_left_out("ends", [shot.place_left_out for shot in found])
    return all(
        (shot.time is None or shot.time <= TIME) and (shot.place is None or shot.place <= PLACE[shot.contacts])
        for shot in found
    )


def largest(differences, unit):
    values = [value for value in differences if value is not None]
    return f"n = {len(values):2}, {max(values):.1e} {unit}" if values else "n =  0"


REASONS = {
    "apart": "pooltool collided balls that were apart",
    "opening": "pooltool collided balls that were parting",
    "overlap": "pooltool let balls into each other",
    "slip sign": "pooltool's slip of a ball that is pressed on the cloth has the wrong sign",
    "tilt at a jaw": "pooltool's blow at a jaw has the wrong tilt",
    "spacer": "with a tenth of its spacer of 1e-6 m pooltool itself differs by more than is asked for",
}


def print_left_out(what, reasons):
    counts = Counter(reason for reason in reasons if reason)
    print(f"left out of the {what}: {sum(counts.values())}")
    for reason, count in counts.most_common():
        print(f"  {count:3}  {REASONS.get(reason, 'pooltool ' + reason)}")


def print_speeds(pooltool, path):
    print(f"\n{f'medians of {TURNS} x {PLAYS}, in turn':24} {'carom':>12} {'pooltool':>12} {'ratio':>8}")
    for shot in (shots.EXAMPLE, *shots.breaks(3)):
        scenario = scenario_of(pooltool, shot, path)
        turns = [(timed(scenario), pooltool.ask("time", shot, plays=PLAYS)) for _ in range(TURNS)]
        ours, theirs = (statistics.median(chain.from_iterable(column)) for column in zip(*turns, strict=True))
        print(f"{shot['name']:24} {ours * 1e3:9.3f} ms {theirs * 1e3:9.1f} ms {theirs / ours:8.0f}")


def timed(scenario):
    return [seconds(scenario) for _ in range(PLAYS)]


def seconds(scenario):
    start = time.perf_counter()
    scenario.run()
    return time.perf_counter() - start


FIRST_SHOT = """
import json, sys, time
start = time.perf_counter()
import carom
imported = time.perf_counter()
carom.Scenario.from_json(sys.stdin.read()).run()
print(json.dumps({"import": imported - start, "first": time.perf_counter() - imported}))
"""


def print_first_shots(path):
    """Print how long the two-ball example takes in a new process, first with nothing of the package compiled."""
    with tempfile.TemporaryDirectory() as home, pooltool_process.started() as pooltool:
        scenario = scenario_of(pooltool, shots.EXAMPLE, Path(home) / path.name)
        installed = Path(carom.__file__).parent
        shutil.copytree(installed, Path(home) / installed.name, ignore=shutil.ignore_patterns("__pycache__"))
        warm = pooltool_process.warm(shots.EXAMPLE)
        rows = [
            ("carom, just installed", first_shot(scenario, {"PYTHONPATH": home})),
            ("carom, later", first_shot(scenario, {})),
            ("pooltool, just installed", pooltool_process.cold(shots.EXAMPLE)),
            ("pooltool, later", warm),
        ]
    print(f"\n{'in a new process':24} {'import':>12} {'first shot':>12}")
    for name, seconds in rows:
        print(f"{name:24} {seconds['import'] * 1e3:9.1f} ms {seconds['first'] * 1e3:9.1f} ms")


def first_shot(scenario, environment):
    command = [sys.executable, "-c", FIRST_SHOT]
    answer = subprocess.run(
        command, input=scenario.to_json(), env={**os.environ, **environment}, capture_output=True, text=True, check=True
    )
    return json.loads(answer.stdout)


if __name__ == "__main__":
    main()
