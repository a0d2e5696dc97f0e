"""The table as seen from above: cloth, cushions, obstacles, balls, velocity arrows."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Circle, FancyArrowPatch, PathPatch, Rectangle
from matplotlib.path import Path
from matplotlib.patheffects import Normal, Stroke
from matplotlib.ticker import MaxNLocator

from carom.figures import style
from carom.figures.outline import is_closed, table_loops
from carom.figures.rails import draw_rails

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.figures.scene import Scene

MARGIN = 0.03
FRAMED = 0.008
"""The margin around a frame."""
CUSHION_POINTS = 8.0


def draw_table(ax: Axes, scene: Scene, *, margin: float = MARGIN) -> None:
    """Draw cloth, cushions and obstacles in true proportion; of a table for cue sports also pockets and frame.

    A periodic side, which has no cushion, is a thin dashed line.

    Parameters
    ----------
    ax : Axes
        Where to draw; its limits, aspect and spines are set.
    scene : Scene
        The table to draw.
    margin : float
        Room around the table, as a part of its larger extent.
    """
    loops = table_loops(scene)
    cloth = [path for part, path in loops if part == "boundary" and is_closed(path)]
    if scene.rails is not None:
        draw_rails(ax, scene.rails, cloth[0], scene.pieces)
        loops = [(part, path) for part, path in loops if part == "obstacle"]
    elif not cloth:
        # All of the table, also where the bounds are those of a part of it.
        (x, y), (width, height) = scene.repeats.low.tolist(), scene.repeats.size.tolist()
        ax.add_patch(Rectangle((x, y), width, height, facecolor=style.CLOTH, zorder=0.2))
    for part, path in loops:
        if part == "periodic":
            ax.add_patch(
                PathPatch(path, fill=False, edgecolor=style.NOSE, linewidth=0.8, linestyle=(0, (4, 3)), zorder=0.5)
            )
            continue
        cushion = style.CUSHION
        ax.add_patch(
            PathPatch(
                path,
                fill=False,
                edgecolor=cushion,
                linewidth=CUSHION_POINTS,
                joinstyle="round",
                clip_on=False,
                zorder=0.1,
            )
        )
        face = style.CLOTH if part == "boundary" else cushion
        ax.add_patch(
            PathPatch(path, fill=is_closed(path), facecolor=face, edgecolor=style.NOSE, linewidth=0.8, zorder=0.5)
        )
    _frame_table(ax, scene, room_around(scene, margin))


def room_around(scene: Scene, margin: float) -> float:
    """Give the room around a table, in length: less where a frame gives some already."""
    return (FRAMED if scene.rails is not None else margin) * scene.size


def _short_number(value: float, _: float) -> str:
    """Write a number with its power of ten, which beside the axis would stand in the way of a title."""
    return f"{value:g}".replace("e-0", "e-").replace("e+0", "e")


def framed_ratio(scene: Scene, margin: float = MARGIN) -> float:
    """Give height over width of a table with the room around it."""
    room = 2.0 * room_around(scene, margin)
    return (scene.height + room) / (scene.width + room)


def _frame_table(ax: Axes, scene: Scene, margin: float) -> None:
    """Set limits, equal aspect, plain spines and few ticks around a table."""
    x_min, y_min, x_max, y_max = scene.bounds
    ax.set_xlim(x_min - margin, x_max + margin)
    ax.set_ylim(y_min - margin, y_max + margin)
    ax.set_aspect("equal")
    for spine in ax.spines.values():
        spine.set_visible(False)
    ax.tick_params(labelsize=style.TICK_SIZE, color=style.FAINT_INK, labelcolor=style.INK, length=2.5, pad=2)
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(MaxNLocator(nbins=4, steps=[1, 2, 5, 10]))
        if not 1e-3 <= scene.size < 1e5:
            axis.set_major_formatter(_short_number)


def draw_balls(
    ax: Axes,
    scene: Scene,
    positions: NDArray[np.float64],
    *,
    filled: bool = True,
    alpha: float = 1.0,
    zorder: float = 3.0,
) -> list[Circle]:
    """Draw every ball as a disc at its place; a point (radius 0) as a small one of fixed size.

    Where the table repeats itself a ball that has left it is drawn where it came in again, and one that stands across a
    side on both, each as far as it is on the table.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    scene : Scene
        Gives radii and colours.
    positions : (n_balls, 2) float64
        Centres, wrapped or not; a ball whose place is not a number (it was pocketed) is left out.
    filled : bool
        Filled discs, or rings.
    alpha : float
        Opacity.
    zorder : float
        Drawing order.

    Returns
    -------
    list of Circle
        The discs, in order of the balls, and then what of them is on another side.
    """
    discs = []
    colours, radii = scene.faces if filled else scene.colours, shown_radii(scene)
    places, which = scene.repeats.copies(scene.repeats.wrapped(positions), radii)
    for place, ball in zip(places, which.tolist(), strict=True):
        radius, colour = radii[ball], colours[ball]
        if not np.all(np.isfinite(place)):
            continue
        disc = Circle(
            (float(place[0]), float(place[1])),
            float(radius),
            facecolor=colour if filled else "none",
            edgecolor=style.BALL_EDGE if filled else style.line_colour(colour),
            linewidth=0.7 if filled else 1.1,
            alpha=alpha,
            zorder=zorder,
        )
        ax.add_patch(disc)
        clip_to_repeats(ax, disc, scene)
        discs.append(disc)
    return discs


def clip_to_repeats(ax: Axes, artist: Artist, scene: Scene) -> None:
    """Leave out what is beyond a side at which the table repeats itself."""
    if scene.repeats:
        (x, y), (width, height) = scene.repeats.low.tolist(), scene.repeats.size.tolist()
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
        artist.set_clip_path(Path(corners), ax.transData)


def shown_radii(scene: Scene) -> NDArray[np.float64]:
    """Give the radii that balls are drawn with, (n_balls,) float64: a point is drawn large enough to be seen."""
    return np.where(scene.radii > 0.0, scene.radii, 0.009 * scene.size)


def draw_arrow(
    ax: Axes, tail: NDArray[np.float64], tip: NDArray[np.float64], *, faint: bool = False
) -> FancyArrowPatch:
    """Draw an arrow between two places of the table, with a light rim so that it shows on every colour.

    The head shrinks with a short arrow, so that the length stays the message. `draw_table` comes first.
    """
    length = float(np.hypot(*(tip - tail))) * points_per_unit(ax)
    size = min(1.0, length / 8.0)
    arrow = FancyArrowPatch(
        (float(tail[0]), float(tail[1])),
        (float(tip[0]), float(tip[1])),
        arrowstyle="-|>,head_length=0.42,head_width=0.17",
        mutation_scale=11 * size,
        shrinkA=0,
        shrinkB=0,
        color=style.FAINT_INK if faint else style.INK,
        linewidth=(1.0 if faint else 1.3) * max(size, 0.5),
        linestyle=(0, (2.2, 1.6)) if faint else "solid",
        joinstyle="miter",
        zorder=4.0 if faint else 4.2,
        clip_on=False,
    )
    rim = Stroke(linewidth=arrow.get_linewidth() + 1.3 * size, foreground="white", alpha=0.75)
    arrow.set_path_effects([] if faint else [rim, Normal()])
    ax.add_patch(arrow)
    return arrow


def points_per_unit(ax: Axes) -> float:
    """Give how many points one unit of length takes in an axes of equal aspect."""
    figure = style.figure_of(ax)
    box = ax.get_position(original=True)
    width, height = figure.get_size_inches()
    across, along = np.ptp(ax.get_xlim()), np.ptp(ax.get_ylim())
    return 72.0 * float(min(box.width * width / across, box.height * height / along))


def arrow_scale(
    scene: Scene, states: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]], spacing: float
) -> float:
    """Choose how long an arrow is for a velocity of one, the same in all frames of a figure.

    An arrow spans the way of a little more than the time between frames, but no more than a fifth of the
    table; all are shortened until their tips lie on the cloth, but never so far that the fastest no longer
    leaves its disc.

    The scale has two digits, so that a caption can state it.

    Parameters
    ----------
    scene : Scene
        The table.
    states : sequence of (positions, velocities), each (n_balls, 2) float64
        What the frames show.
    spacing : float
        Time between frames.
    """
    fastest = max(float(np.nanmax(np.hypot(v[:, 0], v[:, 1]), initial=0.0)) for _, v in states)
    if fastest == 0.0:
        return 0.0
    least = max(2.2 * float(scene.radii.max(initial=0.0)), 0.06 * scene.size) / fastest
    scale = max(least, min(1.3 * spacing, 0.2 * scene.size / fastest))
    inside = table_contains(scene)
    while scale > least and not all(inside(x + scale * v) for x, v in states):
        scale *= 0.95
    return float(f"{scale:.2g}")


def table_contains(scene: Scene) -> Any:
    """Give a test of whether points (n, 2) all lie on the cloth; points not a number are passed over."""
    loops = table_loops(scene)

    def inside(points: NDArray[np.float64]) -> bool:
        points = points[np.all(np.isfinite(points), axis=1)]
        if scene.rails is not None and not _within(scene, points):
            return False
        held = [path.contains_points(points) == (part != "obstacle") for part, path in loops if is_closed(path)]
        return bool(np.all(held))

    return inside


def _within(scene: Scene, points: NDArray[np.float64]) -> bool:
    """Tell whether points lie within the bounds, which may be those of a part of the table."""
    low, high = np.array(scene.bounds[:2]), np.array(scene.bounds[2:])
    return bool(np.all((points >= low) & (points <= high)))
