"""The filmstrip: the table before, during and after an event."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patheffects import Normal, Stroke

from carom.events import Event
from carom.figures import style
from carom.figures.balls import draw_names, draw_stripes
from carom.figures.closeup import close_to
from carom.figures.moments import default_event, frame_times, just_before
from carom.figures.scene import Scene
from carom.figures.table import (
    arrow_scale,
    draw_arrow,
    draw_balls,
    draw_table,
    framed_ratio,
    points_per_unit,
    table_contains,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from carom.run import Run

PAGE_WIDTH = 7.2
PAGE_HEIGHT = 8.4
LEFT, RIGHT, GAP, BELOW, TITLE, NARROW, LEAST = 0.5, 0.1, 0.16, 0.36, 0.3, 1.8, 1.0  # inches
LABEL_GAP, LABEL_ROOM = 6.5, 11.0  # points
LEAST_ARROW = 0.1  # points
MOST_WHOLE = 100  # balls
MOMENTS = {"ball_ball": "collision", "ball_cushion": "cushion", "cue_ball": "strike", "ball_cloth": "landing"}
MOMENTS |= {"ball_pocket": "pocketed"}


@dataclass(frozen=True)
class Strip:
    """What the frames of one filmstrip share."""

    run: Run
    scene: Scene
    event: Event
    times: NDArray[np.float64]
    arrow: float
    small: bool
    """Whether balls are small beside the table, as on a cloth."""

    @property
    def middle(self) -> int:
        """The place of the event's frame."""
        return len(self.times) // 2

    @property
    def participants(self) -> list[int]:
        """The places of the event's balls."""
        return [self.scene.ids.index(ball) for ball in self.event.balls]


def filmstrip(
    run: Run,
    around: Event | None = None,
    *,
    frames: int = 3,
    axes: Sequence[Axes] | None = None,
    arrows: bool = True,
    contact_axes: bool = True,
    closeup: bool | None = None,
) -> list[Axes]:
    """Show the table before, at and after an event, side by side.

    Of an exact run the frames are equal times apart, chosen so that the participants are visibly apart in the
    frames next to the event. Of a stepped run they are the scheme's own: the last step before, the contact,
    the first full step after.

    Parameters
    ----------
    run : Run
        The run to show.
    around : Event, optional
        A row of ``run.events``. If not given: the first ball-ball event in whose frames the balls come apart, or
        else the first of all.
    frames : int
        How many frames, odd.
    axes : sequence of Axes, optional
        One for each frame; a new figure is made if not given.
    arrows : bool
        Draw velocities. In the frame of the event, dashed ones are those just before it.
    contact_axes : bool
        Draw the normal n and the tangent t of the contact in its frame.
    closeup : bool, optional
        Show the balls of the event and their neighbourhood in place of the whole table. If not given: on a cloth, whose
        balls are small, and among more than a hundred balls.

    Returns
    -------
    list of Axes
        One for each frame, in order of time.

    Raises
    ------
    ValueError
        If the run has no event, or `frames` is not an odd number of three or more, or `axes` are not as many.
    TypeError
        If `around` is something else than an event.
    """
    if frames < 3 or frames % 2 == 0:
        raise ValueError(f"frames must be odd and at least 3, got {frames}")
    if around is not None and not isinstance(around, Event):
        raise TypeError(f"around: must be one event, such as run.events[0], got {around!r}")
    scene = Scene.of_run(run)
    event = default_event(run, scene) if around is None else around
    small = _has_small_balls(scene)
    if small if closeup is None else closeup:
        scene, times = close_to(run, scene, event, frames)
    else:
        times = frame_times(run, scene, event, frames)
    strip = Strip(run, scene, event, times, _arrow_scale(run, scene, times, event) if arrows else 0.0, small)
    chosen = _new_axes(scene, frames) if axes is None else list(axes)
    if len(chosen) != frames:
        raise ValueError(f"needs one axes for each of {frames} frames, got {len(chosen)}")
    for frame, ax in enumerate(chosen):
        _draw_frame(ax, strip, frame)
    if contact_axes and any(event.normal):
        _draw_contact_axes(chosen[strip.middle], strip)
    if axes is None and strip.arrow:
        _note_scale(chosen[-1], strip)
    return chosen


