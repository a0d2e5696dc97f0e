"""One moment of a gas of discs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.errors import RecordError

Problems = list[tuple[str, str]]


@dataclass(frozen=True, eq=False, init=False, slots=True)
class Snapshot:
    """All discs of a gas at one time, in a box whose lower left corner is the origin.

    Arrays are copied and made read-only. Two snapshots are equal if they have the same bits, so 0 differs from −0;
    `single_precision` and `assumed` do not count.

    Parameters
    ----------
    time : float
        When it was taken.
    events : int
        How many collisions there were before.
    size : (2,) float64
        Width and height of the box.
    periodic : (2,) bool
        Whether the box repeats itself in x and y; otherwise there are walls.
    positions : (n, 2) float64
        The centres, not wrapped: where a disc would be if the box did not repeat itself.
    velocities : (n, 2) float64
        The velocities.
    radii : (n,) float64
        The radii, zero or positive.
    masses : (n,) float64
        The masses, positive.
    images : (n, 2) int32, optional
        In which repetition of the box each disc is: ``positions - images * size`` lies in the box.
    ids : sequence of n str, optional
        The discs' names, each of them once.
    single_precision : sequence of str
        The fields that a file held with 24 bits only.
    assumed : sequence of str
        The fields that a file did not hold, so that they are what was asked for or what its format means by that.

    Raises
    ------
    RecordError
        If a shape does not fit, or a number is not finite or out of range; it lists every such field.

    Examples
    --------
    >>> pair = Snapshot(0.0, 0, (4, 3), (True, True), [[1, 1], [2, 1]], [[1, 0], [0, 0]], [0.5, 0.5], [1, 1])
    >>> len(pair), pair.positions.dtype, pair.positions.flags.writeable
    (2, dtype('float64'), False)
    """

    time: float
    events: int
    size: NDArray[np.float64]
    periodic: NDArray[np.bool_]
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]
    radii: NDArray[np.float64]
    masses: NDArray[np.float64]
    images: NDArray[np.int32] | None = None
    ids: tuple[str, ...] | None = None
    single_precision: tuple[str, ...] = field(default=(), kw_only=True)
    assumed: tuple[str, ...] = field(default=(), kw_only=True)

    def __init__(
        self,
        time: float,
        events: int,
        size: Any,
        periodic: Any,
        positions: Any,
        velocities: Any,
        radii: Any,
        masses: Any,
        images: Any = None,
        ids: Sequence[str] | None = None,
        *,
        single_precision: Sequence[str] = (),
        assumed: Sequence[str] = (),
    ) -> None:
        problems: Problems = []
        rows = np.shape(positions)[0] if np.ndim(positions) else 0
        if rows == 0:
            problems.append(("positions", "must hold at least one disc"))
        values: dict[str, Any] = {
            "time": _number(problems, "time", time),
            "events": _count(problems, events),
            "size": _floats(problems, "size", size, (2,), "positive"),
            "periodic": _flags(problems, periodic),
            "positions": _floats(problems, "positions", positions, (rows, 2)),
            "velocities": _floats(problems, "velocities", velocities, (rows, 2)),
            "radii": _floats(problems, "radii", radii, (rows,), "zero or positive"),
            "masses": _floats(problems, "masses", masses, (rows,), "positive"),
            "images": None if images is None else _images(problems, images, rows),
            "ids": None if ids is None else _ids(problems, ids, rows),
            "single_precision": tuple(single_precision),
            "assumed": tuple(assumed),
        }
        if problems:
            raise RecordError(problems)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        return len(self.positions)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Snapshot):
            return NotImplemented
        names = [each.name for each in fields(self) if each.name not in ("single_precision", "assumed")]
        return all(same_bits(getattr(self, name), getattr(other, name)) for name in names)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        width, height = self.size.tolist()
        return f"Snapshot: {len(self)} discs in {width:g} × {height:g} at time {self.time:g}, {self.events} collisions"


def same_bits(one: Any, other: Any) -> bool:
    """Whether two values are of the same kind and shape, and have the same bits."""
    if isinstance(one, (np.ndarray, float)) and isinstance(other, (np.ndarray, float)):
        first, second = np.ascontiguousarray(one), np.ascontiguousarray(other)
        alike = (first.dtype, first.shape) == (second.dtype, second.shape)
        return alike and np.array_equal(first.view(np.uint8), second.view(np.uint8))
    return type(one) is type(other) and bool(one == other)


def _number(problems: Problems, name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        problems.append((name, f"must be a number, got {value!r}"))
        return 0.0
    if not np.isfinite(number):
        problems.append((name, f"must be finite, got {number}"))
    return number


def _count(problems: Problems, value: Any) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)) or not 0 <= value < 2**63:
        problems.append(("events", f"must be a whole number from 0 on, got {value!r}"))
        return 0
    return int(value)


def _floats(problems: Problems, name: str, values: Any, shape: tuple[int, ...], sign: str = "") -> NDArray[np.float64]:
    """Give a read-only copy as float64; what is wrong with it is added to the problems."""
    given = np.asarray(values)
    if given.dtype.kind not in "iuf":
        problems.append((name, f"must be real numbers, got {given.dtype}"))
        return np.zeros(shape)
    if given.shape != shape:
        problems.append((name, f"must be of shape {shape}, got {given.shape}"))
        return np.zeros(shape)
    copy = np.array(given, dtype=np.float64, order="C")
    wrong = ~np.isfinite(copy)
    if sign:
        wrong |= copy < 0.0 if sign == "zero or positive" else copy <= 0.0
    for place, number in _first(wrong, copy):
        problems.append((f"{name}{place}", f"must be {f'{sign} and ' if sign else ''}finite, got {number}"))
    copy.flags.writeable = False
    return copy


def _flags(problems: Problems, values: Any) -> NDArray[np.bool_]:
    given = np.array(values)
    if given.dtype != np.bool_ or given.shape != (2,):
        problems.append(("periodic", f"must be two of True and False, got {values!r}"))
        return np.zeros(2, dtype=bool)
    given.flags.writeable = False
    return given


def _images(problems: Problems, values: Any, rows: int) -> NDArray[np.int32]:
    given = np.asarray(values)
    copy = np.zeros((rows, 2), dtype=np.int32)
    limits = np.iinfo(np.int32)
    if given.dtype.kind not in "iu":
        problems.append(("images", f"must be whole numbers, got {given.dtype}"))
    elif given.shape != (rows, 2):
        problems.append(("images", f"must be of shape {(rows, 2)}, got {given.shape}"))
    else:
        for place, number in _first((given < limits.min) | (given > limits.max), given):
            problems.append((f"images{place}", f"must be within 32 bits, got {number}"))
        copy[:] = given
    copy.flags.writeable = False
    return copy


def _ids(problems: Problems, ids: Sequence[str], rows: int) -> tuple[str, ...]:
    names = tuple(ids)
    if len(names) != rows:
        problems.append(("ids", f"must be {rows}, got {len(names)}"))
    strange = next((place for place, name in enumerate(names) if not isinstance(name, str) or not name), None)
    if strange is not None:
        problems.append((f"ids[{strange}]", f"must be a text that is not empty, got {names[strange]!r}"))
    elif len(set(names)) != len(names):
        seen: set[str] = set()
        twice = next(name for name in names if name in seen or seen.add(name))  # type: ignore[func-returns-value]
        problems.append(("ids", f"must be different, {twice!r} is there twice"))
    return names


def _first(wrong: NDArray[np.bool_], values: NDArray[Any]) -> Iterator[tuple[str, Any]]:
    """Give the first wrong value, if there is one, with its place as ``[row]`` or ``[row, column]``."""
    if wrong.any():
        place = np.unravel_index(int(np.argmax(wrong)), wrong.shape)
        yield f"[{', '.join(str(int(index)) for index in place)}]", values[place]
