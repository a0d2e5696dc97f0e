"""The pictures of the README and of pages, kept in ``docs/images``: ``make pictures`` draws them anew."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import carom
from carom import aim
from carom.figures import figure_of, save_figure

FOLDER = Path(__file__).resolve().parent.parent / "images"
BREAK = {
    "table": {"preset": "pool_9ft"},
    "rack": {"game": "nine_ball", "seed": 4},
    "balls": [{"id": "cue", "position": [0.8, 0.635]}],
    "shot": {"V0": 7.0, "phi_deg": 97.4},
}
POT = {
    "table": {"preset": "pool_9ft"},
    "balls": [
        {"id": "cue", "position": [0.635, 0.6]},
        {"id": "1", "position": [0.9, 1.4]},
        {"id": "2", "position": [0.4, 1.9]},
    ],
    "shot": {"V0": 2.5, "phi_deg": 90},
}


def draw(folder: Path) -> None:
    """Draw the exercise around its collision, a break of nine-ball, a million runs of the exercise, and a tolerance."""
    save_figure(figure_of(carom.load("midterm").run().filmstrip()), folder / "midterm.png", dpi=110)
    save_figure(figure_of(carom.Scenario.from_dict(BREAK).run().plot_paths()), folder / "break.png", dpi=110)
    directions, speeds = np.linspace(0, 90, 1000), np.linspace(0, 2.5, 1000)
    grid = carom.Grid({"balls.red.speed": speeds, "balls.red.direction_deg": directions})
    # At 200 dots per inch, so that each run has a dot.
    save_figure(figure_of(carom.load("midterm").ensemble(grid).map("blue.x")), folder / "map.png", dpi=200)
    save_figure(figure_of(_tolerance().map()), folder / "tolerance.png", dpi=110)


def _tolerance() -> carom.Tolerance:
    """Give how far off a pot may be, as the page about aiming has it."""
    pot = carom.Scenario.from_dict(POT)
    aimed = pot.with_values({"shot.phi_deg": aim.at_pot(pot, "2", "lt")})
    return aimed.tolerance({"shot.V0": 2, "shot.phi_deg": 0.8}, "2", carom.ExecutionNoise.preset("pool_tournament"))


if __name__ == "__main__":
    draw(FOLDER)
