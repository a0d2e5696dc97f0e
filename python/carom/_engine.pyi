"""The native module: conversions around the engine, nothing else."""

from typing import Any, TypedDict, final

import numpy as np
from numpy.typing import NDArray

__version__: str
PHYSICS_VERSION: int
EVENT_KINDS: list[str]

def bundled_scenarios() -> dict[str, str]: ...
def schema() -> str: ...

class EventColumns(TypedDict):
    index: NDArray[np.int64]
    time: NDArray[np.float64]
    kind: NDArray[np.int8]
    ball_a: NDArray[np.int32]
    ball_b: NDArray[np.int32]
    cushion: NDArray[np.int32]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    normal_x: NDArray[np.float64]
    normal_y: NDArray[np.float64]
    closing_speed: NDArray[np.float64]
    impulse: NDArray[np.float64]
    cluster: NDArray[np.int64]
