"""Tables: the region the balls move in, and what stands in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any, Literal

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

Axis = Literal["x", "y"]
"""An axis of a table: across its width, or along its length."""

NoseContact = Literal["nose", "plan"]
"""Where a ball touches the nose of a cushion: where the nose is, or one radius from it as seen from above."""


@dataclass(frozen=True, eq=False, repr=False)
class Pocket(Section):
    """A circle that balls fall into, on a cloth: when their centre is inside."""

    id: str
    center: Vector
    radius: float


@dataclass(frozen=True, eq=False, repr=False)
class Mouth(Section):
    """The pockets at the corners of a pocket table, or those in the middle of its long sides.

    A `Table.pocket_table` needs all of it; a `Table.preset` only what is different.

    Parameters
    ----------
    width : float
        Width of the mouth, in length, between the points in which the lines of the noses and of the facings meet.
    angle_deg : float
        By how much each facing narrows the pocket, in degrees from its axis.
    depth : float
        How far the centre of the hole lies outside the nose corner, or the nose line of a side.
    radius : float
        Radius of the hole; a ball falls when its centre is inside.
    jaw_radius : float
        Radius of the jaws' rounding; zero: the noses end in points.
    """

    _: KW_ONLY
    width: float | None = None
    angle_deg: float | None = None
    depth: float | None = None
    radius: float | None = None
    jaw_radius: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Table(Section):
    """The region the balls move in; made by `preset`, `pocket_table`, `rectangle`, `circle` or `path`.

    What they have in common: `obstacles` stand on the table. On a cloth `nose_height` is the height of the cushions'
    noses, absent that of the ball's centre; `nose_contact` says where a ball touches a nose, ``"nose"`` where the nose
    is or ``"plan"`` when its centre is one radius away as seen from above, as in pooltool; `pockets` are circles that
    balls fall into.

    Examples
    --------
    >>> Table.rectangle(width=1, length=2, obstacles=[Circle((0.5, 1.0), 0.1)])
    Table(shape='rectangle', width=1, length=2, obstacles=[Circle(center=(0.5, 1.0), radius=0.1)])
    >>> Table.preset("pool_9ft", corner=Mouth(width=0.12))
    Table(preset='pool_9ft', corner=Mouth(width=0.12))
    """

    shape: str | None = None
    name: str | None = None
    width: float | None = None
    length: float | None = None
    periodic: Sequence[Axis] | None = None
    radius: float | None = None
    cushion_width: float | None = None
    corner: Mouth | None = None
    side: Mouth | None = None
    pieces: Sequence[Line | Arc] | None = None
    obstacles: Sequence[Obstacle] | None = None
    nose_height: float | None = None
    nose_contact: NoseContact | None = None
    pockets: Sequence[Pocket] | None = None

    @classmethod
    def preset(
        cls,
        name: str,
        *,
        width: float | None = None,
        length: float | None = None,
        cushion_width: float | None = None,
        corner: Mouth | None = None,
        side: Mouth | None = None,
        obstacles: Sequence[Obstacle] = (),
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
    ) -> Table:
        """Give a table that comes with Carom (`carom.presets` lists them), with its balls, its cue and its laws.

        Each further key replaces the preset's.
        """
        return cls(
            name=name,
            width=width,
            length=length,
            cushion_width=cushion_width,
            corner=corner,
            side=side,
            obstacles=obstacles or None,
            nose_height=nose_height,
            nose_contact=nose_contact,
        )

    @classmethod
    def pocket_table(
        cls,
        *,
        width: float,
        length: float,
        cushion_width: float,
        corner: Mouth,
        side: Mouth,
        obstacles: Sequence[Obstacle] = (),
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
    ) -> Table:
        """Give a table with six pockets, lower left nose corner at the origin; `cushion_width` is nose to facing end.

        Cushions are ``bottom, right_lower, right_upper, top, left_upper, left_lower``; pockets ``lb, lc, lt, rb, rc,
        rt``, each with cushions such as ``lb.jaw_left``, ``lb.facing_left`` and ``lb.back``.
        """
        return cls(
            "pocket_table",
            width=width,
            length=length,
            cushion_width=cushion_width,
            corner=corner,
            side=side,
            obstacles=obstacles or None,
            nose_height=nose_height,
            nose_contact=nose_contact,
        )

    @classmethod
    def rectangle(
        cls,
        *,
        width: float,
        length: float,
        periodic: Sequence[Axis] = (),
        obstacles: Sequence[Obstacle] = (),
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
        pockets: Sequence[Pocket] = (),
    ) -> Table:
        """Give a rectangle, lower left corner at the origin; cushions ``left, right, bottom, top``.

        Along the axes in `periodic`, such as ``("x", "y")``, it has no cushions: a ball that leaves on one side comes
        in on the other.
        """
        return cls(
            "rectangle",
            width=width,
            length=length,
            periodic=list(periodic) or None,
            obstacles=obstacles or None,
            nose_height=nose_height,
            nose_contact=nose_contact,
            pockets=pockets or None,
        )

    @classmethod
    def circle(
        cls,
        *,
        radius: float,
        obstacles: Sequence[Obstacle] = (),
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
        pockets: Sequence[Pocket] = (),
    ) -> Table:
        """Give a circle around the origin; its one cushion is ``rim``."""
        return cls(
            "circle",
            radius=radius,
            obstacles=obstacles or None,
            nose_height=nose_height,
            nose_contact=nose_contact,
            pockets=pockets or None,
        )

    @classmethod
    def path(
        cls,
        pieces: Sequence[Line | Arc],
        *,
        obstacles: Sequence[Obstacle] = (),
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
        pockets: Sequence[Pocket] = (),
    ) -> Table:
        """Give the inside of a closed path, its pieces in order and counter-clockwise."""
        return cls(
            "path",
            pieces=pieces,
            obstacles=obstacles or None,
            nose_height=nose_height,
            nose_contact=nose_contact,
            pockets=pockets or None,
        )

    def _present(self) -> dict[str, Any]:
        # A field cannot have the name of the classmethod that sets it.
        return {"preset" if key == "name" else key: value for key, value in super()._present().items()}


def _named(name: str | None) -> dict[str, str]:
    return {} if name is None else {"id": name}
