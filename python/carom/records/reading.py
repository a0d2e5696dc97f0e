"""Reading snapshots, whichever program wrote them."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from carom.errors import RecordError
from carom.files import replacing
from carom.records import gsd, parquet, xyz
from carom.records.gsd_blocks import recover_gsd
from carom.records.outside import Assumed
from carom.records.snapshot import Snapshot
from carom.records.writing import check_suffix

SUFFIXES = (*gsd.SUFFIXES, *xyz.SUFFIXES, *parquet.SUFFIXES)
PIECE = 1 << 20


def read_snapshot(
    path: str | os.PathLike[str],
    frame: int = -1,
    *,
    radius: float | None = None,
    mass: float | None = None,
    velocity: float | None = None,
    time_step: float = 1.0,
) -> Snapshot:
    """Read one frame of a GSD, extended XYZ or Parquet file, of Carom's or of another program's.

    What Carom wrote is read back with all its bits. HOOMD-blue's frames have no time and no collisions: their time is
    their step times `time_step`, their events are 0; extended XYZ without ``Time`` counts frames in the same way. A box
    with a third dimension is taken where all discs lie in one plane and move in it; one that is tilted is refused.
    The box's lower left corner becomes the origin. Wrapped positions and images (``map_shift`` in extended XYZ) become
    positions that are not wrapped.

    Parameters
    ----------
    path : path-like
        The file, ending in ``.gsd``, ``.xyz``, ``.extxyz`` or ``.parquet``.
    frame : int
        Which frame, from 0; −1 is the last.
    radius, mass, velocity : float, optional
        What every disc has where the file says nothing of it. Otherwise GSD has its schema's defaults (radius ½,
        mass 1, at rest), and extended XYZ is refused.
    time_step : float
        The time of one step or frame where the file counts those.

    Returns
    -------
    Snapshot
        Its `single_precision` names the fields that the file holds in float32 only.

    Raises
    ------
    RecordError
        If there is no such frame, or what is wrong with it: file, frame, field and what is allowed.
    """
    with _opened(path, Assumed(radius, mass, velocity, time_step)) as file:
        count = len(file)
        if not -count <= frame < count:
            there = f"frames 0 to {count - 1}" if count > 1 else "frame 0 only" if count else "none"
            raise RecordError([(str(path), f"there is no frame {frame}; it has {there}")])
        return file.snapshot(frame % count)


def frames(
    path: str | os.PathLike[str],
    *,
    radius: float | None = None,
    mass: float | None = None,
    velocity: float | None = None,
    time_step: float = 1.0,
) -> Iterator[Snapshot]:
    """Read all frames of a file one after the other; one is held in memory at a time.

    The parameters and errors are those of `read_snapshot`. The whole frames of an extended XYZ file that is cut short
    come first, then the error.
    """
    with _opened(path, Assumed(radius, mass, velocity, time_step)) as file:
        if isinstance(file, xyz.XyzFile):
            yield from file.stream()
            return
        for frame in range(len(file)):
            yield file.snapshot(frame)


def frame_count(path: str | os.PathLike[str]) -> int:
    """Give how many frames a file has."""
    with _opened(path, Assumed()) as file:
        return len(file)


def content_hash(path: str | os.PathLike[str]) -> str:
    """Give the SHA-256 of a file's bytes, as ``sha256:...``; of a folder, that of its files' names and hashes.

    Of a folder each file counts, in order of name, as ``<64 digits>  <name>`` and a line feed, which is what
    ``sha256sum`` prints of them. Hidden files are left out, as a file that is being written is one.
    """
    place = Path(path)
    if not place.exists():
        raise RecordError([(str(path), "no such file")])
    if not place.is_dir():
        return f"sha256:{_digest(place)}"
    whole = hashlib.sha256()
    for part in sorted(each for each in place.iterdir() if each.is_file() and not each.name.startswith(".")):
        whole.update(f"{_digest(part)}  {part.name}\n".encode())
    return f"sha256:{whole.hexdigest()}"


def recover(path: str | os.PathLike[str], to: str | os.PathLike[str]) -> int:
    """Copy the whole frames of a GSD or extended XYZ file that was cut short.

    Parameters
    ----------
    path : path-like
        The file that is cut; it stays as it is.
    to : path-like
        Where the copy is to be, with the same suffix; nothing may be there.

    Returns
    -------
    int
        How many frames the copy has.

    Raises
    ------
    RecordError
        If not even one frame is whole, or something is at `to`.
    """
    source, target = Path(path), Path(to)
    check_suffix(source, (*gsd.SUFFIXES, *xyz.SUFFIXES))
    check_suffix(target, gsd.SUFFIXES if source.suffix.lower() in gsd.SUFFIXES else xyz.SUFFIXES)
    if not source.is_file():
        raise RecordError([(str(path), "no such file")])
    if target.exists():
        raise RecordError([(str(to), "is there already")])
    if source.suffix.lower() in gsd.SUFFIXES:
        return recover_gsd(source, target)
    return _recover_xyz(source, target)


def _recover_xyz(path: Path, to: Path) -> int:
    with path.open("rb") as file:
        count, end = xyz.whole_frames(file, path)
        if count == 0:
            raise RecordError([(str(path), "has no whole frame: nothing to recover")])
        file.seek(0)
        with replacing(to) as temporary, temporary.open("wb") as copy:
            for piece in _pieces(file):
                copy.write(piece[: end - copy.tell()])
    return count


def _opened(path: str | os.PathLike[str], assumed: Assumed) -> gsd.GsdFile | xyz.XyzFile | parquet.ParquetFile:
    place = Path(path)
    check_suffix(place, SUFFIXES)
    if place.suffix.lower() in gsd.SUFFIXES:
        return gsd.GsdFile(place, assumed)
    return xyz.XyzFile(place, assumed) if place.suffix.lower() in xyz.SUFFIXES else parquet.ParquetFile(place)


def _digest(path: Path) -> str:
    digest = hashlib.sha256()
    with path.open("rb") as file:
        for piece in _pieces(file):
            digest.update(piece)
    return digest.hexdigest()


def _pieces(file: BinaryIO) -> Iterator[bytes]:
    while piece := file.read(PIECE):
        yield piece
