"""How a run is computed."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import ClassVar, Literal

from carom.section import Section


@dataclass(frozen=True, eq=False, repr=False)
class Exact(Section):
    """From event to event, without a time step."""

    tag: ClassVar = {"kind": "exact"}


@dataclass(frozen=True, eq=False, repr=False)
class Stepped(Section):
    """The fixed-step scheme of programming courses; its readings are options, each with the first as default.

    Parameters
    ----------
    dt : float
        The time step.
    after_hit : "wait" or "restart", optional
        Whether the other balls make the step in full in which something is hit, or all stop at the earliest hit
        and a new full step begins.
    normal : "before" or "contact", optional
        Whether the normal of a ball-ball contact is taken before the balls move to it, or at it.
    last_step : "short" or "full", optional
        Whether the last step ends exactly at the duration, or is a full one and ends past it.
    steps : int, optional
        How many full steps to make; given, it decides the end in place of the duration.
    """

    tag: ClassVar = {"kind": "stepped"}

    dt: float
    _: KW_ONLY
    after_hit: Literal["wait", "restart"] | None = None
    normal: Literal["before", "contact"] | None = None
    last_step: Literal["short", "full"] | None = None
    steps: int | None = None


Method = Exact | Stepped
"""The ways to compute a run."""
