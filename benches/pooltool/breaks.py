"""Breaks of nine-ball under execution noise: how many Carom and pooltool play in a second, and what comes of them.

The strokes are those that `carom.Scenario.ensemble` draws. From numbers to final states is what is timed, for pooltool
without building its systems. Breaks are chaotic, so that the two can agree in their means only.
"""

import contextlib
import itertools
import os
import statistics
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pooltool_process

import carom

TURNS, RUNS, STROKES = 10, 10_000, 20
"""Turns; how many breaks Carom plays in one, and how many of the same ones each process of pooltool."""

WORDS = {"V0": "shot.V0", "phi": "shot.phi_deg", "theta": "shot.theta_deg", "a": "shot.a", "b": "shot.b"}
"""What varies: pooltool's word, and the column of the ensemble."""

MEANS = "balls in pockets", "time to rest, s"

ERRORS = 4
"""Means are to agree to so many standard errors."""


def print_breaks(scenario, shot):
    """Print how fast breaks are, alone and on all cores, and what comes of them; tell whether the means agree."""
    cores = os.cpu_count() or 1
    with contextlib.ExitStack() as stack:
        processes = [stack.enter_context(pooltool_process.started()) for _ in range(cores)]
        for pooltool in processes:
            pooltool.ask("cold", shot)
        turns = [turn(scenario, shot, processes, seed) for seed in range(TURNS)]
    rates, ours, theirs = zip(*turns, strict=True)
    print_rates(cores, [statistics.median(column) for column in zip(*rates, strict=True)])
    return print_means(np.concatenate(ours), list(itertools.chain.from_iterable(theirs)))


def turn(scenario, shot, processes, seed):
    """Play strokes on one core, then on all; give the rates, and what came of our breaks and of theirs.

    On one core it is processor time that counts, which is the same on a quiet machine and holds on a busy one.
    """
    one, table = ensemble(scenario, seed, threads=1, clock="process_time")
    first, *others = (strokes(table, part) for part in range(len(processes) + 1))
    alone = processes[0].ask("strokes", shot, strokes=first, clock="process_time")
    every, _ = ensemble(scenario, seed, threads=len(processes), clock="perf_counter")
    with ThreadPoolExecutor(len(processes)) as pool:
        asked = [
            pool.submit(process.ask, "strokes", shot, strokes=part, clock="perf_counter")
            for process, part in zip(processes, others, strict=True)
        ]
    together = [answer.result() for answer in asked]
    rates = one, rate(alone), every, sum(map(rate, together))
    return rates, ends(table), [*alone, *itertools.chain.from_iterable(together)]


def ensemble(scenario, seed, threads, clock):
    noise = carom.ExecutionNoise.preset("pool_tournament").around(scenario)
    now = getattr(time, clock)
    start = now()
    table = scenario.ensemble(noise, ["final_position", "pockets", "end_time"], runs=RUNS, seed=seed, threads=threads)
    return RUNS / (now() - start), table


def strokes(table, part):
    rows = slice(part * STROKES, (part + 1) * STROKES)
    columns = [table[column][rows].tolist() for column in WORDS.values()]
    return [dict(zip(WORDS, row, strict=True)) for row in zip(*columns, strict=True)]


def rate(played):
    return len(played) / sum(seconds for seconds, _ in played)


def ends(table):
    """What came of each break, as `MEANS` has it: (n_runs, 2) float64."""
    potted = sum(table[name] != None for name in table.names if name.endswith(".pocket"))  # noqa: E711, an array
    return np.column_stack([potted, table["end_time"]])


def print_rates(cores, rates):
    one, alone, every, together = rates
    print(f"\n{'breaks a second, with noise':32} {'carom':>16} {'pooltool':>16} {'ratio':>6}")
    for what, ours, theirs in (
        ("one thread, processor time", one, alone),
        (f"{cores} threads, {cores} processes", every, together),
    ):
        print(f"{what:32} {ours:16.0f} {theirs:16.1f} {ours / theirs:6.0f}")


def print_means(ours, theirs):
    theirs_ended = np.array([end for _, end in theirs if end is not None])
    (mean, error), (their_mean, their_error) = map(mean_and_error, (ours, theirs_ended))
    apart = (their_mean - mean) / np.hypot(error, their_error)
    print(f"{f'means of {len(ours)} and {len(theirs_ended)}':32} {'':16} {'':16} {'errors apart':>12}")
    for k, what in enumerate(MEANS):
        both = [f"{m[k]:.3f} ± {e[k]:.3f}" for m, e in ((mean, error), (their_mean, their_error))]
        print(f"{what:32} {both[0]:>16} {both[1]:>16} {apart[k]:6.1f}")
    if len(theirs_ended) < len(theirs):
        print(f"left out: {len(theirs) - len(theirs_ended)} breaks in which pooltool raises an error")
    return bool((abs(apart) <= ERRORS).all())


def mean_and_error(values):
    return values.mean(axis=0), values.std(axis=0, ddof=1) / np.sqrt(len(values))
