"""Trajectories that are wrong from their first row on: exchanged columns, other units, another origin."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.comparison.fit import Fit

SMALLEST_SCALE = 0.01
"""A factor nearer to 1 is no other unit."""


def explain_start(fit: Fit) -> list[str]:
    """Say how the places in the first row come from Carom's, where one rule explains them all."""
    found, carom = fit.rows.places[0], fit.expected[0]
    if _near(fit, found[:, ::-1], carom):
        return ["in it x and y are exchanged: are the columns named in the right order?"]
    if names := _exchanged(fit, found, carom):
        return [f"in it {names}: are the columns named in the right order?"]
    if len(found) > 1 and _near(fit, found.reshape(2, -1).T, carom):
        balls = [fit.run.ball_ids[ball] for ball in fit.rows.balls]
        order = ", ".join(f"{name}.{axis}" for axis in "xy" for name in balls)
        return [f"in it the columns stand in the order {order}: are they named in the right order?"]
    factor = float(np.sum(found * carom) / np.sum(carom**2)) if np.any(carom) else 0.0
    if factor > 0.0 and abs(factor - 1.0) > SMALLEST_SCALE and _near(fit, found / factor, carom):
        return [f"in it all places are {factor:.6g} times Carom's: another unit of length?"]
    offset = (found - carom).mean(axis=0)
    if len(found) > 1 and _near(fit, found - offset, carom):
        return [f"in it all balls are moved by ({offset[0]:.6g}, {offset[1]:.6g}): another origin?"]
    return []


def _near(fit: Fit, one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return bool(np.all(np.linalg.norm(one - other, axis=-1) <= fit.tolerance))


def _exchanged(fit: Fit, found: NDArray[np.float64], carom: NDArray[np.float64]) -> str:
    """Name the balls that stand where others should, if every ball stands where some should."""
    names = [fit.run.ball_ids[ball] for ball in fit.rows.balls]
    moved = []
    for place, name in zip(found, names, strict=True):
        distances = np.linalg.norm(carom - place, axis=-1)
        nearest = int(np.argmin(distances))
        if distances[nearest] > fit.tolerance:
            return ""
        if names[nearest] != name:
            moved.append(f"{name} is where Carom has {names[nearest]}")
    return ", ".join(moved[:3])
