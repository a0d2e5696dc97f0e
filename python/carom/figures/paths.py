"""The paths of all balls over a run, with the places of their collisions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D

from carom.figures import style
from carom.figures.balls import draw_balls_of_cloth
from carom.figures.beside import new_axes_beside, note_aim, note_balls, note_samples
from carom.figures.labels import Labeller
from carom.figures.moments import draw_times
from carom.figures.scene import Scene
from carom.figures.table import draw_balls, draw_table, framed_ratio, points_per_unit
from carom.figures.travels import WAYS, Travels, draw_sunk, draw_travels

if TYPE_CHECKING:
    from typing import Any

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.events import Event
    from carom.figures.beside import Beside
    from carom.run import Run

MOST_NUMBERS = 30
MOST_MARKS = 400
SAMPLES = 500
RING = 0.4
"""How opaque the balls at their contacts are."""
NUMBER_SIZE = 9.0
LONGEST_WORDS = 22
"""Letters that fit beside the table, behind a disc."""
MARGIN = 0.055
MARGIN_WITHOUT_NUMBERS = 0.035
LEGEND_COLUMN, LEGEND_ROW = 0.86, 0.18  # inches
LEGEND = {"frameon": False, "handletextpad": 0.1, "columnspacing": 1.2, "borderaxespad": 0.15}


def plot_paths(run: Run, ax: Axes | None = None, *, numbers: bool | None = None) -> Axes:
    """Draw where every ball went, from its start (a ring) to its end (a disc).

    Ball-ball contacts are marked by diamonds, cushion contacts by small dots, up to `MOST_MARKS` of them. Where
    events are numbered, pale rings are the two balls at each ball-ball contact.

    Where the table repeats itself, a path that leaves it goes on at the other side.

    On a cloth a line is solid where the ball rolls, dashed where it slides and dotted where it flies; a ball
    that fell lies in its pocket. Beside the table, on a figure of its own, stand the shot, the samples of lines and
    marks, and the balls that are out of play. Changes of motion have no numbers.

    Parameters
    ----------
    run : Run
        The run to show.
    ax : Axes, optional
        Where to draw; a new figure is made if not given.
    numbers : bool, optional
        Write the events' numbers: those of `Run.events`, from 0. If not given: where there are no more than 30.

    Returns
    -------
    Axes
    """
    scene = Scene.of_run(run)
    shown = run.events.by_kind(*style.EVENT_WORDS) if scene.on_cloth else run.events
    numbered = len(shown) <= MOST_NUMBERS if numbers is None else numbers
    marked = shown if numbered or len(shown) <= MOST_MARKS else shown[:0]
    events = {event.index: event for event in marked if np.isfinite(event.x) and np.isfinite(event.y)}
    found = {event.kind for event in events.values()}
    kinds = [kind for kind in style.EVENT_WORDS if len(shown) <= MOST_MARKS and kind in found]
    draw = _draw_on_cloth if scene.on_cloth else _draw_on_plane
    return draw(ax, run, scene, _Marks(events, kinds, len(shown), numbered))


@dataclass(frozen=True)
class _Marks:
    """The events that are marked, by number; their kinds; how many there are; and whether numbers are written."""

    events: dict[int, Event]
    kinds: list[str]
    count: int
    numbered: bool

    @property
    def margin(self) -> float:
        return MARGIN if self.numbered else MARGIN_WITHOUT_NUMBERS

    @property
    def has_rings(self) -> bool:
        return self.numbered and "ball_ball" in self.kinds


def _draw_on_plane(ax: Axes | None, run: Run, scene: Scene, marks: _Marks) -> Axes:
    """Draw the paths of discs."""
    ax = _new_axes(scene, marks.margin, _legend_marks(marks.kinds, rings=marks.has_rings)) if ax is None else ax
    _draw_table(ax, scene, marks)
    places = run.positions(draw_times(run, SAMPLES))[..., :2]
    _draw_lines(ax, scene, places, marks.count)
    draw_balls(ax, scene, places[0], filled=False, zorder=2.6)
    draw_balls(ax, scene, places[-1], zorder=3.0)
    _draw_events(ax, run, scene, marks, places)
    return ax


def _draw_on_cloth(ax: Axes | None, run: Run, scene: Scene, marks: _Marks) -> Axes:
    """Draw the paths of balls on a cloth, and beside an axes of our own what there is to know."""
    travels = Travels.of(run, scene, draw_times(run, SAMPLES))
    if ax is None:
        ax, beside = new_axes_beside(scene, marks.margin)
        _fill(beside, travels, marks)
    _draw_table(ax, scene, marks)
    draw_travels(ax, travels, crowding=min(1.0, marks.count / 60))
    draw_balls(ax, scene, travels.places[0], filled=False, zorder=2.6)
    draw_sunk(ax, travels)
    _draw_events(ax, run, scene, marks, travels.places)
    # Over the marks, so that the names of balls that stopped at a contact can be read.
    draw_balls_of_cloth(ax, scene, run.positions([run.end_time])[0, :, :2], zorder=4.0)
    return ax


def _fill(beside: Beside, travels: Travels, marks: _Marks) -> None:
    """Write beside the table how the cue struck, what lines and marks mean, and which balls are out of play."""
    scene = travels.scene
    note_aim(beside, scene)
    ways = [
        Line2D([], [], color=style.INK, linewidth=1.3, linestyle=WAYS[way][1], label=WAYS[way][0])
        for way in travels.ways
    ]
    kinds = [kind for kind in marks.kinds if kind != "ball_pocket"]
    note_samples(beside, [*ways, *_legend_marks(kinds, rings=marks.has_rings)])
    unit = scene.unit("time")
    for kind, heading in (("ball_pocket", "pocketed"), ("off_table", "off the table")):
        fallen = [(event, ball) for event, ball in zip(travels.out, travels.fallen, strict=True) if event.kind == kind]
        words = [_fall(event, unit) for event, _ in fallen]
        note_balls(beside, scene, heading, [ball for _, ball in fallen], words)


def _fall(event: Event, unit: str) -> str:
    """Say which ball went out of play, when, and where if there is room for it."""
    name, time = style.legend_name(str(event.ball_a)), f"{event.time:.3g} {unit}".rstrip()
    words = f"{name} in {event.pocket}, {time}"
    return words if event.pocket and len(words) <= LONGEST_WORDS else f"{name}, {time}"


def _draw_table(ax: Axes, scene: Scene, marks: _Marks) -> None:
    draw_table(ax, scene, margin=marks.margin)
    ax.set_xlabel(scene.label("x", "length"), fontsize=style.LABEL_SIZE, labelpad=1)
    ax.set_ylabel(scene.label("y", "length"), fontsize=style.LABEL_SIZE, labelpad=2)


def _draw_events(ax: Axes, run: Run, scene: Scene, marks: _Marks, places: NDArray[np.float64]) -> None:
    events = list(marks.events.values())
    for kind in marks.kinds:
        if kind != "ball_pocket":
            _draw_marks(ax, scene, events, kind)
    if marks.numbered:
        _draw_contact_rings(ax, run, scene, events)
        _draw_numbers(ax, run, scene, marks.events, places)


def _new_axes(scene: Scene, margin: float, marks: list[Line2D]) -> Axes:
    """Make an axes as large as a page's column allows, in the table's proportions, with a legend of its marks."""
    ratio = framed_ratio(scene, margin)
    width = min(5.4, 6.4 / ratio)
    left, right, above = 0.5, 0.1, 0.06
    columns = max(1, min(len(marks), int((left + width + right) / LEGEND_COLUMN)))
    rows = -(-len(marks) // columns)
    below = 0.5 + LEGEND_ROW * rows
    total = (left + width + right, below + width * ratio + above)
    figure = style.new_figure(*total)
    place = (left / total[0], below / total[1], width / total[0], width * ratio / total[1])
    ax = figure.add_axes(place)
    figure.legend(handles=marks, loc="lower center", ncols=-(-len(marks) // rows), fontsize=style.TICK_SIZE, **LEGEND)
    return ax


def _legend_marks(kinds: list[str], *, rings: bool) -> list[Line2D]:
    """Give one sample of each mark, with its meaning."""
    grey = style.FAINT_INK
    ring = Line2D([], [], linestyle="none", marker="o", markersize=8, mfc="none", mec=grey, alpha=RING, label="contact")
    return [
        Line2D([], [], linestyle="none", marker="o", markersize=8, mfc="none", mec=grey, label="start"),
        Line2D([], [], linestyle="none", marker="o", markersize=8, mfc=grey, mec=style.BALL_EDGE, label="end"),
        *(Line2D([], [], linestyle="none", label=style.EVENT_WORDS[kind], **_mark(kind)) for kind in kinds),
        *([ring] if rings else []),
    ]


def _mark(kind: str, most: float = np.inf) -> dict[str, Any]:
    """Give the look of a kind of event's mark, of at most so many points across."""
    colour = style.EVENT_COLOURS[kind]
    shared: dict[str, Any] = {"marker": style.EVENT_MARKERS[kind]}
    if kind in ("ball_cushion", "ball_cloth"):
        return shared | {"markersize": 3.0, "mfc": "white", "mec": colour, "mew": 0.8}
    size = 6.5 if kind == "off_table" else min(4.4, most)
    return shared | {"markersize": size, "mfc": colour, "mec": "white", "mew": 0.6}


