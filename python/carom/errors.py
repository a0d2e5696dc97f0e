"""What can go wrong, as exceptions; all of them pickle."""

from __future__ import annotations

from collections.abc import Sequence


class CaromError(Exception):
    """Any error that Carom raises on its own account."""


class ListedError(CaromError, ValueError):
    """An error that lists every problem found, each with its place.

    Parameters
    ----------
    problems : str or sequence of (str, str)
        The problems as (place, message); the place is empty where a problem has no single one. A plain string is
        one problem without a place.
    """

    problems: list[tuple[str, str]]

    def __init__(self, problems: str | Sequence[tuple[str, str]]) -> None:
        super().__init__(problems)
        found = [("", problems)] if isinstance(problems, str) else problems
        self.problems = [(place, message) for place, message in found]

    def __str__(self) -> str:
        return "\n".join(f"{place}: {message}" if place else message for place, message in self.problems)


class ScenarioError(ListedError):
    """A scenario, or what was asked of it, does not hold together.

    The places of its problems are in the path grammar, such as ``balls[1].radius``.
    """


class TrajectoryError(ListedError):
    """A trajectory to be compared cannot be read, or is none of this run; places are file, line and column."""


class RecordError(ListedError):
    """A file of snapshots cannot be written or read; places are file, frame and field."""


class SimulationError(CaromError, RuntimeError):
    """A run broke one of its own invariants.

    Parameters
    ----------
    message : str
        What was found, with time and balls.
    scenario : str
        The scenario as JSON text, to replay the run.
    """

    scenario: str

    def __init__(self, message: str, scenario: str = "") -> None:
        super().__init__(message, scenario)
        self.scenario = scenario

    def __str__(self) -> str:
        return str(self.args[0])


class RunError(CaromError, ValueError):
    """A run was asked for what it does not hold: a time past its end, or a history it did not keep."""


class MissingExtraError(CaromError, ImportError):
    """An optional part of Carom is not installed; the message names the extra that brings it."""
