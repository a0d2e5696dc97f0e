"""A sweep's dataset: its parts, each written whole or not at all, and the manifest that says whose they are."""

from __future__ import annotations

import hashlib
import json
import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import _engine
from carom.ensemble import native_ensemble, outcomes_of
from carom.errors import RecordError
from carom.extras import needed
from carom.files import replacing, write_text
from carom.sweep.plan import Plan, read_plan

if TYPE_CHECKING:
    import pyarrow

MANIFEST = "manifest.json"

Progress = Callable[[int, int], object]
"""Told now and then of the rows done and of all; ends the sweep by what is true."""


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
            plan.scenario, plan.varied, plan.outcomes, runs=plan.runs, design=plan.design, seed=plan.seed
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
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> SweepResult:
        """Compute the parts that are not there yet.

        Parameters
        ----------
        folder : path-like
            The folder of the dataset; it is made where it is missing.
        threads : int, optional
            On how many threads; absent: as many as there are cores.
        progress : callable, optional
            Called now and then with the rows done and all rows; what is true ends the sweep after the part before.

        Raises
        ------
        RecordError
            When the folder holds the dataset of another sweep, or other things.
        OSError
            When something cannot be written; the parts that are there stay.
        MissingExtraError
            Without pyarrow, which carom[data] brings.
        """
        needed("pyarrow", "data")
        parquet, folder = import_module("pyarrow.parquet"), Path(folder)
        self._begin(folder)
        done = 0
        with ThreadPoolExecutor(1) as writer:
            # While a part is computed, the one before it is written.
            written: Future[None] | None = None
            for part, first, end in self._parts():
                path = folder / _name(part)
                if not path.exists():
                    outcome = self._compute(first, end, threads, progress, done)
                    if written is not None:
                        written.result()
                        written = None
                    if outcome is None:
                        break
                    written = writer.submit(self._write, parquet, (first, end), outcome, path)
                done += end - first
            if written is not None:
                written.result()
        return self._result(parquet, folder)

    def _parts(self) -> Iterator[tuple[int, int, int]]:
        size = self._plan.rows_per_part
        for part in range(-(-self.rows // size)):
            yield part, part * size, min((part + 1) * size, self.rows)

    def _compute(
        self, first: int, end: int, threads: int | None, progress: Progress | None, done: int
    ) -> tuple[Any, ...] | None:
        """Give what the engine has of a part, or None where it was ended early."""
        watch = None if progress is None else lambda more: progress(done + more, self.rows)
        numbers, codes, words, problems, is_interrupted = self._native.run(first, end, threads, watch)
        return None if is_interrupted or "not_run" in words else (numbers, codes, words, problems)

    def _write(self, parquet: Any, rows: tuple[int, int], outcome: tuple[Any, ...], path: Path) -> None:
        table = self._table(*rows, outcome)
        # Outcomes of chaos do not compress; words and counts, of which there are few, need not be written out.
        few = [field.name for field in table.schema if str(field.type) != "double" and field.name != "row"]
        with replacing(path, durable=True) as temporary:
            parquet.write_table(table, temporary, use_dictionary=few, compression="none")

    def _table(self, first: int, end: int, outcome: tuple[Any, ...]) -> pyarrow.Table:
        import numpy as np
        import pyarrow

        numbers, codes, words, problems = outcome
        inputs = self._native.inputs(first, end)
        columns: dict[str, Any] = {"row": np.arange(first, end)}
        columns |= dict(zip(self._plan.vary, inputs, strict=True))
        arrays = {name: pyarrow.array(column) for name, column in columns.items()}
        status = pyarrow.DictionaryArray.from_arrays(pyarrow.array(codes), pyarrow.array(words))
        arrays["status"] = status.cast(pyarrow.string())
        has_none = np.isin(codes, [words.index(word) for word in ("rejected", "failed") if word in words])
        for name, column in outcomes_of(self._plan.scenario, self._native, numbers, ~has_none).items():
            if column.dtype.kind == "O":
                arrays[name] = pyarrow.array(column, type=pyarrow.string())
            else:
                mask = has_none if column.dtype.kind == "i" else None
                arrays[name] = pyarrow.array(column, mask=mask)
        texts: list[str | None] = [None] * (end - first)
        for row, text in problems:
            texts[row - first] = text
        arrays["problem"] = pyarrow.array(texts, type=pyarrow.string())
        return pyarrow.table(arrays)

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
        for left in folder.glob(".part-*.parquet"):  # of a process that was killed
            with suppress(OSError):
                left.unlink()

    def _check_manifest(self, path: Path) -> None:
        try:
            found: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        except ValueError:
            raise RecordError([(str(path), "is no manifest of a dataset")]) from None
        if found.get("digest") == self.digest:
            return
        own = self._facts()
        other = [key for key in own if json.loads(json.dumps(own[key])) != found.get(key)]
        where = f"; they differ in {', '.join(other)}" if other else ""
        raise RecordError([(str(path), f"is the manifest of another sweep{where}: choose another folder")])

    def _result(self, parquet: Any, folder: Path) -> SweepResult:
        statuses: Counter[str] = Counter()
        for part, _, _ in self._parts():
            path = folder / _name(part)
            if path.exists():
                column = parquet.read_table(path, columns=["status"]).column(0)
                statuses.update({row["values"]: row["counts"] for row in column.value_counts().to_pylist()})
        rows = sum(statuses.values())
        return SweepResult(folder, rows, rows == self.rows, dict(sorted(statuses.items())))


def _name(part: int) -> str:
    return f"part-{part:08d}.parquet"
