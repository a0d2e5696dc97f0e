"""What a trajectory does at a cushion, beside what the run does there."""

from __future__ import annotations

from collections.abc import Callable
from math import floor, log10
from typing import TYPE_CHECKING

import numpy as np

from carom.comparison.motion import just_after, just_before, nearness, precision

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.comparison.fit import Fit
    from carom.comparison.motion import Motion, Vector
    from carom.events import Event

PART = 1e-6
"""Speeds are equal that differ by no more than this part of the ball's speed, and what rows leave open."""


CLEAR = 20.0
"""A component is clear of what rows leave open that is so many times larger."""
SIDES = ("left", "right", "bottom", "top")
LEAST_STAY = 3
"""A ball stays at a cushion that is there in so many rows."""


def explain_place(fit: Fit, event: Event, ball: int) -> list[str]:
    """Say how the ball leaves the box of the centres in the trajectory, or does not leave its side."""
    side = _side(fit, event, ball)
    if side is None:
        return []
    axis, sign, wall = side
    assert fit.first is not None
    room = fit.tolerance + precision(fit)
    beyond = sign * (fit.rows.places[: fit.count, fit.rows.balls.index(ball), axis] - wall)
    if beyond[fit.first] > room:
        return _past(fit, event, ball, (axis, sign, wall), beyond)
    return _staying(fit, event, ball, (axis, sign, wall), np.abs(beyond) <= room)


def _side(fit: Fit, event: Event, ball: int) -> tuple[int, float, float] | None:
    """Give the side of a rectangle's box: the axis across it, the sign outwards, where the centre turns."""
    shape = fit.run.scenario.to_dict().get("table", {}).get("shape")
    if shape != "rectangle" or event.cushion not in SIDES:
        return None
    axis = int(np.argmax(np.abs(event.normal)))
    sign = 1.0 if just_before(fit, event, ball)[axis] > 0.0 else -1.0
    return axis, sign, float(fit.run.positions(event.time)[ball, axis])


def _past(fit: Fit, event: Event, ball: int, side: tuple[int, float, float], beyond: NDArray[np.float64]) -> list[str]:
    """Speak of a ball whose centre goes past the place where it should turn, and turns later."""
    axis, _, wall = side
    first = fit.first
    assert first is not None
    back = np.flatnonzero(np.diff(beyond[first:]) < -fit.tolerance)
    if len(back) == 0:
        return []
    farthest = first + int(back[0])
    name, letter = fit.run.ball_ids[ball], "xy"[axis]
    place = fit.rows.places[farthest, fit.rows.balls.index(ball), axis]
    told = (
        f"in the file {name}'s centre goes past {letter} = {wall:.6g}, where it touches the {event.cushion} cushion, "
        f"to {letter} = {place:.6g} in {fit.rows.where(farthest)}, and comes back"
    )
    if farthest == first and _went_on(fit, event, ball):
        return [f"{told}: it goes straight on until then, as when the velocity is reversed only after the step"]
    radius = float(fit.run.scenario.balls[ball].radius or 0.0)
    if abs(beyond[farthest] - radius) <= fit.tolerance + precision(fit):
        return [f"{told}: it turns at the wall itself, as if the ball had no radius"]
    return [told]


def _went_on(fit: Fit, event: Event, ball: int) -> bool:
    """Tell whether the ball is, in the first row that differs, where it would be without the cushion."""
    time = float(fit.rows.times[fit.first]) - event.time
    place = fit.run.positions(event.time)[ball, :2] + time * just_before(fit, event, ball)
    apart = np.linalg.norm(fit.rows.places[fit.first, fit.rows.balls.index(ball)] - place)
    return bool(apart <= nearness(fit, ball))


def _staying(fit: Fit, event: Event, ball: int, side: tuple[int, float, float], there: NDArray[np.bool_]) -> list[str]:
    """Speak of a ball that stays at the cushion, in the first row that differs and in those around it."""
    axis, _, wall = side
    first = fit.first
    assert first is not None
    away = np.flatnonzero(~there)
    begin = int(away[away < first].max(initial=-1)) + 1
    end = int(away[away > first].min(initial=len(there))) - 1
    if not there[first] or end - begin + 1 < LEAST_STAY:
        return []
    name, until = fit.run.ball_ids[ball], "on" if end == len(there) - 1 else f"to {fit.rows.where(end)}"
    return [
        f"in the file {name} stays at the {event.cushion} cushion, {'xy'[axis]} = {wall:.6g}, from "
        f"{fit.rows.where(begin)} {until}, as when its velocity is not turned back"
    ]


def explain_cushion(fit: Fit, event: Event, ball: int, motion: Motion) -> list[str]:
    """Say what the ball does at the cushion in the trajectory."""
    before, carom, after = just_before(fit, event, ball), just_after(fit, event, ball), motion.velocity
    room = motion.noise + PART * float(np.linalg.norm(before))
    name = fit.run.ball_ids[ball]
    if np.linalg.norm(after - before) <= room:
        return [f"in the file {name} goes straight on: this contact with the cushion is missing"]
    normal = np.array(event.normal)
    along = np.array([-normal[1], normal[0]])
    if abs(before @ normal) <= CLEAR * room:
        return []
    found = _factor(after, before, normal, -1.0), _factor(after, before, along, 1.0)
    wanted = _factor(carom, before, normal, -1.0), _factor(carom, before, along, 1.0)
    seen = abs(before @ along) > CLEAR * room
    room_of = room / abs(before @ normal), room / abs(before @ along) if seen else np.inf
    normal_factor = _said_factor(-found[0], room_of[0])
    factors = f"the normal component of {name}'s velocity by {normal_factor} (Carom: {-wanted[0]:.6g})"
    if seen:
        factors += f", the tangential one by {_said_factor(found[1], room_of[1])} (Carom: {wanted[1]:.6g})"
    conclusion = _conclude(found, wanted, room_of) if seen else ""
    return [f"in the file this cushion multiplies {factors}{conclusion and ': ' + conclusion}"]


def _said_factor(factor: float, room: float) -> str:
    """Give a factor as text, with the decimals that are certain."""
    decimals = min(max(floor(-log10(room)), 0), 15)
    return f"{round(factor, decimals) + 0.0:.6g}"


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
