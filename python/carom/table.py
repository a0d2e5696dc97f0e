"""Tables: the region the balls move in, and what stands in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any, Literal

from carom.section import Section

if TYPE_CHECKING:
    from carom.vectors import Vector


NoseContact = Literal["nose", "plan"]


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
class Pocket(Section):
    """A round hole of a table: a ball whose centre comes over it drops."""

    id: str
    center: Vector
    radius: float


@dataclass(frozen=True, eq=False, repr=False)
class Mouth(Section):
    """The mouth of the pockets of a `Table.pocket_table`, and the hole behind it.

    Parameters
    ----------
    width : float
        Between the tips of the cushions.
    angle_deg : float
        By how much the facings open, in degrees.
    depth : float
        How far the hole's centre lies behind the nose line, or the corner.
    radius : float
        Of the hole.
    jaw_radius : float
        Of the rounding where a cushion turns into its facing.
    """

    _: KW_ONLY
    width: float
    angle_deg: float
    depth: float
    radius: float
    jaw_radius: float


@dataclass(frozen=True, eq=False, repr=False)
class Table(Section):
    """The region the balls move in; made by `rectangle`, `circle`, `path`, `pocket_table` or `preset`.

    For cue sports each shape takes `nose_height` (the height of the cushions' noses above the cloth), `nose_contact`
    (``nose``, or ``plan``: balls touch at one radius from the nose line) and, but for the last two, `pockets`.

    Examples
    --------
    >>> Table.rectangle(width=1, length=2, obstacles=[Circle((0.5, 1.0), 0.1)])
    Table(shape='rectangle', width=1, length=2, obstacles=[Circle(center=(0.5, 1.0), radius=0.1)])
    """

    shape: str | None
    width: float | None = None
    length: float | None = None
    radius: float | None = None
    pieces: Sequence[Line | Arc] | None = None
    obstacles: Sequence[Obstacle] | None = None
    _: KW_ONLY
    name: str | None = None
    cushion_width: float | None = None
    corner: Mouth | None = None
    side: Mouth | None = None
    pockets: Sequence[Pocket] | None = None
    nose_height: float | None = None
    nose_contact: NoseContact | None = None

    @classmethod
    def rectangle(
        cls, *, width: float, length: float, obstacles: Sequence[Obstacle] = (), **for_cue_sports: Any
    ) -> Table:
        """Give a rectangle, lower left corner at the origin; cushions ``left, right, bottom, top``."""
        return cls("rectangle", width=width, length=length, obstacles=obstacles or None, **for_cue_sports)

    @classmethod
    def circle(cls, *, radius: float, obstacles: Sequence[Obstacle] = (), **for_cue_sports: Any) -> Table:
        """Give a circle around the origin; its one cushion is ``rim``."""
        return cls("circle", radius=radius, obstacles=obstacles or None, **for_cue_sports)

    @classmethod
    def path(cls, pieces: Sequence[Line | Arc], *, obstacles: Sequence[Obstacle] = (), **for_cue_sports: Any) -> Table:
        """Give the inside of a closed path, its pieces in order and counter-clockwise."""
        return cls("path", pieces=pieces, obstacles=obstacles or None, **for_cue_sports)

    @classmethod
    def pocket_table(
        cls,
        *,
        width: float,
        length: float,
        cushion_width: float,
        corner: Mouth,
        side: Mouth,
        nose_height: float | None = None,
        nose_contact: NoseContact | None = None,
    ) -> Table:
        """Give a rectangle with six pockets, four at the corners and two in the middle of the long sides."""
        return cls(
            "pocket_table",
            width=width,
            length=length,
            cushion_width=cushion_width,
            corner=corner,
            side=side,
            nose_height=nose_height,
            nose_contact=nose_contact,
        )

    @classmethod
    def preset(cls, name: str, **different: Any) -> Table:
        """Give a ready-made table, with its balls, cue and laws.

        Parameters
        ----------
        name : str
            ``pool_9ft``, ``pool_8ft``, ``pool_8ft_home``, ``pool_7ft``, ``snooker_12ft``, ``carom_10ft``,
            ``english_pool``, ``pooltool_7ft``, ``pooltool_snooker`` or ``pooltool_carom``.
        **different
            Keys of its shape that are to be different, such as `nose_contact`.

        Examples
        --------
        >>> Table.preset("pool_9ft")
        Table(name='pool_9ft')
        """
        return cls(None, name=name, **different)

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the table."""
        values = super().to_dict()
        return {"preset": values.pop("name"), **values} if self.name is not None else values


def _named(name: str | None) -> dict[str, str]:
    return {} if name is None else {"id": name}
