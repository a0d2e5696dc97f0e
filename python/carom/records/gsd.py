"""Snapshots in GSD files of the schema hoomd, which HOOMD-blue and OVITO read.

HOOMD-blue has a box centred on the origin and positions in 24 bits. So that Carom gets back the bits that it wrote,
the exact numbers are there too, as logged quantities: ``log/carom/*`` of the frame, ``log/particles/carom/*`` of each
disc. OVITO shows them, and `gsd.hoomd` gives them in `frame.log`.
"""

from __future__ import annotations

import errno
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom._engine import __version__
from carom.errors import RecordError
from carom.extras import needed
from carom.files import replacing
from carom.records.boxes import centred, species
from carom.records.gsd_blocks import COUNT, check_room, restoring
from carom.records.outside import Assumed, flat, flat_box, in_box, repeated
from carom.records.snapshot import Snapshot, same_bits
from carom.records.writing import SnapshotWriter

SUFFIXES = (".gsd",)
SCHEMA, SCHEMA_VERSION = "hoomd", (1, 4)
IDS = "carom/ids"
Chunks = dict[str, NDArray[Any]]


class GsdWriter(SnapshotWriter):
    """Appends snapshots to a GSD file, for HOOMD-blue, OVITO and everything else that reads the schema hoomd.

    A frame has `step`, the collisions so far; a box of two dimensions (Lz = 0), periodic in both as HOOMD-blue knows
    no other; wrapped positions, their images, velocities, diameters and masses in float32; and a type for each pair of
    radius and mass, A the smallest. HOOMD's box is centred on the origin, while Carom's has its lower left corner
    there: x in the file is Carom's x − width/2, and so for y. Carom's own numbers, with all their bits, are in the
    chunks ``log/carom/time``, ``size`` and ``periodic`` and ``log/particles/carom/position`` (not wrapped),
    ``velocity``, ``radius``, ``mass`` and ``image``. What does not change is written once, as the schema has it.

    Every frame is on the disk before it is entered in the file's index, so that a crash leaves the earlier frames.
    Needs carom[gas]. `SnapshotWriter` tells the parameters and errors.

    Parameters
    ----------
    path : path-like
        Where to, ending in ``.gsd``.
    overwrite, append : bool
        What to do with an older file; without either it is refused.
    """

    suffixes = SUFFIXES

    def _resume(self) -> int:
        with GsdFile(self.path) as file:
            if len(file):
                file.snapshot(len(file) - 1)  # is it whole?
                self._first = file.constants()
            return len(file)

    def _append(self, snapshot: Snapshot) -> None:
        chunks = chunks_of(snapshot)
        room = sum(chunk.nbytes for chunk in chunks.values())
        if self._frames == 0:
            check_room(self.path.absolute(), room)
            with replacing(self.path, durable=True) as temporary, _opened(temporary, "x") as file:
                self._write(file, chunks)
            self._first = {name: chunk for name, chunk in chunks.items() if name in CONSTANT}
            return
        if IDS in self._first and IDS not in chunks:
            raise RecordError([("ids", "must be there, as the first frame has them")])
        same_discs = same_bits(self._first["particles/N"], chunks["particles/N"])
        for name in CONSTANT:
            if same_discs and name in chunks and same_bits(self._first.get(name), chunks[name]):
                del chunks[name]
        with restoring(self.path, room), _opened(self.path, "r+") as file:
            if file.nframes != self._frames:
                raise RecordError([("", f"the file has {file.nframes} frames: something else wrote to it")])
            self._write(file, chunks)

    def _write(self, file: Any, chunks: Chunks) -> None:
        for name, chunk in chunks.items():
            file.write_chunk(name, chunk)
        # A power cut may leave part of a frame's entries in the index: that shows when they are counted.
        file.write_chunk(COUNT, np.array([len(chunks) + 1], dtype=np.uint32))
        file.end_frame()


CONSTANT = (
    "configuration/dimensions",
    "configuration/box",
    "particles/N",
    "particles/types",
    "particles/typeid",
    "particles/mass",
    "particles/diameter",
    "log/carom/size",
    "log/carom/periodic",
    "log/particles/carom/radius",
    "log/particles/carom/mass",
    IDS,
)
"""What is not written again where it is as in the first frame."""


