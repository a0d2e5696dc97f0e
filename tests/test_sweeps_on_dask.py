"""Sweeps on a Dask cluster, and the unit of work that is handed to clusters."""

import errno
import os
import pickle
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sweep_files
from sweep_files import contents

import carom
from carom.sweep import dataset, on_dask

pyarrow = pytest.importorskip("pyarrow")
distributed = pytest.importorskip("distributed")

MIDTERM = sweep_files.MIDTERM.replace("rows_per_part = 300", "rows_per_part = 60")
BREAKS = sweep_files.BREAKS.replace("runs = 20000", "runs = 4000").replace("rows_per_part = 500", "rows_per_part = 100")


@pytest.fixture
def sweep(tmp_path: Path) -> carom.Sweep:
    (tmp_path / "midterm.toml").write_text(MIDTERM)
    return carom.Sweep.load(tmp_path / "midterm.toml")


@pytest.fixture
def breaks(tmp_path: Path) -> Path:
    (tmp_path / "breaks.toml").write_text(BREAKS)
    return tmp_path / "breaks.toml"


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """A cluster of two processes, as somebody else's would be."""
    with distributed.LocalCluster(
        2, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0", silence_logs=50
    ) as cluster:
        yield cluster


def pids(cluster: Any) -> list[int]:
    with distributed.Client(cluster, set_as_default=False) as client:
        return list(client.run(os.getpid).values())


def test_the_bytes_are_those_of_threads(sweep: carom.Sweep, tmp_path: Path, cluster: Any) -> None:
    sweep.run(tmp_path / "threads")
    told: list[tuple[int, int]] = []
    result = sweep.run(
        tmp_path / "dask",
        engine="dask",
        scheduler=cluster.scheduler_address,
        progress=lambda *now: told.append(now),
    )
    assert contents(tmp_path / "dask") == contents(tmp_path / "threads")
    assert (result.rows, result.is_complete) == (1000, True)
    assert told == sorted(told) and told[0] == (0, 1000) and told[-1] == (1000, 1000)


