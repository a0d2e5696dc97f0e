"""Rows that are right but at the wrong time: lost, doubled, or with a clock that is set wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from carom.comparison.fit import Fit

MOST_ROWS_SHIFTED = 3
LEAST_ROWS = 4
"""So many rows make a shift more than chance."""


def find_shift(fit: Fit) -> str | None:
    """Say by how much the rows from the first that differs on are shifted in time, where all of them are."""
    assert fit.first is not None
    start = f"from {fit.rows.where(fit.first)} on every row" if fit.first else "every row"
    if fit.first and fit.spacing is not None:
        for count in range(1, MOST_ROWS_SHIFTED + 1):
            for sign in (1, -1):
                if _fits_rows(fit, sign * count):
                    return f"{start} agrees with Carom {_speak_of_rows(sign * count)}"
    shift = _estimate(fit)
    if shift is None or not _fits_later(fit, shift):
        return None
    words = "earlier" if shift < 0 else "later"
    return f"{start} is at Carom's place {abs(shift):.6g} {words} in time: its clock is off by that"


def _speak_of_rows(count: int) -> str:
    number = "one row" if abs(count) == 1 else f"{abs(count)} rows"
    words = "lost" if count > 0 else "too many"
    return f"{number} {'later' if count > 0 else 'earlier'}, as when {number} before it {_are(count)} {words}"


def _are(count: int) -> str:
    return "is" if abs(count) == 1 else "are"


def _fits_rows(fit: Fit, count: int) -> bool:
    """Tell whether all rows from the first that differs on are what the run has so many rows later."""
    rows = np.arange(fit.first or 0, fit.count)
    rows = rows[(rows + count >= 0) & (rows + count < fit.count)]
    if len(rows) < LEAST_ROWS:
        return False
    apart = fit.rows.places[rows] - fit.expected[rows + count]
    return bool(np.all(np.linalg.norm(apart, axis=-1) <= fit.tolerance))


def _fits_later(fit: Fit, shift: float) -> bool:
    """Tell whether the run `shift` later has the places of all rows from the first that differs on."""
    times = fit.rows.times[fit.first : fit.count] + shift
    inside = (times >= 0.0) & (times <= fit.run.end_time)
    # Rows whose time is outside the run after the shift say nothing; most have to say something.
    if inside.sum() < max(LEAST_ROWS, 0.5 * len(times)):
        return False
    found = fit.rows.places[fit.first : fit.count][inside]
    expected = fit.run.positions(times[inside])[:, list(fit.rows.balls), :2]
    return bool(np.all(np.linalg.norm(found - expected, axis=-1) <= fit.tolerance))


def _estimate(fit: Fit) -> float | None:
    """Give the shift in time that explains the first row that differs, were all balls on their straight ways."""
    row = fit.first
    assert row is not None
    time = min(float(fit.rows.times[row]), fit.run.end_time)
    velocities = fit.run.velocities(time)[list(fit.rows.balls), :2]
    squares = float(np.sum(velocities**2))
    return float(np.sum(velocities * fit.offsets[row])) / squares if squares > 0.0 else None