def chunks_of(snapshot: Snapshot) -> Chunks:
    """Give all that a frame holds, by the names of its chunks."""
    positions, images = centred(snapshot)
    names, typeid = species(snapshot.radii, snapshot.masses)
    velocities = np.zeros((len(snapshot), 3), dtype=np.float32)
    velocities[:, :2] = _single("velocities", snapshot.velocities)
    chunks: Chunks = {
        "configuration/step": np.array([snapshot.events], dtype=np.uint64),
        "configuration/dimensions": np.array([2], dtype=np.uint8),
        "configuration/box": np.array([*_single("size", snapshot.size), 0, 0, 0, 0], dtype=np.float32),
        "particles/N": np.array([len(snapshot)], dtype=np.uint32),
        "particles/types": _texts(names),
        "particles/typeid": typeid,
        "particles/mass": _single("masses", snapshot.masses),
        "particles/diameter": _single("radii", 2.0 * snapshot.radii),
        "particles/position": positions,
        "particles/velocity": velocities,
        "particles/image": images,
        "log/carom/time": np.array([snapshot.time]),
        "log/carom/size": snapshot.size,
        "log/carom/periodic": snapshot.periodic.astype(np.uint8),
        "log/particles/carom/position": snapshot.positions,
        "log/particles/carom/velocity": snapshot.velocities,
        "log/particles/carom/radius": snapshot.radii,
        "log/particles/carom/mass": snapshot.masses,
    }
    if snapshot.images is not None:
        chunks["log/particles/carom/image"] = snapshot.images
    if snapshot.ids is not None:
        chunks[IDS] = _texts(snapshot.ids)
    return chunks


def _single(name: str, values: NDArray[np.float64]) -> NDArray[np.float32]:
    """Give values in the precision that HOOMD-blue has, for what fits in."""
    if np.abs(values).max() > np.finfo(np.float32).max:
        raise RecordError([(name, "must be below 3.4e38, the largest number of this format")])
    return values.astype(np.float32)


class GsdFile:
    """A GSD file of the schema hoomd, open for reading.

    Parameters
    ----------
    path : Path
        The file.
    assumed : Assumed
        What its frames are taken to have where they say nothing; where that is not given either, the schema's
        defaults: diameter 1, mass 1, at rest.
    """

    def __init__(self, path: Path, assumed: Assumed | None = None) -> None:
        self.path, self._assumed = path, assumed or Assumed()
        with _told(path):
            self._file = _open(path, "r")
        if self._file.schema != SCHEMA:
            self._file.close()
            raise RecordError([(str(path), f"is of the schema {self._file.schema!r}, and must be of {SCHEMA!r}")])

    def __enter__(self) -> GsdFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def __len__(self) -> int:
        return int(self._file.nframes)

    def constants(self) -> Chunks:
        """Give what the first frame holds of all that is not written again."""
        return {name: self._file.read_chunk(0, name) for name in CONSTANT if self._file.chunk_exists(0, name)}

    def snapshot(self, frame: int) -> Snapshot:
        """Read one frame, counted from 0."""
        with _told(self.path, frame):
            if self._file.chunk_exists(0, COUNT):
                return self._own(frame)
            return self._foreign(frame)

    def _own(self, frame: int) -> Snapshot:
        file = self._file
        names = [name for name in file.find_matching_chunk_names("") if file.chunk_exists(frame, name)]
        if COUNT not in names or int(file.read_chunk(frame, COUNT)[0]) != len(names):
            raise RecordError(
                [("", f"part of it is missing: recover({str(self.path)!r}, to) copies the frames before")]
            )
        positions, velocities, radii, masses = (
            self._read(frame, f"log/particles/carom/{name}") for name in ("position", "velocity", "radius", "mass")
        )
        images, ids = "log/particles/carom/image", self._find(frame, IDS)
        return Snapshot(
            float(self._read(frame, "log/carom/time")[0]),
            int(self._read(frame, "configuration/step")[0]),
            self._read(frame, "log/carom/size"),
            self._read(frame, "log/carom/periodic") != 0,
            positions,
            velocities,
            radii,
            masses,
            file.read_chunk(frame, images) if images in names else None,
            None if ids is None else _words(ids, len(positions)),
        )

    def _foreign(self, frame: int) -> Snapshot:
        """Read a frame that another program wrote, with the defaults of the schema."""
        count = self._find(frame, "particles/N")
        discs = 0 if count is None else int(count[0])
        box = self._find(frame, "configuration/box")
        step = self._find(frame, "configuration/step")
        assumed = self._assumed.or_else(radius=0.5, mass=1.0, velocity=0.0)
        held = {"velocities": "velocity", "radii": "diameter", "masses": "mass"}
        fields: Chunks = {
            "size": flat_box(np.ones(3) if box is None else box, tilts=("xy", "xz", "yz")),
            "positions": self._per_disc(frame, "position", discs, 0.0, 3),
            "velocities": self._per_disc(frame, "velocity", discs, assumed.velocity, 3),
            "radii": self._per_disc(frame, "diameter", discs, 2.0 * (assumed.radius or 0.0), 1),
            "masses": self._per_disc(frame, "mass", discs, assumed.mass, 1),
        }
        single = [name for name, values in fields.items() if values.dtype == np.float32]
        exact = {name: values.astype(np.float64) for name, values in fields.items()}
        exact["positions"] = flat("positions", exact["positions"])
        exact["velocities"] = flat("velocities", exact["velocities"], still=True)
        images = self._find(frame, "particles/image")
        turns = None if images is None or len(images) != discs else flat("images", images)
        steps = 0 if step is None else int(step[0])
        return Snapshot(
            steps * assumed.time_step,
            0,
            exact["size"],
            (True, True),
            in_box(exact["positions"] + exact["size"] / 2.0, exact["size"], turns),
            exact["velocities"],
            exact["radii"] / 2.0,
            exact["masses"],
            turns,
            single_precision=single,
            assumed=[name for name, chunk in held.items() if self._find(frame, f"particles/{chunk}", discs) is None],
        )

    def _per_disc(
        self, frame: int, name: str, discs: int, default: float | None, columns: int
    ) -> NDArray[np.float64] | NDArray[np.float32]:
        found = self._find(frame, f"particles/{name}", discs)
        return repeated(default or 0.0, discs, columns) if found is None else found

    def _find(self, frame: int, name: str, rows: int | None = None) -> Any:
        """Read a chunk; where a frame lacks it that of frame 0, as the schema has it, if the discs are as many."""
        if self._file.chunk_exists(frame, name):
            return self._file.read_chunk(frame, name)
        if not self._file.chunk_exists(0, name):
            return None
        first = self._file.read_chunk(0, name)
        return first if rows is None or len(first) == rows else None

    def _read(self, frame: int, name: str) -> Any:
        found = self._find(frame, name)
        if found is None:
            raise RecordError([(name, "is missing")])
        return found


