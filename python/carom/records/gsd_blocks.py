"""The blocks of a GSD file, version 2: to put a file back as it was, and to save what a cut one still holds.

A header of 256 bytes says where the index and the list of names lie. An entry of the index, 32 bytes, says where a
chunk of a frame lies; the first entry with place 0 ends it. The index stands at byte 256 first; when it is full, one
twice as long is begun at the end of the file, and the old one is left where it was.

The layout is that of the GSD documentation, "File layer".
"""

from __future__ import annotations

import errno
import mmap
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from carom.errors import RecordError
from carom.files import replacing

MAGIC = 0x65DF65DF65DF65DF
HEADER = np.dtype(
    [
        ("magic", "<u8"),
        ("index", "<u8"),
        ("entries", "<u8"),
        ("names", "<u8"),
        ("name_blocks", "<u8"),
        ("versions", "<u4", 2),
        ("application", "S64"),
        ("schema", "S64"),
        ("reserved", "S80"),
    ]
)
ENTRY = np.dtype(
    [
        ("frame", "<u8"),
        ("rows", "<u8"),
        ("place", "<u8"),
        ("columns", "<u4"),
        ("name", "<u2"),
        ("kind", "u1"),
        ("flags", "u1"),
    ]
)
BYTES = np.array([0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1], dtype=np.uint64)
"""The size of a number of each kind: none, uint8 to uint64, int8 to int64, float32, float64, character."""
FIRST_INDEX, FIRST_ENTRIES = HEADER.itemsize, 128
FIRST_NAMES = FIRST_INDEX + FIRST_ENTRIES * ENTRY.itemsize
NAME_BLOCK, FIRST_NAME_BLOCKS = 64, 16
COUNT = "log/carom/chunks"  # holds how many chunks a frame of Carom's has
MARGIN = 65_536  # for the names and the pieces that a disk is parted in


@contextmanager
def restoring(path: Path, room: int) -> Iterator[None]:
    """Put a file back as it was when the block raises: its header, its index and names, and its length.

    When the index cannot grow, gsd (up to 5.0 at least) goes on and writes the new entries over the first ones. All
    that is changed in place is kept in memory here, and needs no room on the disk to be put back.

    Parameters
    ----------
    path : Path
        The file.
    room : int
        How many bytes will be added; too little of it is found out beforehand, with room for the index twice as long.
        For gsd reads a new index through memory, and a full disk that is memory itself kills the process then.
    """
    with path.open("rb") as file:
        header = file.read(HEADER.itemsize)
        size = file.seek(0, os.SEEK_END)
        said = np.frombuffer(header, HEADER)[0]
        blocks = [(0, header)]
        for start, length in (
            (int(said["index"]), int(said["entries"]) * ENTRY.itemsize),
            (int(said["names"]), int(said["name_blocks"]) * NAME_BLOCK),
        ):
            file.seek(start)
            blocks.append((start, file.read(length)))
    check_room(path, room + 2 * int(said["entries"]) * ENTRY.itemsize)
    try:
        yield
    except BaseException:
        with path.open("r+b") as file:
            for start, block in blocks:
                file.seek(start)
                file.write(block)
            file.truncate(size)
            file.flush()
            os.fsync(file.fileno())
        raise


def check_room(path: Path, needed: int) -> None:
    """Raise the error of a full disk if there is less room than this, and a little more, where a file is."""
    if shutil.disk_usage(path.parent).free < needed + MARGIN:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))


