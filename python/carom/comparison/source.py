"""Where a trajectory comes from: a CSV file, or columns in memory. Nothing in it is guessed."""

from __future__ import annotations

import csv
import os
import re
import warnings
from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from carom.columns import ColumnTable
from carom.errors import TrajectoryError

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE | re.ASCII)
DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+(e[+-]?\d+)?", re.IGNORECASE | re.ASCII)
SEPARATOR = re.compile(r"sep=(.)", re.IGNORECASE)
"""A first line that tells Excel the delimiter."""
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
DELIMITERS = {",": "','", ";": "';'", "\t": "tab", " ": "space"}
"""The usual delimiters, as they are named; a space stands for any run of white space."""
SAVE_AS = 'save it as "CSV UTF-8"'
CHUNK = 1 << 20
MOST_LISTED = 5
FREE_TEXT = "U1"
"""The type in which columns that are not compared are read: whatever they hold, and next to nothing of it kept."""


@dataclass
class Listing:
    """Problems of one kind: the first few in full, the others counted."""

    more: str
    found: list[tuple[str, str]] = field(default_factory=list)
    count: int = 0

    def add(self, place: str, message: str) -> None:
        """Note one problem."""
        self.count += 1
        if len(self.found) < MOST_LISTED:
            self.found.append((place, message))

    def problems(self, name: str) -> list[tuple[str, str]]:
        """Give the problems as errors list them."""
        left = self.count - len(self.found)
        return [*self.found, (name, f"and {left} more {self.more}")] if left else self.found


def listed(
    bad: Sequence[Any] | NDArray[Any], describe: Callable[[Any], tuple[str, str]], more: str, name: str
) -> list[tuple[str, str]]:
    """Describe the first few of some bad places, and count the others."""
    left = len(bad) - MOST_LISTED
    return [*map(describe, bad[:MOST_LISTED]), *([(name, f"and {left} more {more}")] if left > 0 else [])]


