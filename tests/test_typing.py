"""Type checkers take what the package takes, and refuse what it refuses."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]

TAKEN = """
import numpy as np
from matplotlib.axes import Axes
from typing_extensions import assert_type

import carom

place = np.array([0.1, 0.1])
carom.Ball("p", position=place, velocity=np.array([3, 4]))
carom.Ball("p", position=(0.1, 0.1), velocity=[3, 4])
carom.Field(np.array([0, -1.0]))
carom.Line(place, place), carom.Arc(place, 1.0, from_deg=0, to_deg=90)
carom.Circle(place, 0.1), carom.Wall(place, place)
run = carom.load("midterm").run()
assert_type(run.filmstrip(run.events[0], frames=5, arrows=False), list[Axes])
run.plot_paths(numbers=False)
"""

REFUSED = """
import carom

run = carom.load("midterm").run()
run.plot_paths(number=False)
run.filmstrip(frames="3")
run.plot_energy(numbers=True)
carom.Ball("p", position=3.0)
"""


def test_mypy_takes_arrays_and_the_options_of_figures_and_refuses_others(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "taken.py").write_text(TAKEN)
    (tmp_path / "refused.py").write_text(REFUSED)
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--config-file",
        os.devnull,
        "--cache-dir",
        str(tmp_path / "c"),
    ]
    done = subprocess.run(
        [*command, "taken.py", "refused.py"],
        cwd=tmp_path,
        env={**os.environ, "MYPYPATH": str(ROOT / "python")},
        capture_output=True,
        text=True,
        check=False,
    )
    lines = done.stdout.splitlines()[:-1]
    errors = [line for line in lines if ": error: " in line]
    assert [line.split(":")[:2] for line in errors] == [["refused.py", str(number)] for number in range(5, 9)], lines
