"""Plain Python values, NumPy numbers included, as the JSON text that the engine reads."""

from __future__ import annotations

import json
import math
import numbers
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from typing import Any


class Encodable(ABC):
    """Something that says itself as a table of keys and values."""

    @abstractmethod
    def to_dict(self) -> dict[str, Any]:
        """Give the keys and values."""


def plain(value: Any) -> Any:
    """Give `value` built from dicts, lists, text, numbers, booleans and None only.

    NumPy scalars become Python numbers and arrays become lists. A number that is not finite becomes ``"nan"``,
    ``"inf"`` or ``"-inf"``, so that the engine can name the place where it stands.
    """
    # The plain types first: a planner encodes thousands of numbers, and an abstract class is slow to ask.
    if value is None or isinstance(value, (str, bool)):
        return value
    if isinstance(value, (int, float)):
        return _plain_number(value)
    if isinstance(value, (dict, Mapping)):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, Encodable):
        return plain(value.to_dict())
    if isinstance(value, numbers.Real):
        return _plain_number(value)
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, Iterable):
        return [plain(item) for item in value]
    raise TypeError(f"a scenario holds text, numbers, lists and tables, not {type(value).__name__}")


def _plain_number(value: numbers.Real | float) -> int | float | str:
    if not isinstance(value, float) and isinstance(value, (int, numbers.Integral)):
        return int(value)
    number = float(value)
    return number if math.isfinite(number) else str(number)


def to_json(value: Any) -> str:
    """Give `value` as JSON text; floats keep every bit."""
    return json.dumps(plain(value), allow_nan=False, ensure_ascii=False)
