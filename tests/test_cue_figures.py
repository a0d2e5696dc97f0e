"""The figures and films of balls on a cloth show where they are, how they move and what became of them."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, FancyArrowPatch, Polygon
from numpy.typing import NDArray
from PIL import Image

import carom
from carom import figures
from carom.figures.beside import TIP
from carom.figures.rails import Rails
from carom.figures.scene import Scene
from carom.figures.travels import WAYS, Travels
from carom.figures.turning import DOT, seen_from_above, turned
from carom.report.pictures import figures_of

GAMES = {
    "pool_9ft": "nine_ball",
    "pool_8ft": "eight_ball",
    "snooker_12ft": "snooker",
    "carom_10ft": "three_cushion",
    "english_pool": "english_pool",
}
SERIES = [figures.plot_energy, figures.plot_speed, figures.plot_spin, figures.plot_momentum]


def scenario(balls: dict[str, list[float]], preset: str = "pool_9ft", **shot: Any) -> carom.Scenario:
    rows = [{"id": name, "position": place} for name, place in balls.items()]
    return carom.Scenario.from_dict({"table": {"preset": preset}, "balls": rows, "shot": shot})


def break_of(preset: str) -> carom.Scenario:
    cue_ball = "white" if preset in ("snooker_12ft", "carom_10ft") else "cue"
    shot = {"cue_ball": cue_ball, "V0": 6.0, "phi_deg": 89.0}
    return carom.Scenario.from_dict({"table": {"preset": preset}, "rack": {"game": GAMES[preset]}, "shot": shot})


@pytest.fixture(scope="module", params=GAMES)
def opening(request: pytest.FixtureRequest) -> carom.Run:
    return break_of(request.param).run()


@pytest.fixture(scope="module")
def side() -> carom.Run:
    """A shot with side spin at one ball, without a ball out of play."""
    return scenario({"cue": [0.4, 0.7], "8": [0.75, 1.35]}, V0=2.2, phi_deg=60.8, a=0.3, b=0.2).run()


@pytest.fixture(scope="module")
def jump() -> carom.Run:
    """A shot over one ball, which lands and stays on the table."""
    balls = {"cue": [0.4, 0.6], "7": [0.5, 0.9]}
    return scenario(balls, V0=3.4, phi_deg=71, theta_deg=40).run()


@pytest.fixture(scope="module")
def potted() -> carom.Run:
    """A ball that is played straight into a corner pocket."""
    return scenario({"9": [0.3, 0.3], "cue": [0.6, 0.6]}, V0=2.0, phi_deg=225).run()


def drawn(axes: Axes | list[Axes]) -> Figure:
    figure = figures.figure_of(axes)
    figure.canvas.draw()
    return figure


def discs_of(ax: Axes, *, filled: bool = True) -> list[Circle]:
    discs = [patch for patch in ax.patches if isinstance(patch, Circle)]
    return [disc for disc in discs if (disc.get_facecolor()[3] > 0) == filled]


def notes_of(ax: Axes) -> Axes:
    """The axes beside the table's."""
    table, notes = figures.figure_of(ax).axes
    assert table is ax
    return notes


def words_of(ax: Axes) -> list[str]:
    return [text.get_text() for text in notes_of(ax).texts]


def lines_by(ax: Axes, way: str) -> list[Line2D]:
    """The lines of paths that stand for a motion: those with the dashes of its sample."""

    def has_its_dashes(line: Line2D) -> bool:
        sample = Line2D([], [], linestyle=WAYS[way][1], linewidth=line.get_linewidth())
        looks = [(each.get_linestyle(), each._dash_pattern) for each in (line, sample)]  # type: ignore[attr-defined]
        return bool(looks[0] == looks[1])

    return list(filter(has_its_dashes, ax.lines))


def places_of(lines: list[Line2D]) -> NDArray[np.float64]:
    return np.concatenate([np.stack(line.get_data(), axis=1) for line in lines])


# All games


def test_every_figure_of_every_game_can_be_drawn(opening: carom.Run) -> None:
    drawn(opening.scenario.plot())
    drawn(opening.plot_paths())
    drawn(opening.filmstrip())
    for draw in SERIES:
        drawn(draw(opening))


