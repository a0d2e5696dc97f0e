"""What surrounds the cloth of a table for cue sports: cushions, pockets, the wooden frame, and the marks on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.patches import FancyBboxPatch, PathPatch, Rectangle
from matplotlib.path import Path

from carom.figures import style
from carom.figures.outline import join_paths, piece_path

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BAND = 0.034
"""Width of the cushions of a table without pockets, over its width: 5 cm on one of 10 feet."""
WOOD = 0.055
"""Width of the wood behind the cushions or the pockets, over the table's width."""
SIGHTED = ("pool_", "carom_", "pooltool_7ft", "pooltool_carom")
"""Presets with these names have sights on their rails, at eighths of the length and quarters of the width."""


@dataclass(frozen=True)
class Rails:
    """The surroundings of a rectangular cloth, whose lower left nose corner is the origin.

    Attributes
    ----------
    width, length : float
        Between the noses.
    cushion : float
        Width of a cushion, from its nose to the wood.
    wood : float
        Width of the frame, from the noses to its outer edge.
    pockets : tuple of mappings
        Each with its ``id``, ``center`` and ``radius``.
    preset : str
        The name of the preset; empty where the table is one's own.
    """

    width: float
    length: float
    cushion: float
    wood: float
    pockets: tuple[Mapping[str, Any], ...]
    preset: str

    @classmethod
    def of(cls, values: Mapping[str, Any], outline: Mapping[str, Any], written: Mapping[str, Any]) -> Rails | None:
        """Read the table of a scenario: in plain keys, its outline, and as it was written; None of another shape."""
        table = values["table"]
        if table["shape"] not in ("pocket_table", "rectangle"):
            return None
        width, length = table["width"], table["length"]
        cushion = table.get("cushion_width", BAND * width)
        deepest = max(cushion, -min(outline["bounds"][:2]))
        preset = str(written["table"].get("preset", ""))
        return cls(width, length, cushion, deepest + WOOD * width, tuple(outline["pockets"]), preset)

    @property
    def outer(self) -> tuple[float, float, float, float]:
        """The outer edge of the frame, as ``(x_min, y_min, x_max, y_max)``."""
        return (-self.wood, -self.wood, self.width + self.wood, self.length + self.wood)

    @property
    def has_sights(self) -> bool:
        """Whether there are diamonds on the frame."""
        return self.preset.startswith(SIGHTED)


def draw_rails(ax: Axes, rails: Rails, cloth: Path, pieces: Sequence[Mapping[str, Any]]) -> None:
    """Draw the surroundings of a cloth, and the cloth, each thing over the one before."""
    _draw_frame(ax, rails)
    if not rails.pockets:
        x, y, across, along = -rails.cushion, -rails.cushion, rails.width, rails.length
        size = (across + 2 * rails.cushion, along + 2 * rails.cushion)
        ax.add_patch(Rectangle((x, y), *size, facecolor=style.RUBBER, edgecolor="none", zorder=0.15))
    ground = PathPatch(cloth, facecolor=style.CLOTH, edgecolor="none", zorder=0.2)
    ax.add_patch(ground)
    _draw_marks(ax, rails)
    holes = [Path.circle(pocket["center"], pocket["radius"]) for pocket in rails.pockets]
    # A ball falls where its centre comes inside the circle; what of it lies behind the back of the pocket is not there.
    for patch in _draw_all(ax, holes, facecolor=style.POCKET, edgecolor="none", zorder=0.4):
        patch.set_clip_path(ground)
    backs = [piece_path(piece) for piece in pieces if _is_back(piece)]
    _draw_all(ax, backs, fill=False, edgecolor=style.POCKET, linewidth=1.6, capstyle="butt", zorder=0.45)
    for chain in _cushions(pieces):
        face = style.RUBBER if rails.pockets else "none"
        ax.add_patch(PathPatch(chain, facecolor=face, edgecolor=style.NOSE, linewidth=0.8, zorder=0.5))
    if rails.has_sights:
        _draw_sights(ax, rails)


