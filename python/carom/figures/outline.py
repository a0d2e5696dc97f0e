"""The outline of a table as paths to draw."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.path import Path

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from numpy.typing import NDArray

    from carom.figures.scene import Scene


def table_loops(scene: Scene) -> list[tuple[str, Path]]:
    """Join the pieces of an outline into paths, one for the boundary and one for each obstacle."""
    loops: list[tuple[str, list[Path]]] = []
    end = None
    for piece in scene.pieces:
        path = piece_path(piece)
        joined = end is not None and np.allclose(_places(path)[0], end, rtol=0, atol=1e-9 * scene.size)
        if joined and loops[-1][0] == piece["part"]:
            loops[-1][1].append(path)
        else:
            loops.append((piece["part"], [path]))
        end = _places(path)[-1]
    return [(part, join_paths(paths)) for part, paths in loops]


def piece_path(piece: Mapping[str, Any]) -> Path:
    """Draw one piece of an outline as a path in its own direction."""
    if piece["kind"] == "line":
        return Path([piece["start"], piece["end"]])
    start, end = piece["from_deg"], piece["to_deg"]
    unit = Path.arc(min(start, end), max(start, end))
    places = _places(unit) * piece["radius"] + np.asarray(piece["center"], dtype=float)
    return Path(places if start <= end else places[::-1], unit.codes)


def join_paths(paths: Sequence[Path]) -> Path:
    """Put paths that follow one another into one, closed where the last end meets the first start."""
    vertices = [_places(paths[0])[:1]]
    codes = [np.array([Path.MOVETO], dtype=Path.code_type)]
    for path in paths:
        drawn = _places(path)[1:]
        vertices.append(drawn)
        lines = np.full(len(drawn), Path.LINETO, dtype=Path.code_type)
        codes.append(lines if path.codes is None else np.asarray(path.codes)[1:])
    places = np.concatenate(vertices)
    span = float(np.ptp(places, axis=0).max())
    if np.allclose(places[0], places[-1], rtol=0, atol=1e-9 * span):
        vertices.append(places[:1])
        codes.append(np.array([Path.CLOSEPOLY], dtype=Path.code_type))
    return Path(np.concatenate(vertices), np.concatenate(codes))


def _places(path: Path) -> NDArray[np.float64]:
    return np.asarray(path.vertices, dtype=np.float64)


def is_closed(path: Path) -> bool:
    """Tell whether a path made by `join_paths` comes back to its start."""
    return path.codes is not None and np.asarray(path.codes)[-1] == Path.CLOSEPOLY
