"""The exercise written out, in Python and in MATLAB, gives the numbers of the stepped method."""

import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import carom

EXAMPLES = Path(__file__).parents[1] / "examples"
NEEDED = "needs Octave (on Debian: apt-get install octave); make test installs it where it can"


@pytest.fixture(scope="module")
def exercise() -> dict:
    return runpy.run_path(str(EXAMPLES / "exercise.py"), run_name="exercise")


def numbers(path: Path, skip: int) -> np.ndarray:
    return np.loadtxt(path, delimiter=",", skiprows=skip)


def largest_difference(rows: np.ndarray, run: carom.Run) -> float:
    return float(np.abs(rows[:, 1:].reshape(-1, 2, 2) - run.positions(rows[:, 0])).max())


def test_python_exercise_is_the_stepped_method_to_round_off(exercise: dict, stepped: carom.Run):
    assert stepped.steps is not None
    start, velocity = (array[0] for array in stepped.states([0.0]))
    times = stepped.steps["time"]
    places, velocities, meetings = exercise["simulate"](start, velocity, times)
    wanted = stepped.states(times)
    assert np.abs(places - wanted[0]).max() < 1e-12
    assert np.abs(velocities - wanted[1]).max() < 1e-12
    assert meetings == [30]


@pytest.mark.parametrize("seed", range(20))
def test_it_agrees_from_other_starts_too(exercise: dict, midterm: carom.Scenario, seed: int):
    """Until the course's formula has amplified the round-off: half a second holds a few collisions."""
    random = np.random.default_rng(seed)
    red = [random.uniform(0.1, 0.4), random.uniform(0.1, 1.9)]
    start, velocity = np.array([red, [0.6, 1.0]]), random.uniform(-4, 4, (2, 2))
    changes = {
        f"balls[{ball}].{key}": array[ball].tolist()
        for ball in (0, 1)
        for key, array in (("position", start), ("velocity", velocity))
    }
    run = midterm.with_values({**changes, "duration": 1.5}).run(method=carom.Stepped(0.03))
    assert run.steps is not None
    places, _, _ = exercise["simulate"](start, velocity, run.steps["time"])
    assert len(run.events) > 1
    assert np.abs(places - run.positions(run.steps["time"])).max() < 1e-12


def test_python_exercise_writes_rows_and_a_picture(tmp_path: Path, stepped: carom.Run):
    subprocess.run([sys.executable, EXAMPLES / "exercise.py"], cwd=tmp_path, check=True)
    assert (tmp_path / "mine.csv").read_text().startswith("t,xr,yr,xb,yb\n")
    assert largest_difference(numbers(tmp_path / "mine.csv", skip=1), stepped) < 1e-12
    assert (tmp_path / "mine.png").stat().st_size > 5000


def test_python_exercise_is_short():
    assert len((EXAMPLES / "exercise.py").read_text(encoding="utf-8").splitlines()) < 60


@pytest.mark.skipif(shutil.which("octave-cli") is None, reason=NEEDED)
def test_matlab_exercise_is_the_stepped_method_to_round_off(tmp_path: Path, stepped: carom.Run):
    subprocess.run(["octave-cli", "--quiet", EXAMPLES / "matlab" / "exercise.m"], cwd=tmp_path, check=True)
    rows = numbers(tmp_path / "mine.csv", skip=0)
    assert rows.shape == (168, 5)
    assert largest_difference(rows, stepped) < 1e-12
