"""Snapshots as extended XYZ, the text that OVITO and ASE read."""

from __future__ import annotations

import os
import re
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from carom.errors import RecordError
from carom.files import replacing
from carom.records.boxes import wrapped
from carom.records.outside import Assumed, flat, flat_box, in_box, repeated
from carom.records.snapshot import Snapshot
from carom.records.writing import SnapshotWriter

SUFFIXES = (".xyz", ".extxyz")
NAME = "X"  # for ASE, which takes chemical symbols only, this is none of them
ROWS_AT_ONCE = 20_000
PAIR = re.compile(r"""([^\s=]+)\s*=\s*(?:"([^"]*)"|'([^']*)'|(\S+))""")
TILTS = ("a_y", "a_z", "b_x", "b_z", "c_x", "c_y")

COLUMN_NAMES = {
    "positions": ("pos",),
    "unwrapped": ("unwrapped",),
    "velocities": ("velo", "vel", "velocity", "velocities"),
    "momenta": ("momenta",),
    "radii": ("radius", "radii"),
    "masses": ("mass", "masses"),
    "images": ("map_shift",),
    "ids": ("id",),
}
"""What columns are called, by Carom and OVITO first, then by ASE and others."""

COLUMN_WIDTHS = {
    "positions": (2, 3),
    "unwrapped": (2,),
    "velocities": (2, 3),
    "momenta": (2, 3),
    "radii": (1,),
    "masses": (1,),
    "images": (2, 3),
}
"""How many columns each field of numbers may have."""


class ExtendedXyzWriter(SnapshotWriter):
    """Appends snapshots to an extended XYZ file, for OVITO, ASE and everything that reads text.

    A comment line holds ``Lattice`` (one thick in z, as readers want three dimensions), ``Properties``, ``pbc``,
    ``Time`` and ``Events``; a row has the position in the box, velocity, radius and mass, and in a periodic box the
    position that is not wrapped; then OVITO's ``map_shift`` and ``id`` where the snapshot has images and ids. Numbers
    have 17 digits and are read back with all their bits. All discs are called X, the name of no element; radius and
    mass tell their species. `SnapshotWriter` tells the parameters and errors.

    Parameters
    ----------
    path : path-like
        Where to, ending in ``.xyz`` or ``.extxyz``.
    overwrite, append : bool
        What to do with an older file; without either it is refused.
    """

    suffixes = SUFFIXES

    def _resume(self) -> int:
        with self.path.open("rb") as file:
            count = sum(1 for _ in frame_places(file, self.path))
            self._size = file.seek(0, os.SEEK_END)
        return count

    def _append(self, snapshot: Snapshot) -> None:
        if self._frames == 0:
            with replacing(self.path, durable=True) as temporary, temporary.open("wb") as file:
                self._write(file, snapshot)
            return
        with self.path.open("r+b", buffering=0) as file:
            if file.seek(0, os.SEEK_END) != self._size:
                raise RecordError([("", "the file has another length than before: something else wrote to it")])
            try:
                self._write(file, snapshot)
            except BaseException:
                file.truncate(self._size)
                raise

    def _write(self, file: BinaryIO | Any, snapshot: Snapshot) -> None:
        for part in lines_of(snapshot):
            left = memoryview(part)
            while left:  # a file without a buffer may take less than it is given
                left = left[file.write(left) :]
        file.flush()
        os.fsync(file.fileno())
        self._size = file.tell()


def lines_of(snapshot: Snapshot) -> Iterator[bytes]:
    """Give the text of a frame in pieces of many lines."""
    columns, names, form = _columns(snapshot)
    width, height = snapshot.size.tolist()
    lattice = f"{width:.17g} 0 0 0 {height:.17g} 0 0 0 1"
    properties = ":".join(names)
    pbc = " ".join("T" if flag else "F" for flag in (*snapshot.periodic, False))
    said = f'Properties={properties} pbc="{pbc}" Time={snapshot.time:.17g} Events={snapshot.events}'
    yield f'{len(snapshot)}\nLattice="{lattice}" {said}\n'.encode()
    for start in range(0, len(snapshot), ROWS_AT_ONCE):
        rows = [column[start : start + ROWS_AT_ONCE] for column in columns]
        lists = [part.tolist() if isinstance(part, np.ndarray) else part for part in rows]
        values = [value for row in zip(*lists, strict=True) for value in row]
        yield ((form * len(lists[0])) % tuple(values)).encode()


