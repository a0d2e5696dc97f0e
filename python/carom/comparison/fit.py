"""How far rows of a trajectory are from a run, and whether they cover it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from carom.comparison.digits import find_rounding

if TYPE_CHECKING:
    from carom.comparison.digits import Digits
    from carom.comparison.rows import Rows
    from carom.run import Run

CLOCK = 1e-9
"""How far, as a part of the duration, a clock that was added up may be from the true time."""
REGULAR = 0.9
"""The part of a regular grid's steps that are equal."""
MOST_HOLES = 3


@dataclass(frozen=True)
class Fit:
    """Rows of a trajectory held against a run, up to its end or to a limit before it.

    Attributes
    ----------
    run : Run
        The run.
    rows : Rows
        The trajectory.
    limit : float
        The time up to which they are compared.
    tolerance : float
        How far a ball may be from its place in the run.
    partial : bool
        Whether the limit was asked for, so that rows after it are no fault.
    """

    run: Run
    rows: Rows
    limit: float
    tolerance: float
    partial: bool = False

    @cached_property
    def count(self) -> int:
        """The number of rows up to the limit."""
        return int(np.searchsorted(self.rows.times, self.limit + CLOCK * self.run.end_time, side="right"))

    @cached_property
    def expected(self) -> NDArray[np.float64]:
        """The places in the run, (count, n_balls, 2)."""
        # A ball at rest stays where it is, and a clock that was added up may end a hair after the run.
        times = np.minimum(self.rows.times[: self.count], self.run.end_time)
        return self.run.positions(times)[:, list(self.rows.balls), :2]

    @cached_property
    def offsets(self) -> NDArray[np.float64]:
        """The places in the trajectory less those in the run, (count, n_balls, 2)."""
        return self.rows.places[: self.count] - self.expected

    @cached_property
    def distances(self) -> NDArray[np.float64]:
        """The distances between the places in trajectory and run, (count, n_balls)."""
        return np.hypot(self.offsets[..., 0], self.offsets[..., 1])

    @cached_property
    def differs(self) -> NDArray[np.bool_]:
        """Whether a row is beyond the tolerance, (count,)."""
        beyond: NDArray[np.bool_] = ~np.all(self.distances <= self.tolerance, axis=1)
        return beyond

    @cached_property
    def first(self) -> int | None:
        """The first row beyond the tolerance."""
        return int(np.argmax(self.differs)) if self.differs.any() else None

    @cached_property
    def step_times(self) -> NDArray[np.float64] | None:
        """The times of a stepped run's steps; None for an exact one."""
        steps = self.run.steps
        return None if steps is None else steps["time"]

    @cached_property
    def gaps(self) -> list[str]:
        """What the rows lack of the run: its start, its end, rows between."""
        return [*self._ends(), *self._holes()]

    @property
    def agrees(self) -> bool:
        """Whether every row is within the tolerance, and the rows cover the run."""
        return self.first is None and not self.gaps

    @cached_property
    def rounding(self) -> tuple[Digits, float]:
        """The digits of the places, and how far rounding to them may have moved a ball."""
        return find_rounding(self.rows.times, self.rows.places, self.fastest)

    @cached_property
    def fastest(self) -> float:
        """The largest speed of a ball of the run at the times of the rows."""
        times = np.minimum(self.rows.times, self.run.end_time)
        return float(np.linalg.norm(self.run.velocities(times), axis=-1).max(initial=0.0))

    @cached_property
    def spacing(self) -> float | None:
        """The step of the time grid where that is regular: nine of ten steps are equal."""
        steps = np.diff(self.rows.times)
        if len(steps) < 3:
            return None
        step = float(np.median(steps))
        return step if np.mean(np.abs(steps - step) <= 1e-3 * step) >= REGULAR else None

    def _ends(self) -> list[str]:
        start, end, broken = float(self.rows.times[0]), float(self.rows.times[-1]), self.rows.broken
        room = CLOCK * self.run.end_time
        found = []
        if start > room:
            found.append(f"it starts at t = {start:.6g} ({self.rows.where(0)}), the run at 0")
        if broken is not None and broken.time <= self.limit + room:
            found.append(f"it has no place in {broken.where}, t = {broken.time:.6g}: {broken.values}")
        elif end < self.limit - room:
            found.append(
                f"it ends at t = {end:.10g} ({self.rows.where(len(self.rows) - 1)}), the run at {self.limit:.10g}; "
                f"--duration {end:.10g} compares that part"
            )
        if self.count < len(self.rows) and not self.partial:
            late = self.rows.times[self.count]
            left = len(self.rows) - self.count
            rows = "1 row is" if left == 1 else f"{left} rows are"
            found.append(
                f"{rows} after the run's end at t = {self.limit:.10g} ({self.rows.where(self.count)}: {late:.10g})"
            )
        return found

    def _holes(self) -> list[str]:
        if self.spacing is None:
            return []
        times = self.rows.times[: self.count]
        steps = np.diff(times)
        found = [self._hole(int(row)) for row in np.flatnonzero(steps > 1.5 * self.spacing)[:MOST_HOLES]]
        left = int((steps > 1.5 * self.spacing).sum()) - len(found)
        return [*found, f"and {left} more holes in its times"] if left else found

    def _hole(self, row: int) -> str:
        before, after = self.rows.times[row : row + 2]
        missing = round((after - before) / self.spacing) - 1 if self.spacing else 0
        rows = "a row is" if missing == 1 else f"{missing} rows are"
        return (
            f"{rows} missing between {self.rows.where(row)} and {self.rows.where(row + 1)}: "
            f"the time goes from {before:.6g} to {after:.6g}, in steps of {self.spacing:.6g}"
        )


def time_step(run: Run) -> float | None:
    """Give the time step of a stepped run; None for an exact one."""
    method = run.scenario.to_dict().get("method", {})
    return float(method["dt"]) if method.get("kind") == "stepped" else None
