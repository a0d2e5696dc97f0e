"""Files cut after so many frames or events, so that a run which goes on from an earlier moment appends the next."""

from __future__ import annotations

import os
from pathlib import Path

from carom.errors import RecordError
from carom.records import gsd, parquet, xyz
from carom.records.event_files import WORD
from carom.records.gsd_blocks import recover_gsd
from carom.records.parquet import parquet_library, parts_of
from carom.records.writing import check_suffix


def cut_frames(path: str | os.PathLike[str], frames: int) -> None:
    """Cut a file of snapshots after so many frames; what is cut short or damaged behind them goes too.

    With no frames nothing is left of the file, nor of a folder but for files of other names.

    Parameters
    ----------
    path : path-like
        The file, or the folder of a `ParquetWriter`; it need not be there if no frame is asked for.
    frames : int
        How many are to stay.

    Raises
    ------
    RecordError
        If it has fewer.
    """
    place = Path(path)
    check_suffix(place, (*gsd.SUFFIXES, *xyz.SUFFIXES, *parquet.SUFFIXES))
    if frames and not place.exists():
        raise RecordError([(str(path), f"no such file, and {_frames(frames)} of it are to stay")])
    if place.is_dir():
        parts = parts_of(place)
        _check_count(place, len(parts), frames)
        for part in reversed(parts[frames:]):
            part.unlink()
    elif frames == 0:
        place.unlink(missing_ok=True)
    elif place.suffix.lower() in gsd.SUFFIXES:
        _cut_gsd(place, frames)
    else:
        _cut_xyz(place, frames)


def cut_events(path: str | os.PathLike[str], events: int) -> None:
    """Cut a folder of an `EventWriter` after so many events, where a piece ends.

    Parameters
    ----------
    path : path-like
        The folder; it need not be there if no events are asked for.
    events : int
        How many are to stay.

    Raises
    ------
    RecordError
        If it has fewer, or no piece ends there.
    """
    place, kept = Path(path), 0
    parts = parts_of(place, WORD) if place.is_dir() else []
    for number, part in enumerate(parts):
        if kept >= events:
            for later in reversed(parts[number:]):
                later.unlink()
            break
        kept += parquet_library().read_metadata(part).num_rows
    if kept != events:
        raise RecordError([(str(path), f"must have a piece that ends after {events} events, and has one after {kept}")])


def _cut_gsd(path: Path, frames: int) -> None:
    try:
        with gsd.GsdFile(path) as file:
            if len(file) == frames:
                file.snapshot(frames - 1)  # is it whole?
                return
    except RecordError:
        pass  # it is damaged behind these frames, perhaps
    _check_count(path, recover_gsd(path, path, frames), frames)


def _cut_xyz(path: Path, frames: int) -> None:
    with path.open("r+b") as file:
        count, end = xyz.whole_frames(file, path, frames)
        _check_count(path, count, frames)
        file.truncate(end)
        file.flush()
        os.fsync(file.fileno())


def _check_count(path: Path, found: int, wanted: int) -> None:
    if found < wanted:
        raise RecordError([(str(path), f"has {_frames(found)}, and {wanted} are to stay")])


def _frames(count: int) -> str:
    return "one frame" if count == 1 else f"{count} frames"