def test_a_cluster_is_started_for_the_call_and_makes_what_is_missing(
    sweep: carom.Sweep, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, started = tmp_path / "out", []
    sweep.run(folder)
    whole = contents(folder)
    for part in (1, 5, 16):
        (folder / f"part-{part:08d}.parquet").unlink()
    (folder / ".part-00000001.12345678.parquet").write_text("what a killed worker left")
    real = distributed.LocalCluster
    monkeypatch.setattr(distributed, "LocalCluster", lambda *a, **k: started.append(real(*a, **k)) or started[-1])
    told: list[int] = []
    assert sweep.run(folder, engine="dask", workers=2, progress=lambda done, of: told.append(done)).is_complete
    assert contents(folder) == whole
    assert told[0] == 1000 - 2 * 60 - 40
    assert started[0].status.name == "closed"
    sweep.run(folder, engine="dask", workers=2)
    assert len(started) == 1, "nothing was missing"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows kills in its own way")
def test_a_worker_that_is_killed_changes_nothing(breaks: Path, tmp_path: Path, cluster: Any) -> None:
    sweep, killed = carom.Sweep.load(breaks), []

    def kill_one(done: int, of: int) -> None:
        if done > 300 and not killed:
            killed.append(pids(cluster)[0])
            os.kill(killed[0], signal.SIGKILL)

    result = sweep.run(tmp_path / "dask", engine="dask", scheduler=cluster.scheduler_address, progress=kill_one)
    assert killed and result.is_complete
    sweep.run(tmp_path / "threads")
    assert contents(tmp_path / "dask") == contents(tmp_path / "threads")


def test_what_is_true_ends_a_sweep_and_the_same_one_goes_on(breaks: Path, tmp_path: Path, cluster: Any) -> None:
    sweep, address = carom.Sweep.load(breaks), cluster.scheduler_address
    part = sweep.run(tmp_path / "out", engine="dask", scheduler=address, progress=lambda done, of: done >= 500)
    assert 500 <= part.rows < 4000 and not part.is_complete
    assert sweep.run(tmp_path / "out", engine="threads").is_complete


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to a single child")
def test_ctrl_c_in_a_terminal_ends_the_command_and_its_workers(breaks: Path, tmp_path: Path) -> None:
    breaks.write_text(BREAKS.replace("4000", "400000"))
    command = [sys.executable, "-m", "carom", "sweep", str(breaks), "--out", str(tmp_path / "out")]
    child = subprocess.Popen(
        [*command, "--engine", "dask", "--workers", "2"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while not list(tmp_path.glob("out/part-*.parquet")):
        time.sleep(0.05)
        assert child.poll() is None
    os.killpg(child.pid, signal.SIGINT)  # a terminal sends it to all
    _, said = child.communicate(timeout=60)  # ends when the last of the workers has closed the pipe
    assert child.returncode == 130, said
    lines = said.splitlines()
    assert lines[0].startswith("error: ended after") and lines[0].endswith("the same command goes on"), said
    assert len(lines) == 2, said
    names = [path.name for path in (tmp_path / "out").iterdir()]
    assert not [name for name in names if name.startswith(".")]
    assert len(names) > 1


def test_a_scheduler_that_does_not_answer_is_named(sweep: carom.Sweep, tmp_path: Path) -> None:
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{closed.getsockname()[1]}"
    for wrong in (address, "nonsense://here"):
        with pytest.raises(OSError, match=f"no Dask scheduler answers there: '{wrong}'"):
            sweep.run(tmp_path / "out", engine="dask", scheduler=wrong)


def test_a_cluster_without_workers_is_an_error(
    sweep: carom.Sweep, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(on_dask, "WORKER_WITHIN", 0.3)
    scheduler = {"cls": distributed.Scheduler, "options": {"dashboard_address": "127.0.0.1:0"}}
    with (
        distributed.SpecCluster(scheduler=scheduler) as cluster,
        pytest.raises(OSError, match="no worker for") as error,
    ):
        sweep.run(tmp_path / "out", engine="dask", scheduler=cluster.scheduler_address)
    assert error.value.filename == cluster.scheduler_address


def test_errors_of_parts_come_back(sweep: carom.Sweep, tmp_path: Path, cluster: Any) -> None:
    (tmp_path / "out").mkdir()
    with distributed.Client(cluster, set_as_default=False) as client:
        with pytest.raises(OSError, match="No space left on device") as error:
            on_dask.write_parts(client, [(0, 1), (1, 1)], full, lambda done: False)
        assert error.value.errno == errno.ENOSPC and error.value.filename in ("part 0", "part 1")
        with pytest.raises(carom.RecordError, match=r"given up: it was with \d workers that were lost"):
            on_dask.write_parts(client, [(0, 1)], deadly, lambda done: False)


def full(part: int) -> None:
    raise OSError(errno.ENOSPC, "No space left on device", f"part {part}")


def deadly(part: int) -> None:
    os._exit(1)


def test_a_worker_has_to_see_the_folder_and_the_same_sweep(sweep: carom.Sweep, tmp_path: Path) -> None:
    with pytest.raises(carom.RecordError, match=r"manifest.json: a worker on .* does not see it"):
        dataset._write_part_as_told(str(tmp_path / "elsewhere"), sweep.digest, 1, 0)
    sweep.run(tmp_path / "out")
    with pytest.raises(carom.RecordError, match=r"is another sweep for a worker on .* physics version \d"):
        dataset._write_part_as_told(str(tmp_path / "out"), "0" * 64, 1, 0)


def test_words_for_the_wrong_engine_are_refused(sweep: carom.Sweep, tmp_path: Path) -> None:
    for words, message in (
        ({"engine": "ray"}, "engine: unknown 'ray'; known: threads, dask"),
        ({"workers": 2}, 'engine="dask" takes them'),
        ({"engine": "dask", "workers": 2, "scheduler": "tcp://here:1"}, "leave out one of the two"),
    ):
        with pytest.raises(ValueError, match=message):
            sweep.run(tmp_path / "out", **words)  # type: ignore[arg-type]
    assert not (tmp_path / "out").exists()


def some_inputs() -> Any:
    speeds, angles = np.linspace(-1, 9, 50), np.linspace(0, 90, 50)
    return pyarrow.table({"balls.red.direction_deg": angles, "row": np.arange(50)[::-1], "balls.red.speed": speeds})


def test_the_work_is_that_of_an_ensemble_in_the_order_of_the_rows(midterm: carom.Scenario) -> None:
    inputs, outcomes = some_inputs(), ["events", "first_event", "final_position"]
    table = carom.outcomes_of_table(midterm, inputs, outcomes, threads=1)
    varied = {name: inputs[name].to_numpy() for name in ("balls.red.direction_deg", "balls.red.speed")}
    expected = midterm.ensemble(varied, outcomes, invalid="keep").to_arrow()
    assert table.column_names[:4] == [*inputs.column_names, "status"]
    assert table.column_names[-1] == "problem"
    assert table["row"].to_pylist() == list(range(50))[::-1]
    for name in expected.column_names:
        assert table[name].to_pylist() == pytest.approx(expected[name].to_pylist(), abs=0, nan_ok=True), name
    rejected = [row for row, word in enumerate(table["status"].to_pylist()) if word == "rejected"]
    assert rejected == [0, 1, 2, 3, 4]
    assert [row for row, text in enumerate(table["problem"].to_pylist()) if text] == rejected
    assert "speed" in table["problem"][0].as_py()
    assert table["events.ball_ball"][0].as_py() is None


def test_the_work_does_not_depend_on_how_it_is_cut(midterm: carom.Scenario) -> None:
    inputs = some_inputs()
    whole = carom.outcomes_of_table(midterm, inputs)
    work = pickle.loads(pickle.dumps((carom.outcomes_of_table, midterm)))
    cut = [work[0](work[1], inputs.slice(start, 7)) for start in range(0, 50, 7)]
    nothing = carom.outcomes_of_table(midterm, inputs.slice(0, 0))
    assert nothing.schema == whole.schema and nothing.num_rows == 0
    together = pyarrow.concat_tables([nothing, *cut])
    assert together.schema == whole.schema
    assert str(together.to_pylist()) == str(whole.to_pylist())  # NaN is not itself


def test_rows_may_all_be_rejected(midterm: carom.Scenario, tmp_path: Path) -> None:
    table = carom.outcomes_of_table(midterm, some_inputs().slice(0, 3))
    assert table["status"].to_pylist() == ["rejected"] * 3
    (tmp_path / "sweep.toml").write_text(MIDTERM.replace("rows_per_part = 60", "rows_per_part = 1"))
    assert carom.Sweep.load(tmp_path / "sweep.toml").run(tmp_path / "out").statuses["rejected"] > 1
    speeds = pyarrow.table({"balls.red.speed": [-1.0] * 3000})
    assert carom.outcomes_of_table(midterm, speeds)["status"].to_pylist() == ["rejected"] * 3000


def test_numbers_may_be_whole_and_single(midterm: carom.Scenario) -> None:
    inputs = pyarrow.table({"balls.red.speed": pyarrow.array([1, 5], pyarrow.int32())})
    table = carom.outcomes_of_table(midterm, inputs, ["end_time"])
    assert table["balls.red.speed"].to_pylist() == [1.0, 5.0]
    assert table["status"].to_pylist() == ["time_limit"] * 2


@pytest.mark.parametrize(
    ("columns", "problem"),
    [
        ({"row": [1]}, "inputs: has no column that is named by the path"),
        ({"balls.red.speed": ["fast"]}, "balls.red.speed: must be a column of numbers, is one of string"),
        ({"balls.red.speed": [None, 1.5]}, "balls.red.speed: lacks a number in 1 of 2 rows"),
        ({"balls.rde.speed": [1.0]}, "balls.rde.speed: no member of the list has the id"),
        ({"id": [1]}, "id: "),
    ],
)
def test_wrong_columns_are_told(midterm: carom.Scenario, columns: dict[str, list[Any]], problem: str) -> None:
    with pytest.raises(carom.ScenarioError) as error:
        carom.outcomes_of_table(midterm, pyarrow.table(columns))
    assert str(error.value).startswith(problem)


def test_other_wrong_inputs_are_told(midterm: carom.Scenario) -> None:
    twice = pyarrow.Table.from_arrays([pyarrow.array([1.0])] * 2, names=["balls.red.speed"] * 2)
    with pytest.raises(carom.ScenarioError, match=r"balls.red.speed: 2 columns have this name"):
        carom.outcomes_of_table(midterm, twice)
    with pytest.raises(TypeError, match=r"inputs: expected a pyarrow.Table, got dict"):
        carom.outcomes_of_table(midterm, {"balls.red.speed": [1.0]})  # type: ignore[arg-type]
    with pytest.raises(carom.ScenarioError, match=r'outcomes: unknown "evnets"'):
        carom.outcomes_of_table(midterm, twice.select([0]), ["evnets"])
    with pytest.raises(carom.ScenarioError, match=r'outcomes: unknown "evnets"'):
        carom.outcomes_of_table(midterm, twice.select([0]).slice(0, 0), ["evnets"])