def _new_axes(scene: Scene, frames: int) -> list[Axes]:
    """Lay the frames in a row, or in a column where the table is wide, without empty space around them."""
    ratio = framed_ratio(scene)
    in_row = ratio > 0.62
    columns, rows = (frames, 1) if in_row else (1, frames)
    across = (PAGE_WIDTH - LEFT - RIGHT - (columns - 1) * GAP) / columns
    most = (PAGE_HEIGHT - BELOW) / rows
    title = TITLE if min(across, (most - TITLE) / ratio) >= NARROW else 1.6 * TITLE
    width = min(across, (most - title) / ratio, 4.6)
    height = width * ratio
    beside = max(0.0, LEAST - width) / 2  # room for the titles of frames that are narrower
    pitch = width + 2 * beside + GAP
    total_width = LEFT + RIGHT + columns * pitch - GAP
    total_height = BELOW + rows * (height + title)
    figure = style.new_figure(total_width, total_height)
    axes = []
    for frame in range(frames):
        column, row = (frame, 0) if in_row else (0, frame)
        left = LEFT + beside + column * pitch
        bottom = total_height - (row + 1) * (height + title)
        place = (left / total_width, bottom / total_height, width / total_width, height / total_height)
        axes.append(figure.add_axes(place))
    _label_scales(axes, scene, in_row=in_row)
    return axes


