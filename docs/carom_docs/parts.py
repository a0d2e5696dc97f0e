"""The parts of pages that are generated: a comment in a page such as ``<!-- part: commands -->`` stands for one."""

from __future__ import annotations

import re
from collections.abc import Callable

from carom_docs import commands, schema, words

PARTS: dict[str, Callable[[], str]] = {
    "commands": commands.markdown,
    "scenario": schema.markdown,
    "event columns": words.event_columns,
}


def with_parts(text: str) -> str:
    """Give a page with its generated parts in their places; an unknown part is a KeyError."""
    return re.sub(r"^<!-- part: (.+) -->$", lambda found: PARTS[found[1]](), text, flags=re.MULTILINE)