def recover_gsd(path: Path, to: Path, most: int | None = None) -> int:
    """Copy a GSD file up to its last whole frame, of the first `most`; give how many frames that are.

    Both may be the same path. The copy ends behind the last of what it holds.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = np.frombuffer(file.read(HEADER.itemsize).ljust(HEADER.itemsize, b"\0"), HEADER).copy()
        if size < FIRST_NAMES + FIRST_NAME_BLOCKS * NAME_BLOCK or header["magic"][0] != MAGIC:
            raise RecordError([(str(path), "is no GSD file, or was cut before its first frame: nothing to recover")])
        if header["names"][0] + header["name_blocks"][0] * NAME_BLOCK > size:
            header["names"], header["name_blocks"] = FIRST_NAMES, FIRST_NAME_BLOCKS
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as held:
            said = int(header["index"][0]), int(header["entries"][0])
            places = [place for place in (said, *_indices(held)) if place[0] < size]
            start, room = max(places, key=lambda place: len(_usable(held, *place)))
            entries = _of_whole_frames(held, _usable(held, start, room), _counts(header[0], held))
            entries = entries if most is None else entries[entries["frame"] < most]
            frames = int(entries["frame"][-1]) + 1 if len(entries) else 0
    if frames == 0:
        raise RecordError([(str(path), "has no whole frame: nothing to recover")])
    header["index"], header["entries"] = start, room
    with replacing(to, durable=True) as temporary:
        shutil.copyfile(path, temporary)
        with temporary.open("r+b") as file:
            file.write(header.tobytes())
            # Older indices too: whoever looks for the best of them must not find frames that are gone.
            for place, size in {*places, (start, room)}:
                file.seek(place)
                file.write(entries[:size].tobytes().ljust(size * ENTRY.itemsize, b"\0"))
            file.truncate(max(start + room * ENTRY.itemsize, _end_of(header[0], entries)))
    return frames


def _end_of(header: np.void, entries: NDArray[np.void]) -> int:
    """Give where the last chunk ends, or the list of names if it lies behind."""
    chunks = entries["place"] + entries["rows"] * entries["columns"] * BYTES[entries["kind"]]
    return max(int(chunks.max()), int(header["names"] + header["name_blocks"] * NAME_BLOCK))


def _indices(held: mmap.mmap) -> Iterator[tuple[int, int]]:
    """Give where each index of a file lies, and how many entries it has room for.

    Older ones stay where they were. All begin with the same entries, and each is twice as long as the one before.
    """
    beginning = held[FIRST_INDEX : FIRST_INDEX + 4 * ENTRY.itemsize]
    place, entries = FIRST_INDEX, FIRST_ENTRIES
    while place > 0:
        yield place, entries
        place, entries = held.find(beginning, place + 1), entries * 2


def _usable(held: mmap.mmap, start: int, most: int) -> NDArray[np.void]:
    """Give the entries of an index up to the first that leads nowhere."""
    available = min(most, (len(held) - start) // ENTRY.itemsize)
    listed = np.frombuffer(held[start : start + available * ENTRY.itemsize], ENTRY)
    kinds = np.minimum(listed["kind"], len(BYTES) - 1)
    last_bytes = listed["place"] + listed["rows"] * listed["columns"] * BYTES[kinds]
    wrong = (listed["place"] == 0) | (last_bytes > len(held)) | (listed["flags"] != 0)
    wrong |= (listed["kind"] == 0) | (listed["kind"] >= len(BYTES))
    wrong[1:] |= listed["frame"][1:] < listed["frame"][:-1]
    return listed[: np.argmax(wrong)] if wrong.any() else listed


def _of_whole_frames(held: mmap.mmap, entries: NDArray[np.void], count_name: int | None) -> NDArray[np.void]:
    """Leave out the entries of the last frame, if they are not all.

    A frame of Carom's says how many it has. Of others' the last is left out, as nobody knows.
    """
    last = entries[entries["frame"] == entries["frame"][-1]] if len(entries) else entries
    for place in last["place"][last["name"] == count_name].tolist():
        if int.from_bytes(held[place : place + 4], "little") == len(last):
            return entries
    return entries[: len(entries) - len(last)]


def _counts(header: NDArray[np.void], held: mmap.mmap) -> int | None:
    """Give the number of the name under which frames say how many chunks they have."""
    start, length = int(header["names"]), int(header["name_blocks"]) * NAME_BLOCK
    names = held[start : start + length].split(b"\0")
    return names.index(COUNT.encode()) if COUNT.encode() in names else None
