"""Figures of gases of discs: what is measured of them, beside what theory says.

Each takes plain arrays, draws on `ax` or on a new figure of its own, and returns where it drew. `units` names the units
of length, time, mass and so on at the axes; without it they are those of a gas whose discs have diameter, mass and
temperature one.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from carom.figures import style
from carom.figures.gas_axes import (
    MEASURED,
    REDUCED,
    SIZE,
    THEORY,
    area_of,
    draw_band,
    finished,
    label,
    number,
    per,
    plain_axes,
)
from carom.figures.gas_discs import discs
from carom.figures.gas_time import compressibility, cooling, diffusion, h_function, psi6

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

__all__ = [
    "compressibility",
    "cooling",
    "diffusion",
    "discs",
    "free_times",
    "h_function",
    "profile",
    "psi6",
    "radial_distribution",
    "speeds",
]


def speeds(
    values: Numbers,
    *,
    temperature: float = 1.0,
    mass: float = 1.0,
    bins: int = 60,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw how speeds are distributed, beside Maxwell's law in two dimensions, (mv/kT) exp(−mv²/2kT).

    Parameters
    ----------
    values : (n,) float64
        The speeds of discs of one mass.
    temperature, mass : float
        kT and the discs' mass, for Maxwell's curve.
    bins : int
        How many bars there are.
    units : mapping of str to str
        The units of time, length and mass.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    top = max(float(np.max(values)), 3.5 * float(np.sqrt(temperature / mass)))
    ax.hist(values, bins=bins, range=(0.0, top), density=True, color=MEASURED, alpha=0.35, label="measured", zorder=2)
    speed = np.linspace(0.0, top, 400)
    curve = mass * speed / temperature * np.exp(-mass * speed**2 / (2.0 * temperature))
    ax.plot(speed, curve, color=THEORY, linewidth=1.5, label="Maxwell", zorder=3)
    ax.set_xlim(0.0, top)
    ax.set_ylim(0.0, None)
    return finished(ax, label("speed", "speed", units), per("probability density", "speed", units))


def free_times(
    values: Numbers,
    *,
    mean: float | None = None,
    bins: int = 50,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw how long discs fly freely, on a logarithmic scale, beside an exponential law.

    Parameters
    ----------
    values : (n,) float64
        Times between two collisions of a disc.
    mean : float, optional
        The mean free time of the exponential; that of the values if not given.
    bins : int
        How many bins there are.
    units : mapping of str to str
        The units of time, length and mass.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    tau = float(np.mean(values)) if mean is None else mean
    counts, edges = np.histogram(values, bins=bins)
    width, middle = np.diff(edges), 0.5 * (edges[1:] + edges[:-1])
    met = counts > 0
    density, error = counts / (len(values) * width), np.sqrt(counts) / (len(values) * width)
    # A bin of one has an error of one, which on this scale would reach to the bottom.
    below = np.minimum(error, 0.9 * density)
    ax.errorbar(
        middle[met],
        density[met],
        (below[met], error[met]),
        fmt="o",
        markersize=3,
        linewidth=0.8,
        color=MEASURED,
        label="measured, with √count",
        zorder=3,
    )
    time = np.linspace(0.0, float(edges[-1]), 200)
    ax.plot(
        time, np.exp(-time / tau) / tau, color=THEORY, linewidth=1.4, label=f"exponential, mean {number(tau)}", zorder=2
    )
    ax.set_yscale("log")
    ax.set_xlim(0.0, float(edges[-1]))
    ax.set_ylim(0.4 * float(density[met].min()), 2.5 * max(1.0 / tau, float(density.max())))
    return finished(ax, label("free time", "time", units), per("probability density", "time", units))


def profile(
    place: Numbers,
    temperature: Numbers,
    density: Numbers,
    *,
    temperature_errors: Numbers | None = None,
    density_errors: Numbers | None = None,
    direction: str = "y",
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw temperature and number density across the box, one on each side's axis.

    Parameters
    ----------
    place : (n,) float64
        The middles of the layers.
    temperature, density : (n,) float64
        kT and the number of discs per area in each.
    temperature_errors, density_errors : (n,) float64, optional
        Their standard errors, drawn as bands.
    direction : str
        The name of the axis across which the layers lie.
    units : mapping of str to str
        The units of length, energy and so on.
    ax : Axes, optional
        Where to draw; a new figure is made if not given. The density is on a twin of it.

    Returns
    -------
    Axes
    """
    if ax is None:
        ax = style.new_axes(*SIZE)
        left, bottom, width, height = ax.get_position().bounds
        ax.set_position((left, bottom, width - 0.09, height))
    style.tidy_axes(ax)
    other = ax.twinx()
    style.tidy_axes(other)
    other.grid(False)
    other.spines["left"].set_visible(False)
    other.spines["right"].set_visible(True)
    other.spines["right"].set_color(style.FAINT_INK)
    area = area_of(units)
    for side, values, errors, colour, marker, words in (
        (ax, temperature, temperature_errors, THEORY, "o", label("temperature", "energy", units)),
        (other, density, density_errors, MEASURED, "s", f"number density (per {area})" if area else "number density"),
    ):
        side.plot(place, values, color=colour, linewidth=1.3, marker=marker, markersize=3.2, zorder=3)
        draw_band(side, place, values, errors, colour)
        side.set_ylabel(words, fontsize=style.LABEL_SIZE, color=colour)
        side.tick_params(axis="y", labelcolor=colour)
        side.set_ylim(_around(values, errors))
    ax.plot([], [], color=THEORY, marker="o", markersize=3.2, label="temperature, left")
    ax.plot([], [], color=MEASURED, marker="s", markersize=3.2, label="density, right")
    ax.set_xlabel(label(direction, "length", units), fontsize=style.LABEL_SIZE)
    style.legend_above(ax, 2)
    return ax


def radial_distribution(
    distance: Numbers,
    values: Numbers,
    *,
    contact: float | None = None,
    diameter: float = 1.0,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw the radial distribution function g(r).

    Parameters
    ----------
    distance, values : (n,) float64
        g at the middles of the rings.
    contact : float, optional
        g at contact as an equation of state gives it, drawn as a mark at the diameter.
    diameter : float
        The discs' diameter.
    units : mapping of str to str
        The units of length and so on.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    ax.axhline(1.0, color=style.FAINT_INK, linewidth=0.9, linestyle=(0, (4, 2)), label="no order", zorder=1.5)
    ax.plot(distance, values, color=MEASURED, linewidth=1.4, label="measured", zorder=3)
    if contact is not None:
        words = f"contact, by pressure: {number(contact)}"
        ax.plot([diameter], [contact], "D", color=THEORY, markersize=5, label=words, zorder=4)
    ax.set_xlim(0.0, float(distance[-1]))
    ax.set_ylim(0.0, 1.08 * max(float(np.max(values)), contact or 0.0, 1.0))
    return finished(ax, label("distance", "length", units), "$g(r)$", columns=3)


def _around(values: Numbers, errors: Numbers | None) -> tuple[float, float]:
    """Give limits with room around values; what hardly differs is not blown up."""
    spread = np.zeros(1) if errors is None else np.asarray(errors)
    low, high = float(np.min(values - spread)), float(np.max(values + spread))
    room = max(0.1 * (high - low), 0.05 * max(abs(low), abs(high)))
    return low - room, high + room
