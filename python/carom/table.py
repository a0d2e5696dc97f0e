"""Tables: the region the balls move in, and what stands in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any

from carom.section import Section

if TYPE_CHECKING:
    from carom.vectors import Vector


@dataclass(frozen=True, eq=False, repr=False)
class Line(Section):
    """A straight piece of a path from `start` to `end`; the table lies to its left."""

    start: Vector
    end: Vector
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the piece."""
        return {"line": [self.start, self.end], **_named(self.id)}


@dataclass(frozen=True, eq=False, repr=False)
class Arc(Section):
    """A round piece of a path.

    It runs counter-clockwise (hollow) where `to_deg` is larger than `from_deg`, else clockwise (bulging); the
    table lies to the left of its direction.
    """

    center: Vector
    radius: float
    _: KW_ONLY
    from_deg: float
    to_deg: float
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the piece."""
        shape = {
            "center": self.center,
            "radius": self.radius,
            "from_deg": self.from_deg,
            "to_deg": self.to_deg,
        }
        return {"arc": shape, **_named(self.id)}


@dataclass(frozen=True, eq=False, repr=False)
class Circle(Section):
    """A round pillar on a table."""

    center: Vector
    radius: float
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the obstacle."""
        return {"circle": {"center": self.center, "radius": self.radius}, **_named(self.id)}


@dataclass(frozen=True, eq=False, repr=False)
class Wall(Section):
    """A thin wall on a table, hit from both sides."""

    start: Vector
    end: Vector
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the obstacle."""
        return {"wall": [self.start, self.end], **_named(self.id)}


@dataclass(frozen=True, eq=False, repr=False)
class Path(Section):
    """An obstacle bounded by a closed path of pieces, drawn clockwise, so that the table lies to its left."""

    pieces: Sequence[Line | Arc]
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the obstacle."""
        return {"path": self.pieces, **_named(self.id)}


Obstacle = Circle | Wall | Path
"""What can stand on a table."""


@dataclass(frozen=True, eq=False, repr=False)
class Table(Section):
    """The region the balls move in; made by `rectangle`, `circle` or `path`.

    Examples
    --------
    >>> Table.rectangle(width=1, length=2, obstacles=[Circle((0.5, 1.0), 0.1)])
    Table(shape='rectangle', width=1, length=2, obstacles=[Circle(center=(0.5, 1.0), radius=0.1)])
    """

    shape: str
    width: float | None = None
    length: float | None = None
    radius: float | None = None
    pieces: Sequence[Line | Arc] | None = None
    obstacles: Sequence[Obstacle] | None = None

    @classmethod
    def rectangle(cls, *, width: float, length: float, obstacles: Sequence[Obstacle] = ()) -> Table:
        """Give a rectangle, lower left corner at the origin; cushions ``left, right, bottom, top``."""
        return cls("rectangle", width=width, length=length, obstacles=obstacles or None)

    @classmethod
    def circle(cls, *, radius: float, obstacles: Sequence[Obstacle] = ()) -> Table:
        """Give a circle around the origin; its one cushion is ``rim``."""
        return cls("circle", radius=radius, obstacles=obstacles or None)

    @classmethod
    def path(cls, pieces: Sequence[Line | Arc], *, obstacles: Sequence[Obstacle] = ()) -> Table:
        """Give the inside of a closed path, its pieces in order and counter-clockwise."""
        return cls("path", pieces=pieces, obstacles=obstacles or None)


def _named(name: str | None) -> dict[str, str]:
    return {} if name is None else {"id": name}
