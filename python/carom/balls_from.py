"""Balls that a scenario reads from a file of snapshots: ``[balls_from]``."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import _engine
from carom.encoding import to_json
from carom.errors import RecordError, ScenarioError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from carom.records import Snapshot

Problems = list[tuple[str, str]]
KEY = "balls_from"


def parse(
    text: str, form: str, folder: Path | None = None, values: Mapping[str, Any] | None = None
) -> _engine.Scenario:
    """Read a scenario's text; balls in a file of their own are read, too.

    Parameters
    ----------
    text : str
        The scenario.
    form : "toml" or "json"
        Its format.
    folder : Path, optional
        What the file's path is relative to; absent: the working folder.
    values : mapping, optional
        Values to change by their paths before the file is read.
    """
    reader = BallsReader(folder or Path())
    try:
        return _engine.Scenario.parse(text, form, reader, to_json(values or {}))
    except ScenarioError as error:
        if advice := reader.advice(error.problems):
            raise ScenarioError([*error.problems, *advice]) from None
        raise


@dataclass(frozen=True)
class Frame:
    """One frame of a file, as the engine takes it."""

    ids: list[str] | None
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64] | None
    radii: NDArray[np.float64]
    masses: NDArray[np.float64]
    size: list[float]
    periodic: list[bool]
    frame: int
    sha256: str


class BallsReader:
    """Reads the file that ``[balls_from]`` names; called with its keys as JSON text.

    Parameters
    ----------
    folder : Path
        What its path is relative to.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._is_single = False

    def __call__(self, keys: str) -> Frame | Problems:
        """Give the frame, or the problems with their places."""
        given: dict[str, Any] = json.loads(keys)
        try:
            return self._read(given)
        except RecordError as error:
            return [(f"{KEY}.path", f"{place}: {message}" if place else message) for place, message in error.problems]
        except OSError as error:
            return [(f"{KEY}.path", f"{given['path']}: cannot be read: {error.strerror or error}")]

    def _read(self, given: dict[str, Any]) -> Frame | Problems:
        # NumPy takes longer to load than most scenarios to read.
        from carom.records import content_hash, frame_count, read_snapshot
        from carom.records.boxes import wrapped

        path, frame = self._folder / given["path"], int(given.get("frame", -1))
        count = frame_count(path)
        if not -count <= frame < count:
            there = f"frames 0 to {count - 1}" if count > 1 else "frame 0 only" if count else "none"
            return [(f"{KEY}.frame", f"there is no frame {frame} in {given['path']}; it has {there}")]
        sha256 = content_hash(path).removeprefix("sha256:")
        wanted = given.get("sha256")
        if wanted is not None and wanted.lower().removeprefix("sha256:") != sha256:
            return [(f"{KEY}.sha256", f"{given['path']} has changed: its SHA-256 is {sha256}")]
        snapshot = read_snapshot(
            path, frame, radius=given.get("radius", 1.0), mass=given.get("mass", 1.0), velocity=0.0
        )
        if problems := _problems(given, snapshot):
            return problems
        self._is_single = "positions" in snapshot.single_precision
        return Frame(
            None if snapshot.ids is None else list(snapshot.ids),
            wrapped(snapshot)[0],
            None if "velocities" in snapshot.assumed else snapshot.velocities,
            snapshot.radii,
            snapshot.masses,
            snapshot.size.tolist(),
            snapshot.periodic.tolist(),
            frame % count,
            sha256,
        )

    def advice(self, problems: Problems) -> Problems:
        """Say what helps where positions of 24 bits make discs overlap."""
        if not self._is_single or not any(" overlaps ball " in message for _, message in problems):
            return []
        message = "the file's positions are in single precision, so discs that touch may overlap: 0.99999 parts them"
        return [(f"{KEY}.radius_factor", message)]


def _problems(given: dict[str, Any], snapshot: Snapshot) -> Problems:
    """Say what was given though the file has it, and what neither has."""
    problems: Problems = []
    for key, field in (("radius", "radii"), ("mass", "masses")):
        if key in given and field not in snapshot.assumed:
            message = f"is for a file without {field}, and this one has some: leave it out"
            problems.append((f"{KEY}.{key}", message))
    if "radius" not in given and "radii" in snapshot.assumed:
        problems.append((f"{KEY}.radius", "missing: the file has no radii; GSD means 0.5 when it has none"))
    return problems
