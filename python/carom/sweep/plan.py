"""What a sweep file says."""

from __future__ import annotations

import difflib
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, get_args

from carom import _engine
from carom.ensemble import Design, Grid, Normal, Uniform, Varied
from carom.errors import ScenarioError
from carom.files import read_text
from carom.library import format_of
from carom.scenario import Scenario, load

FORMAT = 1
ROWS_PER_PART = 1 << 18
DESIGNS = get_args(Design)

KEYS: dict[str, tuple[str, Any]] = {
    "format": ("a whole number", int),
    "title": ("a text", str),
    "description": ("a text", str),
    "scenario": ("the name of a ready-made scenario or the path of a file", str),
    "set": ("a table of values by their paths", dict),
    "vary": ("a table of what is varied, by paths", dict),
    "grid": ("true or false", bool),
    "outcomes": ("a list of names", list),
    "runs": ("a whole number", int),
    "seed": ("a whole number", int),
    "design": ("a word", str),
    "rows_per_part": ("a whole number", int),
    "equilibrate": ("a number", (int, float)),
    "sample_interval": ("a number", (int, float)),
}
"""The keys of a sweep file: what each has to be, in words and as a type."""

PLAIN = ("runs", "seed", "design", "equilibrate", "sample_interval", "rows_per_part", "vary", "grid")
"""The keys of a plan that a manifest has as they are."""

LEAST = {"runs": 1, "rows_per_part": 1, "seed": 0}
"""The least value of whole numbers."""

KINDS: dict[str, tuple[str, ...]] = {
    "values": (),
    "linspace": ("from", "to", "count"),
    "normal": ("mean", "standard_deviation"),
    "uniform": ("low", "high"),
}
"""The ways to say what stands at a path, and the keys of each; `values` is a list."""

BOUNDS = {"normal": {"low", "high"}}
"""Keys that may be there too."""


@dataclass(frozen=True)
class Plan:
    """A sweep as its file has it, checked as far as that goes without the engine."""

    scenario: Scenario
    varied: Varied | Grid
    outcomes: tuple[str, ...]
    runs: int | None = None
    seed: int = 0
    equilibrate: float = 0.0
    sample_interval: float | None = None
    design: str = "independent"
    rows_per_part: int = ROWS_PER_PART
    title: str | None = None
    vary: Mapping[str, Any] = field(default_factory=dict)
    grid: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Give all that decides what the rows are."""
        return {
            "scenario": json.loads(self.scenario.to_json()),
            "vary": dict(self.vary),
            "grid": self.grid,
            "outcomes": list(self.outcomes),
            "runs": self.runs,
            "seed": self.seed,
            "equilibrate": self.equilibrate,
            "sample_interval": self.sample_interval,
            "design": self.design,
            "rows_per_part": self.rows_per_part,
        }

    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Plan:
        """Give the plan whose `to_dict` this is; further keys do not count."""
        own = {key: facts[key] for key in PLAIN}
        return cls(
            scenario=Scenario.from_json(json.dumps(facts["scenario"])),
            varied=_varied(facts["vary"], is_grid=facts["grid"]),
            outcomes=tuple(facts["outcomes"]),
            **own,
        )


def read_plan(path: Path) -> Plan:
    """Read a sweep file.

    Raises
    ------
    ScenarioError
        With every problem found, each with its place.
    """
    form = format_of(path)
    text = read_text(path, ScenarioError, "a sweep file")
    keys = json.loads(_engine.toml_as_json(text)) if form == "toml" else _json(path, text)
    problems = list(_problems(keys))
    if problems:
        raise ScenarioError(problems)
    vary = dict(_flat(keys["vary"]))
    grid = keys.get("grid", False)
    return Plan(
        scenario=_scenario(keys["scenario"], path).with_values(dict(keys.get("set", {}))),
        varied=_varied(vary, is_grid=grid),
        outcomes=tuple(keys.get("outcomes", ("final_position",))),
        runs=keys.get("runs"),
        seed=keys.get("seed", 0),
        equilibrate=keys.get("equilibrate", 0.0),
        sample_interval=keys.get("sample_interval"),
        design=keys.get("design", "independent"),
        rows_per_part=keys.get("rows_per_part", ROWS_PER_PART),
        title=keys.get("title"),
        vary=vary,
        grid=grid,
    )


def _varied(vary: Mapping[str, Any], *, is_grid: bool) -> Varied | Grid:
    numbers = {place: _numbers(said) for place, said in vary.items()}
    return Grid(numbers) if is_grid else numbers


def _json(path: Path, text: str) -> Any:
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise ScenarioError([(f"{path}: line {error.lineno}, column {error.colno}", error.msg)]) from None


def _scenario(said: str, path: Path) -> Scenario:
    """Load the scenario; the path of a file is relative to the sweep's."""
    is_path = "/" in said or "\\" in said or bool(Path(said).suffix)
    return load(path.parent / said) if is_path else load(said)


