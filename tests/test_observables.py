"""Gases that are measured while they run: the API of Python and the shell."""

from __future__ import annotations

import csv
import io
import json
import math
import pickle
import signal
import subprocess
import sys
import threading
import time
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import _engine
from carom.cli import main
from carom.figures import figure_of
from carom.observables import told

SIDES = 14


def gas(packing_fraction: float = 0.3, **more: Any) -> carom.Scenario:
    """Give equal discs from a square lattice, with kT = 1 and no momentum, in a periodic box."""
    count, random = SIDES**2, np.random.default_rng(8)
    step = math.sqrt(math.pi / 4 / packing_fraction)
    velocities = random.normal(size=(count, 2))
    velocities -= velocities.mean(axis=0)
    velocities *= math.sqrt((2 * count - 2) / np.sum(velocities**2))
    balls = [
        {
            "id": f"d{k}",
            "radius": 0.5,
            "mass": 1.0,
            "position": [(k % SIDES + 0.5) * step, (k // SIDES + 0.5) * step],
            "velocity": velocities[k].tolist(),
        }
        for k in range(count)
    ]
    table = {"shape": "rectangle", "width": SIDES * step, "length": SIDES * step, "periodic": ["x", "y"]}
    limits = {} if "duration" in more else {"collisions": 40_000}
    return carom.Scenario.from_dict({"table": table, "balls": balls, "record": "none", **limits, **more})


@pytest.fixture(scope="module")
def measured() -> carom.Run:
    return gas().run(observe=_engine.OBSERVABLES, equilibrate=30)


def shell(*words: object) -> tuple[object, str, str]:
    out, err = io.StringIO(), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.setattr(sys, "argv", ["carom", "gas", *map(str, words)])
        with pytest.raises(SystemExit) as ended:
            main()
    return ended.value.code or 0, out.getvalue(), err.getvalue()


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    path = tmp_path / "gas.json"
    gas().save(path)
    return path


def test_numbers_come_with_errors_and_theory(measured: carom.Run) -> None:
    assert list(measured.observables) == _engine.OBSERVABLES
    z = measured.observables["pressure"]["compressibility_factor"]
    assert z.value is not None
    assert z.error is not None
    assert z.expected is not None
    # A box of so few discs has a Z − 1 that is lower by a part of 1/N.
    assert abs(z.value - 1 - (z.expected - 1) * (1 - 1 / SIDES**2)) < 5 * z.error
    assert z.error < 0.01 * z.value
    assert (z.unit, z.name) == ("1", "compressibility_factor")
    assert "Kolafa" in z.description
    assert str(z).startswith("compressibility_factor = 2.0")
    freedom = measured.observables["pressure"].quantities["degrees_of_freedom"]
    assert (freedom.value, freedom.error) == (2 * SIDES**2 - 2, None)


def test_measuring_moves_no_trajectory(measured: carom.Run) -> None:
    assert measured.digest == gas().run().digest
    recorded = gas(record="all", collisions=2000)
    assert recorded.run(observe=["pressure"]) == recorded.run()


def test_curves_are_tables(measured: carom.Run, tmp_path: Path) -> None:
    curve = measured.observables["speeds"]["speeds"]
    assert isinstance(curve, carom.Curve)
    assert curve.units["density"] == "time/length"
    width = curve["speed"][1] - curve["speed"][0]
    beyond = measured.observables["speeds"]["beyond"].value
    assert beyond is not None
    assert np.sum(curve["density"]) * width + beyond == pytest.approx(1.0)
    curve.to_csv(tmp_path / "speeds.csv")
    with (tmp_path / "speeds.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [float(row["density"]) for row in rows] == curve["density"].tolist()
    assert len(curve.to_pandas()) == len(curve)


def test_options_reach_the_observable() -> None:
    requests: list[Any] = [
        {"name": "radial_distribution", "range": 3, "bin_width": 0.1},
        {"name": "temperature_profile", "axis": "x", "bins": 4},
        {"name": "temperature_profile", "axis": "y", "bins": 5},
    ]
    found = gas(collisions=5000).run(observe=requests).observables
    assert list(found) == ["radial_distribution", "temperature_profile", "temperature_profile_2"]
    assert len(found["radial_distribution"]["radial_distribution"]) == 30
    assert len(found["temperature_profile_2"]["profile"]["y"]) == 5


def test_samples_come_at_the_interval_asked_for() -> None:
    times: list[tuple[float, int, int]] = []
    scenario = gas(duration=30.0, record="events")
    run = scenario.run(
        observe={"name": "h_function", "points": 10_000}, sample_interval=0.5, progress=lambda *now: times.append(now)
    )
    assert run.status == "time_limit"
    assert run.observables["h_function"]["over_time"]["time"].tolist() == pytest.approx(np.arange(61) * 0.5)
    assert len(run.events) > 1000


def test_progress_is_told_and_may_end_the_run() -> None:
    told_of: list[tuple[float, int, int]] = []

    def progress(*now: Any) -> bool:
        told_of.append(now)
        return len(told_of) == 3

    run = gas(collisions=10**9).run(observe="pressure", progress=progress)
    assert run.status == "interrupted"
    assert len(told_of) == 3
    assert told_of == sorted(told_of)
    assert run.observables["pressure"]["compressibility_factor"].value is not None
    with pytest.raises(ZeroDivisionError):
        gas(collisions=10**9).run(observe="pressure", progress=lambda *_: 1 / 0)


def refused(message: str, scenario: carom.Scenario | None = None, **options: Any) -> None:
    with pytest.raises((carom.ScenarioError, TypeError), match=message):
        (scenario or gas(collisions=500)).run(**options)


def test_what_cannot_be_measured_is_refused() -> None:
    refused("did you mean pressure.*radial_distribution", observe=["presure"])
    refused("no option .*ranges.*did you mean range", observe=[{"name": "radial_distribution", "ranges": 2}])
    refused("needs names, or mappings with a name", observe=[3])
    refused("needs names, or mappings with a name", observe=[{"range": 3}])
    refused("^equilibrate: must be a number of collisions", observe=["pressure"], equilibrate=-1)
    refused("^equilibrate: must be a number, got", observe=["pressure"], equilibrate="100")
    refused("^sample_interval: must be a positive time", observe=["pressure"], sample_interval=0)
    refused("^collisions: must be 9800 or more to measure 196 discs", observe=["pressure"], equilibrate=100)
    refused("with 1 samples", observe=["pressure"], sample_interval=1e3)
    refused("^equilibrate: belongs to observe", equilibrate=10)
    refused("^until: must be a kind", observe=["pressure"], until=lambda event: False)
    refused("^table: .*rectangle", carom.load("stadium"), observe=["pressure"])
    refused("^method: ", carom.load("midterm_stepped"), observe=["pressure"])
    refused("^physics.flight: .*cloth", carom.load("nine_ball_break"), observe=["pressure"])


def test_what_is_not_there_is_named(measured: carom.Run) -> None:
    with pytest.raises(KeyError, match=r"no observable 'z'; observed were pressure"):
        measured.observables["z"]
    with pytest.raises(KeyError, match=r"pressure has no 'z'; it has temperature, compressibility_factor"):
        measured.observables["pressure"]["z"]
    plain = gas(collisions=10).run()
    assert len(plain.observables) == 0
    with pytest.raises(KeyError, match="nothing was observed"):
        plain.observables["pressure"]
    with pytest.raises(carom.RunError, match="pressure has no curve"):
        measured.observables["pressure"].plot()


def test_what_was_found_shows_itself_pickles_and_is_no_part_of_a_saved_run(measured: carom.Run, tmp_path: Path) -> None:
    text = repr(measured.observables)
    assert "compressibility_factor  2.0" in text
    assert "±" in text
    assert "over_time: " in text
    again = pickle.loads(pickle.dumps(measured))
    assert again.observables == measured.observables
    table = measured.observables["pressure"].table
    assert table["quantity"].tolist() == list(measured.observables["pressure"].quantities)
    measured.save(tmp_path / "run.json")
    assert len(carom.load_run(tmp_path / "run.json").observables) == 0


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [(2.06326, 0.00123, "2.0633 ± 0.0012"), (1234.5, 67.0, "1234 ± 67"), (1.0, 1e-14, "1 ± 1e-14"), (0.3, None, "0.3")],
)
def test_numbers_are_told_with_two_digits_of_their_error(value: float, error: float | None, text: str) -> None:
    assert told(value, error) == text


@pytest.mark.parametrize(
    "name",
    ["free_path", "speeds", "h_function", "temperature_profile", "radial_distribution", "diffusion", "kinetic_energy"],
)
def test_curves_are_drawn(measured: carom.Run, name: str) -> None:
    ax = measured.observables[name].plot()
    assert ax.get_xlabel()
    assert ax.get_ylabel()
    assert ax.lines or ax.containers
    figure_of(ax).canvas.draw()


def test_everything_is_saved_as_files(measured: carom.Run, tmp_path: Path) -> None:
    files = {path.name for path in measured.observables.save(tmp_path)}
    assert {"observables.json", "speeds.csv", "diffusion.csv"} <= files
    assert files == {path.name for path in tmp_path.iterdir()}
    values = json.loads((tmp_path / "observables.json").read_text(encoding="utf-8"))
    z = measured.observables["pressure"]["compressibility_factor"]
    assert values["pressure"]["quantities"]["compressibility_factor"]["value"] == z.value
    assert values["speeds"]["curves"]["speeds"]["file"] == "speeds.csv"


def test_the_shell_prints_numbers_and_writes_files(saved: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = [saved, "--observe", "pressure,radial_distribution", "--collisions", "2e4", "--equilibrate", "10"]
    code, text, errors = shell(*words, "--out", out)
    assert (code, errors) == (0, "")
    rows = {tuple(line.split("\t")[:2]): line.split("\t") for line in text.splitlines()}
    found = gas().run(collisions=20_000, observe=["pressure"], equilibrate=10).observables["pressure"]
    z = found["compressibility_factor"]
    assert rows["pressure", "compressibility_factor"][2:5] == [str(z.value), str(z.error), str(z.expected)]
    assert rows["collisions", "20000"]
    files = {"checkpoint.carom", "observables.json", "radial_distribution.csv", "radial_distribution.png", "run.json"}
    assert {path.name for path in out.iterdir()} == files
    assert carom.load_run(out / "run.json").verify()
    assert shell(*words, "--out", out)[0] == 1
    code, text, _ = shell(*words, "--json")
    assert code == 0
    assert json.loads(text)["observables"]["pressure"]["quantities"]["compressibility_factor"]["value"] == z.value


def test_the_shell_refuses_what_does_not_fit(saved: Path) -> None:
    for words, message in [
        ((saved, "--n", 5), "a scenario is given"),
        (("--n", 5), "a new gas needs it"),
        (("--n", 5, "--packing-fraction", 0.3), "--duration"),
        ((saved, "--collisions", "1.5"), "no whole number"),
        (("--n", 5, "--packing-fraction", 0.3, "--collisions", "1e3", "--periodic", "z"), "must be one of"),
    ]:
        code, _, errors = shell(*words)
        assert code == 2, words
        assert message in " ".join(errors.replace("│", " ").split()), errors
    code, _, errors = shell(saved, "--observe", "presure")
    assert code == 1
    assert "did you mean pressure" in errors


def test_the_shell_makes_a_gas_from_its_options(monkeypatch: pytest.MonkeyPatch) -> None:
    given: dict[str, Any] = {}

    def make(**options: Any) -> carom.Scenario:
        given.update(options)
        return gas(collisions=options["collisions"])

    monkeypatch.setattr(carom, "gas", make, raising=False)
    code, _, errors = shell(
        "--n", 196, "--packing-fraction", 0.3, "--collisions", "5e3", "--periodic", "x", "--seed", 4
    )
    assert (code, errors) == (0, "")
    assert given == {"n": 196, "packing_fraction": 0.3, "periodic": ["x"], "seed": 4, "collisions": 5000}


class Terminal(io.StringIO):
    """What is printed, as to a terminal."""

    def isatty(self) -> bool:
        return True


def test_a_terminal_is_told_what_takes_its_time(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def told_on_a_terminal(*words: object) -> str:
        monkeypatch.setattr(sys, "argv", ["carom", *map(str, words), "--no-figures", "--json"])
        errors = Terminal()
        with redirect_stdout(io.StringIO()), redirect_stderr(errors), pytest.raises(SystemExit) as ended:
            main()
        assert ended.value.code == 0, errors.getvalue()
        return errors.getvalue()

    words = ["--n", 100, "--packing-fraction", 0.4, "--collisions", "2e5", "--out", tmp_path]
    begun = told_on_a_terminal("gas", *words)
    assert [word in begun for word in ("placing the discs", "to equilibrium", " samples")] == [True] * 3
    resumed = told_on_a_terminal("resume", tmp_path, "--collisions", "4e5")
    assert [word in resumed for word in ("reading the checkpoint", " samples")] == [True] * 2


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to a single child")
def test_ctrl_c_ends_a_measurement_in_the_shell_with_what_is_there(saved: Path, tmp_path: Path) -> None:
    code = """
import sys, threading, signal
from carom.cli import gas, main
import carom.cli.app
started = gas.bar
def telling(*given):
    print("ready", flush=True)
    return started(*given)
gas.bar = telling
main()
"""
    command = [sys.executable, "-c", code, "gas", str(saved), "--collisions", "1e12", "--out", str(tmp_path / "out")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "ready\n"
        time.sleep(1.0)
        child.send_signal(signal.SIGINT)
        try:
            printed, _ = child.communicate(timeout=60)
        finally:
            child.kill()
    assert child.returncode == 130
    assert "status\tinterrupted" in printed
    assert carom.load_run(tmp_path / "out" / "run.json").status == "interrupted"


def test_ctrl_c_in_python_is_a_keyboard_interrupt() -> None:
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        gas(collisions=10**12).run(observe=["pressure"])
