"""Runs: what came out, exact at any time."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import _engine
from carom.columns import ColumnTable
from carom.errors import RunError, ScenarioError
from carom.events import Event, EventTable, decoded, event_table
from carom.files import read_text, write_text
from carom.observables import Observables
from carom.options import options_json
from carom.scenario import Scenario

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    from carom.cue import Shot
    from carom.shot import ShotResult
    from carom.studio import Player
else:
    from carom import arrays as np

MOST_TIMES = 1e8


@dataclass(frozen=True)
class Verification:
    """What `Run.verify` found; true when the bits are the same.

    Attributes
    ----------
    same : bool
        Whether the repeated run gave the same bits.
    physics_version : int
        The version of the physics that the run was made with.
    difference : dict or None
        The first difference: its place, and the two values. Its place is ``physics_version`` where the bits differ
        and the run was made with another version of the physics.
    """

    same: bool
    physics_version: int
    difference: dict[str, Any] | None

    def __bool__(self) -> bool:
        return self.same


@dataclass(frozen=True)
class Reference:
    """A source of a law that a run used: what to cite for it.

    Attributes
    ----------
    law : str
        The law, as kind and name: ``ball_cushion.restitution``, of which ``damping`` is another name,
        ``cluster.reflections``, ``method.stepped``.
    text : str
        Authors, title, where and when.
    doi : str or None
        Its DOI, where it has one.
    """

    law: str
    text: str
    doi: str | None


class Run:
    """A computed run; it compares, copies and pickles.

    Runs are equal that came out equal: the same scenario, status and end, and bit for bit the same events, flights
    or steps and final state, as far as they were kept. What the computation itself took and measured, all of
    `diagnostics`, does not count: a resumed run equals the one that was computed at once.

    Attributes
    ----------
    status : str
        How it ended: ``time_limit``, ``collision_limit``, ``stopped``, ``at_rest``, ``collapsed``,
        ``event_limit``, ``interrupted`` or ``miscue``.
    end_time : float
        The time at which it ended.
    ball_ids : list of str
        The ids of the balls, in the order of every array's ball axis.
    physics_version : int
        The version of the physics that it was made with.
    observables : Observables
        What was measured while it ran, by name; empty where nothing was asked for, and in a run that was loaded.
    """

    def __init__(self, native: _engine.Run, observables: Observables | None = None) -> None:
        self._native = native
        self.observables = Observables() if observables is None else observables
        self.status = native.status
        self.end_time = native.end_time
        self.ball_ids = native.ball_ids
        self.physics_version = native.physics_version

    @cached_property
    def digest(self) -> str | None:
        """A hash over the final state; equal digests mean equal bits. None where a number in it is NaN."""
        return self._native.digest

    @cached_property
    def scenario(self) -> Scenario:
        """The scenario as it was run, with the options' method, duration and so on in it."""
        return Scenario._of(self._native.scenario())

    @cached_property
    def record(self) -> str:
        """What was kept: ``all``, ``events`` or ``none``."""
        return self.scenario.record

    @cached_property
    def events(self) -> EventTable:
        """The events, in order."""
        return event_table(self._native.events(), self.ball_ids, self.cushion_ids, self.pocket_ids)

    @property
    def cushion_ids(self) -> list[str]:
        """The ids of the cushions, in order."""
        return self._native.cushion_ids

    @property
    def pocket_ids(self) -> list[str]:
        """The ids of the pockets, in order."""
        return self._native.pocket_ids

    @property
    def is_on_cloth(self) -> bool:
        """Whether the balls are spheres that roll and spin on a cloth, and no discs."""
        return self._native.is_on_cloth

    @cached_property
    def shot(self) -> ShotResult:
        """What came of the shot: the ball hit first, the balls pocketed, the cushions, and so on.

        Raises
        ------
        RunError
            When the scenario has no shot, or when the run kept no events.

        Examples
        --------
        >>> import carom
        >>> carom.load("nine_ball_break").run().shot.first_ball_hit
        '1'
        """
        from carom.shot import shot_result

        return shot_result(self)

    @cached_property
    def diagnostics(self) -> dict[str, Any]:
        """What the run found when it audited itself: events by kind, drifts, the deepest overlap, and so on.

        Its energies are kinetic and, in a field, potential ones together.
        """
        found: dict[str, Any] = json.loads(self._native.diagnostics())
        return found

    @cached_property
    def references(self) -> list[Reference]:
        """The sources of the laws that acted: of a cushion's law where a ball hit that cushion, and so on.

        A run that kept no events does not know which cushions were hit; then the laws of all of them count.

        Examples
        --------
        >>> import carom
        >>> [reference.law for reference in carom.load("midterm").run().references]
        ['ball_cushion.restitution']
        """
        return [Reference(**source) for source in json.loads(self._native.references())]

    @cached_property
    def steps(self) -> ColumnTable | None:
        """The steps of a stepped run; None for an exact one.

        Columns: ``step``, ``time``, and for each ball ``<id>.x``, ``<id>.y``, ``<id>.vx``, ``<id>.vy`` at that
        time and ``<id>.hit``, the kind of hit in the step that begins there, or None.

        Raises
        ------
        RunError
            When a stepped run did not keep its steps.
        """
        steps = self._native.steps()
        if steps is None:
            return None
        columns: dict[str, NDArray[Any]] = {"step": steps["step"], "time": steps["time"]}
        hits = decoded(steps["hit"], _engine.EVENT_KINDS)
        for ball, name in enumerate(self.ball_ids):
            columns |= {f"{name}.{key}": steps[key][:, ball] for key in ("x", "y", "vx", "vy")}
            columns[f"{name}.hit"] = hits[:, ball]
        return ColumnTable(columns)

    def states(self, times: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Give positions and velocities at any times within the run; at an event's time, those after it.

        Parameters
        ----------
        times : float or (n_times,) array of float
            In any order.

        Returns
        -------
        positions, velocities : (n_times, n_balls, 2) float64
            In length, and in length per time; (n_times, n_balls, 3) on a cloth, where those of balls out of play are
            NaN; without the first axis for a single time.

        Raises
        ------
        RunError
            When a time is outside the run, or when the run kept no flights or steps.
        """
        at = np.asarray(times, dtype=np.float64)
        positions, velocities = self._native.states(np.ascontiguousarray(at).ravel())
        shape = (*at.shape, *positions.shape[1:])
        return positions.reshape(shape), velocities.reshape(shape)

    def positions(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the centres at `times`, (n_times, n_balls, 2) float64, in length; 3 numbers on a cloth; see `states`."""
        return self.states(times)[0]

    def velocities(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the velocities at `times`, in length per time; otherwise as `positions`."""
        return self.states(times)[1]

    def spins(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the angular velocities at `times`, (n_times, n_balls, 3) float64, in radians per time; on a cloth only.

        Those of balls out of play are NaN; a time may be any that `states` takes.

        Raises
        ------
        RunError
            When the balls are discs; and as for `states`.
        """
        return self._spins_and_motions(times)[0]

    def motion(self, times: ArrayLike) -> NDArray[np.object_]:
        """Give how each ball moves at `times`, (n_times, n_balls) object; on a cloth only.

        Each entry is one of the words ``resting``, ``spinning`` (in place), ``sliding``, ``rolling``, ``airborne``,
        ``pocketed`` and ``off_table``, a str: so ``run.motion(times) == "rolling"`` is an array of booleans.

        Raises
        ------
        RunError
            When the balls are discs; and as for `states`.

        Examples
        --------
        >>> import carom
        >>> run = carom.load("nine_ball_break").run()
        >>> [str(word) for word in run.motion([0.0, 0.05])[:, 0]]
        ['sliding', 'sliding']
        """
        return decoded(self._spins_and_motions(times)[1], _engine.MOTIONS)

    def _spins_and_motions(self, times: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int8]]:
        at = np.asarray(times, dtype=np.float64)
        spins, motions = self._native.spins(np.ascontiguousarray(at).ravel())
        balls = len(self.ball_ids)
        return spins.reshape((*at.shape, balls, 3)), motions.reshape((*at.shape, balls))

    def energy(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the kinetic energy at `times`, (n_times,) float64, in mass × (length per time)².

        In a field it is not conserved by itself: the energy that `diagnostics` speaks of is the sum of this and
        `potential_energy`.
        """
        at = np.asarray(times, dtype=np.float64)
        return self._native.energy(np.ascontiguousarray(at).ravel()).reshape(at.shape)

    def potential_energy(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the potential energy at `times`, (n_times,) float64, in mass × (length per time)².

        In a field it is zero for balls at the origin, on a cloth for balls that lie on it, else everywhere.
        """
        at = np.asarray(times, dtype=np.float64)
        return self._native.potential_energy(np.ascontiguousarray(at).ravel()).reshape(at.shape)

    def momentum(self, times: ArrayLike) -> NDArray[np.float64]:
        """Give the total momentum at `times`, (n_times, 2) float64, in mass × length per time; 3 numbers on a cloth."""
        at = np.asarray(times, dtype=np.float64)
        momentum = self._native.momentum(np.ascontiguousarray(at).ravel())
        return momentum.reshape((*at.shape, *momentum.shape[1:]))

    def sample_times(self, step: float) -> NDArray[np.float64]:
        """Give the times 0, `step`, 2 `step` and so on, and the end of the run; (n_times,) float64.

        Raises
        ------
        ValueError
            When `step` is not positive and finite, or would make more than 1e8 times.
        """
        if not 0 < step < np.inf:
            raise ValueError(f"step: must be positive and finite, got {step!r}")
        if self.end_time > MOST_TIMES * step:
            raise ValueError(f"step: {step!r} would make more than {MOST_TIMES:g} times up to {self.end_time:g}")
        times = np.arange(int(self.end_time / step) + 1) * step
        return np.append(times[times < self.end_time], self.end_time)

    def trajectory(self, times: ArrayLike) -> ColumnTable:
        """Give the motion as a table: ``time``, and per ball ``<id>.x``, ``<id>.y``, ``<id>.vx``, ``<id>.vy``.

        On a cloth each ball has ``x, y, z``, the velocity ``vx, vy, vz``, the spin ``wx, wy, wz`` and the word
        ``motion`` (see `Run.motion`); the numbers of a ball out of play are NaN.

        Parameters
        ----------
        times : float or (n_times,) array of float
            One row each, in any order.
        """
        at = np.atleast_1d(np.asarray(times, dtype=np.float64))
        if at.ndim > 1:
            raise ValueError(f"times: must be a number or a list of them, got the shape {at.shape}")
        vectors = dict(zip(("", "v"), self.states(at), strict=True))
        motion = None
        if self.is_on_cloth:
            vectors["w"], motion = self.spins(at), self.motion(at)
        columns: dict[str, NDArray[Any]] = {"time": at}
        for ball, name in enumerate(self.ball_ids):
            for letter, vector in vectors.items():
                axes = "xyz"[: vector.shape[-1]]
                columns |= {f"{name}.{letter}{axis}": vector[:, ball, place] for place, axis in enumerate(axes)}
            if motion is not None:
                columns[f"{name}.motion"] = motion[:, ball]
        return ColumnTable(columns)

    def final_scenario(self) -> Scenario:
        """Give the scenario that goes on from the end of this run, without a shot.

        The balls are where they lie, and move as they do then, if they still do; those out of play are left out, and
        so is the rack. A gas becomes a table with balls, and on a periodic table each ball lies inside. Everything
        else is kept.

        Raises
        ------
        ScenarioError
            When no ball is left.
        """
        return Scenario._of(self._native.final_scenario())

    def next(self, shot: Shot | Mapping[str, Any] | None = None, **keys: Any) -> Run:
        """Run the next shot, from where the balls lie: the same as ``final_scenario().with_shot(shot).run()``.

        Parameters
        ----------
        shot : Shot, optional
            The shot.
        **keys
            The keys of the shot, if it is not given as one.

        Raises
        ------
        ScenarioError
            When the shot does not fit: when the cue ball is out of play, for instance.
        """
        rest = self.final_scenario()
        try:
            return rest.with_shot(shot, **keys).run()
        except ScenarioError as error:
            out = ", ".join(name for name in self.ball_ids if name not in rest.ball_ids)
            hint = f"; out of play: {out}; final_scenario().with_ball(...) puts one back" if out else ""
            told = [(place, message + hint * (place == "shot.cue_ball")) for place, message in error.problems]
            raise ScenarioError(told) from None

    def resume(
        self, *, duration: float | None = None, collisions: int | None = None, max_events: int | None = None
    ) -> Run:
        """Give a longer run that goes on where this one ended: the same bits as one run to the new end.

        The new ends are counted from the start of this run, and take the place of its own: those of them that are not
        given are none, so that `collisions` alone goes on however long it takes.

        Parameters
        ----------
        duration : float, optional
            Go on to this time.
        collisions : int, optional
            Go on to this many collisions in all; a run that has them already is given as it is.
        max_events : int, optional
            Go on to this many events in all at most, beside one of the other two.

        Raises
        ------
        ScenarioError
            When neither `duration` nor `collisions` is given, or when the run has come farther than `duration`.
        RunError
            When the run was made with another version of the physics.
        """
        options = {"duration": duration, "collisions": collisions, "max_events": max_events}
        return Run(self._native.resume(options_json(options)))

    def verify(self) -> Verification:
        """Compute the run again and compare it bit for bit."""
        return Verification(**json.loads(self._native.verify()))

    def to_json(self) -> str:
        """Give the run as JSON text, floats exact."""
        return self._native.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the run to `path` as JSON; `carom.load_run` reads it.

        It holds the run, not what was measured of it: ``run.observables.save`` writes that into files of its own.
        """
        write_text(path, self.to_json() + "\n")

    def plot_paths(self, ax: Axes | None = None, *, numbers: bool | None = None) -> Axes:
        """Draw the paths of the balls; see `carom.figures`."""
        from carom import figures

        return figures.plot_paths(self, ax=ax, numbers=numbers)

    def plot_energy(self, ax: Axes | None = None) -> Axes:
        """Draw the energy over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_energy(self, ax=ax)

    def plot_speed(self, ax: Axes | None = None) -> Axes:
        """Draw the speeds of the balls over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_speed(self, ax=ax)

    def plot_spin(self, ax: Axes | None = None) -> Axes:
        """Draw how fast the balls on a cloth turn over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_spin(self, ax=ax)

    def plot_height(self, ax: Axes | None = None) -> Axes:
        """Draw how high the balls on a cloth fly over it, over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_height(self, ax=ax)

    def plot_momentum(self, ax: Axes | None = None) -> Axes:
        """Draw the total momentum over time; see `carom.figures`."""
        from carom import figures

        return figures.plot_momentum(self, ax=ax)

    def filmstrip(
        self,
        around: Event | None = None,
        *,
        frames: int = 3,
        axes: Sequence[Axes] | None = None,
        arrows: bool = True,
        contact_axes: bool = True,
        closeup: bool | None = None,
    ) -> list[Axes]:
        """Draw an event before, during and after; see `carom.figures`."""
        from carom import figures

        return figures.filmstrip(
            self,
            around=around,
            frames=frames,
            axes=axes,
            arrows=arrows,
            contact_axes=contact_axes,
            closeup=closeup,
        )

    def animate(
        self,
        path: str | os.PathLike[str],
        *,
        fps: float = 30.0,
        speed: float = 1.0,
        size: int = 640,
        trail: float | None = None,
        progress: bool | None = None,
    ) -> Path:
        """Write a film of the run to `path`; see `carom.animation`."""
        from carom import animation

        return animation.animate(self, path, fps=fps, speed=speed, size=size, trail=trail, progress=progress)

    def report(self, path: str | os.PathLike[str], *, figures: bool = True) -> None:
        """Write all there is to know of the run to `path`, as one HTML file that needs nothing else.

        It holds the parameters, the events, the diagnostics, the figures, the digest, the versions, and how to
        reproduce the run. The same run gives the same bytes.

        Parameters
        ----------
        path : path-like
            Where to.
        figures : bool
            Draw the figures of what the run kept.
        """
        from carom.report import write_report

        write_report(self, path, pictures=None if figures else {})

    def player(self, path: str | os.PathLike[str] | None = None) -> Player:
        """Give a page that plays the run: the table, a time line and the events, without network and without Carom.

        It is one HTML file, and the same run gives the same bytes. A notebook shows it, and shows it below a run, too,
        where it is not too large.

        Parameters
        ----------
        path : path-like, optional
            Where to write it.

        Raises
        ------
        RunError
            When the run kept no flights or steps, or is too large for a browser.
        CaromError
            When this installation was made without the page.
        """
        from carom.studio import player_of

        player = player_of(self)
        if path is not None:
            player.save(path)
        return player

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Run):
            return NotImplemented
        if (self.status, self.end_time, self.digest) != (other.status, other.end_time, other.digest):
            return False
        one, two = self.to_json(), other.to_json()
        return one == two or _outcome(one) == _outcome(two)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Callable[[str, Observables], Run], tuple[str, Observables]]:
        return _from_json, (self.to_json(), self.observables)

    def __repr__(self) -> str:
        from carom.summary import summary_of_run

        return summary_of_run(self)

    def _repr_html_(self) -> str:
        from carom.report import run_card

        return run_card(self)


def load_run(path: str | os.PathLike[str]) -> Run:
    """Read a run that `Run.save` wrote.

    Raises
    ------
    RunError
        When there is no such file, or it holds no saved run; the file is named.
    """
    text = read_text(path, RunError, "a saved run")
    try:
        return _from_json(text)
    except RunError as error:
        raise RunError(f"{path}: {error}") from None


def _outcome(text: str) -> str:
    """Give a saved run without what it says of its own computation, which another way to it changes."""
    values: dict[str, Any] = json.loads(text)
    return json.dumps({key: value for key, value in values.items() if key not in ("diagnostics", "carom")})


def _from_json(text: str, observables: Observables | None = None) -> Run:
    return Run(_engine.Run.from_json(text), observables)
