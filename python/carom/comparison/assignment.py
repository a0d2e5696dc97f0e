"""Which column of a trajectory is what: its time, and the x and y of each ball."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.errors import TrajectoryError

if TYPE_CHECKING:
    from carom.comparison.source import Source

ColumnNames = str | Sequence[str] | Mapping[str, str]
"""How columns are named: in Carom's order, or each with what it is."""

TIME = "time"


@dataclass(frozen=True)
class Assignment:
    """What the columns of a trajectory are.

    Attributes
    ----------
    balls : tuple of int
        The balls that it holds, by their place in the run.
    columns : tuple of int
        The places of its columns: time, then x and y of each of these balls.
    meaning : dict of str to str
        What each of them is (``time``, ``red.x``, ...), and its name.
    left_out : tuple of str
        The names of its other columns.
    """

    balls: tuple[int, ...]
    columns: tuple[int, ...]
    meaning: dict[str, str]
    left_out: tuple[str, ...]


def assign(source: Source, columns: ColumnNames | None, ball_ids: Sequence[str]) -> Assignment:
    """Find what each column is.

    Parameters
    ----------
    source : Source
        The trajectory.
    columns : str, sequence of str, mapping, or None
        The names of time, and x and y of each ball in order, as ``"t,xr,yr,xb,yb"`` or a sequence; or what each is,
        as ``"time=t,red.x=xr,red.y=yr"`` or a mapping, for some balls at least. Without a header a sequence names
        the columns by place, an empty name leaving one out, and a mapping gives their numbers from 1. None: the
        names are Carom's own, ``time,<id>.x,<id>.y,...``.
    ball_ids : sequence of str
        The balls of the run.

    Raises
    ------
    TrajectoryError
        When columns are missing, named twice, or not named as they need to be.
    """
    roles = _roles(ball_ids)
    wanted = _wanted(source, columns, roles)
    places = {role: _find(source, name) for role, name in wanted.items()}
    problems = [(source.name, place) for place in places.values() if isinstance(place, str)]
    if problems and source.names is not None and not set(wanted.values()) & set(source.names):
        problems = [(source.name, f"none of the columns {_shortened(list(wanted.values()))} is in it")]
    if problems:
        raise TrajectoryError(problems + _advice(source, columns))
    found = {role: place for role, place in places.items() if isinstance(place, int)}
    _check_distinct(source, found, wanted)
    names = source.names or [str(column + 1) for column in range(source.width)]
    return Assignment(
        balls=tuple(ball for ball, name in enumerate(ball_ids) if f"{name}.x" in found),
        columns=tuple(found.values()),
        meaning=wanted,
        left_out=tuple(name for place, name in enumerate(names) if place not in found.values()),
    )


def _roles(ball_ids: Sequence[str]) -> list[str]:
    return [TIME, *(f"{name}.{axis}" for name in ball_ids for axis in "xy")]


def _wanted(source: Source, columns: ColumnNames | None, roles: list[str]) -> dict[str, str]:
    """Give the name of the column for each role, in the order of roles."""
    if columns is None:
        if source.names is None:
            raise TrajectoryError([(source.name, _speak_of_no_header(source, roles))])
        return {role: role for role in roles}
    if isinstance(columns, str):
        words = [word.strip() for word in columns.split(",")]
        explicit = any("=" in word for word in words)
        return _explicit(_pairs(words), roles) if explicit else _in_order(source, words, roles)
    if isinstance(columns, Mapping):
        return _explicit({str(role): str(name) for role, name in columns.items()}, roles)
    return _in_order(source, [str(name) for name in columns], roles)


def _pairs(words: list[str]) -> dict[str, str]:
    pairs: dict[str, str] = {}
    for word in words:
        role, equals, name = (part.strip() for part in word.partition("="))
        if not equals or not role or not name:
            raise _misnamed(f"{word!r} is not WHAT=NAME, such as red.x=xr, and others are")
        if role in pairs:
            raise _misnamed(f"{role} is given twice")
        pairs[role] = name
    return pairs


