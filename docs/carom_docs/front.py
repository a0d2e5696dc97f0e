"""The pictures of the README, kept in ``docs/images``: ``make pictures`` draws them anew."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import carom
from carom.figures import figure_of, save_figure

FOLDER = Path(__file__).resolve().parent.parent / "images"
BREAK = {
    "table": {"preset": "pool_9ft"},
    "rack": {"game": "nine_ball", "seed": 4},
    "balls": [{"id": "cue", "position": [0.8, 0.635]}],
    "shot": {"V0": 7.0, "phi_deg": 97.4},
}


def draw(folder: Path) -> None:
    """Draw the exercise around its collision, a break of nine-ball, and a million runs of the exercise."""
    save_figure(figure_of(carom.load("midterm").run().filmstrip()), folder / "midterm.png", dpi=110)
    save_figure(figure_of(carom.Scenario.from_dict(BREAK).run().plot_paths()), folder / "break.png", dpi=110)
    directions, speeds = np.linspace(0, 90, 1000), np.linspace(0, 2.5, 1000)
    grid = carom.Grid({"balls.red.speed": speeds, "balls.red.direction_deg": directions})
    # At 200 dots per inch, so that each run has a dot.
    save_figure(figure_of(carom.load("midterm").ensemble(grid).map("blue.x")), folder / "map.png", dpi=200)


if __name__ == "__main__":
    draw(FOLDER)
