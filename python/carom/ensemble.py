"""Ensembles: many runs of one scenario with some of its numbers varied."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from carom import _engine
from carom.columns import ColumnTable, column_of, read_only
from carom.errors import ScenarioError
from carom.progress import Progress, telling

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    from carom.run import Run
    from carom.scenario import Scenario
else:
    from carom import arrays as np

Design = Literal["independent", "latin_hypercube", "sobol"]
"""How the rows of what is drawn lie: each by itself, one in each of as many layers, or as even as can be."""

Invalid = Literal["error", "keep"]
"""What to do about rows whose numbers make no scenario: refuse the ensemble, or keep them without outcomes."""

NAMED_AT_MOST = 3
"""So many rejected rows are named in an error."""

WITHOUT_OUTCOMES = ("rejected", "failed", "not_run")
"""The statuses of rows that have no outcomes."""

ON_CLOTH = ("final_spin", "pockets")
"""The outcomes of balls on a cloth only."""

OF_FLIGHTS = ("distance",)
"""The outcomes that the stepped method does not have."""


@dataclass(frozen=True, slots=True)
class Uniform:
    """A number that is drawn anew for each run, each between two bounds equally likely."""

    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Normal:
    """A number that is drawn anew for each run, from what of a normal distribution lies between two bounds."""

    mean: float
    standard_deviation: float
    low: float = -math.inf
    high: float = math.inf


class Grid(Mapping[str, Any]):
    """Each number of each axis with each of those of the others; the last axis varies fastest.

    Parameters
    ----------
    axes : mapping of str to (n,) array_like
        The numbers at each path.

    Examples
    --------
    >>> import carom
    >>> grid = carom.Grid({"balls.red.speed": [4, 5], "balls.red.direction_deg": [40, 50, 60]})
    >>> grid.shape
    (2, 3)
    """

    def __init__(self, axes: Mapping[str, ArrayLike]) -> None:
        self._axes = {path: read_only(_numbers(path, axis)) for path, axis in axes.items()}

    @property
    def shape(self) -> tuple[int, ...]:
        """How many numbers each axis has: an outcome takes the shape of the grid by ``.reshape(grid.shape)``."""
        return tuple(len(axis) for axis in self._axes.values())

    def __getitem__(self, path: str) -> NDArray[np.float64]:
        return self._axes[path]

    def __iter__(self) -> Iterator[str]:
        return iter(self._axes)

    def __len__(self) -> int:
        return len(self._axes)

    def __repr__(self) -> str:
        return f"Grid: {' x '.join(map(str, self.shape))} of {', '.join(self)}"


Varied = Mapping[str, "ArrayLike | Uniform | Normal"]
"""What is varied: at each path a number for each run, or a distribution."""


class Ensemble(ColumnTable):
    """The outcomes of many runs of one scenario, a row for each run; see `Scenario.ensemble`.

    The columns are the varied numbers, by their paths; ``status``, the word of each run, or ``rejected`` (the numbers
    make no scenario), ``failed`` (a broken invariant) or ``not_run`` (the ensemble was ended early); the outcomes;
    and, where any row was rejected or failed, ``problem``, which says why. Outcomes of rows without any are NaN,
    counts −1 (absent in what pandas, Arrow and CSV get), and pockets None.

    Attributes
    ----------
    is_complete : bool
        Whether every row was run.
    grid : Grid or None
        The grid that the rows are on, where they are on one.
    """

    is_complete: bool
    grid: Grid | None

    def __init__(
        self,
        scenario: Scenario,
        native: _engine.Ensemble,
        columns: Mapping[str, Any],
        *,
        is_complete: bool,
        grid: Grid | None = None,
    ) -> None:
        super().__init__(columns)
        self._scenario = scenario
        self._native = native
        self.is_complete = is_complete
        self.grid = grid

    @property
    def scenario(self) -> Scenario:
        """The scenario that was varied."""
        return self._scenario

    def scenario_of(self, row: int) -> Scenario:
        """Give the scenario of one row, to look at its run; it has the bits of that row.

        Raises
        ------
        ScenarioError
            When the numbers of the row make no scenario.
        """
        return type(self._scenario)._of(self._native.scenario(row))

    @property
    def has_outcome(self) -> NDArray[np.bool_]:
        """Which rows have outcomes, (n_runs,): those that were neither rejected nor failed nor left."""
        found: NDArray[np.bool_] = ~np.isin(self["status"], WITHOUT_OUTCOMES)
        return found

    def map(self, column: str, x: str | None = None, y: str | None = None, ax: Axes | None = None) -> Axes:
        """Draw a column of an ensemble on a grid of two axes, a cell for each run; see `carom.figures.plot_map`.

        Examples
        --------
        >>> import carom
        >>> grid = carom.Grid({"balls.red.speed": [4, 5], "balls.red.direction_deg": [40, 50, 60]})
        >>> axes = carom.load("midterm").ensemble(grid, ["events"]).map("events.ball_ball")
        >>> axes.get_xlabel(), [text.get_text() for text in axes.get_legend().get_texts()]
        ('balls.red.direction_deg', ['1', '2'])
        """
        from carom import figures

        return figures.plot_map(self, column, x=x, y=y, ax=ax)

    def _exported(self) -> dict[str, NDArray[Any]]:
        columns, counts = self.to_dict(), (name for name, meaning in self._native.columns() if meaning == "count")
        return {**columns, **{name: np.ma.masked_equal(columns[name], -1) for name in counts}}


def ensemble(
    scenario: Scenario,
    varied: Varied | Grid,
    outcomes: Sequence[str],
    functions: Mapping[str, Callable[[Run], Any]],
    *,
    runs: int | None,
    design: Design,
    seed: int,
    threads: int | None,
    invalid: Invalid,
    progress: Progress | bool | None,
    equilibrate: float,
    sample_interval: float | None,
) -> Ensemble:
    """Run many variations of a scenario; see `Scenario.ensemble`."""
    if isinstance(outcomes, str):
        raise TypeError(f"outcomes: expected a list of names, got the text {outcomes!r}; give [{outcomes!r}]")
    if invalid not in ("error", "keep"):
        raise ValueError(f'invalid: must be "error" or "keep", got {invalid!r}')
    native = native_ensemble(
        scenario,
        varied,
        outcomes,
        runs=runs,
        design=design,
        seed=seed,
        equilibrate=equilibrate,
        sample_interval=sample_interval,
    )
    with telling(progress, "runs") as tell:
        numbers, codes, words, problems, is_interrupted = native.run(
            0, native.runs, threads, lambda done: tell(done, native.runs)
        )
    rejected = [(row, text) for row, text in problems if words[codes[row]] == "rejected"]
    if rejected and invalid == "error":
        raise _rejected(rejected, native.runs)
    status = _words(words)[codes]
    columns: dict[str, Any] = dict(zip(varied, native.inputs(0, native.runs), strict=True))
    has_outcomes = ~np.isin(status, WITHOUT_OUTCOMES)
    columns |= {"status": status, **outcomes_of(scenario, native, numbers, has_outcomes)}
    is_complete = not is_interrupted and "not_run" not in words
    if functions:
        rows = np.flatnonzero(has_outcomes).tolist() if is_complete else []
        with telling(progress, "functions") as tell:
            values, is_reached = _called(native, scenario, functions, rows, tell)
        is_complete &= is_reached
        columns |= {name: column_of(column) for name, column in values.items()}
    if problems:
        columns["problem"] = np.full(native.runs, None, dtype=object)
        columns["problem"][[row for row, _ in problems]] = [text for _, text in problems]
    grid = varied if isinstance(varied, Grid) else None
    return Ensemble(scenario, native, columns, is_complete=is_complete, grid=grid)


def native_ensemble(
    scenario: Scenario,
    varied: Varied | Grid,
    outcomes: Sequence[str],
    *,
    runs: int | None,
    design: str,
    seed: int,
    equilibrate: float = 0.0,
    sample_interval: float | None = None,
) -> _engine.Ensemble:
    """Give the engine's ensemble, checked."""
    is_grid = isinstance(varied, Grid)
    sources = [(path, *_source(path, numbers, is_grid=is_grid)) for path, numbers in varied.items()]
    return _engine.Ensemble(
        scenario._native, sources, runs, design, seed, list(outcomes), float(equilibrate), sample_interval
    )