def _open(path: Path, mode: str) -> Any:
    needed("gsd", "gas")
    kind = (None, None, None) if mode == "r" else (f"Carom {__version__}", SCHEMA, SCHEMA_VERSION)
    return import_module("gsd.fl").open(str(path), mode, *kind)


@contextmanager
def _opened(path: Path, mode: str) -> Iterator[Any]:
    """Open a file to write a frame; when the block fails its own error is told, not a second one of the closing."""
    file = _open(path, mode)
    try:
        yield file
    except BaseException:
        with suppress(OSError, RuntimeError):
            file.close()
        raise
    try:
        file.close()
    except RuntimeError as error:  # what it says when its index could not grow
        raise OSError(errno.EIO, f"gsd could not finish the frame ({error})", str(path)) from error


@contextmanager
def _told(path: Path, frame: int | None = None) -> Iterator[None]:
    """Turn what gsd says of a file, and what is wrong with a frame, into an error that names the file and frame."""
    place = str(path) if frame is None else f"{path}, frame {frame}"
    try:
        yield
    except FileNotFoundError:
        raise RecordError([(place, "no such file")]) from None
    except RecordError as error:
        said = [(", ".join(filter(None, (place, where))), what) for where, what in error.problems]
        raise RecordError(said) from None
    except RuntimeError as error:
        if not str(error).startswith("Corrupt"):
            raise RecordError([(place, str(error).replace(f": {path}", ""))]) from None
        advice = f"recover({str(path)!r}, to) copies its whole frames"
        raise RecordError([(place, f"is cut short or damaged: {advice}")]) from None


def _texts(words: Any) -> NDArray[np.int8]:
    """Give words as the schema writes them: rows of bytes in UTF-8, each with a zero at its end."""
    coded = [word.encode("utf-8") for word in words]
    width = max(map(len, coded)) + 1
    return np.array(coded, dtype=f"S{width}").view(np.int8).reshape(len(coded), width)


def _words(rows: NDArray[np.int8], count: int) -> list[str]:
    width = rows.size // count
    texts: list[bytes] = np.ascontiguousarray(rows).view(f"S{width}").ravel().tolist()
    return [text.decode("utf-8") for text in texts]
