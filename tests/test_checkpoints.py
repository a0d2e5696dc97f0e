"""Gases that write snapshots, events and checkpoints while they run, are broken off or killed, and go on."""

from __future__ import annotations

import json
import random
import shutil
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import records
from carom.recording import CHECKPOINT

COLLISIONS = 60_000
NAMES = ["pressure", "psi6", "free_path", "diffusion"]
FORMS = ["gsd", "xyz", "parquet"]


class StoppedError(Exception):
    """What a test throws into a run."""


def gas() -> carom.Scenario:
    return carom.gas(200, 0.5, collisions=COLLISIONS, seed=4)


def files(folder: Path, form: str = "gsd", every: float = 0.0) -> dict[str, Any]:
    folder.mkdir(exist_ok=True)
    return {
        "snapshots": carom.Snapshots(folder / f"snapshots.{form}", every_collisions=2500),
        "events": carom.EventStream(folder / "events.parquet", window=(2, 9)),
        "checkpoints": carom.Checkpoints(folder / CHECKPOINT, every=every),
    }


def measured(**more: Any) -> carom.Run:
    return gas().run(observe=NAMES, equilibrate=20, **more)


@pytest.fixture(scope="module")
def alone() -> carom.Run:
    return measured()


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give a folder with what runs write that nothing broke off."""
    folder = tmp_path_factory.mktemp("whole")
    for form in FORMS:
        measured(**files(folder / form, form))
    return folder


def same_numbers(one: carom.Run, other: carom.Run) -> bool:
    def numbers(run: carom.Run) -> str:
        curves = [curve.to_dict() for found in run.observables.values() for curve in found.curves.values()]
        columns = [{name: column.tobytes().hex() for name, column in curve.items()} for curve in curves]
        return json.dumps([run.observables.to_dict(), columns, run.digest, run.status])

    return numbers(one) == numbers(other)


def same_files(one: Path, other: Path, form: str = "gsd") -> bool:
    import pandas

    def events(folder: Path) -> Any:
        return pandas.read_parquet(folder / "events.parquet")

    def shots(folder: Path) -> list[records.Snapshot]:
        return list(records.frames(folder / f"snapshots.{form}"))

    return events(one).equals(events(other)) and shots(one) == shots(other)


def stopping(after: int) -> Any:
    """Give a progress that throws at the call of that number."""
    calls = iter(range(after + 1))

    def progress(*_: Any) -> None:
        if next(calls) == after:
            raise StoppedError

    return progress


def test_writing_moves_no_trajectory_and_no_number(alone: carom.Run, tmp_path: Path) -> None:
    assert alone.digest == gas().run().digest
    assert same_numbers(measured(**files(tmp_path)), alone)


def test_snapshots_and_events_are_those_of_the_run(whole: Path) -> None:
    from pyarrow import parquet

    run = gas().run(record="all")
    frames = list(records.frames(whole / "gsd" / "snapshots.gsd"))
    assert [frame.events for frame in frames] == list(range(0, COLLISIONS + 1, 2500))
    for frame in frames[::5]:
        positions, velocities = run.states(frame.time)
        np.testing.assert_allclose(frame.positions, positions, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(frame.velocities, velocities)
        assert frame.ids is None
    kept = run.events.by_time(2, 9)
    assert len(kept) > 4000
    stream = parquet.read_table(whole / "gsd" / "events.parquet")
    assert stream.equals(kept.to_arrow())


def test_snapshots_come_at_times_and_intervals(tmp_path: Path) -> None:
    gas().run(snapshots=carom.Snapshots(tmp_path / "a.xyz", at=[0, 0.5, 3]))
    assert [frame.time for frame in records.frames(tmp_path / "a.xyz")] == [0, 0.5, 3]
    run = gas().run(snapshots=carom.Snapshots(tmp_path / "b.gsd", every_time=1.5), duration=4.5, collisions=None)
    assert run.status == "time_limit"
    assert [frame.time for frame in records.frames(tmp_path / "b.gsd")] == [0, 1.5, 3, 4.5]
    assert len(run.observables) == 0


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("form", FORMS)
def test_a_run_broken_off_anywhere_goes_on(alone: carom.Run, whole: Path, tmp_path: Path, form: str, seed: int) -> None:
    choose, every = random.Random(seed), [0.0, 1e9][seed % 2]
    given = files(tmp_path / "run", form, every)
    with pytest.raises(StoppedError):
        measured(progress=stopping(0), **given)
    tmp_path = (tmp_path / "run").rename(tmp_path / "moved")  # files are found from the checkpoint
    for _ in range(choose.randrange(3)):
        with suppress(StoppedError):
            carom.resume(tmp_path, progress=stopping(0))
    run = carom.resume(tmp_path)
    assert same_numbers(run, alone)
    assert same_files(tmp_path, whole / form, form)
    assert same_numbers(carom.resume(tmp_path), alone)  # it has ended, still


def test_a_run_that_ended_goes_on_to_a_later_end(whole: Path, alone: carom.Run, tmp_path: Path) -> None:
    given = files(tmp_path)
    measured(collisions=COLLISIONS // 2, **given)
    assert same_numbers(carom.resume(tmp_path, collisions=COLLISIONS), alone)
    assert same_files(tmp_path, whole / "gsd")
    with pytest.raises(carom.ScenarioError, match="duration: the run has come to"):
        carom.resume(tmp_path, duration=0.1)
    with pytest.raises(TypeError, match="collisions: must be an int"):
        carom.resume(tmp_path, collisions=1.5)  # type: ignore[arg-type]


KILLED = """
import sys
from pathlib import Path
sys.path.insert(0, {tests!r})
import test_checkpoints as these, carom
folder = Path({folder!r})
print("ready", flush=True)
if (folder / these.CHECKPOINT).exists():
    carom.resume(folder)
