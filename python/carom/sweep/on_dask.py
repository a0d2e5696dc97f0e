"""The parts of a sweep on a Dask cluster, whose workers compute and write them."""

from __future__ import annotations

import errno
import logging
import signal
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from itertools import islice
from multiprocessing import resource_tracker
from queue import Empty, SimpleQueue
from typing import Any

from carom.errors import RecordError
from carom.extras import needed

ANSWERS_WITHIN = 8
"""Seconds in which a scheduler has to answer."""
WORKER_WITHIN = 60
"""Seconds in which a cluster has to have a worker: some start them when there is work."""
LOOKS_EVERY = 0.1
"""Seconds between two looks at whether the sweep is to end."""
WAITING_PER_THREAD = 2
"""So many parts are with the cluster for each thread of it: one is computed, the next one waits beside it."""


@contextmanager
def connected(scheduler: str | None, workers: int | None) -> Iterator[Any]:
    """Give a client of the scheduler at an address, or of a cluster on this machine that ends with the block."""
    distributed = needed("distributed", "cluster")
    if scheduler is None:
        # Losses and restarts of workers are Dask's to deal with; what cannot be dealt with comes back as an error.
        local = {"threads_per_worker": 1, "dashboard_address": "127.0.0.1:0", "silence_logs": logging.CRITICAL}
        with _sparing_others_ctrl_c():
            cluster = distributed.LocalCluster(workers, host="127.0.0.1", processes=True, **local)
        with cluster, distributed.Client(cluster, set_as_default=False) as client:
            yield client
        return
    try:
        client = distributed.Client(scheduler, timeout=ANSWERS_WITHIN, set_as_default=False)
    except Exception:  # what is there and no scheduler answers anything
        raise OSError(errno.ETIMEDOUT, "no Dask scheduler answers there", scheduler) from None
    with client:
        yield client


@contextmanager
def _sparing_others_ctrl_c() -> Iterator[None]:
    """Keep Ctrl-C, which a terminal sends to all, from what starts in the block: this thread is to end it.

    Threads and processes take over which signals are blocked where they are started, workers that replace others too.
    """
    if sys.platform == "win32":
        yield
        return
    resource_tracker.ensure_running()  # which would unblock it
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def write_parts(
    client: Any, parts: Iterable[tuple[int, int]], write: Callable[[int], None], tell: Callable[[int], object]
) -> None:
    """Let the workers write parts.

    Few of the parts are with the cluster at a time, so that the scheduler's memory does not grow with their number.

    Parameters
    ----------
    client : distributed.Client
        What gives them out.
    parts : iterable of (int, int)
        The number of each part and how many rows it has.
    write : callable
        Writes the part of a number; it is pickled with each of them.
    tell : callable
        Told now and then of the rows done; ends the call by what is true. The parts under way are cancelled.

    Raises
    ------
    Exception
        What a part raised, as it was. The others are cancelled.
    OSError
        When the scheduler is lost, or has no worker for a minute.
    """
    waiting = iter(parts)
    finished: SimpleQueue[Any] = SimpleQueue()
    under_way: dict[Any, int] = {}
    done, seen = 0, time.monotonic()
    try:
        while not tell(done):
            threads = sum(client.nthreads().values())
            seen = time.monotonic() if threads else seen
            if time.monotonic() > seen + WORKER_WITHIN:
                raise OSError(errno.ETIMEDOUT, f"no worker for {WORKER_WITHIN} s", client.scheduler.address)
            # One at least: some clusters start their workers when there is work.
            room = max(WAITING_PER_THREAD * threads, 1) - len(under_way)
            for part, rows in islice(waiting, max(room, 0)):
                future = client.submit(write, part, pure=False)
                under_way[future] = rows
                future.add_done_callback(finished.put)
            if not under_way:
                return
            for future in _ready(finished):
                _raise_what_went_wrong(client, future)
                done += under_way.pop(future)
    finally:
        with suppress(OSError):  # of a scheduler that is lost
            client.cancel(list(under_way))


def _ready(finished: SimpleQueue[Any]) -> Iterator[Any]:
    """Give what is finished, after a short wait where nothing is."""
    with suppress(Empty):
        yield finished.get(timeout=LOOKS_EVERY)
        while True:
            yield finished.get_nowait()


def _raise_what_went_wrong(client: Any, future: Any) -> None:
    lost = needed("distributed", "cluster").KilledWorker
    try:
        future.result()
    except lost as error:
        times, last = error.allowed_failures + 1, error.last_worker.address
        raise RecordError(
            f"a part of the sweep was given up: it was with {times} workers that were lost, at last {last}"
        ) from None
    except CancelledError:
        raise OSError(errno.ECONNRESET, "the Dask scheduler was lost", client.scheduler.address) from None
