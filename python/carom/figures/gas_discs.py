"""A snapshot of a gas: its discs in their box, coloured by what each of them has."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.colors import ListedColormap, Normalize, hsv_to_rgb

from carom.figures import style
from carom.figures.repeats import Repeats

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

WIDTH = 5.0
BAR = 0.72  # inches beside the box, for the bar of colours
EDGED = 400  # so many discs still have an outline
SEQUENTIAL = "viridis"
HUES = np.column_stack([np.linspace(0.0, 1.0, 256, endpoint=False), np.full(256, 0.62), np.full(256, 0.88)])
CYCLIC = ListedColormap(hsv_to_rgb(HUES).tolist(), "hues")
"""All hues, no brighter than others: angles that differ by a sixth of a turn look alike."""
PLAIN = "#8fb3d1"


def discs(
    positions: Numbers,
    radii: Numbers,
    size: Sequence[float] | Numbers,
    *,
    values: NDArray[Any] | None = None,
    words: str = "",
    periodic: Sequence[bool] | NDArray[np.bool_] = (True, True),
    ax: Axes | None = None,
) -> Axes:
    """Draw discs in their box, true to size; where the box repeats itself, those on its edge are on both sides.

    Parameters
    ----------
    positions : (n, 2) float64
        The centres, wrapped or not.
    radii : (n,) float64
        The radii.
    size : (2,) float64
        Width and height of the box.
    values : (n,) float64 or complex128, optional
        What colours the discs: numbers, such as speeds, from dark to light; complex numbers, such as each disc's ψ₆,
        by their angle over six, the direction in which its neighbours lie.
    words : str
        What the values are, with their unit, beside the bar of colours.
    periodic : (2,) bool
        Whether the box repeats itself in x and y.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    box, repeats = np.asarray(size, dtype=float), np.asarray(periodic)
    ax = _new_axes(box, has_bar=values is not None) if ax is None else ax
    sides = Repeats(np.zeros(2), box, repeats)
    places, which = sides.copies(sides.wrapped(positions), np.asarray(radii))
    drawn = 2.0 * np.asarray(radii)[which]
    shown = EllipseCollection(
        drawn,
        drawn,
        np.zeros(len(which)),
        units="xy",
        offsets=places,
        offset_transform=ax.transData,
        linewidths=0.5 if len(radii) <= EDGED else 0.0,
        edgecolors=style.BALL_EDGE if len(radii) <= EDGED else "none",
        zorder=2,
    )
    if values is None:
        shown.set_facecolor(PLAIN)
    else:
        _colour(shown, np.asarray(values)[which])
    ax.add_collection(shown)
    _frame(ax, box, repeats)
    if values is not None:
        _bar(ax, shown, words, is_cut=not np.iscomplexobj(values))
    return ax


def _colour(shown: EllipseCollection, values: NDArray[Any]) -> None:
    if np.iscomplexobj(values):
        shown.set_array(np.degrees(np.angle(values)) / 6.0)
        shown.set_cmap(CYCLIC)
        shown.set_norm(Normalize(-30.0, 30.0))
        return
    shown.set_array(values)
    shown.set_cmap(SEQUENTIAL)
    # The few fastest would leave all others dark.
    shown.set_norm(Normalize(float(np.min(values)), float(np.quantile(values, 0.995))))


def _frame(ax: Axes, box: Numbers, repeats: NDArray[np.bool_]) -> None:
    """Draw the box: walls in full, dashed lines where it repeats itself."""
    ax.set_aspect("equal")
    for side, axis in (("left", 0), ("right", 0), ("bottom", 1), ("top", 1)):
        ax.spines[side].set_color(style.NOSE)
        ax.spines[side].set_linewidth(0.8 if repeats[axis] else 2.0)
        ax.spines[side].set_linestyle((0, (4, 2)) if repeats[axis] else "-")
    ax.set_xlim(0.0, box[0])
    ax.set_ylim(0.0, box[1])
    ax.set_xticks([])
    ax.set_yticks([])


def _bar(ax: Axes, shown: EllipseCollection, words: str, *, is_cut: bool) -> None:
    """Draw the bar of colours; where it is cut it ends in an arrow."""
    inset = ax.inset_axes((1.025, 0.0, 0.03, 1.0))
    bar = style.figure_of(ax).colorbar(shown, cax=inset, extend="max" if is_cut else "neither", extendfrac=0.03)
    bar.outline.set_linewidth(0.4)
    inset.tick_params(labelsize=style.TICK_SIZE, color=style.FAINT_INK, labelcolor=style.INK, length=3)
    inset.set_ylabel(words, fontsize=style.LABEL_SIZE)


def _new_axes(box: Numbers, *, has_bar: bool) -> Axes:
    """Make an axes of the box's shape, the longer side five inches, with room for the bar."""
    width, height = WIDTH * box / box.max()
    margin, bar = 0.14, BAR if has_bar else 0.0
    whole = (width + 2 * margin + bar, height + 2 * margin + 0.1)
    rectangle = (margin / whole[0], margin / whole[1], width / whole[0], height / whole[1])
    return style.new_figure(*whole).add_axes(rectangle)
