"""The laws of motion and of collision, as a scenario names them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
class Cloth(Section):
    """Rolling, sliding and spinning on a cloth, and through the air above it.

    Parameters
    ----------
    gravity : float, optional
        Acceleration of free fall; absent: 9.81.
    restitution : float, optional
        Speed up from the cloth over speed down to it, of a ball that lands, from 0 to 1; absent: 0.5.
    friction : float, optional
        Coefficient of friction of a landing; absent: the ball's `sliding_friction`.
    min_hop : float, optional
        Hops that would rise less than this, in length, are left out; absent: 0.005.
    air : bool, optional
        Whether balls can leave the cloth; absent: True.
    """

    tag: ClassVar = {"law": "cloth"}

    _: KW_ONLY
    gravity: float | None = None
    restitution: float | None = None
    friction: float | None = None
    min_hop: float | None = None
    air: bool | None = None


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


BySpeed = Mapping[str, Sequence[float] | float]
"""A restitution by the closing speed: ``{"by_speed": [c0, c1, c2], "up_to": v}``."""

ByIncidence = Mapping[str, Sequence[float]]
"""A friction by the angle θ between velocity and normal: ``{"by_incidence": [c0, c1]}`` is c0 + c1 θ."""


@dataclass(frozen=True, eq=False, repr=False)
class Frictional(Section):
    """A contact with restitution, and friction where the surfaces slip: between balls, or at a cushion's nose.

    Parameters
    ----------
    normal : float or mapping
        Speed of parting over closing speed, from 0 to 1; at cushions also `BySpeed`.
    friction : float or mapping, optional
        The coefficient. Between balls ``{"a", "b", "c"}`` is a + b exp(−c s) of the slip speed s, and absent it is
        Alciatore's fit; at cushions it must be given, and may be `ByIncidence`.
    cling : float, optional
        Between balls only: what friction is multiplied with; absent: 1.
    """

    tag: ClassVar = {"law": "frictional"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | Mapping[str, float] | ByIncidence | None = None
    cling: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Mathavan2014(Section):
    """Balls with friction between them, and of the one pressed onto the cloth; parameters as of `Frictional`."""

    tag: ClassVar = {"law": "mathavan_2014"}

    _: KW_ONLY
    normal: float
    friction: float | Mapping[str, float] | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Han2005(Section):
    """A cushion by Han's law of 2005; `normal` and `friction` as `Frictional` at cushions."""

    tag: ClassVar = {"law": "han_2005"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence


@dataclass(frozen=True, eq=False, repr=False)
class Mathavan2010(Section):
    """A cushion by Mathavan, Jackson and Parkin's law of 2010; `normal` and `friction` as `Frictional` at cushions."""

    tag: ClassVar = {"law": "mathavan_2010"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence


@dataclass(frozen=True, eq=False, repr=False)
class StrongeCompliant(Section):
    """A cushion that gives way along the nose too; `normal` and `friction` as `Frictional` at cushions.

    `frequency_ratio`, from 1 to 2, is the frequency of the swing along the nose over that into it; absent: 1.8.
    """

    tag: ClassVar = {"law": "stronge_compliant"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence
    frequency_ratio: float | None = None


BallLaw = Elastic | Restitution | Frictional | Mathavan2014
"""What can happen when two balls meet."""

CushionLaw = Elastic | Restitution | Damping | Frictional | Han2005 | Mathavan2010 | StrongeCompliant
"""What can happen when a ball meets a cushion."""


@dataclass(frozen=True, eq=False, repr=False)
class Physics(Section):
    """The laws of a scenario; each one absent is the first named.

    Parameters
    ----------
    flight : Free, Field or Cloth, optional
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
    flight: Free | Field | Cloth | None = None
    ball_ball: BallLaw | None = None
    ball_cushion: CushionLaw | None = None
    cushions: Mapping[str, CushionLaw] | None = None
    cluster: Literal["reflections", "hertz", "pairwise"] | None = None
    collapse: Literal["stop", "tc"] | None = None
