"""NumPy, loaded when something of it is first used: to load it takes longer than to compute a run, which needs none.

What runs and events are made of imports this as ``np``. Type checkers are told of NumPy itself.
"""

from typing import Any


def __getattr__(name: str) -> Any:
    import numpy as np

    value = getattr(np, name)
    globals()[name] = value
    return value
