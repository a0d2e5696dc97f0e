"""Snapshots as Parquet, for pandas, Polars, DuckDB and everything that reads tables."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from carom.errors import RecordError
from carom.extras import needed
from carom.files import replacing
from carom.records.snapshot import Snapshot
from carom.records.writing import SnapshotWriter

SUFFIXES = (".parquet",)
CONSTANT = ("frame", "time", "events", "width", "height", "periodic_x", "periodic_y")
COLUMNS = ("x", "y", "vx", "vy", "radius", "mass")


class ParquetWriter(SnapshotWriter):
    """Appends snapshots to a folder of Parquet files, which pandas, Polars and DuckDB read as one table.

    A Parquet file can be read when its end is written only, so each frame is a file of its own in the folder `path`,
    ``frame-000000000.parquet`` and so on: it appears whole, and a crash leaves the frames before. A row is a disc:
    frame, time, events, width, height, periodic_x, periodic_y (the same for all discs of a frame, and next to nothing
    on the disk), x, y (not wrapped), vx, vy, radius, mass; image_x, image_y and id where the snapshot has them.
    Needs carom[data]. `SnapshotWriter` tells the parameters and errors.

    Parameters
    ----------
    path : path-like
        The folder, ending in ``.parquet``; it is made with the first frame.
    overwrite, append : bool
        What to do with an older folder; without either it is refused. Files of other names in it stay.
    """

    suffixes = SUFFIXES

    def _resume(self) -> int:
        if not self.path.is_dir():
            raise RecordError(
                [(str(self.path), "is one file, which cannot go on: append=True needs a folder of frames")]
            )
        return len(parts_of(self.path))

    def _append(self, snapshot: Snapshot) -> None:
        table, old = _table(snapshot, self._frames), []
        if self._frames == 0:
            if self.path.is_file():
                raise RecordError([("", "is one file, and a folder of frames is to be there")])
            old = parts_of(self.path) if self.path.is_dir() else []
            self.path.mkdir(exist_ok=True)
        try:
            with replacing(self.path / part_name(self._frames), durable=True) as temporary:
                # Only what repeats itself is worth a dictionary.
                parquet_library().write_table(table, temporary, use_dictionary=[*CONSTANT])
                for part in reversed(old[1:]):
                    part.unlink()
        except BaseException:
            with suppress(OSError):  # of a first frame nothing stays, of others the folder is not empty
                self.path.rmdir()
            raise


class ParquetFile:
    """A folder of frames, or one Parquet file with the same columns.

    Parameters
    ----------
    path : Path
        The folder or file.
    """

    def __init__(self, path: Path) -> None:
        self.path, self._library = path, parquet_library()
        if not path.exists():
            raise RecordError([(str(path), "no such file")])
        self._parts = parts_of(path) if path.is_dir() else []
        self._numbers = [] if path.is_dir() else self._listed()

    def __enter__(self) -> ParquetFile:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing is open between two frames."""

    def __len__(self) -> int:
        return len(self._parts) or len(self._numbers)

    def snapshot(self, frame: int) -> Snapshot:
        """Read one frame, counted from 0."""
        place = f"{self.path}, frame {frame}"
        if self._parts:
            part = self._parts[frame]
            with _read_by_arrow(f"{place} ({part.name})"), self._library.ParquetFile(part) as file:
                table = file.read()
        else:
            with _read_by_arrow(place):
                only = [("frame", "=", self._numbers[frame])]
                table = self._library.read_table(self.path, filters=only, partitioning=None)
        missing = [name for name in (*CONSTANT, *COLUMNS) if name not in table.column_names]
        if missing:
            raise RecordError([(f"{place}, {name}", "there is no such column") for name in missing])
        try:
            return _snapshot(table)
        except RecordError as error:
            raise RecordError([(f"{place}, {where}", what) for where, what in error.problems]) from None

    def _listed(self) -> list[int]:
        """Give the numbers of the frames in one file."""
        with _read_by_arrow(str(self.path)), self._library.ParquetFile(self.path) as file:
            table = file.read(["frame"])
        if "frame" not in table.column_names:
            raise RecordError([(f"{self.path}, frame", "there is no such column")])
        return sorted(table.column("frame").unique().to_pylist())


@contextmanager
def _read_by_arrow(place: str) -> Iterator[None]:
    try:
        yield
    except (ValueError, OSError) as error:  # Arrow's own errors are among these
        said = str(error).splitlines()[0]
        raise RecordError([(place, f"cannot be read, it is cut short or no Parquet: {said}")]) from None


def parts_of(folder: Path, word: str = "frame") -> list[Path]:
    """Give the files of a folder's frames, or of other parts, in order; a gap among them is an error."""
    name = re.compile(rf"{word}-\d{{9}}\.parquet")
    found = sorted(path for path in folder.iterdir() if name.fullmatch(path.name))
    for number, path in enumerate(found):
        if path.name != part_name(number, word):
            raise RecordError([(f"{folder}, {word} {number}", "is missing, and later ones are there")])
    return found


def part_name(number: int, word: str = "frame") -> str:
    """Give the name of a file in a folder of parts."""
    return f"{word}-{number:09d}.parquet"


def _table(snapshot: Snapshot, frame: int) -> Any:
    library = needed("pyarrow", "data")
    rows = len(snapshot)
    width, height = snapshot.size.tolist()
    periodic_x, periodic_y = snapshot.periodic.tolist()
    values = (frame, snapshot.time, snapshot.events, width, height, periodic_x, periodic_y)
    columns: dict[str, Any] = {name: np.full(rows, value) for name, value in zip(CONSTANT, values, strict=True)}
    numbers = (*snapshot.positions.T, *snapshot.velocities.T, snapshot.radii, snapshot.masses)
    columns.update(zip(COLUMNS, map(np.ascontiguousarray, numbers), strict=True))
    if snapshot.images is not None:
        columns["image_x"], columns["image_y"] = map(np.ascontiguousarray, snapshot.images.T)
    if snapshot.ids is not None:
        columns["id"] = library.array(snapshot.ids, type=library.string())
    return library.table(columns)


def _snapshot(table: Any) -> Snapshot:
    columns = {name: _numbers(table, name) for name in table.column_names if name != "id"}
    for name in CONSTANT:
        if (columns[name] != columns[name][0]).any():
            raise RecordError([(name, "must be the same for all discs of a frame")])
    first = {name: columns[name][0] for name in CONSTANT}
    return Snapshot(
        float(first["time"]),
        int(first["events"]),
        (first["width"], first["height"]),
        (bool(first["periodic_x"]), bool(first["periodic_y"])),
        np.column_stack([columns["x"], columns["y"]]),
        np.column_stack([columns["vx"], columns["vy"]]),
        columns["radius"],
        columns["mass"],
        np.column_stack([columns["image_x"], columns["image_y"]]) if "image_x" in columns else None,
        table.column("id").to_pylist() if "id" in table.column_names else None,
    )


def _numbers(table: Any, name: str) -> Any:
    column = table.column(name)
    if column.null_count:
        raise RecordError([(name, "must have no empty places")])
    return column.to_numpy()


def parquet_library() -> Any:
    """Give pyarrow's part for Parquet, which carom[data] brings."""
    needed("pyarrow", "data")
    return import_module("pyarrow.parquet")
