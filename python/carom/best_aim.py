"""The best aim: where on a grid of shots a goal is met most often by someone whose strokes scatter."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.columns import ColumnTable
from carom.ensemble import Ensemble, Grid, native_ensemble
from carom.errors import ScenarioError
from carom.goal import Goal, is_met, outcomes_for
from carom.noise import ExecutionNoise, check_level, meant, share
from carom.progress import Progress, telling

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    from carom.scenario import Scenario
else:
    from carom import arrays as np

RUNS_AT_ONCE = 50_000
"""So many runs at most are in one ensemble, unless a single point has more: they bound the memory."""


class AimTable(ColumnTable):
    """How sure a shot is at each point of a grid of aims, a row for each point; see `Scenario.best_aim`.

    The columns are the numbers of the shot, by their paths; ``probability``, the share of the runs that met the goal,
    with its confidence interval from ``low`` to ``high``; and ``hits`` of so many ``runs``. Of points that were not
    finished the probability is NaN, the interval from 0 to 1, and the runs are 0.

    Attributes
    ----------
    scenario : Scenario
        The scenario whose shot was varied.
    grid : Grid
        The aims.
    """

    def __init__(self, scenario: Scenario, grid: Grid, columns: Mapping[str, Any]) -> None:
        super().__init__(columns)
        self.scenario = scenario
        self.grid = grid

    @property
    def has_outcome(self) -> NDArray[np.bool_]:
        """Which points were finished, (n_points,)."""
        finished: NDArray[np.bool_] = self["runs"] > 0
        return finished

    @property
    def is_complete(self) -> bool:
        """Whether all of them were."""
        return bool(self.has_outcome.all())


@dataclass(frozen=True, slots=True)
class BestAim:
    """The point of a grid of aims at which a goal is met most often.

    Among points that are equally good it is the one nearest to their middle. Its interval is that of this point by
    itself; the best of many points owes something to its luck, so play it again with another seed to know how good it
    is: ``best.scenario.success(goal, noise, seed=1)``.

    Attributes
    ----------
    point : dict of str to float
        The numbers of the shot, by their paths.
    scenario : Scenario
        The scenario with this shot.
    probability : float
        The share of its runs that met the goal.
    low, high : float
        Wilson's confidence interval of the probability.
    level : float
        How sure that is.
    hits, runs : int
        How many of its runs met the goal, and how many there were.
    table : AimTable
        All points.
    """

    point: dict[str, float]
    scenario: Scenario
    probability: float
    low: float
    high: float
    level: float
    hits: int
    runs: int
    table: AimTable

    def map(
        self, column: str = "probability", x: str | None = None, y: str | None = None, ax: Axes | None = None
    ) -> Axes:
        """Draw a column of the table over two axes, with the best point; see `carom.figures.plot_best_aim`."""
        from carom import figures

        return figures.plot_best_aim(self, column, x=x, y=y, ax=ax)

    def __repr__(self) -> str:
        place = ", ".join(f"{path} = {number:.6g}" for path, number in self.point.items())
        interval = f"{self.low:.4f} to {self.high:.4f} ({self.level:.0%})"
        finished, points = int(self.table.has_outcome.sum()), len(self.table)
        of = f"{points} points" if finished == points else f"{finished} finished points of {points}"
        return f"BestAim: {place}: {self.probability:.4f}, {interval}, {self.hits} of {self.runs} runs; best of {of}"


def best_aim(
    scenario: Scenario,
    aims: Mapping[str, ArrayLike] | Grid,
    goal: Goal,
    noise: ExecutionNoise,
    *,
    runs: int,
    outcomes: Sequence[str],
    seed: int,
    level: float,
    threads: int | None,
    progress: Progress | bool | None,
) -> BestAim:
    """Find the best aim on a grid; see `Scenario.best_aim`."""
    check_level(level)
    grid = aims if isinstance(aims, Grid) else Grid(aims)
    _check(scenario, grid)
    hits, played = (np.zeros(math.prod(grid.shape), dtype=np.int64) for _ in range(2))
    wanted = outcomes_for(goal, outcomes)
    try:
        with telling(progress, "runs") as tell:
            for points in _chunks(len(hits), runs):
                strokes = _strokes(scenario, grid, noise, points, runs, seed)
                watch = _watch(tell, points.start * runs, len(hits) * runs)
                table = scenario.ensemble(strokes, wanted, threads=threads, invalid="keep", progress=watch)
                _refuse_rejected(table, grid)
                count = (len(points), runs)
                met, has_outcome = is_met(table, goal).reshape(count), table.has_outcome.reshape(count)
                is_finished = (table["status"].reshape(count) != "not_run").all(axis=1)
                hits[points.start : points.stop] = np.where(is_finished, met.sum(axis=1), 0)
                played[points.start : points.stop] = np.where(is_finished, has_outcome.sum(axis=1), 0)
                if not table.is_complete:
                    break
    except KeyboardInterrupt:
        # Between two ensembles; what was counted before stands.
        pass
    if not played.any():
        raise KeyboardInterrupt
    return _best(_table_of(scenario, grid, hits, played, level), level)


def _check(scenario: Scenario, grid: Grid) -> None:
    meant(scenario, grid)
    if not grid:
        raise ScenarioError([("aims", "an empty grid: give numbers for a path such as shot.phi_deg")])
    empty = [path for path, numbers in grid.items() if len(numbers) == 0]
    if empty:
        raise ScenarioError([(path, "an axis of 0 numbers gives no grid") for path in empty])


def _chunks(points: int, runs: int) -> Iterator[range]:
    """Give the points in pieces of at most so many runs."""
    at_once = max(1, RUNS_AT_ONCE // max(1, runs))
    return (range(first, min(first + at_once, points)) for first in range(0, points, at_once))


def _strokes(
    scenario: Scenario, grid: Grid, noise: ExecutionNoise, points: range, runs: int, seed: int
) -> dict[str, NDArray[np.float64]]:
    """Give the numbers of each stroke at some points, drawn as `Scenario.success` draws them there.

    A number that is cut off at a bound is not its mean and a scatter which is the same for all means; so each point
    draws from its own distributions. As rows, seed and paths are the same, so is the luck.
    """
    drawn = []
    for point in points:
        here = _point(grid, point)
        shot = scenario.with_values(here)
        varied = noise.around(shot)
        native = native_ensemble(shot, varied, [], runs=runs, design="independent", seed=seed)
        numbers = dict(zip(varied, native.inputs(0, runs), strict=True))
        drawn.append({path: np.full(runs, number) for path, number in here.items()} | numbers)
    return {path: np.concatenate([numbers[path] for numbers in drawn]) for path in drawn[0]}


def _point(grid: Grid, point: int) -> dict[str, float]:
    places = np.unravel_index(point, grid.shape)
    return {path: float(numbers[place]) for (path, numbers), place in zip(grid.items(), places, strict=True)}


def _watch(tell: Progress, before: int, of: int) -> Progress:
    """Give what tells of the runs of one ensemble as of those of all."""
    return lambda done, _: tell(before + done, of)


def _refuse_rejected(table: Ensemble, grid: Grid) -> None:
    rejected = np.flatnonzero(table["status"] == "rejected")
    if len(rejected):
        first = int(rejected[0])
        stroke = ", ".join(f"{path} = {table[path][first]:.6g}" for path in grid)
        message = f"this stroke makes no scenario: {' '.join(table['problem'][first].split())}"
        raise ScenarioError([(stroke, message)])


def _table_of(
    scenario: Scenario, grid: Grid, hits: NDArray[np.int64], played: NDArray[np.int64], level: float
) -> AimTable:
    axes = np.meshgrid(*grid.values(), indexing="ij")
    columns: dict[str, Any] = {path: axis.ravel() for path, axis in zip(grid, axes, strict=True)}
    known = {pair: share(*pair, level) for pair in set(zip(hits.tolist(), played.tolist(), strict=True))}
    shares = np.array([known[pair] for pair in zip(hits.tolist(), played.tolist(), strict=True)])
    columns |= dict(zip(("probability", "low", "high"), shares.T, strict=True))
    return AimTable(scenario, grid, {**columns, "hits": hits, "runs": played})


def _best(table: AimTable, level: float) -> BestAim:
    probability = table["probability"]
    best = np.flatnonzero(probability == np.nanmax(probability))
    places = np.array(np.unravel_index(best, table.grid.shape), dtype=np.float64)
    from_middle = ((places - places.mean(axis=1, keepdims=True)) ** 2).sum(axis=0)
    row = int(best[np.argmin(from_middle)])
    point = _point(table.grid, row)
    probability, low, high = (float(table[name][row]) for name in ("probability", "low", "high"))
    counts = int(table["hits"][row]), int(table["runs"][row])
    return BestAim(point, table.scenario.with_values(point), probability, low, high, level, *counts, table)