def _columns(snapshot: Snapshot) -> tuple[list[Any], list[str], str]:
    """Give the columns that differ from disc to disc, the names of all, and the form of a row."""
    names = ["species:S:1", "pos:R:3", "velo:R:3", "radius:R:1", "mass:R:1"]
    forms = [NAME, "%.17g %.17g 0", "%.17g %.17g 0", "%.17g", "%.17g"]
    places = snapshot.positions
    if snapshot.periodic.any():
        images = snapshot.images
        places = wrapped(snapshot)[0] if images is None else snapshot.positions - images * snapshot.size
    columns: list[Any] = [*places.T, *snapshot.velocities.T, snapshot.radii, snapshot.masses]
    if snapshot.periodic.any() or snapshot.images is not None:
        names, forms = [*names, "unwrapped:R:2"], [*forms, "%.17g %.17g"]
        columns += [*snapshot.positions.T]
    if snapshot.images is not None:
        names, forms = [*names, "map_shift:I:3"], [*forms, "%d %d 0"]
        columns += [*snapshot.images.T]
    if snapshot.ids is not None:
        blank = next((place for place, name in enumerate(snapshot.ids) if name.split() != [name]), None)
        if blank is not None:
            raise RecordError([(f"ids[{blank}]", f"must have no blanks in this format, got {snapshot.ids[blank]!r}")])
        names, forms = [*names, "id:S:1"], [*forms, "%s"]
        columns += [snapshot.ids]
    return columns, names, " ".join(forms) + "\n"


def frame_places(file: BinaryIO, path: Path) -> Iterator[tuple[int, int]]:
    """Give where each frame begins, and its number of discs; a frame that is cut short is an error.

    The file stands behind the frame when its place is given.
    """
    number = 0
    while True:
        start = file.tell()
        head = file.readline()
        if not head.strip() and not file.read().strip():  # the end, perhaps after empty lines
            return
        count = int(head) if head.strip().isdigit() else 0
        if count == 0:
            found = head.decode("utf-8", "replace").strip()[:40]
            message = f"must begin with its number of discs, got {found!r}"
            raise RecordError([(f"{path}, frame {number}", message)])
        last = deque(enumerate(islice(file, count + 1)), maxlen=1)
        if not last or last[0][0] < count or not last[0][1].endswith(b"\n"):
            raise cut_short(path, number)
        yield start, count
        number += 1


def whole_frames(file: BinaryIO, path: Path, most: int | None = None) -> tuple[int, int]:
    """Give how many whole frames a file begins with, `most` at most, and where they end."""
    count = end = 0
    with suppress(RecordError):
        for _ in islice(frame_places(file, path), most):
            count, end = count + 1, file.tell()
    return count, end


def cut_short(path: Path, frame: int) -> RecordError:
    """Give the error of a frame that ends too early, which says how to save the others."""
    whole = f"the {frame} frames before are" if frame > 1 else "frame 0 is"
    advice = f"; {whole} whole, and recover({str(path)!r}, to) copies them" if frame else ""
    return RecordError([(f"{path}, frame {frame}", f"is cut short: its last line is missing or has no end{advice}")])


