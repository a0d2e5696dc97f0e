"""Colours, sizes and the making and saving of figures.

Every setting is applied to the objects of one figure. Global matplotlib settings are read (a user's fonts are
kept) and never written, and pyplot is not imported, so the figures work without a display.
"""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from carom.colours import PALETTE as PALETTE
from carom.files import replacing

if TYPE_CHECKING:
    from collections.abc import Sequence

CLOTH = "#edf3ee"
CUSHION = "#8a9a91"
NOSE = "#3f4d46"
RUBBER = "#bccdc2"
WOOD = "#d9cbb8"
WOOD_EDGE = "#93826b"
SIGHT = "#fbfaf4"
POCKET = "#363c40"
MARK = "#9fb0a5"
INK = "#22292f"
FAINT_INK = "#7a858c"
GRID = "#e3e7ea"
BALL_EDGE = "#1d2327"

EVENT_COLOURS = {
    "ball_ball": "#b3261e",
    "ball_cushion": "#5b6b78",
    "ball_cloth": "#2b6cb0",
    "ball_pocket": "#22292f",
    "off_table": "#22292f",
}
EVENT_MARKERS = {"ball_ball": "D", "ball_cushion": "o", "ball_cloth": "v", "ball_pocket": "s", "off_table": "X"}
EVENT_WORDS = {
    "ball_ball": "ball-ball",
    "ball_cushion": "cushion",
    "ball_cloth": "landing",
    "ball_pocket": "pocket",
    "off_table": "off the table",
}

TITLE_SIZE = 10.0
LABEL_SIZE = 9.0
TICK_SIZE = 8.0
SMALL_SIZE = 7.0
LONGEST_NAME = 12
"""So many letters of an id are in a legend, whose columns are narrow."""

# A PDF embeds its fonts as fonts (text stays searchable); no file holds a date or random names, so that the
# same figure gives the same file.
SAVE_SETTINGS: dict[Any, Any] = {"pdf.fonttype": 42, "svg.fonttype": "path", "svg.hashsalt": "carom"}
UNDATED: dict[str, dict[str, Any]] = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}
FORMATS = ("png", "pdf", "svg")


class NotebookFigure(Figure):
    """A figure that a notebook shows as the value of a cell, without pyplot."""

    def _repr_png_(self) -> bytes:
        file = io.BytesIO()
        self.savefig(file, format="png", dpi=110)
        return file.getvalue()


def new_figure(width: float, height: float) -> Figure:
    """Make an empty white figure of a size in inches, outside pyplot."""
    figure = NotebookFigure(figsize=(width, height), facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def new_axes(width: float, height: float, legend_rows: int = 1) -> Axes:
    """Make one axes on a new figure of a size in inches, with room for labels and for a legend above.

    The room is fixed: a layout that measures its labels draws everything twice.
    """
    left, right, below, above = 0.72 / width, 0.14 / width, 0.5 / height, (0.12 + 0.18 * legend_rows) / height
    return new_figure(width, height).add_axes((left, below, 1.0 - left - right, 1.0 - below - above))


def save_figure(figure: Figure, path: str | os.PathLike[str], *, dpi: float = 200) -> Path:
    """Save a figure under a temporary name, then give it its own: the file is complete or absent.

    Parameters
    ----------
    figure : Figure
        What to save.
    path : str or path
        Where to; the suffix (``.png``, ``.pdf`` or ``.svg``) chooses the format.
    dpi : float
        Dots per inch of a PNG.

    Returns
    -------
    Path
        The file written.
    """
    kind = Path(path).suffix.lower().lstrip(".")
    with replacing(path) as temporary, matplotlib.rc_context(SAVE_SETTINGS):
        figure.savefig(temporary, format=kind, dpi=dpi, metadata=UNDATED.get(kind))
    return Path(path)


def font_file() -> str:
    """Give the file of the sans-serif font that matplotlib brings, so that films look alike everywhere."""
    return str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf")


def figure_of(axes: Axes | Sequence[Axes]) -> Figure:
    """Give the figure that one axes, or the first of several, belongs to."""
    figure: Any = axes if isinstance(axes, Axes) else axes[0]
    while not isinstance(figure, Figure):
        figure = figure.figure
    return figure


def tidy_axes(ax: Axes) -> None:
    """Give an axes of curves its plain look: two spines, small ticks, a faint grid behind the data."""
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_color(FAINT_INK)
    ax.tick_params(labelsize=TICK_SIZE, color=FAINT_INK, labelcolor=INK, length=3)
    ax.tick_params(which="minor", color=FAINT_INK, length=2)
    ax.grid(True, color=GRID, linewidth=0.6)
    ax.set_axisbelow(True)


def legend_name(name: str) -> str:
    """Give an id as a legend is to show it: no longer than fits, not read as mathematics, nor left out for its "_"."""
    short = name if len(name) <= LONGEST_NAME else f"{name[: LONGEST_NAME - 1]}\N{HORIZONTAL ELLIPSIS}"
    shown = short.replace("$", r"\$")
    return f"\N{ZERO WIDTH SPACE}{shown}" if shown.startswith("_") else shown


def legend_above(ax: Axes, columns: int) -> None:
    """Put the legend of curves above them."""
    ax.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncols=columns,
        fontsize=TICK_SIZE,
        frameon=False,
        handlelength=1.4,
        columnspacing=1.3,
        borderaxespad=0.2,
    )


def line_colour(colour: str, brightest: float = 0.72) -> tuple[float, float, float]:
    """Give the colour of a ball's lines: its own, darkened where it would not show on white."""
    red, green, blue = to_rgb(colour)
    brightness = 0.299 * red + 0.587 * green + 0.114 * blue
    factor = min(1.0, brightest / brightness) if brightness > 0 else 1.0
    return red * factor, green * factor, blue * factor
