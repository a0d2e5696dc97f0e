"""Energy, speed, spin, height and momentum against time, with a tick for every event."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.transforms import blended_transform_factory

from carom.figures import style
from carom.figures.moments import draw_times
from carom.figures.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.run import Run

SIZE = (6.4, 3.4)
SAMPLES = 600
MOST_TICKS = 2000
MOST_NAMED = 8
LEGEND_COLUMNS = 6
TOTAL = "#b4bec5"
TICKS = {"ball_cushion": 0.03, "ball_ball": 0.05, "ball_cloth": 0.03, "ball_pocket": 0.06, "off_table": 0.06}
"""How high the ticks of the events are, over the height of the axes."""
PLAIN = (-3, 4)  # powers of ten between which numbers at an axis are written in full


def plot_energy(run: Run, ax: Axes | None = None) -> Axes:
    """Draw the total energy and every ball's kinetic energy against time; on a cloth that of its spin, too.

    In a field, and where a ball flies over the cloth, the kinetic and the potential energy of all balls are drawn
    too, and the total is their sum; the potential energy is zero at the lowest corner of the table's bounds, or on
    the cloth.

    Parameters
    ----------
    run : Run
        The run to show.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    scene = Scene.of_run(run)
    times = draw_times(run, SAMPLES)
    total, potential = run.energy(times), run.potential_energy(times)
    if not scene.on_cloth:
        potential = potential - _lowest_potential(scene)
    has_potential = bool(np.any(potential > 0.0)) if scene.on_cloth else bool(np.any(scene.field != 0.0))
    ax = _new_axes(scene, more=2 if has_potential else 0) if ax is None else ax
    _draw_balls(ax, scene, times, _kinetic_energies(run, scene, times))
    if has_potential:
        for values, name, dashes in ((total, "kinetic", "--"), (potential, "potential", ":")):
            ax.plot(times, values, color=style.INK, linewidth=1.2, linestyle=dashes, label=name, zorder=3)
        total = total + potential
    # Under the balls' curves, and wider: where one ball has all the energy, both are seen.
    ax.plot(times, total, color=TOTAL, linewidth=3.4, label="total", zorder=1.8)
    return _finish(ax, run, scene, "energy", "energy", from_zero=True)


def plot_speed(run: Run, ax: Axes | None = None) -> Axes:
    """Draw every ball's speed against time.

    Parameters
    ----------
    run : Run
        The run to show.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    scene = Scene.of_run(run)
    ax = _new_axes(scene) if ax is None else ax
    times = draw_times(run, SAMPLES)
    _draw_balls(ax, scene, times, np.linalg.norm(run.velocities(times), axis=-1))
    return _finish(ax, run, scene, "speed", "speed", from_zero=True)


def plot_spin(run: Run, ax: Axes | None = None) -> Axes:
    """Draw how fast every ball on a cloth turns, against time; dashed, its side spin.

    Side spin is that about the vertical, above zero where the ball turns counter-clockwise as seen from above.

    Parameters
    ----------
    run : Run
        The run to show, of balls on a cloth.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes

    Raises
    ------
    RunError
        If the balls of the run are discs, which have no spin.
    """
    scene = Scene.of_run(run)
    times = draw_times(run, SAMPLES)
    spins = run.spins(times)
    ax = _new_axes(scene, more=2) if ax is None else ax
    _draw_balls(ax, scene, times, np.linalg.norm(spins, axis=-1))
    for side, colour in zip(spins[..., 2].T, scene.lines, strict=True):
        if np.any(np.abs(side[np.isfinite(side)]) > 0.0):
            ax.plot(times, side, color=colour, linewidth=0.9, linestyle=(0, (3, 1.5)), zorder=2.1)
    ax.plot([], [], color=style.INK, linewidth=1.2, label="spin")
    ax.plot([], [], color=style.INK, linewidth=0.9, linestyle=(0, (3, 1.5)), label="side spin")
    ax.axhline(0.0, color=style.FAINT_INK, linewidth=0.7, zorder=1)
    return _finish(ax, run, scene, "spin", "angular_velocity", from_zero=False)


def plot_height(run: Run, ax: Axes | None = None) -> Axes:
    """Draw how high the lowest point of every ball on a cloth is above it, while any ball flies.

    The dashed line is the height of a ball that lies on the cloth: what a jump has to clear.

    Parameters
    ----------
    run : Run
        The run to show, of balls on a cloth.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes

    Raises
    ------
    RunError
        If the balls of the run are discs, which stay on their plane.
    """
    scene = Scene.of_run(run)
    flying = run.motion(times := draw_times(run, SAMPLES)) == "airborne"
    ax = _new_axes(scene, more=1) if ax is None else ax
    seen = times[flying.any(axis=1)]
    first, last = (float(seen[0]), float(seen[-1])) if len(seen) else (0.0, run.end_time)
    near = np.unique(np.concatenate([times, np.linspace(first, last, SAMPLES)]))
    _draw_balls(ax, scene, near, run.positions(near)[..., 2] - scene.radii)
    top = 2.0 * float(scene.radii.max())
    ax.axhline(top, color=style.FAINT_INK, linewidth=0.9, linestyle=(0, (4, 2)), label="a ball's top", zorder=1.5)
    room = 0.05 * (last - first)
    span = (max(0.0, first - room), min(run.end_time, last + room))
    return _finish(ax, run, scene, "height", "length", from_zero=True, span=span)


def plot_momentum(run: Run, ax: Axes | None = None) -> Axes:
    """Draw the components of the total momentum against time.

    Parameters
    ----------
    run : Run
        The run to show.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    scene = Scene.of_run(run)
    ax = _new_axes(scene) if ax is None else ax
    times = draw_times(run, SAMPLES)
    momentum = run.momentum(times)
    for axis, (name, colour) in enumerate((("x", style.PALETTE[3]), ("y", style.PALETTE[4]))):
        ax.plot(times, momentum[:, axis], color=colour, linewidth=1.5, label=f"total, {name}", zorder=2)
    ax.axhline(0.0, color=style.FAINT_INK, linewidth=0.7, zorder=1)
    return _finish(ax, run, scene, "momentum", "momentum", from_zero=False)


