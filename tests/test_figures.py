"""The figures show what the run holds, where it is, and leave matplotlib as they found it."""

import itertools
import subprocess
import sys
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import EllipseCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch, PathPatch
from numpy.typing import NDArray

import carom
from carom import figures
from carom.colours import PALETTE, ball_colours
from carom.figures.outline import table_loops
from carom.figures.scene import Scene
from carom.figures.table import arrow_scale, draw_table, table_contains

DRAWINGS = [figures.plot_paths, figures.plot_energy, figures.plot_speed, figures.plot_momentum]


def discs_of(ax: Axes, *, filled: bool = True) -> list[Circle]:
    discs = [patch for patch in ax.patches if isinstance(patch, Circle)]
    return [disc for disc in discs if (disc.get_facecolor()[3] > 0) == filled]


def arrows_of(ax: Axes, *, faint: bool = False) -> list[FancyArrowPatch]:
    arrows = [patch for patch in ax.patches if isinstance(patch, FancyArrowPatch)]
    return [arrow for arrow in arrows if (arrow.get_linestyle() not in ("solid", "-")) == faint]


def centres_of(ax: Axes, *, filled: bool = True) -> NDArray[np.float64]:
    return np.array([disc.center for disc in discs_of(ax, filled=filled)])


def drawn(axes: Axes | list[Axes]) -> Figure:
    figure = figures.figure_of(axes)
    figure.canvas.draw()
    return figure


@pytest.fixture(scope="module")
def stadium() -> carom.Run:
    pieces = [
        {"line": [[0, 0], [1, 0]]},
        {"arc": {"center": [1, 0.5], "radius": 0.5, "from_deg": -90, "to_deg": 90}},
        {"line": [[1, 1], [0, 1]]},
        {"arc": {"center": [0, 0.5], "radius": 0.5, "from_deg": 90, "to_deg": 270}},
    ]
    obstacle = {"circle": {"center": [0.5, 0.5], "radius": 0.1}}
    point = carom.Ball("p", radius=0.0, position=(0.3, 0.2), velocity=(0.8, 0.6))
    table = {"shape": "path", "pieces": pieces, "obstacles": [obstacle]}
    return carom.Scenario(table, [point], duration=6).run()


# Scenarios


def test_a_scenario_is_drawn_as_it_starts(midterm: carom.Scenario) -> None:
    ax = midterm.plot()
    (discs,) = [each for each in ax.collections if isinstance(each, EllipseCollection)]
    np.testing.assert_array_equal(np.asarray(discs.get_offsets()), [[0.1, 0.1], [0.5, 1.0]])
    assert [text.get_text() for text in ax.texts] == ["red", "blue"]
    (arrow,) = arrows_of(ax)
    tail, tip = (np.array(place) for place in arrow._posA_posB)  # type: ignore[attr-defined]
    assert np.linalg.norm(tail - [0.1, 0.1]) == pytest.approx(0.075)
    np.testing.assert_allclose((tip - tail) / np.linalg.norm(tip - tail), [0.6, 0.8])


def test_ids_stand_only_in_discs_with_room_and_as_they_are(midterm: carom.Scenario) -> None:
    for name, shown in (("$x$", ["$x$", "blue"]), ("$\\frac$", ["$\\frac$", "blue"]), (50 * "r", ["blue"])):
        ax = midterm.with_values({"balls.red.id": name}).plot()
        drawn(ax)
        assert [text.get_text() for text in ax.texts] == shown
    small = midterm.with_values({"ball_defaults.radius": 0.01}).plot()
    assert not small.texts


