"""A trajectory held against every reading of the fixed-step method."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

from carom.columns import ColumnTable, column_of
from carom.comparison.fit import Fit

if TYPE_CHECKING:
    from carom.comparison.rows import Rows
    from carom.scenario import Scenario

READINGS = {"after_hit": ("wait", "restart"), "normal": ("before", "contact"), "last_step": ("short", "full")}
"""The options of `Stepped` that are readings, each with its default first."""


def try_readings(
    scenario: Scenario, rows: Rows, tolerance: float, *, duration: float | None, partial: bool
) -> ColumnTable:
    """Compare a trajectory with the runs of all readings of a stepped scenario.

    Returns
    -------
    ColumnTable
        A row for each reading: ``after_hit``, ``normal``, ``last_step``; ``rows``, how many rows the trajectory has
        up to the run's end, and ``within``, how many of them are within the tolerance; ``first``, where the first
        other one stands, or None; ``largest``, the largest distance; ``agrees``; ``why``, for one that has all rows
        within and does not agree, what they lack.
    """
    own = scenario.to_dict()["method"]
    # With a given number of steps there is no last step to read in two ways.
    free = {name: words for name, words in READINGS.items() if not ("steps" in own and name == "last_step")}
    found: list[dict[str, Any]] = []
    for words in product(*free.values()):
        reading = dict(zip(free, words, strict=True))
        run = scenario.with_values({"method": {**own, **reading}}).run(duration=duration, record="all")
        fit = Fit(run, rows, run.end_time, tolerance, partial)
        found.append({**reading, **_measures(fit)})
    return ColumnTable({name: column_of([row[name] for row in found]) for name in found[0]})


def own_reading(method: dict[str, Any]) -> dict[str, str]:
    """Give the readings of a stepped method, defaults filled in."""
    return {name: str(method.get(name, words[0])) for name, words in READINGS.items()}


def _measures(fit: Fit) -> dict[str, Any]:
    return {
        "rows": fit.count,
        "within": int((~fit.differs).sum()),
        "first": None if fit.first is None else fit.rows.where(fit.first),
        "largest": float(fit.distances.max(initial=0.0)),
        "agrees": fit.agrees,
        "why": "; ".join(fit.gaps) if fit.first is None else "",
    }