class XyzFile:
    """An extended XYZ file, open for reading.

    Parameters
    ----------
    path : Path
        The file.
    assumed : Assumed
        What its frames are taken to have where they say nothing.
    """

    def __init__(self, path: Path, assumed: Assumed) -> None:
        self.path, self._assumed = path, assumed
        self._places: list[int] | None = None
        try:
            self._file = path.open("rb")
        except FileNotFoundError:
            raise RecordError([(str(path), "no such file")]) from None

    def __enter__(self) -> XyzFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def __len__(self) -> int:
        return len(self._starts())

    def snapshot(self, frame: int) -> Snapshot:
        """Read one frame, counted from 0."""
        self._file.seek(self._starts()[frame])
        return self._read(frame)

    def stream(self) -> Iterator[Snapshot]:
        """Read frame after frame."""
        for frame, (start, _) in enumerate(frame_places(self._file, self.path)):
            end = self._file.tell()
            self._file.seek(start)
            yield self._read(frame)
            self._file.seek(end)

    def _starts(self) -> list[int]:
        if self._places is None:
            self._file.seek(0)
            self._places = [start for start, _ in frame_places(self._file, self.path)]
        return self._places

    def _read(self, frame: int) -> Snapshot:
        count = int(self._file.readline())
        lines = list(islice(self._file, count + 1))
        try:
            return snapshot_of(lines, frame, self._assumed)
        except RecordError as error:
            place = f"{self.path}, frame {frame}"
            raise RecordError([(f"{place}, {where}", what) for where, what in error.problems]) from None


@dataclass(frozen=True)
class Header:
    """What the comment line of a frame says."""

    pairs: dict[str, str]
    columns: dict[str, tuple[int, int]]
    """The first column and the number of columns of each property."""

    @classmethod
    def of(cls, line: str) -> Header:
        """Read a comment line."""
        pairs = {key: one or two or three for key, one, two, three in PAIR.findall(line)}
        if "Properties" not in pairs:
            raise RecordError([("comment line", "must have Properties=..., as extended XYZ has it")])
        words = pairs["Properties"].split(":")
        columns, at = {}, 0
        if len(words) % 3 or not all(width.isdigit() for width in words[2::3]):
            raise RecordError([("Properties", f"must be name:kind:columns and so on, got {pairs['Properties']!r}")])
        for name, width in zip(words[::3], map(int, words[2::3]), strict=True):
            if name in columns:
                raise RecordError([("Properties", f"names {name} twice")])
            columns[name] = (at, width)
            at += width
        return cls(pairs, columns)

    def find(self, field: str) -> str | None:
        """Give the name of the column that holds a field, or None."""
        return next((name for name in COLUMN_NAMES[field] if name in self.columns), None)

    def number(self, *keys: str) -> float | None:
        """Give the number of the first of these keys that is there."""
        found = next((key for key in keys if key in self.pairs), None)
        if found is None:
            return None
        try:
            return float(self.pairs[found])
        except ValueError:
            raise RecordError([(found, f"must be a number, got {self.pairs[found]!r}")]) from None

    def count(self, key: str) -> int:
        """Give the whole number of a key, 0 if it is not there."""
        word = self.pairs.get(key, "0")
        if not word.isdigit():
            raise RecordError([(key, f"must be a whole number, got {word!r}")])
        return int(word)

    def box(self) -> tuple[NDArray[np.float64], NDArray[np.float64], list[bool]]:
        """Give the lower left corner and the size of the box, and whether it is periodic."""
        cell, origin = self._numbers("Lattice", 9), np.zeros(3)
        if "Origin" in self.pairs:
            origin = self._numbers("Origin", 3)
        matrix = cell.reshape(3, 3)
        sides = np.concatenate([np.diag(matrix), matrix[~np.eye(3, dtype=bool)]])
        # A lattice without pbc is periodic, as in ASE.
        flags = self.pairs.get("pbc", "T T T").replace("True", "T").replace("False", "F").split()
        if len(flags) != 3 or not set(flags) <= {"T", "F", "1", "0"}:
            raise RecordError([("pbc", f"must be three of T and F, got {self.pairs['pbc']!r}")])
        return origin[:2], flat_box(sides, TILTS), [flag in "T1" for flag in flags[:2]]

    def _numbers(self, key: str, count: int) -> NDArray[np.float64]:
        words = self.pairs.get(key, "").split()
        try:
            numbers = np.array([float(word) for word in words])
        except ValueError:
            numbers = np.zeros(0)
        if len(numbers) != count:
            got = repr(self.pairs[key]) if key in self.pairs else "none"
            raise RecordError([(key, f"must be {count} numbers, got {got}")])
        return numbers


