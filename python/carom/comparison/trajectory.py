"""One's own trajectory held against a run: whether it agrees, and if not, what is wrong where."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.columns import ColumnTable, column_of
from carom.comparison.assignment import ColumnNames, assign
from carom.comparison.clock import explain_clock, restart_on_a_full_clock
from carom.comparison.diagnosis import diagnose, explain_break
from carom.comparison.fit import CLOCK, Fit, time_step
from carom.comparison.rows import Rows, read_rows
from carom.comparison.scheme import READINGS, own_reading, try_readings
from carom.comparison.source import listed, open_source
from carom.errors import RunError, ScenarioError, TrajectoryError
from carom.run import Run
from carom.summary import paragraphs

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.comparison.assignment import Assignment
    from carom.comparison.source import Source
    from carom.scenario import Scenario

DEFAULT_TOLERANCE = 1e-6
SAME_STEP = 1e-3
"""Time steps are the same that differ by less than this part."""


@dataclass(frozen=True)
class Difference:
    """The first row of a trajectory that is not where the run is.

    Attributes
    ----------
    row : int
        Its number, from 0.
    where : str
        Where it stands, such as ``line 33``.
    time : float
        Its time.
    ball : str
        The ball that is farthest off in it.
    position, expected : (float, float)
        The ball's place in the trajectory, and in the run.
    distance : float
        How far they are apart.
    """

    row: int
    where: str
    time: float
    ball: str
    position: tuple[float, float]
    expected: tuple[float, float]
    distance: float


@dataclass(frozen=True, repr=False)
class TrajectoryComparison:
    """One's own trajectory held against a run; true when it agrees.

    It agrees when every row is within the tolerance and the rows cover the run: they start at its start, reach its
    end, and leave no hole in a regular time grid.

    Attributes
    ----------
    run : Run
        Carom's run.
    name : str
        The file, or what else the trajectory is.
    columns : dict of str to str
        How its columns were read: what each is (``time``, ``red.x``, ...), and its name or number.
    tolerance : float
        How far a ball may be from its place in the run.
    reasons : list of str
        Why it does not agree: what is missing, the first difference, and what the rows show of its cause.
    notes : list of str
        What was not compared, and what else is worth knowing.
    readings : ColumnTable or None
        For a stepped run: how far the trajectory agrees with each reading of the method.
    """

    run: Run
    name: str
    columns: dict[str, str]
    tolerance: float
    reasons: list[str]
    notes: list[str]
    readings: ColumnTable | None
    _fit: Fit

    def __bool__(self) -> bool:
        return self._fit.agrees

    @property
    def agrees(self) -> bool:
        """Whether the trajectory agrees with the run; the truth of the comparison itself."""
        return self._fit.agrees

    @property
    def balls(self) -> list[str]:
        """The ids of the balls compared."""
        return [self.run.ball_ids[ball] for ball in self._fit.rows.balls]

    @property
    def times(self) -> NDArray[np.float64]:
        """The times of the rows compared, (n_rows,) float64."""
        return self._fit.rows.times[: self._fit.count]

    @property
    def positions(self) -> NDArray[np.float64]:
        """The places in the trajectory, (n_rows, n_balls, 2) float64."""
        return self._fit.rows.places[: self._fit.count]

    @property
    def distances(self) -> NDArray[np.float64]:
        """How far each ball is from its place in the run, (n_rows, n_balls) float64."""
        return self._fit.distances

    @property
    def largest(self) -> float:
        """The largest distance of all."""
        return float(self.distances.max(initial=0.0))

    @cached_property
    def first_difference(self) -> Difference | None:
        """The first row beyond the tolerance, or None."""
        fit, row = self._fit, self._fit.first
        if row is None:
            return None
        ball = int(np.argmax(fit.distances[row]))
        x, y = fit.rows.places[row, ball].tolist()
        carom_x, carom_y = fit.expected[row, ball].tolist()
        return Difference(
            row=row,
            where=fit.rows.where(row),
            time=float(fit.rows.times[row]),
            ball=self.balls[ball],
            position=(x, y),
            expected=(carom_x, carom_y),
            distance=float(fit.distances[row, ball]),
        )

    @cached_property
    def table(self) -> ColumnTable:
        """The rows: ``time``, and per ball ``<id>.x``, ``.y``, ``.carom_x``, ``.carom_y`` and ``.distance``."""
        columns = {"time": self.times}
        for ball, name in enumerate(self.balls):
            for key, places in (("", self.positions), ("carom_", self._fit.expected)):
                columns |= {f"{name}.{key}{axis}": places[:, ball, place] for place, axis in enumerate("xy")}
            columns[f"{name}.distance"] = self.distances[:, ball]
        return ColumnTable(columns)

    @cached_property
    def by_ball(self) -> ColumnTable:
        """A row for each ball: ``ball``, ``rows``, ``within`` the tolerance, ``largest`` distance, its time ``at``."""
        largest = self.distances.argmax(axis=0) if len(self.times) else np.zeros(0, dtype=int)
        return ColumnTable(
            {
                "ball": column_of(self.balls),
                "rows": np.full(len(self.balls), len(self.times)),
                "within": (self.distances <= self.tolerance).sum(axis=0),
                "largest": self.distances.max(axis=0, initial=0.0),
                "at": self.times[largest] if len(largest) else np.full(len(self.balls), np.nan),
            }
        )

    @property
    def verdict(self) -> str:
        """The outcome in one line."""
        compared = f"{len(self.times)} rows of {', '.join(self.balls)}"
        if self:
            return f"agrees: {compared}, within {self.largest:.2g} (tolerance {self.tolerance:g})"
        if self._fit.first is None:
            return f"differs: {compared} are within {self.tolerance:g}, but they do not cover the run"
        within = int((~self._fit.differs).sum())
        return f"differs: {within} of {compared} are within {self.tolerance:g}"

    def plot_distance(self, ax: Axes | None = None, **options: Any) -> Axes:
        """Draw how far each ball is from its place in the run, over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_distance(self, ax=ax, **options)

    def plot_overlay(self, ax: Axes | None = None, **options: Any) -> Axes:
        """Draw the trajectory over the paths of the run; see `carom.figures`."""
        from carom import figures

        return figures.plot_overlay(self, ax=ax, **options)

    def __repr__(self) -> str:
        lines = [("verdict", self.verdict), *(("reason", reason) for reason in self.reasons)]
        lines += [("note", note) for note in self.notes]
        return paragraphs(f"TrajectoryComparison of {self.name}", lines)


