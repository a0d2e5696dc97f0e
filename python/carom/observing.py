"""Runs of gases that are looked at while they go on: what they hand out is written, and they can be gone on with."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import _engine
from carom.encoding import to_json
from carom.errors import RecordError, RunError, ScenarioError
from carom.files import replacing, sweep
from carom.observables import Observables, Progress, Request
from carom.options import check_finite, options_json
from carom.recording import CHECKPOINT, EVERY, Checkpoints, EventStream, Snapshots
from carom.run import Run
from carom.scenario import Scenario

if TYPE_CHECKING:
    from carom.records import EventWriter, GsdWriter, ParquetWriter
    from carom.records import ExtendedXyzWriter as XyzWriter

    Writer = GsdWriter | XyzWriter | ParquetWriter


class Recorder:
    """What writes all that a run hands out, and the run itself now and then.

    Parameters
    ----------
    native : _engine.ObservedRun
        The run.
    snapshots, events : Snapshots, EventStream or None
        What is written on the way.
    checkpoints : Checkpoints or None
        Where the run itself is written.
    append : bool
        Whether the files of snapshots and events go on.
    """

    def __init__(
        self,
        native: _engine.ObservedRun,
        snapshots: Snapshots | None,
        events: EventStream | None,
        checkpoints: Checkpoints | None,
        *,
        append: bool = False,
    ) -> None:
        self._native = native
        self._files = (snapshots, events, checkpoints)
        self._checkpoints = checkpoints
        self._balls, self._cushions = native.ids()
        # Discs that are called by their numbers need no names in a file.
        is_numbered = all(name == str(number) for number, name in enumerate(self._balls))
        self._ids = None if is_numbered else self._balls
        self._snapshots = None if snapshots is None else _writer(snapshots, append=append)
        self._events = None if events is None else _event_writer(events, append=append)
        self._note = _note(snapshots, events, checkpoints)
        self._saved = time.monotonic()

    def write(self, pause: str) -> None:
        """Write what the run hands out at a pause, and a checkpoint if it is time for one."""
        if pause == "snapshot" and self._snapshots is not None:
            from carom.records import Snapshot

            self._snapshots.write(Snapshot(*self._native.snapshot(), None, self._ids))
        if pause == "events" and self._events is not None:
            from carom.events import event_table

            self._events.write(event_table(self._native.events(), self._balls, self._cushions))
        if self._checkpoints is not None and time.monotonic() - self._saved >= self._checkpoints.every:
            self.save()

    def files(self) -> list[str]:
        """Give the names of the files that are there."""
        return [Path(file.path).name for file in self._files if file is not None and Path(file.path).exists()]

    def save(self) -> None:
        """Write a checkpoint, if there are to be any."""
        if self._checkpoints is None:
            return
        try:
            with replacing(self._checkpoints.path, durable=True) as temporary:
                temporary.write_bytes(self._native.checkpoint(self._note))
        except OSError as error:
            from carom.records.writing import reason_of

            place = os.fspath(self._checkpoints.path)
            raise RecordError([(place, f"not written, {reason_of(error)}; what was there before stays")]) from error
        self._saved = time.monotonic()


Files = tuple[Snapshots | None, EventStream | None, Checkpoints | None]


def recorded(snapshots: object, events: object, checkpoints: object) -> Files:
    """Check what is to be written; a path alone is one of checkpoints."""
    if isinstance(checkpoints, (str, os.PathLike)):
        checkpoints = Checkpoints(checkpoints)
    for name, value, kind in (
        ("snapshots", snapshots, Snapshots),
        ("events", events, EventStream),
        ("checkpoints", checkpoints, Checkpoints),
    ):
        if value is not None and not isinstance(value, kind):
            raise TypeError(f"{name}: must be a carom.{kind.__name__}, got {value!r}")
    return snapshots, events, checkpoints  # type: ignore[return-value]


def observed(
    scenario: Scenario,
    options: Mapping[str, Any],
    observe: Request | Sequence[Request],
    sampling: tuple[float | None, float | None],
    files: Files,
    progress: Progress | None,
) -> Run:
    """Run a scenario, measure it and write what it hands out.

    Parameters
    ----------
    scenario : Scenario
        What is run.
    options : mapping
        What goes before what the scenario says.
    observe : sequence of str or mapping
        What is measured.
    sampling : (float or None, float or None)
        Collisions that are left out, and the interval between samples.
    files : (Snapshots or None, EventStream or None, Checkpoints or None)
        What is written.
    progress : callable or None
        Told now and then how far the run has come.
    """
    asked = [observe] if isinstance(observe, (str, Mapping)) else list(observe)
    snapshots, events, checkpoints = files
    equilibrate, interval = sampling
    for name, value in (("equilibrate", equilibrate), ("sample_interval", interval)):
        if value is not None:
            check_finite(name, value)
    plan = {
        "sampling": {"equilibrate": equilibrate or 0.0, "interval": interval},
        "snapshots": "never" if snapshots is None else snapshots.plan(),
        "window": None if events is None else events.plan(),
    }
    if checkpoints is not None and not checkpoints.overwrite and Path(checkpoints.path).exists():
        advice = "carom.resume goes on with it, overwrite=True replaces it"
        raise ScenarioError([("checkpoints", f"{os.fspath(checkpoints.path)} holds a run already: {advice}")])
    rows = to_json([_request(each) for each in asked])
    native = _engine.ObservedRun.start(scenario._native, options_json(options), rows, to_json(plan))
    recorder = Recorder(native, *files)
    recorder.save()
    return driven(native, recorder, progress)


def resume(
    path: str | os.PathLike[str],
    *,
    duration: float | None = None,
    collisions: int | None = None,
    max_events: int | None = None,
    every: float | None = None,
    progress: Progress | None = None,
) -> Run:
    """Go on with a run from its checkpoint, with the bits that it has at once: what is measured and written, too.

    Files of snapshots and events are cut to what they had at the checkpoint, and go on; as seen from the checkpoint
    they must lie where they lay. A run that had ended needs a later end to go on.

    Parameters
    ----------
    path : path-like
        The checkpoint, or a folder with ``checkpoint.carom`` in it.
    duration, collisions, max_events : optional
        New ends, counted from the start of the run, in place of its own; those of them that are not given are none
        then. Absent: the run's own.
    every : float, optional
        Seconds from one checkpoint to the next; absent: as before.
    progress : callable, optional
        As in `Scenario.run`.

    Raises
    ------
    RunError
        When there is no checkpoint, when it is damaged, and when it is of another version; it says which.
    ScenarioError
        When the new ends do not fit.
    RecordError
        When a file of snapshots or events lacks what it had at the checkpoint.
    """
    options = {"duration": duration, "collisions": collisions, "max_events": max_events}
    return driven(*reopened(path, options, every), progress)


def reopened(
    path: str | os.PathLike[str], options: Mapping[str, Any], every: float | None
) -> tuple[_engine.ObservedRun, Recorder]:
    """Give a run as it was at its checkpoint, and what goes on to write its files; see `resume`."""
    place = Path(path) / CHECKPOINT if Path(path).is_dir() else Path(path)
    if every is not None:
        check_finite("every", every)
    ends = options_json(options)
    try:
        native = _engine.ObservedRun.resume(place.read_bytes(), ends)
    except FileNotFoundError:
        raise RunError(f"{place}: no such file, and a checkpoint is needed to go on") from None
    except RunError as error:
        raise RunError(f"{place}: {error}") from None
    snapshots, events, checkpoints = _files(native.note, place, every)
    frames, rows = native.handed_out()
    for file in (snapshots, events, checkpoints):
        if file is not None:
            sweep(file.path)
    if snapshots is not None:
        from carom.records import cut_frames

        cut_frames(snapshots.path, frames)
    if events is not None:
        from carom.records import cut_events

        cut_events(events.path, rows)
    return native, Recorder(native, snapshots, events, checkpoints, append=True)


def driven(native: _engine.ObservedRun, recorder: Recorder, progress: Progress | None) -> Run:
    """Take a run to its end."""
    try:
        while (pause := native.advance()) != "ended":
            if pause == "progress" and progress is not None and progress(*native.progress()):
                native.stop()
            recorder.write(pause)
    except BaseException:
        with suppress(RecordError, RunError):  # of a run that broke the checkpoint before is the last
            recorder.save()
        raise
    recorder.save()
    run, found = native.finish()
    return Run(run, Observables(found, Scenario._of(run.scenario()).units))


def _writer(snapshots: Snapshots, *, append: bool) -> Writer:
    """Give what writes files of a suffix."""
    from carom import records
    from carom.extras import needed
    from carom.records import gsd, parquet, xyz
    from carom.records.writing import check_suffix

    path = Path(snapshots.path)
    check_suffix(path, (*gsd.SUFFIXES, *xyz.SUFFIXES, *parquet.SUFFIXES))
    overwrite, suffix = snapshots.overwrite and not append, path.suffix.lower()
    if suffix in xyz.SUFFIXES:
        return records.ExtendedXyzWriter(path, overwrite=overwrite, append=append)
    # What is missing is told now, and not after hours by the first frame.
    if suffix in gsd.SUFFIXES:
        needed("gsd", "gas")
        return records.GsdWriter(path, overwrite=overwrite, append=append)
    needed("pyarrow", "data")
    return records.ParquetWriter(path, overwrite=overwrite, append=append)


def _event_writer(events: EventStream, *, append: bool) -> EventWriter:
    from carom.records import EventWriter

    return EventWriter(events.path, overwrite=events.overwrite and not append, append=append)


def _note(snapshots: Snapshots | None, events: EventStream | None, checkpoints: Checkpoints | None) -> str:
    """Give what a checkpoint says of the files, as JSON text: where they lie, as seen from it."""
    if checkpoints is None:
        return ""
    folder = Path(checkpoints.path).resolve().parent

    def place(path: str | os.PathLike[str]) -> str:
        try:
            return Path(os.path.relpath(Path(path).resolve(), folder)).as_posix()
        except ValueError:  # on another drive
            return str(Path(path).resolve())

    values: dict[str, Any] = {"every": checkpoints.every}
    if snapshots is not None:
        values["snapshots"] = {**snapshots.plan(), "path": place(snapshots.path)}
    if events is not None:
        values["events"] = {"window": list(events.window), "path": place(events.path)}
    return to_json(values)


def _files(
    note: str, checkpoint: Path, every: float | None
) -> tuple[Snapshots | None, EventStream | None, Checkpoints]:
    """Give the files of which a checkpoint's note tells."""
    values = json.loads(note) if note else {}
    folder = checkpoint.resolve().parent

    def found(kind: Any, name: str) -> Any:
        if name not in values:
            return None
        given = values[name]
        return kind(**{**given, "path": folder / given["path"]})

    seconds = values.get("every", EVERY) if every is None else every
    return found(Snapshots, "snapshots"), found(EventStream, "events"), Checkpoints(checkpoint, seconds)


def _request(request: Request) -> Mapping[str, Any]:
    if isinstance(request, str):
        return {"name": request}
    if not isinstance(request, Mapping) or not isinstance(request.get("name"), str):
        known = ", ".join(_engine.OBSERVABLES)
        raise TypeError(f"observe: needs names, or mappings with a name, got {request!r}; the names are {known}")
    return request