def _draw_lines(ax: Axes, scene: Scene, places: NDArray[np.float64], n_events: int) -> None:
    """Draw the paths; the more events, the thinner and fainter."""
    crowding = min(1.0, n_events / 300)
    for ball, colour in enumerate(map(style.line_colour, scene.colours)):
        ax.plot(
            *scene.repeats.broken(places[:, ball]).T,
            color=colour,
            linewidth=1.3 - 0.8 * crowding,
            alpha=0.85 - 0.35 * crowding,
            solid_joinstyle="round",
            zorder=2.0,
        )


def _draw_marks(ax: Axes, scene: Scene, events: list[Event], kind: str) -> None:
    """Mark the events of a kind; between small balls the marks are small, so that a rack does not drown in them."""
    x, y = scene.repeats.wrapped(np.array([event.position for event in events if event.kind == kind])).T
    radii = scene.radii[scene.radii > 0.0]
    most = max(2.4, 0.7 * float(radii.min()) * points_per_unit(ax)) if len(radii) else np.inf
    zorder = 3.6 + 0.1 * (kind == "ball_ball")
    ax.plot(x, y, linestyle="none", zorder=zorder, clip_on=False, **_mark(kind, most))


def _draw_contact_rings(ax: Axes, run: Run, scene: Scene, events: list[Event]) -> None:
    """Draw faintly where the two balls of each ball-ball contact were."""
    for event in events:
        if event.kind == "ball_ball":
            places = run.positions([event.time])[0, :, :2]
            others = [ball for ball, name in enumerate(scene.ids) if name not in event.balls]
            places[others] = np.nan
            draw_balls(ax, scene, places, filled=False, alpha=RING, zorder=2.4)