def compare_trajectory(
    scenario: Scenario | Run,
    source: Any,
    *,
    columns: ColumnNames | None = None,
    tolerance: float = DEFAULT_TOLERANCE,
    delimiter: str = ",",
    decimal: str = ".",
    duration: float | None = None,
) -> TrajectoryComparison:
    """Hold one's own trajectory against a run.

    The rows may have any times; each is compared with the run at its own. A time may be past the end of the run by a
    billionth of its duration, as a clock that was added up is. A stepped run is compared as far as it goes with a
    trajectory that is longer by up to one step, and that is a reason not to agree.

    Parameters
    ----------
    scenario : Scenario or Run
        What to compare with; a scenario is run with the method that it has.
    source : path-like, ColumnTable, mapping or DataFrame
        The trajectory: a CSV file with or without a header, or columns. Lines at the top of a file that begin with
        ``#`` or ``%`` are passed over, and so are empty lines.
    columns : str, sequence of str or mapping, optional
        The names of its columns: the time, then x and y of each ball in the order of the scenario, as
        ``"t,xr,yr,xb,yb"`` or a sequence; or what each is, as ``"time=t,red.x=xr,red.y=yr"`` or a mapping, where
        balls may be left out. In a file without a header a sequence names all columns by place, an empty name
        leaving one out, and a mapping gives their numbers from 1. Absent: ``time,<id>.x,<id>.y,...``, as Carom
        itself writes them.
    tolerance : float
        How far a ball may be from its place in the run, in the length of the table.
    delimiter : str
        What stands between the columns of a file: one character; a space stands for any run of white space.
    decimal : str
        What stands before the decimals of its numbers: a point or a comma.
    duration : float, optional
        Compare up to this time.

    Raises
    ------
    TrajectoryError
        When the source cannot be read, or its times are not those of this run; every problem has its line and column.
    RunError
        When a run is given that kept no flights, or that is shorter than `duration`.

    Examples
    --------
    >>> import carom
    >>> scenario = carom.load("midterm")
    >>> mine = scenario.run().trajectory([0, 1, 2, 3, 4, 5])
    >>> bool(carom.compare_trajectory(scenario, mine))
    True
    """
    if not 0.0 <= tolerance < np.inf:
        raise ValueError(f"tolerance: must be zero or positive and finite, got {tolerance!r}")
    run = _run_of(scenario, duration)
    opened = open_source(source, delimiter, decimal)
    assignment = assign(opened, columns, run.ball_ids)
    rows = read_rows(opened, assignment)
    partial = duration is not None
    _check_end(run, rows, tolerance, partial=partial)
    fit = Fit(run, rows, _limit(run, rows, duration), tolerance, partial)
    readings = None
    if time_step(run) is not None:
        readings = try_readings(run.scenario, rows, tolerance, duration=duration, partial=partial)
    reasons = [*fit.gaps, *explain_break(fit), *_other_readings(fit, readings, duration), *diagnose(fit)]
    notes = [*_notes(fit, opened, assignment), *_uncovered(fit, readings)]
    return TrajectoryComparison(run, opened.name, assignment.meaning, tolerance, reasons, notes, readings, fit)


def _run_of(scenario: Scenario | Run, duration: float | None) -> Run:
    if not isinstance(scenario, Run):
        return scenario.run(duration=duration, record="all")
    if duration is not None and not 0.0 <= duration < np.inf:
        raise RunError(f"duration: must be zero or positive and finite, got {duration!r}")
    if duration is not None and duration > scenario.end_time and scenario.status != "at_rest":
        raise RunError(f"duration: {duration:g} is after the end of the run at {scenario.end_time:g}")
    scenario.positions(0.0)  # a run that kept no flights says so here
    return scenario


