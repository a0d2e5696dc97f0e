"""Aiming: directions, ghost balls, open pots, and the room that the cue stick has.

Plain geometry of a scenario as it lies before the shot: the cue ball goes straight, without squirt, swerve or throw,
and the ball that it hits leaves along the line of centres. Directions are in degrees from the x axis towards the y
axis, as ``phi_deg`` of a shot is; lengths are in the scenario's own unit. Without `cue_ball` the cue ball is that of
the scenario's shot, or else the ball ``"cue"``.

Source: D. G. Alciatore, The Illustrated Principles of Pool and Billiards, Sterling, 2004, for the ghost ball. The signs
of cut angles are those of pooltool's ``aim.at_ball``.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _engine

if TYPE_CHECKING:
    from carom.scenario import Scenario
    from carom.vectors import Vector

__all__ = [
    "GhostBall",
    "Obstruction",
    "Pot",
    "aiming_point",
    "at_ball",
    "at_point",
    "at_pot",
    "easiest_pot",
    "ghost_ball",
    "least_elevation",
    "obstructions",
    "open_pots",
    "pot",
    "required_precision",
]


@dataclass(frozen=True)
class GhostBall:
    """Where the cue ball has to be when it touches the ball that it sends to a pocket.

    Attributes
    ----------
    center : tuple of float
        Its centre then, as (x, y).
    direction_deg : float
        The direction from where the cue ball lies to there.
    cut_deg : float
        The angle from this direction to that of the ball, positive to the left.
    """

    center: tuple[float, float]
    direction_deg: float
    cut_deg: float


@dataclass(frozen=True)
class Pot:
    """A straight pot that is open.

    Attributes
    ----------
    ball, pocket : str
        What is potted, and where.
    direction_deg : float
        The direction of the cue ball: the middle of `window_deg`.
    cut_deg : float
        The angle from there to the direction of the object ball, positive to the left.
    ghost : tuple of float
        The centre of the cue ball at contact, as (x, y).
    cue_distance : float
        How far the cue ball goes to there.
    object_distance : float
        How far the object ball goes until it is in the pocket.
    window_deg : tuple of float
        The directions of the cue ball between which it pots the ball: the last to the right, and the last to the left.
    object_window_deg : tuple of float
        The directions that the object ball takes at these.
    """

    ball: str
    pocket: str
    direction_deg: float
    cut_deg: float
    ghost: tuple[float, float]
    cue_distance: float
    object_distance: float
    window_deg: tuple[float, float]
    object_window_deg: tuple[float, float]

    @property
    def precision_deg(self) -> float:
        """The width of the window: within which angle the cue ball has to start."""
        right, left = self.window_deg
        return left - right


@dataclass(frozen=True)
class Obstruction:
    """Something that the cue stick meets.

    Attributes
    ----------
    kind : str
        ``"ball"``, ``"cushion"`` or ``"cloth"``.
    id : str or None
        The ball, or the cushion that is met nearest to the tip; None for the cloth.
    clear_from_deg : float or None
        The least elevation, from that of the shot upwards, at which the stick clears it; None where not even an upright
        stick does.
    """

    kind: str
    id: str | None
    clear_from_deg: float | None


def at_point(scenario: Scenario, point: Vector, *, cue_ball: str | None = None) -> float:
    """Give the direction from the cue ball to a point.

    Parameters
    ----------
    scenario : Scenario
        The table and the balls.
    point : sequence of float
        The point, as (x, y).
    cue_ball : str, optional
        The ball that is shot.

    Returns
    -------
    float
        The direction in degrees, above −180 and up to 180.

    Raises
    ------
    ScenarioError
        When there is no such ball, or the point is its centre.
    """
    x, y = point
    return _engine.aim_at_point(scenario._native, (float(x), float(y)), cue_ball)


def at_ball(scenario: Scenario, ball: str, *, cut_deg: float = 0.0, cue_ball: str | None = None) -> float:
    """Give the direction in which the cue ball hits a ball with a cut angle.

    With D the distance to the ball and d that of the centres at contact the direction is asin((d/D) sin χ) off the one
    to the ball's centre for a cut angle χ. On a cloth d = 2 √(R₁ R₂) as seen from above, of discs R₁ + R₂.

    Parameters
    ----------
    scenario : Scenario
        The table and the balls.
    ball : str
        The ball that is hit.
    cut_deg : float, optional
        The angle from the cue ball's direction to that of the ball, between −90 and 90 degrees: positive where the ball
        goes to the left, for which it is hit on its right.
    cue_ball : str, optional
        The ball that is shot.

    Returns
    -------
    float
        The direction in degrees, above −180 and up to 180.

    Raises
    ------
    ScenarioError
        When there is no such ball, the cut angle is out of range, or one of the balls is above the other.
    """
    return _engine.aim_at_ball(scenario._native, ball, cut_deg, cue_ball)


def at_pot(scenario: Scenario, ball: str, pocket: str, *, cue_ball: str | None = None) -> float:
    """Give the direction that pots a ball best: the middle of the pot's window; see `pot`, whose arguments it takes.

    Returns
    -------
    float
        The direction in degrees, for ``phi_deg`` of a shot.
    """
    return pot(scenario, ball, pocket, cue_ball=cue_ball).direction_deg


def aiming_point(scenario: Scenario, pocket: str) -> tuple[float, float]:
    """Give the point to aim a ball at: half-way between the pocket's horn tips, or the middle of a bare hole.

    Raises
    ------
    ScenarioError
        When there is no such pocket.
    """
    x, y = _engine.aiming_point(scenario._native, pocket)
    return x, y


def ghost_ball(scenario: Scenario, ball: str, pocket: str, *, cue_ball: str | None = None) -> GhostBall:
    """Give where the cue ball has to be at contact so that a ball goes to the aiming point of a pocket.

    What may be in the way is not looked at; see `pot` for that.

    Parameters
    ----------
    scenario : Scenario
        The table and the balls.
    ball, pocket : str
        What is to be potted, and where.
    cue_ball : str, optional
        The ball that is shot.

    Raises
    ------
    ScenarioError
        When there is no such ball or pocket, or the ball would have to be cut by 90 degrees or more.
    """
    found = json.loads(_engine.ghost_ball(scenario._native, ball, pocket, cue_ball))
    return GhostBall(tuple(found.pop("center")), **found)


def pot(scenario: Scenario, ball: str, pocket: str, *, cue_ball: str | None = None) -> Pot:
    """Give a straight pot, with the window of directions in which it succeeds.

    A pot is open where the cue ball comes to the ball, and the ball from there into the pocket, and neither touches
    anything on its way: no other ball, no cushion, no other hole. A ball is in the pocket when its centre is between
    the horn tips and its straight line goes on past both jaws without touching them, or when it is over the hole; of a
    ball that lies behind the tips already, over the hole. It may still touch a facing. Whether that throws it out
    depends on its speed, its spin and the rubber, and is left to a run. Another ball that hangs behind the tips closes
    the pocket. Of several windows the widest counts.

    Parameters
    ----------
    scenario : Scenario
        The table and the balls.
    ball, pocket : str
        What is to be potted, and where.
    cue_ball : str, optional
        The ball that is shot.

    Raises
    ------
    ScenarioError
        When there is no such ball or pocket, or the pot is not open.
    """
    return _pot(json.loads(_engine.open_pot(scenario._native, ball, pocket, cue_ball)))


def open_pots(scenario: Scenario, *, cue_ball: str | None = None) -> list[Pot]:
    """Give all open pots, that with the widest window first; see `pot` for what that means.

    Examples
    --------
    >>> import carom
    >>> from carom import aim
    >>> scenario = carom.Scenario.from_dict({"table": {"preset": "pool_9ft"}, "balls": [
    ...     {"id": "cue", "position": [0.635, 0.6]}, {"id": "1", "position": [0.9, 1.27]}]})
    >>> [(pot.pocket, round(pot.cut_deg), round(pot.precision_deg, 2)) for pot in aim.open_pots(scenario)]
    [('rc', -72, 0.26), ('rt', 7, 0.16), ('lt', 61, 0.09)]
    """
    return [_pot(found) for found in json.loads(_engine.open_pots(scenario._native, cue_ball))]


def easiest_pot(scenario: Scenario, *, cue_ball: str | None = None) -> Pot | None:
    """Give the open pot with the widest window; None where no pot is open."""
    return next(iter(open_pots(scenario, cue_ball=cue_ball)), None)


def required_precision(scenario: Scenario, ball: str, pocket: str, *, cue_ball: str | None = None) -> float:
    """Give the width of a pot's window in degrees, within which the cue ball has to start; see `pot`.

    It is the whole angle from one end to the other: to aim at the middle leaves half of it on each side.
    """
    return pot(scenario, ball, pocket, cue_ball=cue_ball).precision_deg


def obstructions(scenario: Scenario) -> list[Obstruction]:
    """Give what the cue stick meets where the scenario's shot strikes; nothing where it has room.

    The stick is a straight cone with round ends, ``length`` of ``[cue]`` long and of its ``shaft_radius`` and
    ``butt_radius``; its tip, rounded with ``tip_radius``, touches the ball where the shot says. Cushions are as high as
    the nose and go outwards from there as far as the stick does.

    Raises
    ------
    ScenarioError
        When the scenario has no shot.
    """
    return [Obstruction(**found) for found in json.loads(_engine.obstructions(scenario._native))]


def least_elevation(scenario: Scenario) -> float | None:
    """Give the least elevation of the butt at which the stick meets nothing, all else being as the shot says.

    Returns
    -------
    float or None
        In degrees from 0 (level) to 90, for ``theta_deg`` of the shot; None where not even an upright stick has room.

    Raises
    ------
    ScenarioError
        When the scenario has no shot.
    """
    return _engine.least_elevation_deg(scenario._native)


def _pot(found: dict[str, Any]) -> Pot:
    pairs = {key: tuple(value) for key, value in found.items() if isinstance(value, list)}
    return Pot(**{**found, **pairs})
