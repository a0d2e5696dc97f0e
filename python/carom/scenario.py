"""Scenarios: everything a run needs, checked and immutable."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import _engine, library
from carom import arrays as np
from carom.ball import Ball
from carom.balls_from import parse
from carom.encoding import plain, to_json
from carom.errors import ScenarioError
from carom.files import write_text
from carom.options import Record, check_counts, options_json

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from carom.best_aim import BestAim
    from carom.cue import Cue, Shot
    from carom.ensemble import Design, Ensemble, Grid, Invalid, Varied
    from carom.events import Event
    from carom.goal import Goal
    from carom.method import Method
    from carom.noise import ExecutionNoise, Success
    from carom.observables import Progress, Request
    from carom.physics import Physics
    from carom.progress import Progress as RunsProgress
    from carom.rack import Rack
    from carom.recording import Checkpoints, EventStream, Snapshots
    from carom.run import Run
    from carom.simulation import Simulation
    from carom.table import Table
    from carom.tolerance import Tolerance


class Scenario:
    """A table, balls and laws, checked; it never changes, and compares, hashes, copies and pickles.

    Parameters
    ----------
    table : Table
        The region the balls move in.
    balls : sequence of Ball, optional
        The balls; at least one, unless there is a rack.
    physics : Physics, optional
        The laws; absent: those of the table's preset, or free flight and elastic collisions.
    rack : Rack, optional
        Balls set up for a game.
    shot : Shot, optional
        A stroke of the cue at time 0.
    cue : Cue, optional
        The cue; absent: that of the table's preset, or a pool cue.
    duration : float, optional
        How long a run goes on, in time. With neither this nor `collisions` it goes on until everything rests.
    **more
        Any other key of a scenario file: `title`, `description`, `collisions`, `max_events`, `record`,
        `method`, `ball_defaults`, `units`.

    Raises
    ------
    ScenarioError
        When the scenario does not hold together; it lists every problem with its place.
    TypeError
        When `collisions` or `max_events` is no int.

    Examples
    --------
    >>> import carom
    >>> table = carom.Table.rectangle(width=1, length=2)
    >>> red = carom.Ball("red", radius=0.075, position=(0.1, 0.1), velocity=(3, 4))
    >>> carom.Scenario(table, [red], duration=5).ball_ids
    ['red']
    >>> pool, rack = carom.Table.preset("pool_9ft"), carom.Rack("nine_ball", seed=7)
    >>> carom.Scenario(pool, rack=rack, shot=carom.Shot(V0=8, phi_deg=91)).run().status
    'at_rest'
    """

    __slots__ = ("_native",)
    _native: _engine.Scenario

    def __init__(
        self,
        table: Table | Mapping[str, Any],
        balls: Sequence[Ball | Mapping[str, Any]] | None = None,
        *,
        physics: Physics | Mapping[str, Any] | None = None,
        rack: Rack | Mapping[str, Any] | None = None,
        shot: Shot | Mapping[str, Any] | None = None,
        cue: Cue | Mapping[str, Any] | None = None,
        duration: float | None = None,
        **more: Any,
    ) -> None:
        keys: dict[str, Any] = {
            "table": table,
            "balls": balls,
            "physics": physics,
            "rack": rack,
            "shot": shot,
            "cue": cue,
        }
        keys |= {"duration": duration, **more}
        given = {name: value for name, value in keys.items() if value is not None}
        check_counts(given)
        self._native = parse(to_json(given), "json")

    @classmethod
    def _of(cls, native: _engine.Scenario) -> Scenario:
        scenario = cls.__new__(cls)
        scenario._native = native
        return scenario

    @classmethod
    def load(cls, source: str | os.PathLike[str]) -> Scenario:
        """Load a ready-made scenario by name, or a file by path; see `carom.load`."""
        return cls._load(source, {})

    @classmethod
    def _load(cls, source: str | os.PathLike[str], values: Mapping[str, Any]) -> Scenario:
        """Load a scenario with some values changed before a file of balls is read."""
        text, form = library.text_of(source)
        try:
            return cls._of(parse(text, form, library.folder_of(source), values))
        except ScenarioError as error:
            if {"physics_version", "digest"} <= {place for place, _ in error.problems}:
                raise ScenarioError(f"{source}: a saved run, not a scenario; load_run and verify take it") from None
            raise ScenarioError([(_in_file(source, place), message) for place, message in error.problems]) from None

    @classmethod
    def from_toml(cls, text: str) -> Scenario:
        """Read a scenario from TOML text; the path of a file of balls is relative to the working folder."""
        return cls._of(parse(text, "toml"))

    @classmethod
    def from_json(cls, text: str) -> Scenario:
        """Read a scenario from JSON text; the path of a file of balls is relative to the working folder."""
        return cls._of(parse(text.removeprefix("\ufeff"), "json"))

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Scenario:
        """Read a scenario from a mapping with the keys of a scenario file; NumPy values are welcome."""
        return cls.from_json(to_json(values))

    @classmethod
    def from_arrays(
        cls,
        table: Table | Mapping[str, Any],
        positions: ArrayLike,
        velocities: ArrayLike | None = None,
        *,
        radii: ArrayLike,
        masses: ArrayLike = 1.0,
        ids: Sequence[str] | None = None,
        **more: Any,
    ) -> Scenario:
        """Put a scenario together from arrays with a row for each ball.

        Parameters
        ----------
        table : Table
            The region the balls move in.
        positions : (n_balls, 2) array_like
            Centres, in length.
        velocities : (n_balls, 2) array_like, optional
            Velocities, in length per time; absent: at rest.
        radii, masses : float or (n_balls,) array_like
            Radii, in length, and masses, 1 if they are not given; a single number is that of all balls.
        ids : sequence of str, optional
            The names of the balls; absent: "0", "1", ...
        **more
            Any other key of a scenario, as `Scenario` takes them.

        Raises
        ------
        ValueError
            When the arrays do not have these shapes, with the name of the one that does not.
        ScenarioError
            When the scenario does not hold together.

        Examples
        --------
        >>> import carom
        >>> table = carom.Table.rectangle(width=1, length=1, periodic=("x", "y"))
        >>> carom.Scenario.from_arrays(table, [[0.2, 0.2], [0.8, 0.5]], radii=0.1, duration=1).ball_ids
        ['0', '1']
        """
        places = np.asarray(positions, dtype=float)
        if places.ndim != 2 or places.shape[1] != 2:
            raise ValueError(f"positions: must have the shape (n_balls, 2), got {places.shape}")
        count = len(places)
        given = {
            "id": _rows("ids", [str(ball) for ball in range(count)] if ids is None else list(ids), (count,)),
            "radius": _rows("radii", radii, (count,)),
            "mass": _rows("masses", masses, (count,)),
            "position": places.tolist(),
            "velocity": _rows("velocities", np.zeros(2) if velocities is None else velocities, (count, 2)),
        }
        balls = [dict(zip(given, row, strict=True)) for row in zip(*given.values(), strict=True)]
        return cls(table, balls, **more)

    @classmethod
    def check(cls, source: str | os.PathLike[str] | Mapping[str, Any]) -> list[tuple[str, str]]:
        """Give every problem of a scenario as (place, message); none means that it holds together.

        Parameters
        ----------
        source : str, path-like or mapping
            What `load` or `from_dict` takes.
        """
        try:
            cls.from_dict(source) if isinstance(source, Mapping) else cls.load(source)
        except ScenarioError as error:
            return error.problems
        return []

    def to_toml(self) -> str:
        """Give the scenario as TOML text in its canonical form."""
        return self._native.to_toml()

    def to_json(self) -> str:
        """Give the scenario as JSON text in its canonical form; equal scenarios give equal text."""
        return self._native.to_json()

    def to_dict(self) -> dict[str, Any]:
        """Give the scenario as a new dict, as its JSON text says it."""
        values: dict[str, Any] = json.loads(self.to_json())
        return values

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the scenario to `path`, as TOML or JSON by its suffix."""
        form = library.format_of(Path(path))
        write_text(path, self.to_toml() if form == "toml" else self.to_json() + "\n")

    @property
    def title(self) -> str:
        """The title; empty where there is none."""
        return str(self.to_dict().get("title", ""))

    @property
    def description(self) -> str:
        """What the scenario shows; empty where it does not say."""
        return str(self.to_dict().get("description", ""))

    @property
    def units(self) -> dict[str, str]:
        """The names of the units (``length``, ``time``, ``mass``) that the scenario or its preset names."""
        names: dict[str, str] = json.loads(self._native.units())
        return names

    @property
    def is_on_cloth(self) -> bool:
        """Whether the balls are spheres that roll and spin on a cloth, and no discs."""
        return self._native.is_on_cloth

    @property
    def record(self) -> Record:
        """What a run keeps: ``all``, ``events`` or ``none``."""
        return self._native.record

    @property
    def balls(self) -> list[Ball]:
        """The balls in order, those of the rack or the gas too, each with its radius, mass and velocity filled in.

        On a cloth places and velocities have three numbers and spins are filled in too: as they are before the cue
        strikes.
        """
        return [Ball(**ball) for ball in json.loads(self._native.balls())]

    @property
    def ball_ids(self) -> list[str]:
        """The ids of the balls, in order."""
        return [ball.id for ball in self.balls]

    def value(self, path: str) -> Any:
        """Give one value by its path, such as ``"balls.red.velocity[0]"``."""
        return json.loads(self._native.value(path))

    def with_values(self, values: Mapping[str, Any]) -> Scenario:
        """Give a scenario with some values changed, each named by its path.

        Examples
        --------
        >>> import carom
        >>> faster = carom.load("midterm").with_values({"balls.red.velocity[0]": 3.1, "duration": 10})
        >>> faster.value("balls.red.velocity[0]")
        3.1
        """
        if not isinstance(values, Mapping):
            raise TypeError(f"values: must be a mapping of paths to values, got {values!r}")
        return type(self)._of(self._native.with_values(to_json(values)))

    def with_shot(self, shot: Shot | Mapping[str, Any] | None = None, **keys: Any) -> Scenario:
        """Give the scenario with a shot in place of the one it has.

        Parameters
        ----------
        shot : Shot, optional
            The shot.
        **keys
            The keys of the shot, if it is not given as one.

        Raises
        ------
        ScenarioError
            When the shot does not fit: at a ball that is not there or that moves already, for instance.
        TypeError
            When both or neither are given.

        Examples
        --------
        >>> import carom
        >>> table = carom.Table.preset("pool_9ft")
        >>> scenario = carom.Scenario(table, [carom.Ball("cue", position=(0.6, 0.6))])
        >>> scenario.with_shot(V0=2, phi_deg=90).value("shot.V0")
        2.0
        """
        if (shot is None) == (not keys):
            raise TypeError("with_shot: needs a carom.Shot or its keys, such as V0=2, phi_deg=90")
        return self.with_values({"shot": keys if shot is None else shot})

    def with_ball(self, ball: Ball | Mapping[str, Any]) -> Scenario:
        """Give the scenario with a ball in place of the one with its id, or added where there is none.

        Of a ball of the rack, what is given here goes before what the rack says.

        Examples
        --------
        >>> import carom
        >>> table = carom.Table.preset("pool_9ft")
        >>> scenario = carom.Scenario(table, [carom.Ball("cue", position=(0.6, 0.6))])
        >>> scenario.with_ball(carom.Ball("1", position=(0.6, 1.2))).ball_ids
        ['cue', '1']
        """
        values = self.to_dict()
        written: list[Any] = values.get("balls", [])
        new = plain(ball)
        balls = [new if one["id"] == new.get("id") else one for one in written]
        return type(self).from_dict({**values, "balls": balls if new in balls else [*balls, new]})

    def expanded(self) -> Scenario:
        """Give the same scenario with its preset, its rack and its gas in plain keys.

        Examples
        --------
        >>> import carom
        >>> carom.Scenario(carom.Table.preset("pool_9ft"), rack=carom.Rack("nine_ball")).expanded().value("table.width")
        1.27
        """
        return type(self)._of(self._native.expanded())

    def outline(self) -> dict[str, Any]:
        """Give what there is to draw of the table.

        Returns
        -------
        dict
            ``bounds`` is [x_min, y_min, x_max, y_max]; ``size`` the table's size; ``pieces`` a list of lines
            (``start``, ``end``) and arcs (``center``, ``radius``, ``from_deg``, ``to_deg``), each with ``id``,
            ``kind`` and ``part`` (``boundary``, ``obstacle``, or ``periodic`` for an open side); ``pockets`` a list
            of ``id``, ``center`` and ``radius``.
        """
        outline: dict[str, Any] = json.loads(self._native.outline())
        return outline

    def run(
        self,
        *,
        method: Method | Mapping[str, Any] | None = None,
        duration: float | None = None,
        collisions: int | None = None,
        max_events: int | None = None,
        record: Record | None = None,
        until: str | Callable[[Event], bool] | None = None,
        observe: Request | Sequence[Request] | None = None,
        equilibrate: float | None = None,
        sample_interval: float | None = None,
        snapshots: Snapshots | None = None,
        events: EventStream | None = None,
        checkpoints: Checkpoints | str | os.PathLike[str] | None = None,
        progress: Progress | None = None,
    ) -> Run:
        """Compute the run; what is given here goes before what the scenario says.

        Parameters
        ----------
        method : Exact or Stepped, optional
            How to compute it.
        duration : float, optional
            End at this time.
        collisions : int, optional
            End after this many collisions of balls with balls and cushions.
        max_events : int, optional
            End after this many events of any kind.
        record : "all", "events" or "none", optional
            What to keep.
        until : str or callable, optional
            End with the first event of this kind, or with the first event for which the function is true;
            the run's status is then ``stopped``. A function needs the exact method, a kind does not.
        observe : sequence of str or mapping, optional
            What to measure of a gas of discs while it runs, for `Run.observables`: names, or mappings of `name` and
            options, such as ``{"name": "radial_distribution", "range": 3}``. It moves no trajectory.
        equilibrate : float, optional
            Collisions of each disc with others before measuring begins; absent: none. They count for the limits.
        sample_interval : float, optional
            The time between samples; absent: that of ten collisions of each disc.
        snapshots : Snapshots, optional
            A file of snapshots of a gas of discs, written while it runs, and when they come.
        events : EventStream, optional
            A file of the events of a span of time, written while the gas runs.
        checkpoints : Checkpoints or path-like, optional
            A file from which `carom.resume` goes on with the run, whatever ends it.
        progress : callable, optional
            Called now and then with the time, the collisions and the samples so far; what is true ends the run, with
            status ``interrupted`` and what was measured so far. Only with one of the four before.

        Raises
        ------
        ScenarioError
            When the options do not fit the scenario, or each other; when it is no gas in a rectangle that can be
            observed, or the run ends before there are two samples.
        SimulationError
            When the run breaks one of its own invariants.
        RecordError
            When a file of snapshots or events is there already, or cannot be written.
        KeyboardInterrupt
            On Ctrl-C; of the run remains what was written on the way, with a checkpoint if there are any.
        """
        from carom.run import Run

        options: dict[str, Any] = {"method": method, "duration": duration, "collisions": collisions}
        options |= {"max_events": max_events, "record": record}
        measuring = {"equilibrate": equilibrate, "sample_interval": sample_interval}
        files = {"snapshots": snapshots, "events": events, "checkpoints": checkpoints}
        if observe is None and (given := [name for name, value in measuring.items() if value is not None]):
            raise TypeError(f"{given[0]}: belongs to observe=[...], and nothing is observed")
        if observe is not None or any(value is not None for value in files.values()):
            if callable(until):
                raise TypeError("until: must be a kind of event where something is observed or written")
            from carom.observing import observed, recorded

            watched = {**options, "until": until}
            return observed(self, watched, observe or (), (equilibrate, sample_interval), recorded(**files), progress)
        if progress is not None:
            raise TypeError("progress: belongs to observe=[...], snapshots, events or checkpoints, and there is none")
        if callable(until):
            return self._start(options).run_until_true(until)
        return Run(self._native.run(options_json({**options, "until": until})))

    def ensemble(
        self,
        varied: Varied | Grid,
        outcomes: Sequence[str] = ("final_position",),
        *,
        functions: Mapping[str, Callable[[Run], Any]] | None = None,
        runs: int | None = None,
        design: Design = "independent",
        seed: int = 0,
        threads: int | None = None,
        invalid: Invalid = "error",
        progress: RunsProgress | bool | None = None,
        equilibrate: float = 0.0,
        sample_interval: float | None = None,
    ) -> Ensemble:
        """Run many variations of this scenario, on all cores; each has the bits of a run by itself.

        Parameters
        ----------
        varied : mapping of str to (n_runs,) array_like, Uniform or Normal; or Grid
            The numbers at paths such as ``balls.red.speed``, ``shot.a`` or ``physics.ball_cushion.normal``. What a
            run draws depends on its row, the seed and the path, and on nothing else.
        outcomes : sequence of str, optional
            What to keep of each run: ``end_time``; ``events``, the count of each kind; ``first_event`` and
            ``last_event``, their times; ``final_position`` and ``final_velocity`` of each ball; on a cloth
            ``final_spin``, and ``pockets``, which each ball is in; ``distance``, the length of each ball's way;
            ``closest_approach.A.B`` of two balls, between their centres; of gases what can be observed, such as
            ``pressure``, each number with its standard error. The status is kept in any case.
        functions : mapping of str to callable, optional
            More columns: what these functions give for each `Run` that has an outcome. They take much longer, one run
            after the other, when all rows are run.
        runs : int, optional
            The number of runs; needed where everything is drawn.
        design : "independent", "latin_hypercube" or "sobol", optional
            How the rows of what is drawn lie.
        seed : int, optional
            The seed of what is drawn.
        threads : int, optional
            On how many threads; absent: as many as there are cores. It changes no bit.
        invalid : "error" or "keep", optional
            What to do about rows whose numbers make no scenario.
        progress : bool or callable, optional
            With true a bar on stderr, where that is a terminal, or in a notebook. A function is called now and then
            with the number of runs done and of all; what is true ends the ensemble. Either counts anew while
            `functions` are called, up to the number of runs that have outcomes.
        equilibrate, sample_interval : float, optional
            When gases are observed; see `run`.

        Returns
        -------
        Ensemble
            A row for each run, with columns for the balls of this scenario; what a row has beyond them, with a larger
            ``gas.n``, has none. After Ctrl-C, or where `progress` ends it, rows that are left say ``not_run``, and what
            functions were not called for is None.

        Raises
        ------
        ScenarioError
            When a path leads to no number, lists differ in length, a distribution makes no sense, or rows make no
            scenario.
        RuntimeError
            When one of `functions` raises an exception, which is its cause.

        Examples
        --------
        >>> import carom
        >>> grid = carom.Grid({"balls.red.speed": [4, 5], "balls.red.direction_deg": [40, 50, 60]})
        >>> hits = carom.load("midterm").ensemble(grid, ["events"])
        >>> hits["events.ball_ball"].reshape(grid.shape).tolist()
        [[1, 1, 2], [2, 2, 2]]
        """
        from carom.ensemble import ensemble

        return ensemble(
            self,
            varied,
            outcomes,
            functions or {},
            runs=runs,
            design=design,
            seed=seed,
            threads=threads,
            invalid=invalid,
            progress=progress,
            equilibrate=equilibrate,
            sample_interval=sample_interval,
        )

    def success(
        self,
        goal: Goal,
        noise: ExecutionNoise,
        *,
        runs: int = 1000,
        outcomes: Sequence[str] = ("pockets",),
        seed: int = 0,
        level: float = 0.95,
        threads: int | None = None,
        progress: RunsProgress | bool | None = None,
    ) -> Success:
        """Tell how likely this shot meets a goal, played by someone whose strokes scatter.

        Parameters
        ----------
        goal : str or callable
            A ball that is to be in a pocket while the cue ball is not; or a function that gets the `Ensemble` of the
            runs and gives (n_runs,) booleans.
        noise : ExecutionNoise
            How far the strokes scatter.
        runs : int, optional
            How many strokes to try.
        outcomes : sequence of str, optional
            The outcomes that a function needs; see `ensemble`.
        seed : int, optional
            The seed of the strokes.
        level : float, optional
            How sure the interval is, between 0 and 1.
        threads : int, optional
            On how many threads; absent: as many as there are cores.
        progress : bool or callable, optional
            As in `ensemble`.

        Returns
        -------
        Success
            After Ctrl-C, or where `progress` ends it, it is of the strokes that were finished.

        Raises
        ------
        ScenarioError
            When there is no shot, or no such ball.
        TypeError
            When a function gives no booleans.
        KeyboardInterrupt
            When no stroke was finished.

        Examples
        --------
        >>> import carom
        >>> noise = carom.ExecutionNoise.preset("pool_tournament")
        >>> pot = carom.load("two_ball_shot").success("1", noise, runs=200)
        >>> 0 <= pot.low <= pot.probability <= pot.high <= 1
        True
        """
        from carom.noise import success

        return success(
            self,
            goal,
            noise,
            runs=runs,
            outcomes=outcomes,
            seed=seed,
            level=level,
            threads=threads,
            progress=progress,
        )

    def best_aim(
        self,
        aims: Mapping[str, ArrayLike] | Grid,
        goal: Goal,
        noise: ExecutionNoise,
        *,
        runs: int = 200,
        outcomes: Sequence[str] = ("pockets",),
        seed: int = 0,
        level: float = 0.95,
        threads: int | None = None,
        progress: RunsProgress | bool | None = None,
    ) -> BestAim:
        """Find what to mean so that a goal is met most often, for someone whose strokes scatter.

        At each point of a grid of shots the goal is met as often as `success` says there with the same seed. So all
        points have the same luck, and differ by what is meant.

        Parameters
        ----------
        aims : mapping of str to (n,) array_like, or Grid
            The numbers to try at paths such as ``shot.phi_deg``, each with each of the others.
        goal : str or callable
            As of `success`. A function gets the runs of several points at once, and judges them row by row.
        noise : ExecutionNoise
            How far the strokes scatter about each point.
        runs : int, optional
            How many strokes to try at each point.
        outcomes, seed, level, threads
            As of `success`.
        progress : bool or callable, optional
            As in `ensemble`; what is true ends the search.

        Returns
        -------
        BestAim
            The best point, and the table of all. After Ctrl-C, or where `progress` ends it, the best of those points
            that were finished.

        Raises
        ------
        ScenarioError
            When there is no shot or no such ball, a path leads to no number of the shot, the grid is empty, or a stroke
            makes no scenario.
        TypeError
            When a function gives no booleans.
        KeyboardInterrupt
            When it was ended before any point was finished.

        Examples
        --------
        >>> import carom
        >>> noise = carom.ExecutionNoise.preset("pool_tournament")
        >>> shot = carom.load("two_ball_shot")
        >>> best = shot.best_aim({"shot.phi_deg": [85, 90, 95]}, "1", noise, runs=20)
        >>> best.hits == best.scenario.success("1", noise, runs=20).hits
        True
        """
        from carom.best_aim import best_aim

        return best_aim(
            self,
            aims,
            goal,
            noise,
            runs=runs,
            outcomes=outcomes,
            seed=seed,
            level=level,
            threads=threads,
            progress=progress,
        )

    def tolerance(
        self,
        reach: Mapping[str, float],
        goal: Goal,
        noise: ExecutionNoise | None = None,
        *,
        cells: int = 50,
        steps: int = 500,
        outcomes: Sequence[str] = ("pockets",),
        threads: int | None = None,
    ) -> Tolerance:
        """Tell how far off this shot may be before a goal is missed.

        Parameters
        ----------
        reach : mapping of str to float
            How far to look on either side of the meant shot, at two paths such as ``shot.phi_deg``.
        goal : str or callable
            As of `success`.
        noise : ExecutionNoise, optional
            What the map shows the ellipses of; the shots themselves have none.
        cells : int, optional
            So many cells the map has on either side of the meant shot.
        steps : int, optional
            In so many steps on either side it is found how far each number alone may be off.
        outcomes, threads
            As of `success`.

        Returns
        -------
        Tolerance
            The margins of each number, and the table of the map. After Ctrl-C the map may have holes.

        Raises
        ------
        ScenarioError
            When there is no shot or no such ball, or a path leads to no number of the shot.
        ValueError
            When there are not two numbers, or no cells or steps.
        TypeError
            When a function gives no booleans.

        Examples
        --------
        >>> import carom
        >>> shot = carom.load("two_ball_shot")
        >>> found = shot.tolerance({"shot.V0": 0.5, "shot.phi_deg": 1}, "1", cells=3, steps=20)
        >>> list(found.margins), len(found.table)
        (['shot.V0', 'shot.phi_deg'], 49)
        """
        from carom.tolerance import tolerance

        return tolerance(self, reach, goal, noise, cells=cells, steps=steps, outcomes=outcomes, threads=threads)

    def start(
        self,
        *,
        method: Method | Mapping[str, Any] | None = None,
        duration: float | None = None,
        collisions: int | None = None,
        max_events: int | None = None,
        record: Record | None = None,
    ) -> Simulation:
        """Start a run that is taken one event at a time, with the exact method; the options are those of `run`."""
        options: dict[str, Any] = {"method": method, "duration": duration, "collisions": collisions}
        return self._start({**options, "max_events": max_events, "record": record})

    def _start(self, options: Mapping[str, Any]) -> Simulation:
        from carom.simulation import Simulation

        return Simulation(self._native.start(options_json(options)))

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the table and the balls as they start; see `carom.figures`."""
        from carom import figures

        return figures.plot_scenario(self, ax=ax)

    def __eq__(self, other: object) -> bool:
        return self.to_json() == other.to_json() if isinstance(other, Scenario) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __reduce__(self) -> tuple[Callable[[str], Scenario], tuple[str]]:
        return type(self).from_json, (self.to_json(),)

    def __repr__(self) -> str:
        from carom.summary import summary_of_scenario

        return summary_of_scenario(self)

    def _repr_html_(self) -> str:
        from carom.report import scenario_card

        return scenario_card(self)


def _rows(name: str, values: ArrayLike, shape: tuple[int, ...]) -> list[Any]:
    """Give an array of a shape as lists; what holds for all rows is repeated."""
    try:
        rows: list[Any] = np.broadcast_to(np.asarray(values), shape).tolist()
    except ValueError:
        raise ValueError(f"{name}: must have the shape {shape}, got {np.shape(values)}") from None
    return rows


def _in_file(source: str | os.PathLike[str], place: str) -> str:
    """Name the file where a place is a line of it; the path of a value says enough by itself."""
    return f"{source}: {place}" if place.startswith("line ") else place


def load(source: str | os.PathLike[str]) -> Scenario:
    """Load a scenario.

    Parameters
    ----------
    source : str or path-like
        The name of a ready-made scenario (`carom.scenarios` lists them); with a slash or a suffix, or as a path
        object, the path of a ``.toml`` or ``.json`` file.

    Raises
    ------
    ScenarioError
        When there is no such scenario, naming the nearest ones, or when it does not hold together.
    """
    return Scenario.load(source)