def _problems(keys: Any) -> Iterator[tuple[str, str]]:
    if not isinstance(keys, dict) or not keys:
        yield "", "an empty sweep: it needs at least scenario and vary"
        return
    for key in ("scenario", "vary"):
        if key not in keys:
            yield key, "missing"
    for key, value in keys.items():
        yield from ((key, problem) for problem in _key_problems(key, value))
    if isinstance(keys.get("vary"), dict):
        yield from _vary_problems(keys["vary"], is_grid=keys.get("grid") is True)


def _key_problems(key: str, value: Any) -> Iterator[str]:
    if key not in KEYS:
        yield f"unknown key{_nearest(key, KEYS)}; known: {', '.join(KEYS)}"
        return
    words, wanted = KEYS[key]
    if not isinstance(value, wanted) or (isinstance(value, bool) and wanted is not bool):
        yield f"must be {words}, got {json.dumps(value)}"
    elif key == "format" and value > FORMAT:
        yield f"format {value} is newer than format {FORMAT}, the newest known here"
    elif key in LEAST and value < LEAST[key]:
        yield f"must be {LEAST[key]} at least, got {value}"
    elif key == "design" and value not in DESIGNS:
        yield f"unknown {value!r}; known: {', '.join(DESIGNS)}"


def _vary_problems(vary: dict[str, Any], *, is_grid: bool) -> Iterator[tuple[str, str]]:
    if not vary:
        yield "vary", "names nothing"
    for path, said in _flat(vary):
        place = f"vary.{path}"
        if not isinstance(said, dict) or len(said) != 1 or next(iter(said)) not in KINDS:
            yield place, f"must have one of {', '.join(KINDS)}, got {json.dumps(said)}"
            continue
        kind, parts = next(iter(said.items()))
        place = f"{place}.{kind}"
        if kind == "values":
            if not isinstance(parts, list) or not parts or not all(map(_is_number, parts)):
                yield place, "must be a list of numbers"
        elif not isinstance(parts, dict) or set(parts) - BOUNDS.get(kind, set()) != set(KINDS[kind]):
            bounds = ", and may have low and high" if kind in BOUNDS else ""
            yield place, f"must have {' and '.join(KINDS[kind])}{bounds}, got {json.dumps(parts)}"
        else:
            yield from ((f"{place}.{key}", "must be a number") for key, part in parts.items() if not _is_number(part))
            if kind == "linspace" and not (isinstance(parts["count"], int) and parts["count"] >= 2):
                yield f"{place}.count", f"must be a whole number from 2 on, got {json.dumps(parts['count'])}"
        if is_grid and kind in ("normal", "uniform"):
            yield place, "is drawn, and a grid has given numbers: give values or linspace, or grid = false"


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _flat(vary: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, Any]]:
    """Give what is varied by whole paths, whether they are written as one key or as keys in each other."""
    for key, said in vary.items():
        path = f"{above}.{key}" if above else key
        if isinstance(said, dict) and said and not set(said) & set(KINDS):
            yield from _flat(said, path)
        else:
            yield path, said


def _numbers(said: Mapping[str, Any]) -> Any:
    """Give what stands at a path as an ensemble takes it."""
    match said:
        case {"values": values}:
            return values
        case {"normal": parts}:
            return Normal(**parts)
        case {"uniform": {"low": low, "high": high}}:
            return Uniform(low, high)
        case {"linspace": {"from": first, "to": last, "count": count}}:
            return [first + (last - first) * k / (count - 1) for k in range(count - 1)] + [float(last)]
    raise AssertionError(said)


def _nearest(word: str, known: Sequence[str] | Mapping[str, Any]) -> str:
    near = difflib.get_close_matches(word, list(known), n=1)
    return f"; did you mean {near[0]}?" if near else ""
