"""The report of a run: one HTML file with all there is to know about it."""

from __future__ import annotations

import os
import platform
from collections.abc import Mapping, Sequence
from functools import cache
from importlib import metadata
from typing import TYPE_CHECKING

from carom import _engine
from carom.cite import citation
from carom.files import write_text
from carom.report import words
from carom.report.parameters import ball_table, law_rows, limit_rows, method_rows, shot_rows, table_rows
from carom.report.pictures import drawn, figures_of, pictures_of
from carom.report.results import diagnostic_rows, event_table, facts, outcome_rows, step_rows, verdict
from carom.report.rows import Row

if TYPE_CHECKING:
    import jinja2

    from carom.run import Run
    from carom.scenario import Scenario

LONGEST_TEXT = 1_000_000


def report_html(
    run: Run, *, pictures: Mapping[str, bytes] | None = None, command: str = "", files: Sequence[str] = ()
) -> str:
    """Give the report of a run as HTML text.

    Parameters
    ----------
    run : Run
        The run.
    pictures : mapping of str to bytes, optional
        Its figures as PNG, by name, where they are there already; an empty one for a report without. If not given,
        they are drawn.
    command : str, optional
        The command that made the run.
    files : sequence of str, optional
        The names of the files that lie beside the report.
    """
    if pictures is None:
        pictures = {name: drawn(figure) for name, figure in figures_of(run)}
    scenario = run.scenario
    text = scenario.to_toml()
    return template("report.html").render(
        title=scenario.title or "A run",
        description=scenario.description,
        run=run,
        early=run.status in words.EARLY,
        verdict=verdict(run),
        facts=facts(run),
        pictures=pictures_of(run, pictures),
        parameters=_parameters(scenario),
        references=run.references,
        balls=ball_table(scenario),
        scenario_text=text if len(text) <= LONGEST_TEXT else "",
        events=event_table(run),
        outcome=outcome_rows(run),
        steps=step_rows(run),
        diagnostics=diagnostic_rows(run),
        versions=_versions(run),
        command=command,
        files=files,
        citation=citation().splitlines()[0],
    )


def _parameters(scenario: Scenario) -> dict[str, list[Row]]:
    groups = {
        "Table": table_rows(scenario),
        "Laws": law_rows(scenario),
        "Shot": shot_rows(scenario),
        "Method": method_rows(scenario),
        "Limits": limit_rows(scenario),
    }
    return {name: rows for name, rows in groups.items() if rows}


def write_report(
    run: Run,
    path: str | os.PathLike[str],
    *,
    pictures: Mapping[str, bytes] | None = None,
    command: str = "",
    files: Sequence[str] = (),
) -> None:
    """Write the report of a run to `path`; the rest is as for `report_html`."""
    write_text(path, report_html(run, pictures=pictures, command=command, files=files))


@cache
def _environment() -> jinja2.Environment:
    import jinja2

    return jinja2.Environment(
        loader=jinja2.PackageLoader("carom.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def template(name: str) -> jinja2.Template:
    """Give a template; whatever it is given is shown as text."""
    return _environment().get_template(name)


def _versions(run: Run) -> list[Row]:
    """Give the versions of what computed and drew; none of them holds a date or a place."""
    other = "" if run.physics_version == _engine.PHYSICS_VERSION else f"this Carom has {_engine.PHYSICS_VERSION}"
    return [
        Row("carom", _engine.__version__),
        Row("physics_version", str(run.physics_version), other),
        Row("Python", platform.python_version()),
        Row("numpy", metadata.version("numpy")),
        Row("matplotlib", metadata.version("matplotlib")),
        Row("platform", f"{platform.system()} {platform.machine()}"),
    ]
