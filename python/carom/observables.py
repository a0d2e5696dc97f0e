"""What was measured of a gas while it ran: numbers with errors, and curves."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom.columns import ColumnTable
from carom.errors import RunError
from carom.files import write_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Request = str | Mapping[str, Any]
"""An observable that is asked for: its name, or a mapping of `name` and options."""

Progress = Callable[[float, int, int], object]
"""Told now and then of the time, the collisions and the samples so far; ends the run by what is true."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A measured number with its standard error.

    Attributes
    ----------
    name : str
        What it is called.
    value : float or None
        The number; None where too little was seen.
    error : float or None
        Its standard error from block averages; None where too little was seen, or for a number that is known.
    unit : str
        Its dimension in words, such as ``energy/length^2``; ``1`` for a pure number.
    description : str
        What it is, and what is expected of it.
    expected : float or None
        What theory expects, where the description says so.
    """

    name: str
    value: float | None
    error: float | None
    unit: str
    description: str
    expected: float | None

    def __str__(self) -> str:
        return f"{self.name} = {told(self.value, self.error)}"


def told(value: float | None, error: float | None = None) -> str:
    """Give a number with two digits of its error, or with six digits of its own.

    >>> told(2.06326, 0.00123), told(1234.5, 67.0), told(0.25), told(None)
    ('2.0633 ± 0.0012', '1234 ± 67', '0.25', 'not measured')
    """
    if value is None:
        return "not measured"
    if not error or not math.isfinite(error):
        return f"{value:.6g}"
    places = 1 - math.floor(math.log10(error))
    if places > 12:
        return f"{value:.6g} ± {error:.2g}"
    return f"{round(value, places):.{max(places, 0)}f} ± {round(error, places):.{max(places, 0)}f}"


class Curve(ColumnTable):
    """A curve as a table: what it is drawn over is its first column; NaN where nothing was measured.

    Attributes
    ----------
    name : str
        What it is called.
    units : dict of str to str
        The dimension of each column in words; ``1`` for pure numbers.
    descriptions : dict of str to str
        What each column is.
    """

    def __init__(self, name: str, columns: Sequence[Mapping[str, Any]]) -> None:
        super().__init__({column["name"]: column["values"] for column in columns})
        self.name = name
        self.units: dict[str, str] = {column["name"]: column["unit"] for column in columns}
        self.descriptions: dict[str, str] = {column["name"]: column["description"] for column in columns}

    def __repr__(self) -> str:
        return f"{self.name}: {len(self)} rows of {', '.join(self.names)}"


class Observable:
    """What one observable found; ``found["compressibility_factor"]`` gives a number, ``found["speeds"]`` a curve.

    Attributes
    ----------
    name : str
        The observable's name.
    quantities : dict of str to Quantity
        The numbers by name.
    curves : dict of str to Curve
        The curves by name.
    units : dict of str to str
        The units of length, time and mass that the scenario names.
    """

    def __init__(self, found: Mapping[str, Any], units: Mapping[str, str]) -> None:
        self.name: str = found["name"]
        self.quantities = {each["name"]: Quantity(**each) for each in found["quantities"]}
        self.curves = {each["name"]: Curve(each["name"], each["columns"]) for each in found["curves"]}
        self.units = dict(units)

    def __getitem__(self, name: str) -> Any:
        known: dict[str, Any] = {**self.quantities, **self.curves}
        if name not in known:
            raise KeyError(f"{self.name} has no {name!r}; it has {', '.join(known)}")
        return known[name]

    @property
    def table(self) -> ColumnTable:
        """The numbers as a table: `quantity`, `value`, `error`, `expected` and `unit`; NaN for what is absent."""
        rows = list(self.quantities.values())

        def floats(name: str) -> list[float]:
            return [math.nan if getattr(row, name) is None else getattr(row, name) for row in rows]

        return ColumnTable(
            {
                "quantity": [row.name for row in rows],
                "value": floats("value"),
                "error": floats("error"),
                "expected": floats("expected"),
                "unit": [row.unit for row in rows],
            }
        )

    @property
    def has_figure(self) -> bool:
        """Whether there is a curve to draw."""
        return any(len(curve) for curve in self.curves.values())

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the curve beside what theory says; see `carom.figures.gas`.

        Raises
        ------
        RunError
            When the observable has no curve, or nothing was measured.
        """
        if not self.has_figure:
            raise RunError(f"{self.name} has no curve to draw; its numbers are in quantities")
        from carom.figures.gas_observed import plot_observable

        return plot_observable(self, ax)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Observable):
            return NotImplemented
        return (self.name, self.quantities, self.curves) == (other.name, other.quantities, other.curves)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        wide = max(map(len, self.quantities), default=0)
        lines = [self.name]
        for each in self.quantities.values():
            unit = "" if each.unit == "1" or each.value is None else f" {each.unit}"
            expected = "" if each.expected is None else f" (expected {each.expected:.6g})"
            lines.append(f"  {each.name:<{wide}}  {told(each.value, each.error)}{unit}{expected}")
        lines += [f"  {each!r}" for each in self.curves.values()]
        return "\n".join(lines)


class Observables(Mapping[str, Observable]):
    """What was observed of a run, by the names of the observables.

    One that was asked for again is under its name and a number: ``temperature_profile``, ``temperature_profile_2``.
    """

    def __init__(self, found: Sequence[Mapping[str, Any]] = (), units: Mapping[str, str] | None = None) -> None:
        self._all: dict[str, Observable] = {}
        for each in found:
            name, number = each["name"], 1
            while (key := name if number == 1 else f"{name}_{number}") in self._all:
                number += 1
            self._all[key] = Observable(each, units or {})

    def __getitem__(self, name: str) -> Observable:
        if name not in self._all:
            known = f"observed were {', '.join(self._all)}" if self._all else "nothing was observed of this run"
            raise KeyError(f"no observable {name!r}; {known}")
        return self._all[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __repr__(self) -> str:
        return "\n".join(map(repr, self._all.values())) or "Observables: nothing was observed"

    def to_dict(self) -> dict[str, Any]:
        """Give all numbers, and the names, units and descriptions of the curves' columns, as plain values."""
        return {name: _as_dict(name, each) for name, each in self._all.items()}

    def save(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Write ``observables.json`` with all numbers, and a CSV file for each curve, into a folder that is there.

        A curve's file is called as its observable, and as the curve too where there are several. Saved runs do not
        hold observables.

        Returns
        -------
        list of Path
            The files.
        """
        base = Path(folder)
        written = [base / "observables.json"]
        write_text(written[0], json.dumps(self.to_dict(), indent=2, ensure_ascii=False) + "\n")
        for name, each in self._all.items():
            for curve in each.curves.values():
                written.append(base / _file_of(name, each, curve))
                curve.to_csv(written[-1])
        return written


def _as_dict(name: str, observable: Observable) -> dict[str, Any]:
    def columns(curve: Curve) -> dict[str, Any]:
        return {key: {"unit": curve.units[key], "description": curve.descriptions[key]} for key in curve.names}

    quantities = {each.name: {k: v for k, v in asdict(each).items() if k != "name"} for each in _all(observable)}
    curves = {
        curve.name: {"file": _file_of(name, observable, curve), "columns": columns(curve)}
        for curve in observable.curves.values()
    }
    return {"observable": observable.name, "quantities": quantities, "curves": curves}


def _all(observable: Observable) -> list[Quantity]:
    return list(observable.quantities.values())


def _file_of(name: str, observable: Observable, curve: Curve) -> str:
    return f"{name}.csv" if len(observable.curves) == 1 else f"{name}_{curve.name}.csv"
