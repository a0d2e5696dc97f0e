"""The figure of an observable: its curve, drawn by the figures of gases, beside what theory says."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.figures import gas, style
from carom.figures.gas_axes import MEASURED, THEORY, draw_band, finished, label, per, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.observables import Curve, Observable

    Numbers = NDArray[np.float64]

FEWEST = 3.0
"""Bins in which fewer counts than this are expected are not drawn."""


def plot_observable(observable: Observable, ax: Axes | None = None) -> Axes:
    """Draw the curve of an observable that has one.

    Parameters
    ----------
    observable : Observable
        What was found.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    (curve,) = observable.curves.values()
    return _FIGURES[observable.name](observable, curve, ax)


def _speeds(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    units = observable.units
    ax = _density(curve, "speed", "maxwell", "Maxwell", ax)
    ax.set_xlim(0.0, None)
    ax.set_ylim(0.0, None)
    return finished(ax, label("speed", "speed", units), per("probability density", "speed", units))


def _free_path(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    units = observable.units
    ax = _density(curve, "start", "poisson", "exponential", ax)
    met = curve["density"][curve["density"] > 0.0]
    ax.set_yscale("log")
    ax.set_xlim(0.0, None)
    if len(met):
        ax.set_ylim(0.4 * float(met.min()), 2.5 * float(met.max()))
    return finished(ax, label("free time", "time", units), per("probability density", "time", units))


def _density(curve: Curve, over: str, theory: str, words: str, ax: Axes | None) -> Axes:
    """Draw a measured density with its errors, and a law over the same bins."""
    ax = plain_axes(ax)
    place = 0.5 * (curve["start"] + curve["end"]) if over == "start" else curve[over]
    density, error = curve["density"], np.nan_to_num(curve["density_error"])
    # density / error² is how many counts there are to a unit of density. Chosen by what is expected and not by what was
    # met, as bins that happened to have many would stand out.
    met = (density > 0.0) & (curve[theory] * density >= FEWEST * error**2)
    ax.errorbar(
        place[met],
        density[met],
        error[met],
        fmt="o",
        markersize=3,
        linewidth=0.8,
        color=MEASURED,
        label="measured",
        zorder=3,
    )
    ax.plot(place, curve[theory], color=THEORY, linewidth=1.4, label=words, zorder=2)
    return ax


def _h_function(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    equilibrium = float(curve["maxwell"][-1])
    drawn = gas.h_function(curve["time"], curve["h"], equilibrium=equilibrium, units=observable.units, ax=ax)
    draw_band(drawn, curve["time"], curve["h"], curve["h_error"])
    return drawn


def _profile(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    direction = curve.names[0]
    return gas.profile(
        curve[direction],
        curve["temperature"],
        curve["density"],
        temperature_errors=np.nan_to_num(curve["temperature_error"]),
        density_errors=np.nan_to_num(curve["density_error"]),
        direction=direction,
        units=observable.units,
        ax=ax,
    )


def _radial_distribution(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    contact = observable.quantities["contact_value"].expected
    g = np.nan_to_num(curve["g"])
    drawn = gas.radial_distribution(curve["r"], g, contact=contact, units={"length": "diameters"}, ax=ax)
    draw_band(drawn, curve["r"], g, np.nan_to_num(curve["g_error"]))
    return drawn


def _diffusion(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    lag, displacement = curve["lag"], curve["mean_square_displacement"]
    correlation = curve["velocity_autocorrelation"]
    seen = (lag > 0.0) & (displacement > 0.0)
    known = ~np.isnan(correlation)
    mean_square = float(correlation[0])  # that of the velocity: two degrees of freedom of kT/m each
    return gas.diffusion(
        lag[seen],
        displacement[seen],
        correlation_time=lag[known],
        correlation=correlation[known] / mean_square,
        diffusivity=observable.quantities["diffusion_from_displacement"].value,
        temperature=0.5 * mean_square,
        units=observable.units,
        ax=ax,
    )


def _kinetic_energy(observable: Observable, curve: Curve, ax: Axes | None) -> Axes:
    units = observable.units
    ax = plain_axes(ax)
    time, energy = curve["time"], curve["kinetic_energy"]
    ax.plot(time, energy, color=MEASURED, linewidth=1.6, label="measured", zorder=3)
    draw_band(ax, time, energy, np.nan_to_num(curve["kinetic_energy_error"]))
    if "haff" in curve and not np.isnan(curve["haff"]).all():
        ax.plot(time, curve["haff"], color=THEORY, linewidth=1.1, linestyle="--", label="Haff", zorder=4)
        ax.set_yscale("log")
    else:
        ax.set_ylim(0.0, 1.3 * float(np.nanmax(energy)))
    ax.set_xlim(float(time[0]), float(time[-1]))
    style.tidy_axes(ax)
    return finished(ax, label("time", "time", units), label("kinetic energy of a disc", "energy", units))


_FIGURES = {
    "speeds": _speeds,
    "free_path": _free_path,
    "h_function": _h_function,
    "temperature_profile": _profile,
    "radial_distribution": _radial_distribution,
    "diffusion": _diffusion,
    "kinetic_energy": _kinetic_energy,
}
