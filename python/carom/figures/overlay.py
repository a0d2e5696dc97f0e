"""The paths of two runs, or of one's own trajectory and a run, over one another."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, PathPatch

from carom.figures import style
from carom.figures.compared import Compared
from carom.figures.table import draw_table, framed_ratio, table_loops

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.comparison import RunComparison, TrajectoryComparison

MOST_DRAWN = 6
MOST_DOTS = 400
MARGIN = 0.035
LEGEND = {"frameon": False, "handletextpad": 0.5, "columnspacing": 1.4, "borderaxespad": 0.15, "handlelength": 2.2}


def plot_overlay(
    comparison: RunComparison | TrajectoryComparison, ax: Axes | None = None, *, balls: Sequence[str] | None = None
) -> Axes:
    """Draw the paths of the second motion over those of the first, in the balls' colours.

    The first (or Carom's) is a broad pale line; the second a thin dark one, or a dot for each row of a trajectory.
    Rings are the starts, discs the ends. A cross on each is where they are when they part: at the first event that
    differs, or in the first row beyond the tolerance.

    Parameters
    ----------
    comparison : RunComparison or TrajectoryComparison
        What `carom.compare` or `carom.compare_trajectory` gave.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.
    balls : sequence of str, optional
        The balls to draw. Absent: all, or where there are more than six, those that part first.

    Returns
    -------
    Axes
    """
    seen = Compared.of(comparison)
    chosen = _choose(seen, balls)
    dots = seen.in_rows and len(seen.times) <= MOST_DOTS
    ax = _new_axes(seen, chosen, dots) if ax is None else ax
    draw_table(ax, seen.scene, margin=MARGIN)
    _draw_other_table(ax, seen)
    ax.set_xlabel(seen.scene.label("x", "length"), fontsize=style.LABEL_SIZE, labelpad=1)
    ax.set_ylabel(seen.scene.label("y", "length"), fontsize=style.LABEL_SIZE, labelpad=2)
    for ball in chosen:
        _draw_ball(ax, seen, ball, dots)
    if seen.meeting is not None:
        for ball in chosen:
            _draw_meeting(ax, seen, ball)
    return ax


def _choose(seen: Compared, balls: Sequence[str] | None) -> list[int]:
    if balls is not None:
        for name in balls:
            if name not in seen.ids:
                raise ValueError(f"unknown ball {name!r}; known are {', '.join(seen.ids)}")
        return [seen.ids.index(name) for name in balls]
    if len(seen.ids) <= MOST_DRAWN:
        return list(range(len(seen.ids)))
    parting = [seen.ids.index(name) for name in seen.parting_balls if name in seen.ids]
    farthest = [int(ball) for ball in np.argsort(-np.nan_to_num(seen.distances).max(axis=0, initial=0.0), kind="stable")]
    return parting or farthest[:2]


def _new_axes(seen: Compared, chosen: list[int], dots: bool) -> Axes:
    """Make an axes in the table's proportions, with a legend below it."""
    ratio = framed_ratio(seen.scene, MARGIN)
    width = min(5.4, 6.4 / ratio)
    handles = _handles(seen, chosen, dots)
    columns = max(1, min(len(handles), round(width / 1.15)))
    rows = -(-len(handles) // columns)
    left, right, below, above = 0.5, 0.1, 0.5 + 0.18 * rows, 0.06
    total = (left + width + right, below + width * ratio + above)
    figure = style.new_figure(*total)
    place = (left / total[0], below / total[1], width / total[0], width * ratio / total[1])
    figure.legend(handles=handles, loc="lower center", ncols=columns, fontsize=style.TICK_SIZE, **LEGEND)
    return figure.add_axes(place)


def _handles(seen: Compared, chosen: list[int], dots: bool) -> list[Line2D]:
    """Give one sample of each thing drawn."""
    first, second = (_short(name) for name in seen.names)
    handles = [
        Line2D([], [], color=_pale(style.FAINT_INK), linewidth=4.0, label=first),
        Line2D([], [], label=second, **_second(style.INK, dots)),
    ]
    if len(seen.ids) > len(chosen) or len(chosen) > 1:
        handles += [
            Line2D([], [], color=style.line_colour(seen.colours[ball]), linewidth=2.0, label=seen.ids[ball])
            for ball in chosen
        ]
    if seen.meeting is not None:
        handles.append(Line2D([], [], linestyle="none", label=seen.parting_words, **_cross()))
    return handles


def _short(name: str) -> str:
    name = name.replace("\\", "/").rsplit("/", 1)[-1]
    return name if len(name) <= 40 else f"{name[:18]}…{name[-20:]}"


def _pale(colour: str | tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = to_rgb(colour)
    return 0.45 * red + 0.55, 0.45 * green + 0.55, 0.45 * blue + 0.55


def _second(colour: str | tuple[float, float, float], dots: bool) -> dict[str, object]:
    """Give the look of the second motion."""
    if dots:
        return {"color": colour, "linestyle": "none", "marker": "o", "markersize": 2.4, "markeredgewidth": 0.0}
    return {"color": colour, "linewidth": 1.0, "linestyle": (0, (3.5, 1.6))}


def _cross() -> dict[str, object]:
    return {"marker": "X", "markersize": 7.0, "markerfacecolor": style.INK, "markeredgecolor": "white", "mew": 0.8}


def _draw_ball(ax: Axes, seen: Compared, ball: int, dots: bool) -> None:
    colour = style.line_colour(seen.colours[ball])
    one, two = (path[:, ball] for path in seen.paths)
    ax.plot(*one.T, color=_pale(colour), linewidth=3.2, solid_joinstyle="round", zorder=2.0)
    ax.plot(*two.T, zorder=2.3, **_second(_dark(colour), dots))  # type: ignore[arg-type]
    radius = float(seen.radii[ball]) or 0.009 * seen.scene.size
    for path, face in ((one, _pale(colour)), (two, "none")):
        if len(path):
            _draw_disc(ax, path[0], radius, "none", colour, 1.9)
            _draw_disc(ax, path[-1], radius, face, _dark(colour), 2.2)


def _dark(colour: tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = colour
    return 0.75 * red, 0.75 * green, 0.75 * blue


def _draw_disc(ax: Axes, place: NDArray[np.float64], radius: float, face: object, edge: object, zorder: float) -> None:
    if np.all(np.isfinite(place)):
        centre = float(place[0]), float(place[1])
        disc = Circle(centre, radius, facecolor=face, edgecolor=edge, linewidth=0.9, zorder=zorder)  # type: ignore[arg-type]
        ax.add_patch(disc)


def _draw_meeting(ax: Axes, seen: Compared, ball: int) -> None:
    """Mark where a ball is in both when they part."""
    assert seen.meeting is not None
    if seen.ids[ball] not in seen.parting_balls:
        return
    for places in seen.meeting:
        ax.plot(*places[ball], linestyle="none", zorder=4.0, **_cross())


def _draw_other_table(ax: Axes, seen: Compared) -> None:
    """Draw the outline of the second table where it is another one."""
    if seen.other is None or seen.other.pieces == seen.scene.pieces:
        return
    for _, path in table_loops(seen.other):
        ax.add_patch(PathPatch(path, fill=False, edgecolor=style.NOSE, linewidth=1.0, linestyle=(0, (4, 3)), zorder=0.7))
    ax.autoscale_view()