def _explicit(pairs: Mapping[str, str], roles: list[str]) -> dict[str, str]:
    for role in pairs:
        if role not in roles:
            raise _misnamed(f"nothing is called {role!r}{_nearest(role, roles)}; known are {_shortened(roles)}")
    if TIME not in pairs:
        raise _misnamed("the column of the time is not named: time=NAME")
    if len(pairs) == 1:
        raise _misnamed(f"no ball is named, such as {roles[1]}=NAME,{roles[2]}=NAME")
    for role in pairs:
        ball, _, axis = role.rpartition(".")
        other = f"{ball}.{'y' if axis == 'x' else 'x'}"
        if role != TIME and other not in pairs:
            raise _misnamed(f"{role} is named, and {other} is not")
    return {role: pairs[role] for role in roles if role in pairs}


def _in_order(source: Source, names: list[str], roles: list[str]) -> dict[str, str]:
    """Match names with roles by their order; without a header they also say which column is which."""
    if source.names is None:
        if len(names) != source.width:
            raise _misnamed(
                f"{len(names)} names for the {source.width} columns of {source.name}, which has no header; "
                f"an empty name leaves a column out{_decimals(source, len(names))}"
            )
        names = [str(place) for place, name in enumerate(names, start=1) if name]
    if len(names) != len(roles):
        raise _misnamed(f"{len(names)} names, and {len(roles)} are needed, for {_shortened(roles)}")
    return dict(zip(roles, names, strict=True))


def _find(source: Source, name: str) -> int | str:
    """Give the place of a column, or what is wrong."""
    if source.names is None:
        if name.isdecimal() and 1 <= int(name) <= source.width:
            return int(name) - 1
        return f"no header, so columns have numbers from 1 to {source.width}, not {name!r}"
    count = source.names.count(name)
    if count == 1:
        return source.names.index(name)
    if count > 1:
        return f"{count} columns are called {name!r}"
    return f"no column {name!r}{_nearest(name, source.names)}"


def _check_distinct(source: Source, found: Mapping[str, int], wanted: Mapping[str, str]) -> None:
    seen: dict[int, str] = {}
    for role, place in found.items():
        if place in seen:
            raise TrajectoryError([(source.name, f"column {wanted[role]!r} is to be both {seen[place]} and {role}")])
        seen[place] = role


def _advice(source: Source, columns: ColumnNames | None) -> list[tuple[str, str]]:
    """Say what columns there are, and how to name them."""
    if source.names is None:
        return []
    one = "column" if source.width == 1 else "columns"
    lines = [f"it has {source.width} {one}: {_shortened(source.names)}"]
    if hint := source.hint():
        lines = [f"it has {source.width} {one}; {hint}"]
    elif source.odd_header:
        lines.append("its first line is read as a header, since not all of it are numbers")
    elif _is_in_order(columns, source.width) and not any("," in name for name in source.names):
        lines.append(f'as many as are named; if they are in that order: --columns "{",".join(source.names)}"')
    else:
        lines.append("say which is which, as in --columns time=t,red.x=xr,red.y=yr, balls left out not compared")
    return [(source.name, line) for line in lines]


def _is_in_order(columns: ColumnNames | None, width: int) -> bool:
    """Tell whether so many columns were named in order."""
    if isinstance(columns, str):
        return "=" not in columns and columns.count(",") + 1 == width
    return columns is not None and not isinstance(columns, Mapping) and len(columns) == width


def _speak_of_no_header(source: Source, roles: list[str]) -> str:
    words = f"no header: name its {source.width} columns in order with --columns, for {_shortened(roles)}"
    if hint := source.hint():
        return f"no header, and {source.width} column; {hint}"
    return f"{words} (its comment says: {source.comment})" if source.comment else words


def _decimals(source: Source, names: int) -> str:
    if hint := source.hint():
        return f"; {hint}"
    return "; are its numbers written with decimal commas?" if source.width == 2 * names else ""


def _nearest(name: str, known: Sequence[str]) -> str:
    folded = {each.casefold(): each for each in reversed(known)}
    near = difflib.get_close_matches(name.casefold(), folded, n=1, cutoff=0.5)
    return f"; the nearest is {folded[near[0]]!r}" if near else ""


def _shortened(names: Sequence[str]) -> str:
    return ", ".join(names if len(names) <= 9 else [*names[:5], "...", names[-1]])


def _misnamed(message: str) -> TrajectoryError:
    return TrajectoryError([("--columns", message)])