def test_tables_keep_their_proportions_and_show_all_of_the_frame(opening: carom.Run) -> None:
    x_min, y_min, x_max, y_max = Scene.of(opening.scenario).bounds
    for ax in (opening.scenario.plot(), opening.plot_paths()):
        drawn(ax)
        (x0, y0), (x1, y1) = ax.transData.transform([[0.0, 0.0], [1.0, 1.0]])
        assert x1 - x0 == pytest.approx(y1 - y0)
        assert ax.get_xlim()[0] < x_min < 0
        assert ax.get_xlim()[1] > x_max
        assert ax.get_ylim()[0] < y_min < 0
        assert ax.get_ylim()[1] > y_max


def test_what_stands_beside_the_table_covers_nothing(opening: carom.Run) -> None:
    ax = opening.plot_paths()
    figure = drawn(ax)
    notes = notes_of(ax)
    renderer = FigureCanvasAgg(figure).get_renderer()
    boxes = [text.get_window_extent(renderer) for text in notes.texts]
    assert ax.get_tightbbox(renderer).x1 <= min(box.x0 for box in boxes)
    assert max(box.x1 for box in boxes) <= figure.bbox.width
    assert max(box.y1 for box in boxes) <= figure.bbox.height
    assert not any(one.overlaps(other) for k, one in enumerate(boxes) for other in boxes[k + 1 :])


def test_figures_draw_on_given_axes_alone(opening: carom.Run) -> None:
    for draw in (opening.plot_paths, opening.scenario.plot):
        figure = Figure()
        ax = figure.add_subplot()
        assert draw(ax=ax) is ax
        assert figure.axes == [ax]


def test_units_of_a_preset_stand_at_the_axes(side: carom.Run) -> None:
    assert side.plot_paths().get_xlabel() == "x (m)"
    assert figures.plot_spin(side).get_ylabel() == "spin (rad/s)"
    assert side.plot_energy().get_ylabel() == "energy (J)"


# Tables


def test_a_pocket_table_has_rails_of_its_own_measures(side: carom.Run) -> None:
    rails = Scene.of(side.scenario).rails
    assert rails is not None
    assert (rails.width, rails.length, rails.cushion) == (1.27, 2.54, 0.0508)
    assert len(rails.pockets) == 6
    for pocket in rails.pockets:
        assert np.all(np.array(pocket["center"]) > -rails.wood)
    assert rails.has_sights


@pytest.mark.parametrize(("preset", "sights"), [("carom_10ft", True), ("snooker_12ft", False), ("english_pool", False)])
def test_sights_are_on_the_tables_that_have_them(preset: str, sights: bool) -> None:
    rails = Scene.of(break_of(preset)).rails
    assert isinstance(rails, Rails)
    assert rails.has_sights == sights


def test_discs_have_no_rails(midterm: carom.Scenario) -> None:
    scene = Scene.of(midterm)
    assert scene.rails is None
    assert scene.aim is None
    assert not scene.on_cloth


# Paths


def test_ways_of_moving_are_told_apart(jump: carom.Run) -> None:
    ax = jump.plot_paths()
    times = np.linspace(0.0, jump.end_time, 400)
    motions = jump.motion(times)
    for way in WAYS:
        met = bool(np.any(motions == way))
        assert bool(lines_by(ax, way)) == met
        assert (WAYS[way][0] in words_of(ax)) == met
    assert lines_by(ax, "airborne")


def test_a_line_shows_where_its_ball_moves_so(side: carom.Run) -> None:
    ax = side.plot_paths()
    rolling, sliding = (places_of(lines_by(ax, way)) for way in ("rolling", "sliding"))
    change = side.events.by_kind("slide_to_roll")[0]
    ball = side.ball_ids.index(str(change.ball_a))
    place = side.positions(change.time)[ball, :2]
    for places in (rolling, sliding):
        assert np.nanmin(np.linalg.norm(places - place, axis=1)) == 0.0
    before = side.positions(0.5 * change.time)[ball, :2]
    assert np.nanmin(np.linalg.norm(sliding - before, axis=1)) < 0.02
    assert np.nanmin(np.linalg.norm(rolling - before, axis=1)) > 0.05


