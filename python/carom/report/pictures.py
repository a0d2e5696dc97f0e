"""The figures of a run as pictures in a page."""

from __future__ import annotations

import io
import struct
from base64 import b64encode
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.report.results import count_events
from carom.report.text import counted, short

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from carom.run import Run

DPI = 200
CSS_DPI = 96

NAMES = ("filmstrip", "paths", "energy", "speed", "spin", "height", "momentum")
"""The figures of a run, in their order on a page."""

TITLES = {
    "filmstrip": "Before, during, after",
    "paths": "Paths",
    "energy": "Energy",
    "speed": "Speed",
    "spin": "Spin",
    "height": "Height",
    "momentum": "Momentum",
}
CAPTIONS = {
    "filmstrip": "One event. Arrows are velocities, dashed ones those just before it; n is the normal of the contact, "
    "t its tangent.",
    "paths": "Every ball from its start (a ring) to its end (a disc). Diamonds are contacts of balls, with the "
    "two balls as pale rings, dots contacts with cushions; numbers, where there are any, are the index of events.csv "
    "and of the events below, from 0.",
    "energy": "Kinetic energy of each ball, and the total. The ticks below the curves are the events.",
    "speed": "Speed of each ball.",
    "spin": "How fast each ball turns; dashed, its side spin, above zero where it turns counter-clockwise from above.",
    "height": "How high the lowest point of each ball is above the cloth, while any flies; the dashed line is the top "
    "of a ball that lies there.",
    "momentum": "Total momentum: contacts of balls leave it as it is, cushions and fields change it.",
}


@dataclass(frozen=True)
class Picture:
    """A PNG picture with its words.

    Attributes
    ----------
    name : str
        One of `NAMES`.
    uri : str
        The picture itself, as a ``data:`` address.
    width, height : int
        Its size on the page, in CSS pixels.
    alt : str
        What it shows, for those who do not see it.
    """

    name: str
    uri: str
    width: int
    height: int
    alt: str

    @property
    def title(self) -> str:
        """Its heading."""
        return TITLES[self.name]

    @property
    def caption(self) -> str:
        """What its marks mean."""
        return CAPTIONS[self.name]

    @property
    def upright(self) -> bool:
        """Whether it is higher than wide."""
        return self.height > self.width


def figures_of(run: Run) -> Iterator[tuple[str, Figure]]:
    """Draw, one after the other, the figures that a run has something for."""
    if run.record != "all":
        return
    from carom import figures

    for name in NAMES:
        if name == "filmstrip":
            if len(run.events):
                yield name, figures.figure_of(figures.filmstrip(run))
        elif _has(run, name):
            yield name, figures.figure_of(getattr(figures, f"plot_{name}")(run))


def _has(run: Run, name: str) -> bool:
    """Tell whether there is something to see: discs have no spin, and few shots fly."""
    if name == "height":
        return run.is_on_cloth and len(run.events.by_kind("ball_cloth", "off_table")) > 0
    return name != "spin" or run.is_on_cloth


def drawn(figure: Figure) -> bytes:
    """Give a figure as PNG, as `save_figure` writes it."""
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=DPI)
    return file.getvalue()


def data_uri(png: bytes) -> str:
    """Give a PNG as a ``data:`` address."""
    return f"data:image/png;base64,{b64encode(png).decode('ascii')}"


def pictures_of(run: Run, drawings: Mapping[str, bytes]) -> list[Picture]:
    """Put drawings, PNG by name, into words and order."""
    return [_picture(run, name, drawings[name]) for name in NAMES if name in drawings]


def _picture(run: Run, name: str, png: bytes) -> Picture:
    width, height = (round(size * CSS_DPI / DPI) for size in struct.unpack(">II", png[16:24]))
    return Picture(name, data_uri(png), width, height, _alternative(run, name))


def _alternative(run: Run, name: str) -> str:
    found = run.diagnostics
    span = f"from time 0 to {short(run.end_time)}"
    if name == "filmstrip":
        return "The table from above before, at and after an event, with the balls and their velocities."
    if name == "paths":
        balls, events = counted(len(run.ball_ids), "ball"), counted(count_events(run), "event")
        return f"The table from above with the paths of {balls} and the places of {events}."
    if name == "energy":
        first, last = short(found["initial_energy"], 4), short(found["final_energy"], 4)
        return f"Curves of energy against time {span}; the energy goes from {first} to {last}."
    return f"Curves of {name} against time {span}."