def columns_of(scenario: Scenario, grid: Grid) -> dict[str, list[str]]:
    """Give the columns of each outcome that a scenario has, but those of pairs."""
    is_stepped = scenario.to_dict().get("method", {}).get("kind") == "stepped"
    missing = {*(() if scenario.is_on_cloth else ON_CLOTH), *(OF_FLIGHTS if is_stepped else ())}
    names = [name for name in _engine.OUTCOMES if name not in missing]
    made = {name: native_ensemble(scenario, grid, [name], runs=None, design="independent", seed=0) for name in names}
    return {name: [column for column, _ in native.columns()] for name, native in made.items()}


def _source(path: str, numbers: Any, *, is_grid: bool) -> tuple[str, NDArray[np.float64]]:
    """Give the engine's word for what stands at a path, and its numbers."""
    match numbers:
        case Uniform(low, high):
            return "uniform", np.array([low, high], dtype=np.float64)
        case Normal(mean, standard_deviation, low, high):
            bounds = [] if (low, high) == (-math.inf, math.inf) else [low, high]
            return "normal", np.array([mean, standard_deviation, *bounds], dtype=np.float64)
        case _:
            return "axis" if is_grid else "given", _numbers(path, numbers)


def _numbers(path: str, numbers: ArrayLike) -> NDArray[np.float64]:
    try:
        array = np.array(numbers, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{path}: expected numbers, a Uniform or a Normal, got {numbers!r}") from None
    if array.ndim != 1:
        raise ValueError(f"{path}: must have the shape (n_runs,), got {array.shape}")
    return array


def outcomes_of(
    scenario: Scenario,
    native: _engine.Ensemble,
    numbers: Sequence[NDArray[np.float64]],
    has_outcomes: NDArray[np.bool_],
) -> dict[str, NDArray[Any]]:
    """Give the columns of outcomes by name, each as what it is."""
    pockets = _words([*(pocket["id"] for pocket in scenario.outline()["pockets"]), None])
    columns: dict[str, NDArray[Any]] = {}
    for place, (name, meaning) in enumerate(native.columns()):
        column = numbers[place]
        if meaning == "quantity":
            columns[name] = column
            continue
        whole = np.where(has_outcomes, column, -1.0).astype(np.int64)
        columns[name] = pockets[whole] if meaning == "pocket" else whole
    return columns


def _called(
    native: _engine.Ensemble,
    scenario: Scenario,
    functions: Mapping[str, Callable[[Run], Any]],
    rows: Sequence[int],
    tell: Progress,
) -> tuple[dict[str, list[Any]], bool]:
    """Call functions of the runs of some rows, which are computed once more for them, one by one.

    Ctrl-C ends it, as does what is told: the values of rows not reached are None, and whether all were comes with them.
    """
    values: dict[str, list[Any]] = {name: [None] * native.runs for name in functions}
    try:
        for done, row in enumerate(rows):
            if tell(done, len(rows)):
                return values, False
            run = type(scenario)._of(native.scenario(row)).run()
            given = [_given(name, function, run, row) for name, function in functions.items()]
            for column, value in zip(values.values(), given, strict=True):
                column[row] = value
    except KeyboardInterrupt:
        return values, False
    return values, True


def _given(name: str, function: Callable[[Run], Any], run: Run, row: int) -> Any:
    try:
        return function(run)
    except Exception as error:
        raise RuntimeError(f"functions: {name} raised {type(error).__name__} for run {row}: {error}") from error


def _words(words: Sequence[str | None]) -> NDArray[Any]:
    column = np.empty(len(words), dtype=object)
    column[:] = words
    return column


def _rejected(rejected: Sequence[tuple[int, str]], runs: int) -> ScenarioError:
    """Give the error that says which rows make no scenario, and why the first of them do not."""
    problems = [(f"run {row}", " ".join(text.split())) for row, text in rejected[:NAMED_AT_MOST]]
    more = len(rejected) - len(problems)
    said = f"{len(rejected)} of {runs} make no scenario" + (f", {more} more than are named here" if more else "")
    return ScenarioError([("runs", f'{said}; invalid="keep" leaves them without outcomes'), *problems])