else:
    these.measured(**these.files(folder, {form!r}))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
@pytest.mark.parametrize("form", FORMS)
def test_a_run_killed_at_any_moment_goes_on(alone: carom.Run, whole: Path, tmp_path: Path, form: str) -> None:
    choose = random.Random(form)
    code = KILLED.format(tests=str(Path(__file__).parent), folder=str(tmp_path), form=form)
    kills = 0
    for _ in range(12):
        with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
            assert child.stdout is not None
            assert child.stdout.readline() == "ready\n"
            time.sleep(choose.uniform(0.0, 0.15))
            child.kill()
            child.wait(timeout=60)
        kills += child.returncode == -signal.SIGKILL
    assert kills
    assert same_numbers(carom.resume(tmp_path), alone)
    assert same_files(tmp_path, whole / form, form)
    assert not [path for path in tmp_path.rglob(".*") if path.parent == tmp_path]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no limit of a file's size")
@pytest.mark.parametrize("form", ["gsd", "xyz"])
def test_a_full_disk_ends_a_run_that_can_go_on(alone: carom.Run, whole: Path, tmp_path: Path, form: str) -> None:
    import resource

    unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
    size = (whole / form / f"snapshots.{form}").stat().st_size
    resource.setrlimit(resource.RLIMIT_FSIZE, (size * 2 // 3, unlimited[1]))
    try:
        with pytest.raises(carom.RecordError, match=r"not written, .*File too large"):
            measured(**files(tmp_path, form))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
    assert same_numbers(carom.resume(tmp_path), alone)
    assert same_files(tmp_path, whole / form, form)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no limit of a file's size")
def test_a_checkpoint_that_cannot_be_written_leaves_the_one_before(alone: carom.Run, tmp_path: Path) -> None:
    import resource

    place = tmp_path / CHECKPOINT
    with pytest.raises(StoppedError):
        measured(checkpoints=place, progress=stopping(0))
    before, unlimited = place.read_bytes(), resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) // 2, unlimited[1]))
    try:
        with pytest.raises(carom.RecordError, match=f"{CHECKPOINT}: not written, File too large"):
            carom.resume(place, every=0.0)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
    assert place.read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == [CHECKPOINT]
    assert same_numbers(carom.resume(place), alone)


def test_a_checkpoint_that_is_none_is_refused_and_says_why(whole: Path, tmp_path: Path) -> None:
    place = tmp_path / CHECKPOINT
    good = (whole / "gsd" / CHECKPOINT).read_bytes()

    def refused(content: bytes, message: str) -> None:
        place.write_bytes(content)
        with pytest.raises(carom.RunError, match=message) as error:
            carom.resume(tmp_path)
        assert str(error.value).startswith(f"{place}: ")

    refused(b"", "not a checkpoint")
    refused(good[:-1], f"cut short: it has {len(good) - 1} of {len(good)} bytes")
    refused(good[:50], "cut short")
    refused(good + b"x", "damaged: it has")
    for at in (10, 20, 60, 100, len(good) // 2, len(good) - 1):
        refused(good[:at] + bytes([good[at] ^ 4]) + good[at + 1 :], "damaged: its checksum")
    place.unlink()
    with pytest.raises(carom.RunError, match="no such file, and a checkpoint is needed"):
        carom.resume(tmp_path)


def test_files_that_lack_what_they_had_are_refused(whole: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(whole / "gsd", tmp_path / "copy"))
    records.cut_frames(folder / "snapshots.gsd", 3)
    with pytest.raises(carom.RecordError, match=r"snapshots.gsd: has 3 frames, and 25 are to stay"):
        carom.resume(folder)
    (folder / "snapshots.gsd").unlink()
    with pytest.raises(carom.RecordError, match=r"no such file, and 25 frames of it are to stay"):
        carom.resume(folder)
    shutil.copy(whole / "gsd" / "snapshots.gsd", folder)
    next((folder / "events.parquet").iterdir()).unlink()
    with pytest.raises(carom.RecordError, match=r"events.parquet: must have a piece that ends after \d+ events"):
        carom.resume(folder)


def test_what_does_not_fit_is_refused_before_anything_is_written(tmp_path: Path) -> None:
    def refused(kind: type[Exception], message: str, **options: Any) -> None:
        with pytest.raises(kind, match=message):
            gas().run(**options)
        assert list(tmp_path.iterdir()) == []

    path = tmp_path / "a.gsd"
    for given in ({}, {"every_time": 1.0, "at": [2.0]}):
        with pytest.raises(carom.ScenarioError, match="needs one of every_time"):
            carom.Snapshots(path, **given)
    refused(carom.ScenarioError, "snapshots.every_time: must be a positive", snapshots=carom.Snapshots(path, -1.0))
    refused(carom.ScenarioError, "snapshots.at: .*ascend", snapshots=carom.Snapshots(path, at=[2, 1]))
    refused(carom.RecordError, "must end in", snapshots=carom.Snapshots(tmp_path / "a.png", 1.0))
    refused(carom.RecordError, "must end in", events=carom.EventStream(tmp_path / "a.csv", (1, 2)))
    refused(carom.ScenarioError, "events.window: .*earlier", events=carom.EventStream(tmp_path / "a.parquet", (2, 1)))
    refused(TypeError, "snapshots: must be a carom.Snapshots", snapshots="a.gsd")
    refused(TypeError, "progress: belongs to", progress=print)
    refused(TypeError, "until: must be a kind", checkpoints=path, until=lambda event: True)
    with pytest.raises(carom.ScenarioError, match=r"every_time: must be finite"):
        carom.Snapshots(path, float("nan"))
    with pytest.raises(carom.ScenarioError, match=r"checkpoints.every: must be seconds"):
        carom.Checkpoints(path, -1)


def test_older_files_are_kept_unless_they_may_be_replaced(tmp_path: Path) -> None:
    given = files(tmp_path)
    measured(**given)
    for name, kind in [
        ("snapshots", carom.RecordError),
        ("events", carom.RecordError),
        ("checkpoints", carom.ScenarioError),
    ]:
        with pytest.raises(kind, match=r"there already|holds a run already"):
            gas().run(**{name: given[name]})
    again = {name: type(each)(**{**_fields(each), "overwrite": True}) for name, each in given.items()}
    measured(collisions=20_000, **again)
    assert len(list(records.frames(tmp_path / "snapshots.gsd"))) == 9


def _fields(value: Any) -> dict[str, Any]:
    return {name: getattr(value, name) for name in value.__slots__}


def shell(*words: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "carom", *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)


WORDS = [
    "--n",
    "200",
    "--packing-fraction",
    "0.5",
    "--seed",
    "4",
    "--observe",
    "pressure,psi6",
    "--no-figures",
    "--json",
]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to a single child")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["ctrl_c", "sigterm"])
def test_the_shell_goes_on_after_it_was_interrupted(tmp_path: Path, number: signal.Signals) -> None:
    out, most = tmp_path / "out", 3_000_000
    words = [*WORDS, "--collisions", most, "--snapshots", "gsd", "--snapshot-collisions", "1e5", "--out", out]
    command = [sys.executable, "-m", "carom", "gas", *map(str, words), "--events", "1", "2"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        while not (out / "snapshots.gsd").exists():
            time.sleep(0.01)
        time.sleep(0.3)
        child.send_signal(number)
        text, errors = child.communicate(timeout=60)
    assert child.returncode in (130, -signal.SIGINT)
    assert f"carom resume {out} goes on" in errors
    assert json.loads(text)["status"] == "interrupted"
    refused = shell("gas", *words)
    assert refused.returncode == 1
    assert f"holds a run already; carom resume {out} goes on with it" in refused.stderr

    resumed = shell("resume", out, "--no-figures", "--json")
    assert (resumed.returncode, resumed.stderr) == (0, "")
    found = json.loads(resumed.stdout)
    at_once = json.loads(shell("gas", *WORDS, "--collisions", most).stdout)
    for key in ("status", "digest", "observables", "collisions", "end_time"):
        assert found[key] == at_once[key], key
    assert {"snapshots.gsd", "events.parquet", CHECKPOINT, "run.json", "observables.json"} == set(found["files"])
    assert [frame.events for frame in records.frames(out / "snapshots.gsd")] == list(range(0, most + 1, 100_000))

    longer = json.loads(shell("resume", out, "--collisions", "3.2e6", "--json", "--no-figures").stdout)
    assert longer["collisions"] == 3_200_000


def test_the_shell_refuses_what_does_not_fit(tmp_path: Path) -> None:
    out = tmp_path / "out"
    for words, message in [
        (["--snapshots", "gsd"], "needs --out"),
        (["--events", 1, 2], "needs --out"),
        (["--checkpoint-every", 1], "needs --out"),
        (["--snapshots", "gsd", "--out", out], "needs one of --snapshot-interval"),
        (["--snapshots", "png", "--snapshot-interval", 1, "--out", out], "must be one of gsd, xyz, parquet"),
        (["--snapshot-interval", 1, "--out", out], "it is said when they come"),
        (["--snapshots", "gsd", "--snapshot-times", "1;2", "--out", out], "are no times"),
    ]:
        done = shell("gas", *WORDS, "--collisions", "1e3", *words)
        assert done.returncode == 2, words
        assert message in " ".join(done.stderr.replace("│", " ").split()), done.stderr
    assert not out.exists()
    done = shell("gas", *WORDS, "--collisions", "1e3", "--observe", "presure", "--out", out)
    assert (done.returncode, out.exists()) == (1, False)
    done = shell("resume", tmp_path)
    assert done.returncode == 1
    assert "a checkpoint is needed" in done.stderr


def test_overwriting_leaves_nothing_of_the_run_before(tmp_path: Path) -> None:
    words = [*WORDS, "--collisions", "2e4", "--out", tmp_path]
    first = shell("gas", *words, "--snapshots", "xyz", "--snapshot-times", "0,1", "--events", 0, 1)
    assert first.returncode == 0, first.stderr
    assert (tmp_path / "snapshots.xyz").exists()
    second = shell("gas", *words, "--snapshots", "gsd", "--snapshot-interval", 1, "--overwrite")
    assert second.returncode == 0, second.stderr
    there = {path.name for path in tmp_path.iterdir() if not path.is_dir() or any(path.iterdir())}
    assert there == {"snapshots.gsd", CHECKPOINT, "run.json", "observables.json"}
