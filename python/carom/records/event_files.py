"""Events as Parquet, for pandas, Polars, DuckDB and everything that reads tables."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from carom.errors import RecordError
from carom.files import replacing
from carom.records.parquet import SUFFIXES, parquet_library, part_name, parts_of
from carom.records.writing import check_suffix, reason_of

if TYPE_CHECKING:
    from carom.events import EventTable

WORD = "events"
"""What the files of a folder of events are called: ``events-000000000.parquet`` and so on."""


class EventWriter:
    """Appends pieces of a stream of events to a folder of Parquet files, which others read as one table.

    Each piece is a file of its own, which appears whole; a crash leaves those before. Needs carom[data].

    Parameters
    ----------
    path : path-like
        The folder, ending in ``.parquet``; it is made with the first piece.
    overwrite : bool
        Whether an older folder is replaced. Files of other names in it stay.
    append : bool
        Whether an older folder goes on, if there is one.

    Raises
    ------
    RecordError
        If the suffix is another, if a file is there, or a folder of events and neither was said.
    """

    def __init__(self, path: str | os.PathLike[str], *, overwrite: bool = False, append: bool = False) -> None:
        self.path = Path(path)
        check_suffix(self.path, SUFFIXES)
        parquet_library()
        if self.path.is_file():
            raise RecordError([(str(path), "is one file, and a folder of events is to be there")])
        there = parts_of(self.path, WORD) if self.path.is_dir() else []
        if there and not (overwrite or append):
            raise RecordError([(str(path), "is there already: overwrite=True replaces it, append=True goes on")])
        if overwrite:
            for part in reversed(there):
                part.unlink()
        self._parts = 0 if overwrite else len(there)

    def write(self, events: EventTable) -> None:
        """Append a piece.

        Raises
        ------
        RecordError
            If it cannot be written, because the disk is full, for example; the earlier pieces stay.
        """
        place = self.path / part_name(self._parts, WORD)
        try:
            self.path.mkdir(exist_ok=True)
            with replacing(place, durable=True) as temporary:
                parquet_library().write_table(events.to_arrow(), temporary)
        except OSError as error:
            raise RecordError([(str(place), f"not written, {reason_of(error)}; the pieces before it stay")]) from error
        self._parts += 1


def events_to_parquet(events: EventTable | Iterable[EventTable], path: str | os.PathLike[str]) -> None:
    """Write events as one Parquet file, with the columns of `run.events` and all their bits.

    The file is written under a temporary name and appears when it is complete; one that is there is replaced.
    Needs carom[data].

    Parameters
    ----------
    events : EventTable or iterable of EventTable
        The events, or pieces of a long stream one after the other, each of which becomes a row group.
    path : path-like
        Where to, ending in ``.parquet``.

    Raises
    ------
    RecordError
        If the suffix is another, or there is no piece at all.
    """
    from carom.events import EventTable

    check_suffix(Path(path), SUFFIXES)
    pieces = iter([events] if isinstance(events, EventTable) else events)
    first = next(pieces, None)
    if first is None:
        raise RecordError([(str(path), "there is no piece of the stream to write, not even an empty one")])
    writer = parquet_library()
    table = first.to_arrow()
    with replacing(path) as temporary, writer.ParquetWriter(temporary, table.schema) as file:
        file.write_table(table)
        for piece in pieces:
            file.write_table(piece.to_arrow())
