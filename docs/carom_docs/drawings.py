"""Pictures that explain how the engine works, drawn from what it computes."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import carom
from carom.figures import save_figure, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

RED, BLUE, AMBER = style.PALETTE[0], style.PALETTE[1], style.PALETTE[2]
BALLS = {"red": RED, "blue": BLUE}


def draw_all(folder: Path) -> None:
    """Draw every picture of this module into `folder`, as SVG."""
    drawings: dict[str, Callable[[], Figure]] = {
        "step": draw_step,
        "gap": draw_gap,
        "graze": draw_graze,
        "timeline": draw_timeline,
    }
    for name, draw in drawings.items():
        save_figure(draw(), folder / f"{name}.svg")


def draw_step() -> Figure:
    """Draw a ball that a time step carries past another one, and the contact that it misses."""
    scenario = _passing()
    run, stepped = scenario.run(), scenario.run(method=carom.Stepped(dt=0.3))
    figure = style.new_figure(7.2, 2.45)
    for place, (title, shown) in enumerate({"from event to event": run, "in steps of 0.3": stepped}.items()):
        ax = figure.add_axes((0.01 + 0.5 * place, 0.0, 0.48, 0.88))
        _blank(ax, (0.0, 2.4), (0.0, 1.42))
        ax.set_title(title, fontsize=style.TITLE_SIZE, color=style.INK)
        times = shown.steps["time"] if shown.steps else run.sample_times(0.01)
        places = shown.positions(times)
        for ball, name in enumerate(shown.ball_ids):
            ax.plot(*places[:, ball].T, color=BALLS[name], lw=1.2, marker="o" if shown.steps else None, ms=3)
            _ball(ax, places[0, ball], BALLS[name], filled=False)
            _ball(ax, places[-1, ball], BALLS[name])
        for event in shown.events.by_kind("ball_ball"):
            ax.plot(event.x, event.y, marker="D", ms=6, color=style.EVENT_COLOURS["ball_ball"], zorder=5)
    return figure


def draw_gap() -> Figure:
    """Draw the gap between the two balls of the midterm over time, on the flights that lead to their contact."""
    run = carom.load("midterm").run()
    contact = run.events.by_kind("ball_ball")[0]
    start = run.events.by_time(0.0, contact.time)[-2].time
    times = np.linspace(start, contact.time + 0.35, 300)
    there, speed = run.states(start)
    relative, speed = there[1] - there[0], speed[1] - speed[0]
    gap = np.linalg.norm(relative + np.outer(times - start, speed), axis=1) - 0.15
    ax = style.new_axes(6.4, 3.0, legend_rows=0)
    style.tidy_axes(ax)
    ax.axhline(0.0, color=style.INK, lw=0.8)
    before = times <= contact.time
    ax.plot(times[before], gap[before], color=BLUE, lw=2)
    ax.plot(times[~before], gap[~before], color=BLUE, lw=1.2, ls=(0, (3, 3)))
    ax.plot(contact.time, 0.0, "D", color=style.EVENT_COLOURS["ball_ball"], ms=7, zorder=5)
    _note(ax, "closing: the contact", (contact.time, 0.0), (-8, -30), ha="right")
    opening = times[(gap < 0)][-1]
    ax.plot(opening, 0.0, "o", mfc="white", mec=style.FAINT_INK, ms=6, zorder=5)
    _note(ax, "opening: no event", (opening, 0.0), (12, -30))
    ax.set_xlabel("time", fontsize=style.LABEL_SIZE)
    ax.set_ylabel("gap", fontsize=style.LABEL_SIZE)
    ax.set_ylim(min(gap) - 0.06, max(gap) + 0.03)
    return _figure(ax)


def draw_graze() -> Figure:
    """Draw the squared gap of two discs that pass each other: a hit, a hair's breadth, a miss."""
    ax = style.new_axes(6.4, 3.0, legend_rows=0)
    style.tidy_axes(ax)
    ax.axhline(0.0, color=style.INK, lw=0.8)
    times = np.linspace(8.0, 12.0, 400)
    for offset, colour, words in ((1.9, BLUE, "hit"), (2.0, AMBER, "graze"), (2.1, RED, "miss")):
        gap = (10.0 - times) ** 2 + offset**2 - 4.0
        ax.plot(times, gap, color=colour, lw=2)
        ax.text(12.05, gap[-1], words, color=style.INK, fontsize=style.LABEL_SIZE, va="center")
    ax.plot(10.0 - np.sqrt(4.0 - 1.9**2), 0.0, "D", color=style.EVENT_COLOURS["ball_ball"], ms=7, zorder=5)
    ax.set(xlim=(8.0, 12.4), ylim=(-0.8, 4.7))
    ax.set_xlabel("time", fontsize=style.LABEL_SIZE)
    ax.set_ylabel("distance² − (r₁ + r₂)²", fontsize=style.LABEL_SIZE)
    return _figure(ax)


