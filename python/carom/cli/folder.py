"""A folder of results: written beside its place and moved there when it is complete."""

from __future__ import annotations

import secrets
import shutil
import signal
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from carom.errors import ScenarioError


def check_free(folder: Path, names: Iterable[str], *, overwrite: bool) -> None:
    """Refuse a folder that holds files of these names, unless they may be overwritten."""
    if folder.exists() and not folder.is_dir():
        raise ScenarioError([("--out", f"{folder} is not a folder")])
    if not overwrite and any((folder / name).exists() for name in names):
        raise ScenarioError([("--out", f"{folder} already holds results; --overwrite replaces them")])


@contextmanager
def filling(folder: Path, names: Iterable[str], mark: str) -> Iterator[Path]:
    """Give a new empty folder whose files are moved to `folder` when the block ends well.

    When it does not, nothing remains. Files at `folder` that have one of the names but were not written anew
    are removed; others stay. Ctrl-C is held back while files are moved, and the file named `mark` comes last:
    where it stands, the others are complete.

    Parameters
    ----------
    folder : Path
        Where the files are to be; it and the folders above it are made if need be.
    names : iterable of str
        The names that results have in such a folder.
    mark : str
        The file that goes first and comes last.
    """
    temporary = _nearest_existing(folder.parent) / f".{folder.name}.{secrets.token_hex(4)}"
    try:
        temporary.mkdir()
    except OSError as error:
        raise ScenarioError([("--out", f"{folder} cannot be made: {error.strerror}")]) from None
    try:
        yield temporary
        with _uninterrupted():
            _move_all(temporary, folder, names, mark)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _move_all(temporary: Path, folder: Path, names: Iterable[str], mark: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    written = sorted((path.name for path in temporary.iterdir()), key=lambda name: name == mark)
    for name in [mark, *names]:
        if name == mark or name not in written:
            (folder / name).unlink(missing_ok=True)
    for name in written:
        (temporary / name).replace(folder / name)


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
