"""How far two programs agree on a shot.

A played shot is a dictionary: ``events``, rows of time, kind and ids in pooltool's words; ``end``, where each ball lies
at last, None in a pocket; ``faults``, as `run_pooltool` finds them.
"""

import math
from dataclasses import dataclass

import shots

TIME = 1e-6
"""Event times up to the first ball-ball contact are to agree to this, in s."""

PLACE = {1: 1e-4, 2: 2e-3}
"""Ends are to agree to this, in m, by the number of ball-ball contacts."""

OWN = 0.9
"""The part of a tolerance that pooltool may use up itself when nine tenths of its spacer are taken away."""

SLIP = "slip sign"
"""The fault that shows after a contact only."""

TILTED = {"stronge", "impulse"}
"""Cushion laws to which pooltool gives a wrong direction of the blow at a jaw."""

CUSHIONS = ("ball_linear_cushion", "ball_circular_cushion")
COMPARED = ("stick_ball", "sliding_rolling", "ball_ball", *CUSHIONS, "ball_pocket")


@dataclass
class Agreement:
    """The differences of a shot, or why it is no measure.

    Attributes
    ----------
    laws : str
        The key of its pair of laws.
    contacts : int
        How many ball-ball contacts pooltool saw.
    time, place : float or None
        The largest difference of event times up to the first ball-ball contact, and of the ends; None where not
        compared, infinite where the events are others.
    time_left_out, place_left_out : str
        Why not; empty where compared, or where there is nothing to compare.
    """

    laws: str
    contacts: int
    time: float | None = None
    place: float | None = None
    time_left_out: str = ""
    place_left_out: str = ""


def agreement(shot, theirs, finer, ours):
    """Compare ours with pooltool's, and leave out what pooltool with a tenth of its spacer (`finer`) sees otherwise."""
    contacts = sum(event[1] == "ball_ball" for event in theirs["events"])
    faults = theirs["faults"] + finer["faults"]
    found = Agreement(shot["laws"], contacts)
    if contacts:
        found.time_left_out = why_no_times(shot, theirs, finer, [fault for fault in faults if fault != SLIP])
        found.time = None if found.time_left_out else time_difference(theirs, ours)
    if contacts in PLACE:
        found.place_left_out = why_no_places(shot, theirs, finer, faults)
        found.place = None if found.place_left_out else place_difference(theirs, ours)
    return found


def why_no_times(shot, theirs, finer, faults):
    if faults:
        return faults[0]
    if tilted(shot, opening(theirs)):
        return "tilt at a jaw"
    return "spacer" if time_difference(theirs, finer) > OWN * TIME else ""


def why_no_places(shot, theirs, finer, faults):
    if faults:
        return faults[0]
    if tilted(shot, theirs["events"]):
        return "tilt at a jaw"
    contacts = sum(event[1] == "ball_ball" for event in theirs["events"])
    return "spacer" if place_difference(theirs, finer) > OWN * PLACE[contacts] else ""


def tilted(shot, events):
    return shots.LAWS[shot["laws"]][1] in TILTED and any(event[1] == "ball_circular_cushion" for event in events)


def opening(played):
    """The events up to and including the first ball-ball contact."""
    compared = [event for event in played["events"] if event[1] in COMPARED]
    end = next((k + 1 for k, event in enumerate(compared) if event[1] == "ball_ball"), len(compared))
    return compared[:end]


def time_difference(one, other):
    rows = list(zip(opening(one), opening(other), strict=False))
    if len(opening(one)) != len(opening(other)) or any(identity(a) != identity(b) for a, b in rows):
        return math.inf
    return max(abs(a[0] - b[0]) for a, b in rows)


def identity(event):
    """What an event is apart from its time: kind and balls; cushions have other names elsewhere."""
    kind = "cushion" if event[1] in CUSHIONS else event[1]
    balls = event[2:] if kind == "ball_ball" else event[3:] if kind == "stick_ball" else event[2:3]
    return kind, sorted(balls)


def place_difference(one, other):
    """The largest distance between two ends of a ball; infinite when it was pocketed once only."""
    pairs = [(place, other["end"][name]) for name, place in one["end"].items()]
    if any((a is None) != (b is None) for a, b in pairs):
        return math.inf
    return max(math.dist(a, b) if a else 0.0 for a, b in pairs)
