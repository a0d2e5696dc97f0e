"""What may be given as a point, a velocity or an acceleration; for type checkers, since it needs NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Vector = Sequence[float] | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]
"""A vector (x, y) or (x, y, z): numbers in a row, or a NumPy array of them."""
