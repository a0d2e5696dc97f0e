"""The axes of a gas's figures: their look, labels and units, and what several of them draw."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter

from carom.figures import style
from carom.units import unit_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

SIZE = (6.4, 3.4)
REDUCED = {
    "length": r"$\sigma$",
    "mass": "$m$",
    "time": r"$\sigma\sqrt{m/kT}$",
    "speed": r"$\sqrt{kT/m}$",
    "energy": "$kT$",
}
"""The units of a gas whose discs have diameter, mass and temperature one."""
MEASURED, THEORY, SECOND = style.PALETTE[1], style.PALETTE[0], style.PALETTE[3]
BAND = 0.22  # how opaque the band of errors is


def plain_axes(ax: Axes | None) -> Axes:
    """Make an axes where none is given, and give it the look of curves."""
    ax = style.new_axes(*SIZE) if ax is None else ax
    style.tidy_axes(ax)
    return ax


def finished(ax: Axes, below: str, left: str, columns: int = 2) -> Axes:
    """Label both axes and put the legend above."""
    ax.set_xlabel(below, fontsize=style.LABEL_SIZE)
    ax.set_ylabel(left, fontsize=style.LABEL_SIZE)
    for axis in (ax.xaxis, ax.yaxis):
        if axis.get_scale() == "log":
            axis.set_major_locator(LogLocator(numticks=8))
            axis.set_minor_formatter(NullFormatter())
    style.legend_above(ax, columns)
    return ax


def label(words: str, quantity: str, units: Mapping[str, str]) -> str:
    """Give an axis label: the words, and the unit in brackets where there is one."""
    return f"{words} ({unit})" if (unit := unit_of(units, quantity)) else words


def per(words: str, quantity: str, units: Mapping[str, str]) -> str:
    """Give the label of a density: the words, and per what unit where there is one."""
    return f"{words} (per {unit})" if (unit := unit_of(units, quantity)) else words


def area_of(units: Mapping[str, str]) -> str:
    """Give the unit of an area, or nothing."""
    return f"{unit}²" if (unit := unit_of(units, "length")) else ""


def number(value: float) -> str:
    """Give a number of four digits for a legend, with the sign that axes have.

    >>> number(-2.83788)
    '−2.838'
    """
    return f"{value:.4g}".replace("-", "\N{MINUS SIGN}")


def draw_band(ax: Axes, time: Numbers, values: Numbers, errors: Numbers | None, colour: str = MEASURED) -> None:
    """Draw errors, where there are any, as a band on both sides of a curve."""
    if errors is not None:
        low, high = np.asarray(values) - errors, np.asarray(values) + errors
        ax.fill_between(time, low, high, color=colour, alpha=BAND, linewidth=0, zorder=2.5)


def draw_level(ax: Axes, value: float, words: str) -> None:
    """Draw a value of theory as a dashed line."""
    ax.axhline(value, color=THEORY, linewidth=1.2, linestyle=(0, (5, 2)), label=words, zorder=2)
