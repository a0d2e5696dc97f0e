"""What a time step costs: the stepped method held against the exact run, for many steps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.columns import ColumnTable
from carom.method import Exact, Stepped
from carom.summary import block

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.events import Event
    from carom.run import Run
    from carom.scenario import Scenario

DEFAULT_STEPS = tuple(step * 10.0**power for power in (-1, -2, -3, -4, -5) for step in (1.0, 0.5, 0.3))[:-2]
"""Time steps over four decades."""


@dataclass(frozen=True, repr=False)
class StepComparison:
    """The stepped method against the exact run of the same scenario.

    Attributes
    ----------
    exact : Run
        The exact run.
    table : ColumnTable
        One row for each time step: ``dt``; ``events``, how many the stepped run has; ``missed``, how many of
        the exact run's it lacks and ``extra``, how many it has beside them (by kind, balls and cushion);
        ``time_lost``, the time that balls waited at contacts; ``overlap``, how deep balls were in each
        other at any time, within steps too; ``error``, how far from its exact place the worst ball ends.
    order : float or None
        The slope of log ``error`` against log ``dt``, over the steps whose runs have the exact run's events;
        None where fewer than two do. As the steps go to zero it goes to 1.
    """

    exact: Run
    table: ColumnTable
    order: float | None

    def plot_errors(self, ax: Axes | None = None, **options: Any) -> Axes:
        """Draw the error against the time step; see `carom.figures`."""
        from carom import figures

        return figures.plot_errors(self, ax=ax, **options)

    def __repr__(self) -> str:
        steps = self.table["dt"]
        lines = [("events", str(len(self.exact.events))), ("time steps", f"{len(steps)}")]
        if len(steps):
            best = int(np.argmin(steps))
            lines += [("smallest", f"{steps[best]:.6g}, error {self.table['error'][best]:.3g}")]
        return block("StepComparison", [*lines, ("order", "none" if self.order is None else f"{self.order:.3g}")])


def compare_steps(scenario: Scenario, steps: Iterable[float] = DEFAULT_STEPS, **options: Any) -> StepComparison:
    """Run a scenario exactly and with each of some time steps.

    Parameters
    ----------
    scenario : Scenario
        What to run; its own method, and what it says of keeping results, are set aside.
    steps : iterable of float
        The time steps.
    **options
        What `Scenario.run` takes beside the method: `duration`, `max_events`.

    Returns
    -------
    StepComparison

    Examples
    --------
    >>> import carom
    >>> comparison = carom.compare_steps(carom.load("midterm"), [0.03, 0.01])
    >>> comparison.table["missed"].tolist()
    [1, 0]
    """
    exact = scenario.run(method=Exact(), record="all", **options)
    rows = [_row(exact, scenario.run(method=Stepped(dt), record="events", **options), dt) for dt in steps]
    table = ColumnTable({name: [row[name] for row in rows] for name in ROW})
    return StepComparison(exact, table, _order(table))


ROW = ("dt", "events", "missed", "extra", "time_lost", "overlap", "error")


def _row(exact: Run, stepped: Run, dt: float) -> dict[str, float]:
    wanted, found = _kinds_of(exact.events), _kinds_of(stepped.events)
    end = min(exact.end_time, stepped.end_time)
    apart = np.linalg.norm(stepped.positions([end]) - exact.positions([end]), axis=-1)
    return {
        "dt": float(dt),
        "events": found.total(),
        "missed": (wanted - found).total(),
        "extra": (found - wanted).total(),
        "time_lost": stepped.diagnostics["lost_time"],
        "overlap": stepped.diagnostics["deepest_overlap"],
        "error": float(apart.max(initial=0.0)),
    }


def _kinds_of(events: Iterable[Event]) -> Counter[tuple[Any, ...]]:
    """Count the events of each sort: kind, balls, cushion."""
    return Counter((event.kind, frozenset(event.balls), event.cushion) for event in events)


def _order(table: ColumnTable) -> float | None:
    good = (table["missed"] == 0) & (table["extra"] == 0) & (table["error"] > 0)
    steps: Sequence[float] = table["dt"][good]
    if len(set(steps)) < 2:
        return None
    slope, _ = np.polyfit(np.log(steps), np.log(table["error"][good]), 1)
    return float(slope)