def _limit(run: Run, rows: Rows, duration: float | None) -> float:
    if duration is not None:
        return min(duration, run.end_time)
    return max(run.end_time, float(rows.times[-1])) if run.status == "at_rest" else run.end_time


def _check_end(run: Run, rows: Rows, tolerance: float, *, partial: bool) -> None:
    """Refuse times after the end of the run, but for one step of a stepped run and a part that was asked for."""
    if partial or run.status == "at_rest":
        return
    end = (run.end_time + (time_step(run) or 0.0)) * (1.0 + CLOCK)
    late = np.flatnonzero(rows.times > end)

    def describe(row: int) -> tuple[str, str]:
        return f"{rows.source.name}, {rows.where(row)}", f"t = {rows.times[row]:.10g} is after the run's end"

    if len(late):
        told = explain_clock(run, rows, tolerance, any_factor=True)
        if told is None and time_step(run) is not None:
            told = restart_on_a_full_clock(run.scenario, rows, tolerance)
        if told is not None:
            raise TrajectoryError([(rows.source.name, told)])
        longer = f"the run ends at t = {run.end_time:.10g}; --duration sets another end, or compares a part"
        problems = listed(late, describe, "rows after the run's end", rows.source.name)
        raise TrajectoryError([*problems, (rows.source.name, longer)])


def _other_readings(fit: Fit, readings: ColumnTable | None, duration: float | None) -> list[str]:
    """Say which other readings of the fixed-step method the trajectory agrees with, to its own digits."""
    if readings is None or fit.agrees:
        return []
    scenario, (digits, moved), lead = fit.run.scenario, fit.rounding, "it agrees"
    tolerance = max(fit.tolerance, moved)
    if tolerance > fit.tolerance:
        readings = try_readings(scenario, fit.rows, tolerance, duration=duration, partial=fit.partial)
        lead = f"to its {digits.speak()} it agrees"
    if told := _agreeing_readings(fit.run, readings, lead):
        return told
    told_of_clock = restart_on_a_full_clock(scenario, fit.rows, tolerance)
    return [told_of_clock] if told_of_clock else []


def _agreeing_readings(run: Run, readings: ColumnTable, lead: str) -> list[str]:
    own = own_reading(run.scenario.to_dict()["method"])
    names = [name for name in READINGS if name in readings.names]
    sentences = []
    for row in np.flatnonzero(readings["agrees"]):
        other = {name: readings[name][row] for name in names if readings[name][row] != own[name]}
        if not other:
            continue
        changed = ", ".join(f"{name} = {word}" for name, word in other.items())
        settings = " ".join(f"--set method.{name}={word}" for name, word in other.items())
        sentences.append(f"{lead} with another reading of the method, {changed} ({settings})")
    return sentences


def _notes(fit: Fit, source: Source, assignment: Assignment) -> list[str]:
    run, rows = fit.run, fit.rows
    notes = ["read as " + ", ".join(f"{role} = {name}" for role, name in assignment.meaning.items())]
    if source.names is None:
        notes[0] += ", by number, as there is no header"
    if left_out := [name for name in assignment.left_out if name]:
        notes.append(f"columns not compared: {', '.join(left_out)}")
    absent = [name for ball, name in enumerate(run.ball_ids) if ball not in rows.balls]
    if absent:
        notes.append(f"balls not compared: {', '.join(absent)}")
    if fit.partial:
        notes.append(f"compared up to t = {fit.limit:.10g}: {fit.count} of {len(rows)} rows")
    step = time_step(run)
    if (
        fit.first is not None
        and step is not None
        and fit.spacing is not None
        and abs(fit.spacing - step) > SAME_STEP * step
    ):
        notes.append(
            f"its times go in steps of {fit.spacing:.6g}, the scenario's method in steps of {step:.6g}; "
            f"--dt {fit.spacing:.6g} compares it so"
        )
    if not fit.agrees and step is None and fit.spacing is not None and _may_step(run):
        notes.append(
            f"its times go in steps of {fit.spacing:.6g}; if it was computed with that time step, "
            f"--method stepped --dt {fit.spacing:.6g} compares it with the fixed-step method"
        )
    return notes


def _uncovered(fit: Fit, readings: ColumnTable | None) -> list[str]:
    """Say why readings that have every row within the tolerance do not agree."""
    if readings is None or fit.first is None:
        return []
    names = [name for name in READINGS if name in readings.names]
    rows = np.flatnonzero(~readings["agrees"] & (readings["within"] == readings["rows"]))
    return [
        f"{', '.join(f'{name} = {readings[name][row]}' for name in names)} has all its rows within the tolerance, "
        f"but does not agree: {readings['why'][row]}"
        for row in rows
    ]


def _may_step(run: Run) -> bool:
    """Tell whether the fixed-step method knows how to compute the run's scenario."""
    try:
        run.scenario.with_values({"method": {"kind": "stepped", "dt": 1.0}})
    except ScenarioError:
        return False
    return True
