"""``carom check`` and ``carom verify``: is this scenario sound, is this run what its scenario gives."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from carom.cli import options
from carom.cli.output import PROBLEM, print_json, reporting, say_error


@reporting()
def check(scenario: options.ScenarioName, as_json: options.Json = False) -> None:
    """Check a scenario and report every problem with its place."""
    from carom.scenario import Scenario

    problems = Scenario.check(scenario)
    if as_json:
        rows = [{"place": place, "message": message} for place, message in problems]
        print_json({"scenario": scenario, "sound": not problems, "problems": rows})
    else:
        for place, message in problems:
            say_error(place, message)
    if problems:
        raise typer.Exit(PROBLEM)
    if not as_json:
        print(f"{scenario}: no problems")


@reporting()
def verify(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="A run.json.", show_default=False)],
    as_json: options.Json = False,
) -> None:
    """Compute a saved run again and compare it bit for bit."""
    import carom

    found = carom.load_run(run).verify()
    version = found.physics_version
    if as_json:
        print_json({"run": str(run), "same": found.same, "physics_version": version, "difference": found.difference})
    elif found.same:
        made = "" if version == carom.PHYSICS_VERSION else f", made with {version}"
        print(f"{run}: same bits (physics version {carom.PHYSICS_VERSION}{made})")
    elif found.difference and found.difference["place"] == "physics_version":
        now = found.difference["now"]
        say_error(str(run), f"made with physics version {version}, and this is version {now}: not the same bits")
    else:
        details = ", ".join(f"{name} {value}" for name, value in (found.difference or {}).items())
        say_error(str(run), f"differs (physics version {version}): {details}")
    if not found.same:
        raise typer.Exit(PROBLEM)
