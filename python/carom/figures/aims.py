"""Maps of aims: how likely a goal is met over what is meant, and how far off a shot may be."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke

from carom.figures import maps, style

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes

    from carom.best_aim import BestAim
    from carom.tolerance import Tolerance

MET, MISSED = "met", "missed"
COLOURS = ("#8cc5a2", "#f0e3d8")
SIGMAS: tuple[tuple[int, Literal["solid", "dashed"]], ...] = ((1, "solid"), (2, "dashed"))
HALO = [withStroke(linewidth=3.0, foreground="white")]


def plot_best_aim(
    best: BestAim, column: str = "probability", x: str | None = None, y: str | None = None, ax: Axes | None = None
) -> Axes:
    """Draw how likely a goal is met over two numbers of the meant shot, with the best point marked.

    Parameters
    ----------
    best : BestAim
        On a grid of which two axes have more than one number.
    column : str, optional
        What to draw of the table.
    x, y, ax
        As of `plot_map`, whose errors it has too.

    Returns
    -------
    Axes
    """
    _, (along_y, along_x) = maps.axes_of(best.table.grid, x, y)
    mark = _mark(best.point[along_x], best.point[along_y], f"best: {best.probability:.3g}")
    return maps.draw_cells(best.table, maps.Cells.of(best.table, column), column, (x, y), ax, [mark])


def plot_tolerance(tolerance: Tolerance, x: str | None = None, y: str | None = None, ax: Axes | None = None) -> Axes:
    """Draw where a goal is met around the meant shot, which is marked, and the noise's ellipses of one and two sigma.

    Two in five strokes are within the ellipse of one sigma and six in seven within that of two. Where a shot makes no
    scenario the map is grey.

    Parameters
    ----------
    tolerance : Tolerance
        What to draw.
    x, y, ax
        As of `plot_map`.

    Returns
    -------
    Axes
    """
    table = tolerance.table
    _, (along_y, along_x) = maps.axes_of(table.grid, x, y)
    places = np.ma.masked_where(~table.has_outcome, np.where(table["met"], 0.0, 1.0))
    counts = tuple(int((places == place).sum()) for place in (0, 1))
    cells = maps.Cells(places, (MET, MISSED), COLOURS, counts)
    meant = {path: margin.meant for path, margin in tolerance.margins.items()}
    marks = [*_ellipses(tolerance, meant, along_x, along_y), _mark(meant[along_x], meant[along_y], "meant")]
    return maps.draw_cells(table, cells, "goal", (x, y), ax, marks)


def _ellipses(tolerance: Tolerance, meant: Mapping[str, float], along_x: str, along_y: str) -> list[Line2D]:
    """Give the ellipses of the noise; where only one of the numbers scatters they are lines."""
    if tolerance.noise is None:
        return []
    scatter = tolerance.noise.around(tolerance.table.scenario.with_values(meant))
    width, height = (scatter[path].standard_deviation if path in scatter else 0.0 for path in (along_x, along_y))
    if width == height == 0.0:
        return []
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    return [
        Line2D(
            meant[along_x] + sigmas * width * np.cos(turn),
            meant[along_y] + sigmas * height * np.sin(turn),
            color=style.INK,
            linewidth=1.2,
            linestyle=dashes,
            path_effects=HALO,
            label=f"{sigmas} sigma",
        )
        for sigmas, dashes in SIGMAS
    ]


def _mark(x: float, y: float, label: str) -> Line2D:
    return Line2D(
        [x],
        [y],
        linestyle="none",
        marker="P",
        markersize=9.0,
        markerfacecolor=style.INK,
        markeredgecolor="white",
        label=label,
    )
