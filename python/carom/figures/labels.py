"""Numbers beside marks, placed where they cover neither one another nor what matters."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

DIRECTIONS = np.array([[np.cos(a), np.sin(a)] for a in np.radians(np.arange(20, 380, 30))])
DISTANCES = (1.0, 1.5, 2.1, 2.8)


@dataclass
class Labeller:
    """Finds free places for small texts, one after the other, all lengths in points.

    Attributes
    ----------
    taken : list of (2,) arrays
        Places that a label should not cover: marks, discs, labels placed before.
    lines : (n, 2) float64
        Places along the curves, which a label avoids where it can.
    """

    lines: NDArray[np.float64]
    taken: list[tuple[NDArray[np.float64], float]] = field(default_factory=list)

    def place(
        self,
        anchor: NDArray[np.float64],
        size: float,
        distance: float,
        towards: NDArray[np.float64] | None = None,
    ) -> NDArray[np.float64]:
        """Choose the centre of a label of about `size` points beside an anchor, and keep it for later ones.

        With `towards` (a unit vector) only places on that side are tried.
        """
        directions = DIRECTIONS if towards is None else _fan(towards)
        options = [
            (self._cost(anchor + step * distance * way, size) + 0.6 * step, anchor + step * distance * way)
            for step in DISTANCES
            for way in directions
        ]
        centre: NDArray[np.float64] = min(options, key=lambda option: option[0])[1]
        self.taken.append((centre, size / 2))
        return centre

    def avoid(self, centres: Sequence[NDArray[np.float64]] | NDArray[np.float64], radius: float) -> None:
        """Keep later labels off some round places."""
        self.taken.extend((np.asarray(centre), radius) for centre in centres)

    def _cost(self, centre: NDArray[np.float64], size: float) -> float:
        """Weigh how much a label would cover: marks and labels count much, curves a little."""
        reach = size / 2
        covered = 0.0
        for place, radius in self.taken:
            depth = reach + radius - float(np.hypot(*(place - centre)))
            covered += max(0.0, depth) * 4.0
        if len(self.lines):
            near = float(np.hypot(*(self.lines - centre).T).min())
            covered += max(0.0, reach - near)
        return covered


def _fan(towards: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give directions around one, the straight one first."""
    turns = np.radians([0.0, -25.0, 25.0, -50.0, 50.0])
    cosines, sines = np.cos(turns), np.sin(turns)
    x, y = towards
    return np.stack([cosines * x - sines * y, sines * x + cosines * y], axis=1)
