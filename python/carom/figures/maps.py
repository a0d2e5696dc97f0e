"""Maps: an outcome of a two-dimensional ensemble, a cell for each run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import matplotlib
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from carom.figures import style
from carom.units import unit_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.lines import Line2D
    from numpy.typing import NDArray

    from carom.ensemble import Grid
    from carom.scenario import Scenario

MOST_CATEGORIES = 12
"""So many different words have a colour of their own, and so many whole numbers are drawn as such."""
NO_OUTCOME, NONE, OTHER = "no outcome", "none", "other"
NO_OUTCOME_COLOUR, NONE_COLOUR, OTHER_COLOUR = "#b4bbc0", style.CLOTH, "#5f696f"
QUANTITIES = "viridis"
# After the eight of the balls, whose hues are all there are: four that differ by how dark they are.
WORDS = (*style.PALETTE, "#17324d", "#bfe3c0", "#5a1a2b", "#f3d9c4")

QUANTITY_OF = {
    **dict.fromkeys(("end_time", "first_event", "last_event", "duration"), "time"),
    **dict.fromkeys(("x", "y", "z", "position", "radius", "width", "length"), "length"),
    **dict.fromkeys(("vx", "vy", "vz", "velocity", "speed", "V0", "cue_speed"), "speed"),
    **dict.fromkeys(("wx", "wy", "wz"), "angular_velocity"),
    "mass": "mass",
    "acceleration": "acceleration",
}
"""What the last word of a path or of a column is a quantity of."""


class OnGrid(Protocol):
    """A table with a row for each point of a grid: an ensemble, or the chances of aims."""

    @property
    def scenario(self) -> Scenario:
        """The scenario that is varied."""

    @property
    def grid(self) -> Grid | None:
        """The grid, where there is one."""

    @property
    def has_outcome(self) -> NDArray[np.bool_]:
        """Which rows have outcomes."""

    def __getitem__(self, name: str) -> Any:
        """Give a column."""


@dataclass(frozen=True)
class Cells:
    """What the cells of a map show: a number or the place of a category for each, masked where there is none.

    Attributes
    ----------
    values : (n_rows,) masked float64
        The quantity of each row, or the place of its category.
    categories : tuple of str, or None
        The names of the categories; None for a quantity.
    colours : tuple of str
        Their colours.
    counts : tuple of int
        How many rows there are of each.
    """

    values: Any
    categories: tuple[str, ...] | None = None
    colours: tuple[Any, ...] = ()
    counts: tuple[int, ...] = ()

    @classmethod
    def of(cls, table: OnGrid, name: str) -> Cells:
        """Read a column: words and few whole numbers as categories, other numbers as a quantity."""
        column, has_outcome = table[name], table.has_outcome
        if column.dtype.kind == "O" and _are_numbers(column):
            # What a function gave, with None where there is no run.
            has_outcome = np.array([value is not None for value in column])
            column = np.array([0 if value is None else value for value in column])
        if column.dtype.kind in "Ob":
            return _words(column, has_outcome)
        if column.dtype.kind in "iu":
            different = np.unique(column[has_outcome])
            if 0 < len(different) <= MOST_CATEGORIES:
                return _whole_numbers(column, different, has_outcome)
        return cls(np.ma.masked_where(~(has_outcome & np.isfinite(column)), column.astype(np.float64)))

    @property
    def misses_some(self) -> bool:
        """Whether there are rows without an outcome."""
        return bool(np.ma.getmaskarray(self.values).any())


def plot_map(ensemble: OnGrid, column: str, x: str | None = None, y: str | None = None, ax: Axes | None = None) -> Axes:
    """Draw an outcome of an ensemble on a grid of two axes, a cell for each run.

    Words, and whole numbers of which there are at most twelve, have a colour each, which the legend names; words that
    are rarer than the first twelve are gathered as "other". Quantities have a colour bar. Rows without the outcome are
    grey.

    Parameters
    ----------
    ensemble : Ensemble
        One on a `Grid`, of which two axes have more than one number.
    column : str
        The name of an outcome's column.
    x, y : str, optional
        The paths along the axes; absent: the last axis of the grid, which varies fastest, is x.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes

    Raises
    ------
    ValueError
        When the ensemble is on no such grid.
    KeyError
        When there is no such column.
    """
    return draw_cells(ensemble, Cells.of(ensemble, column), column, (x, y), ax)


def draw_cells(
    table: OnGrid,
    cells: Cells,
    name: str,
    axes: tuple[str | None, str | None],
    ax: Axes | None,
    marks: Sequence[Line2D] = (),
) -> Axes:
    """Draw cells that have a name, and marks over them, and explain both; see `plot_map`."""
    grid, (along_y, along_x) = axes_of(table.grid, *axes)
    units = table.scenario.expanded().to_dict().get("units", {})
    ax = _new_axes() if ax is None else ax
    values = cells.values.reshape([len(numbers) for numbers in grid.values()])
    orders = {path: np.argsort(numbers, kind="stable") for path, numbers in grid.items()}
    values = values[np.ix_(*orders.values())]
    values = values if list(grid) == [along_y, along_x] else values.T
    edges = [_edges(grid[path][orders[path]], path) for path in (along_x, along_y)]
    least, most = _limits(cells)
    # Unlike an image it is right on a logarithmic axis too; in PDF and SVG a million cells are dots, not paths.
    drawn = ax.pcolormesh(*edges, values, cmap=_colour_map(cells), vmin=least, vmax=most, rasterized=True)
    for mark in marks:
        ax.add_line(mark)
    ax.set(xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    ax.tick_params(labelsize=style.TICK_SIZE, color=style.FAINT_INK, labelcolor=style.INK, length=3)
    for spine in ax.spines.values():
        spine.set_color(style.FAINT_INK)
    ax.set_xlabel(_label(along_x, units), fontsize=style.LABEL_SIZE)
    ax.set_ylabel(_label(along_y, units), fontsize=style.LABEL_SIZE)
    ax.set_title(_plain(name), fontsize=style.TITLE_SIZE, loc="left")
    _explain(ax, drawn, cells, _label(name, units), marks)
    return ax


def axes_of(grid: Grid | None, x: str | None, y: str | None) -> tuple[dict[str, NDArray[np.float64]], tuple[str, str]]:
    """Give the two axes of a grid that have more than one number, and which path is y and which x."""
    if grid is None:
        raise ValueError("a map needs an ensemble on a carom.Grid; this one has numbers for each run, or draws them")
    long = {path: numbers for path, numbers in grid.items() if len(numbers) > 1}
    if len(long) != 2:
        shape = ", ".join(f"{path}: {len(numbers)}" for path, numbers in grid.items())
        raise ValueError(f"a map needs a grid with two axes of more than one number, got {len(long)} of them ({shape})")
    for word, path in (("x", x), ("y", y)):
        if path is not None and path not in long:
            raise ValueError(f"{word}: no axis {path!r}; the axes are {' and '.join(long)}")
    if x is not None and x == y:
        raise ValueError(f"x and y: both are {x}; the axes are {' and '.join(long)}")
    first, last = long
    is_turned = x == first or y == last
    return long, (last, first) if is_turned else (first, last)


def _edges(numbers: NDArray[np.float64], path: str) -> NDArray[np.float64]:
    """Give the edges of the cells around numbers in order: half-way between them, and as far beyond the ends."""
    steps = np.diff(numbers)
    if not (steps > 0.0).all():
        twice = numbers[np.flatnonzero(steps <= 0.0)[0]]
        raise ValueError(f"{path}: has {twice:g} more than once, and a cell is to be one run")
    inner = numbers[:-1] + steps / 2
    return np.concatenate([[numbers[0] - steps[0] / 2], inner, [numbers[-1] + steps[-1] / 2]])


def _are_numbers(column: NDArray[Any]) -> bool:
    known = [value for value in column if value is not None]
    is_number = (isinstance(value, (int, float, np.number)) and not isinstance(value, bool) for value in known)
    return bool(known) and all(is_number)


def _words(column: NDArray[Any], has_outcome: NDArray[np.bool_]) -> Cells:
    """Read a column of words; None is a word where there is an outcome, as of a ball that is in no pocket."""
    texts = [NONE if value is None and has else value for value, has in zip(column, has_outcome, strict=True)]
    counts = Counter(str(text) for text in texts if text is not None)
    # Words that are equally frequent are in alphabetical order, so that the same words have the same colours.
    ordered = sorted(counts, key=lambda word: (-counts[word], word))
    named, rest = ordered[:MOST_CATEGORIES], ordered[MOST_CATEGORIES:]
    place = {word: min(rank, len(named)) for rank, word in enumerate(ordered)}
    places = np.array([-1 if text is None else place[str(text)] for text in texts], dtype=np.float64)
    return Cells(
        np.ma.masked_less(places, 0.0),
        (*named, *([OTHER] if rest else [])),
        (*_word_colours(named), *([OTHER_COLOUR] if rest else [])),
        (*(counts[word] for word in named), *([sum(counts[word] for word in rest)] if rest else [])),
    )


def _word_colours(words: Sequence[str]) -> list[str]:
    """Give words their colours; that there is none is pale, as it is often most of the map."""
    free = iter(WORDS)
    return [NONE_COLOUR if word == NONE else next(free) for word in words]


def _whole_numbers(column: NDArray[np.int64], different: NDArray[np.int64], has_outcome: NDArray[np.bool_]) -> Cells:
    """Read a column of few whole numbers: in their order, from dark to bright."""
    places = np.searchsorted(different, column).astype(np.float64)
    counts = [int((column[has_outcome] == number).sum()) for number in different]
    shades = matplotlib.colormaps[QUANTITIES](np.linspace(0.0, 1.0, len(different)))
    return Cells(
        np.ma.masked_where(~has_outcome, places), tuple(map(str, different)), tuple(map(tuple, shades)), tuple(counts)
    )


def _colour_map(cells: Cells) -> Any:
    bare = matplotlib.colormaps[QUANTITIES] if cells.categories is None else ListedColormap(cells.colours or ["white"])
    return bare.with_extremes(bad=NO_OUTCOME_COLOUR)


def _limits(cells: Cells) -> tuple[float | None, float | None]:
    """Give the numbers at the ends of the colours; the limits of a quantity are its own."""
    if cells.categories is None:
        return (None, None) if cells.values.count() else (0.0, 1.0)
    return -0.5, max(len(cells.categories), 1) - 0.5


def _new_axes() -> Axes:
    """Make an axes of five inches by five, so that a thousand cells have a dot each at 200 dots per inch."""
    width, height = 7.0, 5.9
    return style.new_figure(width, height).add_axes((0.8 / width, 0.5 / height, 5.0 / width, 5.0 / height))


def _explain(ax: Axes, drawn: ScalarMappable, cells: Cells, label: str, marks: Sequence[Line2D]) -> None:
    """Say what the colours mean: by a colour bar, by a legend beside the map, or above where there is a bar."""
    names: Sequence[tuple[str, Any]] = list(zip(cells.categories or (), cells.colours, strict=True))
    names = [*names, *([(NO_OUTCOME, NO_OUTCOME_COLOUR)] if cells.misses_some else [])]
    handles: list[Any] = [
        Patch(facecolor=colour, edgecolor=style.FAINT_INK, linewidth=0.5, label=style.legend_name(name))
        for name, colour in names
    ]
    handles += marks
    look: Mapping[str, Any] = {"fontsize": style.TICK_SIZE, "frameon": False, "handlelength": 1.0, "handleheight": 1.0}
    if cells.categories is not None:
        ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.4, **look)
        return
    if cells.values.count():
        bar = ax.figure.colorbar(drawn, cax=ax.inset_axes((1.03, 0.0, 0.045, 1.0)))
        bar.set_label(label, fontsize=style.LABEL_SIZE)
        bar.ax.tick_params(labelsize=style.TICK_SIZE, color=style.FAINT_INK, labelcolor=style.INK, length=3)
        bar.outline.set_edgecolor(style.FAINT_INK)
    if handles:
        ax.legend(handles=handles, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2, **look)


def _label(name: str, units: Mapping[str, str]) -> str:
    """Give a path or a column with its unit in brackets, where it is known."""
    last = name.rsplit(".", 1)[-1].split("[")[0]
    unit = unit_of(units, QUANTITY_OF[last]) if last in QUANTITY_OF else ""
    return f"{_plain(name)} ({unit})" if unit else _plain(name)


def _plain(text: str) -> str:
    """Keep text from being read as mathematics."""
    return text.replace("$", r"\$")
