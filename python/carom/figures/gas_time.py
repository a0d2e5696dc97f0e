"""Figures of gases against time: what settles, what spreads, what cools."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from carom.figures import style
from carom.figures.gas_axes import (
    MEASURED,
    REDUCED,
    SECOND,
    THEORY,
    area_of,
    draw_band,
    draw_level,
    finished,
    label,
    number,
    plain_axes,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

SETTLED = 0.1  # the first tenth of a running mean is too wild to choose the axis by


def compressibility(
    time: Numbers,
    values: Numbers,
    errors: Numbers | None = None,
    *,
    reference: float | None = None,
    reference_name: str = "Kolafa and Rottner",
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw the compressibility Z = pA/(NkT) as it has been measured up to each time.

    Parameters
    ----------
    time, values : (n,) float64
        The running mean at each time.
    errors : (n,) float64, optional
        Its standard error, drawn as a band on both sides.
    reference : float, optional
        What an equation of state gives, drawn as a line.
    reference_name : str
        Whose equation that is.
    units : mapping of str to str
        The units of time, length and mass.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    ax.plot(time, values, color=MEASURED, linewidth=1.4, label="running mean", zorder=3)
    draw_band(ax, time, values, errors)
    if reference is not None:
        draw_level(ax, reference, f"{reference_name}, {number(reference)}")
    settled = np.asarray(values)[int(SETTLED * len(values)) :]
    spread = np.zeros(1) if errors is None else np.asarray(errors)[int(SETTLED * len(values)) :]
    seen = np.concatenate([settled + spread, settled - spread, [] if reference is None else [reference]])
    margin = 0.15 * float(np.ptp(seen)) or 0.05
    ax.set_ylim(float(seen.min()) - margin, float(seen.max()) + margin)
    ax.set_xlim(0.0, float(time[-1]))
    return finished(ax, label("time", "time", units), "compressibility $Z = pA/(NkT)$")


def h_function(
    time: Numbers,
    values: Numbers,
    *,
    equilibrium: float | None = None,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw Boltzmann's H against time, and the value that it has for Maxwell's law.

    Parameters
    ----------
    time, values : (n,) float64
        H = ∫ f ln f d²v at each time.
    equilibrium : float, optional
        Its value in equilibrium.
    units : mapping of str to str
        The units of time, length and mass.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    ax.plot(time, values, color=MEASURED, linewidth=1.4, label="measured", zorder=3)
    if equilibrium is not None:
        draw_level(ax, equilibrium, f"Maxwell, {number(equilibrium)}")
    ax.set_xlim(float(time[0]), float(time[-1]))
    return finished(ax, label("time", "time", units), "Boltzmann's $H$")


def diffusion(
    time: Numbers,
    displacement: Numbers,
    *,
    correlation_time: Numbers | None = None,
    correlation: Numbers | None = None,
    diffusivity: float | None = None,
    temperature: float = 1.0,
    mass: float = 1.0,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw the mean squared displacement, with its two slopes, and the correlation of velocities in an inset.

    Parameters
    ----------
    time, displacement : (n,) float64
        ⟨|r(t) − r(0)|²⟩ at times above zero.
    correlation_time, correlation : (m,) float64, optional
        ⟨v(t)·v(0)⟩ / ⟨v²⟩ for the inset.
    diffusivity : float, optional
        D of the line 4Dt.
    temperature, mass : float
        kT and the mass, for the flight before the first collision, (2kT/m) t².
    units : mapping of str to str
        The units of length, time and so on.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    time = np.asarray(time)
    low, high = 0.5 * float(np.min(displacement)), 2.0 * float(np.max(displacement))
    ax.plot(time, displacement, color=MEASURED, linewidth=1.6, label="measured", zorder=3)
    flight = 2.0 * temperature / mass * time**2
    ax.plot(time, flight, color=style.INK, linewidth=0.9, linestyle=":", label="flight, $2kT t^2/m$", zorder=2)
    if diffusivity is not None:
        line = 4.0 * diffusivity * time
        ax.plot(
            time,
            line,
            color=THEORY,
            linewidth=1.1,
            linestyle="--",
            label=f"$4Dt$, $D$ = {number(diffusivity)}",
            zorder=2,
        )
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlim(float(time[0]), float(time[-1]))
    ax.set_ylim(low, high)
    if correlation_time is not None and correlation is not None:
        _inset(ax, correlation_time, correlation, label("time", "time", units))
    area = area_of(units)
    words = f"mean squared displacement ({area})" if area else "mean squared displacement"
    return finished(ax, label("time", "time", units), words, columns=3)


def psi6(
    time: Numbers,
    values: Numbers,
    errors: Numbers | None = None,
    *,
    discs: int | None = None,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw how much the gas is ordered in hexagons, |ψ₆| of all discs together, against time.

    Parameters
    ----------
    time, values : (n,) float64
        |ψ₆|, between 0 and 1.
    errors : (n,) float64, optional
        Their standard errors, drawn as a band.
    discs : int, optional
        Their number; then 1/√N is drawn, about what so many directions give at random.
    units : mapping of str to str
        The unit of time.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    ax.plot(time, values, color=MEASURED, linewidth=1.3, label="all discs together", zorder=3)
    draw_band(ax, time, values, errors)
    if discs is not None:
        draw_level(ax, 1.0 / float(np.sqrt(discs)), "at random, $1/\\sqrt{N}$")
    ax.set_xlim(float(time[0]), float(time[-1]))
    ax.set_ylim(0.0, 1.0)
    return finished(ax, label("time", "time", units), "hexagonal order $|\\psi_6|$")


def cooling(
    time: Numbers,
    temperature: Numbers,
    *,
    haff_time: float | None = None,
    units: Mapping[str, str] = REDUCED,
    ax: Axes | None = None,
) -> Axes:
    """Draw how a gas with inelastic collisions cools, beside Haff's law T₀/(1 + t/τ)².

    Parameters
    ----------
    time, temperature : (n,) float64
        T from time 0 on; it is drawn over T at the first time.
    haff_time : float, optional
        τ of Haff's law, 4/[(1 − e²) ν₀] for discs of restitution e and collision rate ν₀.
    units : mapping of str to str
        The unit of time.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    ax = plain_axes(ax)
    time, share = np.asarray(time), np.asarray(temperature) / temperature[0]
    later = time > 0.0
    ax.plot(time[later], share[later], color=MEASURED, linewidth=1.6, label="measured", zorder=3)
    if haff_time is not None:
        law = (1.0 + time[later] / haff_time) ** -2
        words = f"Haff, τ = {number(haff_time)}"
        ax.plot(time[later], law, color=THEORY, linewidth=1.1, linestyle="--", label=words, zorder=4)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlim(float(time[later][0]), float(time[-1]))
    ax.set_ylim(0.6 * float(share.min()), 1.6)
    return finished(ax, label("time", "time", units), "temperature $T/T_0$")


def _inset(ax: Axes, time: Numbers, values: Numbers, words: str) -> None:
    """Draw the correlation of velocities where the rising curve leaves room."""
    inset = ax.inset_axes((0.58, 0.17, 0.39, 0.4))
    style.tidy_axes(inset)
    inset.axhline(0.0, color=style.FAINT_INK, linewidth=0.7, zorder=1)
    inset.plot(time, values, color=SECOND, linewidth=1.2, zorder=2)
    inset.set_xlim(float(time[0]), float(time[-1]))
    inset.tick_params(labelsize=style.SMALL_SIZE)
    inset.set_xlabel(words, fontsize=style.SMALL_SIZE, labelpad=1)
    inset.set_title("correlation of velocities", fontsize=style.SMALL_SIZE, color=style.INK, pad=3)
