"""The laws of motion and of collision, as a scenario names them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from carom.section import Section

if TYPE_CHECKING:
    from carom.vectors import Vector


@dataclass(frozen=True, eq=False, repr=False)
class Free(Section):
    """Straight flight at constant velocity."""

    tag: ClassVar = {"law": "free"}


@dataclass(frozen=True, eq=False, repr=False)
class Field(Section):
    """Flight with the same constant `acceleration` (x, y) for all balls, in length per time squared."""

    tag: ClassVar = {"law": "field"}

    acceleration: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Elastic(Section):
    """A contact that loses no energy; between balls, or of a ball and a cushion."""

    tag: ClassVar = {"law": "elastic"}


@dataclass(frozen=True, eq=False, repr=False)
class Restitution(Section):
    """A contact after which the speed along the normal is `normal` times what it was, reversed.

    Parameters
    ----------
    normal : float
        From 0 to 1 (elastic).
    tangential : float, optional
        At cushions only: speed along the cushion after over before, from 0 to 1; absent: 1.
    """

    tag: ClassVar = {"law": "restitution"}

    _: KW_ONLY
    normal: float
    tangential: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Damping(Section):
    """A cushion that gives back the mirrored velocity times `factor`, from 0 to 1."""

    tag: ClassVar = {"law": "damping"}

    factor: float


BallLaw = Elastic | Restitution
"""What can happen when two balls meet."""

CushionLaw = Elastic | Restitution | Damping
"""What can happen when a ball meets a cushion."""


@dataclass(frozen=True, eq=False, repr=False)
class Physics(Section):
    """The laws of a scenario; each one absent is the first named.

    Parameters
    ----------
    flight : Free or Field, optional
        How balls move between events.
    ball_ball : BallLaw, optional
        What happens when two balls meet.
    ball_cushion : CushionLaw, optional
        What happens when a ball meets a cushion.
    cushions : mapping of str to CushionLaw, optional
        Laws of single cushions, by the cushion's id, in place of `ball_cushion`.
    cluster : "reflections", "hertz" or "pairwise", optional
        How contacts at one instant are resolved.
    collapse : "stop" or "tc", optional
        What is done when a ball's contacts follow each other without end in a finite time: the run stops, or contacts
        within a very short time t_c lose nothing, so that balls in a field go on hopping and do not come to rest.

    Examples
    --------
    >>> Physics(ball_cushion=Damping(0.8), cushions={"left": Elastic()})
    Physics(ball_cushion=Damping(factor=0.8), cushions={'left': Elastic()})
    """

    _: KW_ONLY
    flight: Free | Field | None = None
    ball_ball: BallLaw | None = None
    ball_cushion: CushionLaw | None = None
    cushions: Mapping[str, CushionLaw] | None = None
    cluster: Literal["reflections", "hertz", "pairwise"] | None = None
    collapse: Literal["stop", "tc"] | None = None
