"""How far balls are apart in two runs, or in one's own trajectory and a run, over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import LogLocator, NullLocator
from matplotlib.transforms import blended_transform_factory

from carom.figures import style
from carom.figures.compared import Compared, shortened
from carom.figures.series import LEGEND_COLUMNS, MOST_NAMED, MOST_TICKS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.comparison import RunComparison, TrajectoryComparison

SIZE = (6.4, 3.5)
MOST_DOTS = 400
ROUND_OFF = 1e-15
"""Distances up to this part of the table's size are not drawn."""
FEWEST_DECADES = 3.0
RUG = 0.1
"""The part of the axes' height, at its foot, that the ticks of events have to themselves."""


def plot_distance(comparison: RunComparison | TrajectoryComparison, ax: Axes | None = None) -> Axes:
    """Draw, on a logarithmic scale, how far every ball is from its place in the other run, over time.

    A vertical line marks the moment at which the runs part: the first event that differs, or the first row of a
    trajectory beyond the tolerance. Ticks at the foot are the events, of both runs if there are two. Distances that
    are zero or no more than round-off leave gaps.

    Parameters
    ----------
    comparison : RunComparison or TrajectoryComparison
        What `carom.compare` or `carom.compare_trajectory` gave.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    seen = Compared.of(comparison)
    few = len(seen.ids) <= MOST_NAMED
    entries = (len(seen.ids) if few else 2) + 2 + (seen.tolerance is not None) + (seen.parting is not None)
    ax = style.new_axes(*SIZE, legend_rows=-(-entries // LEGEND_COLUMNS)) if ax is None else ax
    style.tidy_axes(ax)
    distances = np.where(seen.distances > ROUND_OFF * seen.scene.size, seen.distances, np.nan)
    _set_scale(ax, seen, distances)
    _draw_balls(ax, seen, distances) if few else _draw_crowd(ax, seen, distances)
    if seen.tolerance:
        ax.axhline(seen.tolerance, color=style.FAINT_INK, linewidth=1.0, linestyle=(0, (4, 3)), label="tolerance")
    if seen.parting is not None:
        ax.axvline(seen.parting, ymin=RUG, color=style.INK, linewidth=1.0, linestyle=":", label=seen.parting_words)
    _draw_ticks(ax, seen)
    ax.set_xlabel(
        seen.scene.label("time", "time"), fontsize=style.LABEL_SIZE, loc="left" if len(seen.events) > 1 else None
    )
    ax.set_ylabel(seen.scene.label("distance", "length"), fontsize=style.LABEL_SIZE)
    if not np.isfinite(distances).any():
        words = "no distance at any time"
        ax.text(0.5, 0.5, words, transform=ax.transAxes, ha="center", color=style.INK, fontsize=style.LABEL_SIZE)
    style.legend_above(ax, LEGEND_COLUMNS)
    return ax


def _set_scale(ax: Axes, seen: Compared, distances: NDArray[np.float64]) -> None:
    """Set a logarithmic scale around the distances, with room for ticks at its foot."""
    ax.set_xlim(0.0, seen.end_time or 1.0)
    ax.set_yscale("log")
    levels = np.log10(distances[np.isfinite(distances)])
    levels = np.append(levels, np.log10(seen.tolerance)) if seen.tolerance else levels
    low, high = (levels.min(), levels.max()) if len(levels) else (-FEWEST_DECADES, 0.0)
    high = max(high, low + FEWEST_DECADES)
    room = 0.06 * (high - low)
    foot = (high - low + 2.0 * room) * RUG / (1.0 - RUG)
    ax.set_ylim(10.0 ** (low - room - foot), 10.0 ** (high + room))
    ax.yaxis.set_major_locator(LogLocator(numticks=9))
    ax.yaxis.set_minor_locator(NullLocator())


def _draw_balls(ax: Axes, seen: Compared, distances: NDArray[np.float64]) -> None:
    """Draw a curve for each ball; a few rows of a trajectory are dots too."""
    dots = seen.in_rows and len(seen.times) <= MOST_DOTS
    # The first is the widest and drawn first: where balls are equally far off, all are seen.
    for ball, (name, colour) in enumerate(zip(seen.ids, map(style.line_colour, seen.colours), strict=True)):
        ax.plot(
            seen.times,
            distances[:, ball],
            color=colour,
            linewidth=0.8 if dots else 1.3,
            marker="o" if dots else None,
            markersize=2.2,
            label=style.legend_name(name),
            zorder=2.0 + 0.01 * ball,
        )


def _draw_crowd(ax: Axes, seen: Compared, distances: NDArray[np.float64]) -> None:
    """Draw many balls: each faintly, and the farthest of all at each time."""
    for ball in range(len(seen.ids)):
        label = "each ball" if ball == 0 else None
        ax.plot(seen.times, distances[:, ball], color=style.PALETTE[5], linewidth=0.5, alpha=0.5, label=label, zorder=2)
    farthest = np.fmax.reduce(distances, axis=1)
    ax.plot(seen.times, farthest, color=style.PALETTE[1], linewidth=1.5, label="the farthest", zorder=2.2)


def _draw_ticks(ax: Axes, seen: Compared) -> None:
    """Draw the events' times at the foot: those of the second run below those of the first."""
    where = blended_transform_factory(ax.transData, ax.transAxes)
    rows = len(seen.events)
    for row, events in enumerate(seen.events):
        top = RUG * (rows - row) / rows * 0.9
        for kind in ("ball_cushion", "ball_ball"):
            times = np.asarray(events["time"], dtype=float)[np.asarray(events["kind"]) == kind]
            if 0 < len(times) <= MOST_TICKS:
                ax.vlines(
                    times[times <= seen.end_time],
                    top - 0.7 * RUG / rows,
                    top,
                    transform=where,
                    color=style.EVENT_COLOURS[kind],
                    linewidth=1.4 if kind == "ball_ball" else 0.8,
                    label=style.EVENT_WORDS[kind] if row == 0 else "",
                    zorder=2.5,
                )
    if rows > 1:
        one, two = (shortened(name, 28) for name in seen.names)
        words = f"events: {one} above, {two} below"
        place = {"xy": (1.0, 0.0), "xycoords": "axes fraction", "xytext": (0, -18), "textcoords": "offset points"}
        ax.annotate(words, **place, ha="right", va="top", fontsize=style.SMALL_SIZE, color=style.FAINT_INK)  # type: ignore[arg-type]
