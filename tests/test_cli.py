"""The command line: what it prints, writes, refuses, and with which exit code."""

import base64
import csv
import errno
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import carom
from carom.cli import main
from carom.cli.options import read_setting
from carom.cli.output import reporting

RUN_FILES = {"events.csv", "trajectory.csv", "run.json", "report.html"}
FIGURES = {"filmstrip", "paths", "energy", "speed", "momentum"}
ESCAPE = "\x1b"


@dataclass
class Done:
    code: object
    stdout: str
    stderr: str


def shell(*words: object) -> Done:
    """Give a command to the program, in this process: starting a new one for each test takes long."""
    out, err = io.StringIO(), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.setattr(sys, "argv", ["carom", *map(str, words)])
        with pytest.raises(SystemExit) as ended:
            main()
    return Done(ended.value.code or 0, out.getvalue(), err.getvalue())


def fine(*words: object) -> str:
    done = shell(*words)
    assert (done.code, done.stderr) == (0, ""), done.stderr
    return done.stdout


def process(*words: object, **more: str) -> subprocess.CompletedProcess[str]:
    """Give a command to the program in a process of its own."""
    command = [sys.executable, "-m", "carom", *map(str, words)]
    environment = {**os.environ, **more}
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", env=environment, check=False)


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def names_in(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


# carom run


def test_run_prints_events_and_diagnostics_and_writes_nothing(
    tmp_path: Path, run: carom.Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    printed = fine("run", "midterm")
    events, diagnostics = printed.split("\n\n")
    head, *rows = [line.split("\t") for line in events.splitlines()]
    assert head[:2] == ["time", "kind"]
    assert [float(row[0]) for row in rows] == run.events["time"].tolist()
    facts = dict(line.split("\t", 1) for line in diagnostics.splitlines())
    assert facts["status"] == "time_limit"
    assert facts["digest"] == run.digest
    assert not names_in(tmp_path)


class Terminal(io.StringIO):
    """What is printed, as to a terminal."""

    def isatty(self) -> bool:
        return True


def on_a_terminal(columns: int, monkeypatch: pytest.MonkeyPatch, *words: object) -> str:
    """What a command prints on a terminal of so many columns, without its colours."""
    monkeypatch.setenv("COLUMNS", str(columns))
    out = Terminal()
    monkeypatch.setattr(sys, "argv", ["carom", *map(str, words)])
    with redirect_stdout(out), pytest.raises(SystemExit):
        main()
    return re.sub(ESCAPE + r"\[[0-9;]*m", "", out.getvalue())


def test_a_terminal_of_80_columns_shows_whole_words_and_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    printed = on_a_terminal(80, monkeypatch, "run", "midterm")
    assert max(map(len, printed.splitlines())) <= 80
    assert "\N{HORIZONTAL ELLIPSIS}" not in printed
    assert printed.count("  ball_cushion ") == 11


@pytest.mark.parametrize("columns", [80, 40])
def test_a_terminal_shows_every_number_beside_long_names(
    columns: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, run: carom.Run
) -> None:
    values = run.scenario.to_dict()
    for ball, name in zip(values["balls"], ("Anna-Maria Hohenstaufen", "Maximilian [b] Oberhuber"), strict=True):
        ball["id"] = name
    path = tmp_path / "long.toml"
    carom.Scenario.from_dict(values).save(path)
    printed = on_a_terminal(columns, monkeypatch, "run", path)
    events = printed.split("diagnostic")[0]
    rows = [line.split() for line in events.splitlines() if re.match(r" +[0-9.]+  ball", line)]
    numbers = [(row[0], *row[-3:]) for row in rows]
    wanted = (run.events[name].tolist() for name in ("time", "x", "y", "closing_speed"))
    assert numbers == [tuple(f"{value:.6g}" for value in row) for row in zip(*wanted, strict=True)]
    assert max(map(len, events.splitlines())) <= 80
    assert "[b]" in events


@pytest.mark.skipif(sys.platform == "win32", reason="pipes close otherwise there")
@pytest.mark.parametrize("words", [["run", "midterm"], ["--help"], ["check", "nothing"], ["schema"]], ids=" ".join)
def test_a_closed_pipe_ends_a_command_quietly(words: list[str]) -> None:
    read, write = os.pipe()
    os.close(read)
    command = [sys.executable, "-m", "carom", *words]
    to_errors = words[0] == "check"
    done = subprocess.run(
        command,
        stdout=subprocess.PIPE if to_errors else write,
        stderr=write if to_errors else subprocess.PIPE,
        check=False,
    )
    os.close(write)
    assert (done.returncode, done.stdout or b"", done.stderr or b"") == (141, b"", b"")


@pytest.mark.parametrize("text", [".9", "+0.9", "0.9", "0.900_0", "9.e-1"])
def test_numbers_of_set_are_those_of_python_and_toml(text: str) -> None:
    assert read_setting(f"table.width={text}") == ("table.width", 0.9)


@pytest.mark.parametrize("text", ["nan", "inf", "-infinity", "word", "1 m", ""])
def test_words_of_set_stay_words(text: str) -> None:
    assert read_setting(f"title={text}") == ("title", text)


def test_characters_that_the_font_lacks_are_named_in_one_line(tmp_path: Path) -> None:
    words = ("run", "midterm", "--set", "balls.red.id=球体", "--out", tmp_path / "out", "--no-animation")
    done = process(*words)
    assert (done.returncode, done.stderr) == (0, "warning: the figures' font lacks 球 体; boxes stand there\n")


def test_piped_output_has_no_colours(tmp_path: Path) -> None:
    options = ("--out", tmp_path / "out", "--no-figures")
    done = process("run", "midterm", *options, FORCE_COLOR="1", TERM="xterm-256color")
    assert (done.returncode, done.stderr) == (0, "")
    assert ESCAPE not in done.stdout


def test_piped_output_is_utf8_whatever_the_system_speaks(tmp_path: Path) -> None:
    path = tmp_path / "\N{GREEK SMALL LETTER PI}.toml"
    fine("scenarios", "--copy", "midterm", path)
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('id = "red"', 'id = "ž"'), encoding="utf-8")
    done = process("run", path, PYTHONIOENCODING="cp1252")
    assert (done.returncode, done.stderr) == (0, "")
    assert "\tž\t" in done.stdout
    done = process("check", path.with_name("no π.toml"), PYTHONIOENCODING="ascii")
    assert (done.returncode, done.stderr) == (1, f"error: {path.with_name('no π.toml')}: no such file\n")


def test_run_writes_tables_figures_and_film(tmp_path: Path, run: carom.Run) -> None:
    out = tmp_path / "deep" / "out"
    fine("run", "midterm", "--out", out)
    assert names_in(out) == RUN_FILES | {f"{name}.png" for name in FIGURES} | {"animation.gif"}
    assert names_in(tmp_path) == {"deep"}
    assert names_in(tmp_path / "deep") == {"out"}
    assert carom.load_run(out / "run.json") == run
    assert [float(row["time"]) for row in rows_of(out / "events.csv")] == run.events["time"].tolist()


def test_the_report_shows_the_figures_that_were_written(tmp_path: Path) -> None:
    words = ("run", "midterm", "--dt", "0.03", "--set", "title=A <b>", "--no-animation")
    fine(*words, "--out", tmp_path / "png")
    fine(*words, "--out", tmp_path / "svg", "--format", "svg")
    report = (tmp_path / "png" / "report.html").read_text(encoding="utf-8")
    for name in FIGURES:
        assert base64.b64encode((tmp_path / "png" / f"{name}.png").read_bytes()).decode() in report
    assert "carom run midterm --set &#39;title=A &lt;b&gt;&#39; --dt 0.03" in report
    assert "Beside this page: run.json, events.csv, trajectory.csv, steps.csv, filmstrip.png" in report
    in_svg = (tmp_path / "svg" / "report.html").read_text(encoding="utf-8")
    pictures = [re.findall(r"data:image/png;base64,[\w+/=]+", text) for text in (report, in_svg)]
    assert pictures[0] == pictures[1]
    assert len(pictures[0]) == len(FIGURES)


def test_a_report_without_figures_says_so(tmp_path: Path) -> None:
    fine("run", "midterm", "--no-figures", "--no-animation", "--out", tmp_path / "out")
    report = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "This report was made without figures." in report
    assert "<img" not in report


def test_a_run_without_figures_loads_no_matplotlib(tmp_path: Path) -> None:
    words = ["carom", "run", "midterm", "--no-figures", "--no-animation", "--out", str(tmp_path / "out")]
    code = (
        f"import sys, runpy; sys.argv = {words!r}\n"
        "try: runpy.run_module('carom', run_name='__main__')\n"
        "except SystemExit: pass\n"
        "print('matplotlib' in sys.modules, file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "False"
    assert names_in(tmp_path / "out") == RUN_FILES


def test_files_keep_every_bit(tmp_path: Path, run: carom.Run) -> None:
    fine("run", "midterm", "--sample", "0.25", "--out", tmp_path / "out", "--no-figures", "--no-animation")
    rows = rows_of(tmp_path / "out" / "trajectory.csv")
    assert len(rows) == 21
    for row in rows:
        x, y = run.positions(float(row["time"]))[1]
        assert (float(row["blue.x"]), float(row["blue.y"])) == (x, y)


def test_stepped_runs_write_their_steps(tmp_path: Path, stepped: carom.Run) -> None:
    options = ("--method", "stepped", "--dt", "0.03", "--no-figures", "--no-animation")
    fine("run", "midterm", *options, "--out", tmp_path / "out")
    assert names_in(tmp_path / "out") == RUN_FILES | {"steps.csv"}
    assert carom.load_run(tmp_path / "out" / "run.json").digest == stepped.digest
    assert stepped.steps is not None
    assert len(rows_of(tmp_path / "out" / "steps.csv")) == len(stepped.steps)


def test_dt_alone_means_stepped(stepped: carom.Run) -> None:
    assert json.loads(fine("run", "midterm", "--dt", "0.03", "--json"))["digest"] == stepped.digest


def test_figures_come_in_the_formats_asked_for(tmp_path: Path) -> None:
    fine("run", "midterm", "--out", tmp_path / "out", "--format", "svg,pdf", "--no-animation")
    expected = {f"{name}.{kind}" for name in FIGURES for kind in ("svg", "pdf")}
    assert names_in(tmp_path / "out") == RUN_FILES | expected


def test_a_film_comes_in_the_kind_asked_for(tmp_path: Path) -> None:
    pytest.importorskip("imageio_ffmpeg", reason="carom[movie] is not installed")
    out = tmp_path / "out"
    fine("run", "midterm", "--duration", "1", "--no-figures", "--out", out)
    fine("run", "midterm", "--duration", "1", "--no-figures", "--animation", "mp4", "--out", out, "--overwrite")
    assert names_in(out) == RUN_FILES | {"animation.mp4"}


def test_a_folder_that_holds_a_run_is_refused(tmp_path: Path) -> None:
    options = ("run", "midterm", "--out", tmp_path / "out", "--no-animation", "--no-figures")
    fine(*options)
    before = (tmp_path / "out" / "run.json").stat().st_mtime_ns
    refused = shell(*options, "--duration", "1")
    assert (refused.code, refused.stdout) == (1, "")
    assert refused.stderr.startswith("error: --out: ")
    assert "--overwrite" in refused.stderr
    assert (tmp_path / "out" / "run.json").stat().st_mtime_ns == before


def test_overwriting_leaves_no_old_results_and_keeps_other_files(tmp_path: Path) -> None:
    out = tmp_path / "out"
    fine("run", "midterm", "--dt", "0.03", "--out", out, "--no-animation")
    (out / "notes.txt").write_text("mine", encoding="utf-8")
    fine("run", "midterm", "--out", out, "--no-animation", "--no-figures", "--overwrite")
    assert names_in(out) == RUN_FILES | {"notes.txt"}
    assert names_in(tmp_path) == {"out"}


@pytest.fixture
def other_disk() -> Iterator[Path]:
    """Give a folder on another file system than that of temporary files."""
    try:
        folder = Path(tempfile.mkdtemp(dir="/dev/shm"))
    except OSError:
        pytest.skip("no second file system here")
    yield folder
    shutil.rmtree(folder)


def test_a_link_to_another_file_system_is_written_through(tmp_path: Path, other_disk: Path) -> None:
    link = tmp_path / "link"
    link.symlink_to(other_disk)
    options = ("run", "midterm", "--out", link, "--no-animation", "--no-figures")
    fine(*options, "--dt", "0.03")
    fine(*options, "--overwrite")
    assert link.is_symlink()
    assert names_in(other_disk) == RUN_FILES
    assert carom.load_run(link / "run.json").steps is None
    assert names_in(tmp_path) == {"link"}


def test_a_link_to_a_folder_yet_to_be_made_is_written_through(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "deep" / "out")
    fine("run", "midterm", "--out", tmp_path / "link", "--no-animation", "--no-figures")
    assert names_in(tmp_path / "deep" / "out") == RUN_FILES
    assert names_in(tmp_path) == {"link", "deep"}


def test_files_that_cannot_be_moved_leave_the_old_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = tmp_path / "out"
    options = ("run", "midterm", "--out", out, "--no-animation", "--no-figures")
    fine(*options, "--dt", "0.03")
    before = {name: (out / name).read_bytes() for name in names_in(out)}

    def refuse(*_: object) -> None:
        raise PermissionError(errno.EACCES, "no", str(out))

    monkeypatch.setattr("carom.cli.folder._move_all", refuse)
    assert shell(*options, "--overwrite").code == 1
    assert {name: (out / name).read_bytes() for name in names_in(out)} == before
    monkeypatch.undo()
    (out / "paths.png").mkdir()
    done = shell(*options, "--overwrite")
    assert (done.code, done.stderr) == (
        1,
        f"error: --out: {out / 'paths.png'} is a folder, and a file is to be there\n",
    )
    assert {name: (out / name).read_bytes() for name in before} == before


def test_no_folder_is_no_place_for_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for command in ("run", "compare"):
        done = shell(command, "midterm", "--out", "")
        assert done.code == 2
        assert "--out" in done.stderr
    assert not names_in(tmp_path)
    fine("run", "midterm", "--out", ".", "--no-animation", "--no-figures")
    assert names_in(tmp_path) == RUN_FILES


def test_errors_speak_of_the_file_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    path = Path("nodir") / "x.toml"
    done = shell("scenarios", "--copy", "midterm", path)
    assert done.stderr == f"error: {path}: the folder nodir does not exist\n"


def test_set_changes_values() -> None:
    printed = fine("run", "midterm", "--set", "balls.red.velocity[0]=0", "--set", "duration=0.4", "--json")
    found = json.loads(printed)
    assert found["end_time"] == 0.4
    assert found["events"] == []


def test_json_holds_the_run(run: carom.Run) -> None:
    found = json.loads(fine("run", "midterm", "--json"))
    assert found["status"] == "time_limit"
    assert found["digest"] == run.digest
    assert [event["time"] for event in found["events"]] == run.events["time"].tolist()
    assert found["events"][3]["ball_b"] == "blue"
    assert found["files"] == []
    assert found["references"][0]["law"] == "ball_cushion.restitution"


def test_limits_end_a_run() -> None:
    assert json.loads(fine("run", "midterm", "--collisions", "2", "--json"))["status"] == "collision_limit"
    assert json.loads(fine("run", "midterm", "--max-events", "2", "--json"))["status"] == "event_limit"


def test_an_event_budget_that_was_not_asked_for_is_no_success() -> None:
    done = shell("run", "midterm", "--set", "max_events=2")
    assert done.code == 1
    assert done.stderr.startswith("error: run: ended by event_limit")


def test_runs_that_kept_little_write_little(tmp_path: Path) -> None:
    fine("run", "midterm", "--set", "record=events", "--out", tmp_path / "out")
    assert names_in(tmp_path / "out") == {"events.csv", "run.json", "report.html"}


def test_a_run_that_kept_nothing_says_so(tmp_path: Path, run: carom.Run) -> None:
    words = ("run", "midterm", "--set", "record=none")
    kept, diagnostics = fine(*words, "--out", tmp_path / "out").split("\n\n")
    assert kept == "no events: the run kept none (record = none)"
    facts = dict(line.split("\t", 1) for line in diagnostics.splitlines())
    assert (facts["status"], facts["digest"]) == ("time_limit", run.digest)
    assert facts["record"] == "none"
    assert facts["events.ball_cushion"] == "11"
    assert names_in(tmp_path / "out") == {"run.json", "report.html"}
    found = json.loads(fine(*words, "--json"))
    assert (found["record"], found["events"], found["digest"]) == ("none", None, run.digest)
    assert json.loads(fine("run", "midterm", "--json"))["record"] == "all"


def test_what_a_scenario_keeps_is_no_matter_to_compare_and_bench(tmp_path: Path) -> None:
    path = tmp_path / "little.toml"
    carom.load("midterm").with_values({"record": "none"}).save(path)
    assert fine("compare", path, "--dt", "0.03,0.01") == fine("compare", "midterm", "--dt", "0.03,0.01")
    (row,) = json.loads(fine("bench", path, "--repeats", "1", "--json"))
    assert row["events"] == 12


def test_the_speed_of_a_film_is_said(tmp_path: Path) -> None:
    options = ("--set", "duration=40", "--sample", "10", "--no-figures", "--out", tmp_path / "out")
    assert json.loads(fine("run", "midterm", *options, "--json"))["animation_speed"] == 2.0
    assert "\nanimation_speed\t2.0\n" in fine("run", "midterm", *options, "--overwrite")
    found = json.loads(fine("run", "midterm", *options, "--overwrite", "--no-animation", "--json"))
    assert found["animation_speed"] is None


# Errors


def test_every_problem_is_one_line_with_its_place() -> None:
    done = shell("run", "midterm", "--set", "balls.red.radius=-1", "--set", "duration=-5")
    assert (done.code, done.stdout) == (1, "")
    lines = done.stderr.splitlines()
    assert len(lines) == 2
    assert all(line.startswith("error: ") for line in lines)
    assert any("radius" in line for line in lines)
    assert any("duration" in line for line in lines)


@pytest.mark.parametrize(
    "words",
    [
        ("run", "midtrem"),
        ("run", "no/such/file.toml"),
        ("run", "midterm", "--set", "balls.red.speeed=1"),
        ("verify", "no/such/run.json"),
        ("scenarios", "--copy", "nothing", "x.toml"),
        ("compare", "no-such-scenario"),
        ("bench", "no-such-scenario"),
    ],
)
def test_problems_are_reported_line_by_line(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = shell(*words)
    assert done.code == (2 if words[0] == "compare" else 1)
    assert all(line.startswith("error: ") for line in done.stderr.splitlines())
    assert done.stderr
    assert not names_in(tmp_path)


@pytest.mark.parametrize(
    "words",
    [
        ("run",),
        ("run", "midterm", "--dt"),
        ("run", "midterm", "--set", "duration"),
        ("run", "midterm", "--method", "guess"),
        ("run", "midterm", "--method", "stepped"),
        ("run", "midterm", "--method", "exact", "--dt", "0.1"),
        ("run", "midterm", "--format", "bmp"),
        ("run", "midterm", "--sample", "0"),
        ("run", "midterm", "--sample", "inf"),
        ("compare", "midterm", "--dt", "0.1,-1"),
        ("fly",),
    ],
)
def test_wrong_usage_exits_with_2(words: tuple[str, ...]) -> None:
    assert shell(*words).code == 2


def test_what_is_no_scenario_is_named_in_one_line(tmp_path: Path, run: carom.Run) -> None:
    run.save(tmp_path / "run.json")
    assert shell("run", tmp_path / "run.json").stderr == (
        f"error: {tmp_path / 'run.json'}: a saved run, not a scenario; load_run and verify take it\n"
    )
    assert shell("run", f"{tmp_path}/").stderr == f"error: {tmp_path}: a folder, not a scenario file\n"
    assert shell("run", "nofile.toml").stderr == "error: nofile.toml: no such file\n"


def test_files_and_folders_that_cannot_be_are_reported(tmp_path: Path) -> None:
    (tmp_path / "bytes.json").write_bytes(b"\xff\xfe")
    assert shell("verify", tmp_path / "bytes.json").stderr == (
        f"error: {tmp_path / 'bytes.json'}: not a text in UTF-8 (byte 0)\n"
    )
    assert shell("run", "midterm", "--out", tmp_path / "bytes.json").stderr.startswith("error: --out: ")
    done = shell("run", "midterm", "--sample", "1e-9", "--out", tmp_path / "out")
    assert done.stderr.startswith("error: --sample: ")
    assert names_in(tmp_path) == {"bytes.json"}


def test_a_process_of_its_own_exits_with_the_same_codes() -> None:
    assert process("check", "midterm").returncode == 0
    wrong = process("check", "midtrem")
    assert (wrong.returncode, wrong.stdout) == (1, "")
    assert wrong.stderr.startswith("error: ")
    assert "Traceback" not in wrong.stderr
    assert process("check").returncode == 2


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent differently there")
def test_an_interrupted_run_leaves_nothing_and_exits_with_130(tmp_path: Path) -> None:
    words = ["run", "midterm", "--set", "duration=400", "--out", str(tmp_path / "out"), "--no-figures"]
    child = subprocess.Popen(
        [sys.executable, "-m", "carom", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    deadline = time.monotonic() + 60.0
    while not list(tmp_path.glob(".out.*/.animation.*.gif")) and time.monotonic() < deadline:
        time.sleep(0.02)
    child.send_signal(signal.SIGINT)
    printed, said = child.communicate(timeout=60)
    assert child.returncode == 130
    assert printed == ""
    assert said.startswith("interrupted")
    assert len(said.splitlines()) == 1
    assert not names_in(tmp_path)


def test_an_interruption_that_the_parser_turned_into_an_exit_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(prog_name: str) -> None:
        raise SystemExit(130)

    monkeypatch.setattr("carom.cli.app.app", interrupted)
    done = shell("run", "midterm")
    assert (done.code, done.stderr) == (130, "interrupted: nothing is half written\n")


def test_an_interruption_where_python_drops_exceptions_still_interrupts(monkeypatch: pytest.MonkeyPatch) -> None:
    class Finalized:
        def __del__(self) -> None:
            raise KeyboardInterrupt

    def interrupted_in_a_finalizer(prog_name: str) -> None:
        Finalized()
        time.sleep(60.0)

    monkeypatch.setattr("carom.cli.app.app", interrupted_in_a_finalizer)
    hook = sys.unraisablehook
    started = time.monotonic()
    done = shell("run", "midterm")
    assert time.monotonic() - started < 30.0
    assert (done.code, done.stderr) == (130, "interrupted: nothing is half written\n")
    assert sys.unraisablehook is hook


# The other commands


def test_compare_shows_first_order_convergence(tmp_path: Path) -> None:
    found = json.loads(fine("compare", "midterm", "--dt", "0.001,0.0003,0.0001", "--json"))
    assert found["exact_events"] == 12
    assert [row["missed"] for row in found["steps"]] == [0, 0, 0]
    assert found["order"] == pytest.approx(1.0, abs=0.35)
    assert not names_in(tmp_path)


def test_compare_writes_its_table_and_figure(tmp_path: Path) -> None:
    out = tmp_path / "out"
    fine("compare", "midterm", "--dt", "0.03", "--dt", "0.01", "--out", out, "--format", "png", "--format", "pdf")
    assert names_in(out) == {"comparison.csv", "errors.png", "errors.pdf"}
    assert [float(row["dt"]) for row in rows_of(out / "comparison.csv")] == [0.03, 0.01]
    assert shell("compare", "midterm", "--dt", "0.1", "--out", out).code == 2


def test_compare_without_any_error_draws_that(tmp_path: Path) -> None:
    fine("compare", "midterm", "--dt", "0.1,0.01", "--duration", "0", "--out", tmp_path / "out")
    assert names_in(tmp_path / "out") == {"comparison.csv", "errors.png"}


def test_check_lists_every_problem(tmp_path: Path) -> None:
    assert "no problems" in fine("check", "midterm")
    text = carom.load("midterm").to_toml().replace("0.075", "-0.075")
    path = tmp_path / "wrong.toml"
    path.write_text(text, encoding="utf-8")
    done = shell("check", path)
    assert done.code == 1
    assert done.stderr.startswith("error: ")
    found = json.loads(shell("check", path, "--json").stdout)
    assert not found["sound"]
    assert all("radius" in problem["place"] for problem in found["problems"])


def test_verify_says_whether_the_bits_are_the_same(tmp_path: Path, run: carom.Run) -> None:
    path = tmp_path / "run.json"
    run.save(path)
    assert "same bits" in fine("verify", path)
    assert json.loads(fine("verify", path, "--json"))["same"] is True
    time_of_contact = repr(float(run.events["time"][3]))
    moved = repr(float(np.nextafter(run.events["time"][3], 1.0)))
    text = path.read_text(encoding="utf-8")
    assert time_of_contact in text
    path.write_text(text.replace(time_of_contact, moved), encoding="utf-8")
    done = shell("verify", path)
    assert done.code == 1
    assert done.stderr.startswith("error: ")


def test_scenarios_are_listed_and_copied(tmp_path: Path) -> None:
    listed = [line.split("\t")[0] for line in fine("scenarios").splitlines()]
    assert listed == ["name", *carom.scenarios()]
    for name in ("mine.toml", "mine.json"):
        fine("scenarios", "--copy", "midterm", tmp_path / name)
        assert carom.load(tmp_path / name) == carom.load("midterm")
    assert shell("scenarios", "--copy", "midterm", tmp_path / "mine.toml").code == 1
    fine("scenarios", "--copy", "midterm", tmp_path / "mine.toml", "--overwrite")


def test_schema_is_json() -> None:
    assert json.loads(fine("schema")) == json.loads(carom.schema())


def test_bench_gives_a_median(tmp_path: Path) -> None:
    (row,) = json.loads(fine("bench", "midterm", "--repeats", "3", "--json"))
    assert row["scenario"] == "midterm"
    assert row["events"] == 12
    assert row["median_s"] > 0


def test_version_and_help() -> None:
    assert fine("--version").strip() == f"carom {carom.__version__}"
    assert fine("--cite") == carom.citation() + "\n"
    for command in ("run", "compare", "check", "verify", "scenarios", "schema", "bench", "map"):
        printed = fine(command, "--help")
        assert f"carom {command}" in printed.split("For example:")[1]
        assert ESCAPE not in printed


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys, runpy; sys.argv = ['carom', '--help']\n"
        "try: runpy.run_module('carom', run_name='__main__')\n"
        "except SystemExit: pass\n"
        "heavy = ('numpy', 'matplotlib', 'carom._engine')\n"
        "print([name for name in heavy if name in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"


def test_what_libraries_say_to_their_developers_is_not_printed(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.warns(DeprecationWarning, match="old name"), reporting():
        warnings.warn("old name", DeprecationWarning, stacklevel=1)
    with reporting():
        warnings.simplefilter("always")
        warnings.warn("look here", UserWarning, stacklevel=1)
    assert capsys.readouterr().err == "warning: look here\n"
