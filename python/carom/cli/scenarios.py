"""``carom scenarios`` and ``carom schema``: what is there, and how to write one's own."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from carom.cli import options
from carom.cli.output import print_json, print_table, reporting
from carom.errors import ScenarioError


@reporting()
def scenarios(
    copy: Annotated[
        tuple[str, Path] | None,
        typer.Option("--copy", metavar="NAME FILE", help="Write a ready-made scenario to a file.", show_default=False),
    ] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace FILE if it is there.")] = False,
    as_json: options.Json = False,
) -> None:
    """List the ready-made scenarios, or copy one to start from."""
    if copy is not None:
        _copy(*copy, overwrite=overwrite)
        return
    import carom

    found = [(name, carom.load(name)) for name in carom.scenarios()]
    rows: dict[str, list[Any]] = {
        "name": [name for name, _ in found],
        "balls": [len(scenario.ball_ids) for _, scenario in found],
        "title": [scenario.title for _, scenario in found],
    }
    if as_json:
        print_json([dict(zip(rows, row, strict=True)) for row in zip(*rows.values(), strict=True)])
    else:
        print_table(rows)


def _copy(name: str, path: Path, *, overwrite: bool) -> None:
    """Write a ready-made scenario: its own text with its comments as TOML, the canonical form as JSON."""
    import carom
    from carom.files import write_text
    from carom.library import format_of, scenarios, text_of

    if name not in scenarios():
        carom.load(name)
        raise ScenarioError([("--copy", f"{name} is not a ready-made scenario")])
    if path.exists() and not overwrite:
        raise ScenarioError([("--copy", f"{path} is there already; --overwrite replaces it")])
    if format_of(path) == "toml":
        write_text(path, text_of(name)[0])
    else:
        carom.load(name).save(path)


@reporting()
def schema() -> None:
    """Print the JSON Schema of scenario files."""
    import carom

    print(carom.schema())
