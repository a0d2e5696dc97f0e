"""What the commands share that measure a gas: the bar, Ctrl-C, and the results."""

from __future__ import annotations

import shlex
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from carom.cli import INTERRUPTED
from carom.cli.folder import filling
from carom.cli.output import print_json, print_table, say_error
from carom.progress import new_bar

if TYPE_CHECKING:
    from types import FrameType

    from carom.observables import Observable, Observables
    from carom.run import Run

MARK = "run.json"
QUANTITIES = "observables.json"


def count(text: str) -> int:
    """Read a whole number, also as ``1e6``."""
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if number < 0.0 or number != int(number):
        raise typer.BadParameter(f"{text!r} is no whole number from 0 on, such as 1000000 or 1e6")
    return int(number)


@contextmanager
def interruptible() -> Iterator[Callable[[], bool]]:
    """Give a function that says whether Ctrl-C was pressed or the process asked to end; the next one does end it."""
    pressed = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield pressed.is_set
        return

    def press(_number: int, _frame: FrameType | None) -> None:
        pressed.set()
        put_back()

    def put_back() -> None:
        for number, handler in before.items():
            signal.signal(number, handler)

    before = {number: signal.signal(number, press) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield pressed.is_set
    finally:
        put_back()


@contextmanager
def waiting(words: str) -> Iterator[None]:
    """Say on a terminal what takes its time, until it is done."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console
    from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        progress.add_task(words, total=None)
        yield


@contextmanager
def bar(most: int | None, end: float | None, already: int = 0) -> Iterator[Callable[[float, int, int], None]]:
    """Show on a terminal how far the run has come, at what speed, and how long it will take.

    Parameters
    ----------
    most, end : int or None, float or None
        Collisions and time at which it ends.
    already : int
        Collisions that happened before this command.
    """
    if not sys.stderr.isatty():
        yield lambda *_: None
        return
    with new_bar() as progress:
        task = progress.add_task("to equilibrium", total=1.0, speed="")
        began = progress.get_time()

        def tell(time: float, done: int, samples: int) -> None:
            share = max(done / most if most else 0.0, time / end if end else 0.0)
            rate = (done - already) / max(progress.get_time() - began, 1e-9)
            words = f"{samples} sample{'s' * (samples > 1)}" if samples else "to equilibrium"
            progress.update(task, completed=share, description=words, speed=f"{rate:,.0f} events/s")

        yield tell


def result_names() -> list[str]:
    """Give the names of all files of results, which come when a run has ended."""
    from carom import _engine
    from carom.figures import FORMATS

    kinds = ["csv", *(kind.removeprefix(".") for kind in FORMATS)]
    return [MARK, QUANTITIES, *(f"{name}.{kind}" for name in _engine.OBSERVABLES for kind in kinds)]


def finish(run: Run, out: Path | None, more: list[str], kinds: list[str], *, as_json: bool) -> None:
    """Write and print what was measured; an interrupted run ends the command as such.

    Parameters
    ----------
    run : Run
        The run.
    out : Path or None
        The folder of its results.
    more : list of str
        The files in it that were written while the run went on.
    kinds : list of str
        The kinds of figures.
    as_json : bool
        Whether to print JSON.
    """
    files: list[str] = []
    if out is not None and run.observables:
        with filling(out, result_names(), MARK) as folder:
            files = _write(run, folder, kinds)
    facts = {"status": run.status, "end_time": run.end_time, "digest": run.digest, "collisions": _collisions(run)}
    facts |= {"out": None if out is None else str(out), "files": [*files, *more]}
    if as_json:
        print_json({**facts, "observables": run.observables.to_dict()})
    else:
        _print_tables(run.observables, facts)
    if run.status == "interrupted":
        early = "" if run.observables else ", before measuring began"
        advice = "" if out is None else f"; carom resume {shlex.quote(str(out))} goes on"
        say_error("", f"interrupted at t = {run.end_time:g}{early}{advice}")
        raise typer.Exit(INTERRUPTED)


def _write(run: Run, folder: Path, kinds: list[str]) -> list[str]:
    """Write the numbers, the curves, their figures and the run."""
    written = [path.name for path in run.observables.save(folder)]
    for name, observable in run.observables.items():
        written += _write_figure(name, observable, folder, kinds)
    run.save(folder / MARK)
    return [*written, MARK]


def _write_figure(name: str, observable: Observable, folder: Path, kinds: list[str]) -> list[str]:
    if not kinds or not observable.has_figure:
        return []
    from carom.figures import figure_of, save_figure

    figure = figure_of(observable.plot())
    return [save_figure(figure, folder / f"{name}.{kind}").name for kind in kinds]


def _collisions(run: Run) -> int:
    events = run.diagnostics["events"]
    return int(events.get("ball_ball", 0) + events.get("ball_cushion", 0))


def _print_tables(observables: Observables, facts: dict[str, Any]) -> None:
    rows = [(name, each) for name, found in observables.items() for each in found.quantities.values()]
    if rows:
        print_table(
            {
                "observable": [name for name, _ in rows],
                "quantity": [each.name for _, each in rows],
                "value": [each.value for _, each in rows],
                "error": [each.error for _, each in rows],
                "expected": [each.expected for _, each in rows],
                "unit": [each.unit for _, each in rows],
            },
            small=("error",),
        )
        print()
    shown = {**facts, "files": " ".join(facts["files"]) or None}
    shown = {name: value for name, value in shown.items() if value is not None}
    print_table({"run": list(shown), "value": list(shown.values())})
