"""How far a player's strokes scatter, and how sure a shot is under that."""

from __future__ import annotations

import json
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

from carom.ensemble import Ensemble, Normal
from carom.errors import ScenarioError
from carom.goal import Goal, is_met, outcomes_for

if TYPE_CHECKING:
    from carom.progress import Progress
    from carom.scenario import Scenario

WORDS: dict[str, tuple[str, str]] = {
    "speed": ("V0", "cue_speed"),
    "direction_deg": ("phi_deg", "direction_deg"),
    "elevation_deg": ("theta_deg", "elevation_deg"),
    "left": ("a", "left"),
    "top": ("b", "top"),
}
"""The keys of a shot for each kind of scatter, in pooltool's word and in the plain one."""

BOUNDS: dict[str, tuple[float, float]] = {"speed": (0.0, math.inf), "elevation_deg": (0.0, 90.0)}
"""Where a stroke that scatters ends: no speed is negative, and no cue lies lower than level."""


@dataclass(frozen=True, slots=True)
class ExecutionNoise:
    """How far strokes scatter about what the player means: standard deviations of normal distributions.

    Parameters
    ----------
    speed : float
        Of the speed of the cue, in length per time.
    direction_deg, elevation_deg : float
        Of the direction and of how high the butt is raised, in degrees.
    left, top : float
        Of the place where the tip meets the ball, across and along its height, in length.

    Examples
    --------
    >>> noise = ExecutionNoise.preset("pool_tournament")
    >>> noise.direction_deg, noise.times(0.5).direction_deg
    (0.125, 0.0625)
    """

    speed: float = 0.0
    direction_deg: float = 0.0
    elevation_deg: float = 0.0
    left: float = 0.0
    top: float = 0.0

    @classmethod
    def preset(cls, name: str) -> ExecutionNoise:
        """Give published noise, in SI units.

        ``pool_tournament`` is that of the computational pool tournaments that FastFiz was made for: 0.5 mm and 0.5 mm
        of the tip's place, 0.1° of elevation, 0.125° of direction, 0.075 m/s.

        Raises
        ------
        ValueError
            When there is no such preset; it lists those that there are.
        """
        if name not in PRESETS:
            raise ValueError(f"no execution noise {name!r}; known: {', '.join(PRESETS)}")
        return PRESETS[name]

    def times(self, factor: float) -> ExecutionNoise:
        """Give a noise that is so many times as large: a beginner has more of it, a master less."""
        return replace(self, **{name: getattr(self, name) * factor for name in WORDS})

    def around(self, scenario: Scenario) -> dict[str, Normal]:
        """Give the distributions of a scenario's shot, for `Scenario.ensemble`.

        The offsets of a shot are over the ball's radius. Where the mean is near a bound (a level cue, no speed) the
        distribution is cut off there.

        Raises
        ------
        ScenarioError
            When the scenario has no shot.
        """
        shot = _shot_of(scenario, "only a shot has execution noise")
        balls = {ball["id"]: ball for ball in json.loads(scenario._native.balls())}
        radius = balls[shot.get("cue_ball", "cue")]["radius"]
        is_plain = "cue_speed" in shot
        varied: dict[str, Normal] = {}
        for name, words in WORDS.items():
            deviation = getattr(self, name) / (radius if name in ("left", "top") else 1.0)
            word = next((word for word in words if word in shot), words[is_plain])
            if deviation != 0.0:
                varied[f"shot.{word}"] = Normal(shot.get(word, 0.0), deviation, *BOUNDS.get(name, ()))
        return varied


PRESETS = {
    "pool_tournament": ExecutionNoise(speed=0.075, direction_deg=0.125, elevation_deg=0.1, left=0.5e-3, top=0.5e-3)
}


