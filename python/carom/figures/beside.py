"""What stands beside a table for cue sports: the shot, what the lines mean, and which balls are out of play."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Polygon

from carom.figures import style
from carom.figures.scene import BARE
from carom.figures.table import framed_ratio

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.figures.aim import Aim
    from carom.figures.scene import Scene

WIDTH = 1.62  # inches
ROW = 13.0  # points
HEADING = 15.0
FACE = 21.0
DISC = 4.2
SAMPLE = 19.0
STICK, BUTT = "#c99f6a", "#6b4a35"
TIP = "#2b6cb0"
"""The colours of a cue, of its butt, and of its chalked tip."""


@dataclass
class Beside:
    """An axes measured in points, filled from its top downwards.

    Attributes
    ----------
    y : float
        How far it is filled.
    """

    ax: Axes
    y: float

    def heading(self, words: str) -> None:
        """Write a heading."""
        self.y -= HEADING
        self.write(0.0, self.y + 3.0, words, color=style.FAINT_INK)

    def row(self, words: str) -> float:
        """Write a line of text after room for a sample, and give the middle of its height."""
        self.y -= ROW
        middle = self.y + ROW / 2
        self.ax.text(SAMPLE + 6.0, middle, words, fontsize=style.TICK_SIZE, color=style.INK, va="center_baseline")
        return middle

    def write(self, x: float, y: float, words: str, *, color: str = style.INK) -> None:
        """Write a text whose baseline begins at a place."""
        self.ax.text(x, y, words, fontsize=style.TICK_SIZE, color=color, va="baseline", parse_math=False)

    def skip(self, points: float = 7.0) -> None:
        """Leave room."""
        self.y -= points


def new_axes_beside(scene: Scene, margin: float) -> tuple[Axes, Beside]:
    """Make an axes in the table's proportions as large as a page's column allows, and one to its right for notes."""
    ratio = framed_ratio(scene, margin)
    width = min(5.4, 6.4 / ratio)
    left, gap, right, below, above = 0.5, 0.14, 0.04, 0.45, 0.06
    height = max(width * ratio, 3.2)
    total = (left + width + gap + WIDTH + right, below + height + above)
    figure = style.new_figure(*total)

    def at(x: float, y: float, across: float, along: float) -> tuple[float, float, float, float]:
        return x / total[0], y / total[1], across / total[0], along / total[1]

    ax = figure.add_axes(at(left, below + (height - width * ratio) / 2, width, width * ratio))
    notes = figure.add_axes(at(left + width + gap, below, WIDTH, height), label="notes")
    notes.set(xlim=(0.0, 72.0 * WIDTH), ylim=(0.0, 72.0 * height))
    notes.set_axis_off()
    return ax, Beside(notes, 72.0 * height)


def note_aim(beside: Beside, scene: Scene) -> None:
    """Draw how the cue strikes: the ball as the shooter sees it, the same from the side, and the numbers."""
    aim = scene.aim
    if aim is None:
        return
    beside.heading("the shot")
    middle = beside.y - FACE - 3.0
    ball = scene.ids.index(aim.ball)
    draw_face(beside.ax, aim, np.array([FACE + 1.0, middle]), FACE, scene.colours[ball])
    _draw_side(beside.ax, aim, np.array([4.0 * FACE, middle]), 0.5 * FACE, scene.colours[ball])
    beside.y = middle - FACE - 4.0
    for words in _in_words(aim, scene):
        beside.y -= ROW - 1.5
        beside.write(0.0, beside.y + 3.0, words)
    beside.skip()


def draw_face(ax: Axes, aim: Aim, centre: NDArray[np.float64], radius: float, colour: str) -> None:
    """Draw the cue ball as seen along the cue, and where the tip touches it; dashed, the limit of a miscue."""
    x, y = centre.tolist()
    ax.add_patch(Circle((x, y), radius, facecolor=colour, edgecolor=style.BALL_EDGE, linewidth=0.9))
    for across, along in (([-1, 1], [0, 0]), ([0, 0], [-1, 1])):
        ends = x + radius * np.array(across), y + radius * np.array(along)
        ax.plot(*ends, color=style.FAINT_INK, linewidth=0.5)
    limit = {"facecolor": "none", "edgecolor": style.FAINT_INK, "linewidth": 0.7, "linestyle": (0, (3, 2))}
    ax.add_patch(Circle((x, y), aim.limit * radius, **limit))
    tip = (x - aim.left * radius, y + aim.top * radius)
    ax.add_patch(Circle(tip, 3.0, facecolor=TIP, edgecolor="white", linewidth=0.7, zorder=3))


def draw_stick(ax: Axes, scene: Scene, place: NDArray[np.float64]) -> None:
    """Draw the cue on the table as seen from above, a little behind the ball at a place."""
    aim = scene.aim
    assert aim is not None
    radius = float(scene.radii[scene.ids.index(aim.ball)])
    ahead, left = aim.direction, np.array([-aim.direction[1], aim.direction[0]])
    lean = float(np.cos(np.radians(aim.elevation_deg)))
    front = place + aim.left * radius * left - 1.5 * radius * ahead
    for start, end, colour in ((0.0, 0.012, TIP), (0.012, 0.03, BARE), (0.03, 0.7, STICK), (0.7, 1.0, BUTT)):
        corners = []
        for part, side in ((start, 1), (end, 1), (end, -1), (start, -1)):
            thick = aim.tip + part * (aim.butt - aim.tip)
            corners.append(front - part * aim.length * lean * ahead + side * thick * left)
        ax.add_patch(Polygon(corners, facecolor=colour, edgecolor=style.INK, linewidth=0.3, zorder=3.3))


def _draw_side(ax: Axes, aim: Aim, centre: NDArray[np.float64], radius: float, colour: str) -> None:
    """Draw the ball on the cloth from the side, and the front of the cue, raised as it is."""
    x, y = centre.tolist()
    ax.plot([x - 3.4 * radius, x + 1.8 * radius], [y - radius] * 2, color=style.CUSHION, linewidth=1.2, zorder=1)
    ax.add_patch(Circle((x, y), radius, facecolor=colour, edgecolor=style.BALL_EDGE, linewidth=0.8, zorder=2))
    angle = np.radians(aim.elevation_deg)
    back, up = np.array([-np.cos(angle), np.sin(angle)]), np.array([np.sin(angle), np.cos(angle)])
    depth = float(np.sqrt(max(0.0, 1.0 - aim.left**2 - aim.top**2)))
    tip = centre + radius * (aim.top * up + depth * back)
    ends = np.stack([tip, tip + 2.4 * radius * back])
    ax.plot(*ends.T, color=STICK, linewidth=2.4, solid_capstyle="butt", zorder=3)
    ax.plot(*np.stack([tip, tip + 0.22 * radius * back]).T, color=TIP, linewidth=2.4, solid_capstyle="butt", zorder=4)


def _in_words(aim: Aim, scene: Scene) -> list[str]:
    """Say the numbers of a shot; an offset of zero is not worth a line."""
    unit = scene.unit("speed")
    words = [f"cue at {aim.speed:.3g}" + (f" {unit}" if unit else "")]
    words.append(f"direction {aim.direction_deg:.4g}°")
    if aim.elevation_deg:
        words.append(f"raised by {aim.elevation_deg:.3g}°")
    for offset, names in ((aim.left, ("left", "right")), (aim.top, ("top", "bottom"))):
        if offset:
            words.append(f"{abs(offset):.2g} R {names[offset < 0]}")
    return words


def note_samples(beside: Beside, samples: Sequence[Line2D]) -> None:
    """Explain lines and marks, each by a sample of it."""
    for sample in samples:
        y = beside.row(str(sample.get_label()))
        marked = sample.get_marker() not in ("None", None, "")
        sample.set_data([SAMPLE / 2] if marked else [0.0, SAMPLE], [y] if marked else [y, y])
        beside.ax.add_line(sample)
    beside.skip()


def note_balls(beside: Beside, scene: Scene, heading: str, balls: Sequence[int], words: Sequence[str]) -> None:
    """List balls, each with its disc and a few words; as many as there is room for."""
    if not balls:
        return
    beside.heading(heading)
    room = int((beside.y - ROW) / ROW)
    shown = len(balls) if len(balls) <= room + 1 else room
    for ball, text in list(zip(balls, words, strict=True))[:shown]:
        y = beside.row(text)
        _draw_disc(beside.ax, scene, ball, (SAMPLE / 2, y))
    if shown < len(balls):
        beside.row(f"and {len(balls) - shown} more")
    beside.skip()


def _draw_disc(ax: Axes, scene: Scene, ball: int, place: tuple[float, float]) -> None:
    ax.add_patch(Circle(place, DISC, facecolor=scene.faces[ball], edgecolor=style.BALL_EDGE, linewidth=0.7))
    if scene.is_striped(ball):
        x, y = place
        reach, half = DISC * 0.835, DISC * 0.55
        corners = [(x - reach, y - half), (x + reach, y - half), (x + reach, y + half), (x - reach, y + half)]
        ax.add_patch(Polygon(corners, facecolor=scene.colours[ball], edgecolor="none"))
