"""What a run may be asked beyond its scenario, checked and as the engine reads it."""

from __future__ import annotations

import math
import numbers
from collections.abc import Mapping
from typing import Any, Literal, TypedDict

from carom.encoding import to_json
from carom.errors import ScenarioError
from carom.method import Exact, Stepped

Record = Literal["all", "events", "none"]
"""What a run keeps: events and flights, events only, or neither."""


class RunOptions(TypedDict, total=False):
    """What a run may be asked in place of what its scenario says; see `Scenario.run`."""

    method: Exact | Stepped | Mapping[str, Any] | None
    duration: float | None
    collisions: int | None
    max_events: int | None
    record: Record | None


def options_json(options: Mapping[str, Any]) -> str:
    """Check the types of `options` and give them as JSON text; what is None is left out."""
    given = {name: value for name, value in options.items() if value is not None}
    for name, value in given.items():
        _CHECKS.get(name, _unknown)(name, value)
    return to_json(given) if given else "{}"


def check_counts(values: Mapping[str, Any]) -> None:
    """Refuse a count that is no int among the keys of a scenario, as among the options of a run."""
    for name in ("collisions", "max_events"):
        if values.get(name) is not None:
            check_whole(name, values[name])


def check_whole(name: str, value: object) -> None:
    """Refuse what is no int."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name}: must be an int, got {value!r}")


def check_number(name: str, value: object) -> None:
    """Refuse what is no number."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: must be a number, got {value!r}")


def check_finite(name: str, value: object) -> None:
    """Refuse what is no number, or none that is finite."""
    check_number(name, value)
    if not math.isfinite(value):  # type: ignore[arg-type]
        raise ScenarioError([(name, f"must be finite, got {value}")])


def _method(name: str, value: object) -> None:
    if not isinstance(value, (Exact, Stepped, Mapping)):
        raise TypeError(f"{name}: must be carom.Exact() or carom.Stepped(dt=...), got {value!r}")


def _word(name: str, value: object) -> None:
    if not isinstance(value, str):
        raise TypeError(f"{name}: must be a word, got {value!r}")


def _unknown(name: str, value: object) -> None:
    raise TypeError(f"unknown option {name}={value!r}; known are {', '.join(_CHECKS)}")


_CHECKS = {
    "method": _method,
    "duration": check_number,
    "collisions": check_whole,
    "max_events": check_whole,
    "record": _word,
    "until": _word,
}
