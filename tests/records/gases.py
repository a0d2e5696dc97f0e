"""Gases to write and read back, with numbers that show every lost bit."""

from pathlib import Path

import numpy as np

from carom.records import ExtendedXyzWriter, GsdWriter, ParquetWriter, Snapshot

WRITERS = {".gsd": GsdWriter, ".xyz": ExtendedXyzWriter, ".parquet": ParquetWriter}
SUFFIXES = list(WRITERS)
FILES = Path(__file__).parent / "files"


def gas(
    frame: int = 0,
    discs: int = 7,
    *,
    periodic: tuple[bool, bool] = (True, True),
    images: bool = True,
    ids: bool = False,
    seed: int = 11,
) -> Snapshot:
    """A frame of a mixture of two species; where the box is periodic the discs have gone round it."""
    random = np.random.default_rng([seed, frame])
    size = np.array([4.1, 3.3]) * np.sqrt(discs)
    positions = (random.random((discs, 2)) + np.where(periodic, random.integers(-3, 4, (discs, 2)), 0)) * size
    large = np.arange(discs) % 2 == 1
    return Snapshot(
        0.1 * frame + 1.0 / 3.0,
        1000 * frame,
        size,
        periodic,
        positions,
        random.normal(size=(discs, 2)),
        np.where(large, 0.7, 0.5),
        np.where(large, 1.96, 1.0),
        np.floor(positions / size).astype(np.int32) if images else None,
        [f"disc {disc}" if ids == "blanks" else f"d{disc}é" for disc in range(discs)] if ids else None,
    )
