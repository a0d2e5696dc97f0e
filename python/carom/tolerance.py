"""Tolerance: how far off a shot may be before its goal is missed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.ensemble import Ensemble, Grid
from carom.errors import ScenarioError
from carom.goal import Goal, is_met, outcomes_for
from carom.noise import ExecutionNoise, bounds_of, meant

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.scenario import Scenario
else:
    from carom import arrays as np


@dataclass(frozen=True, slots=True)
class Margin:
    """How far one number of a shot alone may be off, all else being as meant.

    Looked at in steps from the meant number outwards: `below` and `above` are the last steps before the first miss. The
    goal is lost somewhere within one step more; what happens between two steps is not seen.

    Attributes
    ----------
    meant : float
        The number of the meant shot.
    below, above : float
        How much less and how much more it may be; NaN where the meant shot itself misses.
    resolution : float
        The length of a step.
    is_missed_below, is_missed_above : bool
        Whether a miss comes after that. Where it does not, `below` or `above` ends with what was looked at, or with
        what a stroke can be: no speed is negative.
    """

    meant: float
    below: float
    above: float
    resolution: float
    is_missed_below: bool
    is_missed_above: bool

    def __repr__(self) -> str:
        sides = ((self.below, self.is_missed_below, "below"), (self.above, self.is_missed_above, "above"))
        words = [f"{'' if missed else 'at least '}{offset:.4g} {side}" for offset, missed, side in sides]
        said = "missed as meant" if math.isnan(self.below) else " and ".join(words)
        return f"Margin: {self.meant:.6g}, {said}, in steps of {self.resolution:.4g}"


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How far off a shot may be before its goal is missed; see `Scenario.tolerance`.

    Attributes
    ----------
    margins : dict of str to Margin
        How far each number alone may be off, by its path.
    is_met : bool
        Whether the meant shot meets the goal.
    table : Ensemble
        The shots on the grid, a row for each, without noise; its column ``met`` says whether the goal is met.
    noise : ExecutionNoise or None
        The noise whose ellipses the map shows.
    """

    margins: dict[str, Margin]
    is_met: bool
    table: Ensemble
    noise: ExecutionNoise | None

    def map(self, x: str | None = None, y: str | None = None, ax: Axes | None = None) -> Axes:
        """Draw where the goal is met around the meant shot; see `carom.figures.plot_tolerance`."""
        from carom import figures

        return figures.plot_tolerance(self, x=x, y=y, ax=ax)

    def __repr__(self) -> str:
        margins = "; ".join(f"{path}: {repr(margin).removeprefix('Margin: ')}" for path, margin in self.margins.items())
        return f"Tolerance: {margins}"


def tolerance(
    scenario: Scenario,
    reach: Mapping[str, float],
    goal: Goal,
    noise: ExecutionNoise | None,
    *,
    cells: int,
    steps: int,
    outcomes: Sequence[str],
    threads: int | None,
) -> Tolerance:
    """Tell how far off a shot may be; see `Scenario.tolerance`."""
    _check(reach, {"cells": cells, "steps": steps})
    center = meant(scenario, reach)
    wanted = outcomes_for(goal, outcomes)
    lines = {path: _numbers(path, center[path], far, steps) for path, far in reach.items()}
    scan = scenario.ensemble(_one_by_one(center, lines), wanted, threads=threads, invalid="keep")
    if not scan.is_complete:
        # Half of a scan would give margins that are too small.
        raise KeyboardInterrupt
    ends = np.cumsum([len(numbers) for numbers in lines.values()])[:-1]
    found = zip(lines, np.split(is_met(scan, goal), ends), np.split(scan.has_outcome, ends), strict=True)
    margins = {path: _margin(center[path], lines[path], reach[path] / steps, *rows) for path, *rows in found}
    grid = Grid({path: _numbers(path, center[path], far, cells) for path, far in reach.items()})
    table = scenario.ensemble(grid, wanted, threads=threads, invalid="keep")
    columns = {**table.to_dict(), "met": is_met(table, goal)}
    judged = Ensemble(scenario, table._native, columns, is_complete=table.is_complete, grid=grid)
    return Tolerance(margins, not any(math.isnan(margin.below) for margin in margins.values()), judged, noise)


def _check(reach: Mapping[str, float], counts: Mapping[str, int]) -> None:
    if len(reach) != 2:
        raise ValueError(f"reach: must have two numbers of the shot, got {len(reach)} ({', '.join(reach)})")
    wrong = [(path, far) for path, far in reach.items() if not 0.0 < far < math.inf]
    if wrong:
        raise ScenarioError([(path, f"how far to look must be positive and finite, got {far}") for path, far in wrong])
    for name, count in counts.items():
        if count < 1:
            raise ValueError(f"{name}: must be 1 at least, got {count}")


def _numbers(path: str, center: float, far: float, steps: int) -> NDArray[np.float64]:
    """Give so many numbers on either side of one, which keeps its bits, as far as a stroke has them."""
    numbers = center + far * (np.arange(-steps, steps + 1) / steps)
    low, high = bounds_of(path)
    return numbers[(low <= numbers) & (numbers <= high)]


def _one_by_one(
    center: Mapping[str, float], lines: Mapping[str, NDArray[np.float64]]
) -> dict[str, NDArray[np.float64]]:
    """Give shots of which one number after the other goes along its line while the rest stays as meant."""

    def column(path: str) -> NDArray[np.float64]:
        parts = (numbers if moved == path else np.full(len(numbers), center[path]) for moved, numbers in lines.items())
        return np.concatenate(list(parts))

    return {path: column(path) for path in center}


def _margin(
    meant: float,
    numbers: NDArray[np.float64],
    resolution: float,
    met: NDArray[np.bool_],
    has_outcome: NDArray[np.bool_],
) -> Margin:
    """Read a scan from the meant shot outwards on both sides."""
    middle = int(np.flatnonzero(numbers == meant)[0])

    def side(outwards: slice) -> tuple[float, bool]:
        lost = np.flatnonzero(~met[outwards])
        if len(lost) == 0:
            return (len(met[outwards]) - 1) * resolution, False
        steps = int(lost[0]) - 1
        return steps * resolution if steps >= 0 else math.nan, bool(has_outcome[outwards][lost[0]])

    (below, is_missed_below), (above, is_missed_above) = side(slice(middle, None, -1)), side(slice(middle, None))
    return Margin(meant, below, above, resolution, is_missed_below, is_missed_above)
