"""Words of runs, read from where they are defined."""

from __future__ import annotations

import inspect
import re

from carom.events import COLUMNS, Event

ATTRIBUTE = re.compile(r"^(?P<names>\w+(?:, \w+)*) : (?P<type>.+)\n(?P<meaning>(?: {4}.+\n?)+)", re.MULTILINE)


def event_columns() -> str:
    """Give the columns of events as a table, from the docstring of `Event`."""
    rows: dict[str, str] = {}
    for found in ATTRIBUTE.finditer(inspect.cleandoc(Event.__doc__ or "")):
        meaning = " ".join(found["meaning"].split()).replace("``", "`")
        rows |= {name: f"| `{name}` | {found['type']} | {meaning} |" for name in found["names"].split(", ")}
    return "\n".join(["| column | type | meaning |", "|---|---|---|", *(rows[name] for name in COLUMNS)])
