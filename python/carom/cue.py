"""The cue, and how it strikes."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import Literal

from carom.section import Section


@dataclass(frozen=True, eq=False, repr=False)
class Cue(Section):
    """The stick; what is absent is that of the table's preset, or else that of a pool cue.

    Parameters
    ----------
    mass : float, optional
        Absent: 0.567.
    tip_radius : float, optional
        Radius of the tip's rounding, in length; absent: 0.0106.
    end_mass : float, optional
        Mass of the end of the shaft that is pushed aside, which makes squirt; zero: none; absent: 0.00567.
    restitution : float, optional
        Coefficient of restitution of the tip, from 0 to 1; absent: 1.
    miscue_offset : float, optional
        The tip slips off where it touches the ball further from the middle than this, over the ball's radius; absent:
        0.55. At 1 it never does.
    length, shaft_radius, butt_radius : float, optional
        In length, for drawings.
    """

    _: KW_ONLY
    mass: float | None = None
    tip_radius: float | None = None
    end_mass: float | None = None
    restitution: float | None = None
    miscue_offset: float | None = None
    length: float | None = None
    shaft_radius: float | None = None
    butt_radius: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Shot(Section):
    """A stroke of the cue at time 0, in pooltool's words or in plain ones; each number is given in one of them.

    Parameters
    ----------
    cue_ball : str, optional
        The id of the ball that is struck; absent: cue.
    V0, cue_speed : float
        Speed of the cue as it meets the ball, in length per time.
    phi_deg, direction_deg : float
        Direction of the stroke seen from above, in degrees from the x axis towards the y axis.
    theta_deg, elevation_deg : float, optional
        How high the butt is raised, in degrees from 0 (level) to 90 (straight down); absent: 0.
    a, left : float, optional
        How far to the left of the middle the ball is struck, over its radius, as the shooter sees it; absent: 0.
    b, top : float, optional
        How far above the middle, over the radius, as the shooter sees it along the cue; absent: 0.
    offset_of : "contact" or "tip_center", optional
        What is offset by this much: the point of the ball that is touched, or the centre of the tip's rounding.

    Examples
    --------
    >>> Shot(V0=2, phi_deg=90, b=0.2)
    Shot(V0=2, phi_deg=90, b=0.2)
    >>> Shot(cue_speed=2, direction_deg=90, top=0.2)
    Shot(cue_speed=2, direction_deg=90, top=0.2)
    """

    _: KW_ONLY
    cue_ball: str | None = None
    V0: float | None = None
    cue_speed: float | None = None
    phi_deg: float | None = None
    direction_deg: float | None = None
    theta_deg: float | None = None
    elevation_deg: float | None = None
    a: float | None = None
    left: float | None = None
    b: float | None = None
    top: float | None = None
    offset_of: Literal["contact", "tip_center"] | None = None
