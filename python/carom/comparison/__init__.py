"""Comparisons: of time steps with the exact run, of two runs, of one's own trajectory with a run."""

from carom.comparison.parting import Parting
from carom.comparison.runs import RunComparison, compare
from carom.comparison.steps import StepComparison, compare_steps
from carom.comparison.trajectory import Difference, TrajectoryComparison, compare_trajectory

__all__ = [
    "Difference",
    "Parting",
    "RunComparison",
    "StepComparison",
    "TrajectoryComparison",
    "compare",
    "compare_steps",
    "compare_trajectory",
]