class TextFile:
    """A CSV file, with a header or without.

    Empty lines are passed over, and so are lines at the top that begin with ``#`` or ``%``. The first other line is the
    header, unless it holds numbers only.

    Parameters
    ----------
    path : path-like
        A regular file in UTF-8, with or without byte order mark, and with any line ends.
    delimiter : str
        One character; a space stands for any run of white space.
    decimal : str
        A point or a comma.
    """

    def __init__(self, path: str | os.PathLike[str], delimiter: str, decimal: str = ".") -> None:
        if len(delimiter) != 1 or delimiter in '"\r\n':
            raise ValueError(f"delimiter: must be one character, such as ',' or ';', got {delimiter!r}")
        if decimal not in (".", ",") or decimal == delimiter:
            raise ValueError(f"decimal: must be '.' or ',', and not the delimiter, got {decimal!r}")
        self._decimal = decimal
        self.path = Path(path)
        self.name = str(path)
        self._delimiter = delimiter
        _check_regular(self.path)
        _check_encoding(self.path, self.name)
        self.comment = ""
        with self._open() as file:
            self._first, line = self._head(file)
        if not line:
            raise TrajectoryError([(self.name, "holds no line of a table")])
        fields = self._split(line)
        self.width = len(fields)
        numbers = [bool(NUMBER.fullmatch(self._pointed(each))) for each in fields]
        self.names = None if all(numbers) else fields
        self.odd_header = any(numbers) and not all(numbers)
        self._head_line = line

    def values(self, columns: Sequence[int]) -> NDArray[np.float64]:
        """Give some columns as (n_rows, n_columns) float64.

        A parser of NumPy's reads the file; where it stumbles, a second and slower look says where and why.
        """
        kinds = ["f8" if column in columns else FREE_TEXT for column in range(self.width)]
        dtype = np.dtype([(f"f{column}", kind) for column, kind in enumerate(kinds)])
        delimiter = None if self._delimiter == " " else self._delimiter
        try:
            with self._open() as file, warnings.catch_warnings():
                warnings.simplefilter("ignore", UserWarning)  # a header and nothing else
                lines = self._body(file)
                reading: dict[str, Any] = {"delimiter": delimiter, "quotechar": '"', "comments": None}
                table = np.loadtxt(lines, dtype, ndmin=1, encoding="utf-8", **reading)
            found = np.stack([table[f"f{column}"] for column in columns], axis=1)
        except ValueError:
            found = self._look_closely(columns)
        if len(found) == 0:
            raise TrajectoryError([(self.name, "a header and no rows")])
        return found

    def place(self, row: int) -> str:
        """Say in which line of the file a row stands, counted from 1."""
        return f"line {self._lines[row]}"

    def hint(self) -> str:
        """Say whether the file looks like one with another delimiter, or with decimal commas."""
        for other, name in DELIMITERS.items():
            width = len(_split(self._head_line, other))
            if other != self._delimiter and width > self.width and self._delimiter not in self._head_line:
                return f"with {name} as delimiter it has {width}: --delimiter {name} (Python: delimiter={other!r})"
        return ""

    @cached_property
    def _lines(self) -> NDArray[np.int64]:
        with self._open() as file:
            numbered = enumerate(file, start=1)
            return np.array([n for n, line in numbered if n >= self._first_row and line.strip()], dtype=np.int64)

    @property
    def _first_row(self) -> int:
        return self._first + (self.names is not None)

    def _open(self) -> IO[str]:
        return self.path.open(encoding="utf-8-sig")

    def _head(self, file: IO[str]) -> tuple[int, str]:
        """Find the first line that is neither empty nor a comment, and its number."""
        for number, line in enumerate(file, start=1):
            text = line.strip()
            if number == 1 and (told := SEPARATOR.fullmatch(line.rstrip("\r\n"))):
                self._check_separator(told[1])
            elif text and text[0] not in "#%":
                return number, line
            else:
                self.comment = text or self.comment
        return 0, ""

    def _check_separator(self, told: str) -> None:
        """Hold the delimiter against that in a first line as Excel writes it."""
        if told != self._delimiter:
            name, own = (DELIMITERS.get(each, repr(each)) for each in (told, self._delimiter))
            message = f"its first line says that {name} is the delimiter, not {own}: --delimiter {name}"
            raise TrajectoryError([(f"{self.name}, line 1", message)])

    def _pointed(self, text: str) -> str:
        """Give a number as it is written with a decimal point."""
        return text.replace(",", ".") if self._decimal == "," else text

    def _body(self, file: IO[str]) -> Iterator[str]:
        """Give the lines from the first row on, with decimal points."""
        _, line = self._head(file)
        lines = chain([line], file) if self.names is None else iter(file)
        return map(self._pointed, lines) if self._decimal == "," else lines

    def _split(self, line: str) -> list[str]:
        return _split(line, self._delimiter)

    def _look_closely(self, columns: Sequence[int]) -> NDArray[np.float64]:
        """Read line by line, and list what is wrong; where nothing is, give the values."""
        ragged = Listing("lines with another number of columns")
        texts = Listing("values that are no numbers")
        values = array("d")
        names = self.names or [f"column {column + 1}" for column in range(self.width)]
        with self._open() as file:
            for number, line in enumerate(file, start=1):
                if number < self._first_row or not line.strip():
                    continue
                place = f"{self.name}, line {number}"
                fields = self._split(line)
                if len(fields) != self.width:
                    ragged.add(place, _speak_of_width(fields, self.width, self.names is not None))
                    continue
                for column in columns:
                    text = self._pointed(fields[column])
                    if NUMBER.fullmatch(text):
                        values.append(float(text))
                    else:
                        texts.add(f"{place}, {names[column]}", _speak_of_text(fields[column]))
        problems = ragged.problems(self.name) + texts.problems(self.name)
        if problems:
            raise TrajectoryError(problems)
        return np.frombuffer(values, dtype=np.float64).reshape(-1, len(columns))


