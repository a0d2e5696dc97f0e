"""Figures of scenarios and runs, for papers and slides.

Every figure takes `ax` (the filmstrip `axes`), draws there or on a new figure of its own outside pyplot, and
returns where it drew. `save_figure` writes PNG, PDF or SVG.
"""

from carom.figures.aims import plot_best_aim, plot_tolerance
from carom.figures.distance import plot_distance
from carom.figures.errors import plot_errors
from carom.figures.filmstrip import filmstrip
from carom.figures.maps import plot_map
from carom.figures.overlay import plot_overlay
from carom.figures.paths import plot_paths
from carom.figures.scenario import plot_scenario
from carom.figures.series import plot_energy, plot_height, plot_momentum, plot_speed, plot_spin
from carom.figures.style import FORMATS, figure_of, save_figure

__all__ = [
    "FORMATS",
    "figure_of",
    "filmstrip",
    "plot_best_aim",
    "plot_distance",
    "plot_energy",
    "plot_errors",
    "plot_height",
    "plot_map",
    "plot_momentum",
    "plot_overlay",
    "plot_paths",
    "plot_scenario",
    "plot_speed",
    "plot_spin",
    "plot_tolerance",
    "save_figure",
]
