"""Values in what pooltool wrote."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from carom.errors import ScenarioError


def at(values: Any, *keys: str) -> Any:
    """Give the value below these keys; the absence of one is an error that names its place."""
    for depth, key in enumerate(keys, start=1):
        if not isinstance(values, Mapping) or key not in values:
            raise ScenarioError([(".".join(keys[:depth]), "is missing from pooltool's file")])
        values = values[key]
    return values
