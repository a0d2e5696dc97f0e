"""What the figures read of balls on a cloth: the scenario in plain keys, how each ball moves, and the shot."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray

    from carom.run import Run
    from carom.scenario import Scenario

RESTING, SPINNING, SLIDING, ROLLING, AIRBORNE, POCKETED, OFF_TABLE = range(7)
"""The codes of motions, in the order of the engine."""


def is_on_cloth(scenario: Scenario) -> bool:
    """Tell whether the balls of a scenario roll and spin on a cloth."""
    return scenario._native.is_on_cloth


def plain_values(scenario: Scenario) -> dict[str, Any]:
    """Give a scenario as a dict, its preset and its rack turned into plain keys."""
    values: dict[str, Any] = json.loads(scenario._native.expanded().to_json())
    return values


def spins_and_motions(run: Run, times: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int8]]:
    """Give the spins (n_times, n_balls, 3) and the codes of the motions (n_times, n_balls) of a run on a cloth."""
    return run._native.spins(np.ascontiguousarray(times, dtype=np.float64))


@dataclass(frozen=True)
class Aim:
    """A stroke of the cue, as it is drawn.

    Attributes
    ----------
    ball : str
        The id of the ball that is struck.
    speed : float
        Speed of the cue.
    direction_deg, elevation_deg : float
        Direction as seen from above, from x towards y, and how far the butt is raised.
    left, top : float
        Where the tip touches the ball, over its radius, from the middle as the shooter sees it.
    limit : float
        The offset beyond which the tip slips off.
    length, tip, butt : float
        Length of the cue, and the radii of its ends.
    """

    ball: str
    speed: float
    direction_deg: float
    elevation_deg: float
    left: float
    top: float
    limit: float
    length: float
    tip: float
    butt: float

    @classmethod
    def of(cls, values: Mapping[str, Any], radii: Mapping[str, float]) -> Aim | None:
        """Read the shot of a scenario in plain keys, whose balls have these radii; None where there is none."""
        shot, cue = values.get("shot", {}), POOL_CUE | values.get("cue", {})
        ball = str(shot.get("cue_ball", "cue"))
        if not shot or ball not in radii:
            return None

        def either(one: str, other: str) -> float:
            return float(shot.get(one, shot.get(other, 0.0)))

        # The centre of the tip lies farther out than the point in which its rounding touches the ball.
        at_center = shot.get("offset_of") == "tip_center"
        scale = radii[ball] / (radii[ball] + cue["tip_radius"]) if at_center else 1.0
        return cls(
            ball=ball,
            speed=either("V0", "cue_speed"),
            direction_deg=either("phi_deg", "direction_deg"),
            elevation_deg=either("theta_deg", "elevation_deg"),
            left=scale * either("a", "left"),
            top=scale * either("b", "top"),
            limit=cue["miscue_offset"],
            length=cue["length"],
            tip=cue["shaft_radius"],
            butt=cue["butt_radius"],
        )

    @property
    def direction(self) -> NDArray[np.float64]:
        """Unit vector of the stroke as seen from above."""
        angle = np.radians(self.direction_deg)
        return np.array([np.cos(angle), np.sin(angle)])


POOL_CUE = {
    "tip_radius": 0.0106045,
    "miscue_offset": 0.55,
    "length": 1.4732,
    "shaft_radius": 0.0065,
    "butt_radius": 0.02,
}
"""What the engine takes for a cue where a scenario does not say; drawn, never computed with."""
