"""Packages that only an extra brings."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from carom.errors import MissingExtraError


def needed(module: str, extra: str) -> ModuleType:
    """Import `module`, or raise `MissingExtraError` with the one line that says how to get it.

    A module that is there but does not load keeps its own error.
    """
    try:
        return import_module(module)
    except ModuleNotFoundError as missing:
        if missing.name != module:
            raise
        raise MissingExtraError(f"{module} is not installed: needs carom[{extra}]") from missing
