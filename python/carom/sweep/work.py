"""The unit of work of a sweep: from a table of inputs to the table of their outcomes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _engine
from carom.ensemble import WITHOUT_OUTCOMES, native_ensemble, outcomes_of
from carom.errors import ScenarioError
from carom.extras import needed

if TYPE_CHECKING:
    import numpy as np
    import pyarrow
    from numpy.typing import NDArray

    from carom.scenario import Scenario
else:
    from carom import arrays as np

ROW = "row"
"""The one column of inputs that names no path: it is kept as it is."""


def outcomes_of_table(
    scenario: Scenario,
    inputs: pyarrow.Table,
    outcomes: Sequence[str] = ("final_position",),
    *,
    threads: int | None = None,
    equilibrate: float = 0.0,
    sample_interval: float | None = None,
) -> pyarrow.Table:
    """Run a scenario once for each row of a table, and give the rows with what came out.

    It depends on nothing but its arguments, and pickles with them: this is what to hand to Dask, Ray Data, Spark or
    whatever else spreads tables over machines. The parts of a `Sweep` come from it too.

    Parameters
    ----------
    scenario : Scenario
        What is run.
    inputs : pyarrow.Table
        A column of numbers for each varied path, named by it, and perhaps a column ``row`` of anything.
    outcomes : sequence of str
        What to keep of each run; see `Scenario.ensemble`.
    threads : int, optional
        On how many threads; absent: as many as there are cores. Where others share the machine, 1.
    equilibrate, sample_interval : float, optional
        When gases are observed; see `Scenario.run`.

    Returns
    -------
    pyarrow.Table
        In the order of the rows: the columns of `inputs`, then ``status``, the outcomes, and ``problem``, which says
        why a row is ``rejected`` (its numbers make no scenario) or ``failed``; its outcomes are NaN or null. The
        columns are the same for each table of inputs with the same columns, one without rows too: they are those of the
        balls of `scenario`.

    Raises
    ------
    ScenarioError
        When a column is no path of the scenario or has no numbers, or an outcome is unknown.
    MissingExtraError
        Without pyarrow, which carom[data] brings.
    """
    inputs = _checked(inputs)
    # No ensemble is without rows: where there are none, one stands there that is not run.
    varied = {
        path: inputs[path].to_numpy() if inputs.num_rows else np.zeros(1) for path in inputs.column_names if path != ROW
    }
    native = native_ensemble(
        scenario,
        varied,
        outcomes,
        runs=None,
        design="independent",
        seed=0,
        equilibrate=equilibrate,
        sample_interval=sample_interval,
    )
    computed = compute(scenario, native, inputs, 0, threads=threads)
    if computed is None:
        raise KeyboardInterrupt
    return computed.table()


@dataclass(frozen=True, slots=True)
class Computed:
    """What the engine has of a table of inputs, before it is a table itself."""

    scenario: Scenario
    native: _engine.Ensemble
    inputs: pyarrow.Table
    numbers: Sequence[NDArray[np.float64]]
    codes: NDArray[np.uint8]
    words: list[str]
    problems: list[tuple[int, str]]

    def table(self) -> pyarrow.Table:
        """Give the inputs with their outcomes."""
        arrow = needed("pyarrow", "data")
        arrays = dict(zip(self.inputs.column_names, self.inputs.columns, strict=True))
        status = arrow.DictionaryArray.from_arrays(arrow.array(self.codes), arrow.array(self.words, arrow.string()))
        arrays["status"] = status.cast(arrow.string())
        has_none = np.isin(self.codes, [place for place, word in enumerate(self.words) if word in WITHOUT_OUTCOMES])
        for name, column in outcomes_of(self.scenario, self.native, self.numbers, ~has_none).items():
            if column.dtype.kind == "O":
                arrays[name] = arrow.array(column, type=arrow.string())
            else:
                arrays[name] = arrow.array(column, mask=has_none if column.dtype.kind == "i" else None)
        texts: list[str | None] = [None] * len(self.codes)
        for row, text in self.problems:
            texts[row] = text
        arrays["problem"] = arrow.array(texts, type=arrow.string())
        return arrow.table(arrays)


def compute(
    scenario: Scenario,
    native: _engine.Ensemble,
    inputs: pyarrow.Table,
    first: int,
    *,
    threads: int | None = None,
    watch: Callable[[int], object] | None = None,
) -> Computed | None:
    """Run the rows of an ensemble from one on, whose numbers are `inputs`, or give None where that was ended early."""
    numbers, codes, words, problems, is_interrupted = native.run(first, first + inputs.num_rows, threads, watch)
    if is_interrupted or "not_run" in words:
        return None
    problems = [(row - first, text) for row, text in problems]
    return Computed(scenario, native, inputs, numbers, codes, words, problems)


def _checked(inputs: pyarrow.Table) -> pyarrow.Table:
    """Give the inputs with double precision, or raise what is wrong with their columns."""
    arrow = needed("pyarrow", "data")
    problems = list(_problems(inputs, arrow))
    if problems:
        raise ScenarioError(problems)
    fields = [field if field.name == ROW else arrow.field(field.name, arrow.float64()) for field in inputs.schema]
    return inputs.cast(arrow.schema(fields))


def _problems(inputs: Any, arrow: Any) -> Iterator[tuple[str, str]]:
    """Say what is wrong with the columns, as far as that needs no engine."""
    if not isinstance(inputs, arrow.Table):
        raise TypeError(f"inputs: expected a pyarrow.Table, got {type(inputs).__name__}")
    if not set(inputs.column_names) - {ROW}:
        yield "inputs", "has no column that is named by the path of a number to be varied"
    counts = Counter(inputs.column_names)
    yield from ((name, f"{count} columns have this name") for name, count in counts.items() if count > 1)
    for field, column in zip(inputs.schema, inputs.columns, strict=True):
        if field.name == ROW:
            continue
        if not (arrow.types.is_integer(field.type) or arrow.types.is_floating(field.type)):
            yield field.name, f"must be a column of numbers, is one of {field.type}"
        elif column.null_count:
            yield field.name, f"lacks a number in {column.null_count} of {len(column)} rows"
