"""Goals: what a shot is played for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from carom.ensemble import Ensemble
from carom.errors import ScenarioError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
else:
    from carom import arrays as np

Goal = str | Callable[[Ensemble], Any]
"""A ball that is to be in a pocket while the cue ball is not, or a function that says of each run whether it is met."""


def outcomes_for(goal: Goal, outcomes: Sequence[str]) -> list[str]:
    """Give the outcomes that are wanted, with those that the goal needs."""
    return list(dict.fromkeys([*outcomes, "pockets"] if isinstance(goal, str) else outcomes))


def is_met(table: Ensemble, goal: Goal) -> NDArray[np.bool_]:
    """Tell of each run whether it meets a goal, (n_runs,); what has no outcome does not.

    Raises
    ------
    ScenarioError
        When there is no such ball.
    TypeError
        When a function gives no booleans.
    """
    met = np.asarray(_is_potted(table, goal) if isinstance(goal, str) else goal(table))
    runs = len(table)
    if met.shape != (runs,) or met.dtype != np.bool_:
        raise TypeError(f"goal: must give {runs} booleans, one for each run; got {met.dtype} of the shape {met.shape}")
    found: NDArray[np.bool_] = met & table.has_outcome
    return found


def _is_potted(table: Ensemble, ball: str) -> NDArray[np.bool_]:
    cue = table.scenario.to_dict()["shot"].get("cue_ball", "cue")
    name = f"{ball}.pocket"
    if name not in table:
        known = [column.removesuffix(".pocket") for column in table.names if column.endswith(".pocket")]
        raise ScenarioError([("goal", f"there is no ball {ball!r}; known: {', '.join(known)}")])
    potted = _is_in_pocket(table[name])
    return potted if ball == cue else potted & ~_is_in_pocket(table[f"{cue}.pocket"])


def _is_in_pocket(pockets: NDArray[Any]) -> NDArray[np.bool_]:
    return np.array([pocket is not None for pocket in pockets], dtype=np.bool_)