def _draw_frame(ax: Axes, rails: Rails) -> None:
    """Draw the wood, round at its corners."""
    x_min, y_min, x_max, y_max = rails.outer
    rounding = 0.5 * rails.wood
    frame = FancyBboxPatch(
        (x_min, y_min),
        x_max - x_min,
        y_max - y_min,
        boxstyle=f"round,pad=0,rounding_size={rounding}",
        facecolor=style.WOOD,
        edgecolor=style.WOOD_EDGE,
        linewidth=0.8,
        zorder=0.1,
    )
    ax.add_patch(frame)


def _cushions(pieces: Sequence[Mapping[str, Any]]) -> list[Path]:
    """Give the noses with their jaws and facings, from one pocket to the next; all around where there is none."""
    boundary = [piece for piece in pieces if piece["part"] == "boundary"]
    backs = [place for place, piece in enumerate(boundary) if _is_back(piece)]
    turned = boundary[backs[0] :] + boundary[: backs[0]] if backs else boundary
    chains = [list(chain) for is_back, chain in groupby(turned, key=_is_back) if not is_back]
    return [join_paths(list(map(piece_path, chain))) for chain in chains]


def _is_back(piece: Mapping[str, Any]) -> bool:
    return bool(piece["id"].endswith(".back"))


def _draw_marks(ax: Axes, rails: Rails) -> None:
    """Draw the lines and spots on the cloth of a table that has them."""
    lines, spots = _marks(rails)
    _draw_all(ax, lines, fill=False, edgecolor=style.MARK, linewidth=0.7, zorder=0.3)
    dots = [Path.circle((x, y), 0.005 * rails.width) for x, y in spots]
    _draw_all(ax, dots, facecolor=style.MARK, edgecolor="none", zorder=0.3)


def _marks(rails: Rails) -> tuple[list[Path], list[tuple[float, float]]]:
    """Give the lines and spots by the rules of the game: pool, carom, snooker or English pool."""
    width, length = rails.width, rails.length
    middle = 0.5 * width
    if rails.preset.startswith(("pool_", "pooltool_7ft")):
        return [], [(middle, 0.25 * length), (middle, 0.75 * length)]
    if "carom" in rails.preset:
        return [], [(middle, part * length) for part in (0.25, 0.5, 0.75)]
    if "snooker" in rails.preset:
        baulk, radius = 737.0 / 3569.0 * length, 292.0 / 1778.0 * width
        half = Path.arc(180.0, 360.0)
        curve = Path(np.asarray(half.vertices) * radius + np.array([middle, baulk]), half.codes)
        spots = [(middle + part * radius, baulk) for part in (-1.0, 0.0, 1.0)]
        spots += [(middle, 0.5 * length), (middle, 0.75 * length), (middle, (1.0 - 324.0 / 3569.0) * length)]
        return [Path([(0.0, baulk), (width, baulk)]), curve], spots
    if rails.preset == "english_pool":
        return [Path([(0.0, 0.2 * length), (width, 0.2 * length)])], [(middle, 0.75 * length)]
    return [], []


def _draw_sights(ax: Axes, rails: Rails) -> None:
    """Draw the diamonds in the middle of the wood behind the cushions; where a side pocket is, there is none."""
    out = 0.5 * (rails.cushion + rails.wood)
    across = [rails.width * part / 4 for part in (1, 2, 3)]
    along = [rails.length * part / 8 for part in range(1, 8) if part != 4 or not rails.pockets]
    places = [(x, y) for x in across for y in (-out, rails.length + out)]
    places += [(x, y) for y in along for x in (-out, rails.width + out)]
    size = 0.009 * rails.width
    rhomb = size * np.array([[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])
    sights = [Path(rhomb + np.array(place), closed=True) for place in places]
    _draw_all(ax, sights, facecolor=style.SIGHT, edgecolor=style.WOOD_EDGE, linewidth=0.4, zorder=0.6)


def _draw_all(ax: Axes, paths: Sequence[Path], **look: Any) -> list[PathPatch]:
    """Draw paths as one patch; give it, if there are some."""
    patches = [PathPatch(Path.make_compound_path(*paths), **look)] if paths else []
    for patch in patches:
        ax.add_patch(patch)
    return patches
