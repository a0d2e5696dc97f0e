"""Pictures and films of tables that repeat themselves: nothing leaves the picture, and no side looks like a wall."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.patches import Circle
from PIL import Image

import carom
from carom.figures.repeats import Repeats
from carom.figures.scene import Scene

BOTH = Repeats(np.zeros(2), np.array([4.0, 2.0]), np.array([True, True]))


def table(**balls: tuple[float, float, float, float]) -> carom.Scenario:
    made = [
        carom.Ball(name, radius=0.25, position=(x, y), velocity=(vx, vy), color="red")
        for name, (x, y, vx, vy) in balls.items()
    ]
    return carom.Scenario(carom.Table.rectangle(width=4, length=2, periodic=("x", "y")), made, duration=3)


def discs(ax: Axes, *, filled: bool) -> list[tuple[float, float]]:
    found = [patch for patch in ax.patches if isinstance(patch, Circle) and patch.get_fill() is not None]
    chosen = [disc for disc in found if (disc.get_facecolor()[3] > 0.0) == filled]
    return sorted((round(x, 9), round(y, 9)) for x, y in (disc.center for disc in chosen))


def test_a_path_is_broken_where_it_goes_on_at_the_other_side() -> None:
    path = BOTH.broken(np.array([[3.0, 1.0], [6.0, 1.0]]))
    assert np.array_equal(path, [[3, 1], [4, 1], [np.nan, np.nan], [0, 1], [2, 1]], equal_nan=True)
    through_a_corner = BOTH.broken(np.array([[3.0, 1.5], [5.0, 2.5]]))
    assert np.array_equal(through_a_corner, [[3, 1.5], [4, 2], [np.nan, np.nan], [0, 0], [1, 0.5]], equal_nan=True)
    back = BOTH.broken(np.array([[1.0, 1.0], [-7.0, 1.0]]))
    assert np.isnan(back[:, 0]).sum() == 2
    assert np.nanmax(back[:, 0]) == 4


def test_paths_lose_no_length_and_stay_in_the_box() -> None:
    random = np.random.default_rng(3)
    path = random.normal(scale=5.0, size=(200, 2)).cumsum(axis=0)
    ends, which = BOTH.segments(path)
    assert np.all((ends >= -1e-9) & (ends <= BOTH.size + 1e-9))
    lengths = np.bincount(which, np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
    assert np.allclose(lengths, np.linalg.norm(np.diff(path, axis=0), axis=1), atol=1e-12)
    drawn = BOTH.broken(path)
    assert np.nansum(np.linalg.norm(np.diff(drawn, axis=0), axis=1)) == pytest.approx(lengths.sum())


def test_short_pieces_near_a_corner_are_no_jump_and_no_bridge() -> None:
    path = BOTH.broken(np.array([[3.9, 1.95], [4.1, 2.15], [3.95, 2.1]]))
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    assert np.nanmax(steps) < 0.5


def test_a_table_with_walls_is_left_as_it_is() -> None:
    walls = Repeats(np.zeros(2), np.ones(2), np.array([False, False]))
    path = np.array([[0.5, 0.5], [3.0, np.nan]])
    assert walls.broken(path) is path
    assert walls.wrapped(path) is path
    assert len(walls.copies(path, np.ones(2))[0]) == 2


def test_along_a_wall_nothing_is_moved() -> None:
    strip = Repeats(np.zeros(2), np.array([4.0, 2.0]), np.array([True, False]))
    assert strip.wrapped(np.array([5.0, 2.5])).tolist() == [1.0, 2.5]
    places, which = strip.copies(np.array([[3.9, 0.1]]), np.array([0.25]))
    assert (places.tolist(), which.tolist()) == ([[3.9, 0.1], [pytest.approx(-0.1), 0.1]], [0, 0])


def test_discs_across_a_side_are_on_both_and_in_a_corner_on_four() -> None:
    run = table(a=(3.5, 1.0, 0.5, 0.0), b=(1.0, 0.1, 0.0, 0.0)).run(duration=1.0)
    ends = discs(run.plot_paths(), filled=True)
    assert ends == [(0.0, 1.0), (1.0, 0.1), (1.0, 2.1), (4.0, 1.0)]
    places, _ = BOTH.copies(np.array([[0.1, 1.9]]), np.array([0.25]))
    assert sorted(np.round(places, 9).tolist()) == [[0.1, -0.1], [0.1, 1.9], [4.1, -0.1], [4.1, 1.9]]


def test_paths_and_ends_of_balls_that_went_round_are_in_the_picture() -> None:
    run = table(a=(1.0, 0.5, 3.0, 1.0)).run()
    ax = run.plot_paths()
    (line,) = [line for line in ax.lines if len(line.get_xdata()) > 2]
    x, y = np.asarray(line.get_xdata(), dtype=float), np.asarray(line.get_ydata(), dtype=float)
    assert (np.nanmin(x), np.nanmax(x), np.nanmin(y), np.nanmax(y)) == pytest.approx((0, 4, 0, 2))
    assert np.isnan(x).sum() == 3  # twice across the width, once along the length
    assert discs(ax, filled=True) == [pytest.approx((2.0, 1.5))]


def test_sides_without_walls_are_dashed() -> None:
    ax = table(a=(1.0, 1.0, 3.0, 1.0)).run().plot_paths()
    dashed = [patch for patch in ax.patches if not isinstance(patch, Circle) and patch.get_linestyle() != "solid"]
    assert len(dashed) >= 1


def test_a_filmstrip_shows_a_contact_that_is_not_across_a_side() -> None:
    # The first contact is across the left side, the second in the middle.
    scenario = table(a=(0.3, 1.0, -1.0, 0.0), b=(3.7, 1.0, 1.0, 0.0), c=(1.5, 0.6, 0.3, 0.0), d=(2.5, 0.6, 0.0, 0.0))
    run = scenario.run()
    middle = run.filmstrip()[1]
    first, second = run.events.by_kind("ball_ball")[0], run.events.by_kind("ball_ball")[1]
    assert set(first.balls) == {"a", "b"}
    assert f"{second.time:.2f}"[:4] in middle.get_title()
    around = run.filmstrip(around=first)
    for ax in around:
        assert all(-0.25 <= x <= 4.25 for x, _ in discs(ax, filled=True))
    # Its normal is drawn at the side, and not through the whole table.
    ends = [np.ptp(line.get_xdata()) for line in around[1].lines if len(line.get_xdata()) == 2]
    assert max(ends) < 2.0


def test_a_filmstrip_of_many_balls_looks_closely() -> None:
    run = carom.gas(150, 0.3, seed=2, duration=0.3, record="all").run()
    ax = run.filmstrip()[1]
    assert np.ptp(ax.get_xlim()) < 0.6 * Scene.of_run(run).width


def test_a_film_has_each_disc_whole_or_on_both_sides(tmp_path: Path) -> None:
    run = table(a=(3.5, 1.0, 1.0, 0.0)).run(duration=2.0)
    covered = []
    with Image.open(run.animate(tmp_path / "film.gif", fps=5, size=400, trail=0)) as film:
        for frame in range(film.n_frames):
            film.seek(frame)
            red, green, _ = np.moveaxis(np.asarray(film.convert("RGB")).astype(int), -1, 0)
            covered.append(int(((red > 150) & (green < 100)).sum()))
    # Its edge, two pixels wide, is another colour, and is missing where a side cuts the disc.
    assert min(covered) > 0.85 * max(covered)


def test_the_start_is_drawn_on_both_sides() -> None:
    ax = table(a=(3.9, 1.0, 0.0, 1.0)).plot()
    (drawn,) = [each for each in ax.collections if len(each.get_offsets()) > 1]
    assert sorted(np.round(np.asarray(drawn.get_offsets()), 9).tolist()) == [[-0.1, 1.0], [3.9, 1.0]]
