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
class Break:
    """Where the numbers of a trajectory end: its first row with a place that is not finite.

    Attributes
    ----------
    where : str
        Where it stands.
    time : float
        Its time.
    ball : int
        The first ball that has no place there, by its place in the run.
    values : str
        What stands there instead.
    """

    where: str
    time: float
    ball: int
    values: str


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
    broken : Break or None
        The row that would follow, where that has a place that is not finite.
    """

    source: Source
    balls: tuple[int, ...]
    times: NDArray[np.float64]
    places: NDArray[np.float64]
    broken: Break | None = None

    def __len__(self) -> int:
        return len(self.times)

    def where(self, row: int) -> str:
        """Say where a row stands."""
        return self.source.place(row)


def read_rows(source: Source, assignment: Assignment) -> Rows:
    """Read the rows, up to the first with a place that is not finite.

    Raises
    ------
    TrajectoryError
        When a time, or a value of the first row, is no finite number, or when times do not ascend from zero or later.
    """
    values = source.values(assignment.columns)
    _check_finite(source, assignment, values)
    times = np.ascontiguousarray(values[:, 0])
    _check_ascending(source, times)
    bad = np.flatnonzero(~np.isfinite(values).all(axis=1))
    broken = _speak_of_break(source, assignment, values, int(bad[0])) if len(bad) else None
    count = int(bad[0]) if len(bad) else len(values)
    return Rows(source, assignment.balls, times[:count], values[:count, 1:].reshape(count, -1, 2), broken)


def _speak_of_break(source: Source, assignment: Assignment, values: NDArray[np.float64], row: int) -> Break:
    bad = np.flatnonzero(~np.isfinite(values[row]))
    names = list(assignment.meaning.values())
    words = ", ".join(f"{names[column]} = {values[row, column]}" for column in bad)
    return Break(source.place(row), float(values[row, 0]), assignment.balls[(int(bad[0]) - 1) // 2], words)


def _check_finite(source: Source, assignment: Assignment, values: NDArray[np.float64]) -> None:
    """Refuse times that are not finite, and a first row that holds no places."""
    names = list(assignment.meaning.values())

    def describe(cell: NDArray[np.int64]) -> tuple[str, str]:
        row, column = (int(place) for place in cell)
        return f"{source.name}, {source.place(row)}, {names[column]}", f"must be finite, got {values[row, column]}"

    finite = np.isfinite(values)
    finite[1:, 1:] = True
    bad = np.argwhere(~finite)
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
