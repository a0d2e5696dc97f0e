"""What a trajectory does at the collision of two balls, beside what the run does there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from carom.comparison.motion import MUCH_NEARER, just_after, just_before, precision, said

if TYPE_CHECKING:
    from carom.comparison.fit import Fit
    from carom.comparison.motion import Motion, Vector
    from carom.events import Event

PART = 1e-6
CLEAR = 20.0
"""A component is clear of what rows leave open that is so many times larger."""
HARDLY = 0.1
"""A ball hardly moves that goes less than this part of its way in the run."""
SMALLEST_PART_OF_NORMAL = 1e-3
"""Nearer to the x axis a normal has no tangent [1, -n1/n2] to speak of."""
SMALLEST_ANGLE = 0.01
"""In degrees: a normal that is turned by less is not spoken of."""


def met_exactly(fit: Fit, event: Event, balls: tuple[int, int]) -> list[str]:
    """Find that balls of a stepped run stand, in the first row that differs, where they touch exactly."""
    times = fit.step_times
    if times is None or not fit.first or fit.rows.times[fit.first - 1] > event.time:
        return []
    start = float(times[max(int(np.searchsorted(times, event.time)) - 1, 0)])
    places, velocities = (part[list(balls), :2] for part in fit.run.states(start))
    later = _touching(places, velocities, sum(fit.run.scenario.balls[ball].radius or 0.0 for ball in balls))
    if later is None or start + later - event.time <= 0.0:
        return []
    seen = [side for side in (0, 1) if balls[side] in fit.rows.balls]
    late = (start + later - event.time) * float(np.linalg.norm(velocities, axis=1).max())
    room = fit.tolerance + precision(fit)
    if room > MUCH_NEARER * late:
        return []
    for side in seen:
        found = fit.rows.places[fit.first, fit.rows.balls.index(balls[side])]
        if np.linalg.norm(found - places[side] - later * velocities[side]) > room:
            return []
    return [
        f"in the file the balls meet where they touch exactly, {start + later - event.time:.3g} later than the formula "
        "(|x_r - x_b| - 2r) / |v_r - v_b| of the scheme says"
    ]


def _touching(places: Vector, velocities: Vector, reach: float) -> float | None:
    """Give the time in which two balls on straight ways come so near to each other."""
    apart, closing = places[0] - places[1], velocities[0] - velocities[1]
    half, square = float(apart @ closing), float(closing @ closing)
    root = half**2 - square * (float(apart @ apart) - reach**2)
    return None if root < 0.0 or square == 0.0 else (-half - root**0.5) / square


@dataclass(frozen=True)
class Contact:
    """A collision of two balls in run and trajectory.

    Attributes
    ----------
    fit : Fit
        The trajectory and the run.
    event : Event
        The collision in the run.
    balls : tuple of int
        The two balls, by their place in the run.
    after : tuple of two Motions or None
        Their velocities after it in the trajectory, where rows tell.
    """

    fit: Fit
    event: Event
    balls: tuple[int, int]
    after: tuple[Motion | None, Motion | None]

    def explain(self) -> list[str]:
        """Say what the balls do in the trajectory."""
        if len(self.seen) == 0:
            return []
        steps = (self._straight, self._exchanged, self._frame, self._momentum, self._direction, self._strength)
        return next((sentences for step in steps if (sentences := step())), [])

    @property
    def seen(self) -> list[int]:
        """Which of the two have a velocity."""
        return [side for side in (0, 1) if self.after[side] is not None]

    @property
    def names(self) -> list[str]:
        """The ids of the two."""
        return [self.fit.run.ball_ids[ball] for ball in self.balls]

    @property
    def masses(self) -> list[float]:
        """The masses of the two."""
        balls = self.fit.run.scenario.balls
        return [float(balls[ball].mass or 1.0) for ball in self.balls]

    @property
    def before(self) -> list[Vector]:
        """Their velocities before it, the same in both."""
        return [just_before(self.fit, self.event, ball) for ball in self.balls]

    @property
    def room(self) -> float:
        """How much two equal velocities may differ."""
        speed = max(float(np.linalg.norm(velocity)) for velocity in self.before)
        return max(motion.noise for motion in self.after if motion is not None) + PART * speed

    def velocity(self, side: int) -> Vector:
        """Give a velocity after it in the trajectory."""
        motion = self.after[side]
        assert motion is not None
        return motion.velocity

    def impulse(self, side: int) -> Vector:
        """Give the impulse on a ball in the trajectory."""
        return self.masses[side] * (self.velocity(side) - self.before[side])

    def standing(self) -> list[str]:
        """Find balls that hardly move after their contact: in two steps of the file at least, both of them."""
        rows, first = self.fit.rows, self.fit.first
        if first is None or not all(ball in rows.balls for ball in self.balls):
            return []
        columns = [rows.balls.index(ball) for ball in self.balls]
        ways = np.linalg.norm(np.diff(rows.places[first:, columns], axis=0), axis=-1).max(axis=1)
        speed = max(float(np.linalg.norm(just_after(self.fit, self.event, ball))) for ball in self.balls)
        moving = ways > HARDLY * speed * np.diff(rows.times[first:])
        count = int(np.argmax(moving)) if moving.any() else len(moving)
        if count < 2:
            return []
        span = f"from {rows.where(first)} to {rows.where(first + count)}"
        return [
            f"in the file both balls hardly move {span}, as when their collision does not part them and is found anew "
            "in every step; a normal that is not of length 1, or of another direction, does that"
        ]

    def _same(self, one: Vector, other: Vector) -> bool:
        return bool(np.linalg.norm(one - other) <= self.room)

    def _straight(self) -> list[str]:
        straight = [side for side in self.seen if self._same(self.velocity(side), self.before[side])]
        if len(straight) == 2:
            return ["in the file both balls go straight on: this collision is missing"]
        if straight == self.seen:
            return [f"in the file {self.names[straight[0]]} goes straight on"]
        return []

    def _exchanged(self) -> list[str]:
        if len(self.seen) < 2 or not all(self._same(self.velocity(side), self.before[1 - side]) for side in (0, 1)):
            return []
        return ["in the file the balls exchange their whole velocities, not only the components along the normal"]

    def _frame(self) -> list[str]:
        """Find that n and t = [1, -n1/n2] are not of length 1: what lies along them is multiplied by their squares."""
        normal = self._normal(1)
        tangent = np.array([-normal[1], normal[0]])
        if abs(normal[1]) < SMALLEST_PART_OF_NORMAL or not self._goes_across(tangent):
            return []
        factor = 1.0 / float(normal[1]) ** 2
        if factor - 1.0 <= MUCH_NEARER:
            return []
        size = self._distance() ** 2
        told = f"is multiplied by {factor:.6g} = |t|^2 for t = [1, -n1/n2]"
        if self._multiplied(normal, 1.0, tangent, factor):
            names = " and ".join(self.names[side] for side in self.seen if self._across(side, tangent))
            return [f"in the file the tangential component of {names} {told}: is t of length 1?"]
        if self._multiplied(normal, size, tangent, factor):
            return [
                f"in the file the normal component after this collision is multiplied by {size:.6g} = |n|^2 for "
                f"n = x_r - x_b, and the tangential one {told}: are n and t of length 1?"
            ]
        return []

    def _across(self, side: int, tangent: Vector) -> bool:
        return abs(float(self.before[side] @ tangent)) > CLEAR * self.room

    def _goes_across(self, tangent: Vector) -> bool:
        return any(self._across(side, tangent) for side in self.seen)

    def _distance(self) -> float:
        """Give the distance of the centres where the run takes the normal: at the contact, or before its step."""
        times = self.fit.step_times
        method = self.fit.run.scenario.to_dict().get("method", {})
        time = self.event.time
        if times is not None and method.get("normal", "before") == "before":
            time = float(times[max(int(np.searchsorted(times, time)) - 1, 0)])
        one, two = self.fit.run.positions(time)[list(self.balls), :2]
        return float(np.linalg.norm(one - two))

    def _multiplied(self, normal: Vector, along: float, tangent: Vector, across: float) -> bool:
        """Tell whether the balls leave with Carom's components along normal and tangent, each times a factor."""
        for side in self.seen:
            carom = just_after(self.fit, self.event, self.balls[side])
            wanted = along * (carom @ normal) * normal + across * (carom @ tangent) * tangent
            if np.linalg.norm(self.velocity(side) - wanted) > 2.0 * across * self.room:
                return False
        return True

    def _momentum(self) -> list[str]:
        if len(self.seen) < 2:
            return []
        masses, before = self.masses, self.before
        old = masses[0] * before[0] + masses[1] * before[1]
        new = masses[0] * self.velocity(0) + masses[1] * self.velocity(1)
        if np.linalg.norm(new - old) <= self.room * sum(masses):
            return []
        sentences = [f"momentum is not kept in the file: {said(old)} before this collision, {said(new)} after it"]
        for side in (0, 1):
            carom = just_after(self.fit, self.event, self.balls[side])
            right = "as in Carom's run" if self._same(carom, self.velocity(side)) else f"Carom: {said(carom)}"
            straight = self._same(before[side], self.velocity(side))
            change = "stays" if straight else f"goes from {said(before[side])} to"
            sentences.append(f"{self.names[side]}'s velocity {change} {said(self.velocity(side))} ({right})")
        return sentences

    def _direction(self) -> list[str]:
        side = self.seen[-1]
        impulse, normal = self.impulse(side), self._normal(side)
        size = float(np.linalg.norm(impulse))
        line = impulse / size * (1.0 if impulse @ normal >= 0.0 else -1.0)
        angle = float(np.degrees(np.arctan2(normal[0] * line[1] - normal[1] * line[0], normal @ line)))
        room = max(SMALLEST_ANGLE, np.degrees(2.0 * self.room * self.masses[side] / size))
        if abs(angle) <= room:
            return []
        names = [name for name, other in self._known_lines(normal) if _angle_between(line, other) <= room]
        named = f": it is {' or '.join(names)}" if names else ""
        sentences = [
            f"the normal of this collision is turned by {abs(angle):.3g} degrees in the file: the impulse on "
            f"{self.names[side]} lies along {said(line)}, Carom's normal is {said(normal)}{named}"
        ]
        if self._obeys_law_along(impulse, line, side):
            sentences.append("along that direction the velocities are exchanged as they should be")
        return sentences

    def _obeys_law_along(self, impulse: Vector, line: Vector, side: int) -> bool:
        """Tell whether the impulse is that of the run's law, were the normal this line."""
        before, masses = self.before, self.masses
        approach = before[1 - side] - before[side]
        carom = self._carom_impulse(side) @ self._normal(side)
        bounce = carom / float(approach @ self._normal(side))
        wanted = bounce * (approach @ line) * line
        return bool(np.linalg.norm(impulse - wanted) <= 2.0 * self.room * max(masses))

    def _strength(self) -> list[str]:
        side = self.seen[-1]
        normal, carom = self._normal(side), self._carom_impulse(side)
        size, wanted = float(self.impulse(side) @ normal), float(carom @ normal)
        if abs(size - wanted) <= 2.0 * self.room * self.masses[side]:
            return []
        factor = size / wanted
        if factor < 0.0:
            return [f"the impulse in the file drives the balls together: it is {factor:.6g} times Carom's"]
        kind = "weak" if factor < 1.0 else "strong"
        return [f"the impulse in the file has Carom's direction but is too {kind}: {factor:.6g} times Carom's"]

    def _normal(self, side: int) -> Vector:
        """Give the run's normal, towards one of the balls."""
        return np.array(self.event.normal) * (1.0 if side == 1 else -1.0)

    def _carom_impulse(self, side: int) -> Vector:
        ball = self.balls[side]
        change = just_after(self.fit, self.event, ball) - just_before(self.fit, self.event, ball)
        return self.masses[side] * change

    def _known_lines(self, normal: Vector) -> list[tuple[str, Vector]]:
        """Give directions that are often taken for the normal, by name."""
        x, y = normal
        known = [
            ("the normal with its components exchanged", np.array([y, x])),
            ("the normal with the sign of one component changed", np.array([x, -y])),
            ("the tangent", np.array([-y, x])),
            ("the x axis", np.array([1.0, 0.0])),
            ("the y axis", np.array([0.0, 1.0])),
            ("the direction of the relative velocity", self.before[0] - self.before[1]),
        ]
        return [*known, *self._lines_of_centres()]

    def _lines_of_centres(self) -> list[tuple[str, Vector]]:
        """Give the lines between the centres in the rows around the collision."""
        rows = self.fit.rows
        if not all(ball in rows.balls for ball in self.balls):
            return []
        one, two = (rows.balls.index(ball) for ball in self.balls)
        after = int(np.searchsorted(rows.times, self.event.time))
        around = [row for row in (after - 1, after) if 0 <= row < len(rows)]
        return [
            (f"the line between the centres in {rows.where(row)}", rows.places[row, two] - rows.places[row, one])
            for row in around
        ]


def _angle_between(one: Vector, other: Vector) -> float:
    """Give the angle between two lines, in degrees."""
    cross = one[0] * other[1] - one[1] * other[0]
    return float(np.degrees(np.arctan2(abs(cross), abs(one @ other))))
