"""Sweeps: ensembles that are written in a file, run into a Parquet dataset, and go on where they were ended."""

from carom.sweep.dataset import MANIFEST, Engine, Sweep, SweepResult
from carom.sweep.work import outcomes_of_table

__all__ = ["MANIFEST", "Engine", "Sweep", "SweepResult", "outcomes_of_table"]
