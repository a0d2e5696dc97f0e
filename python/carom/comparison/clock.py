"""Clocks that are not Carom's: of another unit, counting steps, begun late, or going on in full where a step is cut."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.comparison.fit import CLOCK, time_step

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.comparison.rows import Rows
    from carom.run import Run
    from carom.scenario import Scenario

LEAST_ROWS = 4
"""So many rows in which a ball has moved make another clock more than chance."""


def explain_clock(run: Run, rows: Rows, tolerance: float, *, any_factor: bool) -> str | None:
    """Say which plain change of the clock makes the first rows agree, if one does and they do not as they are.

    Any factor is tried where no ball can be taken for one of another speed: where times are past the run's end.
    """
    best, told = max(_leading(run, rows, rows.times, tolerance), LEAST_ROWS - 1), None
    for times, words in _clocks(run, rows, any_factor=any_factor):
        count = _leading(run, rows, times, tolerance)
        if count > best:
            best, told = count, words
    if told is None:
        return None
    until = "every row agrees" if best == len(rows) else f"the rows agree up to {rows.where(best - 1)}"
    return f"{told} With that set right, {until}"


def _clocks(run: Run, rows: Rows, *, any_factor: bool) -> list[tuple[NDArray[np.float64], str]]:
    """Give the times as other clocks would have them, each with what that clock does; the plainest come first."""
    first, step = float(rows.times[0]), time_step(run)
    elapsed, late = rows.times - first, "" if first == 0.0 else f", from {first:.6g} on"
    clocks = [(elapsed, f"its clock starts at {first:.6g}, Carom's at 0.")]
    clocks.append((elapsed / 1000.0, f"its times are 1000 times Carom's{late}: milliseconds?"))
    if step is not None:
        twice = "as when the time step is multiplied twice"
        clocks.append((elapsed * step, f"its times count steps{late}; Carom's are {step:.6g} times that."))
        clocks.append((elapsed / step, f"its times are {step:.6g} times Carom's{late}, {twice}."))
    if any_factor and (factor := _estimate(run, rows)):
        others = "another unit of time, or the number of the step?"
        clocks.append((elapsed * factor, f"its times are {1.0 / factor:.6g} times Carom's{late}: {others}"))
    return clocks


def _estimate(run: Run, rows: Rows) -> float | None:
    """Give the part of its own time that Carom's run takes for the second row, were all balls on straight ways."""
    velocities = run.velocities(0.0)[list(rows.balls), :2]
    square = float(np.sum(velocities**2))
    if len(rows) < LEAST_ROWS or square == 0.0:
        return None
    passed = float(np.sum(velocities * (rows.places[1] - rows.places[0]))) / square
    factor = passed / float(rows.times[1] - rows.times[0])
    return factor if factor > 0.0 else None


def _leading(run: Run, rows: Rows, times: NDArray[np.float64], tolerance: float) -> int:
    """Count the rows up to the first that would differ with these times, if a ball moves in enough of them."""
    end = run.end_time + (time_step(run) or 0.0)
    expected = run.positions(np.clip(times, 0.0, run.end_time))[:, list(rows.balls), :2]
    agree = np.linalg.norm(rows.places - expected, axis=-1).max(axis=1) <= tolerance
    agree &= (times >= 0.0) & (times <= end * (1.0 + CLOCK))
    count = len(agree) if agree.all() else int(np.argmin(agree))
    moved = np.linalg.norm(expected[:count] - expected[0], axis=-1).max(axis=1, initial=0.0) > 10.0 * tolerance
    return count if moved.sum() >= LEAST_ROWS - 1 else 0


def restart_on_a_full_clock(scenario: Scenario, rows: Rows, tolerance: float) -> str | None:
    """Find that rows are those of ``after_hit = restart``, step by step, though the times count every step in full."""
    method, count = scenario.to_dict()["method"], len(rows) - 1
    step = float(method["dt"])
    if count < LEAST_ROWS or not np.allclose(rows.times[:-1], step * np.arange(count), rtol=0.0, atol=CLOCK * step):
        return None
    for normal in ("before", "contact"):
        kept = {key: value for key, value in method.items() if key != "last_step"}
        changed = {**kept, "after_hit": "restart", "normal": normal, "steps": count}
        run = scenario.with_values({"method": changed}).run(record="all")
        if run.steps is not None and _in_step(run, run.steps["time"], rows, tolerance):
            also = "" if normal == "before" else " --set method.normal=contact"
            return (
                f"row by row it is at the places of after_hit = restart, normal = {normal}, but its clock goes on by "
                f"{step:.6g} in every step, and a step that a hit cuts short takes less time; with such times "
                f"--set method.after_hit=restart{also} compares it"
            )
    return None


def _in_step(run: Run, times: NDArray[np.float64], rows: Rows, tolerance: float) -> bool:
    """Tell whether the rows are the steps of a run, of which some are cut short; the last may be shorter."""
    if len(times) != len(rows) or times[-2] >= rows.times[-2] - CLOCK * rows.times[-1]:
        return False
    times = times.copy()
    times[-1] = min(times[-1], times[-2] + rows.times[-1] - rows.times[-2])
    apart = rows.places - run.positions(times)[:, list(rows.balls), :2]
    return bool(np.all(np.linalg.norm(apart, axis=-1) <= tolerance))
