"""A scenario as it starts: the table, what stands on it, and the balls with their velocities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import EllipseCollection

from carom.figures import style
from carom.figures.balls import draw_names, draw_stripes
from carom.figures.beside import draw_stick, new_axes_beside, note_aim
from carom.figures.scene import Scene
from carom.figures.table import (
    MARGIN,
    arrow_scale,
    clip_to_repeats,
    draw_arrow,
    draw_table,
    framed_ratio,
    points_per_unit,
    shown_radii,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.scenario import Scenario

MOST_ARROWS = 100


def plot_scenario(scenario: Scenario, ax: Axes | None = None) -> Axes:
    """Draw a scenario at time 0.

    A ball's id stands in its disc where there is room. Arrows show the velocities, all at one scale, where at most
    `MOST_ARROWS` balls move; more would hide the table. A cue that will strike is drawn behind its ball; beside the
    table, on a figure of its own, are the point that it touches and its numbers.

    Parameters
    ----------
    scenario : Scenario
        What to draw.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    scene = Scene.of(scenario)
    if ax is None and scene.aim is not None:
        ax, beside = new_axes_beside(scene, MARGIN)
        note_aim(beside, scene)
    ax = _new_axes(scene) if ax is None else ax
    draw_table(ax, scene)
    ax.set_xlabel(scene.label("x", "length"), fontsize=style.LABEL_SIZE, labelpad=1)
    ax.set_ylabel(scene.label("y", "length"), fontsize=style.LABEL_SIZE, labelpad=2)
    balls = scenario.balls
    places = np.array([ball.position for ball in balls], dtype=float)[:, :2]
    velocities = np.array([ball.velocity for ball in balls], dtype=float)[:, :2]
    _draw_discs(ax, scene, places)
    draw_stripes(ax, scene, places, zorder=3.2)
    draw_names(ax, scene, places, zorder=3.5)
    _draw_velocities(ax, scene, places, velocities)
    if scene.aim is not None:
        draw_stick(ax, scene, places[scene.ids.index(scene.aim.ball)])
    return ax


def _new_axes(scene: Scene) -> Axes:
    """Make an axes as large as a page's column allows, in the table's proportions."""
    ratio = framed_ratio(scene)
    width = min(5.4, 6.4 / ratio)
    left, right, below, above = 0.5, 0.1, 0.45, 0.06
    total = (left + width + right, below + width * ratio + above)
    place = (left / total[0], below / total[1], width / total[0], width * ratio / total[1])
    return style.new_figure(*total).add_axes(place)


def _draw_discs(ax: Axes, scene: Scene, places: NDArray[np.float64]) -> None:
    """Draw all balls at once: a patch for each of thousands would take long."""
    radii = shown_radii(scene)
    places, which = scene.repeats.copies(scene.repeats.wrapped(places), radii)
    faces = np.array(scene.faces)[which]
    radii = radii[which]
    edge = min(0.7, 0.3 * float(radii.min()) * points_per_unit(ax))
    discs = EllipseCollection(
        2.0 * radii,
        2.0 * radii,
        np.zeros(len(radii)),
        units="xy",
        offsets=places,
        offset_transform=ax.transData,
        facecolors=faces.tolist(),
        edgecolors=style.BALL_EDGE,
        linewidths=edge,
        zorder=3.0,
    )
    ax.add_collection(discs, autolim=False)
    clip_to_repeats(ax, discs, scene)


def _draw_velocities(ax: Axes, scene: Scene, places: NDArray[np.float64], velocities: NDArray[np.float64]) -> None:
    """Draw the velocities from the rims of the discs, so that they leave the names free."""
    speeds = np.linalg.norm(velocities, axis=-1)
    moving = speeds > 0.0
    if not 0 < np.count_nonzero(moving) <= MOST_ARROWS:
        return
    radii, velocities, speeds = shown_radii(scene)[moving], velocities[moving], speeds[moving]
    rims = scene.repeats.wrapped(places[moving] + radii[:, None] * velocities / speeds[:, None])
    apart = scene.size / np.sqrt(len(places)) / float(speeds.max())
    scale = arrow_scale(scene, [(rims, velocities)], apart)
    for rim, velocity in zip(rims, velocities, strict=True):
        draw_arrow(ax, rim, rim + scale * velocity)