def test_changes_of_motion_have_no_numbers_and_others_those_of_the_table_of_events(side: carom.Run) -> None:
    shown = side.events.by_kind("ball_ball", "ball_cushion")
    numbers = [text.get_text() for text in side.plot_paths().texts if text.get_text() not in side.ball_ids]
    assert sorted(map(int, numbers)) == shown["index"].tolist()
    assert len(shown) < len(side.events)


def test_no_number_stands_on_a_pocket() -> None:
    run = carom.load("two_ball_shot").run()
    ax = run.plot_paths()
    numbers = [text for text in ax.texts if text.get_text() in ("8", "11")]
    assert len(numbers) == 2
    for pocket in run.scenario.outline()["pockets"]:
        for text in numbers:
            distance = np.hypot(*(np.array(text.get_position()) - pocket["center"]))
            assert distance > pocket["radius"], (text.get_text(), pocket["id"])


def test_balls_at_rest_lie_over_the_marks_of_contacts(opening: carom.Run) -> None:
    ax = opening.plot_paths()
    marks = max(line.get_zorder() for line in ax.lines)
    ends = opening.positions([opening.end_time])[0, :, :2]
    on_top = [disc.center for disc in discs_of(ax) if disc.get_zorder() > marks]
    np.testing.assert_array_equal(np.sort(on_top, axis=0), np.sort(ends[np.isfinite(ends[:, 0])], axis=0))


def test_landings_are_marked(jump: carom.Run) -> None:
    ax = jump.plot_paths()
    landings = jump.events.by_kind("ball_cloth")
    assert len(landings)
    (marks,) = [line for line in ax.lines if line.get_marker() == "v"]
    np.testing.assert_array_equal(np.asarray(marks.get_xdata()), landings["x"])
    assert "landing" in words_of(ax)


def test_a_pocketed_ball_ends_in_its_pocket_and_is_listed(potted: carom.Run) -> None:
    (event,) = potted.events.by_kind("ball_pocket")
    assert event.ball_a == "9"
    scene = Scene.of_run(potted)
    assert scene.rails is not None
    corner = np.array(scene.rails.pockets[0]["center"])
    travels = Travels.of(potted, scene, np.linspace(0.0, potted.end_time, 50))
    np.testing.assert_array_equal(travels.places[-1, 0], corner)
    assert np.all(np.isfinite(travels.places))
    ax = potted.plot_paths()
    centres = [disc.center for disc in discs_of(ax)]
    assert any(np.array_equal(centre, corner) for centre in centres)
    assert len(centres) == 2
    assert f"9 in lb, {event.time:.3g} s" in words_of(ax)
    assert "pocketed" in words_of(ax)


def test_long_names_of_pocketed_balls_leave_no_room_for_the_pocket() -> None:
    run = scenario({"the_ninth_ball": [0.3, 0.3], "cue": [0.6, 0.6]}, V0=2.0, phi_deg=225).run()
    (event,) = run.events.by_kind("ball_pocket")
    ax = run.plot_paths()
    (words,) = [words for words in words_of(ax) if words.startswith("the_nin")]
    assert words.endswith(f", {event.time:.3g} s")
    assert " in " not in words
    renderer = FigureCanvasAgg(drawn(ax)).get_renderer()
    (box,) = [text.get_window_extent(renderer) for text in notes_of(ax).texts if text.get_text() == words]
    assert box.x1 <= figures.figure_of(ax).bbox.width


def test_balls_in_one_pocket_lie_beside_each_other(potted: carom.Run) -> None:
    scene = Scene.of_run(potted)
    (event,) = potted.events.by_kind("ball_pocket")
    from carom.figures.travels import _ends

    ends = _ends(scene, (event, event, event))
    apart = [np.linalg.norm(one - other) for k, one in enumerate(ends) for other in ends[k + 1 :]]
    assert min(apart) > 0.3 * scene.radii[0]


def test_a_ball_off_the_table_is_listed() -> None:
    run = scenario({"cue": [0.4, 0.6]}, V0=5.5, phi_deg=71, theta_deg=40, b=-0.1).run()
    assert len(run.events.by_kind("off_table")) == 1
    ax = run.plot_paths()
    drawn(ax)
    assert words_of(ax).count("off the table") == 2  # the mark and the list
    for draw in SERIES:
        drawn(draw(run))


