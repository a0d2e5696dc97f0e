"""Numbers and words as pages show them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

DIGITS = 6
MINUS = "\N{MINUS SIGN}"


def exact(value: float | int) -> str:
    """Give a number with all its digits.

    Examples
    --------
    >>> exact(0.1 + 0.2), exact(5.0), exact(-1)
    ('0.30000000000000004', '5', '−1')
    """
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\N{NO-BREAK SPACE}").replace("-", MINUS)
    return repr(value).removesuffix(".0").replace("-", MINUS)


def short(value: float | int, digits: int = DIGITS) -> str:
    """Give a number with so many significant digits; integers in full.

    Examples
    --------
    >>> short(0.26985987331378397), short(-2.220446049250313e-15, 2), short(12)
    ('0.26986', '−2.2e−15', '12')
    """
    return exact(value) if isinstance(value, int) else f"{value:.{digits}g}".replace("-", MINUS)


def column(values: ArrayLike) -> list[str]:
    """Give numbers with one number of decimals, so that their points stand in line.

    It is as many as give the largest six digits, or fewer where no number needs them.

    Examples
    --------
    >>> column([0.123456789, -12.25, 1e-17]), column([0.5, 2.0]), column([2e7, 0.5])
    (['0.1235', '−12.2500', '0.0000'], ['0.5', '2.0'], ['2e+07', '0.5'])
    """
    numbers = np.asarray(values, dtype=float)
    largest = float(np.abs(numbers[np.isfinite(numbers)]).max(initial=0.0))
    size = math.floor(math.log10(largest)) if largest > 0.0 else 0
    if not -4 <= size < DIGITS:
        return [short(float(number)) for number in numbers]
    decimals = DIGITS - 1 - max(size, 0)
    # Adding zero turns a minus zero, left by rounding, into a plain one.
    rounded = [f"{round(float(number), decimals) + 0.0:.{decimals}f}" for number in numbers]
    spare = min((len(text) - len(text.rstrip("0")) for text in rounded), default=0)
    shown = min(decimals, spare)
    return [text[: len(text) - shown].removesuffix(".").replace("-", MINUS) for text in rounded]


def point(values: Sequence[float]) -> str:
    """Give a point or a vector: ``(0.1, 2)``."""
    return f"({', '.join(map(short, values))})"


def with_unit(text: str, unit: str | None) -> str:
    """Give a number's text and its unit, where there is one."""
    return f"{text}\N{NO-BREAK SPACE}{unit}" if unit else text


def head(words: str, unit: str | None) -> str:
    """Give the head of a column, with the unit of its numbers where there is one."""
    return f"{words} ({unit})" if unit else words


def counted(count: int, word: str) -> str:
    """Give a count and its word: ``1 ball``, ``2 balls``."""
    return f"{exact(count)} {word}{'' if count == 1 else 's'}"


def listed(words: Iterable[str]) -> str:
    """Put words in a row: ``a, b and c``."""
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last