class Columns:
    """Columns in memory: a `ColumnTable`, a mapping of names to columns, or a DataFrame."""

    comment = ""
    odd_header = False

    def __init__(self, table: Any) -> None:
        self.name = type(table).__name__
        self._keys = list(_keys(table))
        self.names: list[str] | None = [str(key) for key in self._keys]
        self.width = len(self._keys)
        self._table = table

    def values(self, columns: Sequence[int]) -> NDArray[np.float64]:
        """Give some columns as (n_rows, n_columns) float64."""
        found = [self._numbers(self._keys[column]) for column in columns]
        if len({len(column) for column in found}) > 1:
            lengths = ", ".join(f"{self._keys[c]} {len(x)}" for c, x in zip(columns, found, strict=True))
            raise TrajectoryError([(self.name, f"columns of different length: {lengths}")])
        if len(found[0]) == 0:
            raise TrajectoryError([(self.name, "has no rows")])
        return np.stack(found, axis=1)

    def place(self, row: int) -> str:
        """Say which row it is, counted from 0."""
        return f"row {row}"

    def hint(self) -> str:
        """Say nothing: columns are what they are."""
        return ""

    def _numbers(self, key: Any) -> NDArray[np.float64]:
        column = np.asarray(self._table[key])
        if column.ndim != 1:
            raise TrajectoryError([(f"{self.name}, {key}", f"must be one column, got the shape {column.shape}")])
        try:
            return column.astype(np.float64)
        except (TypeError, ValueError):
            raise TrajectoryError(self._texts(key, column)) from None

    def _texts(self, key: Any, column: NDArray[Any]) -> list[tuple[str, str]]:
        texts = Listing("values that are no numbers")
        for row, value in enumerate(column.tolist()):
            if not isinstance(value, (int, float)) and not NUMBER.fullmatch(str(value).strip()):
                texts.add(f"{self.name}, row {row}, {key}", f"{value!r} is not a number")
        return texts.problems(self.name)


Source = TextFile | Columns
"""A trajectory's columns, before it is known what they mean."""


def open_source(source: Any, delimiter: str, decimal: str) -> Source:
    """Open what `carom.compare_trajectory` is given."""
    return TextFile(source, delimiter, decimal) if isinstance(source, (str, os.PathLike)) else Columns(source)


def _keys(table: Any) -> Iterable[Any]:
    """Give the names of a table's columns, as each kind of table tells them."""
    if isinstance(table, ColumnTable):
        return table.names
    if isinstance(table, Mapping):
        return table
    for names in ("column_names", "columns"):
        if hasattr(table, names) and hasattr(table, "__getitem__"):
            keys: Iterable[Any] = getattr(table, names)
            return keys
    raise TypeError(f"source: must be a path, or a table of columns, got {type(table).__name__}")


def _check_regular(path: Path) -> None:
    if not path.exists():
        raise TrajectoryError([(str(path), "no such file")])
    if not path.is_file():
        raise TrajectoryError([(str(path), "not a file; it may be read twice, so a folder or pipe does not do")])


def _check_encoding(path: Path, name: str) -> None:
    """Refuse a file that is no text in UTF-8, and say how to save it as one."""
    with path.open("rb") as file:
        if file.read(2) in UTF_16:
            raise TrajectoryError([(name, f"a text in UTF-16; {SAVE_AS}")])
    try:
        with path.open(encoding="utf-8-sig") as text:
            while text.read(CHUNK):
                pass
    except UnicodeDecodeError:
        raise TrajectoryError([(name, f"not a text in UTF-8 ({_undecodable(path)}); {SAVE_AS}")]) from None


def _undecodable(path: Path) -> str:
    """Say where the first byte is that is no UTF-8."""
    data = path.read_bytes()
    try:
        data.decode()
    except UnicodeDecodeError as error:
        line = data[: error.start].count(10) + 1  # line ends
        return f"line {line}, byte 0x{data[error.start]:02x}"
    return "it is being written"


def _split(line: str, delimiter: str) -> list[str]:
    """Split a line into its fields, without quotes and white space around them."""
    if delimiter == " ":
        return [field.strip('"') for field in line.split()]
    return [field.strip() for field in next(csv.reader([line.rstrip("\r\n")], delimiter=delimiter))]


def _speak_of_width(fields: list[str], width: int, has_header: bool) -> str:
    wanted = "the header" if has_header else "the first line"
    message = f"{len(fields)} columns, and {wanted} has {width}"
    return f"{message}; are these decimal commas? Write decimal points" if len(fields) == 2 * width else message


def _speak_of_text(text: str) -> str:
    if not text:
        return "is empty"
    if DECIMAL_COMMA.fullmatch(text):
        return f"{text!r} has a decimal comma: --decimal , reads it (Python: decimal=',')"
    if text[0] in "#%":
        return f"{text!r} is not a number; comments are read over at the top only"
    return f"{text!r} is not a number"
