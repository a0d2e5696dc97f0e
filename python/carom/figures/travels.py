"""Where balls on a cloth went, and how: sliding, rolling, through the air, out of play."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Circle

from carom.figures import style

if TYPE_CHECKING:
    from typing import Any

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.events import Event
    from carom.figures.scene import Scene
    from carom.run import Run

WAYS: dict[str, tuple[str, Any]] = {
    "rolling": ("rolling", "solid"),
    "sliding": ("sliding", (0, (2.6, 1.3))),
    "airborne": ("in the air", (0, (0.9, 1.5))),
}
"""The words and the dashes of the motions that take a ball somewhere."""
SUNK = 0.8
"""Size of a ball in a pocket, over its own."""


@dataclass(frozen=True)
class Travels:
    """The ways of all balls.

    Attributes
    ----------
    places : (n_times, n_balls, 2) float64
        Seen from above; of a ball out of play, where it ended.
    motions : (n_times, n_balls) str
        How they move.
    out : tuple of Event
        The events that took a ball out of play, in order.
    """

    scene: Scene
    places: NDArray[np.float64]
    motions: NDArray[np.object_]
    out: tuple[Event, ...]

    @classmethod
    def of(cls, run: Run, scene: Scene, times: NDArray[np.float64]) -> Travels:
        """Follow the balls of a run at some ascending times."""
        places = run.positions(times)[..., :2].copy()
        out = tuple(run.events.by_kind("ball_pocket", "off_table"))
        for event, end in zip(out, _ends(scene, out), strict=True):
            ball = scene.ids.index(str(event.ball_a))
            places[~np.isfinite(places[:, ball, 0]), ball] = end
        return cls(scene, places, run.motion(times), out)

    @property
    def fallen(self) -> list[int]:
        """The balls that are out of play at the end, in the order in which they left it."""
        return [self.scene.ids.index(str(event.ball_a)) for event in self.out]

    @property
    def ways(self) -> list[str]:
        """The motions of `WAYS` that occur."""
        return [way for way in WAYS if np.any(self.motions == way)]


def draw_travels(ax: Axes, travels: Travels, *, crowding: float) -> None:
    """Draw the path of every ball, a line for each of its ways; the more crowded (0 to 1), the thinner and fainter."""
    for ball, colour in enumerate(travels.scene.lines):
        for way in WAYS:
            stretches = _stretches(travels.motions[:, ball] == way)
            if stretches:
                gap = np.full((1, 2), np.nan)
                parts = [part for first, end in stretches for part in (travels.places[first:end, ball], gap)]
                ax.plot(
                    *np.concatenate(parts[:-1]).T,
                    color=colour,
                    linewidth=1.3 - 0.4 * crowding,
                    linestyle=WAYS[way][1],
                    alpha=0.9 - 0.1 * crowding,
                    solid_joinstyle="round",
                    zorder=2.0,
                )


def draw_sunk(ax: Axes, travels: Travels) -> None:
    """Draw the balls in their pockets, a little smaller, with rims that show on the dark."""
    scene = travels.scene
    for event, ball in zip(travels.out, travels.fallen, strict=True):
        if event.kind == "ball_pocket":
            x, y = travels.places[-1, ball].tolist()
            radius = SUNK * float(scene.radii[ball])
            disc = Circle((x, y), radius, facecolor=scene.faces[ball], edgecolor=style.SIGHT, linewidth=0.8)
            disc.set(alpha=0.9, zorder=2.8)
            ax.add_patch(disc)


def _stretches(held: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Give the slices of times over which a motion goes on, each with the first time of what follows it."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], held, [False]])))
    return [(int(first), min(int(end) + 1, len(held))) for first, end in edges.reshape(-1, 2)]


def _ends(scene: Scene, out: tuple[Event, ...]) -> list[NDArray[np.float64]]:
    """Give where each ball out of play is drawn: in its pocket, around its centre where there are several."""
    pockets = [np.array(pocket["center"], dtype=float) for pocket in scene.rails.pockets] if scene.rails else []
    ends: list[NDArray[np.float64]] = []
    held: dict[int, int] = {}
    for event in out:
        place = np.array(event.position)
        if event.kind == "ball_pocket" and pockets:
            pocket = int(np.argmin([np.linalg.norm(place - centre) for centre in pockets]))
            held[pocket] = count = held.get(pocket, -1) + 1
            radius = float(scene.radii[scene.ids.index(str(event.ball_a))])
            place = pockets[pocket] + 0.5 * radius * _spiral(count)
        ends.append(place)
    return ends


def _spiral(count: int) -> NDArray[np.float64]:
    """Give places around a centre, the first in it."""
    return np.array([np.cos(2.4 * count), np.sin(2.4 * count)]) * min(count, 1)
