"""What is wrong with a trajectory, in sentences, each no stronger than what its rows show."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from carom.comparison.clock import explain_clock
from carom.comparison.contact import Contact, met_exactly
from carom.comparison.cushion import explain_cushion, explain_place
from carom.comparison.digits import fitting_tolerance
from carom.comparison.fit import CLOCK
from carom.comparison.motion import Motion, Track, acceleration_of, nearness, precision, said, settled
from carom.comparison.shift import find_shift
from carom.comparison.start import explain_start

if TYPE_CHECKING:
    from carom.comparison.fit import Fit
    from carom.comparison.motion import Vector
    from carom.events import Event

COARSE = 0.1
"""Of velocities less certain than this part of the largest nothing is said."""
FINE = 0.01
"""Velocities are the same only where they are at least so certain."""
PRECISE = 1e-6
"""Places that rounding moves by less have digits enough."""


def diagnose(fit: Fit) -> list[str]:
    """Say where a trajectory first differs from the run by more than rounding, and what it does there."""
    if fit.first is None:
        return []
    rounded = _rounded(fit)
    if rounded is None:
        return _diagnose(fit, "the first row that differs is")
    digits, moved = fit.rounding
    told, fitting = f"its numbers have {digits.speak()}", f"--tolerance {fitting_tolerance(moved):g}"
    if rounded.first is None:
        where = _where(fit, fit.first, "the first row that differs is")
        return [where, f"{told}, and rounding explains every difference; {fitting} compares it so"]
    told += f", so that rounding explains differences of up to {moved:.2g} ({fitting})"
    return [told, *_diagnose(rounded, "the first row that differs by more is")]


def _rounded(fit: Fit) -> Fit | None:
    """Give the fit with the tolerance that the digits of the trajectory need, if rounding explains any difference."""
    moved = fit.rounding[1]
    rounded = replace(fit, tolerance=max(fit.tolerance, moved))
    return rounded if fit.differs[: rounded.first].any() else None


def _diagnose(fit: Fit, lead: str) -> list[str]:
    first = fit.first
    assert first is not None
    ball = fit.rows.balls[int(np.argmax(fit.distances[first]))]
    sentences = [_where(fit, first, lead)]
    if first == 0:
        return sentences + (explain_start(fit) or _explain_times(fit))
    before = f"{fit.rows.where(first - 1)} (t = {fit.rows.times[first - 1]:.6g})"
    sentences.append(f"up to {before} it agrees to {fit.distances[:first].max():.2g}")
    return sentences + (_explain_times(fit) or _cause(fit, ball))


def _explain_times(fit: Fit) -> list[str]:
    """Say how the places are Carom's at other times, where they are."""
    told = find_shift(fit)
    if told is None and fit.first is not None and fit.first <= 1:
        told = explain_clock(fit.run, fit.rows, fit.tolerance, any_factor=False)
    return [told] if told else []


def explain_break(fit: Fit) -> list[str]:
    """Say what comes right before the row that has no place, where the rows agree until then."""
    broken = fit.rows.broken
    if broken is None or fit.first is not None or broken.time > fit.limit:
        return []
    name = fit.run.ball_ids[broken.ball]
    events = fit.run.events.by_ball(name).by_time(0.0, broken.time)
    if len(events) == 0:
        return [f"before that, Carom's run has no event of {name}"]
    event = events[len(events) - 1]
    told = [f"the last event of {name} before it is {speak_of(fit, event)}"]
    if event.kind == "ball_ball" and settled(fit, event) >= fit.rows.times[-1] - CLOCK * fit.run.end_time:
        told.append(
            "a tangent t = [1, -n1/n2] gives infinity or NaN where n2 = 0; Carom's normal there is "
            f"{said(np.array(event.normal))}"
        )
    return told


def _where(fit: Fit, first: int, lead: str) -> str:
    found, carom, apart = fit.rows.places[first], fit.expected[first], fit.distances[first]
    worst = int(np.argmax(apart))
    names = [fit.run.ball_ids[ball] for ball in fit.rows.balls]
    others = [name for name, far in zip(names, apart > fit.tolerance, strict=True) if far and name != names[worst]]
    also = f"; {', '.join(others)} differ{'s' if len(others) == 1 else ''} too" if others else ""
    here, there = _said_apart(found[worst], carom[worst])
    return (
        f"{lead} {fit.rows.where(first)}, t = {fit.rows.times[first]:.6g}: {names[worst]} is at "
        f"{here}, in Carom's run at {there}, {apart[worst]:.3g} apart{also}"
    )


