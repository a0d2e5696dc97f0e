"""What a cue-sport scenario has beside table and balls: the rack, the cue and the shot; and what came of the shot."""

from __future__ import annotations

from dataclasses import KW_ONLY, asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal

from carom.section import Section

if TYPE_CHECKING:
    from carom.run import Run

Game = Literal["eight_ball", "nine_ball", "ten_ball", "straight_pool", "snooker", "three_cushion", "english_pool"]


@dataclass(frozen=True, eq=False, repr=False)
class Rack(Section):
    """The balls of a game where they stand at its start, the cue ball among them.

    Parameters
    ----------
    game : str
        ``eight_ball``, ``nine_ball``, ``ten_ball``, ``straight_pool``, ``snooker``, ``three_cushion`` or
        ``english_pool``.
    seed : int, optional
        Decides the order of balls where the game leaves it free, and the jitter; absent: 0.
    spacing : float, optional
        Gap between neighbours over their diameter; absent: 0, so that they touch exactly.
    jitter : float, optional
        How far each ball is moved at random at most, over its radius; absent: 0.

    Examples
    --------
    >>> Rack("nine_ball", seed=7)
    Rack(game='nine_ball', seed=7)
    """

    game: Game
    _: KW_ONLY
    seed: int | None = None
    spacing: float | None = None
    jitter: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Cue(Section):
    """The cue; what is absent is that of the table's preset, or else that of a pool cue.

    Parameters
    ----------
    mass : float, optional
    tip_radius : float, optional
        Radius of the tip's rounding, in length.
    end_mass : float, optional
        Mass of the end of the shaft that the ball pushes aside, which makes the squirt; zero: none.
    restitution : float, optional
        Coefficient of restitution of the tip, from 0 to 1.
    miscue_offset : float, optional
        The tip slips off where it touches the ball further from the middle than this, over the ball's radius.
    length, shaft_radius, butt_radius : float, optional
        Of the stick, in length.
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
    """The strike of the cue at time 0; each number in pooltool's word or in Carom's, not in both.

    Parameters
    ----------
    cue_ball : str, optional
        The ball that is struck; absent: ``cue``.
    V0, cue_speed : float, optional
        Speed of the cue, not of the ball, in length per time.
    phi_deg, direction_deg : float, optional
        Direction in plan, in degrees from the x axis towards the y axis.
    theta_deg, elevation_deg : float, optional
        Elevation of the butt, in degrees from 0 to 90; absent: 0.
    a, left : float, optional
        Offset of the contact over the ball's radius, positive to the shooter's left; absent: 0.
    b, top : float, optional
        Offset upwards, across the cue; absent: 0.
    offset_of : "contact" or "tip_center", optional
        What the offsets are those of; absent: the point of contact.

    Examples
    --------
    >>> Shot(V0=8, phi_deg=90, b=0.2)
    Shot(V0=8, phi_deg=90, b=0.2)
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


@dataclass(frozen=True)
class ShotResult:
    """What came of a shot, as planners ask for it.

    Attributes
    ----------
    cue_ball : str
        The ball that was struck.
    first_ball_hit : str or None
        The first ball that it met.
    pocketed : tuple of (str, str)
        The balls that dropped, in order, each with its pocket.
    cushions_before : tuple of str
        The cushions that the cue ball met before it met a ball; all of them if it met none.
    cushions_after : tuple of (str, str)
        The cushions that balls met after that first contact, in order, each with the ball.
    off_table : tuple of str
        The balls that left the table, in order.
    is_scratch : bool
        Whether the cue ball dropped into a pocket or left the table.
    is_miscue : bool
        Whether the tip slipped off.
    """

    cue_ball: str
    first_ball_hit: str | None
    pocketed: tuple[tuple[str, str], ...]
    cushions_before: tuple[str, ...]
    cushions_after: tuple[tuple[str, str], ...]
    off_table: tuple[str, ...]
    is_scratch: bool
    is_miscue: bool

    def to_dict(self) -> dict[str, Any]:
        """Give the attributes by their names."""
        return asdict(self)


def result_of(run: Run, cue_ball: str) -> ShotResult:
    """Read what came of a shot from the events of its run."""
    first: str | None = None
    before: list[str] = []
    after: list[tuple[str, str]] = []
    pocketed: list[tuple[str, str]] = []
    gone: list[str] = []
    for event in run.events:
        if event.kind == "ball_ball" and first is None and cue_ball in event.balls:
            first = next(ball for ball in event.balls if ball != cue_ball)
        elif event.kind == "ball_cushion" and event.cushion is not None:
            if first is not None:
                after.append((str(event.ball_a), event.cushion))
            elif event.ball_a == cue_ball:
                before.append(event.cushion)
        elif event.kind == "ball_pocket" and event.pocket is not None:
            pocketed.append((str(event.ball_a), event.pocket))
        elif event.kind == "off_table":
            gone.append(str(event.ball_a))
    return ShotResult(
        cue_ball=cue_ball,
        first_ball_hit=first,
        pocketed=tuple(pocketed),
        cushions_before=tuple(before),
        cushions_after=tuple(after),
        off_table=tuple(gone),
        is_scratch=cue_ball in [*gone, *(ball for ball, _ in pocketed)],
        is_miscue=run.status == "miscue",
    )
