"""``carom sweep``: run the ensemble of a file into a dataset."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated, Literal

import typer

from carom.cli import INTERRUPTED, options
from carom.cli.measuring import interruptible
from carom.cli.output import print_json, print_table, reporting, say_error
from carom.progress import counting

Engine = Literal["threads", "dask"]


@reporting()
def sweep(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The sweep: a .toml or .json file.", show_default=False)],
    out: Annotated[Path, typer.Option(metavar="DIR", help="The folder of the dataset.", show_default=False)],
    engine: Annotated[
        Engine, typer.Option(help="What computes: the threads of this command, or the workers of a Dask cluster.")
    ] = "threads",
    threads: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            min=1,
            help="On N threads, with dask for each worker.  [default: as many as there are cores; with dask 1]",
        ),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS",
            help="With dask: the cluster of this scheduler, such as tcp://10.0.0.1:8786. All of its workers have to "
            "see DIR, at the same path.  [default: worker processes of this machine, for this command]",
        ),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=1, help="With dask: start N worker processes.  [default: as many as there are cores]"
        ),
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Run many variations of a scenario into a Parquet dataset, as a file says.

    The dataset is written in parts, each whole or not at all, beside manifest.json. Ctrl-C, or a kill, loses no more
    than the parts under way: the same command goes on, and the dataset is the one that it would have been at once.
    Rows whose numbers make no scenario stay, rejected, with the problem.
    """
    from carom.sweep import Sweep

    _check_usage(engine, scheduler, workers)
    planned = Sweep.load(file)
    began = time.perf_counter()
    with interruptible() as interrupted, counting("runs", "runs") as told:
        result = planned.run(
            out,
            engine=engine,
            threads=threads,
            scheduler=scheduler,
            workers=workers,
            progress=lambda *now: told(*now) or interrupted(),
        )
    seconds = time.perf_counter() - began
    facts = {"rows": result.rows, "of": planned.rows, "seconds": round(seconds, 3), "out": str(out)}
    if as_json:
        print_json({**facts, "statuses": result.statuses})
    else:
        print_table({"status": list(result.statuses), "rows": list(result.statuses.values())})
        print()
        print_table({"sweep": list(facts), "value": list(facts.values())})
    if not result.is_complete:
        say_error("", f"ended after {result.rows} of {planned.rows} rows; the same command goes on")
        raise typer.Exit(INTERRUPTED)


def _check_usage(engine: str, scheduler: str | None, workers: int | None) -> None:
    for option, value in (("--scheduler", scheduler), ("--workers", workers)):
        if value is not None and engine != "dask":
            raise typer.BadParameter("is for --engine dask", param_hint=option)
    if scheduler is not None and workers is not None:
        raise typer.BadParameter("the scheduler at an address has its own workers", param_hint="--workers")
