"""Tables that repeat themselves: paths broken at the sides, and discs that stand across one on both."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Repeats:
    """A box, and along which axes it repeats itself; along none, all is left as it is.

    Attributes
    ----------
    low, size : (2,) float64
        The lower left corner and the extent of the box.
    axes : (2,) bool
        Whether it repeats itself along x and y.
    """

    low: Numbers
    size: Numbers
    axes: NDArray[np.bool_]

    def __bool__(self) -> bool:
        return bool(self.axes.any())

    def wrapped(self, places: Numbers) -> Numbers:
        """Give places (..., 2) moved into the box."""
        return places - self._boxes(places) * self.size if self else places

    def nearest(self, places: Numbers, to: Numbers) -> Numbers:
        """Give of places (..., 2) the repetitions that are nearest to others."""
        if not self:
            return places
        return np.where(self.axes, places - np.rint((places - to) / self.size) * self.size, places)

    def copies(self, places: Numbers, radii: Numbers) -> tuple[Numbers, NDArray[np.intp]]:
        """Give all places at which discs are seen in the box, and which disc each of them is: first all of them once.

        Parameters
        ----------
        places : (n, 2) float64
            Their centres, in the box.
        radii : (n,) float64
            Their radii.
        """
        which = np.arange(len(places))
        for axis in np.flatnonzero(self.axes):
            low, high = self.low[axis], self.low[axis] + self.size[axis]
            step = np.where(np.arange(2) == axis, self.size, 0.0)
            at_low = places[:, axis] - radii[which] < low
            at_high = places[:, axis] + radii[which] > high
            places = np.concatenate([places, places[at_low] + step, places[at_high] - step])
            which = np.concatenate([which, which[at_low], which[at_high]])
        return places, which

    def segments(self, path: Numbers) -> tuple[Numbers, NDArray[np.intp]]:
        """Cut the straight ways between places (n, 2) at the sides, and move them into the box.

        Returns
        -------
        ends : (m, 2, 2) float64
            Where each of them starts and ends.
        which : (m,) int
            The place after which it comes.
        """
        which = np.arange(len(path) - 1)
        for axis in np.flatnonzero(self.axes):
            path, which = self._cut(path, which, int(axis))
        ends = np.stack([path[:-1], path[1:]], axis=1)
        return ends - (self._boxes(ends.mean(axis=1)) * self.size)[:, None], which

    def broken(self, path: Numbers) -> Numbers:
        """Give a path (n, 2) in the box, with a row of NaN wherever it goes on at another side."""
        if not self or len(path) < 2:
            return self.wrapped(path)
        ends, _ = self.segments(path)
        jumps = np.flatnonzero(np.abs(ends[1:, 0] - ends[:-1, 1]).max(axis=1) > 0.5 * self.size[self.axes].min()) + 1
        parts = np.split(ends, jumps)
        gap = np.full((1, 2), np.nan)
        rows = [row for part in parts for row in (part[:1, 0], part[:, 1], gap)]
        return np.concatenate(rows[:-1])

    def _boxes(self, places: Numbers) -> Numbers:
        """Give in which repetition of the box places (..., 2) are."""
        return np.where(self.axes, np.floor((places - self.low) / self.size), 0.0)

    def _cut(self, path: Numbers, which: NDArray[np.intp], axis: int) -> tuple[Numbers, NDArray[np.intp]]:
        """Put the places in at which a path crosses sides along one axis."""
        turns = (path[:, axis] - self.low[axis]) / self.size[axis]
        start, end = turns[:-1], turns[1:]
        first, last = np.floor(np.minimum(start, end)) + 1, np.ceil(np.maximum(start, end)) - 1
        rows, places = [], []
        for row in np.flatnonzero(last >= first):
            sides = np.arange(first[row], last[row] + 1)
            share = np.sort((sides - start[row]) / (end[row] - start[row]))
            rows.append(np.full(len(share), row))
            places.append(path[row] + share[:, None] * (path[row + 1] - path[row]))
        if not rows:
            return path, which
        after = np.concatenate(rows)
        counts = np.bincount(after, minlength=len(which))
        return np.insert(path, after + 1, np.concatenate(places), axis=0), np.repeat(which, counts + 1)
