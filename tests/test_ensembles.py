"""Ensembles: each row is the run that its numbers give, whatever the threads, and nothing is lost."""

import contextlib
import csv
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom

MIDTERM = carom.load("midterm")
BREAK = carom.load("nine_ball_break")


def end_of(scenario: carom.Scenario) -> dict[str, Any]:
    """Compute what an ensemble keeps of a run, from the run itself."""
    run = scenario.run(record="all")
    columns: dict[str, Any] = {"status": run.status, "end_time": run.end_time}
    axes = "xyz" if len(run.positions(run.end_time)[0]) == 3 else "xy"
    vectors = {"": run.positions(run.end_time), "v": run.velocities(run.end_time)}
    for prefix, values in vectors.items():
        for ball, row in zip(run.ball_ids, values, strict=True):
            columns |= {f"{ball}.{prefix}{axis}": value for axis, value in zip(axes, row, strict=True)}
    for kind, count in run.diagnostics["events"].items():
        columns[f"events.{kind}"] = count
    times = run.events["time"]
    columns |= {"first_event": times[0], "last_event": times[-1]} if len(times) else {}
    return columns


OUTCOMES = ["end_time", "events", "first_event", "last_event", "final_position", "final_velocity"]
CASES: list[tuple[carom.Scenario, dict[str, Any]]] = [
    (MIDTERM, {"balls.red.velocity[0]": [3.0, 0.0, -2.5]}),
    (MIDTERM, {"balls.red.speed": [5.0, 0.0, 9.0], "balls.red.direction_deg": [53.0, 10.0, 400.0]}),
    (MIDTERM, {"balls.red.position[0]": [0.1, 0.2], "physics.ball_cushion.factor": [0.5, 1.0]}),
    (MIDTERM, {"duration": [0.1, 3.0], "balls.blue.mass": [0.5, 2.0]}),
    (MIDTERM.with_values({"method": {"kind": "stepped", "dt": 0.03}}), {"balls.red.velocity[1]": [4.0, 4.5]}),
    (carom.load("fifty_random"), {"balls[3].velocity[0]": [0.5, -0.5], "balls[7].velocity[1]": [1.0, 2.0]}),
    (BREAK, {"shot.V0": [7.5, 8.0], "shot.phi_deg": [96.0, 96.5]}),
    (BREAK, {"rack.seed": [1, 2], "physics.flight.gravity": [9.8, 9.81]}),
]


@pytest.mark.parametrize(("scenario", "varied"), CASES)
def test_a_row_has_the_bits_of_the_run_by_itself(scenario: carom.Scenario, varied: dict[str, Any]) -> None:
    table = scenario.ensemble(varied, OUTCOMES)
    assert table.is_complete
    for row in range(len(table)):
        numbers = {path: column[row] for path, column in varied.items()}
        changed = scenario.with_values(numbers)
        expected = end_of(changed)
        for name, value in expected.items():
            found = table[name][row]
            same = found == value or (value != value and found != found)
            assert same, (row, name, found, value)
        assert table.scenario_of(row).run().digest == changed.run().digest
        assert {path: table[path][row] for path in varied} == numbers


def test_pockets_and_spins_of_a_break() -> None:
    table = BREAK.ensemble({"shot.V0": carom.Normal(8, 0.2), "shot.phi_deg": carom.Normal(96.3, 0.5)}, runs=40)
    table = BREAK.ensemble({path: table[path] for path in ("shot.V0", "shot.phi_deg")}, ["pockets", "final_spin"])
    pocketed = 0
    for row in range(40):
        run = table.scenario_of(row).run()
        pockets = {event.ball_a: event.pocket for event in run.events.by_kind("ball_pocket")}
        assert {ball: table[f"{ball}.pocket"][row] for ball in run.ball_ids} == {
            ball: pockets.get(ball) for ball in run.ball_ids
        }
        pocketed += len(pockets)
    assert pocketed > 10
    assert np.isnan(table["cue.wx"]).sum() < 40


def test_no_number_of_threads_changes_a_bit() -> None:
    varied = {"balls.red.speed": carom.Uniform(1, 9), "balls.red.direction_deg": carom.Uniform(0, 90)}
    tables = [MIDTERM.ensemble(varied, OUTCOMES, runs=1000, seed=5, threads=threads) for threads in (1, 2, 7, None)]
    assert all(table == tables[0] for table in tables)