def test_long_lists_end_where_their_room_does() -> None:
    from carom.figures.beside import new_axes_beside, note_balls

    scene = Scene.of(break_of("snooker_12ft"))
    _, beside = new_axes_beside(scene, 0.03)
    beside.y = 80.0
    note_balls(beside, scene, "pocketed", range(22), scene.ids)
    assert beside.ax.texts[-1].get_text().startswith("and ")
    assert min(text.get_position()[1] for text in beside.ax.texts) > 0.0


# The shot


def test_the_shot_is_drawn_where_the_tip_touches(side: carom.Run) -> None:
    for ax in (side.plot_paths(), side.scenario.plot()):
        discs = [patch for patch in notes_of(ax).patches if isinstance(patch, Circle)]
        face = max(discs, key=lambda disc: disc.radius)
        (tip,) = [disc for disc in discs if np.allclose(disc.get_facecolor()[:3], to_rgb(TIP))]
        offset = (np.array(tip.center) - np.array(face.center)) / face.radius
        np.testing.assert_allclose(offset, [-0.3, 0.2])
        assert words_of(ax)[:5] == ["the shot", "cue at 2.2 m/s", "direction 60.8°", "0.3 R left", "0.2 R top"]


def test_an_offset_of_the_tips_centre_is_that_of_its_contact() -> None:
    shot = {"V0": 2.0, "phi_deg": 90, "a": 0.3, "offset_of": "tip_center"}
    aim = Scene.of(scenario({"cue": [0.4, 0.7]}, **shot)).aim
    assert aim is not None
    assert aim.left == pytest.approx(0.3 * 0.028575 / (0.028575 + 0.0106045))


def test_the_cue_lies_behind_its_ball(side: carom.Run) -> None:
    ax = side.scenario.plot()
    sticks = [np.asarray(patch.get_xy()) for patch in ax.patches if isinstance(patch, Polygon)]
    corners = np.concatenate(sticks) - [0.4, 0.7]
    angle = np.radians(60.8)
    ahead, left = corners @ [np.cos(angle), np.sin(angle)], corners @ [-np.sin(angle), np.cos(angle)]
    assert ahead.max() == pytest.approx(-1.5 * 0.028575)
    assert ahead.min() == pytest.approx(-1.5 * 0.028575 - 1.4732)
    assert (left.max() + left.min()) / 2 == pytest.approx(0.3 * 0.028575)


# Balls


def test_only_striped_pool_balls_have_stripes() -> None:
    scene = Scene.of(break_of("pool_8ft"))
    striped = {name for ball, name in enumerate(scene.ids) if scene.is_striped(ball)}
    assert striped == {str(number) for number in range(9, 16)}
    assert {scene.faces[ball] for ball, name in enumerate(scene.ids) if name in striped} == {"#fbfaf4"}


def test_discs_with_such_names_have_none() -> None:
    ball = carom.Ball("9", radius=0.1, position=(0.5, 0.5), velocity=(1, 0))
    table = carom.Table.rectangle(width=1, length=1)
    assert not Scene.of(carom.Scenario(table, [ball], duration=1)).is_striped(0)


def test_numbers_stand_in_the_discs_with_room() -> None:
    shown = {text.get_text() for text in break_of("pool_9ft").plot().texts}
    assert shown == {str(number) for number in range(1, 10)}


# Filmstrips


def test_every_event_of_a_shot_can_be_shown(jump: carom.Run, potted: carom.Run) -> None:
    for run in (jump, potted):
        for event in run.events:
            before, at, after = run.filmstrip(event)
            assert before.get_xlim() == at.get_xlim() == after.get_xlim()
            drawn([before, at, after])


def test_a_filmstrip_shows_the_neighbourhood_of_its_event(side: carom.Run) -> None:
    contact = side.events.by_kind("ball_ball")[0]
    for ax in side.filmstrip(contact):
        low, high = np.array([ax.get_xlim(), ax.get_ylim()]).T
        assert np.all(high - low < 1.0)
        centres = np.array([disc.center for disc in discs_of(ax)])
        assert np.all((centres > low) & (centres < high))
        (x0, y0), (x1, y1) = ax.transData.transform([[0.0, 0.0], [1.0, 1.0]])
        assert x1 - x0 == pytest.approx(y1 - y0)


