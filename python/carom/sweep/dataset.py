"""A sweep's dataset: its parts, each written whole or not at all, and the manifest that says whose they are."""

from __future__ import annotations

import hashlib
import json
import os
from collections import Counter
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache, partial
from importlib import import_module
from pathlib import Path
from socket import gethostname
from typing import TYPE_CHECKING, Any, Literal, get_args

from carom import _engine
from carom import arrays as np
from carom.ensemble import native_ensemble
from carom.errors import RecordError
from carom.extras import needed
from carom.files import replacing, write_text
from carom.progress import Progress, telling
from carom.sweep.plan import Plan, read_plan
from carom.sweep.work import ROW, Computed, compute

if TYPE_CHECKING:
    import pyarrow

MANIFEST = "manifest.json"

SHARED = "the folder has to be one that all workers see, and Carom the same everywhere"

Engine = Literal["threads", "dask"]
"""What computes the parts of a sweep."""
ENGINES = get_args(Engine)


@dataclass(frozen=True, slots=True)
class SweepResult:
    """What a call of `Sweep.run` has done.

    Attributes
    ----------
    folder : Path
        Where the dataset is; ``pandas.read_parquet(folder)`` reads it whole.
    rows : int
        The rows that are there now.
    is_complete : bool
        Whether these are all.
    statuses : dict of str to int
        How many of the rows have which status.
    """

    folder: Path
    rows: int
    is_complete: bool
    statuses: dict[str, int]


