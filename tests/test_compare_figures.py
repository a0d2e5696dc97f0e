"""Figures of comparisons: distance against time, and paths over one another."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from test_figures import discs_of

import carom
from carom import figures


def legend_of(shown: Axes | Figure) -> list[str]:
    legend = shown.get_legend() if isinstance(shown, Axes) else shown.legends[0]
    assert legend is not None
    return [text.get_text() for text in legend.get_texts()]


def lines_at(ax: Axes, time: float) -> int:
    """Count the vertical lines at a time."""
    return sum(list(line.get_xdata()) == [time, time] for line in ax.lines)


@pytest.fixture(scope="module")
def nudged(midterm: carom.Scenario) -> carom.RunComparison:
    return carom.compare(midterm, midterm.with_values({"balls.red.velocity[0]": 3.1}), names=("mine", "yours"))


@pytest.fixture(scope="module")
def moved(midterm: carom.Scenario) -> carom.TrajectoryComparison:
    table = midterm.run().trajectory(np.linspace(0.0, 5.0, 101)).to_dict()
    late = np.where(table["time"] > 2.0, 0.01, 0.0)
    return carom.compare_trajectory(midterm, {**table, "blue.x": table["blue.x"] + late})


def test_distance_of_runs_marks_where_their_events_part(nudged: carom.RunComparison) -> None:
    ax = nudged.plot_distance()
    assert ax.get_yscale() == "log"
    assert nudged.parting.time is not None
    assert lines_at(ax, nudged.parting.time) == 1
    assert {"red", "blue", "first event that differs"} <= set(legend_of(ax))
    red = next(line for line in ax.lines if line.get_label() == "red")
    drawn = np.asarray(red.get_ydata())
    far = nudged.distances[:, 0] > 1e-9
    assert np.array_equal(drawn[far], nudged.distances[far, 0])
    assert "events: mine above, yours below" in [text.get_text() for text in ax.texts]


def test_distance_of_a_trajectory_marks_its_first_difference(moved: carom.TrajectoryComparison) -> None:
    ax = moved.plot_distance()
    first = moved.first_difference
    assert first is not None
    assert first.time == pytest.approx(2.05)
    assert lines_at(ax, first.time) == 1
    assert {"tolerance", "first that differs (row 41)"} <= set(legend_of(ax))
    assert any(set(line.get_ydata()) == {1e-6} for line in ax.lines)


def test_distance_of_equal_runs_says_so(midterm: carom.Scenario) -> None:
    ax = carom.compare(midterm, midterm).plot_distance()
    assert "no distance at any time" in [text.get_text() for text in ax.texts]


def test_many_balls_are_a_crowd_and_their_farthest() -> None:
    scenario = carom.load("fifty_random")
    start = scenario.value("balls[0].position[0]")
    comparison = carom.compare(scenario, scenario.with_values({"balls[0].position[0]": start + 1e-9}), samples=50)
    assert {"each ball", "the farthest"} <= set(legend_of(comparison.plot_distance()))
    ax = comparison.plot_overlay()
    assert comparison.parting.event is not None
    drawn = {name for name in legend_of(figures.figure_of(ax)) if name in comparison.balls}
    assert drawn == set(comparison.parting.event.balls)
    assert f"up to t = {1.25 * comparison.parting.event.time:.3g}" in legend_of(figures.figure_of(ax))
    assert len(discs_of(ax)) == 2 * len(drawn)


def test_overlay_holds_both_paths_in_true_proportion(nudged: carom.RunComparison) -> None:
    ax = nudged.plot_overlay()
    assert ax.get_aspect() == 1.0
    ends = {tuple(np.round(disc.center, 9)) for disc in discs_of(ax)}
    wanted = [run.positions(5.0) for run in (nudged.a, nudged.b)]
    assert ends == {tuple(np.round(place, 9)) for places in wanted for place in places}
    assert {"mine", "yours", "red", "blue"} <= set(legend_of(figures.figure_of(ax)))


def test_overlay_of_a_trajectory_has_a_dot_for_each_row(moved: carom.TrajectoryComparison) -> None:
    ax = moved.plot_overlay(balls=["blue"])
    (dots,) = [line for line in ax.lines if line.get_marker() == "o" and len(line.get_xdata()) == 101]
    assert np.array_equal(dots.get_xdata(), moved.positions[:, 1, 0])
    crosses = [line for line in ax.lines if line.get_marker() == "X"]
    assert len(crosses) == 2
    with pytest.raises(ValueError, match="unknown ball 'green'"):
        moved.plot_overlay(balls=["green"])


def test_overlay_draws_another_table_too(midterm: carom.Scenario) -> None:
    same = carom.compare(midterm, midterm).plot_overlay()
    other = carom.compare(midterm, midterm.with_values({"table.length": 2.5})).plot_overlay()
    assert len(other.patches) == len(same.patches) + 1
    assert other.get_ylim()[1] > 2.5


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_scenario_can_be_compared_in_figures(name: str, tmp_path: Path) -> None:
    comparison = carom.compare(carom.load(name), carom.load(name), samples=20)
    for draw in (comparison.plot_distance, comparison.plot_overlay):
        figures.save_figure(figures.figure_of(draw()), tmp_path / "figure.png", dpi=30)


def test_a_long_id_is_shortened_in_legends() -> None:
    run = carom.load("midterm").with_values({"balls.red.id": "$" + "x" * 110}).run()
    comparison = carom.compare(run, run.scenario.with_values({"balls[0].velocity": [3.1, 4.0]}))
    distance = comparison.plot_distance().get_legend()
    (overlay,) = figures.figure_of(comparison.plot_overlay()).legends
    assert distance is not None
    for legend in (distance, overlay):
        names = [text.get_text() for text in legend.get_texts()]
        assert r"\$" + "x" * 10 + "\N{HORIZONTAL ELLIPSIS}" in names
