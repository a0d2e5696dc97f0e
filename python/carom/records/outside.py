"""What files of other programs say otherwise: boxes with a third dimension, and what they leave out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.errors import RecordError


@dataclass(frozen=True)
class Assumed:
    """What is taken for granted where a file does not say it; None: that it says it.

    Parameters
    ----------
    radius, mass : float or None
        Those of every disc.
    velocity : float or None
        Both components, for every disc.
    time_step : float
        The time of one step or frame, where the file counts these.
    """

    radius: float | None = None
    mass: float | None = None
    velocity: float | None = None
    time_step: float = 1.0

    def or_else(self, **defaults: float) -> Assumed:
        """Give the same with defaults where nothing was given."""
        return replace(self, **{name: value for name, value in defaults.items() if getattr(self, name) is None})


def flat_box(box: NDArray[Any], tilts: tuple[str, ...]) -> NDArray[Any]:
    """Give width and height of a box (Lx, Ly, Lz, tilts ...); one that is tilted is refused, its tilt by name."""
    tilted = [(name, float(tilt)) for name, tilt in zip(tilts, box[3:], strict=False) if tilt != 0]
    if tilted:
        name, tilt = tilted[0]
        raise RecordError([("box", f"must be a rectangle, but it has the tilt {name} = {tilt:g}")])
    return np.asarray(box[:2])


def flat(name: str, values: NDArray[Any], *, still: bool = False) -> NDArray[Any]:
    """Give the columns x and y; z must be the same for all discs, and zero if it is to be `still`.

    Parameters
    ----------
    name : str
        The field, for the error.
    values : (n, 2 or 3) array
        Positions, velocities or images.
    still : bool
        Whether z must be zero, as of velocities.
    """
    if values.shape[1] == 3:
        depth = values[:, 2]
        moved = depth != (0 if still else depth[:1])
        if moved.any():
            disc = int(np.argmax(moved))
            wanted = "zero" if still else "the same for all, as discs lie in one plane"
            raise RecordError([(f"{name}[{disc}, 2]", f"z must be {wanted}, got {depth[disc]:g}")])
    return np.ascontiguousarray(values[:, :2])


def in_box(
    positions: NDArray[np.float64], size: NDArray[np.float64], images: NDArray[Any] | None
) -> NDArray[np.float64]:
    """Give positions that are not wrapped, of wrapped ones and images."""
    return positions if images is None else positions + images * size


def repeated(value: float, discs: int, columns: int) -> NDArray[np.float64]:
    """Give one number for every disc: as (discs,), or as a vector in x and y, (discs, columns)."""
    if columns == 1:
        return np.full(discs, value)
    vectors = np.zeros((discs, columns))
    vectors[:, :2] = value
    return vectors