def test_what_is_drawn_depends_on_row_path_and_seed_alone() -> None:
    speed = {"balls.red.speed": carom.Normal(5, 0.1)}
    both = {"balls.red.direction_deg": carom.Uniform(0, 90), **speed}
    few, many = (MIDTERM.ensemble(speed, [], runs=runs, seed=5)["balls.red.speed"] for runs in (10, 100))
    assert few.tolist() == many[:10].tolist()
    assert MIDTERM.ensemble(both, [], runs=10, seed=5)["balls.red.speed"].tolist() == few.tolist()
    assert MIDTERM.ensemble(speed, [], runs=10, seed=6)["balls.red.speed"].tolist() != few.tolist()
    assert abs(many.mean() - 5) < 0.05


@pytest.mark.parametrize("design", ["independent", "latin_hypercube", "sobol"])
def test_layers_of_designs_are_filled(design: Any) -> None:
    varied = {"balls.red.speed": carom.Uniform(0, 64), "balls.red.direction_deg": carom.Uniform(0, 64)}
    table = MIDTERM.ensemble(varied, [], runs=64, design=design, seed=1)
    layers = [len(set(np.floor(table[path]).astype(int).tolist())) for path in varied]
    assert (layers == [64, 64]) == (design != "independent")


def test_the_last_axis_of_a_grid_varies_fastest() -> None:
    grid = carom.Grid({"balls.red.speed": [4, 5], "balls.red.direction_deg": [40, 50, 60]})
    table = MIDTERM.ensemble(grid, ["end_time"])
    assert table["balls.red.speed"].tolist() == [4, 4, 4, 5, 5, 5]
    assert table["balls.red.direction_deg"].tolist() == [40, 50, 60] * 2
    assert (grid.shape, len(grid), repr(grid)) == (
        (2, 3),
        2,
        "Grid: 2 x 3 of balls.red.speed, balls.red.direction_deg",
    )


def test_functions_of_runs_are_columns_too() -> None:
    varied = {"balls.red.speed": [4.0, -1.0, 5.0]}
    table = MIDTERM.ensemble(varied, [], functions={"energy": lambda run: float(run.energy(1.0))}, invalid="keep")
    expected = [MIDTERM.with_values({"balls.red.speed": speed}).run().energy(1.0) for speed in (4.0, 5.0)]
    assert table["energy"].tolist() == [expected[0], None, expected[1]]


def speeds_called(functions: dict[str, Any], **options: Any) -> carom.Ensemble:
    speeds = [1.0, -1.0, 2.0, 3.0, 4.0]
    return MIDTERM.ensemble({"balls.red.speed": speeds}, [], functions=functions, invalid="keep", **options)


def test_ctrl_c_in_a_function_keeps_the_values_of_the_runs_before() -> None:
    def end_time(run: carom.Run) -> float:
        if run.scenario.value("balls.red.speed") == 3.0:
            raise KeyboardInterrupt
        return run.end_time

    table = speeds_called({"events": lambda run: len(run.events), "end_time": end_time})
    assert not table.is_complete
    assert table["end_time"].tolist() == [5.0, None, 5.0, None, None]
    assert [count is None for count in table["events"]] == [False, True, False, True, True]
    assert table["status"].tolist() == ["time_limit", "rejected", *["time_limit"] * 3]


def test_progress_counts_the_calls_of_functions_too_and_may_end_them() -> None:
    told: list[tuple[int, int]] = []

    def progress(done: int, of: int) -> bool:
        told.append((done, of))
        return (done, of) == (2, 4)

    table = speeds_called({"end_time": lambda run: run.end_time}, progress=progress)
    assert [now for now in told if now[1] == 4] == [(0, 4), (1, 4), (2, 4)]
    assert table["end_time"].tolist() == [5.0, None, 5.0, None, None]
    assert not table.is_complete
    assert speeds_called({"end_time": lambda run: run.end_time}, progress=lambda *now: False).is_complete


def test_no_function_is_called_after_an_early_end() -> None:
    called: list[carom.Run] = []
    speeds = {"shot.V0": carom.Normal(8, 0.2)}
    table = BREAK.ensemble(speeds, [], functions={"run": called.append}, runs=20_000, progress=lambda *now: True)
    assert (table.is_complete, called, set(table["run"])) == (False, [], {None})


def test_an_exception_in_a_function_tells_of_which_run() -> None:
    def speed(run: carom.Run) -> float:
        return 1 / (run.scenario.value("balls.red.speed") - 2.0)

    with pytest.raises(RuntimeError, match="functions: speed raised ZeroDivisionError for run 2: ") as error:
        speeds_called({"speed": speed})
    assert isinstance(error.value.__cause__, ZeroDivisionError)


