"""``carom compare``: time steps, two runs, or one's own trajectory."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from carom.cli import options
from carom.cli.compare_runs import compare_runs
from carom.cli.compare_steps import compare_steps
from carom.cli.compare_trajectory import Asked, TrajectoryFile, compare_trajectory
from carom.cli.comparing import Destination, check_place
from carom.cli.output import TROUBLE, reporting
from carom.cli.run import MethodName

SettingsOfA = Annotated[
    list[str] | None, typer.Option("--set-a", metavar="PATH=VALUE", help="As --set, in A only. Repeatable.")
]
SettingsOfB = Annotated[
    list[str] | None,
    typer.Option("--set-b", metavar="PATH=VALUE", help="As --set, in B only; without B, in a second A. Repeatable."),
]


@reporting(TROUBLE)
def compare(
    a: Annotated[str, typer.Argument(metavar="A", help=options.SCENARIO_OR_RUN, show_default=False)],
    b: Annotated[str | None, typer.Argument(metavar="B", help="The same, to compare A with.")] = None,
    trajectory: Annotated[
        Path | None, typer.Option("--with", metavar="FILE", help="Compare A with the trajectory in this CSV file.")
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            metavar="NAMES",
            help="Its columns: t,xr,yr,xb,yb (time, then x and y of each ball in order), or time=t,red.x=xr,red.y=yr."
            "  [default: time,red.x,red.y,...]",
        ),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(metavar="D", help="Exit with 1 beyond this distance.  [default: with FILE 1e-6]"),
    ] = None,
    delimiter: Annotated[
        str | None, typer.Option(metavar="C", help="Between FILE's columns: one character, tab or space.  [default: ,]")
    ] = None,
    decimal: Annotated[
        str | None, typer.Option(metavar="C", help="What stands before FILE's decimals: . or ,  [default: .]")
    ] = None,
    dt: Annotated[
        list[str] | None,
        typer.Option(metavar="LIST", help="Time steps, comma separated.  [default: 0.1 down to 0.00001]"),
    ] = None,
    method: Annotated[MethodName | None, typer.Option(help="How to compute A for FILE.", show_default=False)] = None,
    duration: options.Duration = None,
    settings: options.Settings = None,
    settings_a: SettingsOfA = None,
    settings_b: SettingsOfB = None,
    out: options.Out = None,
    overwrite: options.Overwrite = False,
    formats: options.Formats = None,
    as_json: options.Json = False,
) -> None:
    """Compare two runs, a trajectory of your own with a run, or the stepped method with the exact run.

    With A and B (or --set-a, --set-b): the first event that differs, and how far the balls come apart.

    With --with FILE: whether the trajectory in a CSV file agrees with A, and if not, what is wrong in which line.

    With A alone: the stepped method beside the exact run, for each of some time steps: how many events it misses and
    adds; the time that balls lost waiting at contacts; the deepest overlap of two balls, within steps too; how far from
    its exact place the worst ball ends.

    With --out also write the tables as CSV, comparison.csv first, and figures.

    The exit code is 0, or 1 where FILE does not agree or the runs are farther apart than --tolerance; it is 2 where
    nothing could be compared.
    """
    two = b is not None or bool(settings_a) or bool(settings_b)
    given: dict[str, Any] = {"--dt": dt, "--method": method, "--columns": columns, "--delimiter": delimiter}
    given |= {"--decimal": decimal}
    given |= {"B": b, "--set-a": settings_a, "--set-b": settings_b, "--tolerance": tolerance}
    if tolerance is not None and not 0.0 <= tolerance < float("inf"):
        raise typer.BadParameter("must be zero or positive and finite", param_hint="--tolerance")
    place = Destination(out, options.read_formats(formats), overwrite, as_json)
    if trajectory is not None:
        _refuse(given, ("B", "--set-a", "--set-b"), "--with compares FILE with A alone")
        check_place(place)
        file = TrajectoryFile(trajectory, columns, delimiter, decimal, tolerance)
        compare_trajectory(Asked(a, method, dt, duration, settings), file, place)
    elif two:
        _refuse(
            given, ("--dt", "--method", "--columns", "--delimiter", "--decimal"), "two runs are compared as they are"
        )
        check_place(place)
        compare_runs((a, b or a), duration, (settings or [], settings_a or [], settings_b or []), tolerance, place)
    else:
        _refuse(given, ("--method", "--columns", "--delimiter", "--decimal"), "it belongs to --with FILE")
        _refuse(given, ("--tolerance",), "it belongs to B or --with FILE")
        compare_steps(a, dt, duration, settings, place)


def _refuse(given: Mapping[str, Any], names: tuple[str, ...], why: str) -> None:
    for name in names:
        if given[name] is not None:
            raise typer.BadParameter(f"cannot be given here: {why}", param_hint=name)