def snapshot_of(lines: Sequence[bytes], frame: int, assumed: Assumed) -> Snapshot:
    """Read a frame, from its comment line on.

    Parameters
    ----------
    lines : sequence of bytes
        The comment line and a line for each disc.
    frame : int
        Its number, which counts as its time if the file has none.
    assumed : Assumed
        What is taken where the file does not say it.
    """
    header = Header.of(lines[0].decode("utf-8", "replace"))
    rows = lines[1:]
    fields = _numbers_of(header, rows)
    if "positions" not in fields:
        raise RecordError([("Properties", "must have pos")])
    origin, size, periodic = header.box()
    positions = flat("positions", fields["positions"]) - origin
    images = _whole(flat("images", fields["images"])) if "images" in fields else None
    masses = _given(fields, "masses", assumed.mass, "mass", len(rows))
    derived = ("velocities",) if "momenta" in fields else ()
    time = header.number("Time", "time")
    name = header.find("ids")
    return Snapshot(
        frame * assumed.time_step if time is None else time,
        header.count("Events"),
        size,
        periodic,
        fields["unwrapped"] if "unwrapped" in fields else in_box(positions, size, images),
        _velocities(fields, masses, assumed, len(rows)),
        _given(fields, "radii", assumed.radius, "radius", len(rows)),
        masses,
        images,
        None if name is None else _words(rows, header.columns[name][0]),
        assumed=[each for each in ("velocities", "radii", "masses") if each not in (*fields, *derived)],
    )


def _whole(images: NDArray[np.float64]) -> NDArray[np.int64]:
    wrong = (images != np.rint(images)) | (np.abs(images) > 2**31)
    if wrong.any():
        disc, axis = (int(index) for index in np.argwhere(wrong)[0])
        message = f"must be a whole number of 32 bits, got {images[disc, axis]:g}"
        raise RecordError([(f"images[{disc}, {axis}]", message)])
    return images.astype(np.int64)


def _velocities(fields: dict[str, Any], masses: NDArray[np.float64], assumed: Assumed, rows: int) -> Any:
    if "velocities" not in fields and "momenta" in fields:
        return flat("momenta", fields["momenta"], still=True) / masses[:, None]
    return flat("velocities", _given(fields, "velocities", assumed.velocity, "velocity", rows, 2), still=True)


def _given(
    fields: dict[str, Any], field: str, default: float | None, option: str, rows: int, columns: int = 1
) -> NDArray[np.float64]:
    """Give a field as the file has it, or as it was assumed."""
    if field in fields:
        values: NDArray[np.float64] = fields[field]
        return values[:, 0] if columns == 1 else values
    if default is None:
        names = " or ".join(COLUMN_NAMES[field])
        raise RecordError([(field, f"the file has no column {names}: give {option}=... to take one for all")])
    return repeated(default, rows, columns)


def _numbers_of(header: Header, rows: Sequence[bytes]) -> dict[str, NDArray[np.float64]]:
    """Read all columns of numbers that are known, each field as (n, columns) float64."""
    wanted = {field: name for field in COLUMN_WIDTHS if (name := header.find(field)) is not None}
    spans = {field: header.columns[name] for field, name in wanted.items()}
    for field, (_, width) in spans.items():
        if width not in COLUMN_WIDTHS[field]:
            allowed = " or ".join(map(str, COLUMN_WIDTHS[field]))
            raise RecordError([("Properties", f"{wanted[field]} must have {allowed} columns, got {width}")])
    places = [at + step for at, width in spans.values() for step in range(width)]
    try:
        numbers = np.loadtxt(rows, dtype=np.float64, usecols=places, comments=None, ndmin=2, encoding="utf-8")
    except ValueError as error:
        raise RecordError([("rows", _worded(str(error)))]) from None
    if len(numbers) != len(rows):
        raise RecordError([("rows", f"must be {len(rows)}, got {len(numbers)} and empty lines")])
    fields, at = {}, 0
    for field, (_, width) in spans.items():
        fields[field] = np.ascontiguousarray(numbers[:, at : at + width])
        at += width
    return fields


def _worded(message: str) -> str:
    """Say what NumPy found wrong, in one line and without its advice."""
    return message.splitlines()[0].split("; use `usecols`")[0].rstrip(".")


def _words(rows: Sequence[bytes], column: int) -> list[str]:
    return [row.split()[column].decode("utf-8") for row in rows]