def _new_axes(scene: Scene, more: int = 0) -> Axes:
    """Make an axes under room for a legend that names the balls where they are few, and three things and `more`."""
    entries = 3 + more + (len(scene.ids) if len(scene.ids) <= MOST_NAMED else 1)
    return style.new_axes(*SIZE, legend_rows=-(-entries // LEGEND_COLUMNS))


def _kinetic_energies(run: Run, scene: Scene, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the kinetic energy of every ball, (n_times, n_balls) float64."""
    energies: NDArray[np.float64] = 0.5 * scene.masses * np.sum(np.square(run.velocities(times)), axis=-1)
    if scene.on_cloth:
        spins = run.spins(times)
        energies = energies + 0.2 * scene.masses * scene.radii**2 * np.sum(np.square(spins), axis=-1)
    return energies


def _lowest_potential(scene: Scene) -> float:
    """Give the potential energy of all balls together at the lowest corner of the table's bounds."""
    corners = np.array([(x, y) for x in scene.bounds[::2] for y in scene.bounds[1::2]])
    return float(-(corners @ scene.field).max() * scene.masses.sum())


def _draw_balls(ax: Axes, scene: Scene, times: NDArray[np.float64], values: NDArray[np.float64]) -> None:
    """Draw one curve for each ball; in the legend they are named if they are few."""
    many = len(scene.ids) > MOST_NAMED
    names = ["each ball", *[""] * (len(scene.ids) - 1)] if many else list(map(style.legend_name, scene.ids))
    for ball, (name, colour) in enumerate(zip(names, scene.lines, strict=True)):
        ax.plot(times, values[:, ball], color=colour, linewidth=0.9 if many else 1.3, label=name or None, zorder=2)


def _finish(
    ax: Axes,
    run: Run,
    scene: Scene,
    words: str,
    quantity: str,
    *,
    from_zero: bool,
    span: tuple[float, float] | None = None,
) -> Axes:
    """Add event ticks, labels and the legend above the curves, over a span of time or the whole run."""
    style.tidy_axes(ax)
    start, end = span or (0.0, run.end_time)
    ax.set_xlim(start, end if end > start else start + 1.0)
    low, high = ax.get_ylim()
    if from_zero:
        low, high = 0.0, max(high, 1.05 * ax.dataLim.y1)
    rug = 0.07 * (high - low)
    ax.set_ylim(low - rug, high)
    power = _shorten_numbers(ax)
    _draw_event_ticks(ax, run, start, end)
    ax.set_xlabel(scene.label("time", "time"), fontsize=style.LABEL_SIZE)
    ax.set_ylabel(scene.label(words, quantity, power), fontsize=style.LABEL_SIZE)
    style.legend_above(ax, LEGEND_COLUMNS)
    return ax


def _shorten_numbers(ax: Axes) -> int:
    """Write very large and very small numbers as multiples of a power of ten, and give its exponent."""
    largest = float(np.abs(ax.get_ylim()).max())
    power = int(np.floor(np.log10(largest))) if 0.0 < largest < np.inf else 0
    if PLAIN[0] <= power < PLAIN[1]:
        return 0
    ax.yaxis.set_major_formatter(lambda value, _: f"{value / 10.0**power:g}")
    return power


def _draw_event_ticks(ax: Axes, run: Run, start: float, end: float) -> None:
    """Draw a row of ticks under the curves, coloured by kind; ball-ball ones are the taller."""
    where = blended_transform_factory(ax.transData, ax.transAxes)
    events = run.events.by_time(start, end)
    kinds = np.asarray(events["kind"])
    all_times = np.asarray(events["time"], dtype=float)
    for kind, height in TICKS.items():
        times = all_times[kinds == kind]
        if 0 < len(times) <= MOST_TICKS:
            ax.vlines(
                times,
                0.0,
                height,
                transform=where,
                color=style.EVENT_COLOURS[kind],
                linewidth=0.9 if kind in ("ball_cushion", "ball_cloth") else 1.6,
                label=style.EVENT_WORDS[kind],
                zorder=2.5,
            )
