"""A run taken one event at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom import _engine
from carom.errors import RunError
from carom.events import Event, decoded, event_from

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from carom.run import Run
else:
    from carom import arrays as np


@dataclass(frozen=True, slots=True)
class Candidate:
    """What would happen to a ball next, if nothing else came first.

    Attributes
    ----------
    ball : str
        The ball.
    kind : str or None
        The kind of event; None when nothing ever closes on this ball.
    ball_b, cushion : str or None
        What it would meet.
    time : float or None
        When.
    gap : float or None
        The distance now between the two.
    pocket : str or None
        What it would fall into.
    """

    ball: str
    kind: str | None
    ball_b: str | None
    cushion: str | None
    time: float | None
    gap: float | None
    pocket: str | None = None


class Simulation:
    """A run under way; it gives the same bits as one that is computed at once.

    Iterating over it takes the remaining events one by one.

    Examples
    --------
    >>> import carom
    >>> simulation = carom.load("midterm").start()
    >>> simulation.step().kind
    'ball_cushion'
    >>> simulation.run_until(2.0)
    >>> simulation.finish().status
    'time_limit'
    """

    def __init__(self, native: _engine.Simulation) -> None:
        self._native = native

    @property
    def time(self) -> float:
        """The time that the simulation has come to."""
        return self._native.time

    @property
    def status(self) -> str | None:
        """How the run ended; None while it goes on."""
        return self._native.status

    @property
    def positions(self) -> NDArray[np.float64]:
        """The centres now, (n_balls, 2) float64, in length; (n_balls, 3) on a cloth, NaN for balls out of play."""
        return self._native.positions()

    @property
    def velocities(self) -> NDArray[np.float64]:
        """The velocities now, in length per time; otherwise as `positions`."""
        return self._native.velocities()

    @property
    def spins(self) -> NDArray[np.float64]:
        """The angular velocities now, (n_balls, 3) float64, in radians per time; on a cloth only."""
        return self._native.spins()[0]

    @property
    def motion(self) -> NDArray[np.object_]:
        """How each ball moves now, (n_balls,) object, as words; on a cloth only. See `Run.motion`."""
        return decoded(self._native.spins()[1], _engine.MOTIONS)

    def step(self) -> Event | None:
        """Go on to the next event and give it; None when the run has ended before another one."""
        row = self._native.step()
        return None if row is None else event_from(row)

    def __iter__(self) -> Iterator[Event]:
        while (event := self.step()) is not None:
            yield event

    def run_until(self, time: float) -> None:
        """Go on to `time`, or to the end of the run if that is earlier.

        Raises
        ------
        RunError
            When `time` is NaN, or lies before the present one: a simulation does not go back.
        """
        if time != time:
            raise RunError(f"time: must be a number, got {time!r}")
        if time < self.time:
            raise RunError(f"time: {time:.17g} lies before {self.time:.17g}, where the simulation is")
        self._native.run_until(time)

    def run_until_true(self, predicate: Callable[[Event], bool]) -> Run:
        """Go on until the first event for which `predicate` is true, and end the run there."""
        if any(predicate(event) for event in self):
            self.stop()
        return self.finish()

    def candidates(self) -> list[Candidate]:
        """Give each ball's next event as foreseen now, in order of the balls."""
        return [Candidate(**row) for row in self._native.candidates()]

    def stop(self) -> None:
        """End the run here; its status is ``stopped``."""
        self._native.stop()

    def finish(self) -> Run:
        """Go on to the end, unless the run has ended, and give the whole run."""
        from carom.run import Run

        return Run(self._native.finish())

    def __repr__(self) -> str:
        return f"Simulation at time {self.time:.6g}" + (f" ({self.status})" if self.status else "")
