"""The stroke of the cue, as figures draw it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray


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