def _draw_numbers(ax: Axes, run: Run, scene: Scene, events: dict[int, Event], places: NDArray[np.float64]) -> None:
    """Put numbers at the events: at cushions outside the table, between balls where there is room."""
    scale = points_per_unit(ax)
    places = scene.repeats.wrapped(places)
    curves = places.reshape(-1, 2)[:: max(1, places.size // 8000)]
    curves = curves[np.isfinite(curves[:, 0])]
    labeller = Labeller(lines=np.concatenate([curves, _ring_points(run, scene, [*events.values()])]) * scale)
    marks = {number: scene.repeats.wrapped(np.array(event.position)) for number, event in events.items()}
    labeller.avoid([mark * scale for mark in marks.values()], 2.5)
    for pocket in scene.rails.pockets if scene.rails else []:
        labeller.avoid([np.array(pocket["center"], dtype=float) * scale], float(pocket["radius"]) * scale)
    for radius, place in zip(scene.radii, places[-1], strict=True):
        labeller.avoid([place * scale], float(radius) * scale)
    ordered = sorted(events.items(), key=lambda item: item[1].kind != "ball_cushion")
    for number, event in ordered:
        at_cushion = event.kind == "ball_cushion"
        away = -_inward(run, scene, event) if at_cushion else None
        anchor = marks[number] * scale
        size = NUMBER_SIZE * (1.0 if number < 10 else 1.35)
        centre = labeller.place(anchor, size, 9.0 if at_cushion else 4.0 + size / 2, away) / scale
        colour = style.INK if at_cushion else style.EVENT_COLOURS.get(event.kind, style.EVENT_COLOURS["ball_ball"])
        ax.text(
            float(centre[0]),
            float(centre[1]),
            str(number),
            fontsize=NUMBER_SIZE,
            fontweight="normal" if at_cushion else "bold",
            color=colour,
            ha="center",
            va="center_baseline",
            zorder=5,
        )


def _ring_points(run: Run, scene: Scene, events: list[Event]) -> NDArray[np.float64]:
    """Give places along the rings drawn at the start and at ball-ball contacts."""
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    drawn = [(0.0, ball) for ball in range(len(scene.ids))]
    drawn += [(event.time, scene.ids.index(b)) for event in events if event.kind == "ball_ball" for b in event.balls]
    rings = [run.positions([time])[0, ball, :2] + scene.radii[ball] * circle for time, ball in drawn]
    return scene.repeats.wrapped(np.concatenate(rings))


def _inward(run: Run, scene: Scene, event: Event) -> NDArray[np.float64]:
    """Give the normal of a cushion contact that points to the side where the ball goes on."""
    normal = np.array(event.normal)
    ball = scene.ids.index(str(event.ball_a))
    velocity = run.velocities([event.time])[0, ball, :2]
    return normal if normal @ velocity >= 0 else -normal