def _said_apart(one: Vector, other: Vector) -> tuple[str, str]:
    """Give two places as texts, with as many digits as it takes to tell them apart."""
    texts = ((said(one, digits), said(other, digits)) for digits in range(6, 18))
    return next(((here, there) for here, there in texts if here != there), (said(one, 17), said(other, 17)))


def _cause(fit: Fit, ball: int) -> list[str]:
    """Say what the ball does in the file where it leaves its path in the run."""
    assert fit.first is not None
    name, time = fit.run.ball_ids[ball], fit.rows.times[fit.first]
    if stopped := _stopped_with(fit, ball):
        return stopped
    event = _last_event(fit, ball)
    told = [f"before that, Carom's run has no event of {name}"]
    if event is not None:
        told = [f"the last event of {name} before it is {speak_of(fit, event)}"]
        if special := _at_place(fit, ball, event):
            return told + special
        if event.time < time < settled(fit, event):
            return told
        if stuck := _standing(fit, event):
            return told + stuck
    motion = Track(fit, ball).motion_after(event)
    if motion is None:
        return told
    carom = fit.run.velocities(min(time, fit.run.end_time))[ball, :2]
    now = motion.velocity if event is None else _carried(fit, event, motion.velocity, time)
    change, speed = now - carom, float(np.linalg.norm(carom))
    if motion.noise > COARSE * fit.fastest:
        return told + _too_few_digits(fit)
    if np.linalg.norm(change) <= motion.noise + 1e-6 * speed:
        return told + (_beside(fit, ball, carom) if motion.noise <= FINE * speed else _too_few_digits(fit))
    if event is not None and _begins_at(fit, ball, event, change):
        return told + (_explain(fit, ball, event, motion) or _too_few_digits(fit))
    return told + _unforeseen(fit, ball, now, carom, change)


def _too_few_digits(fit: Fit) -> list[str]:
    """Say why no more is said, where it is for want of digits."""
    digits, moved = fit.rounding
    return [f"its numbers have {digits.speak()}, too few to tell what happens there"] if moved > PRECISE else []


def _stopped_with(fit: Fit, ball: int) -> list[str]:
    """Find a hit of other balls in the step before the first row that differs, at whose time this ball stops too."""
    assert fit.first is not None
    times, row = fit.step_times, fit.rows.times[fit.first]
    if times is None:
        return []
    step = max(int(np.searchsorted(times, row - CLOCK * fit.run.end_time)) - 1, 0)
    name, found = fit.run.ball_ids[ball], fit.rows.places[fit.first, fit.rows.balls.index(ball)]
    events = [event for event in fit.run.events.by_time(float(times[step]), float(row)) if event.time > times[step]]
    if any(name in event.balls for event in events):
        return []
    for event in events:
        there = fit.run.positions(event.time)[ball, :2]
        if np.linalg.norm(found - there) <= nearness(fit, ball):
            return [
                f"right before it is {speak_of(fit, event)}, and in the file {name} stops at that time too; in Carom's "
                "run it goes on"
            ]
    return []


def _at_place(fit: Fit, ball: int, event: Event) -> list[str]:
    """Find that the ball is, right after its last event, at a place that a known mistake takes it to."""
    assert fit.first is not None
    if event.cluster is not None or event.time == 0.0 or not _follows(fit, event):
        return []
    if event.kind == "ball_cushion":
        return explain_place(fit, event, ball)
    return met_exactly(fit, event, _balls_of(fit, event)) if event.kind == "ball_ball" else []


def _follows(fit: Fit, event: Event) -> bool:
    """Tell whether the first row that differs is the first after an event, or after the step of the event."""
    assert fit.first is not None
    return fit.first == 0 or settled(fit, event) >= fit.rows.times[fit.first - 1] - CLOCK * fit.run.end_time


def _last_event(fit: Fit, ball: int) -> Event | None:
    """Give the last event of a ball up to the first row that differs."""
    assert fit.first is not None
    time = fit.rows.times[fit.first] + CLOCK * fit.run.end_time
    events = fit.run.events.by_ball(fit.run.ball_ids[ball]).by_time(0.0, time)
    return events[len(events) - 1] if len(events) else None


def speak_of(fit: Fit, event: Event) -> str:
    """Name an event, with its time and, in a stepped run, its step."""
    if event.cushion is not None:
        what = f"the contact of {event.ball_a} with the {event.cushion} cushion"
    else:
        what = f"the collision of {' and '.join(event.balls)}"
    times = fit.step_times
    step = "" if times is None else f", in step {max(int(np.searchsorted(times, event.time)) - 1, 0)}"
    together = "" if event.cluster is None else ", one of several contacts at once"
    return f"{what} at t = {event.time:.6g}{step}{together}"


