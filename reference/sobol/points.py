"""Writes points.json anew: points of Sobol's sequence as scipy computes them.

    python reference/sobol/points.py

README.md beside this file says what is in it.
"""

import json
from pathlib import Path

import scipy
from scipy.stats import qmc

TARGET = Path(__file__).with_name("points.json")

DIMENSIONS = 32

ROWS = [*range(64), 1000, 1_000_003, 123_456_789]
"""The first points, and some so far that the recurrences of all dimensions have run for long."""


def main():
    """Write the file."""
    sequence = qmc.Sobol(DIMENSIONS, scramble=False, bits=32)
    points = []
    for row in ROWS:
        if row > sequence.num_generated:
            sequence.fast_forward(row - sequence.num_generated)
        points.append({"row": row, "point": sequence.random(1)[0].tolist()})
    lines = ",\n".join("  " + json.dumps(point) for point in points)
    TARGET.write_text(f'{{\n "scipy": "{scipy.__version__}",\n "points": [\n{lines}\n ]\n}}\n', encoding="utf-8")


if __name__ == "__main__":
    main()
