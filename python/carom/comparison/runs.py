"""Two runs side by side: what first goes otherwise, and how far their balls come apart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.columns import ColumnTable, column_of, read_only
from carom.comparison.parting import Parting, find_parting
from carom.errors import RunError
from carom.run import Run
from carom.scenario import Scenario
from carom.summary import paragraphs

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_NAMED = 8
SAMPLES = 1000
THRESHOLDS = (1e-12, 1e-9, 1e-6, 1e-3)
"""Distances for which is said when they are first exceeded."""

WORDS = ("title", "description")
"""What a scenario says of itself, without effect on its run."""


@dataclass(frozen=True, repr=False)
class RunComparison:
    """Two runs side by side, up to the earlier of their ends; true when they are the same, to the last bit.

    Attributes
    ----------
    a, b : Run
        The runs.
    names : (str, str)
        What they are called.
    balls : list of str
        The balls that are in both, by id.
    samples : int
        How many evenly spread times they are compared at, beside those of their events.
    """

    a: Run
    b: Run
    names: tuple[str, str]
    balls: list[str]
    samples: int

    @property
    def same_bits(self) -> bool:
        """Whether both end at the same time in bit for bit the same state, of balls of the same ids."""
        same_end = self.a.end_time == self.b.end_time and self.a.ball_ids == self.b.ball_ids
        return same_end and self.a.digest is not None and self.a.digest == self.b.digest

    @property
    def only_in_a(self) -> list[str]:
        """The balls that are not in `b`."""
        return [name for name in self.a.ball_ids if name not in self.balls]

    @property
    def only_in_b(self) -> list[str]:
        """The balls that are not in `a`."""
        return [name for name in self.b.ball_ids if name not in self.balls]

    @property
    def end_time(self) -> float:
        """The earlier of their ends; balls at rest stay where they are, so the end of a run at rest is none."""
        ends = {self.a.end_time, self.b.end_time}
        return min((run.end_time for run in (self.a, self.b) if run.status != "at_rest"), default=max(ends))

    @cached_property
    def changes(self) -> ColumnTable:
        """What differs between the two scenarios: ``value`` by its path, and what it is in ``a`` and ``b``, or None."""
        one, two = (dict(_flat(run.scenario.to_dict())) for run in (self.a, self.b))
        paths = [path for path in one | two if one.get(path) != two.get(path) and path not in WORDS]
        return ColumnTable(
            {
                "value": column_of(paths, words=True),
                "a": column_of([one.get(path) for path in paths], words=True),
                "b": column_of([two.get(path) for path in paths], words=True),
            }
        )

    @cached_property
    def parting(self) -> Parting:
        """How long their events are the same, and the first one that is not."""
        return find_parting(self.a, self.b, self.balls, self.end_time)

    @cached_property
    def times(self) -> NDArray[np.float64]:
        """The times compared, (n_times,) float64: evenly spread ones, and those of all events."""
        even = np.linspace(0.0, self.end_time, self.samples)
        events = [np.asarray(run.events["time"], dtype=np.float64) for run in (self.a, self.b)]
        times = np.unique(np.concatenate([even, *events]))
        chosen: NDArray[np.float64] = read_only(times[times <= self.end_time])
        return chosen

    @cached_property
    def distances(self) -> NDArray[np.float64]:
        """How far each ball is in `b` from its place in `a`, (n_times, n_balls) float64."""
        apart = _places(self.a, self.balls, self.times) - _places(self.b, self.balls, self.times)
        distances: NDArray[np.float64] = read_only(np.hypot(apart[..., 0], apart[..., 1]))
        return distances

    @property
    def largest(self) -> float:
        """The largest distance of all."""
        return float(np.nanmax(self.distances, initial=0.0))

    @cached_property
    def table(self) -> ColumnTable:
        """The distances over time: ``time``, and per ball ``<id>.distance``."""
        distances = {f"{name}.distance": self.distances[:, ball] for ball, name in enumerate(self.balls)}
        return ColumnTable({"time": self.times, **distances})

    @cached_property
    def by_ball(self) -> ColumnTable:
        """A row for each ball: ``ball``, ``largest`` distance, its time ``at``, and ``over_<d>``: first beyond d.

        The times are those of `times`; one that never comes is NaN.
        """
        found = np.nan_to_num(self.distances)
        columns = {
            "ball": column_of(self.balls),
            "largest": found.max(axis=0, initial=0.0),
            "at": self.times[found.argmax(axis=0)],
        }
        columns |= {f"over_{threshold:g}": self._first_over(threshold) for threshold in THRESHOLDS}
        return ColumnTable(columns)

    def first_over(self, distance: float) -> float | None:
        """Give the first of `times` at which a ball is farther than `distance` from its place, or None."""
        times = self._first_over(distance)
        return None if np.all(np.isnan(times)) else float(np.nanmin(times))

    def _first_over(self, distance: float) -> NDArray[np.float64]:
        over = self.distances > distance
        return np.where(over.any(axis=0), self.times[over.argmax(axis=0)], np.nan)

    def __bool__(self) -> bool:
        return self.same_bits and self.largest == 0.0

    @property
    def verdict(self) -> str:
        """The outcome in one line."""
        if self:
            return f"the same bits: every ball ends where it does in the other, at t = {self.end_time:.6g}"
        same = self.parting.event is None
        events = "the same events in the same order, ball by ball" if same else "the events differ"
        return f"{events}; the largest distance is {self.largest:.3g}, up to t = {self.end_time:.6g}"

    @property
    def notes(self) -> list[str]:
        """What is not the same in both beside their motion."""
        notes = [
            f"only in {name}: {_named(balls)}"
            for name, balls in zip(self.names, (self.only_in_a, self.only_in_b), strict=True)
            if balls
        ]
        for name, run in zip(self.names, (self.a, self.b), strict=True):
            if run.end_time > self.end_time:
                notes.append(f"{name} goes on to t = {run.end_time:.6g} ({run.status}); not compared")
        if self.a.physics_version != self.b.physics_version:
            notes.append(f"made with physics versions {self.a.physics_version} and {self.b.physics_version}")
        rows = list(zip(*self.changes.to_dict().values(), strict=True))
        notes += [f"{path}: {_shown(one)} | {_shown(two)}" for path, one, two in rows[:MOST_NAMED]]
        return [*notes, f"and {len(rows) - MOST_NAMED} more values"] if len(rows) > MOST_NAMED else notes

    def plot_distance(self, ax: Axes | None = None, **options: Any) -> Axes:
        """Draw how far the balls are apart, over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_distance(self, ax=ax, **options)

    def plot_overlay(self, ax: Axes | None = None, **options: Any) -> Axes:
        """Draw the paths of one run over those of the other; see `carom.figures`."""
        from carom import figures

        return figures.plot_overlay(self, ax=ax, **options)

    def __repr__(self) -> str:
        lines = [("verdict", self.verdict), ("events", self.parting.speak(self.names))]
        far = self.by_ball["largest"]
        for ball in np.argsort(-far, kind="stable")[:MOST_NAMED]:
            at = self.by_ball["at"][ball]
            lines.append((self.balls[ball], f"largest distance {far[ball]:.3g} at t = {at:.6g}"))
        if len(self.balls) > MOST_NAMED:
            lines.append(("...", f"and {len(self.balls) - MOST_NAMED} balls with smaller ones"))
        return paragraphs(
            f"RunComparison of {' and '.join(self.names)}", [*lines, *(("note", note) for note in self.notes)]
        )