def draw_timeline() -> Figure:
    """Draw the flights of the midterm: each ball has its own, and an event ends those of its balls only."""
    run = carom.load("midterm").run(duration=2.0)
    figure = style.new_figure(7.2, 1.9)
    ax = figure.add_axes((0.08, 0.26, 0.9, 0.72))
    style.tidy_axes(ax)
    ax.grid(visible=False)
    ax.spines["left"].set_visible(False)
    for row, name in enumerate(("blue", "red")):
        events = run.events.by_ball(name)
        edges: NDArray[np.float64] = np.concatenate([[0.0], events["time"], [run.end_time]])
        for place, (start, end) in enumerate(pairwise(edges)):
            ax.barh(row, end - start, left=start, height=0.42, color=BALLS[name], alpha=0.85 if place % 2 else 0.5)
        for event in events.by_kind("ball_cushion"):
            ax.plot(event.time, row, "o", color=style.EVENT_COLOURS["ball_cushion"], mec="white", ms=7)
    for event in run.events.by_kind("ball_ball"):
        ax.plot([event.time] * 2, [0, 1], "-D", color=style.EVENT_COLOURS["ball_ball"], mec="white", lw=2, ms=8)
    ax.set(xlim=(0.0, run.end_time), ylim=(-0.5, 1.5))
    ax.set_yticks([0, 1], ["blue", "red"], fontsize=style.LABEL_SIZE)
    ax.tick_params(axis="y", length=0)
    ax.set_xlabel("time", fontsize=style.LABEL_SIZE)
    return figure


def _passing() -> carom.Scenario:
    """Give two balls that brush each other between two steps of 0.3."""
    table = carom.Table.rectangle(width=2.4, length=1.6)
    red = carom.Ball("red", radius=0.15, position=(0.35, 0.5), velocity=(1.0, 0.0))
    blue = carom.Ball("blue", radius=0.15, position=(2.05, 0.79), velocity=(-1.0, 0.0))
    return carom.Scenario(table, [red, blue], duration=1.5)


def _blank(ax: Axes, across: tuple[float, float], along: tuple[float, float]) -> None:
    ax.set(xlim=across, ylim=along, aspect="equal", xticks=[], yticks=[], facecolor=style.CLOTH)
    for spine in ax.spines.values():
        spine.set_color(style.CUSHION)


def _ball(ax: Axes, place: NDArray[np.float64], colour: str, *, filled: bool = True) -> None:
    from matplotlib.patches import Circle

    face = colour if filled else "none"
    ax.add_patch(Circle((place[0], place[1]), 0.15, facecolor=face, edgecolor=colour, lw=1.2, alpha=0.9, zorder=3))


def _note(ax: Axes, words: str, place: tuple[float, float], shift: tuple[float, float], ha: str = "left") -> None:
    arrow = {"arrowstyle": "-", "color": style.FAINT_INK, "lw": 0.8}
    ax.annotate(
        words,
        place,
        shift,
        textcoords="offset points",
        ha=ha,
        fontsize=style.LABEL_SIZE,
        color=style.INK,
        arrowprops=arrow,
    )


def _figure(ax: Axes) -> Figure:
    from carom.figures import figure_of

    return figure_of(ax)
