"""``carom bench``: how fast this machine computes."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom.cli import options
from carom.cli.output import print_json, print_table, reporting

if TYPE_CHECKING:
    from carom.scenario import Scenario

SHORTEST = 0.05


@reporting()
def bench(
    names: Annotated[
        list[str] | None,
        typer.Argument(metavar="SCENARIO", help="Scenarios; all ready-made ones if not given.", show_default=False),
    ] = None,
    repeats: Annotated[int, typer.Option(min=1, help="How many times to time each; the median counts.")] = 7,
    as_json: options.Json = False,
) -> None:
    """Time some scenarios, the computation alone."""
    import carom

    rows = [_time(name, carom.load(name), repeats) for name in names or carom.scenarios()]
    if as_json:
        print_json(rows)
    else:
        print_table({key: [row[key] for row in rows] for key in rows[0]})


def _time(name: str, scenario: Scenario, repeats: int) -> dict[str, Any]:
    """Time one scenario; a short one is run several times in a row for each timing."""
    import statistics

    started = time.perf_counter()
    events = sum(scenario.run().diagnostics["events"].values())
    once = time.perf_counter() - started
    loops = max(1, round(SHORTEST / max(once, 1e-9)))
    timings = []
    for _ in range(repeats):
        started = time.perf_counter()
        for _ in range(loops):
            scenario.run()
        timings.append((time.perf_counter() - started) / loops)
    median = statistics.median(timings)
    return {"scenario": name, "events": events, "median_s": median, "events_per_s": events / median}
