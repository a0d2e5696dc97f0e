"""The colours of balls, the same in figures and on pages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from carom.vectors import Vector

# Paul Tol's "bright" and Okabe and Ito's sets, ordered so that neighbours differ in hue and in lightness;
# all can be told apart with the common forms of colour blindness.
PALETTE = (
    "#c8402f",
    "#2b6cb0",
    "#e3a21a",
    "#1f9d7c",
    "#8e5bb5",
    "#66b7e0",
    "#8c5a2b",
    "#d377a8",
)

# A ball whose id is a colour word is drawn in that colour, in the shade used here.
COLOUR_WORDS = {
    "red": PALETTE[0],
    "blue": PALETTE[1],
    "yellow": "#edc23b",
    "green": PALETTE[3],
    "orange": "#e07f24",
    "purple": PALETTE[4],
    "pink": PALETTE[7],
    "brown": PALETTE[6],
    "black": "#2b2f33",
    "white": "#fbfaf4",
    "grey": "#8b939a",
    "gray": "#8b939a",
    "cue": "#fbfaf4",
}


def ball_colours(ids: Sequence[str], given: Sequence[str | Vector | None]) -> list[str]:
    """Choose a colour for every ball, as CSS and matplotlib write it.

    A colour given in the scenario comes first, then the ball's id where it is a colour word, then the palette
    in order, leaving out the colours already taken while some are left.
    """
    fixed = [
        COLOUR_WORDS.get(name.lower()) if colour is None else _written(colour)
        for name, colour in zip(ids, given, strict=True)
    ]
    free = [colour for colour in PALETTE if colour not in fixed] or list(PALETTE)
    chosen: list[str] = []
    used = 0
    for colour in fixed:
        chosen.append(colour or free[used % len(free)])
        used += colour is None
    return chosen


def _written(colour: str | Vector) -> str:
    if isinstance(colour, str):
        return colour.lower()
    return "#" + "".join(f"{round(255 * part):02x}" for part in colour)
