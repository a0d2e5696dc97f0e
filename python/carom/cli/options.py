"""What several commands are given, and how it is read."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from carom.scenario import Scenario

SCENARIO = "A ready-made scenario's name (see: carom scenarios), or a .toml or .json file."
SCENARIO_OR_RUN = "A ready-made scenario's name (see: carom scenarios), a .toml or .json file, or a saved run.json."

ScenarioName = Annotated[str, typer.Argument(metavar="SCENARIO", help=SCENARIO, show_default=False)]
Duration = Annotated[float | None, typer.Option(metavar="T", min=0.0, help="End at this time.")]
MaxEvents = Annotated[int | None, typer.Option(metavar="N", min=1, help="End after N events of any kind.")]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help="Change a value, e.g. balls.red.velocity[0]=3.1. Repeatable."),
]


def _folder(text: str) -> Path:
    """Read a folder's name; an empty one, as an unset shell variable gives it, is none."""
    if not text:
        raise typer.BadParameter("needs the name of a folder; a dot is the working folder")
    return Path(text)


Out = Annotated[Path | None, typer.Option(parser=_folder, metavar="DIR", help="Write the results into this folder.")]
Overwrite = Annotated[bool, typer.Option("--overwrite", help="Replace results that DIR already holds.")]
Formats = Annotated[
    list[str] | None,
    typer.Option("--format", metavar="LIST", help="Figures as png, svg, pdf; comma separated.  [default: png]"),
]
Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]


def load_with(source: str, settings: list[str] | None) -> Scenario:
    """Load a scenario and change the values that ``--set`` names."""
    from carom.scenario import Scenario

    values = dict(map(read_setting, settings or []))
    before = {path: value for path, value in values.items() if path.startswith("balls_from.")}
    after = {path: value for path, value in values.items() if path not in before}
    scenario = Scenario._load(source, before)
    return scenario.with_values(after) if after else scenario


def is_saved_run(source: str) -> bool:
    """Tell a saved run from a scenario, by the content of its file."""
    path = Path(source)
    if path.suffix.lower() != ".json" or not path.is_file():
        return False
    try:
        values = json.loads(path.read_text(encoding="utf-8-sig"))
    except ValueError:
        return False
    return isinstance(values, dict) and {"physics_version", "digest"} <= set(values)


def read_setting(setting: str) -> tuple[str, Any]:
    """Read ``PATH=VALUE``; the value is JSON, a number as Python and TOML write it, or else a word.

    Examples
    --------
    >>> read_setting("duration=10"), read_setting("table.shape=circle"), read_setting("table.width=.9")
    (('duration', 10), ('table.shape', 'circle'), ('table.width', 0.9))
    """
    path, equals, value = setting.partition("=")
    if not equals or not path:
        raise typer.BadParameter(f"{setting!r} is not PATH=VALUE", param_hint="--set")
    try:
        return path, json.loads(value)
    except json.JSONDecodeError:
        return path, _number(value)


def _number(text: str) -> float | str:
    """Read ``.9``, ``1.``, ``+2`` and ``1_000``, which JSON does not know; anything else stays a word."""
    for read in (int, float):
        try:
            number = read(text)
        except ValueError:
            continue
        return number if text[-1].isdigit() or text.endswith(".") else text
    return text


def command_line(command: str, source: str, given: Mapping[str, Any]) -> str:
    """Give the line that asks for this again: a command, a scenario, and the options that are not None.

    Examples
    --------
    >>> command_line("run", "midterm", {"--set": ["duration=10", "title=A b"], "--dt": 0.03, "--duration": None})
    "carom run midterm --set duration=10 --set 'title=A b' --dt 0.03"
    """
    words = ["carom", command, source]
    for name, value in given.items():
        values = value if isinstance(value, list) else [] if value is None else [value]
        words += [word for each in values for word in (name, _word(each))]
    return shlex.join(words)


def _word(value: Any) -> str:
    if isinstance(value, float):
        return f"{value!r}".removesuffix(".0")
    return str(value.value if isinstance(value, Enum) else value)


def read_formats(formats: list[str] | None) -> list[str]:
    """Read lists such as ``png,pdf``; the option may be repeated."""
    known = ("png", "svg", "pdf")
    chosen = [word.strip().lower() for word in ",".join(formats or ["png"]).split(",")]
    for word in chosen:
        if word not in known:
            raise typer.BadParameter(f"{word!r} is none of {', '.join(known)}", param_hint="--format")
    return chosen
