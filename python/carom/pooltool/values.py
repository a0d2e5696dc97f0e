"""Values in what pooltool wrote."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from carom.errors import ScenarioError


def at(values: Any, path: str) -> Any:
    """Give the value at a path such as ``"specs.M"``; its absence is an error that names the path."""
    for key in path.split("."):
        if not isinstance(values, Mapping) or key not in values:
            raise ScenarioError([(path, "is missing from pooltool's file")])
        values = values[key]
    return values
