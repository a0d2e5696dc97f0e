"""Figures of gases draw what they are given, where they are told, with units at the axes."""

from collections.abc import Callable

import matplotlib
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure

from carom.figures import figure_of, gas

TIME = np.linspace(0.1, 10.0, 100)
ONES = np.ones(100)
SI = {"length": "m", "time": "s", "mass": "kg"}

FIGURES: dict[str, tuple[Callable[..., Axes], str, str]] = {
    "compressibility": (
        lambda **more: gas.compressibility(TIME, 2 * ONES, 0.1 * ONES, reference=2.1, **more),
        "time (s)",
        "compressibility $Z = pA/(NkT)$",
    ),
    "speeds": (lambda **more: gas.speeds(TIME, **more), "speed (m/s)", "probability density (per m/s)"),
    "free_times": (lambda **more: gas.free_times(TIME, **more), "free time (s)", "probability density (per s)"),
    "h_function": (lambda **more: gas.h_function(TIME, -ONES, equilibrium=-1.2, **more), "time (s)", "Boltzmann's $H$"),
    "profile": (lambda **more: gas.profile(TIME, ONES, ONES, **more), "y (m)", "temperature (J)"),
    "radial_distribution": (
        lambda **more: gas.radial_distribution(TIME, ONES, contact=2.0, **more),
        "distance (m)",
        "$g(r)$",
    ),
    "diffusion": (
        lambda **more: gas.diffusion(TIME, TIME**2, correlation_time=TIME, correlation=ONES, diffusivity=0.5, **more),
        "time (s)",
        "mean squared displacement (m²)",
    ),
    "psi6": (lambda **more: gas.psi6(TIME, 0.5 * ONES, discs=100, **more), "time (s)", r"hexagonal order $|\psi_6|$"),
    "cooling": (lambda **more: gas.cooling(TIME, 1 / TIME, haff_time=2.0, **more), "time (s)", "temperature $T/T_0$"),
}


def ellipses(ax: Axes) -> EllipseCollection:
    (shown,) = (each for each in ax.collections if isinstance(each, EllipseCollection))
    return shown


@pytest.mark.parametrize("name", FIGURES)
def test_figures_are_drawn_where_they_are_told_with_units_and_leave_settings_alone(name: str) -> None:
    draw, below, left = FIGURES[name]
    before = dict(matplotlib.rcParams)
    given = Figure().add_subplot()
    assert draw(ax=given, units=SI) is given
    assert (given.get_xlabel(), given.get_ylabel()) == (below, left)
    own = draw()
    assert figure_of(own) is not figure_of(given)
    assert r"\sigma" in own.get_xlabel() or r"\sqrt" in own.get_xlabel(), "the units of the reduced gas"
    assert draw(units={}).get_xlabel() in below, "without units there are no brackets"
    assert dict(matplotlib.rcParams) == before


@pytest.mark.parametrize("name", FIGURES)
def test_legends_lie_above_the_data(name: str) -> None:
    ax = FIGURES[name][0]()
    figure = figure_of(ax)
    figure.canvas.draw()
    legend = ax.get_legend()
    assert legend is not None
    box = legend.get_window_extent()
    assert box.y0 >= ax.get_window_extent().y1
    assert box.y1 <= figure.bbox.y1
    assert box.x1 <= figure.bbox.x1


def test_theory_is_drawn_as_it_is_written() -> None:
    (maxwell,) = gas.speeds(np.array([1.0, 2.0]), temperature=2.0, mass=3.0).lines
    speed, density = maxwell.get_data()
    assert np.allclose(density, 1.5 * np.asarray(speed) * np.exp(-0.75 * np.asarray(speed) ** 2))
    lines = {line.get_label(): line.get_data() for line in gas.cooling(TIME, 1 / TIME, haff_time=2.0).lines}
    assert np.allclose(lines["Haff, τ = 2"][1], (1 + TIME / 2) ** -2)
    assert np.allclose(lines["measured"][1], TIME[0] / TIME)
    lines = {line.get_label(): line.get_data() for line in gas.diffusion(TIME, TIME, diffusivity=0.5).lines}
    assert np.allclose(lines["$4Dt$, $D$ = 0.5"][1], 2 * TIME)
    assert np.allclose(lines["flight, $2kT t^2/m$"][1], 2 * TIME**2)


def test_the_histogram_of_free_times_is_a_density() -> None:
    values = np.random.default_rng(5).exponential(0.5, 2000)
    ax = gas.free_times(values, bins=20)
    (points,) = (container.lines[0] for container in ax.containers)
    _, density = points.get_data()
    width = (values.max() - values.min()) / 20
    assert np.isclose(np.sum(density) * width, 1.0)
    assert ax.get_yscale() == "log"


def test_the_first_values_of_a_running_mean_do_not_set_the_axis() -> None:
    values = 2 * ONES
    values[0] = 100.0
    low, high = gas.compressibility(TIME, values, reference=2.1).get_ylim()
    assert (low < 2.0, high > 2.1, high < 3.0) == (True, True, True)


def test_discs_on_the_edge_of_a_periodic_box_are_on_both_sides() -> None:
    positions = np.array([[0.1, 1.0], [3.95, 2.9], [2.0, 1.5], [9.0, -1.4]])
    radii = np.array([0.25, 0.25, 0.25, 0.5])
    both = ellipses(gas.discs(positions, radii, (4, 3)))
    # One on an edge, one in a corner (which is on four), one within, one wrapped to (1, 1.6).
    assert len(both.get_offsets()) == 2 + 4 + 1 + 1
    assert [1.0, 1.6] in np.round(both.get_offsets(), 12).tolist()
    assert [-0.05, -0.1] in np.round(both.get_offsets(), 12).tolist()
    walls = ellipses(gas.discs(positions[:3], radii[:3], (4, 3), periodic=(False, False)))
    assert np.array_equal(walls.get_offsets(), positions[:3])


def test_discs_are_coloured_by_numbers_or_by_the_angle_of_complex_ones() -> None:
    positions, radii = np.ones((3, 2)) * [[1], [2], [3]], np.full(3, 0.4)
    ax = gas.discs(positions, radii, (4, 4), values=np.array([1.0, 2.0, 4.0]), words="speed (m/s)")
    assert np.array_equal(ellipses(ax).get_array(), [1.0, 2.0, 4.0])
    turned = gas.discs(positions, radii, (4, 4), values=np.exp(6j * np.radians([0.0, 10.0, -20.0])))
    assert np.allclose(ellipses(turned).get_array(), [0.0, 10.0, -20.0])
    assert ellipses(turned).norm.vmin == -30.0


def test_a_hundred_thousand_discs_are_one_collection() -> None:
    places = np.random.default_rng(2).random((100_000, 2)) * 300
    ax = gas.discs(places, np.full(100_000, 0.3), (300, 300), values=places[:, 0])
    assert len(ax.collections) == 1
    assert len(ellipses(ax).get_offsets()) >= 100_000