class Sweep:
    """An ensemble that runs into a dataset on the disk, part by part, with bounded memory.

    A part is written whole or not at all; what is there already is not computed again. So a sweep that was ended, or
    killed, goes on where it was, and the dataset is the one that it would have been at once, byte for byte.

    Parameters
    ----------
    plan : Plan
        What the file says; `Sweep.load` reads it.
    """

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._native = native_ensemble(
            plan.scenario,
            plan.varied,
            plan.outcomes,
            runs=plan.runs,
            design=plan.design,
            seed=plan.seed,
            equilibrate=plan.equilibrate,
            sample_interval=plan.sample_interval,
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Sweep:
        """Read a sweep file, TOML or JSON.

        Raises
        ------
        ScenarioError
            With every problem of the file, each with its place; or those of the scenario and of what is varied.
        """
        return cls(read_plan(Path(path)))

    @property
    def plan(self) -> Plan:
        """What the file says."""
        return self._plan

    @property
    def rows(self) -> int:
        """The number of runs."""
        return self._native.runs

    @property
    def digest(self) -> str:
        """The SHA-256 of all that decides what the rows are, the version of the physics too."""
        text = json.dumps(self._facts(), sort_keys=True, ensure_ascii=False)
        return hashlib.sha256(text.encode()).hexdigest()

    def run(
        self,
        folder: str | os.PathLike[str],
        *,
        engine: Engine = "threads",
        threads: int | None = None,
        scheduler: str | None = None,
        workers: int | None = None,
        progress: Progress | bool | None = None,
    ) -> SweepResult:
        """Compute the parts that are not there yet.

        Parameters
        ----------
        folder : path-like
            The folder of the dataset; it is made where it is missing. With ``engine="dask"`` the workers write into it,
            so all of them have to see it at the same path.
        engine : {"threads", "dask"}
            What computes the parts: the threads of this process, or the workers of a Dask cluster. The bytes are the
            same.
        threads : int, optional
            On how many threads each part is computed; absent: with threads on as many as there are cores, on a Dask
            worker on one.
        scheduler : str, optional
            The address of the cluster's scheduler, such as ``"tcp://10.0.0.1:8786"``; absent: worker processes of
            this machine, which are started for this call.
        workers : int, optional
            How many worker processes to start; absent: as many as there are cores.
        progress : bool or callable, optional
            With true a bar on stderr, where that is a terminal, or in a notebook. A function is called now and then
            with the rows done and all rows; what is true ends the sweep. With threads the part under way is dropped, on
            a cluster those under way are cancelled.

        Raises
        ------
        RecordError
            When the folder holds the dataset of another sweep, or other things; when a worker sees another one there,
            or none; when a part costs one worker after another.
        OSError
            When something cannot be written, here or on a worker, or no scheduler answers at the address; the parts
            that are there stay.
        MissingExtraError
            Without pyarrow, which carom[data] brings, or distributed, which carom[cluster] brings.
        """
        _check_engine(engine, scheduler, workers)
        needed("pyarrow", "data")
        if engine == "dask":
            needed("distributed", "cluster")
        folder = Path(folder)
        self._begin(folder)
        missing = self._missing(folder)
        done = self.rows - sum(len(self._rows_of(part)) for part in missing)

        with telling(progress, "runs") as told:

            def tell(more: int) -> object:
                return told(done + more, self.rows)

            if missing and engine == "threads":
                self._run_here(folder, missing, threads, tell)
            elif missing:
                self._run_on_dask(folder, missing, threads or 1, scheduler, workers, tell)
        result = self._result(folder)
        if result.is_complete:
            _remove_what_was_left(folder)
        return result

    def write_part(self, folder: Path, part: int, threads: int) -> None:
        """Compute a part and write it into a folder."""
        computed = self._compute(self._inputs(part), threads)
        if computed is None:
            raise KeyboardInterrupt
        _write(computed, folder / _name(part))

    def _run_here(self, folder: Path, parts: list[int], threads: int | None, tell: Callable[[int], object]) -> None:
        done = 0
        with ThreadPoolExecutor(1) as beside:
            # While a part is computed, the one before it is written, and the inputs of the next one are drawn.
            written: Future[None] | None = None
            drawn = beside.submit(self._inputs, parts[0])
            for part, following in zip(parts, [*parts[1:], None], strict=True):
                inputs = drawn.result()
                if following is not None:
                    drawn = beside.submit(self._inputs, following)
                computed = self._compute(inputs, threads, partial(_added, tell, done))
                if written is not None:
                    written.result()
                    written = None
                if computed is None:
                    break
                written = beside.submit(_write, computed, folder / _name(part))
                done += inputs.num_rows
            if written is not None:
                written.result()

    def _run_on_dask(
        self,
        folder: Path,
        parts: list[int],
        threads: int,
        scheduler: str | None,
        workers: int | None,
        tell: Callable[[int], object],
    ) -> None:
        from carom.sweep import on_dask

        write = partial(_write_part_as_told, str(folder.absolute()), self.digest, threads)
        try:
            with on_dask.connected(scheduler, workers) as client:
                on_dask.write_parts(client, ((part, len(self._rows_of(part))) for part in parts), write, tell)
        finally:
            if scheduler is None:  # the workers of a cluster that goes on may still be writing
                _remove_what_was_left(folder)

    def _missing(self, folder: Path) -> list[int]:
        there = {path.name for path in folder.iterdir()}
        return [part for part in range(self._parts) if _name(part) not in there]

    @property
    def _parts(self) -> int:
        return -(-self.rows // self._plan.rows_per_part)

    def _rows_of(self, part: int) -> range:
        size = self._plan.rows_per_part
        return range(part * size, min((part + 1) * size, self.rows))

    def _inputs(self, part: int) -> pyarrow.Table:
        arrow, rows = needed("pyarrow", "data"), self._rows_of(part)
        columns = zip(self._plan.vary, self._native.inputs(rows.start, rows.stop), strict=True)
        return arrow.table({ROW: np.arange(rows.start, rows.stop), **dict(columns)})

    def _compute(
        self, inputs: pyarrow.Table, threads: int | None, watch: Callable[[int], object] | None = None
    ) -> Computed | None:
        first = inputs[ROW][0].as_py()
        return compute(self._plan.scenario, self._native, inputs, first, threads=threads, watch=watch)

    def _facts(self) -> dict[str, Any]:
        return {**self._plan.to_dict(), "physics_version": _engine.PHYSICS_VERSION}

    def _begin(self, folder: Path) -> None:
        """Make the folder, or see that it is this sweep's."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / MANIFEST
        if not path.exists():
            strangers = sorted(each.name for each in folder.iterdir() if not each.name.startswith("."))
            if strangers:
                raise RecordError([(str(folder), f"holds no dataset but other things, such as {strangers[0]}")])
            write_text(
                path, json.dumps({"format": 1, "rows": self.rows, "digest": self.digest, **self._facts()}, indent=2)
            )
        else:
            self._check_manifest(path)
        _remove_what_was_left(folder)

    def _check_manifest(self, path: Path) -> None:
        found = _read_manifest(path)
        if found.get("digest") == self.digest:
            return
        own = self._facts()
        other = [key for key in own if json.loads(json.dumps(own[key])) != found.get(key)]
        where = f"; they differ in {', '.join(other)}" if other else ""
        raise RecordError([(str(path), f"is the manifest of another sweep{where}: choose another folder")])

    def _result(self, folder: Path) -> SweepResult:
        parquet, statuses = import_module("pyarrow.parquet"), Counter[str]()
        for part in range(self._parts):
            path = folder / _name(part)
            if path.exists():
                column = parquet.read_table(path, columns=["status"]).column(0)
                statuses.update({row["values"]: row["counts"] for row in column.value_counts().to_pylist()})
        rows = sum(statuses.values())
        return SweepResult(folder, rows, rows == self.rows, dict(sorted(statuses.items())))


def _check_engine(engine: str, scheduler: str | None, workers: int | None) -> None:
    if engine not in ENGINES:
        raise ValueError(f"engine: unknown {engine!r}; known: {', '.join(ENGINES)}")
    if engine == "threads" and (scheduler is not None or workers is not None):
        raise ValueError('scheduler, workers: are those of a Dask cluster; engine="dask" takes them')
    if scheduler is not None and workers is not None:
        raise ValueError("workers: the scheduler at an address has its own; leave out one of the two")
    if workers is not None and workers < 1:
        raise ValueError(f"workers: must be 1 at least, got {workers}")


def _added(tell: Callable[[int], object], done: int, more: int) -> object:
    return tell(done + more)


def _write_part_as_told(folder: str, digest: str, threads: int, part: int) -> None:
    """Write a part into a folder whose manifest says what it is; this is what a worker is sent."""
    _sweep_of(folder, digest).write_part(Path(folder), part, threads)


@lru_cache(maxsize=1)
def _sweep_of(folder: str, digest: str) -> Sweep:
    path = Path(folder) / MANIFEST
    if not path.exists():
        raise RecordError([(str(path), f"a worker on {gethostname()} does not see it: {SHARED}")])
    sweep = Sweep(Plan.from_dict(_read_manifest(path)))
    if sweep.digest != digest:
        here = f"physics version {_engine.PHYSICS_VERSION}"
        raise RecordError(
            [(str(path), f"is another sweep for a worker on {gethostname()}, which has {here}: {SHARED}")]
        )
    return sweep


def _read_manifest(path: Path) -> Mapping[str, Any]:
    try:
        found: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        raise RecordError([(str(path), "is no manifest of a dataset")]) from None
    return found


def _write(computed: Computed, path: Path) -> None:
    table = computed.table()
    # Outcomes of chaos do not compress; words and counts, of which there are few, need not be written out.
    few = [field.name for field in table.schema if str(field.type) != "double" and field.name != ROW]
    with replacing(path, durable=True) as temporary:
        import_module("pyarrow.parquet").write_table(table, temporary, use_dictionary=few, compression="none")


def _remove_what_was_left(folder: Path) -> None:
    """Remove what a killed process left half written."""
    for left in folder.glob(".part-*.parquet"):
        with suppress(OSError):
            left.unlink()


def _name(part: int) -> str:
    return f"part-{part:08d}.parquet"
