"""Scenarios and runs in a few lines of text, at most one screen of 80 columns and 24 lines."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from textwrap import fill
from typing import TYPE_CHECKING, Any

from carom.units import unit_of

if TYPE_CHECKING:
    from carom.run import Run
    from carom.scenario import Scenario

WIDTH = 80
NAMES_WIDTH = 60
MOST_CUSHIONS = 6
DIGEST_SHOWN = len("sha256:") + 16
MORE = "..."
TAGS = ("shape", "preset", "law", "kind", "game")
"""The keys that say of which kind a setting is; their words go without them."""

Fact = tuple[str, str]


def summary_of_scenario(scenario: Scenario) -> str:
    """Give a scenario in a few lines."""
    return block(f"Scenario {scenario.title!r}" if scenario.title else "Scenario", facts_of_scenario(scenario))


def summary_of_run(run: Run) -> str:
    """Give a run in a few lines."""
    values, units = run.scenario.to_dict(), run.scenario.units
    diagnostics, digest = run.diagnostics, run.digest
    counts = [f"{count} {kind}" for kind, count in diagnostics["events"].items() if count]
    total = sum(diagnostics["events"].values())
    energies = [f"{diagnostics[name]:.6g}" for name in ("initial_energy", "final_energy")]
    facts = [
        ("status", run.status),
        ("end time", _with_unit(run.end_time, units, "time")),
        ("balls", str(len(run.ball_ids))),
        ("events", f"{total} ({', '.join(counts)})" if counts else "0"),
        ("energy", f"{energies[0]} to {_with_unit(float(energies[1]), units, 'energy')}"),
        ("energy error", _with_unit(float(f"{diagnostics['energy_error']:.2g}"), units, "energy")),
        ("method", _setting(values.get("method", {"kind": "exact"}))),
    ]
    facts += [("lost time", _with_unit(diagnostics["lost_time"], units, "time"))] if diagnostics["lost_time"] else []
    facts += [("record", run.record)] if "record" in values or run.record != "all" else []
    facts += [("digest", digest[:DIGEST_SHOWN] + MORE)] if digest else []
    return block(f"Run of {values['title']!r}" if "title" in values else "Run", facts)


def facts_of_scenario(scenario: Scenario) -> list[Fact]:
    """Give what a scenario says, each by its name."""
    values, units = scenario.to_dict(), scenario.units
    facts: list[Fact] = [(name, _table(values[name])) for name in ("table", "gas") if name in values]
    facts.append(("balls", _named(scenario.ball_ids)))
    facts += [(name, _setting(values[name])) for name in ("rack", "shot", "cue") if name in values]
    for name, law in values.get("physics", {}).items():
        facts += _cushions(law) if name == "cushions" else [(f"physics.{name}", _setting(law))]
    facts.append(("method", _setting(values.get("method", {"kind": "exact"}))))
    facts += [("duration", _with_unit(values["duration"], units, "time"))] if "duration" in values else []
    facts += [(name, str(values[name])) for name in ("collisions", "max_events", "record") if name in values]
    return facts + ([("units", _setting(units))] if units else [])


def block(head: str, lines: Iterable[Fact]) -> str:
    """Give a heading and named lines below it, each cut where the screen ends."""
    return "\n".join(_cut(line) for line in [head, *(f"  {name}: {text}" for name, text in lines)])


def paragraphs(head: str, lines: Iterable[Fact]) -> str:
    """Give a heading and named sentences below it, each in full and wrapped where the screen ends."""
    texts = [_one_line(f"  {name}: {text}") for name, text in lines]
    wrapped = [fill(text, WIDTH, subsequent_indent=" " * 4, break_on_hyphens=False) for text in texts]
    return "\n".join([_cut(head), *wrapped])


def _cut(text: str) -> str:
    """Give a text as one line of the screen, cut where the screen ends."""
    line = _one_line(text)
    return line if len(line) <= WIDTH else line[: WIDTH - len(MORE)] + MORE


def _one_line(text: str) -> str:
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)


def _table(table: Mapping[str, Any]) -> str:
    return _setting({name: len(value) if isinstance(value, list) else value for name, value in table.items()})


def _named(names: Sequence[str]) -> str:
    """Give how many there are, and the names of as many as fit in the line, all of them or none cut."""
    shown = 0
    while shown < len(names) and len(", ".join(names[: shown + 1])) <= NAMES_WIDTH:
        shown += 1
    listed = [*names[: max(shown, 1)], *([MORE] if max(shown, 1) < len(names) else [])]
    return f"{len(names)} ({', '.join(listed)})"


def _cushions(laws: Mapping[str, Any]) -> list[Fact]:
    """Give the laws of single cushions, at most so many of them."""
    facts = [(f"physics.cushions.{name}", _setting(law)) for name, law in laws.items()]
    left = len(facts) - MOST_CUSHIONS
    return facts if left <= 0 else [*facts[:MOST_CUSHIONS], ("physics.cushions", f"and {left} more")]


def _with_unit(number: float, units: Mapping[str, str], quantity: str) -> str:
    return f"{number:.6g} {unit_of(units, quantity)}".rstrip()


def _setting(setting: Any) -> str:
    if not isinstance(setting, Mapping):
        return str(setting)
    kind = [str(setting[tag]) for tag in TAGS if tag in setting]
    rest = [f"{name} {_setting(value)}" for name, value in setting.items() if name not in TAGS]
    return ", ".join(kind + rest)