IN_A_TERMINAL = """
import carom
noise = carom.ExecutionNoise.preset("pool_tournament")
scenario = carom.load("nine_ball_break")
{call}
print("done")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no pseudo-terminals")
@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            "scenario.ensemble({'shot.V0': carom.Normal(8, 0.2)}, runs=3000, progress=True)",
            ["runs", " of 3,000, ", " runs/s"],
        ),
        (
            "scenario.ensemble({'shot.V0': [8.0] * 50}, functions={'end': lambda run: run.end_time}, progress=True)",
            ["functions", " of 50, ", " runs/s"],
        ),
        ("scenario.success('1', noise, runs=3000, progress=True)", ["runs", " of 3,000, ", " runs/s"]),
        (
            "scenario.best_aim({'shot.V0': [8.0, 8.1]}, '1', noise, runs=2000, progress=True)",
            ["runs", " of 4,000, ", " runs/s"],
        ),
        ("scenario.success('1', noise, runs=3000)", []),
    ],
)
def test_a_bar_shows_on_a_terminal_and_leaves_it_clean(call: str, words: list[str]) -> None:
    import pty

    code = [sys.executable, "-c", IN_A_TERMINAL.format(call=call)]
    done = subprocess.run(code, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("done\n", "")
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "100"}
    with subprocess.Popen(code, stdout=subprocess.PIPE, stderr=theirs, env=environment) as child:
        os.close(theirs)
        said = b""
        with contextlib.suppress(OSError):  # which Linux has for the end
            while chunk := os.read(ours, 4096):
                said += chunk
        os.close(ours)
        assert child.stdout is not None and child.stdout.read() == b"done\n"
    shown = said.decode()
    assert all(word in shown for word in words)
    assert bool(words) == bool(shown)
    if words:  # the last line is erased, and the cursor is back
        last = shown[shown.rindex("\x1b[2K") :].replace("\x1b[2K", "").replace("\x1b[?25h", "")
        assert (last.strip("\r\n"), shown.count("\x1b[?25l")) == ("", shown.count("\x1b[?25h"))


def test_a_progress_that_is_neither_is_refused() -> None:
    with pytest.raises(TypeError, match="progress: must be true, false or a function, got 'bar'"):
        MIDTERM.ensemble({"balls.red.speed": [1.0]}, progress="bar")  # type: ignore[arg-type]


@pytest.mark.parametrize("numbers", [[-1.0], [-1.0] * 3000])
def test_all_rows_may_be_rejected(numbers: list[float]) -> None:
    table = MIDTERM.ensemble({"balls.red.speed": numbers}, ["events", "end_time"], invalid="keep")
    assert set(table["status"]) == {"rejected"} and table.is_complete
    assert table["events.ball_ball"].tolist() == [-1] * len(numbers)
    assert "balls[0].speed: must be zero or positive" in table["problem"][-1]
    with pytest.raises(carom.ScenarioError, match=f"{len(numbers)} of {len(numbers)} make no scenario"):
        MIDTERM.ensemble({"balls.red.speed": numbers})


def test_a_path_to_no_number_is_no_matter_of_rows() -> None:
    for path in ("balls.red.spede", "balls.red.id", "table.shape", "physics.flight.gravity"):
        with pytest.raises(carom.ScenarioError):
            MIDTERM.ensemble({path: [1.0]}, invalid="keep")


def test_rows_that_make_no_scenario_are_named() -> None:
    varied = {"balls.red.speed": [1.0, -1.0, float("nan"), float("inf"), -2.0], "balls.blue.mass": [1.0] * 5}
    with pytest.raises(carom.ScenarioError) as error:
        MIDTERM.ensemble(varied)
    places = [place for place, _ in error.value.problems]
    assert places == ["runs", "run 1", "run 2", "run 3"]
    assert "4 of 5 make no scenario, 1 more than are named here" in str(error.value)
    table = MIDTERM.ensemble(varied, ["events", "end_time"], invalid="keep")
    assert table["status"].tolist() == ["time_limit", *["rejected"] * 4]
    assert table["problem"][0] is None
    assert all("balls[0].speed" in problem for problem in table["problem"][1:])
    assert np.isnan(table["end_time"]).tolist() == [False, True, True, True, True]
    assert (table["events.ball_ball"] == -1).tolist() == [False, True, True, True, True]


def test_what_is_absent_is_absent_in_other_programs(tmp_path: Path) -> None:
    table = MIDTERM.ensemble({"balls.red.speed": [-1.0, 1.0]}, ["events"], invalid="keep")
    table.to_csv(tmp_path / "table.csv")
    first = next(csv.DictReader((tmp_path / "table.csv").read_text().splitlines()))
    assert first["events.ball_ball"] == ""
    pandas, arrow = table.to_pandas(), table.to_arrow()
    assert pandas["events.ball_ball"].isna().tolist() == [True, False]
    assert arrow["events.ball_ball"].null_count == 1
    assert arrow["status"].to_pylist() == ["rejected", "time_limit"]


@pytest.mark.parametrize(
    ("varied", "options", "message"),
    [
        ({"balls.red.spede": [1.0]}, {}, "balls\\[0\\].spede: unknown key; did you mean speed"),
        ({"balls.rde.speed": [1.0]}, {}, "no member of the list has the id"),
        ({"balls.red.speed": [1.0], "duration": [1.0, 2.0]}, {}, "duration: has 2 numbers, and balls.red.speed has 1"),
        ({"balls.red.speed": [1.0]}, {"runs": 2}, "runs: asks for 2, and what is varied gives 1"),
        ({"balls.red.speed": carom.Uniform(1, 2)}, {}, "runs: missing"),
        ({"balls.red.speed": carom.Uniform(2, 1)}, {"runs": 2}, "balls.red.speed: .*low"),
        ({"balls.red.speed": carom.Normal(2, 0)}, {"runs": 2}, "standard_deviation: must be above 0, got 0"),
        ({"balls.red.speed": []}, {}, "no runs"),
        (carom.Grid({"balls.red.speed": []}), {}, "an axis of 0 numbers gives no grid"),
        ({"balls.red.speed": [1.0]}, {"outcomes": ["closest_approach.red.bleu"]}, 'no ball "bleu"; did you mean blue'),
        ({"balls.red.speed": [1.0]}, {"outcomes": ["pockets"]}, "outcomes: pockets: is for balls on a cloth"),
        ({"balls.red.speed": [1.0]}, {"outcomes": ["end"]}, 'outcomes: unknown "end"; known: end_time, events'),
        ({"balls.red.speed": [1.0]}, {"design": "sobel"}, 'design: unknown "sobel"; known: independent'),
    ],
)
def test_what_makes_no_ensemble_is_refused(varied: Any, options: dict[str, Any], message: str) -> None:
    with pytest.raises(carom.ScenarioError, match=message):
        MIDTERM.ensemble(varied, **options)


def test_wrong_types_are_told() -> None:
    with pytest.raises(TypeError, match=r"balls.red.speed: expected numbers, a Uniform or a Normal, got 'fast'"):
        MIDTERM.ensemble({"balls.red.speed": "fast"})
    with pytest.raises(ValueError, match=r"must have the shape \(n_runs,\), got \(2, 1\)"):
        MIDTERM.ensemble({"balls.red.speed": [[1.0], [2.0]]})
    with pytest.raises(TypeError, match="expected a list of names"):
        MIDTERM.ensemble({"balls.red.speed": [1.0]}, "events")
    with pytest.raises(ValueError, match="invalid: must be"):
        MIDTERM.ensemble({"balls.red.speed": [1.0]}, invalid="drop")  # type: ignore[arg-type]


def test_progress_is_told_and_may_end_it() -> None:
    told: list[tuple[int, int]] = []

    def progress(done: int, of: int) -> bool:
        told.append((done, of))
        return True

    varied = {"shot.V0": carom.Normal(8, 0.2)}
    table = BREAK.ensemble(varied, ["end_time"], runs=20_000, progress=progress)
    assert told[0][1] == 20_000
    assert not table.is_complete
    left = table["status"] == "not_run"
    assert 0 < left.sum() < 20_000
    assert np.isnan(table["end_time"][left]).all()
    finished = int(np.flatnonzero(~left)[0])
    assert table["end_time"][finished] == table.scenario_of(finished).run().end_time


def test_an_exception_in_progress_is_raised() -> None:
    def progress(done: int, of: int) -> bool:
        raise LookupError("no bar")

    with pytest.raises(LookupError, match="no bar"):
        BREAK.ensemble({"shot.V0": carom.Normal(8, 0.2)}, ["end_time"], runs=20_000, progress=progress)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows raises no SIGINT in a thread")
def test_ctrl_c_keeps_what_is_finished() -> None:
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    timer.start()
    table = BREAK.ensemble({"shot.V0": carom.Normal(8, 0.2)}, ["end_time"], runs=50_000)
    timer.join()
    statuses = set(table["status"])
    assert not table.is_complete
    assert {"at_rest", "not_run"} <= statuses


def test_other_threads_work_meanwhile() -> None:
    ticks, is_over = [0], threading.Event()

    def tick() -> None:
        while not is_over.wait(0.001):
            ticks[0] += 1

    ticker = threading.Thread(target=tick)
    ticker.start()
    BREAK.ensemble({"shot.V0": carom.Normal(8, 0.2)}, ["end_time"], runs=2000)
    is_over.set()
    ticker.join()
    assert ticks[0] > 5


def test_gases_of_unlike_sizes_have_what_they_have_in_common() -> None:
    gas = carom.load("gas").with_values({"collisions": 200})
    table = gas.ensemble({"gas.n": [50, 40]}, ["events", "final_position"])
    assert (table["events.ball_ball"] == 200).all()
    assert np.isnan(table["45.x"]).tolist() == [False, True]
    last = table.scenario_of(1).run()
    assert table["39.x"][1] == last.positions(last.end_time)[39, 0]
    walled = gas.with_values({"gas.periodic": []})
    table = walled.ensemble({"gas.n": [50, 40]}, ['closest_approach."1"."45"', "distance"])
    assert np.isnan(table['closest_approach."1"."45"']).tolist() == [False, True]
    assert (table["1.distance"] > 0).all()


def test_ways_on_a_cloth_are_those_of_many_states() -> None:
    varied = {"shot.V0": [2.0, 8.0], "rack.seed": [1.0, 2.0]}
    table = BREAK.ensemble(varied, ["distance", 'closest_approach.cue."1"', 'closest_approach."2"."3"'])
    for row in range(2):
        run = table.scenario_of(row).run()
        radius = 0.028575
        assert table['closest_approach.cue."1"'][row] == pytest.approx(2 * radius, rel=1e-9)
        places = run.positions(np.linspace(0, run.end_time, 20_000))
        for place, ball in enumerate(run.ball_ids):
            pieces = np.linalg.norm(np.diff(places[:, place], axis=0), axis=1)
            assert table[f"{ball}.distance"][row] == pytest.approx(np.nansum(pieces), rel=2e-3, abs=1e-4), ball
        two, three = (places[:, run.ball_ids.index(ball)] for ball in ("2", "3"))
        nearest = np.nanmin(np.linalg.norm(two - three, axis=1))
        assert nearest - 2e-3 < table['closest_approach."2"."3"'][row] <= nearest + 1e-12


def test_observables_of_gases_are_those_of_single_runs() -> None:
    gas = carom.load("gas").with_values({"collisions": 20_000})
    fractions = [0.1, 0.4]
    table = gas.ensemble({"gas.packing_fraction": fractions}, ["pressure", "speeds", "events"], equilibrate=10)
    for row, fraction in enumerate(fractions):
        run = gas.with_values({"gas.packing_fraction": fraction}).run(
            observe=["pressure", "speeds"], equilibrate=10, record="none"
        )
        for name in ("pressure", "speeds"):
            for quantity in run.observables[name].quantities.values():
                for found, value in (("", quantity.value), (".error", quantity.error)):
                    expected = np.nan if value is None else value
                    got = table[f"{name}.{quantity.name}{found}"][row]
                    assert got == expected or np.isnan([got, expected]).all(), quantity
        assert table["events.ball_ball"][row] == 20_000
    z = run.observables["pressure"].quantities["compressibility_factor"]
    assert z.error is not None and z.expected is not None
    assert abs(table["pressure.compressibility_factor"][1] - z.expected) < 5 * z.error


def test_what_cannot_be_observed_is_told() -> None:
    gas = carom.load("gas").with_values({"collisions": 20_000})
    with pytest.raises(carom.ScenarioError, match="first_event: goes with nothing that is observed, such as pressure"):
        gas.ensemble({"gas.packing_fraction": [0.1]}, ["pressure", "first_event"])
    with pytest.raises(carom.ScenarioError, match=r"outcomes: .*rectangle"):
        carom.load("circle").ensemble({"duration": [1.0]}, ["pressure"])
    table = gas.ensemble({"collisions": [200, 20_000]}, ["pressure"], invalid="keep")
    assert table["status"].tolist() == ["rejected", "collision_limit"]
    assert "collisions: must be 250 or more to measure 50 discs" in table["problem"][0]
