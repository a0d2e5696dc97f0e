"""Tables of named columns, as every result of a run is one."""

from __future__ import annotations

import csv
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from carom.extras import needed
from carom.files import replacing

if TYPE_CHECKING:
    import numpy as np
    import pandas
    import pyarrow
    from numpy.typing import NDArray
else:
    from carom import arrays as np


class ColumnTable:
    """Columns of equal length, each a read-only NumPy array, in a fixed order.

    Parameters
    ----------
    columns : mapping of str to (n_rows,) array
        The columns by name.

    Examples
    --------
    >>> table = ColumnTable({"time": [0.0, 0.5], "red.x": [0.1, 1.6]})
    >>> table.names, len(table), float(table["red.x"][1])
    (['time', 'red.x'], 2, 1.6)
    """

    def __init__(self, columns: Mapping[str, Any]) -> None:
        self._columns = {name: read_only(column) for name, column in columns.items()}

    @property
    def names(self) -> list[str]:
        """The names of the columns, in order."""
        return list(self._columns)

    def column(self, name: str) -> NDArray[Any]:
        """Give one column, (n_rows,); an unknown name is a KeyError that lists the known ones."""
        if name not in self._columns:
            raise KeyError(f"no column {name!r}; the columns are {', '.join(self._columns)}")
        return self._columns[name]

    def __getitem__(self, name: str) -> Any:
        return self.column(name)

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __iter__(self) -> Iterator[Any]:
        return iter(self._columns)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self) or not isinstance(other, ColumnTable):
            return NotImplemented
        return self.names == other.names and all(
            _same(column, other._columns[name]) for name, column in self._columns.items()
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"{type(self).__name__}: {len(self)} rows of {', '.join(self.names)}"

    def _repr_html_(self) -> str:
        from carom.report import table_card

        return table_card(self, f"{type(self).__name__}, {len(self)} rows")

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """Give the columns as a new dict; the arrays are shared, not copied."""
        return dict(self._columns)

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write the table as CSV.

        Floats carry 17 significant digits, which read back to the same bits; what is absent is empty.
        """
        texts = (_texts(column) for column in self._exported().values())
        with replacing(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.names)
            writer.writerows(zip(*texts, strict=True))

    def to_pandas(self) -> pandas.DataFrame:
        """Give the table as a pandas DataFrame; needs carom[data].

        Whole numbers that may be absent are of pandas' type Int64.
        """
        library = needed("pandas", "data")

        def series(column: NDArray[Any]) -> Any:
            if not isinstance(column, np.ma.MaskedArray):
                return column
            return library.arrays.IntegerArray(column.data.copy(), np.ma.getmaskarray(column))

        columns = {name: series(column) for name, column in self._exported().items()}
        frame: pandas.DataFrame = library.DataFrame(columns)
        return frame

    def to_arrow(self) -> pyarrow.Table:
        """Give the table as a pyarrow Table; needs carom[data].

        Words are strings also where all of them are absent, so that tables of several runs can be joined.
        """
        library = needed("pyarrow", "data")

        def array(column: NDArray[Any]) -> Any:
            if column.dtype.kind == "O":
                words = [None if word is None else str(word) for word in column]
                return library.array(words, type=library.string())
            mask = np.ma.getmaskarray(column) if isinstance(column, np.ma.MaskedArray) else None
            return library.array(np.ma.getdata(column), mask=mask)

        return library.table({name: array(column) for name, column in self._exported().items()})

    def _exported(self) -> dict[str, NDArray[Any]]:
        """Give the columns as other programs get them: masked where a number is absent."""
        return self._columns


def column_of(values: Sequence[Any], *, words: bool = False) -> NDArray[Any]:
    """Give a column of values: numbers as numbers; `words`, and what may be absent, as objects.

    >>> column_of(["red", None]).dtype, column_of([1.5, 2.0]).dtype
    (dtype('O'), dtype('float64'))
    """
    if not words and all(isinstance(value, (bool, int, float, np.generic)) for value in values):
        return np.array(values)
    column = np.empty(len(values), dtype=object)
    column[:] = values
    return column


def read_only(column: Any) -> NDArray[Any]:
    """Give an array as one that refuses to be written to."""
    view = np.asarray(column).view()
    view.setflags(write=False)
    return view


def _same(one: NDArray[Any], other: NDArray[Any]) -> bool:
    floats = one.dtype.kind == "f" and other.dtype.kind == "f"
    return np.array_equal(one, other, equal_nan=floats)


def _texts(column: NDArray[Any]) -> Iterable[str]:
    if isinstance(column, np.ma.MaskedArray):
        return map(_text_or_empty, column.tolist())
    texts: dict[str, Callable[[Any], str]] = {"f": "{:.17g}".format, "O": _text_or_empty}
    return map(texts.get(column.dtype.kind, str), column.tolist())


def _text_or_empty(value: Any) -> str:
    return "" if value is None else str(value)
