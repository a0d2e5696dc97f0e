"""A trajectory that was read: times, and the places of balls at them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from carom.comparison.source import listed
from carom.errors import TrajectoryError

if TYPE_CHECKING:
    from carom.comparison.assignment import Assignment
    from carom.comparison.source import Source


@dataclass(frozen=True)
class Rows:
    """The rows of a trajectory.

    Attributes
    ----------
    source : Source
        Where they come from; it says where a row stands.
    balls : tuple of int
        The balls, by their place in the run.
    times : (n_rows,) float64
        Ascending, from zero or later.
    places : (n_rows, n_balls, 2) float64
        The centres of these balls.
    """

    source: Source
    balls: tuple[int, ...]
    times: NDArray[np.float64]
    places: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.times)

    def where(self, row: int) -> str:
        """Say where a row stands."""
        return self.source.place(row)


def read_rows(source: Source, assignment: Assignment) -> Rows:
    """Read the rows.

    Raises
    ------
    TrajectoryError
        When a value is no finite number, or when times do not ascend from zero or later.
    """
    values = source.values(assignment.columns)
    _check_finite(source, assignment, values)
    times = np.ascontiguousarray(values[:, 0])
    _check_ascending(source, times)
    return Rows(source, assignment.balls, times, values[:, 1:].reshape(len(values), -1, 2))


def _check_finite(source: Source, assignment: Assignment, values: NDArray[np.float64]) -> None:
    names = list(assignment.meaning.values())

    def describe(cell: NDArray[np.int64]) -> tuple[str, str]:
        row, column = (int(place) for place in cell)
        return f"{source.name}, {source.place(row)}, {names[column]}", f"must be finite, got {values[row, column]}"

    bad = np.argwhere(~np.isfinite(values))
    if len(bad):
        raise TrajectoryError(listed(bad, describe, "values that are not finite", source.name))


def _check_ascending(source: Source, times: NDArray[np.float64]) -> None:
    def negative(row: int) -> tuple[str, str]:
        return f"{source.name}, {source.place(row)}", f"the time is negative: {times[row]:.10g}"

    def back(row: int) -> tuple[str, str]:
        words = "stands twice" if times[row] == times[row - 1] else f"comes after {times[row - 1]:.10g}"
        return f"{source.name}, {source.place(row)}", f"times must ascend: {times[row]:.10g} {words}"

    early, late = np.flatnonzero(times < 0.0), np.flatnonzero(np.diff(times) <= 0.0) + 1
    problems = listed(early, negative, "negative times", source.name)
    problems += listed(late, back, "times that do not ascend", source.name)
    if problems:
        raise TrajectoryError(problems)
