"""How balls on a cloth have turned, and what of their marks is seen from above."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb

from carom.figures.balls import STRIPE
from carom.figures.scene import BARE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.figures.scene import Scene
    from carom.run import Run

DOT = 0.42
"""Radius of the dots of a ball, over its own; they are opposite each other."""
SPREAD = 3
"""Every pixel of a ball is seen at so many times so many places."""


def turned(run: Run, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give how far every ball has turned since time 0, as rotation matrices.

    Between two events the spin is linear in time, so that over a short while h the turn is the one about
    ∫ω dt + (ω' × ω) h³ / 12, exact to the fourth order in h (W. Magnus, 1954). The end of a side spin is no event, and
    its one kink costs ω' h² / 8 at most.

    Parameters
    ----------
    run : Run
        A run on a cloth.
    times : (n_times,) float64
        Ascending; the events between them are minded, too.

    Returns
    -------
    (n_times, n_balls, 3, 3) float64
        From the frame of the ball to that of the table. A ball out of play stays as it was.
    """
    end = float(times[-1])
    events = np.asarray(run.events.by_time(0.0, end)["time"], dtype=float)
    fine = np.unique(np.concatenate([[0.0], times, events, np.linspace(0.0, end, 4 * len(times))]))
    first = np.nan_to_num(run.spins(fine[:-1]))
    last = np.nan_to_num(run.spins(np.nextafter(fine[1:], -np.inf)))
    h = np.diff(fine)[:, None, None]
    # With ω' h = ω₁ − ω₀ that is (ω₁ × ω₀) h² / 12.
    steps = _rotations(0.5 * (first + last) * h + np.cross(last, first) * h**2 / 12.0)
    turns = np.empty((len(fine), *steps.shape[1:]))
    turns[0] = np.eye(3)
    for index, step in enumerate(steps):
        turns[index + 1] = step @ turns[index]
    chosen: NDArray[np.float64] = turns[np.searchsorted(fine, times)]
    return chosen


def seen_from_above(
    scene: Scene, ball: int, turn: NDArray[np.float64], radius: float, shift: tuple[float, float]
) -> NDArray[np.uint8]:
    """Give a ball as a square of pixels, (n, n, 4) uint8 of red, green, blue and opacity, the first row on top.

    Parameters
    ----------
    scene : Scene
        Gives the colours.
    ball : int
        Which ball.
    turn : (3, 3) float64
        How it has turned.
    radius : float
        In pixels.
    shift : (float, float)
        Where its centre is from the middle of the square, in pixels to the right and downwards, from −0.5 to 0.5.
    """
    half = int(np.ceil(radius)) + 1
    fine = (np.arange((2 * half + 1) * SPREAD) + 0.5) / SPREAD - half - 0.5
    x, y = np.meshgrid((fine - shift[0]) / radius, -(fine - shift[1]) / radius)
    squared = x**2 + y**2
    up = np.sqrt(np.maximum(0.0, 1.0 - squared))
    own = np.stack([x, y, up], axis=-1) @ turn
    is_dot = own[..., 2] ** 2 > 1.0 - DOT**2
    colour, dot = (np.array(to_rgb(each)) for each in (scene.colours[ball], _dot(scene, ball)))
    picture = np.broadcast_to(colour, (*x.shape, 3)).copy()
    if scene.is_striped(ball):
        picture[np.abs(own[..., 1]) > STRIPE] = to_rgb(BARE)
    picture[is_dot] = dot
    picture[squared > (1.0 - 1.2 / radius) ** 2] = to_rgb("#1d2327")
    inside = squared <= 1.0
    blocks = (2 * half + 1, SPREAD, 2 * half + 1, SPREAD)
    opacity = inside.reshape(blocks).mean(axis=(1, 3))
    weight = np.maximum(opacity, 1e-9)[..., None] * SPREAD**2
    mean = (picture * inside[..., None]).reshape(*blocks, 3).sum(axis=(1, 3)) / weight
    pixels: NDArray[np.uint8] = np.rint(255 * np.concatenate([mean, opacity[..., None]], axis=-1)).astype(np.uint8)
    return pixels


def _dot(scene: Scene, ball: int) -> str:
    """Give the colour of a ball's dots: white on colours, red on white."""
    red, green, blue = to_rgb(scene.colours[ball])
    return "#c8402f" if min(red, green, blue) > 0.85 else BARE


def _rotations(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the rotations about vectors (..., 3) by their lengths, (..., 3, 3)."""
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    x, y, z = np.moveaxis(vectors, -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*vectors.shape[:-1], 3, 3)
    safe = np.where(angle > 0.0, angle, 1.0)
    twice = (1.0 - np.cos(angle)) / safe**2 * (cross @ cross)
    turns: NDArray[np.float64] = np.eye(3) + np.sinc(angle / np.pi) * cross + twice
    return turns
