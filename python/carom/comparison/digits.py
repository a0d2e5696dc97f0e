"""How many digits the numbers of a trajectory have, and how far leaving out the others moves a place."""

from __future__ import annotations

from dataclasses import dataclass
from math import floor, log10, sqrt
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

LEAST_VALUES = 8
"""Fewer different numbers may have few digits by chance."""
FULL = 12
"""Numbers with so many digits are taken to be whole."""
SAME_GRID = 1e-9


@dataclass(frozen=True)
class Digits:
    """The digits of some numbers: those of the number that has most, significant ones and those after the point.

    Attributes
    ----------
    significant, decimals : int
        How many; both zero where numbers are whole, or too few to tell.
    half : float
        Half of the last significant digit of the largest number: how far rounding moves one.
    """

    significant: int = 0
    decimals: int = 0
    half: float = 0.0

    def speak(self) -> str:
        """Say how many there are, as numbers with a fixed point are told from others."""
        fixed = abs(0.5 * 10.0**-self.decimals - self.half) <= 0.1 * self.half
        count, what = (self.decimals, "decimal") if fixed else (self.significant, "significant digit")
        return f"{count} {what}{'' if count == 1 else 's'}"


def count_digits(values: NDArray[np.float64]) -> Digits:
    """Count the digits of finite numbers."""
    significant, decimals = 0, 0
    different = np.unique(np.abs(values))
    if len(different) < LEAST_VALUES:
        return Digits()
    for value in different:
        mantissa, _, exponent = repr(float(value)).partition("e")
        whole, _, fraction = mantissa.partition(".")
        fraction = fraction.rstrip("0")
        digits = (whole + fraction).lstrip("0") if fraction else whole.strip("0")
        significant = max(significant, len(digits))
        decimals = max(decimals, len(fraction) - int(exponent or 0))
        if significant >= FULL:
            return Digits()
    return Digits(significant, decimals, 0.5 * 10.0 ** (floor(log10(different[-1])) + 1 - significant))


def find_rounding(times: NDArray[np.float64], places: NDArray[np.float64], fastest: float) -> tuple[Digits, float]:
    """Give the digits of places, and how far rounding may have moved a ball.

    The times are taken to be rounded too, unless they lie on a grid.

    Parameters
    ----------
    times, places : arrays
        The numbers.
    fastest : float
        The largest speed of a ball.
    """
    digits = count_digits(places)
    moved = sqrt(2.0) * digits.half
    if moved and not _on_a_grid(times):
        moved += fastest * count_digits(times).half
    return digits, moved


def fitting_tolerance(distance: float) -> float:
    """Give the next of 1, 2 and 5 times a power of ten that is no smaller."""
    power = 10.0 ** floor(log10(distance))
    return next(float(f"{step * power:.1g}") for step in (1, 2, 5, 10) if step * power >= distance)


def _on_a_grid(times: NDArray[np.float64]) -> bool:
    """Tell whether all times but the last are multiples of one step."""
    inner = times[:-1]
    if len(inner) < 3:
        return False
    step = float(np.median(np.diff(inner)))
    return bool(np.all(np.abs(inner - np.round(inner / step) * step) <= SAME_GRID * times[-1]))