def test_a_crowd_is_drawn_without_arrows() -> None:
    balls = [carom.Ball(f"b{k}", radius=0, position=(1 + k % 20, 1 + k // 20), velocity=(1, 0)) for k in range(101)]
    table = carom.Table.rectangle(width=21, length=21)
    assert len(arrows_of(carom.Scenario(table, balls[:100], duration=1).plot())) == 100
    assert not arrows_of(carom.Scenario(table, balls, duration=1).plot())


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_ready_made_scenario_can_be_drawn(name: str) -> None:
    drawn(carom.load(name).plot())


# Filmstrips


def test_exact_frames_are_equal_times_apart_with_the_event_in_the_middle(run: carom.Run) -> None:
    contact = run.events.by_kind("ball_ball")[0]
    axes = run.filmstrip()
    assert len(axes) == 3
    places = [centres_of(ax) for ax in axes]
    np.testing.assert_array_equal(places[1], run.positions(contact.time))
    spacings = np.linspace(0.0, 0.2, 20001)
    before = run.positions(contact.time - spacings)[:, 0]
    spacing = spacings[np.argmin(np.linalg.norm(before - places[0][0], axis=1))]
    np.testing.assert_allclose(places[0], run.positions(contact.time - spacing), atol=1e-4)
    np.testing.assert_allclose(places[2], run.positions(contact.time + spacing), atol=1e-4)


@pytest.mark.parametrize("around", ["ball_ball", 1.0, 3, "table", "empty"])
def test_a_filmstrip_is_around_one_event(run: carom.Run, around: Any) -> None:
    parts = {"table": run.events.by_kind("ball_ball"), "empty": run.events[:0]}
    with pytest.raises(TypeError, match=r"around: must be one event, such as run\.events\[0\], got"):
        run.filmstrip(around=parts.get(around, around))


def test_exact_balls_are_apart_before_and_after_and_on_the_flights_that_meet(run: carom.Run) -> None:
    contact = run.events.by_kind("ball_ball")[0]
    before, at, after = (np.linalg.norm(np.diff(centres_of(ax), axis=0)) for ax in run.filmstrip())
    assert at == pytest.approx(0.15, abs=1e-12)
    assert min(before, after) > 0.15 + 0.075
    times = run.events["time"]
    last, following = times[times < contact.time].max(), times[times > contact.time].min()
    red_before = centres_of(run.filmstrip()[0])[0]
    fraction = (run.positions(contact.time)[0] - red_before) / run.velocities(last)[0]
    assert 0 < fraction[0] < contact.time - last
    assert fraction[0] == pytest.approx(fraction[1])
    assert following > contact.time


def test_stepped_frames_are_the_schemes_own(stepped: carom.Run) -> None:
    assert stepped.steps is not None
    contact = stepped.events.by_kind("ball_ball")[0]
    steps = stepped.steps["time"]
    k = int(np.flatnonzero(steps < contact.time)[-1])
    before, at, after = (centres_of(ax) for ax in stepped.filmstrip())
    np.testing.assert_array_equal(before, stepped.positions(steps[k]))
    np.testing.assert_array_equal(at, stepped.positions(contact.time))
    np.testing.assert_array_equal(after, stepped.positions(steps[k + 2]))
    np.testing.assert_array_equal(stepped.positions(steps[k + 1]), at)


@pytest.mark.parametrize("frames", [3, 5])
def test_titles_say_time_and_moment(run: carom.Run, frames: int) -> None:
    axes = run.filmstrip(frames=frames)
    titles = [ax.get_title() for ax in axes]
    middle = frames // 2
    assert "0.8647" in titles[middle]
    assert "collision" in titles[middle]
    assert all("before" in title for title in titles[:middle])
    assert all("after" in title for title in titles[middle + 1 :])
    drawn(axes)
    renderer = FigureCanvasAgg(figures.figure_of(axes)).get_renderer()
    boxes = [ax.title.get_window_extent(renderer) for ax in axes]
    assert all(one.x1 < other.x0 for one, other in itertools.pairwise(boxes))


@pytest.mark.parametrize(("width", "length"), [(1.0, 200.0), (1e-9, 2e-9)])
def test_titles_of_tall_and_of_tiny_tables_are_apart_and_differ(width: float, length: float) -> None:
    table = carom.Table.rectangle(width=width, length=length)
    ball = carom.Ball("p", radius=0.1 * width, position=(width / 2, width / 2), velocity=(3, 4))
    axes = carom.Scenario(table, [ball], duration=5 * width).run().filmstrip()
    assert len({ax.get_title() for ax in axes}) == 3
    figure = drawn(axes)
    renderer = FigureCanvasAgg(figure).get_renderer()
    boxes = [ax.title.get_window_extent(renderer) for ax in axes]
    assert all(one.x1 < other.x0 for one, other in itertools.pairwise(boxes))
    assert boxes[0].x0 > 0
    assert boxes[-1].x1 < figure.bbox.width
    assert all(box.y1 <= figure.bbox.height for box in boxes)


def test_units_stand_in_titles_and_at_axes(midterm: carom.Scenario) -> None:
    run = midterm.with_values({"units": {"length": "m", "time": "s", "mass": "kg"}}).run()
    assert "0.8647 s" in run.filmstrip()[1].get_title()
    assert run.plot_paths().get_xlabel() == "x (m)"
    assert run.plot_energy().get_ylabel() == "energy (J)"
    assert run.plot_speed().get_ylabel() == "speed (m/s)"
    assert run.plot_momentum().get_ylabel() == "momentum (kg m/s)"


def test_every_moving_ball_has_one_arrow_and_a_resting_one_none(run: carom.Run) -> None:
    before, at, after = run.filmstrip()
    assert [len(arrows_of(ax)) for ax in (before, at, after)] == [1, 2, 2]
    assert len(arrows_of(at, faint=True)) == 1
    assert [len(arrows_of(ax)) for ax in run.filmstrip(arrows=False)] == [0, 0, 0]


def test_arrows_start_at_centres_and_their_tips_lie_on_the_cloth(run: carom.Run) -> None:
    for event in run.events:
        for ax in run.filmstrip(event):
            for arrow in arrows_of(ax):
                (tail, tip) = (np.array(place) for place in arrow._posA_posB)  # type: ignore[attr-defined]
                assert np.linalg.norm(centres_of(ax) - tail, axis=1).min() < 1e-12
                assert np.all((tip > 0) & (tip < [1, 2]))


def test_the_contact_frame_has_a_normal_and_a_tangent(run: carom.Run) -> None:
    axes = run.filmstrip()
    assert [[text.get_text() for text in ax.texts] for ax in axes] == [[], ["n", "t"], []]
    assert all(not ax.texts for ax in run.filmstrip(contact_axes=False))


@pytest.mark.parametrize("name", ["midterm", "tilted", "stadium", "triangle_break", "counting_pi"])
def test_the_names_of_normal_and_tangent_lie_on_the_cloth_beside_the_discs(name: str) -> None:
    run = carom.load(name).run(collisions=40)
    axes = run.filmstrip()
    renderer = FigureCanvasAgg(drawn(axes)).get_renderer()
    inside = table_contains(Scene.of(run.scenario))
    discs = [disc.get_window_extent(renderer) for disc in discs_of(axes[1])]
    for text in axes[1].texts:
        assert inside(np.array([text.get_position()]))
        x, y = axes[1].transData.transform(text.get_position())
        assert not any(disc.contains(x, y) for disc in discs)


def test_no_arrow_is_cut_off(run: carom.Run) -> None:
    assert not any(arrow.get_clip_on() for ax in run.filmstrip() for arrow in arrows_of(ax))


def test_a_filmstrip_can_show_any_event_of_any_table(run: carom.Run, stadium: carom.Run) -> None:
    for shown in (run, stadium):
        for event in shown.events:
            axes = shown.filmstrip(event)
            np.testing.assert_allclose(centres_of(axes[1]), shown.positions(event.time), atol=1e-12)


def test_an_event_at_the_end_of_its_run_can_be_shown(midterm: carom.Scenario) -> None:
    run = midterm.run(collisions=4)
    axes = run.filmstrip(run.events[3])
    np.testing.assert_array_equal(centres_of(axes[1]), centres_of(axes[2]))
    assert np.linalg.norm(np.diff(centres_of(axes[0]), axis=0)) > 0.2


def test_what_cannot_be_shown_is_refused(run: carom.Run, midterm: carom.Scenario) -> None:
    with pytest.raises(ValueError, match="odd"):
        run.filmstrip(frames=4)
    with pytest.raises(ValueError, match="one axes for each"):
        run.filmstrip(axes=[Figure().add_subplot()])
    with pytest.raises(ValueError, match="no event"):
        midterm.run(duration=0.1).filmstrip()


# Paths


def test_paths_go_from_rings_to_discs(run: carom.Run) -> None:
    ax = run.plot_paths()
    np.testing.assert_array_equal(centres_of(ax), run.positions(run.end_time))
    np.testing.assert_array_equal(centres_of(ax, filled=False)[:2], run.positions(0.0))
    assert [disc.radius for disc in discs_of(ax)] == [0.075, 0.075]


def test_paths_pass_through_every_place_where_a_ball_turned(run: carom.Run) -> None:
    lines = run.plot_paths().lines
    for ball, name in enumerate(run.ball_ids):
        turns = run.positions(run.events.by_ball(name)["time"])[:, ball]
        path = np.stack(lines[ball].get_data(), axis=1)
        for turn in turns:
            assert np.linalg.norm(path - turn, axis=1).min() == 0.0


def test_collisions_are_marked_at_their_places_and_numbered_as_in_the_table_of_events(run: carom.Run) -> None:
    ax = run.plot_paths()
    marks = [line for line in ax.lines if line.get_linestyle() == "None"]
    assert {line.get_marker() for line in marks} == {"o", "D"}
    places = np.concatenate([np.stack(line.get_data(), axis=1) for line in marks])
    expected = np.stack([run.events["x"], run.events["y"]], axis=1)
    np.testing.assert_array_equal(np.sort(places, axis=0), np.sort(expected, axis=0))
    assert sorted(int(text.get_text()) for text in ax.texts) == run.events["index"].tolist()


def test_numbers_cover_neither_each_other_nor_the_marks(run: carom.Run) -> None:
    ax = run.plot_paths()
    renderer = FigureCanvasAgg(drawn(ax)).get_renderer()
    boxes = [text.get_window_extent(renderer) for text in ax.texts]
    pairs = [(a, b) for k, a in enumerate(boxes) for b in boxes[k + 1 :]]
    assert not any(a.overlaps(b) for a, b in pairs)
    marks = ax.transData.transform(np.stack([run.events["x"], run.events["y"]], axis=1))
    assert not any(box.contains(*mark) for box in boxes for mark in marks)


def test_the_legend_of_paths_names_what_there_is(run: carom.Run, stadium: carom.Run) -> None:
    for shown, words in (
        (run, ["start", "end", "ball-ball", "cushion", "contact"]),
        (stadium, ["start", "end", "cushion"]),
    ):
        (legend,) = figures.figure_of(shown.plot_paths()).legends
        assert [text.get_text() for text in legend.get_texts()] == words


@pytest.mark.parametrize("draw", [figures.plot_energy, figures.plot_speed])
def test_a_long_id_is_shortened_in_a_legend(draw: Any, midterm: carom.Scenario) -> None:
    ax = draw(midterm.with_values({"balls.red.id": "x" * 110}).run())
    renderer = FigureCanvasAgg(drawn(ax)).get_renderer()
    legend = ax.get_legend()
    assert legend.get_texts()[0].get_text() == "x" * 11 + "\N{HORIZONTAL ELLIPSIS}"
    assert legend.get_window_extent(renderer).x1 <= drawn(ax).bbox.width


def test_many_events_are_not_numbered(run: carom.Run) -> None:
    assert not run.resume(duration=60.0).plot_paths().texts
    assert not run.plot_paths(numbers=False).texts


# Curves against time


@pytest.mark.parametrize("method", ["run", "stepped"])
def test_energy_is_drawn_with_its_jumps(method: str, request: pytest.FixtureRequest) -> None:
    run = request.getfixturevalue(method)
    total = next(line for line in run.plot_energy().lines if line.get_label() == "total")
    times, energy = (np.asarray(values) for values in total.get_data())
    np.testing.assert_array_equal(energy, run.energy(times))
    for time in run.events.by_kind("ball_cushion")["time"]:
        at = int(np.searchsorted(times, time))
        assert times[at] == time
        assert times[at - 1] == np.nextafter(time, -np.inf)
        assert energy[at] < energy[at - 1]


def test_energy_in_a_field_is_drawn_in_its_parts() -> None:
    ax = carom.load("tilted").run().plot_energy()
    lines = {str(line.get_label()): np.asarray(line.get_ydata()) for line in ax.lines}
    np.testing.assert_array_equal(lines["total"], lines["kinetic"] + lines["potential"])
    assert lines["potential"].min() >= 0.0
    assert np.all(np.diff(lines["total"]) < 1e-9 * lines["total"][0])


def test_speed_and_momentum_are_the_runs(run: carom.Run) -> None:
    for line, ball in zip(run.plot_speed().lines, range(2), strict=False):
        times = np.asarray(line.get_xdata())
        speed = np.linalg.norm(run.velocities(times)[:, ball], axis=-1)
        np.testing.assert_array_equal(np.asarray(line.get_ydata()), speed)
    for line, axis in zip(run.plot_momentum().lines, range(2), strict=False):
        times = np.asarray(line.get_xdata())
        np.testing.assert_array_equal(np.asarray(line.get_ydata()), run.momentum(times)[:, axis])


@pytest.mark.parametrize("draw", DRAWINGS[1:])
def test_every_event_has_a_tick_by_its_kind(run: carom.Run, draw: "type[figures.plot_energy]") -> None:
    ax = draw(run)
    ticks = {str(each.get_label()): len(each.get_paths()) for each in ax.collections}
    kinds = run.events["kind"].tolist()
    assert ticks == {"cushion": kinds.count("ball_cushion"), "ball-ball": kinds.count("ball_ball")}


def test_a_balls_energy_is_seen_where_it_is_the_total(run: carom.Run) -> None:
    red, blue, total = run.plot_energy().lines[:3]
    assert total.get_label() == "total"
    assert total.get_zorder() < min(red.get_zorder(), blue.get_zorder())
    assert total.get_linewidth() > 2 * max(red.get_linewidth(), blue.get_linewidth())


def test_a_constant_speed_is_drawn_below_the_edge(stadium: carom.Run) -> None:
    assert stadium.plot_speed().get_ylim()[1] > 1.04


@pytest.mark.parametrize(("mass", "label"), [(1.0, "energy (J)"), (1e9, r"energy ($10^{10}$ J)")])
def test_large_numbers_are_multiples_of_a_power_of_ten(midterm: carom.Scenario, mass: float, label: str) -> None:
    units = {"units": {"length": "m", "time": "s", "mass": "kg"}, "ball_defaults.mass": mass}
    ax = midterm.with_values(units).run().plot_energy()
    assert ax.get_ylabel() == label
    renderer = FigureCanvasAgg(drawn(ax)).get_renderer()
    assert ax.get_tightbbox(renderer).x0 >= 0.0
    assert max(len(text.get_text()) for text in ax.get_yticklabels()) <= 4


@pytest.mark.parametrize("draw", DRAWINGS[1:])
def test_legends_do_not_cover_the_curves(run: carom.Run, draw: "type[figures.plot_energy]") -> None:
    ax = draw(run)
    renderer = FigureCanvasAgg(drawn(ax)).get_renderer()
    legend = ax.get_legend()
    assert legend is not None
    assert legend.get_window_extent(renderer).y0 >= ax.get_window_extent(renderer).y1 - 1.0


# The comparison of methods


def test_errors_are_drawn_on_two_logarithmic_scales(midterm: carom.Scenario) -> None:
    comparison = carom.compare_steps(midterm, [0.03, 0.01, 0.001])
    ax = figures.plot_errors(comparison)
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    marked = [line for line in ax.lines if line.get_marker() == "o"]
    shown = sorted(float(x) for line in marked for x in np.asarray(line.get_xdata()))
    assert shown == [0.001, 0.01, 0.03]


# Tables


def test_tables_keep_their_proportions(run: carom.Run, stadium: carom.Run) -> None:
    for shown in (run, stadium):
        for ax in (*shown.filmstrip(), shown.plot_paths()):
            assert ax.get_aspect() == 1.0
            drawn(ax)
            (x0, y0), (x1, y1) = ax.transData.transform([[0.0, 0.0], [1.0, 1.0]])
            assert x1 - x0 == pytest.approx(y1 - y0)


def test_a_boundary_of_lines_and_arcs_is_one_closed_path_with_its_obstacles(stadium: carom.Run) -> None:
    scene = Scene.of(stadium.scenario)
    loops = table_loops(scene)
    assert [part for part, _ in loops] == ["boundary", "obstacle"]
    inside = table_contains(scene)
    assert inside(np.array([[0.0, 0.5], [1.45, 0.5], [-0.45, 0.5], [0.5, 0.1]]))
    for outside in ([1.4, 0.95], [0.5, 0.5], [0.5, 1.1], [-0.4, 0.05]):
        assert not inside(np.array([outside]))
    ax = Figure().add_subplot()
    draw_table(ax, scene)
    assert len([patch for patch in ax.patches if isinstance(patch, PathPatch)]) == 4


def test_arrows_of_resting_balls_have_no_scale(run: carom.Run) -> None:
    scene = Scene.of(run.scenario)
    assert arrow_scale(scene, [(np.ones((2, 2)), np.zeros((2, 2)))], 1.0) == 0.0


def test_a_point_is_drawn_large_enough_to_be_seen(stadium: carom.Run) -> None:
    assert discs_of(stadium.plot_paths())[0].radius > 0.0


# Colours


def test_colours_come_from_the_scenario_then_the_name_then_the_palette() -> None:
    chosen = ball_colours(["red", "8", "9", "x"], [None, "Gold", (1.0, 0.0, 0.5), None])
    assert chosen[0] == PALETTE[0]
    assert chosen[1] == "gold"
    np.testing.assert_allclose(to_rgb(chosen[2]), (1.0, 0.0, 0.5), atol=1 / 255)
    assert chosen[3] == PALETTE[1]


def test_palette_cycles() -> None:
    assert ball_colours([str(k) for k in range(20)], [None] * 20)[8:16] == list(PALETTE)


# Manners


@pytest.mark.parametrize("draw", DRAWINGS)
def test_figures_draw_on_the_given_axes_and_return_them(run: carom.Run, draw: "type[figures.plot_energy]") -> None:
    ax = Figure().add_subplot()
    assert draw(run, ax=ax) is ax
    assert ax.lines


def test_a_scenario_is_drawn_on_the_given_axes(midterm: carom.Scenario) -> None:
    ax = Figure().add_subplot()
    assert midterm.plot(ax=ax) is ax
    assert ax.patches


def test_filmstrip_draws_on_the_given_axes(run: carom.Run) -> None:
    given = list(Figure().subplots(1, 3))
    assert run.filmstrip(axes=given) == given


def test_global_settings_and_pyplot_are_left_alone(run: carom.Run, tmp_path: Path) -> None:
    before = dict(matplotlib.rcParams)
    for draw in DRAWINGS:
        figures.save_figure(figures.figure_of(draw(run)), tmp_path / "figure.pdf")
    figures.save_figure(figures.figure_of(run.filmstrip()), tmp_path / "filmstrip.svg")
    assert dict(matplotlib.rcParams) == before


def test_figures_need_no_pyplot_and_no_display() -> None:
    code = (
        "import sys, carom; run = carom.load('midterm').run()\n"
        "run.filmstrip(); run.plot_paths(); run.plot_energy()\n"
        "print('matplotlib.pyplot' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "False"


@pytest.mark.parametrize("kind", figures.FORMATS)
def test_figures_save_and_the_same_figure_gives_the_same_file(run: carom.Run, tmp_path: Path, kind: str) -> None:
    one, other = (figures.save_figure(figures.figure_of(run.filmstrip()), tmp_path / f"{name}.{kind}") for name in "ab")
    magic = {"png": b"\x89PNG", "pdf": b"%PDF", "svg": b"<?xml"}[kind]
    assert one.read_bytes().startswith(magic)
    assert one.read_bytes() == other.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"a.{kind}", f"b.{kind}"]
