"""Where scenario texts come from: the ready-made ones, and files; and the ready-made tables."""

from __future__ import annotations

import difflib
import os
from pathlib import Path

from carom import _engine
from carom.errors import ScenarioError
from carom.files import read_text

FORMATS = {".toml": "toml", ".json": "json"}
"""The formats of scenario files, by suffix."""


def scenarios() -> list[str]:
    """Give the names of the ready-made scenarios, in order."""
    return sorted(_engine.bundled_scenarios())


def presets() -> dict[str, str]:
    """Give the ready-made tables for `carom.Table.preset`: their titles by their names.

    Examples
    --------
    >>> presets()["snooker_12ft"]
    'Snooker, 12 feet'
    """
    return _engine.presets()


def text_of(source: str | os.PathLike[str]) -> tuple[str, str]:
    """Find a scenario's text and its format.

    Parameters
    ----------
    source : str or path-like
        The name of a ready-made scenario; with a slash or a suffix, or as a path object, the path of a file.

    Returns
    -------
    text, format : str
        The text, and ``"toml"`` or ``"json"``.

    Raises
    ------
    ScenarioError
        When there is no such scenario, naming the nearest ready-made ones; when a file is not UTF-8 text; and
        when its suffix is neither ``.toml`` nor ``.json``, in small letters or not.
    """
    if isinstance(source, str) and not _is_path(source):
        return _bundled(source), "toml"
    path = Path(source)
    return _read(path), format_of(path)


def folder_of(source: str | os.PathLike[str]) -> Path | None:
    """Give the folder that paths in a scenario's file are relative to; a ready-made one has none."""
    return None if isinstance(source, str) and not _is_path(source) else Path(source).parent


def format_of(path: Path) -> str:
    """Give the scenario format that the suffix of `path` stands for."""
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise ScenarioError(f"{path}: a scenario file ends in .toml or .json")
    return FORMATS[suffix]


def _is_path(source: str) -> bool:
    return "/" in source or os.sep in source or bool(Path(source).suffix)


def _bundled(name: str) -> str:
    texts = _engine.bundled_scenarios()
    if name not in texts:
        raise ScenarioError(f"no scenario {name!r}{_nearest(name)}; a file's path has a slash or a suffix")
    return texts[name]


def _read(path: Path) -> str:
    if not path.exists():
        raise ScenarioError(f"{path}: no such file{_nearest(path.stem)}")
    return read_text(path, ScenarioError, "a scenario file")


def _nearest(name: str) -> str:
    near = difflib.get_close_matches(name, scenarios(), n=3, cutoff=0.6)
    return f"; the nearest ready-made: {', '.join(near)}" if near else ""
