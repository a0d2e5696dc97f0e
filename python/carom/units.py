"""The units of quantities, from those that a scenario names."""

from __future__ import annotations

from collections.abc import Mapping


def unit_of(units: Mapping[str, str], quantity: str) -> str:
    """Give the unit of a quantity, put together from those of length, time and mass if need be; empty for none.

    Examples
    --------
    >>> units = {"length": "m", "time": "s"}
    >>> unit_of(units, "time"), unit_of(units, "speed"), unit_of(units, "energy")
    ('s', 'm/s', '')
    """
    if quantity in units:
        return units[quantity]
    length, time, mass = (units.get(name, "") for name in ("length", "time", "mass"))
    if quantity == "speed" and length and time:
        return f"{length}/{time}"
    if quantity == "angular_velocity" and time:
        return f"rad/{time}"
    if quantity == "acceleration" and length and time:
        return f"{length}/{time}²"
    if quantity == "momentum" and length and time and mass:
        return f"{mass} {length}/{time}"
    if quantity == "energy" and length and time and mass:
        joule = (length, time, mass) == ("m", "s", "kg")
        return "J" if joule else f"{mass} {length}²/{time}²"
    return ""
