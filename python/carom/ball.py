"""Balls, as a scenario describes them."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING

from carom.section import Section

if TYPE_CHECKING:
    from carom.vectors import Vector


@dataclass(frozen=True, eq=False, repr=False)
class Ball(Section):
    """A ball and how it starts.

    Parameters
    ----------
    id : str
        The name of this ball, unlike that of any other.
    position : (2,) or (3,) sequence of float, optional
        Centre (x, y) at time 0, in length; over a cloth also (x, y, z), with the height of the centre. Only a ball of
        the rack can do without.
    velocity : (2,) or (3,) sequence of float, optional
        Velocity (x, y), over a cloth also (x, y, z), at time 0, in length per time; absent: at rest, unless `speed` is
        given.
    spin : (3,) sequence of float, optional
        Angular velocity (x, y, z) at time 0, in radians per time, by the right-hand rule; on a cloth only.
    speed, direction_deg : float, optional
        Speed and direction (degrees from the x axis towards the y axis), together, in place of `velocity`.
    radius : float, optional
        In length; zero is a point; absent: that of ``ball_defaults``.
    mass : float, optional
        Absent: that of ``ball_defaults``, or 1.
    sliding_friction, rolling_friction : float, optional
        Coefficients of friction with the cloth; absent: those of ``ball_defaults``, or 0.2 and 0.01.
    spin_decay : float, optional
        Rate at which the cloth slows the spin about the vertical, in radians per time squared; absent: that of
        ``ball_defaults``, or 10.9.
    color : str or (3,) sequence of float, optional
        A CSS colour name, ``#rrggbb``, or red, green and blue from 0 to 1.

    Examples
    --------
    >>> Ball("red", radius=0.075, position=(0.1, 0.1), velocity=(3, 4))
    Ball(id='red', position=(0.1, 0.1), velocity=(3, 4), radius=0.075)
    """

    id: str
    _: KW_ONLY
    position: Vector | None = None
    velocity: Vector | None = None
    spin: Vector | None = None
    speed: float | None = None
    direction_deg: float | None = None
    radius: float | None = None
    mass: float | None = None
    sliding_friction: float | None = None
    rolling_friction: float | None = None
    spin_decay: float | None = None
    color: str | Vector | None = None
