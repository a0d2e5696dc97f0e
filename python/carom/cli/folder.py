"""A folder of results: written under a hidden name and moved to its place when it is complete."""

from __future__ import annotations

import os
import shutil
import signal
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from carom.errors import ScenarioError
from carom.files import speaking_of


def check_free(folder: Path, names: Iterable[str], *, overwrite: bool) -> None:
    """Refuse a folder that holds files of these names, unless they may be overwritten."""
    if folder.exists() and not folder.is_dir():
        raise ScenarioError([("--out", f"{folder} is not a folder")])
    taken = [folder / name for name in names if (folder / name).exists()]
    if taken and not overwrite:
        raise ScenarioError([("--out", f"{folder} already holds results; --overwrite replaces them")])
    for path in taken:
        if path.is_dir():
            raise ScenarioError([("--out", f"{path} is a folder, and a file is to be there")])


@contextmanager
def made(folder: Path | None) -> Iterator[None]:
    """Make a folder for what is written while the block goes on; one that is empty when it fails is removed."""
    if folder is None:
        yield
        return
    is_new = not folder.exists()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ScenarioError([("--out", f"{folder} cannot be written: {error.strerror}")]) from None
    try:
        yield
    except BaseException:
        if is_new:
            with suppress(OSError):
                folder.rmdir()
        raise


@contextmanager
def filling(folder: Path, names: Iterable[str], mark: str) -> Iterator[Path]:
    """Give a new empty folder whose files are moved to `folder` when the block ends well.

    When it does not, nothing remains and what was there stays. Files at `folder` that have one of the names but
    were not written anew are removed after the others are in their places; files of other names stay. Ctrl-C is
    held back while files are moved, and the file named `mark` comes last.

    The new folder stands where its files can be renamed to their places: inside `folder` if that is there (it
    may be a link, or another file system), or else in the nearest folder above it that is.

    Parameters
    ----------
    folder : Path
        Where the files are to be; it and the folders above it are made if need be.
    names : iterable of str
        The names that results have in such a folder.
    mark : str
        The file that comes last.
    """
    target = Path(os.path.realpath(folder))
    temporary = _nearest_existing(target) / f".{target.name}.{os.urandom(4).hex()}"
    try:
        try:
            temporary.mkdir()
        except OSError as error:
            raise ScenarioError([("--out", f"{folder} cannot be written: {error.strerror}")]) from None
        with speaking_of(temporary, folder):
            yield temporary
            with _uninterrupted():
                _move_all(temporary, target, names, mark)
    finally:
        with _uninterrupted():
            shutil.rmtree(temporary, ignore_errors=True)


def _move_all(temporary: Path, folder: Path, names: Iterable[str], mark: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    written = sorted((path.name for path in temporary.iterdir()), key=lambda name: name == mark)
    for name in written:
        (temporary / name).replace(folder / name)
    for name in names:
        if name not in written:
            (folder / name).unlink(missing_ok=True)


def _nearest_existing(folder: Path) -> Path:
    return folder if folder.exists() else _nearest_existing(folder.parent)


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Hold Ctrl-C back for a moment."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
