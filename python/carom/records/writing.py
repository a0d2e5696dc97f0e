"""What the writers of snapshots have in common."""

from __future__ import annotations

import errno
import os
from abc import ABC, abstractmethod
from pathlib import Path

from carom.errors import RecordError
from carom.records.snapshot import Snapshot


class SnapshotWriter(ABC):
    """Appends snapshots to a file, each of them whole or not at all.

    Nothing is open between two frames, so there is nothing to close. When a frame cannot be written, because the
    disk is full or Ctrl-C comes, the file is put back as it was before; the next `write` tries anew.

    Parameters
    ----------
    path : path-like
        Where to; its folder must exist. The file appears with the first frame.
    overwrite : bool
        Whether an older file is replaced, by the first frame.
    append : bool
        Whether an older file goes on, if there is one.

    Raises
    ------
    RecordError
        If the suffix is another, if there is a file and neither was said, or if a file that is to go on is not whole.
    """

    suffixes: tuple[str, ...] = ()

    def __init__(self, path: str | os.PathLike[str], *, overwrite: bool = False, append: bool = False) -> None:
        self.path = Path(path)
        check_suffix(self.path, self.suffixes)
        if overwrite and append:
            raise RecordError([(str(path), "either overwrite or append, not both")])
        is_there = self.path.exists()
        if is_there and not (overwrite or append):
            raise RecordError([(str(path), "is there already: overwrite=True replaces it, append=True goes on")])
        self._frames = self._resume() if is_there and append else 0

    def __len__(self) -> int:
        return self._frames

    def __repr__(self) -> str:
        return f"{type(self).__name__}: {self._frames} frames in {self.path}"

    def write(self, snapshot: Snapshot) -> None:
        """Append one frame.

        Raises
        ------
        RecordError
            If it cannot be written, because the disk is full, for example; the earlier frames are whole and stay.
        """
        place = f"{self.path}, frame {self._frames}"
        try:
            self._append(snapshot)
        except RecordError as error:
            raise RecordError([(f"{place}, {where}", what) for where, what in error.problems]) from None
        except OSError as error:
            raise RecordError([(place, f"not written, {reason_of(error)}; {self._kept()}")]) from error
        self._frames += 1

    def _kept(self) -> str:
        if self._frames == 0:
            return "nothing was changed"
        return f"the {self._frames} before it are whole and stay" if self._frames > 1 else "frame 0 is whole and stays"

    @abstractmethod
    def _resume(self) -> int:
        """Give the number of frames of a file that is to go on."""

    @abstractmethod
    def _append(self, snapshot: Snapshot) -> None:
        """Append a frame, or leave all as it was and raise."""


def check_suffix(path: Path, suffixes: tuple[str, ...]) -> None:
    """Refuse a path with another suffix."""
    if path.suffix.lower() not in suffixes:
        raise RecordError([(str(path), f"must end in {' or '.join(suffixes)}")])


def reason_of(error: OSError) -> str:
    """Say in words why something could not be written."""
    return "the disk is full" if error.errno == errno.ENOSPC else error.strerror or str(error)
