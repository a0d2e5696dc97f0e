"""Stripes and names of balls that have room for them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from carom.figures import style
from carom.figures.table import draw_balls, points_per_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.figures.scene import Scene

STRIPE = 0.55
"""Half the width of a stripe, over the radius."""
SMALLEST_NAME = 5.0
LETTER = 0.62  # width of a letter over its size


def draw_balls_of_cloth(ax: Axes, scene: Scene, places: NDArray[np.float64], *, zorder: float = 3.0) -> None:
    """Draw balls with their stripes and, where there is room, their names; those without a place (NaN) are left out."""
    draw_balls(ax, scene, places, zorder=zorder)
    draw_stripes(ax, scene, places, zorder=zorder + 0.05)
    draw_names(ax, scene, places, zorder=zorder + 0.1)


def draw_stripes(ax: Axes, scene: Scene, places: NDArray[np.float64], *, zorder: float) -> None:
    """Draw the stripes of striped pool balls, whose discs are white."""
    band = _band()
    for ball, place in enumerate(places):
        if scene.is_striped(ball) and np.all(np.isfinite(place)):
            shape = Path(np.asarray(band.vertices) * scene.radii[ball] + place, band.codes)
            ax.add_patch(PathPatch(shape, facecolor=scene.colours[ball], edgecolor="none", zorder=zorder))


def draw_names(ax: Axes, scene: Scene, places: NDArray[np.float64], *, zorder: float) -> None:
    """Write the ids into the discs that have room for them."""
    diameters = 2.0 * scene.radii * points_per_unit(ax)
    for name, place, diameter, colour in zip(scene.ids, places, diameters, scene.colours, strict=True):
        size = min(style.LABEL_SIZE, 0.6 * diameter, 0.85 * diameter / (LETTER * max(len(name), 1)))
        if size >= SMALLEST_NAME and name.isprintable() and np.all(np.isfinite(place)):
            ax.text(
                float(place[0]),
                float(place[1]),
                name,
                fontsize=size,
                color="white" if _is_dark(colour) else style.INK,
                ha="center",
                va="center_baseline",
                zorder=zorder,
                parse_math=False,
                clip_on=True,
            )


def _band() -> Path:
    """Give the stripe of a disc of radius one: what lies between two chords."""
    edge = np.degrees(np.arcsin(STRIPE))
    right, left = Path.arc(-edge, edge), Path.arc(180.0 - edge, 180.0 + edge)
    return Path(
        np.concatenate([np.asarray(right.vertices), np.asarray(left.vertices)]),
        np.concatenate([np.asarray(right.codes), [Path.LINETO], np.asarray(left.codes)[1:]]),
    )


def _is_dark(colour: str) -> bool:
    red, green, blue = to_rgb(colour)
    return 0.299 * red + 0.587 * green + 0.114 * blue < 0.6
