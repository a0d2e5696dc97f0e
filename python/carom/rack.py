"""Balls set up for a game."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import Literal

from carom.section import Section

Game = Literal["eight_ball", "nine_ball", "ten_ball", "straight_pool", "snooker", "three_cushion", "english_pool"]
"""The games that there is a rack for."""


@dataclass(frozen=True, eq=False, repr=False)
class Rack(Section):
    """Balls set up for a game on a rectangular table; a `Ball` with the id of one of them replaces what it gives.

    Parameters
    ----------
    game : str
        ``eight_ball``, ``nine_ball``, ``ten_ball``, ``straight_pool``, ``snooker``, ``three_cushion`` or
        ``english_pool``.
    seed : int, optional
        What the order and the displacements are drawn from; absent: 0.
    spacing : float, optional
        The gap between neighbours over a ball's diameter; absent: 0, so that they touch.
    jitter : float, optional
        How far at most each racked ball is moved at random, over its radius; absent: 0.

    Examples
    --------
    >>> import carom
    >>> table = carom.Table.preset("pool_9ft")
    >>> carom.Scenario(table, rack=Rack("nine_ball", seed=7)).ball_ids
    ['cue', '1', '3', '5', '7', '9', '8', '4', '2', '6']
    """

    game: Game
    _: KW_ONLY
    seed: int | None = None
    spacing: float | None = None
    jitter: float | None = None
