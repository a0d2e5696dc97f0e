"""The commands put together."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from carom.cli import ending_with_the_pipe
from carom.cli.bench import bench
from carom.cli.check import check, verify
from carom.cli.compare import compare
from carom.cli.gas import gas
from carom.cli.map import map_
from carom.cli.resume import resume
from carom.cli.run import run
from carom.cli.scenarios import scenarios, schema
from carom.cli.studio import studio
from carom.cli.sweep import sweep


class Commands(TyperGroup):
    """The commands; a closed pipe ends them before typer sees it, which would make it exit code 1."""

    def make_context(self, *args: Any, **more: Any) -> Any:
        """Read the command line, and print help where it asks for it."""
        with ending_with_the_pipe():
            return super().make_context(*args, **more)

    def invoke(self, *args: Any, **more: Any) -> Any:
        """Run the command."""
        with ending_with_the_pipe():
            return super().invoke(*args, **more)


app = typer.Typer(
    cls=Commands,
    help="How balls move on a table: exact, fast, and the same everywhere.",
    epilog="Start with: carom run midterm",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        import carom

        typer.echo(f"carom {carom.__version__}")
        raise typer.Exit


def _print_citation(wanted: bool) -> None:
    if wanted:
        import carom

        typer.echo(carom.citation())
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version.")
    ] = False,
    cite: Annotated[
        bool, typer.Option("--cite", callback=_print_citation, is_eager=True, help="Print how to cite Carom.")
    ] = False,
) -> None:
    pass


EXAMPLES: dict[Callable[..., None], list[str]] = {
    run: [
        "carom run midterm",
        "carom run midterm --method stepped --dt 0.03 --out out/stepped",
        "carom run my.toml --set balls.red.velocity[0]=3.1 --duration 10 --format pdf --out out/mine",
    ],
    compare: [
        "carom compare midterm",
        "carom compare midterm --dt 0.03,0.01,0.003 --duration 1 --out out/compare",
        "carom compare midterm midterm_stepped --out out/both",
        "carom compare midterm --set-b balls.red.velocity[0]=3.1",
        "carom compare midterm_stepped --with mine.csv --columns t,xr,yr,xb,yb",
    ],
    gas: [
        "carom gas --n 1000 --packing-fraction 0.5 --collisions 1e5 --observe pressure,speeds",
        "carom gas fifty_random --equilibrate 20 --observe pressure,speeds",
        "carom gas fifty_random --snapshots gsd --snapshot-interval 0.5 --events 1 2 --out out/gas",
    ],
    resume: ["carom resume out/gas", "carom resume out/gas --duration 20"],
    sweep: [
        "carom sweep my_sweep.toml --out out/sweep",
        "carom sweep my_sweep.toml --out out/on_dask --engine dask --workers 2",
    ],
    map_: [
        "carom map midterm --x balls.red.direction_deg=0:90:300 --y balls.red.speed=0:3:300 --show blue.x",
        "carom map nine_ball_break --x shot.phi_deg=95:98:30 --y shot.V0=6:9:20 --show 1.pocket --out out/map",
    ],
    check: ["carom check my.toml"],
    verify: ["carom verify out/mine/run.json"],
    scenarios: ["carom scenarios", "carom scenarios --copy stadium stadium.toml"],
    schema: ["carom schema > carom.schema.json"],
    studio: ["carom studio", "carom studio midterm", "carom studio my.toml --port 8000 --no-browser"],
    bench: ["carom bench midterm stadium", "carom bench midterm --repeats 21"],
}

for command, examples in EXAMPLES.items():
    # The mark \b keeps the line ends of a paragraph.
    app.command(
        command.__name__.rstrip("_"),
        epilog="\n".join(["\b", "For example:", *(f"  {example}" for example in examples)]),
    )(command)
