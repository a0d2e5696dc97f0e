"""How balls move on a table: exact, fast, and the same everywhere.

>>> import carom
>>> run = carom.load("midterm").run()
>>> run.status
'time_limit'

Importing the package loads nothing else; each name below is loaded when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from carom._engine import PHYSICS_VERSION, __version__, schema
    from carom.ball import Ball
    from carom.best_aim import AimTable, BestAim
    from carom.cite import citation
    from carom.columns import ColumnTable
    from carom.comparison import (
        Difference,
        Parting,
        RunComparison,
        StepComparison,
        TrajectoryComparison,
        compare,
        compare_steps,
        compare_trajectory,
    )
    from carom.cue import Cue, Shot
    from carom.ensemble import Ensemble, Grid, Normal, Uniform
    from carom.errors import (
        CaromError,
        MissingExtraError,
        RecordError,
        RunError,
        ScenarioError,
        SimulationError,
        TrajectoryError,
    )
    from carom.events import Event, EventTable
    from carom.gases import gas
    from carom.library import presets, scenarios
    from carom.method import Exact, Stepped
    from carom.noise import ExecutionNoise, Success
    from carom.observables import Curve, Observable, Observables, Quantity
    from carom.observing import resume
    from carom.physics import (
        ByIncidence,
        BySpeed,
        Cloth,
        Damping,
        Elastic,
        FallingFriction,
        Field,
        Free,
        Frictional,
        Han2005,
        Mathavan2010,
        Mathavan2014,
        Physics,
        Restitution,
        StrongeCompliant,
    )
    from carom.rack import Rack
    from carom.recording import Checkpoints, EventStream, Snapshots
    from carom.run import Reference, Run, Verification, load_run
    from carom.scenario import Scenario, load
    from carom.shot import ShotResult
    from carom.simulation import Candidate, Simulation
    from carom.studio import MissingPageError, Player
    from carom.sweep import Sweep, SweepResult, outcomes_of_table
    from carom.table import Arc, Circle, Line, Mouth, Path, Pocket, Table, Wall
    from carom.tolerance import Margin, Tolerance

_HOMES = {
    "_engine": ["PHYSICS_VERSION", "__version__", "schema"],
    "ball": ["Ball"],
    "best_aim": ["AimTable", "BestAim"],
    "cite": ["citation"],
    "columns": ["ColumnTable"],
    "comparison": [
        "Difference",
        "Parting",
        "RunComparison",
        "StepComparison",
        "TrajectoryComparison",
        "compare",
        "compare_steps",
        "compare_trajectory",
    ],
    "cue": ["Cue", "Shot"],
    "ensemble": ["Ensemble", "Grid", "Normal", "Uniform"],
    "errors": [
        "CaromError",
        "MissingExtraError",
        "RecordError",
        "RunError",
        "ScenarioError",
        "SimulationError",
        "TrajectoryError",
    ],
    "events": ["Event", "EventTable"],
    "gases": ["gas"],
    "library": ["presets", "scenarios"],
    "method": ["Exact", "Stepped"],
    "physics": [
        "ByIncidence",
        "BySpeed",
        "Cloth",
        "Damping",
        "Elastic",
        "FallingFriction",
        "Field",
        "Free",
        "Frictional",
        "Han2005",
        "Mathavan2010",
        "Mathavan2014",
        "Physics",
        "Restitution",
        "StrongeCompliant",
    ],
    "noise": ["ExecutionNoise", "Success"],
    "observables": ["Curve", "Observable", "Observables", "Quantity"],
    "observing": ["resume"],
    "rack": ["Rack"],
    "recording": ["Checkpoints", "EventStream", "Snapshots"],
    "run": ["Reference", "Run", "Verification", "load_run"],
    "scenario": ["Scenario", "load"],
    "shot": ["ShotResult"],
    "simulation": ["Candidate", "Simulation"],
    "studio": ["MissingPageError", "Player"],
    "sweep": ["Sweep", "SweepResult", "outcomes_of_table"],
    "table": ["Arc", "Circle", "Line", "Mouth", "Path", "Pocket", "Table", "Wall"],
    "tolerance": ["Margin", "Tolerance"],
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = [
    "PHYSICS_VERSION",
    "AimTable",
    "Arc",
    "Ball",
    "BestAim",
    "ByIncidence",
    "BySpeed",
    "Candidate",
    "CaromError",
    "Checkpoints",
    "Circle",
    "Cloth",
    "ColumnTable",
    "Cue",
    "Curve",
    "Damping",
    "Difference",
    "Elastic",
    "Ensemble",
    "Event",
    "EventStream",
    "EventTable",
    "Exact",
    "ExecutionNoise",
    "FallingFriction",
    "Field",
    "Free",
    "Frictional",
    "Grid",
    "Han2005",
    "Line",
    "Margin",
    "Mathavan2010",
    "Mathavan2014",
    "MissingExtraError",
    "MissingPageError",
    "Mouth",
    "Normal",
    "Observable",
    "Observables",
    "Parting",
    "Path",
    "Physics",
    "Player",
    "Pocket",
    "Quantity",
    "Rack",
    "RecordError",
    "Reference",
    "Restitution",
    "Run",
    "RunComparison",
    "RunError",
    "Scenario",
    "ScenarioError",
    "Shot",
    "ShotResult",
    "Simulation",
    "SimulationError",
    "Snapshots",
    "StepComparison",
    "Stepped",
    "StrongeCompliant",
    "Success",
    "Sweep",
    "SweepResult",
    "Table",
    "Tolerance",
    "TrajectoryComparison",
    "TrajectoryError",
    "Uniform",
    "Verification",
    "Wall",
    "__version__",
    "citation",
    "compare",
    "compare_steps",
    "compare_trajectory",
    "gas",
    "load",
    "load_run",
    "outcomes_of_table",
    "presets",
    "resume",
    "scenarios",
    "schema",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'carom' has no attribute {name!r}")
    value = getattr(import_module(f"carom.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
