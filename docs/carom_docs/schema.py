"""The scenario reference, from the JSON Schema that the engine gives."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import carom

DOCS = Path(__file__).parents[1]
FRAGMENTS = DOCS / "reference" / "fragments"
GREATEST = 2**63 - 1
WORDS = {"number": "number", "integer": "whole number", "string": "text", "boolean": "true or false"}

Values = Mapping[str, Any]


def load() -> dict[str, Any]:
    """Give the JSON Schema of scenarios."""
    values: dict[str, Any] = json.loads(carom.schema())
    return values


def sections() -> dict[str, list[str]]:
    """Give the name of each section of the reference, with the keys that its example has to show."""
    # A gas, or a file, stands in place of the table and the balls that the example of the whole has.
    instead = {"gas", "balls_from", "balls_source"}
    found = {"scenario": [key for key in _asked(load()) if key not in instead]}
    for name, definition in _definitions().items():
        if words_of(definition) or "properties" not in {*definition, *_first(variants_of(definition))}:
            found[kebab(name)] = []
        elif "properties" in definition:
            found[kebab(name)] = _asked(definition)
        else:
            found |= {section_of(name, one): _asked(one) for one in variants_of(definition)}
    return found


def _asked(definition: Values) -> list[str]:
    """Give the keys that an example has to show: of two names of one thing the first."""
    asked: list[str] = []
    for key, value in definition["properties"].items():
        other = re.search(r"; or `(\w+)`", value.get("description", ""))
        if other is None or other[1] not in asked:
            asked.append(key)
    return asked


def laws() -> set[str]:
    """Give the names of all laws, such as ``ball-cushion-damping``."""
    return {f"{kebab(name)}-{word}" for name in _named(load()["$defs"]["Physics"]) for word in _choices(name)}


def shapes() -> set[str]:
    """Give the names of all shapes of tables and of obstacles, such as ``circle`` and ``obstacle-circle``."""
    return set(_choices("Table")) | {f"obstacle-{word}" for word in _choices("Obstacle")}


def markdown() -> str:
    """Give a section for each part of a scenario: its keys, and an example."""
    schema = load()
    parts = [_object("The file", "scenario", "", schema, level=2)]
    for name, definition in _definitions().items():
        parts.append("\n".join(_definition(name, definition)))
    return "\n\n".join(parts)


def kebab(name: str) -> str:
    """Turn ``BallBall`` into ``ball-ball``.

    >>> kebab("BallBall")
    'ball-ball'
    """
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower()


def variants_of(definition: Values) -> list[Any]:
    """Give the ways a value of several forms can be written, definitions in full; none for a plain one."""
    written = definition.get("oneOf") or definition.get("anyOf") or []
    return [load()["$defs"][_reference(one)] | one if "$ref" in one else one for one in written]


def words_of(definition: Values) -> list[str]:
    """Give the words of a value that is one of a few."""
    return [one["const"] for one in variants_of(definition) if "const" in one]


def tag_of(variant: Values) -> tuple[str, str]:
    """Give the key that tells a variant, and its word: ``shape``, ``rectangle``; without a word the key again."""
    for key, value in variant["properties"].items():
        if "const" in value:
            return key, value["const"]
    key = variant["required"][0]
    return key, key


def section_of(name: str, variant: Values) -> str:
    """Name the section of a variant, such as ``table-rectangle``."""
    return f"{kebab(name)}-{tag_of(variant)[1]}"


def _definitions() -> dict[str, Any]:
    """Give the definitions by their names, without those that are one form of another and shown there."""
    every: dict[str, Any] = load()["$defs"]
    forms = [one for definition in every.values() for one in definition.get("anyOf", [])]
    shown = {_reference(form) for form in forms if "$ref" in form}
    return {name: definition for name, definition in every.items() if name not in shown}


def _choices(name: str) -> list[str]:
    definition = load()["$defs"][name]
    return words_of(definition) or [tag_of(one)[1] for one in variants_of(definition)]


def _first(items: list[Any]) -> Any:
    return items[0] if items else {}


def _named(definition: Values) -> list[str]:
    """Give the definitions that the keys of an object refer to."""
    return [_reference(value) for value in definition["properties"].values() if "$ref" in value]


def _reference(value: Values) -> str:
    return str(value["$ref"]).rpartition("/")[2]


def _definition(name: str, definition: Values) -> Iterator[str]:
    title = " and ".join(f"`{place}`" for place in _places(name))
    title += " of a preset" if name.endswith("Change") else ""
    if "properties" in definition:
        yield _object(title, kebab(name), definition["description"], definition, level=2)
        return
    yield from (f"(scenario-{kebab(name)})=", f"## {title}", "", _line(definition["description"]), "")
    if words_of(definition):
        yield from ("| word | meaning |", "|---|---|")
        for one in variants_of(definition):
            word = _linked(f"`{json.dumps(one['const'])}`", f"{kebab(name)}-{one['const']}")
            yield f"| {word} | {_line(one['description'])} |"
        yield from ("", _example(kebab(name)))
    elif all("properties" in one for one in variants_of(definition)):
        for one in variants_of(definition):
            key, word = tag_of(one)
            heading = f"`{key} = {json.dumps(word)}`" if key != word else f"`{key}`"
            yield _object(heading, section_of(name, one), one["description"], one, level=3)
            yield ""
    else:
        yield from (f"- {_type(one)}: {_line(one['description'])}" for one in variants_of(definition))
        yield from ("", _example(kebab(name)))


def _object(title: str, section: str, description: str, definition: Values, *, level: int) -> str:
    required = definition.get("required", [])
    rows = [_row(key, value, key in required) for key, value in definition["properties"].items()]
    more = _linked("More about it, with a picture.", section)
    return "\n".join(
        [
            f"(scenario-{section})=",
            f"{'#' * level} {title}",
            "",
            _line(description) + (f" {more}" if "](" in more else ""),
            "",
            "| key | type | default | meaning |",
            "|---|---|---|---|",
            *rows,
            "",
            _example(section),
        ]
    )


def _row(key: str, value: Values, required: bool) -> str:
    meaning = _line(value.get("description", "Says which one it is."))
    absent = re.search(r"[;.] [Aa]bsent: ([^.]+)\.", meaning)
    if absent:
        meaning = meaning.replace(absent[0], ".")
    default = (
        "required" if required else absent[1] if absent else f"`{value['default']:g}`" if "default" in value else ""
    )
    return f"| `{key}` | {_type(value)} | {default} | {meaning} |"


def _type(value: Values) -> str:
    """Say of what type a value is and in which bounds."""
    if "const" in value:
        return f"`{json.dumps(value['const'])}`"
    if "$ref" in value:
        name = _reference(value)
        return f"[{min(_places(name), key=len).rpartition('.')[2]}](#scenario-{kebab(name)})"
    if value["type"] == "array":
        return _list(value)
    if "properties" in value:
        return "keys " + ", ".join(f"`{key}`" for key in value["properties"])
    if value["type"] == "object":
        return f"by id: {_type(value['additionalProperties'])}"
    return ", ".join([WORDS[value["type"]], *_bounds(value)])


def _list(value: Values) -> str:
    least, most = value.get("minItems"), value.get("maxItems")
    inner = _type(value["items"])
    if least is not None and most is not None and least < most:
        return f"{least} or {most} × {inner}"
    if least is not None and least == most:
        return f"{least} × ({inner})" if value["items"].get("type") == "array" else f"{least} × {inner}"
    return f"list of {inner}" + (f", at least {least}" if least else "")


def _bounds(value: Values) -> list[str]:
    bounds = []
    if "exclusiveMinimum" in value:
        bounds.append(f"> {value['exclusiveMinimum']:g}")
    if "minimum" in value:
        bounds.append(f"≥ {value['minimum']:g}")
    if "maximum" in value:
        bounds.append("< 2⁶³" if value["maximum"] == GREATEST else f"≤ {value['maximum']:g}")
    if value.get("minLength"):
        bounds.append("not empty")
    return bounds


def _places(name: str) -> list[str]:
    """Give the paths at which a definition is used, such as ``table.obstacles``; the same path once."""
    found: list[str] = []
    for place, value in _uses(load(), ""):
        if value == name and place not in found:
            found.append(place)
    return found


def _uses(definition: Values, place: str) -> Iterator[tuple[str, str]]:
    """Give each use of a definition at or below a place, as (place, name of the definition)."""
    if "$ref" in definition:
        name = _reference(definition)
        yield place, name
        yield from _uses(load()["$defs"][name], place)
    for key, value in definition.get("properties", {}).items():
        yield from _uses(value, f"{place}.{key}" if place else key)
    if isinstance(definition.get("additionalProperties"), Mapping):
        yield from _uses(definition["additionalProperties"], f"{place}.<id>")
    for value in [definition.get("items"), *variants_of(definition)]:
        if value is not None:
            yield from _uses(value, place)


def _example(section: str) -> str:
    text = (FRAGMENTS / f"{section}.toml").read_text(encoding="utf-8")
    return f"```toml\n{text.rstrip()}\n```"


def _linked(text: str, section: str) -> str:
    """Link a text to the page of a law or a shape, where there is one."""
    for folder, page in (("laws", section), ("tables", section.removeprefix("table-"))):
        if (DOCS / folder / f"{page}.md").exists():
            return f"[{text}](../{folder}/{page}.md)"
    return text


def _line(text: str) -> str:
    return " ".join(text.replace("|", "\\|").split())
