"""The part of a table around an event, for balls that are small on the whole of it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from carom.figures.moments import frame_times
from carom.figures.table import shown_radii

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.events import Event
    from carom.figures.scene import Scene
    from carom.run import Run

LEAST = 13.0
"""Side of the picture over the radius of the larger ball, at least."""
AROUND = 4.0
"""Room around the centres of the balls, over the radius, at least."""
SHARE = 0.2
"""The same, over what the centres span."""
PACKED = 0.5
"""Gap of two balls of one pack over the smaller radius, at most."""


def close_to(run: Run, scene: Scene, event: Event, frames: int) -> tuple[Scene, NDArray[np.float64]]:
    """Give the scene whose bounds are the neighbourhood of an event, and the times of its frames.

    The balls of the event are in the picture in every frame, and so is the pack that they belong to when they meet.
    """
    centre = np.array(event.position)
    chosen = [scene.ids.index(ball) for ball in event.balls]
    radius = float(shown_radii(scene)[chosen].max())
    near = _square(scene, np.stack([centre, centre]), LEAST * radius)
    times = frame_times(run, near, event, frames)
    places = scene.repeats.nearest(run.positions(times)[:, chosen, :2].reshape(-1, 2), centre)
    places = np.concatenate([places, _pack(run, scene, event, chosen), [centre]])
    places = places[np.isfinite(places[:, 0])]
    ends = np.stack([places.min(axis=0), places.max(axis=0)])
    span = float(np.ptp(ends, axis=0).max())
    side = max(LEAST * radius, span + 2.0 * max(AROUND * radius, SHARE * span))
    return _square(scene, ends, side), times


def _pack(run: Run, scene: Scene, event: Event, chosen: list[int]) -> NDArray[np.float64]:
    """Give the places (n, 2) of all balls that lie close to those of an event, from neighbour to neighbour."""
    places = scene.repeats.nearest(run.positions([event.time])[0, :, :2], np.array(event.position))
    radii = scene.radii
    gaps = np.linalg.norm(places[:, None] - places, axis=-1) - radii[:, None] - radii
    close = gaps <= PACKED * np.minimum(radii[:, None], radii)  # never for balls out of play, whose gaps are NaN
    packed = np.zeros(len(radii), dtype=bool)
    packed[chosen] = True
    while (grown := packed | close[packed].any(axis=0)).sum() > packed.sum():
        packed = grown
    return np.asarray(places[packed])


def _square(scene: Scene, ends: NDArray[np.float64], side: float) -> Scene:
    """Give the scene bounded by a square around two places, moved into the table, or cut where it is larger."""
    low, high = np.array(scene.bounds[:2]), np.array(scene.bounds[2:])
    start = np.clip(ends.mean(axis=0) - side / 2, low, np.maximum(low, high - side))
    end = np.minimum(start + side, high)
    return replace(scene, bounds=(*start.tolist(), *end.tolist()))
