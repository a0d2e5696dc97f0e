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
class Cloth(Section):
    """Balls that slide, roll and spin on a cloth, and fly over it: with this law they are spheres.

    How a ball rubs on the cloth, its `sliding_friction`, `rolling_friction` and `spin_decay`, stands with the ball.

    Parameters
    ----------
    gravity : float, optional
        Acceleration of free fall; absent: 9.81.
    restitution : float, optional
        Speed up over speed down of a ball that lands on the cloth, from 0 to 1; absent: 0.5.
    friction : float, optional
        Coefficient of friction of a landing; absent: the ball's `sliding_friction`.
    min_hop : float, optional
        Hops that would rise less than this, in length, are left out; absent: 0.005.
    air : bool, optional
        Whether balls can leave the cloth; absent: true.
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


@dataclass(frozen=True, eq=False, repr=False)
class FallingFriction(Section):
    """A coefficient of friction between balls that falls with the speed s at which they slip: a + b exp(−c s).

    Alciatore's fit to Marlow's measurements, ``FallingFriction(0.009951, 0.108, 1.088)`` with speeds in m/s, is what
    the laws take that are given no friction.
    """

    a: float
    b: float
    c: float


@dataclass(frozen=True, eq=False, repr=False)
class BySpeed(Section):
    """A coefficient of restitution that depends on the closing speed v: c0 + c1 v + c2 v².

    Parameters
    ----------
    by_speed : (3,) sequence of float
        The coefficients c0, c1 and c2; what they give must lie between 0 and 1 at every speed up to `up_to`.
    up_to : float
        Faster contacts have the restitution of this speed.
    """

    by_speed: Vector
    _: KW_ONLY
    up_to: float


@dataclass(frozen=True, eq=False, repr=False)
class ByIncidence(Section):
    """A coefficient of friction with a cushion that depends on the angle of incidence θ, in radians: c0 + c1 θ.

    Parameters
    ----------
    by_incidence : (2,) sequence of float
        The coefficients c0 and c1; what they give must not be negative for angles from 0 to π/2.
    """

    by_incidence: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Frictional(Section):
    """A contact with restitution, and friction where the surfaces slip on each other; on a cloth only.

    Between balls it makes throw and passes spin on; at a cushion it is one impulse at the point of the nose.

    Parameters
    ----------
    normal : float or BySpeed
        Speed away over speed towards, along the normal, from 0 to 1; by speed at cushions only.
    friction : float, FallingFriction or ByIncidence
        The coefficient of friction. Between balls it may be left out, for Alciatore's fit, or fall with the speed; at
        cushions it is needed, and may depend on the angle of incidence.
    cling : float, optional
        Between balls only: what friction is multiplied with; absent: 1.
    """

    tag: ClassVar = {"law": "frictional"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | FallingFriction | ByIncidence | None = None
    cling: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Mathavan2014(Section):
    """Two balls as Mathavan, Jackson and Parkin have them in 2014, summed over the blow; on a cloth only.

    Parameters
    ----------
    normal : float
        Speed of parting over closing speed, from 0 to 1; its square is the part of the work that comes back.
    friction : float or FallingFriction, optional
        The coefficient of friction between balls; absent: Alciatore's fit.
    """

    tag: ClassVar = {"law": "mathavan_2014"}

    _: KW_ONLY
    normal: float
    friction: float | FallingFriction | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Han2005(Section):
    """A ball at a cushion as Han has it in 2005: it sticks or slips at the nose; on a cloth only.

    Parameters
    ----------
    normal : float or BySpeed
        Speed away over speed towards, along the normal, from 0 to 1. Han's own:
        ``BySpeed((0.39, 0.257, -0.044), up_to=2.9)``.
    friction : float or ByIncidence
        The coefficient of friction with the cushion. Han's own: ``ByIncidence((0.471, -0.241))``.
    """

    tag: ClassVar = {"law": "han_2005"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence


@dataclass(frozen=True, eq=False, repr=False)
class Mathavan2010(Section):
    """A ball at a cushion as Mathavan, Jackson and Parkin have it in 2010, summed over the blow; on a cloth only.

    Parameters
    ----------
    normal : float or BySpeed
        The square root of the part of the work that comes back, from 0 to 1.
    friction : float or ByIncidence
        The coefficient of friction with the cushion.
    """

    tag: ClassVar = {"law": "mathavan_2010"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence


@dataclass(frozen=True, eq=False, repr=False)
class StrongeCompliant(Section):
    """A ball at a cushion that gives way along the nose too, as a spring does, after Stronge; on a cloth only.

    Parameters
    ----------
    normal : float or BySpeed
        The energetic coefficient of restitution, from 0 to 1.
    friction : float or ByIncidence
        The coefficient of friction with the cushion.
    frequency_ratio : float, optional
        Frequency of the swing along the nose over that of the swing into it, from 1 to 2; absent: 1.8.
    """

    tag: ClassVar = {"law": "stronge_compliant"}

    _: KW_ONLY
    normal: float | BySpeed
    friction: float | ByIncidence
    frequency_ratio: float | None = None


FlightLaw = Free | Field | Cloth
"""How balls can move between events."""

BallLaw = Elastic | Restitution | Frictional | Mathavan2014
"""What can happen when two balls meet."""

CushionLaw = Elastic | Restitution | Damping | Frictional | Han2005 | Mathavan2010 | StrongeCompliant
"""What can happen when a ball meets a cushion."""


@dataclass(frozen=True, eq=False, repr=False)
class Physics(Section):
    """The laws of a scenario; each one absent is that of the table's preset, or else the first named.

    Parameters
    ----------
    flight : Free, Field or Cloth, optional
        How balls move between events.
    ball_ball : Elastic, Restitution, Frictional or Mathavan2014, optional
        What happens when two balls meet.
    ball_cushion : Elastic, Restitution, Damping, Frictional, Han2005, Mathavan2010 or StrongeCompliant, optional
        What happens when a ball meets a cushion.
    cushions : mapping of str to a law of cushions, optional
        Laws of single cushions, by the cushion's id, in place of `ball_cushion`.
    cluster : "reflections", "hertz" or "pairwise", optional
        How contacts at one instant are resolved; absent: on a cloth hertz, else reflections.
    collapse : "stop" or "tc", optional
        What is done when a ball's contacts follow each other without end in a finite time: the run stops, or contacts
        within a very short time t_c lose nothing, so that balls in a field go on hopping and do not come to rest.

    Examples
    --------
    >>> Physics(ball_cushion=Damping(0.8), cushions={"left": Elastic()})
    Physics(ball_cushion=Damping(factor=0.8), cushions={'left': Elastic()})
    >>> Physics(flight=Cloth(), ball_ball=Frictional(normal=0.95), ball_cushion=Mathavan2010(normal=0.85, friction=0.2))
    Physics(flight=Cloth(), ball_ball=Frictional(normal=0.95), ball_cushion=Mathavan2010(normal=0.85, friction=0.2))
    """

    _: KW_ONLY
    flight: FlightLaw | None = None
    ball_ball: BallLaw | None = None
    ball_cushion: CushionLaw | None = None
    cushions: Mapping[str, CushionLaw] | None = None
    cluster: Literal["reflections", "hertz", "pairwise"] | None = None
    collapse: Literal["stop", "tc"] | None = None
