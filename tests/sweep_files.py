"""The sweeps that tests run, and what a dataset holds."""

from pathlib import Path

MIDTERM = """
scenario = "midterm"
runs = 1000
seed = 7
outcomes = ["events", "end_time", "final_position"]
rows_per_part = 300

[vary]
"balls.red.speed" = { normal = { mean = 5, standard_deviation = 4 } }
balls.red.direction_deg = { uniform = { low = 0, high = 90 } }
"""

BREAKS = """
scenario = "nine_ball_break"
runs = 20000
seed = 3
outcomes = ["pockets", "end_time"]
rows_per_part = 500

[vary]
"shot.V0" = { normal = { mean = 8, standard_deviation = 0.2 } }
"""


def contents(folder: Path) -> dict[str, bytes]:
    """Give all that is in a folder, hidden files too."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}
