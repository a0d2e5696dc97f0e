"""Scenarios and runs in a few lines of text."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

MOST_NAMED = 8


def summary_of_scenario(values: Mapping[str, Any]) -> str:
    """Give a scenario, as a dict, in a few lines."""
    lines = [("table", _table(values["table"])), ("balls", _named([ball["id"] for ball in values["balls"]]))]
    lines += [(f"physics.{name}", _setting(law)) for name, law in values.get("physics", {}).items()]
    lines += [("method", _setting(values.get("method", {"kind": "exact"})))]
    lines += [(name, str(values[name])) for name in ("duration", "collisions", "record") if name in values]
    return block(f"Scenario {values['title']!r}" if "title" in values else "Scenario", lines)


def block(head: str, lines: Iterable[tuple[str, str]]) -> str:
    """Give a heading and named lines below it."""
    return "\n".join([head, *(f"  {name}: {text}" for name, text in lines)])


def _table(table: Mapping[str, Any]) -> str:
    return _setting({name: len(value) if name in ("pieces", "obstacles") else value for name, value in table.items()})


def _named(names: Sequence[str]) -> str:
    shown = ", ".join(names[:MOST_NAMED]) + (", ..." if len(names) > MOST_NAMED else "")
    return f"{len(names)} ({shown})"


def _setting(setting: Any) -> str:
    if not isinstance(setting, Mapping):
        return str(setting)
    kind = [str(setting[tag]) for tag in ("shape", "law", "kind") if tag in setting]
    rest = [f"{name} {_setting(value)}" for name, value in setting.items() if name not in ("shape", "law", "kind")]
    return ", ".join(kind + rest)