def compare(
    a: Scenario | Run, b: Scenario | Run, *, names: tuple[str, str] = ("a", "b"), samples: int = SAMPLES
) -> RunComparison:
    """Hold two runs side by side; scenarios are run as they are.

    Balls are matched by their ids. Tables and radii may differ; what does is in the notes.

    Parameters
    ----------
    a, b : Scenario or Run
        What to compare.
    names : (str, str)
        What to call them.
    samples : int
        How many evenly spread times to compare them at, beside those of their events.

    Raises
    ------
    RunError
        When no ball is in both, or when a run kept no flights.
    TypeError
        When one of the two is neither a scenario nor a run.

    Examples
    --------
    >>> import carom
    >>> scenario = carom.load("midterm")
    >>> comparison = carom.compare(scenario, scenario.with_values({"balls.red.velocity[0]": 3.1}))
    >>> comparison.parting.event.kind, comparison.first_over(1e-6) > 0
    ('ball_cushion', True)
    """
    if samples < 2:
        raise ValueError(f"samples: must be at least 2, got {samples!r}")
    one, two = (_run_of(each, name) for each, name in zip((a, b), names, strict=True))
    balls = [name for name in one.ball_ids if name in two.ball_ids]
    if not balls:
        raise RunError(
            f"no ball is in both: {names[0]} has {_named(one.ball_ids)}; {names[1]} has {_named(two.ball_ids)}"
        )
    return RunComparison(one, two, names, balls, samples)


def _run_of(given: Scenario | Run, name: str) -> Run:
    if isinstance(given, Scenario):
        return given.run(record="all")
    if not isinstance(given, Run):
        raise TypeError(f"{name}: must be a Scenario or a Run, got {given!r}; carom.load and carom.load_run read files")
    try:
        given.positions(0.0)
    except RunError as error:
        raise RunError(f"{name}: {error}") from None
    return given


def _places(run: Run, balls: list[str], times: NDArray[np.float64]) -> NDArray[np.float64]:
    return run.positions(times)[:, [run.ball_ids.index(name) for name in balls], :2]


def _flat(values: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Give every single value of a scenario with its path, balls by their ids."""
    if isinstance(values, Mapping):
        for name, value in values.items():
            yield from _flat(value, f"{path}.{name}" if path else str(name))
    elif isinstance(values, list):
        for place, value in enumerate(values):
            named = isinstance(value, Mapping) and "id" in value and path == "balls"
            yield from _flat(value, f"{path}.{value['id']}" if named else f"{path}[{place}]")
    else:
        yield path, values


def _named(names: list[str]) -> str:
    return ", ".join(names[:MOST_NAMED]) + (", ..." if len(names) > MOST_NAMED else "")


def _shown(value: Any) -> str:
    return "absent" if value is None else str(value)