@dataclass(frozen=True, slots=True)
class Success:
    """How often a goal was met.

    Attributes
    ----------
    probability : float
        The share of the runs that met it.
    low, high : float
        Wilson's confidence interval of the probability.
    level : float
        How sure that is.
    hits, runs : int
        How many runs met the goal, and how many there were: where it was ended early those that were finished.
    table : Ensemble
        The runs.
    """

    probability: float
    low: float
    high: float
    level: float
    hits: int
    runs: int
    table: Ensemble

    def __repr__(self) -> str:
        interval = f"{self.low:.4f} to {self.high:.4f} ({self.level:.0%})"
        return f"Success: {self.probability:.4f}, {interval}, {self.hits} of {self.runs} runs"


def success(
    scenario: Scenario,
    goal: Goal,
    noise: ExecutionNoise,
    *,
    runs: int,
    outcomes: Sequence[str],
    seed: int,
    level: float,
    threads: int | None,
    progress: Progress | bool | None,
) -> Success:
    """Tell how sure a shot is; see `Scenario.success`."""
    check_level(level)
    wanted = outcomes_for(goal, outcomes)
    varied = noise.around(scenario)
    table = scenario.ensemble(varied, wanted, runs=runs, seed=seed, threads=threads, progress=progress)
    played, hits = int(table.has_outcome.sum()), int(is_met(table, goal).sum())
    if played == 0 and not table.is_complete:
        raise KeyboardInterrupt
    return Success(*share(hits, played, level), level, hits, played, table)


def meant(scenario: Scenario, paths: Collection[str]) -> dict[str, float]:
    """Give the numbers of a scenario's shot at paths; those that a shot may leave out are 0.

    Raises
    ------
    ScenarioError
        When there is no shot, or a path leads to no number of it.
    """
    shot = _shot_of(scenario, "only a shot is aimed")
    other = {f"shot.{one}": two for pair in WORDS.values() for one, two in (pair, pair[::-1])}
    problems = []
    for path in paths:
        if path not in other:
            problems.append((path, f"is no number of a shot to aim with; known: {', '.join(other)}"))
        elif other[path] in shot:
            problems.append((path, f"the shot says it in the other word, shot.{other[path]}"))
    if problems:
        raise ScenarioError(problems)
    return {path: float(shot.get(path.removeprefix("shot."), 0.0)) for path in paths}


def bounds_of(path: str) -> tuple[float, float]:
    """Give the bounds of what stands at a path of a shot."""
    found = (bounds for name, bounds in BOUNDS.items() if path.removeprefix("shot.") in WORDS[name])
    return next(found, (-math.inf, math.inf))


def check_level(level: float) -> None:
    """Refuse how sure an interval is to be where it is no probability."""
    if not 0.0 < level < 1.0:
        raise ValueError(f"level: must be between 0 and 1, got {level}")


def share(hits: int, runs: int, level: float) -> tuple[float, float, float]:
    """Give the share of runs that met a goal, with Wilson's interval; of no runs nothing is known."""
    if runs == 0:
        return math.nan, 0.0, 1.0
    return hits / runs, *_wilson(hits, runs, NormalDist().inv_cdf(0.5 + level / 2.0))


def _shot_of(scenario: Scenario, why: str) -> Mapping[str, Any]:
    shot: Mapping[str, Any] | None = scenario.to_dict().get("shot")
    if shot is None:
        raise ScenarioError([("shot", f"missing: {why}")])
    return shot


def _wilson(hits: int, runs: int, quantile: float) -> tuple[float, float]:
    """Give Wilson's interval of a probability, JASA 22 (1927) 209."""
    share, weight = hits / runs, quantile * quantile / runs
    middle = (share + weight / 2.0) / (1.0 + weight)
    half = quantile / (1.0 + weight) * math.sqrt(share * (1.0 - share) / runs + weight / (4.0 * runs))
    # At the ends the interval reaches them exactly, but for rounding.
    return 0.0 if hits == 0 else middle - half, 1.0 if hits == runs else middle + half
