"""How a ball moves in a trajectory, from its rows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from carom.comparison.fit import CLOCK

if TYPE_CHECKING:
    from carom.comparison.fit import Fit
    from carom.events import Event

Vector = NDArray[np.float64]
MUCH_NEARER = 0.1
SMALLEST_PART = 1e-12
"""Places are taken to be no more precise than this part of the largest coordinate."""


@dataclass(frozen=True)
class Motion:
    """A ball's velocity in a trajectory, and how uncertain the rows leave it."""

    velocity: Vector
    noise: float


@dataclass(frozen=True)
class Track:
    """A ball in a trajectory, from the first row that differs on.

    Attributes
    ----------
    fit : Fit
        The trajectory and the run.
    ball : int
        The ball's place among the run's.
    """

    fit: Fit
    ball: int

    @property
    def column(self) -> int:
        """The ball's place among those in the trajectory."""
        return self.fit.rows.balls.index(self.ball)

    def motion_after(self, event: Event | None) -> Motion | None:
        """Give the velocity right after an event, or at the first row that differs; None where rows do not tell."""
        first = self.fit.first
        assert first is not None
        since = self.fit.rows.times[first] if event is None else settled(self.fit, event)
        starts = [first]
        if first > 0 and self.fit.rows.times[first - 1] >= since - CLOCK * self.fit.run.end_time:
            starts.append(first - 1)
        motions = (self._motion_from(row, since) for row in starts)
        return next((motion for motion in motions if motion is not None), None)

    def _motion_from(self, row: int, since: float) -> Motion | None:
        """Give the velocity at a time from three rows, if they lie on one flight."""
        times, places = self.fit.rows.times[row : row + 3], self.fit.rows.places[row : row + 3, self.column]
        if len(times) < 3:
            return None
        span = times[1:] - times[0]
        acceleration = acceleration_of(self.fit)
        near, far = (places[1:] - places[0]) / span[:, None] - 0.5 * acceleration * span[:, None]
        noise = 4.0 * precision(self.fit) / float(span[0])
        if np.linalg.norm(near - far) > noise + 1e-6 * np.linalg.norm(far):
            return None
        return Motion(far - acceleration * (times[0] - since), noise)


def precision(fit: Fit) -> float:
    """Say how precisely the trajectory gives places: as it agrees before it differs, and as its digits allow."""
    smallest = SMALLEST_PART * float(np.abs(fit.rows.places).max())
    return max(smallest, fit.rounding[1], float(fit.distances[: fit.first].max(initial=0.0)))


def nearness(fit: Fit, ball: int) -> float:
    """Say how near to a place the first row that differs has to be to be taken for it: much nearer than to Carom's."""
    assert fit.first is not None
    apart = float(fit.distances[fit.first, fit.rows.balls.index(ball)])
    return min(fit.tolerance + precision(fit), MUCH_NEARER * apart)


def acceleration_of(fit: Fit) -> Vector:
    """Give the constant acceleration of all balls."""
    flight = fit.run.scenario.to_dict().get("physics", {}).get("flight", {})
    return np.array(flight.get("acceleration", (0.0, 0.0)), dtype=np.float64)


def settled(fit: Fit, event: Event) -> float:
    """Give the time from which a ball moves on after an event: its own, or the end of the step it waits for."""
    times = fit.step_times
    if times is None:
        return event.time
    return float(times[min(int(np.searchsorted(times, event.time)), len(times) - 1)])


def just_before(fit: Fit, event: Event, ball: int) -> Vector:
    """Give a ball's velocity in the run right before an event."""
    velocity: Vector = fit.run.velocities(np.nextafter(event.time, -np.inf))[ball, :2]
    return velocity


def just_after(fit: Fit, event: Event, ball: int) -> Vector:
    """Give a ball's velocity in the run right after an event."""
    velocity: Vector = fit.run.velocities(event.time)[ball, :2]
    return velocity


def said(vector: Vector, digits: int = 6) -> str:
    """Give a vector as text."""
    return f"({vector[0] + 0.0:.{digits}g}, {vector[1] + 0.0:.{digits}g})"
