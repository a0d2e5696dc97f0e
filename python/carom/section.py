"""What the parts of a scenario have in common: each is one table of its file."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, ClassVar

from carom.encoding import Encodable, plain


class Section(Encodable):
    """A frozen dataclass that stands for one table of a scenario file.

    Values are checked where they meet the rest, when a `Scenario` is made. Sections compare by what they say: a list
    equals a tuple of the same numbers, and 1 equals 1.0.
    """

    tag: ClassVar[dict[str, str]] = {}

    def to_dict(self) -> dict[str, Any]:
        """Give the keys of the table; what is absent is left out."""
        return {**self.tag, **self._present()}

    def _present(self) -> dict[str, Any]:
        values = {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]
        return {name: value for name, value in values.items() if value is not None}

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return bool(plain(self) == plain(other))

    def __hash__(self) -> int:
        return hash((type(self), _hashable(plain(self))))

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={value!r}" for name, value in self._present().items())
        return f"{type(self).__name__}({values})"


def _hashable(value: Any) -> Any:
    if isinstance(value, dict):
        return tuple((key, _hashable(item)) for key, item in sorted(value.items()))
    return tuple(map(_hashable, value)) if isinstance(value, list) else value
