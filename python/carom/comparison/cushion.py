"""What a trajectory does at a cushion, beside what the run does there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from carom.comparison.motion import just_after, just_before

if TYPE_CHECKING:
    from carom.comparison.fit import Fit
    from carom.comparison.motion import Motion, Vector
    from carom.events import Event

PART = 1e-6
"""Speeds are equal that differ by no more than this part of the ball's speed, and what rows leave open."""


def explain_cushion(fit: Fit, event: Event, ball: int, motion: Motion) -> list[str]:
    """Say what the ball does at the cushion in the trajectory."""
    before, carom, after = just_before(fit, event, ball), just_after(fit, event, ball), motion.velocity
    room = motion.noise + PART * float(np.linalg.norm(before))
    name = fit.run.ball_ids[ball]
    if np.linalg.norm(after - before) <= room:
        return [f"in the file {name} goes straight on: this contact with the cushion is missing"]
    normal = np.array(event.normal)
    along = np.array([-normal[1], normal[0]])
    if abs(before @ normal) <= 1e3 * room:
        return []
    found = _factor(after, before, normal, -1.0), _factor(after, before, along, 1.0)
    wanted = _factor(carom, before, normal, -1.0), _factor(carom, before, along, 1.0)
    seen = abs(before @ along) > 1e3 * room
    room_of = room / abs(before @ normal), room / abs(before @ along) if seen else np.inf
    factors = f"the normal component of {name}'s velocity by {-found[0]:.6g} (Carom: {-wanted[0]:.6g})"
    factors += f", the tangential one by {found[1]:.6g} (Carom: {wanted[1]:.6g})" if seen else ""
    conclusion = _conclude(found, wanted, room_of) if seen else ""
    return [f"in the file this cushion multiplies {factors}{conclusion and ': ' + conclusion}"]


def _factor(after: Vector, before: Vector, direction: Vector, sign: float) -> float:
    speed = float(before @ direction)
    return sign * float(after @ direction) / speed if speed else 0.0


def _conclude(found: tuple[float, float], wanted: tuple[float, float], room: tuple[float, float]) -> str:
    """Put the two factors into words, where they are those of a known mistake."""

    def are(normal: float, tangential: float) -> bool:
        return abs(found[0] - normal) <= 2 * room[0] and abs(found[1] - tangential) <= 2 * room[1]

    normal, tangential = wanted
    known: list[tuple[str, Callable[[], bool]]] = [
        ("only the normal component is damped", lambda: are(normal, 1.0)),
        ("only the tangential component is damped", lambda: are(1.0, tangential)),
        ("nothing is damped", lambda: are(1.0, 1.0)),
        ("the tangential component is reversed too", lambda: are(normal, -tangential)),
        ("the tangential component is reversed in place of the normal one", lambda: are(-normal, -tangential)),
        ("the two factors are exchanged", lambda: are(tangential, normal)),
        ("it is damped twice", lambda: are(normal**2, tangential**2)),
        ("it is the energy that is damped so, not the velocity", lambda: are(normal**0.5, tangential**0.5)),
        ("the normal component is not reversed", lambda: abs(found[0] + normal) <= 2 * room[0]),
    ]
    return next((words for words, holds in known if holds()), "")
