"""The error of the stepped method against its time step."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.figures import style
from carom.figures.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.comparison import StepComparison


def plot_errors(comparison: StepComparison, ax: Axes | None = None) -> Axes:
    """Draw, on two logarithmic scales, the error at the end against the time step.

    Filled marks are steps whose runs have the events of the exact run, open ones those that miss or add some;
    the guide has slope 1, the order of the scheme, and goes through the smallest filled one. Where no step has an
    error above zero, that is said in the figure.

    Parameters
    ----------
    comparison : StepComparison
        What `carom.compare_steps` gave.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.

    Returns
    -------
    Axes
    """
    scene = Scene.of(comparison.exact.scenario)
    ax = style.new_axes(4.8, 3.6, legend_rows=3) if ax is None else ax
    table = comparison.table
    positive = table["error"] > 0
    good = positive & (table["missed"] == 0) & (table["extra"] == 0)
    steps, errors = table["dt"], table["error"]
    colour = style.PALETTE[1]
    for chosen, face, label in (
        (good, colour, _name_order("same events as the exact run", comparison.order)),
        (positive & ~good, "white", "events missed or added"),
    ):
        if chosen.any():
            ax.plot(
                steps[chosen],
                errors[chosen],
                linestyle="none",
                marker="o",
                markersize=5.5,
                markerfacecolor=face,
                markeredgecolor=colour,
                label=label,
                zorder=3,
            )
    _draw_guide(ax, steps[good] if good.any() else steps[positive], errors[good] if good.any() else errors[positive])
    if positive.any():
        ax.set_xscale("log")
        ax.set_yscale("log")
    style.tidy_axes(ax)
    ax.set_xlabel(scene.label("time step Δt", "time"), fontsize=style.LABEL_SIZE)
    ax.set_ylabel(scene.label("position error at the end", "length"), fontsize=style.LABEL_SIZE)
    if not positive.any():
        ax.set(xticks=[], yticks=[])
        words = "no error at any step"
        ax.text(0.5, 0.5, words, transform=ax.transAxes, ha="center", color=style.INK, fontsize=style.LABEL_SIZE)
        return ax
    ax.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        fontsize=style.TICK_SIZE,
        frameon=False,
        borderaxespad=0.2,
    )
    return ax


def _name_order(words: str, order: float | None) -> str:
    return words if order is None else f"{words} (fitted slope {order:.2f})"


def _draw_guide(ax: Axes, steps: NDArray[np.float64], errors: NDArray[np.float64]) -> None:
    """Draw a line of slope 1 through the point with the smallest step."""
    if len(steps) == 0:
        return
    least = int(np.argmin(steps))
    ends = np.array([steps.min(), steps.max()])
    ends = ends if len(steps) > 1 else ends * [0.5, 2.0]
    ax.plot(
        ends,
        errors[least] * ends / steps[least],
        color=style.FAINT_INK,
        linewidth=1.0,
        linestyle=(0, (4, 3)),
        label="slope 1",
        zorder=2,
    )
