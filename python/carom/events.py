"""The events of a run, as rows and as columns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, overload

from carom import _engine
from carom.columns import ColumnTable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
else:
    from carom import arrays as np


@dataclass(frozen=True, slots=True)
class Event:
    """One event: what met what, when and where.

    Attributes
    ----------
    index : int
        Its row in the run, from 0.
    time : float
        When it happened.
    kind : str
        ``ball_ball``, ``ball_cushion`` and so on, the same words everywhere.
    ball_a, ball_b : str or None
        The balls' ids; `ball_b` is None where a single ball is involved.
    cushion : str or None
        The cushion's id, where there is one.
    x, y : float
        The contact point.
    normal_x, normal_y : float
        The unit normal of the contact.
    closing_speed : float
        The speed at which the gap closed, before the contact.
    impulse : float
        The normal impulse, in units of mass times speed.
    cluster : int or None
        The number of the cluster it was resolved in; None when it stood alone.
    pocket : str or None
        The pocket's id, where a ball fell into one.
    """

    index: int
    time: float
    kind: str
    ball_a: str | None
    ball_b: str | None
    cushion: str | None
    x: float
    y: float
    normal_x: float
    normal_y: float
    closing_speed: float
    impulse: float
    cluster: int | None
    pocket: str | None = None

    @property
    def position(self) -> tuple[float, float]:
        """The contact point (x, y)."""
        return self.x, self.y

    @property
    def normal(self) -> tuple[float, float]:
        """The unit normal (x, y) of the contact."""
        return self.normal_x, self.normal_y

    @property
    def balls(self) -> tuple[str, ...]:
        """The ids of the balls that take part."""
        return tuple(ball for ball in (self.ball_a, self.ball_b) if ball is not None)


COLUMNS = tuple(field.name for field in fields(Event))
"""The event columns, in order."""


class EventTable(ColumnTable):
    """Events as columns: ``events["time"]``; as rows: ``events[0]``; and in parts, which compose.

    A column is a read-only array of n_events entries: int64 for `index` and `cluster` (−1: in no cluster; in pandas,
    Arrow, CSV and JSON that is absent), float64 for numbers, object for `kind`, `ball_a`, `ball_b`, `cushion` and
    `pocket` (str, or None where absent).

    Parameters
    ----------
    columns : mapping of str to (n_events,) array
        The columns of `Event`, complete.
    kinds, balls, cushions, pockets : sequences of str
        The words that `by_kind`, `by_ball`, `by_cushion` and `by_pocket` know.
    """

    def __init__(
        self,
        columns: Mapping[str, Any],
        kinds: Sequence[str],
        balls: Sequence[str],
        cushions: Sequence[str],
        pockets: Sequence[str] = (),
    ) -> None:
        super().__init__({name: columns[name] for name in COLUMNS})
        self._kinds = tuple(kinds)
        self._balls = tuple(balls)
        self._cushions = tuple(cushions)
        self._pockets = tuple(pockets)

    @overload
    def __getitem__(self, key: str) -> NDArray[Any]: ...
    @overload
    def __getitem__(self, key: int) -> Event: ...
    @overload
    def __getitem__(self, key: slice | NDArray[Any] | Sequence[int]) -> EventTable: ...
    def __getitem__(self, key: str | int | slice | NDArray[Any] | Sequence[int]) -> NDArray[Any] | Event | EventTable:
        if isinstance(key, str):
            return self.column(key)
        if isinstance(key, (int, np.integer)):
            return self._row(int(key))
        return self._part(key if isinstance(key, slice) else np.asarray(key, dtype=None if len(key) else np.intp))

    def __contains__(self, item: object) -> bool:
        return super().__contains__(item) if isinstance(item, str) else any(event == item for event in self)

    def __iter__(self) -> Iterator[Event]:
        columns = (self.column(name).tolist() for name in COLUMNS)
        return (event_from(dict(zip(COLUMNS, values, strict=True))) for values in zip(*columns, strict=True))

    def by_kind(self, *kinds: str) -> EventTable:
        """Give the events of these kinds; an unknown word is a ValueError."""
        _check_known("kind of event", kinds, self._kinds)
        return self._part(_any_of(self["kind"], kinds))

    def by_ball(self, *balls: str) -> EventTable:
        """Give the events in which any of these balls takes part; an unknown id is a ValueError."""
        _check_known("ball", balls, self._balls)
        return self._part(_any_of(self["ball_a"], balls) | _any_of(self["ball_b"], balls))

    def by_cushion(self, *cushions: str) -> EventTable:
        """Give the events at any of these cushions; an unknown id is a ValueError."""
        _check_known("cushion", cushions, self._cushions)
        return self._part(_any_of(self["cushion"], cushions))

    def by_pocket(self, *pockets: str) -> EventTable:
        """Give the events in which a ball falls into any of these pockets; an unknown id is a ValueError."""
        _check_known("pocket", pockets, self._pockets)
        return self._part(_any_of(self["pocket"], pockets))

    def by_time(self, start: float, end: float) -> EventTable:
        """Give the events with ``start <= time <= end``."""
        time = self["time"]
        return self._part((time >= start) & (time <= end))

    def first(self) -> Event | None:
        """Give the first event, or None where there is none."""
        return self._row(0) if len(self) else None

    def _row(self, row: int) -> Event:
        if not -len(self) <= row < len(self):
            raise IndexError(f"no event {row}; the table has {len(self)}")
        return next(iter(self._part(slice(row, row + 1 or None))))

    def _exported(self) -> dict[str, NDArray[Any]]:
        cluster = self.column("cluster")
        return {**self.to_dict(), "cluster": np.ma.masked_equal(cluster, -1)}

    def _part(self, rows: slice | NDArray[Any]) -> EventTable:
        columns = {name: self.column(name)[rows] for name in COLUMNS}
        return EventTable(columns, self._kinds, self._balls, self._cushions, self._pockets)


def event_table(
    native: Mapping[str, Any], balls: Sequence[str], cushions: Sequence[str], pockets: Sequence[str] = ()
) -> EventTable:
    """Give the table of the engine's columns, in which kinds, balls, cushions and pockets are codes."""
    columns, kinds = dict(native), _engine.EVENT_KINDS
    for name, words in (
        ("kind", kinds),
        ("ball_a", balls),
        ("ball_b", balls),
        ("cushion", cushions),
        ("pocket", pockets),
    ):
        columns[name] = decoded(columns[name], words)
    return EventTable(columns, kinds, balls, cushions, pockets)


def event_from(values: Mapping[str, Any]) -> Event:
    """Build an `Event` from its columns' values; a cluster of −1 means none."""
    cluster = values["cluster"]
    return Event(**{**values, "cluster": None if cluster == -1 else cluster})


def decoded(codes: NDArray[np.integer[Any]], words: Sequence[str]) -> NDArray[np.object_]:
    """Turn codes into words, sharing each word's one string; −1 becomes None."""
    table = np.array([*words, None], dtype=object)
    chosen: NDArray[np.object_] = table[codes]
    return chosen


def _any_of(column: NDArray[Any], words: Sequence[str]) -> NDArray[np.bool_]:
    chosen = np.zeros(len(column), dtype=bool)
    for word in words:
        chosen |= column == word
    return chosen


def _check_known(what: str, words: Sequence[str], known: Sequence[str]) -> None:
    for word in words:
        if word not in known:
            listed = f"known are {', '.join(known)}" if known else "there is none"
            raise ValueError(f"unknown {what} {word!r}; {listed}")
