"""What the figures of comparisons read, whether of two runs or of a trajectory and a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from carom.comparison import RunComparison
from carom.figures.moments import draw_times
from carom.figures.scene import Scene

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.comparison import TrajectoryComparison
    from carom.events import EventTable

SAMPLES = 1500


Path = tuple["NDArray[np.float64]", "NDArray[np.float64]"]


@dataclass(frozen=True)
class Compared:
    """Two motions of the same balls.

    Attributes
    ----------
    scene : Scene
        The table of the first.
    other : Scene or None
        That of the second, where there are two runs.
    ids, colours : tuple of str
        One for each ball that is in both.
    names : (str, str)
        What the two motions are called.
    end_time : float
        How far they are compared.
    times, distances : (n_times,) and (n_times, n_balls) float64
        How far each ball is apart.
    in_rows : bool
        Whether the second motion is known at `times` only.
    tolerance : float or None
        The distance that is no difference.
    parting : float or None
        When the two part, and in words what that is.
    parting_balls : tuple of str
        The balls that part then.
    events : tuple of EventTable
        The events of each run.
    paths : two pairs of (n,) and (n, n_balls, 2) float64
        Times and places to draw the paths by, of the first and of the second motion.
    meeting : two (n_balls, 2) float64, or None
        The places at the parting.
    """

    scene: Scene
    other: Scene | None
    ids: tuple[str, ...]
    colours: tuple[str, ...]
    names: tuple[str, str]
    end_time: float
    times: NDArray[np.float64]
    distances: NDArray[np.float64]
    in_rows: bool
    tolerance: float | None
    parting: float | None
    parting_words: str
    parting_balls: tuple[str, ...]
    events: tuple[EventTable, ...]
    paths: tuple[Path, Path]
    meeting: tuple[NDArray[np.float64], NDArray[np.float64]] | None

    @classmethod
    def of(cls, comparison: RunComparison | TrajectoryComparison) -> Compared:
        """Read a comparison."""
        return _of_runs(comparison) if isinstance(comparison, RunComparison) else _of_trajectory(comparison)

    @property
    def radii(self) -> NDArray[np.float64]:
        """The radii of the balls, (n_balls,) float64."""
        return self.scene.radii[[self.scene.ids.index(name) for name in self.ids]]


def shortened(name: str, most: int) -> str:
    """Give a name, a path's last part, in at most so many letters."""
    name = name.replace("\\", "/").rsplit("/", 1)[-1]
    half = most // 2
    return name if len(name) <= most else f"{name[: half - 1]}…{name[half - most :]}"


def _of_runs(comparison: RunComparison) -> Compared:
    scene = Scene.of(comparison.a.scenario)
    balls = [scene.ids.index(name) for name in comparison.balls]
    theirs = [comparison.b.ball_ids.index(name) for name in comparison.balls]
    parting = comparison.parting
    both = ((comparison.a, balls), (comparison.b, theirs))

    def places(times: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        one, two = (run.positions(times)[:, chosen, :2] for run, chosen in both)
        return one, two

    times = [draw_times(run, SAMPLES) for run, _ in both]
    even = np.unique(np.concatenate(times))
    even = even[even <= comparison.end_time]
    one, two = places(even)
    meeting = None
    if parting.time is not None:
        at_a, at_b = places(np.array([parting.time]))
        meeting = at_a[0], at_b[0]
    return Compared(
        scene=scene,
        other=Scene.of(comparison.b.scenario),
        ids=tuple(comparison.balls),
        colours=tuple(scene.colours[ball] for ball in balls),
        names=comparison.names,
        end_time=comparison.end_time,
        times=comparison.times,
        distances=comparison.distances,
        in_rows=False,
        tolerance=None,
        parting=parting.time,
        parting_words="first event that differs",
        parting_balls=() if parting.event is None else parting.event.balls,
        events=(comparison.a.events, comparison.b.events),
        paths=((even, one), (even, two)),
        meeting=meeting,
    )


def _of_trajectory(comparison: TrajectoryComparison) -> Compared:
    run, first = comparison.run, comparison.first_difference
    scene = Scene.of(run.scenario)
    balls = [scene.ids.index(name) for name in comparison.balls]
    end = float(comparison.times[-1]) if len(comparison.times) else 0.0
    times = draw_times(run, SAMPLES)
    meeting = None
    if first is not None:
        at_first = run.positions(min(first.time, run.end_time))[balls, :2]
        meeting = at_first, comparison.positions[first.row]
    return Compared(
        scene=scene,
        other=None,
        ids=tuple(comparison.balls),
        colours=tuple(scene.colours[ball] for ball in balls),
        names=("Carom", comparison.name),
        end_time=max(end, run.end_time),
        times=comparison.times,
        distances=comparison.distances,
        in_rows=True,
        tolerance=comparison.tolerance,
        parting=None if first is None else first.time,
        parting_words="" if first is None else f"first that differs ({first.where})",
        parting_balls=() if first is None else (first.ball,),
        events=(run.events,),
        paths=((times, run.positions(times)[:, balls, :2]), (comparison.times, comparison.positions)),
        meeting=meeting,
    )