def _label_scales(axes: Sequence[Axes], scene: Scene, *, in_row: bool) -> None:
    """Name the scales once, and keep their numbers only where the strip ends."""
    middle = axes[len(axes) // 2]
    (middle if in_row else axes[-1]).set_xlabel(scene.label("x", "length"), fontsize=style.TICK_SIZE, labelpad=1)
    (axes[0] if in_row else middle).set_ylabel(scene.label("y", "length"), fontsize=style.TICK_SIZE, labelpad=2)
    for ax in axes[1:] if in_row else axes[:-1]:
        if in_row:
            ax.tick_params(left=False, labelleft=False)
        else:
            ax.tick_params(bottom=False, labelbottom=False)


def _note_scale(ax: Axes, strip: Strip) -> None:
    """Say in the lower right corner how long an arrow is."""
    unit = strip.scene.unit("time")
    words = f"arrows: velocity \N{MULTIPLICATION SIGN} {strip.arrow:g}" + (f" {unit}" if unit else "")
    style.figure_of(ax).text(
        0.99, 0.008, words, fontsize=style.SMALL_SIZE, color=style.FAINT_INK, ha="right", va="bottom"
    )


def _arrow_scale(run: Run, scene: Scene, times: NDArray[np.float64], event: Event) -> float:
    """Choose how long an arrow is for a velocity of one; of small balls by the event's own, else by all."""
    small = _has_small_balls(scene)
    chosen = [scene.ids.index(ball) for ball in event.balls] if small else slice(None)
    positions, velocities = (each[:, chosen, :2] for each in run.states(times))
    states = zip(scene.repeats.wrapped(positions), velocities, strict=True)
    shown = [(x[seen], v[seen]) for x, v in states for seen in [_is_shown(scene, x)]]
    spacing = float(times[-1] - times[0]) / (len(times) - 1)
    return arrow_scale(scene, shown, spacing)


def _has_small_balls(scene: Scene) -> bool:
    """Tell whether an event is looked at from near, and arrows are scaled for its own balls."""
    return scene.on_cloth or len(scene.ids) > MOST_WHOLE


def _is_shown(scene: Scene, positions: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which balls (n_balls, 2) are in play and in the picture."""
    low, high = np.array(scene.bounds[:2]), np.array(scene.bounds[2:])
    shown: NDArray[np.bool_] = np.all((positions >= low) & (positions <= high), axis=-1)
    return shown


def _draw_frame(ax: Axes, strip: Strip, frame: int) -> None:
    time = float(strip.times[frame])
    draw_table(ax, strip.scene)
    _draw_ghost_paths(ax, strip, time)
    positions = strip.scene.repeats.wrapped(strip.run.positions([time])[0, :, :2])
    moving = _moving(ax, strip, frame, positions)
    draw_balls(ax, strip.scene, positions)
    if strip.scene.on_cloth:
        draw_stripes(ax, strip.scene, positions, zorder=3.05)
        draw_names(ax, strip.scene, np.where(moving[:, None], np.nan, positions), zorder=3.1)
    if frame == strip.middle and strip.event.kind != "cue_ball":
        _draw_velocities_before(ax, strip, positions)
    velocities = strip.run.velocities([time])[0, :, :2]
    for ball in np.flatnonzero(moving):
        arrow = draw_arrow(ax, positions[ball], positions[ball] + strip.arrow * velocities[ball])
        # A close-up is scaled for the balls of its event; the arrows of others may leave the picture.
        arrow.set_clip_on(strip.small and ball not in strip.participants)
    ax.set_title(_title(ax, strip, frame), fontsize=style.TITLE_SIZE - 1, color=style.INK, pad=4)


def _moving(ax: Axes, strip: Strip, frame: int, positions: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which balls have an arrow in a frame; before the cue strikes, none."""
    velocities = strip.run.velocities([strip.times[frame]])[0, :, :2]
    is_struck = strip.event.kind != "cue_ball" or frame >= strip.middle
    seen = np.array([_is_seen(ax, strip, velocity) and is_struck for velocity in velocities], dtype=bool)
    moving: NDArray[np.bool_] = _is_shown(strip.scene, positions) & seen
    return moving


def _is_seen(ax: Axes, strip: Strip, velocity: NDArray[np.float64]) -> bool:
    """Tell whether the arrow of a velocity is long enough to be drawn; that of a ball about to rest is not."""
    return float(np.hypot(*velocity)) * strip.arrow * points_per_unit(ax) > LEAST_ARROW


def _draw_velocities_before(ax: Axes, strip: Strip, positions: NDArray[np.float64]) -> None:
    """Draw, pointing to the centres of the participants, with what velocity they came."""
    before = strip.run.velocities([just_before(strip.event.time)])[0, :, :2]
    for ball in strip.participants:
        if _is_seen(ax, strip, before[ball]) and np.all(np.isfinite(positions[ball])):
            draw_arrow(ax, positions[ball] - strip.arrow * before[ball], positions[ball], faint=True)


def _draw_ghost_paths(ax: Axes, strip: Strip, time: float) -> None:
    """Draw where each ball comes from, fading into the past, and dotted where it goes."""
    speed = np.nanmax(np.linalg.norm(strip.run.velocities(strip.times), axis=-1))
    back = 0.7 * strip.scene.size / speed if speed > 0 else 0.0
    past = _path_times(strip.run, max(0.0, time - back), time)
    future = _path_times(strip.run, time, float(strip.times[-1]))
    came = strip.run.positions(past)[..., :2]
    goes = strip.run.positions(future)[..., :2]
    fade = 0.6 * (past[1:] - past[0]) / max(time - past[0], 1e-300)
    for ball, colour in enumerate(strip.scene.lines):
        if np.ptp(came[:, ball], axis=0).any():
            pieces, which = strip.scene.repeats.segments(came[:, ball])
            colours = [(*colour, alpha) for alpha in fade[which]]
            lines = LineCollection(list(pieces), colors=colours, linewidths=1.0, capstyle="butt", zorder=1.5)
            ax.add_collection(lines, autolim=False)
        if np.ptp(goes[:, ball], axis=0).any():
            ax.plot(
                *strip.scene.repeats.broken(goes[:, ball]).T,
                color=colour,
                alpha=0.8,
                linewidth=0.9,
                linestyle=(0, (1, 2)),
                zorder=1.5,
            )


def _path_times(run: Run, start: float, end: float) -> NDArray[np.float64]:
    """Give times close enough to draw paths, with all events among them."""
    events = np.asarray(run.events.by_time(start, end)["time"], dtype=float)
    return np.unique(np.concatenate([np.linspace(start, end, 40), events]))


def _draw_contact_axes(ax: Axes, strip: Strip) -> None:
    """Draw the lines of the contact's normal and tangent through it, each named beyond what it crosses."""
    scene, event = strip.scene, strip.event
    centre, normal = scene.repeats.wrapped(np.array(event.position)), np.array(event.normal)
    at_cushion = len(event.balls) == 1
    point = 1.0 / points_per_unit(ax)
    short = max(2.4 * float(scene.radii[strip.participants].max()), 0.06 * scene.size)
    positions, velocities = (states[0, :, :2] for states in strip.run.states([event.time]))
    positions = scene.repeats.nearest(positions, centre)
    tips = (positions + strip.arrow * velocities)[strip.participants] - centre
    for name, direction in (("n", normal), ("t", np.array([-normal[1], normal[0]]))):
        origin = centre + 0.03 * scene.size * normal if name == "t" and at_cushion else centre
        wanted = [max(short, float((sign * tips @ direction).max()) + 6.0 * point) for sign in (1.0, -1.0)]
        ahead = _length_inside(scene, origin, direction, wanted[0], LABEL_ROOM * point)
        behind = _length_inside(scene, origin, -direction, wanted[1], LABEL_ROOM * point)
        behind = 0.0 if name == "n" and at_cushion else behind
        ends = origin + np.outer([-behind, ahead], direction)
        ax.plot(*ends.T, color=style.INK, linewidth=0.7, linestyle=(0, (5, 2.5)), zorder=3.6)
        labels = origin + np.outer([ahead + LABEL_GAP * point, -behind - LABEL_GAP * point], direction)
        clear = _gaps_to_discs(scene, positions, labels) / point > 3.0
        first = (ahead >= 0.6 * wanted[0] and bool(clear[0])) or not clear[1] or behind == 0.0
        _name_line(ax, labels[0 if first else 1], name)


def _name_line(ax: Axes, place: NDArray[np.float64], name: str) -> None:
    """Write a letter with a light rim, so that it can be read on whatever it covers."""
    x, y = place.tolist()
    ax.text(
        x,
        y,
        name,
        fontsize=style.LABEL_SIZE,
        style="italic",
        ha="center",
        va="center",
        zorder=5,
        path_effects=[Stroke(linewidth=2.0, foreground=style.CLOTH), Normal()],
    )


def _gaps_to_discs(scene: Scene, positions: NDArray[np.float64], places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give how far some places (n, 2) are from the nearest disc, below zero inside it."""
    distances = np.linalg.norm(places[:, None] - positions, axis=-1) - scene.radii
    gaps: NDArray[np.float64] = np.nanmin(distances, axis=1)
    return gaps


def _length_inside(
    scene: Scene, origin: NDArray[np.float64], direction: NDArray[np.float64], wanted: float, room: float
) -> float:
    """Shorten a line from the contact until it, and so much more for its name, lies on the cloth."""
    inside = table_contains(scene)
    lengths = wanted * np.arange(1.0, 0.2, -0.05)
    return next((float(x) for x in lengths if inside((origin + (x + room) * direction)[None])), float(lengths[-1]))


def _title(ax: Axes, strip: Strip, frame: int) -> str:
    """Give a frame's title: its time, and what it shows; in two lines where the frame is narrow."""
    least = float(np.diff(strip.times)[np.diff(strip.times) > 0].min(initial=1.0))
    digits = int(np.clip(np.ceil(-np.log10(least)) + 2, 1, 9))
    # Where so many decimals leave times alike, as many digits as tell them apart.
    texts = [f"{time:.{digits}f}" for time in strip.times]
    more = (f"{{:.{significant}g}}" for significant in range(3, 18))
    while len(set(texts)) < len(set(strip.times.tolist())):
        texts = list(map(next(more).format, strip.times))
    unit = strip.scene.unit("time")
    time = f"t = {texts[frame]}" + (f" {unit}" if unit else "")
    kind = MOMENTS.get(strip.event.kind, strip.event.kind.replace("_", " "))
    words = ("before", kind, "after")[int(np.sign(frame - strip.middle)) + 1]
    width = ax.get_position(original=True).width * style.figure_of(ax).get_figwidth()
    return f"{words}\n{time}" if width < NARROW else f"{time} — {words}"
