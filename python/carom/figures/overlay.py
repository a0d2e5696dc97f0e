"""The paths of two runs, or of one's own trajectory and a run, over one another."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, PathPatch

from carom.figures import style
from carom.figures.compared import Compared, shortened
from carom.figures.outline import table_loops
from carom.figures.table import clip_to_repeats, draw_table, framed_ratio

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.comparison import RunComparison, TrajectoryComparison
    from carom.figures.scene import Scene

MOST_DRAWN = 6
MOST_EVENTS = 60
AFTERWARDS = 1.25
"""With many balls or events, paths are drawn to this multiple of the time at which they part."""
MOST_DOTS = 400
OTHERS = "#b9c2c8"
MARGIN = 0.035
SAMPLE_WIDTH, LETTER_WIDTH = 0.55, 0.066
"""What an entry of a legend takes, in inches: its sample and the room around it, and each letter."""
LEGEND = {"frameon": False, "handletextpad": 0.5, "columnspacing": 1.4, "borderaxespad": 0.15, "handlelength": 2.2}


def plot_overlay(
    comparison: RunComparison | TrajectoryComparison,
    ax: Axes | None = None,
    *,
    balls: Sequence[str] | None = None,
    until: float | None = None,
) -> Axes:
    """Draw the paths of the second motion over those of the first, in the balls' colours.

    The first (or Carom's) is a broad pale line; the second a thin dark one, or a dot for each row of a trajectory.
    Rings are the starts, discs the ends. Crosses are where the ball is in each when they part: at the first event that
    differs, or in the first row beyond the tolerance. Among more than six balls only those that part first are drawn,
    and all others as they are then.

    Parameters
    ----------
    comparison : RunComparison or TrajectoryComparison
        What `carom.compare` or `carom.compare_trajectory` gave.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.
    balls : sequence of str, optional
        The balls to draw. Absent: all, or where there are more than six, those that part first.
    until : float, optional
        Draw paths up to this time. Absent: to the end, or where there are more than six balls or sixty events, until a
        little after they part.

    Returns
    -------
    Axes
    """
    seen = Compared.of(comparison)
    chosen = _choose(seen, balls)
    crowded = len(chosen) < len(seen.ids) and balls is None
    until = _choose_end(seen, crowded) if until is None else min(until, seen.end_time)
    dots = seen.in_rows and len(seen.times) <= MOST_DOTS
    ax = _new_axes(seen, _handles(seen, chosen, dots, until)) if ax is None else ax
    draw_table(ax, _framing_both(seen), margin=MARGIN)
    _draw_other_table(ax, seen)
    ax.set_xlabel(seen.scene.label("x", "length"), fontsize=style.LABEL_SIZE, labelpad=1)
    ax.set_ylabel(seen.scene.label("y", "length"), fontsize=style.LABEL_SIZE, labelpad=2)
    for ball in chosen:
        _draw_ball(ax, seen, ball, dots, until)
    if crowded:
        _draw_others(ax, seen, chosen)
    if seen.meeting is not None:
        for ball in chosen:
            _draw_meeting(ax, seen, ball)
    return ax


def _choose_end(seen: Compared, crowded: bool) -> float:
    tangled = crowded or max(len(events) for events in seen.events) > MOST_EVENTS
    return min(AFTERWARDS * seen.parting, seen.end_time) if tangled and seen.parting else seen.end_time


def _choose(seen: Compared, balls: Sequence[str] | None) -> list[int]:
    if balls is not None:
        for name in balls:
            if name not in seen.ids:
                raise ValueError(f"unknown ball {name!r}; known are {', '.join(seen.ids)}")
        return [seen.ids.index(name) for name in balls]
    if len(seen.ids) <= MOST_DRAWN:
        return list(range(len(seen.ids)))
    parting = [seen.ids.index(name) for name in seen.parting_balls if name in seen.ids]
    farthest = [
        int(ball) for ball in np.argsort(-np.nan_to_num(seen.distances).max(axis=0, initial=0.0), kind="stable")
    ]
    return parting or farthest[:2]


def _new_axes(seen: Compared, handles: list[Line2D]) -> Axes:
    """Make an axes in the table's proportions, with a legend below it."""
    ratio = framed_ratio(_framing_both(seen), MARGIN)
    width = min(5.4, 6.4 / ratio)
    left, right, above = 0.5, 0.1, 0.06
    columns, rows = _arrange([len(str(handle.get_label())) for handle in handles], left + width + right)
    below = 0.5 + 0.18 * rows
    total = (left + width + right, below + width * ratio + above)
    figure = style.new_figure(*total)
    place = (left / total[0], below / total[1], width / total[0], width * ratio / total[1])
    figure.legend(handles=handles, loc="lower center", ncols=columns, fontsize=style.TICK_SIZE, **LEGEND)
    return figure.add_axes(place)


def _arrange(letters: list[int], width: float) -> tuple[int, int]:
    """Choose how many columns, and so rows, a legend takes in a width in inches, from the lengths of its texts.

    A legend is filled column by column, and its columns are as wide as their longest texts.
    """
    for columns in range(len(letters), 1, -1):
        rows = -(-len(letters) // columns)
        longest = [max(letters[start : start + rows]) for start in range(0, len(letters), rows)]
        if sum(SAMPLE_WIDTH + LETTER_WIDTH * each for each in longest) <= width:
            return len(longest), rows
    return 1, len(letters)


def _handles(seen: Compared, chosen: list[int], dots: bool, until: float) -> list[Line2D]:
    """Give one sample of each thing drawn."""
    first, second = (shortened(name, 36) for name in seen.names)
    handles = [
        Line2D([], [], color=_pale(style.FAINT_INK), linewidth=4.0, label=first),
        Line2D([], [], label=second, **_second(style.INK, dots)),
    ]
    if len(seen.ids) > 1:
        handles += [
            Line2D(
                [],
                [],
                color=style.line_colour(seen.colours[ball]),
                linewidth=2.0,
                label=style.legend_name(seen.ids[ball]),
            )
            for ball in chosen
        ]
    if seen.meeting is not None:
        handles.append(Line2D([], [], linestyle="none", label=seen.parting_words, **_cross()))
    if until < seen.end_time:
        handles.append(Line2D([], [], linestyle="none", label=f"up to t = {until:.3g}"))
    return handles


def _pale(colour: str | tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = to_rgb(colour)
    return 0.45 * red + 0.55, 0.45 * green + 0.55, 0.45 * blue + 0.55


def _second(colour: str | tuple[float, float, float], dots: bool) -> dict[str, Any]:
    """Give the look of the second motion."""
    if dots:
        return {"color": colour, "linestyle": "none", "marker": "o", "markersize": 2.4, "markeredgewidth": 0.0}
    return {"color": colour, "linewidth": 1.0, "linestyle": (0, (3.5, 1.6))}


def _cross() -> dict[str, Any]:
    return {"marker": "X", "markersize": 7.0, "markerfacecolor": style.INK, "markeredgecolor": "white", "mew": 0.8}


def _draw_ball(ax: Axes, seen: Compared, ball: int, dots: bool, until: float) -> None:
    colour = style.line_colour(seen.colours[ball])
    one, two = (places[times <= until, ball] for times, places in seen.paths)
    repeats = seen.scene.repeats
    ax.plot(*repeats.broken(one).T, color=_pale(colour), linewidth=3.2, solid_joinstyle="round", zorder=2.0)
    ax.plot(*(repeats.wrapped(two) if dots else repeats.broken(two)).T, zorder=2.3, **_second(_dark(colour), dots))
    radius = _radius(seen, ball)
    for path, face, edge in ((one, _pale(colour), _dark(colour)), (two, colour, _dark(colour))):
        if len(path):
            _draw_disc(ax, seen.scene, path[0], radius, "none", colour, 1.9)
            _draw_disc(ax, seen.scene, path[-1], radius, face, edge, 2.2)


def _draw_others(ax: Axes, seen: Compared, chosen: list[int]) -> None:
    """Draw faintly where the other balls of the first motion are at the parting."""
    if seen.meeting is not None:
        for ball in (ball for ball in range(len(seen.ids)) if ball not in chosen):
            _draw_disc(ax, seen.scene, seen.meeting[0][ball], _radius(seen, ball), "none", OTHERS, 1.2)


def _radius(seen: Compared, ball: int) -> float:
    return float(seen.radii[ball]) or 0.009 * seen.scene.size


def _dark(colour: tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = colour
    return 0.75 * red, 0.75 * green, 0.75 * blue


def _draw_disc(
    ax: Axes, scene: Scene, place: NDArray[np.float64], radius: float, face: Any, edge: Any, zorder: float
) -> None:
    if np.all(np.isfinite(place)):
        seen, _ = scene.repeats.copies(scene.repeats.wrapped(place[None]), np.array([radius]))
        for x, y in seen.tolist():
            disc = Circle((x, y), radius, facecolor=face, edgecolor=edge, linewidth=0.9, zorder=zorder)
            ax.add_patch(disc)
            clip_to_repeats(ax, disc, scene)


def _draw_meeting(ax: Axes, seen: Compared, ball: int) -> None:
    """Mark where a ball is in both when they part."""
    assert seen.meeting is not None
    if seen.ids[ball] not in seen.parting_balls:
        return
    for places in seen.meeting:
        ax.plot(*seen.scene.repeats.wrapped(places[ball]), linestyle="none", zorder=4.0, **_cross())


def _framing_both(seen: Compared) -> Scene:
    """Give the first table with bounds in which the second has room too."""
    if seen.other is None:
        return seen.scene
    one, two = np.array(seen.scene.bounds), np.array(seen.other.bounds)
    low, high = np.minimum(one, two)[:2].tolist(), np.maximum(one, two)[2:].tolist()
    return replace(seen.scene, bounds=(low[0], low[1], high[0], high[1]))


def _draw_other_table(ax: Axes, seen: Compared) -> None:
    """Draw the outline of the second table where it is another one."""
    if seen.other is None or seen.other.pieces == seen.scene.pieces:
        return
    for _, path in table_loops(seen.other):
        ax.add_patch(
            PathPatch(path, fill=False, edgecolor=style.NOSE, linewidth=1.0, linestyle=(0, (4, 3)), zorder=0.7)
        )
