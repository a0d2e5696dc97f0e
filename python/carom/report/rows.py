"""A name, what it is, and what that means: the rows of which most tables of a page are made."""

from __future__ import annotations

from typing import NamedTuple


class Row(NamedTuple):
    """One row.

    Attributes
    ----------
    name : str
        What is said.
    value : str
        What it is.
    note : str
        What that means, where it is not plain.
    """

    name: str
    value: str
    note: str = ""
