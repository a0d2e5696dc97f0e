"""Sweeps: ensembles that are written in a file, run into a Parquet dataset, and go on where they were ended."""

from carom.sweep.dataset import MANIFEST, Sweep, SweepResult

__all__ = ["MANIFEST", "Sweep", "SweepResult"]