def _carried(fit: Fit, event: Event, velocity: Vector, time: float) -> Vector:
    """Give the velocity that one after an event has become at a time."""
    return velocity + acceleration_of(fit) * (time - settled(fit, event))


def _beside(fit: Fit, ball: int, velocity: Vector) -> list[str]:
    """Speak of a ball that moves as in the run, at another place."""
    offset = fit.offsets[fit.first, fit.rows.balls.index(ball)]
    name, square = fit.run.ball_ids[ball], float(velocity @ velocity)
    delay = -float(offset @ velocity) / square if square > 0.0 else 0.0
    aside = float(np.linalg.norm(offset + delay * velocity))
    if aside <= 1e-3 * np.linalg.norm(offset) + 4.0 * precision(fit):
        words = "behind" if delay > 0.0 else "ahead"
        return [f"there {name} moves with the same velocity as in Carom's run, {abs(delay):.4g} {words} in time"]
    return [f"there {name} moves with the same velocity as in Carom's run, but {said(offset)} beside its place"]


def _begins_at(fit: Fit, ball: int, event: Event, change: Vector) -> bool:
    """Tell whether the difference began at an event: followed back, it was nothing then."""
    assert fit.first is not None
    time, before = fit.rows.times[fit.first], fit.rows.times[fit.first - 1]
    start = settled(fit, event)
    if start >= before - CLOCK * fit.run.end_time:
        return True
    offset = fit.offsets[fit.first, fit.rows.balls.index(ball)]
    since = float(offset @ change) / float(change @ change)
    astray = np.linalg.norm(offset - since * change) > 1e-3 * np.linalg.norm(offset) + 4.0 * precision(fit)
    return not astray and abs(time - since - start) <= time - before


def _standing(fit: Fit, event: Event) -> list[str]:
    """Speak of two balls that do not come apart where the run's do, right before the first row that differs."""
    assert fit.first is not None
    if event.kind != "ball_ball" or not _follows(fit, event):
        return []
    return Contact(fit, event, _balls_of(fit, event), (None, None)).standing()


def _balls_of(fit: Fit, event: Event) -> tuple[int, int]:
    one, two = (fit.run.ball_ids.index(name) for name in event.balls)
    return one, two


def _explain(fit: Fit, ball: int, event: Event, motion: Motion) -> list[str]:
    if event.cluster is not None or event.time == 0.0:
        return []
    if event.kind == "ball_cushion":
        return explain_cushion(fit, event, ball, motion)
    if event.kind != "ball_ball":
        return []
    balls = _balls_of(fit, event)
    one, two = (motion if each == ball else _motion_of_other(fit, each, event) for each in balls)
    return Contact(fit, event, balls, (one, two)).explain()


def _motion_of_other(fit: Fit, ball: int, event: Event) -> Motion | None:
    """Give the other ball's velocity after a collision, if it is in the file and met nothing since."""
    if ball not in fit.rows.balls:
        return None
    last = _last_event(fit, ball)
    return Track(fit, ball).motion_after(event) if last is not None and last.index == event.index else None


def _unforeseen(fit: Fit, ball: int, found: Vector, carom: Vector, change: Vector) -> list[str]:
    """Speak of a ball that moves otherwise than in the run, without an event there."""
    assert fit.first is not None
    name, time, before = fit.run.ball_ids[ball], fit.rows.times[fit.first], fit.rows.times[fit.first - 1]
    offset = fit.offsets[fit.first, fit.rows.balls.index(ball)]
    since = float(offset @ change) / float(change @ change)
    if _last_event(fit, ball) is None and abs(time - since) <= time - before:
        return [
            f"from the start {name} moves with the velocity {said(found)} in the file, {said(carom)} in Carom's run"
        ]
    rows = f"between {fit.rows.where(fit.first - 1)} and {fit.rows.where(fit.first)}"
    events = fit.run.events.by_ball(name)
    following = events[np.asarray(events["time"] > time + CLOCK * fit.run.end_time)].first()
    then = f"; its next event there is {speak_of(fit, following)}" if following is not None else ""
    return [
        f"{rows} Carom's run has no event of {name}, but in the file its velocity becomes {said(found)}; "
        f"Carom: {said(carom)}{then}"
    ]