def test_a_filmstrip_can_show_the_whole_table(side: carom.Run) -> None:
    scene = Scene.of_run(side)
    for ax in figures.filmstrip(side, closeup=False):
        assert ax.get_xlim()[0] < scene.bounds[0]
        assert ax.get_ylim()[1] > scene.bounds[3]


def test_a_pocketed_ball_is_gone_at_its_event(potted: carom.Run) -> None:
    axes = potted.filmstrip(potted.events.by_kind("ball_pocket")[0])
    assert [len(discs_of(ax)) for ax in axes] == [2, 1, 1]
    assert "pocketed" in axes[1].get_title()


def test_a_break_shows_the_whole_rack(opening: carom.Run) -> None:
    event = opening.events.by_kind("ball_ball").first()
    if event is None:  # the first shot of carom may miss
        return
    axes = opening.filmstrip(event)
    (x0, x1), (y0, y1) = axes[0].get_xlim(), axes[0].get_ylim()
    touching = opening.events.by_kind("ball_ball").by_time(event.time, event.time)
    at = opening.positions([event.time])[0]
    for name in {ball for each in touching for ball in each.balls}:
        x, y, radius = at[opening.ball_ids.index(name)]
        assert x0 <= x - radius < x + radius <= x1, name
        assert y0 <= y - radius < y + radius <= y1, name


def test_before_the_cue_strikes_nothing_moves(side: carom.Run) -> None:
    axes = side.filmstrip(side.events.by_kind("cue_ball")[0])
    arrows = [[patch for patch in ax.patches if isinstance(patch, FancyArrowPatch)] for ax in axes]
    assert [len(each) for each in arrows] == [0, 1, 1]


# Curves against time


def test_energies_of_the_balls_add_up_to_the_total(side: carom.Run) -> None:
    lines = {str(line.get_label()): line for line in side.plot_energy().lines}
    times = np.asarray(lines["total"].get_xdata())
    parts = sum(np.asarray(lines[name].get_ydata()) for name in side.ball_ids)
    np.testing.assert_allclose(parts, side.energy(times), rtol=1e-12, atol=1e-15)
    assert "potential" not in lines


def test_a_flight_has_a_potential_energy(jump: carom.Run) -> None:
    lines = {str(line.get_label()): np.asarray(line.get_ydata()) for line in jump.plot_energy().lines}
    np.testing.assert_array_equal(lines["total"], lines["kinetic"] + lines["potential"])
    assert lines["potential"].max() > 0.1 * lines["total"][0] > 0.0


def test_spin_and_its_vertical_part_are_the_runs(side: carom.Run) -> None:
    cue, eight, *others = figures.plot_spin(side).lines
    times = np.asarray(cue.get_xdata())
    spins = side.spins(times)
    np.testing.assert_array_equal(np.asarray(cue.get_ydata()), np.linalg.norm(spins[:, 0], axis=-1))
    np.testing.assert_array_equal(np.asarray(eight.get_ydata()), np.linalg.norm(spins[:, 1], axis=-1))
    np.testing.assert_array_equal(np.asarray(others[0].get_ydata()), spins[:, 0, 2])
    assert spins[0, 0, 2] < 0.0  # the tip left of the middle turns the ball clockwise


def test_discs_have_no_spin_and_no_height_to_draw(run: carom.Run) -> None:
    with pytest.raises(carom.RunError, match="spin"):
        figures.plot_spin(run)
    with pytest.raises(carom.RunError, match="motion"):
        figures.plot_height(run)


def test_heights_are_those_of_the_lowest_points_while_a_ball_flies(jump: carom.Run) -> None:
    ax = jump.plot_height()
    cue, seven, top = ax.lines
    times = np.asarray(cue.get_xdata())
    heights = jump.positions(times)[..., 2] - 0.028575
    np.testing.assert_array_equal(np.asarray(cue.get_ydata()), heights[:, 0])
    np.testing.assert_array_equal(np.asarray(seven.get_ydata()), heights[:, 1])
    assert heights.max() > 2 * 0.028575 == np.asarray(top.get_ydata())[0]
    last = jump.events.by_kind("ball_cloth")[-1].time
    assert last < ax.get_xlim()[1] < 1.2 * last < jump.end_time
    shown = {str(each.get_label()): len(each.get_paths()) for each in ax.collections}
    assert shown["landing"] == len(jump.events.by_kind("ball_cloth"))
    late = jump.events.by_time(ax.get_xlim()[1], jump.end_time).by_kind("ball_cushion")
    assert len(late) > 0
    assert shown.get("cushion", 0) == len(jump.events.by_kind("ball_cushion")) - len(late)


