"""When to look: the times of a filmstrip's frames, and the times at which a curve of a run is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.events import Event
    from carom.figures.scene import Scene
    from carom.run import Run

SPACINGS = 240
CLEAR = 1 / 3
MOST_TRIED = 30
MOST_EVENTS_DRAWN = 20_000


def frame_times(run: Run, scene: Scene, event: Event, frames: int) -> NDArray[np.float64]:
    """Choose the times of a filmstrip around an event, the event in the middle.

    Stepped runs are shown at the scheme's own times, exact ones at equal distances.

    Returns
    -------
    (frames,) float64
    """
    half = frames // 2
    if run.steps is not None:
        return _stepped_times(run, scene, event, half)
    spacing = _exact_spacing(run, scene, event, half)
    return np.clip(event.time + spacing * np.arange(-half, half + 1), 0.0, run.end_time)


def default_event(run: Run, scene: Scene) -> Event:
    """Choose the event that a filmstrip shows: the first ball-ball one with a clear view, or the first of all.

    Raises
    ------
    ValueError
        If the run has no event.
    """
    contacts = run.events.by_kind("ball_ball")
    event = contacts.first() or run.events.first()
    if event is None:
        raise ValueError("the run has no event to show")
    if run.steps is not None:
        return event
    tried = (contacts[index] for index in range(min(len(contacts), MOST_TRIED)))
    return next((each for each in tried if _is_whole(run, scene, each) and _is_clear(run, scene, each)), event)


def draw_times(run: Run, samples: int) -> NDArray[np.float64]:
    """Choose times that draw a run's curves truly: evenly spread ones, and each event just before and at it.

    Beyond `MOST_EVENTS_DRAWN` events the evenly spread times alone are used, more of them.

    Returns
    -------
    (n_times,) float64, ascending
    """
    even = np.linspace(0.0, run.end_time, samples)
    events = np.unique(np.asarray(run.events["time"], dtype=float))
    if len(events) > MOST_EVENTS_DRAWN:
        return np.linspace(0.0, run.end_time, 4 * MOST_EVENTS_DRAWN)
    before = np.maximum(np.nextafter(events, -np.inf), 0.0)
    return np.unique(np.concatenate([even, before, events]))


def just_before(time: float) -> float:
    """Give the last number before a time, but not before the start."""
    return max(float(np.nextafter(time, -np.inf)), 0.0)


def _exact_spacing(run: Run, scene: Scene, event: Event, half: int) -> float:
    """Choose the time between frames.

    The smallest at which the participants are clearly apart in the frames next to the event, within the flights
    that meet there; where those are too short to come apart, the window is widened step by step.
    """
    room = _room(run, event) / half
    limit = min(_flight_room(run, event) / half, room)
    best: tuple[float, float] = (0.0, limit)
    while limit > 0.0:
        spacings = limit * np.linspace(1 / SPACINGS, 1.0, SPACINGS)
        apart = _apart(run, scene, event, spacings)
        enough = np.flatnonzero(apart >= 1.0)
        if len(enough):
            return float(spacings[enough[0]])
        widest = int(np.argmax(apart))
        best = max(best, (float(apart[widest]), float(spacings[widest])))
        if best[0] >= CLEAR or limit == room:
            break
        limit = min(2.0 * limit, room)
    return best[1]


def _is_whole(run: Run, scene: Scene, event: Event) -> bool:
    """Tell whether the participants meet on one side of a table that repeats itself, and not across its sides."""
    chosen = [scene.ids.index(ball) for ball in event.balls]
    places = scene.repeats.wrapped(run.positions([event.time])[0, chosen, :2])
    return bool(np.array_equal(scene.repeats.nearest(places, places[0]), places))


def _is_clear(run: Run, scene: Scene, event: Event) -> bool:
    """Tell whether the participants come apart before and after an event, within their flights."""
    limit = min(_flight_room(run, event), _room(run, event))
    apart = _apart(run, scene, event, limit * np.linspace(1 / SPACINGS, 1.0, SPACINGS))
    return bool(apart.max() >= CLEAR)


def _sides(run: Run, event: Event) -> dict[float, float]:
    """Give the time before (-1) and after (1) an event within its run, leaving out a side that has none."""
    rooms = {-1.0: event.time, 1.0: run.end_time - event.time}
    return {sign: room for sign, room in rooms.items() if room > 1e-6 * run.end_time}


def _room(run: Run, event: Event) -> float:
    return min(_sides(run, event).values(), default=0.0)


def _apart(run: Run, scene: Scene, event: Event, spacings: NDArray[np.float64]) -> NDArray[np.float64]:
    """Say how far apart the participants are a time before and after an event, the smaller of the two.

    In units of what is clearly apart: a diameter, or a twentieth of the table. An event at the start or at the
    end of the run is looked at from its one side.
    """
    radii = [scene.radii[scene.ids.index(ball)] for ball in event.balls]
    wanted = max(2.0 * float(np.mean(radii)), 0.05 * scene.size)
    gaps = [_gap(run, scene, event, event.time + sign * spacings) for sign in _sides(run, event)]
    apart: NDArray[np.float64] = np.min(gaps or [np.zeros(len(spacings))], axis=0) / wanted
    return apart


def _flight_room(run: Run, event: Event) -> float:
    """Time from the event to the nearest other event of its balls, a little shortened."""
    times = np.asarray(run.events.by_ball(*event.balls)["time"], dtype=float)
    others = np.abs(times - event.time)
    others = others[others > 1e-9 * run.end_time]
    return 0.95 * float(others.min()) if len(others) else np.inf


def _gap(run: Run, scene: Scene, event: Event, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distance between the surfaces of the two balls, or of the ball and the place of contact."""
    places = run.positions(np.clip(times, 0.0, run.end_time))[..., :2]
    chosen = [scene.ids.index(ball) for ball in event.balls]
    other = places[:, chosen[1]] if len(chosen) > 1 else np.array([event.x, event.y])
    one = scene.repeats.nearest(places[:, chosen[0]], other)
    distance = np.linalg.norm(one - other, axis=-1)
    # A ball out of play is as far away as can be.
    gap: NDArray[np.float64] = np.nan_to_num(distance - scene.radii[chosen].sum(), nan=np.inf)
    return gap


def _stepped_times(run: Run, scene: Scene, event: Event, half: int) -> NDArray[np.float64]:
    """Give the starts of the steps before, the contact, and the ends of the full steps after it.

    A ball may wait at the contact place until its step ends; the frame after is the first step's end at which
    one of the participants has left.
    """
    assert run.steps is not None
    steps = np.asarray(run.steps["time"], dtype=float)
    before = steps[steps < event.time]
    after = steps[steps > event.time]
    chosen = [scene.ids.index(ball) for ball in event.balls]
    contact = run.positions([event.time])[0, chosen]
    waiting = 0
    while waiting + half < len(after) and np.array_equal(run.positions([after[waiting]])[0, chosen], contact):
        waiting += 1
    early = np.concatenate([np.full(half, steps[0]), before])[-half:]
    late = np.concatenate([after[waiting:], np.full(half, steps[-1])])[:half]
    return np.concatenate([early, [event.time], late])
