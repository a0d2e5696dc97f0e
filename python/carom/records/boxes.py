"""What files say otherwise than Carom: wrapped positions, boxes centred on the origin, species."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from carom.errors import RecordError
from carom.records.snapshot import Snapshot, same_bits

MOST_SPECIES = 26
OUTSIDE = 1e-9  # of the box's size: more than round-off puts a disc beyond a wall by


def wrapped(snapshot: Snapshot) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Give positions within the box, and in which image of it the discs are.

    Returns
    -------
    positions : (n, 2) float64
        From zero to the size, the size itself left out where the box is periodic.
    images : (n, 2) int32
        Zero where there are walls.
    """
    images = np.where(snapshot.periodic, np.floor(snapshot.positions / snapshot.size), 0.0)
    limit = float(np.iinfo(np.int32).max)
    if np.abs(images).max() >= limit:
        raise RecordError([("positions", f"must be within {limit:.0f} boxes of the origin")])
    inside = snapshot.positions - images * snapshot.size
    # A quotient or difference that was rounded up ends on the far side, or a hair before the near one.
    over = snapshot.periodic & (inside >= snapshot.size)
    images += over
    inside = np.where(over | (snapshot.periodic & (inside < 0.0)), 0.0, inside)
    return inside, images.astype(np.int32)


def centred(snapshot: Snapshot) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Give what HOOMD-blue takes: positions from −L/2 to L/2 in float32, (n, 3), and images, (n, 3) int32.

    Raises
    ------
    RecordError
        If a disc's centre is beyond a wall, where HOOMD-blue has no place for it.
    """
    inside, images = wrapped(snapshot)
    beyond = ~snapshot.periodic & ((inside < -OUTSIDE * snapshot.size) | (inside > (1.0 + OUTSIDE) * snapshot.size))
    if beyond.any():
        disc = int(np.argmax(beyond.any(axis=1)))
        raise RecordError([(f"positions[{disc}]", "is beyond a wall of the box")])
    half = snapshot.size.astype(np.float32) / np.float32(2)
    below = np.nextafter(half, np.float32(0))
    shifted = (inside - snapshot.size / 2.0).astype(np.float32)
    over = snapshot.periodic & (shifted >= half)
    places = np.zeros((len(snapshot), 3), dtype=np.float32)
    places[:, :2] = np.clip(np.where(over, -half, shifted), -half, below)
    turns = np.zeros((len(snapshot), 3), dtype=np.int32)
    turns[:, :2] = images + over
    return places, turns


def species(radii: NDArray[np.float64], masses: NDArray[np.float64]) -> tuple[list[str], NDArray[np.uint32]]:
    """Sort discs into species of one radius and mass: A is the smallest, of equal ones the lightest.

    More than 26 of them are no species but a distribution: then all are A.

    >>> names, typeid = species(np.array([2.0, 1.0, 1.0]), np.ones(3))
    >>> names, typeid.tolist()
    (['A', 'B'], [1, 0, 0])
    """
    if same_bits(radii, np.full_like(radii, radii[0])) and same_bits(masses, np.full_like(masses, masses[0])):
        return ["A"], np.zeros(len(radii), dtype=np.uint32)
    _, by_size = np.unique(radii, return_inverse=True)
    weights, by_weight = np.unique(masses, return_inverse=True)
    kinds, codes = np.unique(by_size * len(weights) + by_weight, return_inverse=True)
    if len(kinds) > MOST_SPECIES:
        return ["A"], np.zeros(len(radii), dtype=np.uint32)
    return [chr(ord("A") + kind) for kind in range(len(kinds))], codes.astype(np.uint32)