def test_a_shot_that_stays_on_the_cloth_has_no_picture_of_its_height(jump: carom.Run, side: carom.Run) -> None:
    assert "height" in {name for name, _ in figures_of(jump)}
    assert "height" not in {name for name, _ in figures_of(side)}


def test_pockets_have_ticks(potted: carom.Run) -> None:
    labels = {str(each.get_label()): len(each.get_paths()) for each in potted.plot_speed().collections}
    assert labels["pocket"] == 1


# Films


def test_turns_are_those_of_a_finer_integration(side: carom.Run) -> None:
    times = np.array([0.0, 0.2, 0.9, 2.5])
    coarse = turned(side, times)
    fine = turned(side, np.linspace(0.0, 2.5, 2501))[[0, 200, 900, 2500]]
    np.testing.assert_allclose(
        coarse @ np.swapaxes(coarse, -1, -2), np.broadcast_to(np.eye(3), coarse.shape), atol=1e-12
    )
    np.testing.assert_allclose(turned(side, np.linspace(0.0, 2.5, 76))[-1], fine[-1], atol=2e-3)
    np.testing.assert_array_equal(coarse[0], np.broadcast_to(np.eye(3), (2, 3, 3)))


def test_a_rolling_ball_turns_by_its_way_over_its_radius() -> None:
    ball = {"id": "cue", "position": [0.2, 0.7], "velocity": [0.5, 0.0], "spin": [0.0, 0.5 / 0.028575, 0.0]}
    run = carom.Scenario.from_dict({"table": {"preset": "pool_9ft"}, "balls": [ball], "duration": 0.5}).run()
    angle = (run.positions(0.5)[0, 0] - 0.2) / 0.028575
    expected = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    np.testing.assert_allclose(turned(run, np.array([0.0, 0.5]))[1, 0], expected, atol=1e-9)


def test_a_turned_ball_shows_its_dot_where_it_is() -> None:
    scene = Scene.of(break_of("pool_9ft"))
    ball = scene.ids.index("3")
    tilt = np.radians(40.0)
    turn = np.array([[np.cos(tilt), 0, np.sin(tilt)], [0, 1, 0], [-np.sin(tilt), 0, np.cos(tilt)]])
    # Seen from aside, the middle of the dot lies lower than its pole.
    for applied, across in ((np.eye(3), 0.0), (turn, np.sin(tilt) * np.sqrt(1.0 - DOT**2))):
        seen = seen_from_above(scene, ball, applied, 40.0, (0.0, 0.0)).astype(int)
        dot = np.argwhere((seen[..., :3].min(axis=-1) > 230) & (seen[..., 3] == 255))
        down, right = (dot.mean(axis=0) - seen.shape[0] // 2) / 40.0
        assert right == pytest.approx(across, abs=0.02)
        assert down == pytest.approx(0.0, abs=0.02)


def test_a_film_shows_balls_until_they_fall_and_then_beside_the_time(potted: carom.Run, tmp_path: Path) -> None:
    path = potted.animate(tmp_path / "film.gif", fps=10, size=400, trail=0.0)
    assert potted.motion(potted.end_time)[0] == "pocketed"
    with Image.open(path) as film:
        first = np.asarray(film.convert("RGB")).astype(int)
        film.seek(getattr(film, "n_frames", 1) - 1)
        last = np.asarray(film.convert("RGB")).astype(int)
    blank = np.full((26, 60, 3), 255)
    np.testing.assert_array_equal(first[:26, -60:], blank)
    assert np.any(last[:26, -60:] != blank)


def test_a_break_can_be_filmed(opening: carom.Run, tmp_path: Path) -> None:
    path = opening.animate(tmp_path / "film.gif", fps=5, size=200)
    with Image.open(path) as film:
        assert film.size[1] == 200
        assert getattr(film, "n_frames", 1) > 10
