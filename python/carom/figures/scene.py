"""What the figures read of a scenario: balls with their colours, the outline, and the words for axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_hex

from carom.colours import ball_colours
from carom.figures.aim import Aim
from carom.figures.rails import Rails
from carom.figures.repeats import Repeats
from carom.figures.style import line_colour
from carom.units import unit_of

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray

    from carom.run import Run
    from carom.scenario import Scenario


STRIPED = {str(number) for number in range(9, 16)}
"""Pool balls with these numbers are white with a stripe."""
BARE = "#fbfaf4"
BRIGHTEST = 0.58
"""How bright a line of a ball on a cloth is at most: dashes of a white ball are to be seen in print, too."""


@dataclass(frozen=True)
class Scene:
    """A table and the balls on it, in file order.

    Attributes
    ----------
    ids, colours : tuple of str
        One for each ball.
    radii, masses : (n_balls,) float64
        One for each ball.
    bounds : tuple of float
        ``(x_min, y_min, x_max, y_max)`` of the table, with its rails where it has some.
    pieces : tuple of mappings
        The pieces of the outline, boundary first, in order.
    field : (2,) float64
        The constant acceleration of all balls.
    repeats : Repeats
        The table as a box, and along which axes it repeats itself.
    units : mapping
        Names of units by quantity (``length``, ``time``, ...); may be empty.
    on_cloth : bool
        Whether the balls roll and spin on a cloth.
    rails : Rails or None
        What surrounds the cloth of a table for cue sports.
    aim : Aim or None
        The stroke of the cue.
    """

    ids: tuple[str, ...]
    colours: tuple[str, ...]
    radii: NDArray[np.float64]
    masses: NDArray[np.float64]
    bounds: tuple[float, float, float, float]
    pieces: tuple[Mapping[str, Any], ...]
    field: NDArray[np.float64]
    repeats: Repeats
    units: Mapping[str, str]
    on_cloth: bool = False
    rails: Rails | None = None
    aim: Aim | None = None

    @classmethod
    def of_run(cls, run: Run) -> Scene:
        """Read the scenario of a run that kept its motion; of another one, the error says what to keep."""
        if run.record != "all":
            run.positions(0.0)
        return cls.of(run.scenario)

    @classmethod
    def of(cls, scenario: Scenario) -> Scene:
        """Read a scenario."""
        outline = scenario.outline()
        balls = scenario.balls
        ids = tuple(ball.id for ball in balls)
        colours = ball_colours(ids, [ball.color for ball in balls])
        values = scenario.expanded().to_dict()
        rails = Rails.of(values, outline, scenario.to_dict()) if scenario.is_on_cloth else None
        x_min, y_min, x_max, y_max = outline["bounds"] if rails is None else rails.outer
        radii = [ball.radius or 0.0 for ball in balls]
        low, high = np.array(outline["bounds"], dtype=float).reshape(2, 2)
        periodic = values["table"].get("periodic", [])
        return cls(
            ids=ids,
            colours=tuple(map(to_hex, colours)),
            radii=np.array(radii, dtype=float),
            masses=np.array([ball.mass or 1.0 for ball in balls], dtype=float),
            bounds=(x_min, y_min, x_max, y_max),
            pieces=tuple(outline["pieces"]),
            field=np.array(values.get("physics", {}).get("flight", {}).get("acceleration", (0.0, 0.0)), dtype=float),
            repeats=Repeats(low, high - low, np.array([axis in periodic for axis in "xy"])),
            units=values.get("units", {}),
            on_cloth=scenario.is_on_cloth,
            rails=rails,
            aim=Aim.of(values, dict(zip(ids, radii, strict=True))),
        )

    def is_striped(self, ball: int) -> bool:
        """Tell whether a ball is a striped pool ball."""
        return self.on_cloth and self.ids[ball] in STRIPED

    @property
    def faces(self) -> list[str]:
        """The colours of the discs: under a stripe they are white."""
        return [BARE if self.is_striped(ball) else colour for ball, colour in enumerate(self.colours)]

    @property
    def lines(self) -> list[tuple[float, float, float]]:
        """The colours of the balls' lines."""
        if not self.on_cloth:
            return [line_colour(colour) for colour in self.colours]
        return [line_colour(colour, BRIGHTEST) for colour in self.colours]

    @property
    def width(self) -> float:
        """Extent of the table along x."""
        return self.bounds[2] - self.bounds[0]

    @property
    def height(self) -> float:
        """Extent of the table along y."""
        return self.bounds[3] - self.bounds[1]

    @property
    def size(self) -> float:
        """The larger extent of the table."""
        return max(self.width, self.height)

    def label(self, words: str, quantity: str, power: int = 0) -> str:
        """Give an axis label: the words, and in brackets the power of ten and the unit where there are any."""
        parts = [f"$10^{{{power}}}$"] if power else []
        parts += [unit] if (unit := self.unit(quantity)) else []
        return f"{words} ({' '.join(parts)})" if parts else words

    def unit(self, quantity: str) -> str:
        """Give the unit of a quantity, put together from those of length, time and mass if need be."""
        return unit_of(self.units, quantity)
