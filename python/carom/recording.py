"""What a run of a gas writes while it goes on: snapshots, events and checkpoints."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from carom.errors import ScenarioError
from carom.options import check_finite, check_whole

CHECKPOINT = "checkpoint.carom"
"""The checkpoint in a folder of results."""

EVERY = 300.0
"""Seconds between two checkpoints, if nothing is said."""


@dataclass(frozen=True, slots=True)
class Snapshots:
    """Snapshots, written to a file while the run goes on; one of `every_time`, `every_collisions` and `at` says when.

    Each frame is on the disk before the run goes on. They move no trajectory.

    Parameters
    ----------
    path : path-like
        The file: ``.gsd`` for HOOMD-blue and OVITO, ``.xyz`` or ``.extxyz`` for extended XYZ, ``.parquet`` for a folder
        of tables.
    every_time : float, optional
        At the start, and at these intervals of time.
    every_collisions : int, optional
        At the start, and after so many more collisions of balls with balls and cushions.
    at : sequence of float, optional
        At these times, which ascend.
    overwrite : bool
        Whether an older file is replaced; otherwise it is refused.

    Raises
    ------
    ScenarioError
        When none or several of the three say when.

    Examples
    --------
    >>> import carom
    >>> carom.Snapshots("gas.gsd", every_time=0.5).every_time
    0.5
    """

    path: str | os.PathLike[str]
    every_time: float | None = None
    every_collisions: int | None = None
    at: Sequence[float] | None = None
    overwrite: bool = False

    def __post_init__(self) -> None:
        given = [name for name in ("every_time", "every_collisions", "at") if getattr(self, name) is not None]
        if len(given) != 1:
            got = f"got {' and '.join(given)}" if given else "got none"
            raise ScenarioError([("snapshots", f"needs one of every_time, every_collisions and at, {got}")])
        if self.every_time is not None:
            check_finite("snapshots.every_time", self.every_time)
        if self.every_collisions is not None:
            check_whole("snapshots.every_collisions", self.every_collisions)
            if self.every_collisions < 1:
                raise ScenarioError(
                    [("snapshots.every_collisions", f"must be one or more, got {self.every_collisions}")]
                )
        for time in self.at if self.at is not None else ():
            check_finite("snapshots.at", time)

    def plan(self) -> dict[str, Any]:
        """Give when they come, as the engine reads it."""
        times = None if self.at is None else list(self.at)
        plans = {"every_time": self.every_time, "every_collisions": self.every_collisions, "at": times}
        return {name: value for name, value in plans.items() if value is not None}


@dataclass(frozen=True, slots=True)
class EventStream:
    """All events of a span of time, written as Parquet while the run goes on; needs carom[data].

    They are the columns of `Run.events` with all their bits; `index` counts the events of the whole run. Some ten
    thousand are held in memory at a time.

    Parameters
    ----------
    path : path-like
        The folder, ending in ``.parquet``, whose files are whole; pandas, Polars and DuckDB read it as one table.
    window : (float, float)
        Its beginning and its end, both included.
    overwrite : bool
        Whether an older folder is replaced; otherwise it is refused.

    Examples
    --------
    >>> import carom
    >>> carom.EventStream("events.parquet", window=(10, 11)).window
    (10, 11)
    """

    path: str | os.PathLike[str]
    window: tuple[float, float]
    overwrite: bool = False

    def __post_init__(self) -> None:
        if len(self.window) != 2:
            raise ScenarioError([("events.window", f"must be two times, got {self.window!r}")])
        for time in self.window:
            check_finite("events.window", time)

    def plan(self) -> dict[str, float]:
        """Give the window, as the engine reads it."""
        begin, end = self.window
        return {"from": begin, "to": end}


@dataclass(frozen=True, slots=True)
class Checkpoints:
    """A file that holds the run as it was a while ago, from which `carom.resume` goes on with the same bits.

    It is written at the start, now and then, when the run ends and when something ends it, Ctrl-C for instance: under
    another name first, and renamed when it is on the disk. So there always is a whole one.

    Parameters
    ----------
    path : path-like
        The file.
    every : float
        Seconds from one to the next.
    overwrite : bool
        Whether the checkpoint of another run is replaced; otherwise it is refused.

    Examples
    --------
    >>> import carom
    >>> carom.Checkpoints("gas.carom").every
    300.0
    """

    path: str | os.PathLike[str]
    every: float = EVERY
    overwrite: bool = False

    def __post_init__(self) -> None:
        check_finite("checkpoints.every", self.every)
        if not self.every >= 0:
            raise ScenarioError([("checkpoints.every", f"must be seconds, from zero on, got {self.every!r}")])
