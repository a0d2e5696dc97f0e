"""Maps: each cell is its run, in a colour that the figure explains; and the command that draws them."""

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.image import imread
from test_cli import fine, shell

import carom
from carom import figures
from carom.ensemble import columns_of
from carom.figures import maps

MIDTERM = carom.load("midterm")
BREAK = carom.load("nine_ball_break")
SPEED, DIRECTION = "balls.red.speed", "balls.red.direction_deg"
GRID = carom.Grid({SPEED: [1, 2, 4], DIRECTION: [10, 40, 50, 60]})


@pytest.fixture(scope="module")
def table() -> carom.Ensemble:
    return MIDTERM.ensemble(GRID, ["events", "final_position"])


def mesh_of(ax: Axes) -> Any:
    (mesh,) = ax.collections
    return mesh


def cells_of(ax: Axes) -> Any:
    """Give what the cells show, a row for each row of cells; older matplotlib keeps it flat."""
    rows, columns = (corners - 1 for corners in mesh_of(ax).get_coordinates().shape[:2])
    return mesh_of(ax).get_array().reshape(rows, columns)


def colour_at(ax: Axes, row: int, column: int) -> str:
    """Give the colour of a cell, as a legend's patch has it."""
    return to_hex(mesh_of(ax).to_rgba(cells_of(ax))[row, column])


def legend_of(ax: Axes) -> dict[str, str]:
    """Give the colour of each entry."""
    legend = ax.get_legend()
    if legend is None:
        return {}
    texts = [text.get_text() for text in legend.get_texts()]
    return dict(zip(texts, (to_hex(patch.get_facecolor()) for patch in legend.get_patches()), strict=True))


def words(shape: tuple[int, int], values: list[str | None]) -> carom.Ensemble:
    """Give an ensemble whose column `word` has these values."""
    grid = carom.Grid({SPEED: np.arange(1, shape[0] + 1), DIRECTION: np.arange(1, shape[1] + 1)})
    of_speeds = iter(values)
    return MIDTERM.ensemble(grid, [], functions={"word": lambda run: next(of_speeds)})


def test_a_quantity_has_its_cells_and_a_labelled_colour_bar(table: carom.Ensemble) -> None:
    ax = table.map("blue.x")
    assert np.array_equal(cells_of(ax), table["blue.x"].reshape(3, 4))
    assert (ax.get_title(loc="left"), ax.get_xlabel(), ax.get_ylabel()) == ("blue.x", DIRECTION, SPEED)
    (bar,) = ax.child_axes
    assert bar.get_ylabel() == "blue.x"
    assert mesh_of(ax).get_clim() == (table["blue.x"].min(), table["blue.x"].max())
    assert ax.get_legend() is None
    assert ax.get_aspect() == "auto"


def test_cells_are_centred_on_the_numbers_and_reach_half_way_to_their_neighbours(table: carom.Ensemble) -> None:
    ax = table.map("blue.y")
    corners = mesh_of(ax).get_coordinates()
    assert corners[0, :, 0].tolist() == [-5, 25, 45, 55, 65]
    assert corners[:, 0, 1].tolist() == [0.5, 1.5, 3, 5]
    assert (*ax.get_xlim(), *ax.get_ylim()) == (-5, 65, 0.5, 5)


def test_axes_can_be_exchanged_and_numbers_come_in_their_order(table: carom.Ensemble) -> None:
    expected = table["red.y"].reshape(3, 4)
    for turned in (table.map("red.y", x=SPEED), table.map("red.y", y=DIRECTION)):
        assert (turned.get_xlabel(), turned.get_ylabel()) == (SPEED, DIRECTION)
        assert np.array_equal(cells_of(turned), expected.T)
    backwards = carom.Grid({SPEED: [4, 1, 2], "balls.blue.mass": [1], DIRECTION: [60, 50, 40, 10]})
    ax = MIDTERM.ensemble(backwards).map("red.y", x=DIRECTION, y=SPEED)
    assert np.array_equal(cells_of(ax), expected)


def test_few_whole_numbers_have_a_colour_each_in_their_order(table: carom.Ensemble) -> None:
    ax = table.map("events.ball_ball")
    legend, hits = legend_of(ax), table["events.ball_ball"].reshape(3, 4)
    assert list(legend) == [str(number) for number in np.unique(hits)]
    assert len(set(legend.values())) == len(legend)
    for (row, column), number in np.ndenumerate(hits):
        assert colour_at(ax, row, column) == legend[str(number)]
    assert not ax.child_axes


def test_many_whole_numbers_are_a_quantity() -> None:
    grid = carom.Grid({"physics.ball_cushion.factor": [0.9, 1.0], SPEED: np.linspace(1, 9, 20)})
    table = MIDTERM.ensemble(grid, ["events"])
    assert len(np.unique(table["events.ball_cushion"])) > maps.MOST_CATEGORIES
    ax = table.map("events.ball_cushion")
    assert np.array_equal(cells_of(ax).ravel(), table["events.ball_cushion"])
    assert len(ax.child_axes) == 1


def test_words_are_named_with_the_most_frequent_first() -> None:
    ax = words((2, 3), ["b", "a", "b", "c", "b", "c"]).map("word")
    legend = legend_of(ax)
    assert list(legend) == ["b", "c", "a"]
    found = [[colour_at(ax, row, column) for column in range(3)] for row in range(2)]
    assert found == [[legend[word] for word in row] for row in ("bab", "cbc")]


def test_the_rarest_of_many_words_are_gathered() -> None:
    often = [f"w{number:02}" for number in range(12)]
    ax = words((3, 9), [*often, *often, "x", "y", "z"]).map("word")
    legend = legend_of(ax)
    assert list(legend) == [*often, "other"]
    assert len(set(legend.values())) == 13
    assert {colour_at(ax, 2, column) for column in (6, 7, 8)} == {legend["other"]}


def test_pockets_are_words_and_none_is_one_of_them() -> None:
    grid = carom.Grid({"shot.V0": [6, 7, 8], "shot.phi_deg": [95, 96, 97.6]})
    table = BREAK.ensemble(grid, ["pockets"])
    ax = table.map("1.pocket")
    pockets = table["1.pocket"].reshape(3, 3)
    assert None in pockets
    assert len(set(pockets.flat)) > 1
    legend = legend_of(ax)
    assert "no outcome" not in legend
    for (row, column), pocket in np.ndenumerate(pockets):
        assert colour_at(ax, row, column) == legend[pocket or "none"]
    assert ax.get_ylabel() == "shot.V0 (m/s)"


@pytest.mark.parametrize("column", ["blue.x", "events.ball_ball", "mark", "flag"])
def test_rows_without_an_outcome_are_grey_and_named(column: str) -> None:
    grid = carom.Grid({SPEED: [1, 2], "balls.red.position[0]": [0.01, 0.1]})
    functions = {"mark": lambda run: run.end_time, "flag": lambda run: True}
    table = MIDTERM.ensemble(grid, ["events", "final_position"], functions=functions, invalid="keep")
    assert table.has_outcome.tolist() == [False, True, False, True]
    ax = table.map(column)
    legend = legend_of(ax)
    assert list(legend)[-1] == "no outcome"
    assert np.ma.getmaskarray(cells_of(ax)).tolist() == [[True, False]] * 2
    assert colour_at(ax, 0, 0) == legend["no outcome"] != colour_at(ax, 0, 1)
    assert legend_of(table.map("status")).keys() == {"rejected", "time_limit"}


def test_an_event_that_never_came_is_no_outcome() -> None:
    ax = MIDTERM.ensemble(carom.Grid({SPEED: [0, 1], DIRECTION: [10, 20]}), ["first_event"]).map("first_event")
    assert np.ma.getmaskarray(cells_of(ax)).tolist() == [[True, True], [False, False]]


def test_units_stand_in_brackets_where_the_scenario_names_them() -> None:
    scenario = MIDTERM.with_values({"units": {"length": "m", "time": "s"}})
    ax = scenario.ensemble(GRID).map("blue.x")
    assert (ax.get_ylabel(), ax.get_xlabel()) == (f"{SPEED} (m/s)", DIRECTION)
    assert ax.child_axes[0].get_ylabel() == "blue.x (m)"


def test_maps_are_drawn_where_they_are_told_and_leave_settings_alone(table: carom.Ensemble) -> None:
    before = dict(matplotlib.rcParams)
    given = Figure().add_subplot()
    assert table.map("blue.x", ax=given) is given
    own = figures.plot_map(table, "events.ball_ball")
    assert figures.figure_of(own) is not figures.figure_of(given)
    assert dict(matplotlib.rcParams) == before


def test_a_thousand_cells_have_a_dot_each(tmp_path: Path) -> None:
    grid = carom.Grid({SPEED: [1, 2], DIRECTION: np.linspace(0, 90, 1000)})
    ax = MIDTERM.ensemble(grid).map("blue.x")
    path = figures.save_figure(figures.figure_of(ax), tmp_path / "map.png")
    dots = imread(path)[200, 160:1160] * 255
    expected = mesh_of(ax).to_rgba(cells_of(ax))[1] * 255
    # The outermost dots lie under the frame.
    assert np.abs(dots - expected)[2:-2].max() <= 1


def test_legends_and_colour_bars_are_on_the_figure(table: carom.Ensemble) -> None:
    ax = words((2, 3), ["a_word_that_is_longer_than_any", "b", "b", "b", "b", "b"]).map("word")
    for each in (ax, table.map("blue.x")):
        figure = figures.figure_of(each)
        figure.canvas.draw()
        assert figure.bbox.fully_containsx(figure.get_tightbbox().x1 * figure.dpi)


WRONG: dict[str, tuple[Any, dict[str, Any], str]] = {
    "no grid": ({SPEED: [1, 2]}, {}, "a map needs an ensemble on a carom.Grid"),
    "one axis": (carom.Grid({SPEED: [1, 2]}), {}, r"got 1 of them \(balls.red.speed: 2\)"),
    "three axes": (
        carom.Grid({SPEED: [1, 2], DIRECTION: [1, 2], "balls.blue.mass": [1, 2]}),
        {},
        "got 3 of them .*balls.blue.mass: 2",
    ),
    "no such axis": (GRID, {"x": "balls.blue.mass"}, "x: no axis 'balls.blue.mass'; the axes are"),
    "twice an axis": (GRID, {"x": SPEED, "y": SPEED}, "x and y: both are balls.red.speed"),
    "twice a number": (carom.Grid({SPEED: [1, 2, 1], DIRECTION: [1, 2]}), {}, "balls.red.speed: has 1 more than once"),
}


@pytest.mark.parametrize(("varied", "options", "message"), WRONG.values(), ids=WRONG.keys())
def test_what_cannot_be_drawn_is_refused(varied: Any, options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        MIDTERM.ensemble(varied).map("blue.x", **options)


def test_an_unknown_column_is_answered_with_the_known(table: carom.Ensemble) -> None:
    with pytest.raises(KeyError, match=r"no column 'blu\.x'; the columns are .*blue\.x"):
        table.map("blu.x")


def test_an_ensemble_remembers_its_grid(table: carom.Ensemble) -> None:
    assert table.grid is GRID
    assert MIDTERM.ensemble({SPEED: [1.0]}).grid is None
    with pytest.raises(ValueError, match="read-only"):
        GRID[SPEED][0] = 3.0


@pytest.mark.parametrize("scenario", [MIDTERM, BREAK])
def test_the_columns_of_each_outcome_are_those_of_the_engine(scenario: carom.Scenario) -> None:
    path = "shot.V0" if scenario.is_on_cloth else SPEED
    columns = columns_of(scenario, carom.Grid({path: [5.0]}))
    with pytest.raises(carom.ScenarioError) as error:
        scenario.ensemble({path: [5.0]}, ["nothing"])
    known = str(error.value).split("known: ")[1].split(", closest_approach.A.B, ")[0].split(", ")
    assert list(columns) == [name for name in known if scenario.is_on_cloth or name not in ("final_spin", "pockets")]
    found = scenario.ensemble({path: [5.0]}, list(columns))
    assert found.names[2:] == [name for names in columns.values() for name in names]


# carom map

ASKED = ("map", "midterm", "--x", f"{DIRECTION}=10:60:4", "--y", f"{SPEED}=1:4:3")


def test_map_prints_the_facts_and_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    printed = fine(*ASKED, "--show", "events.ball_ball")
    lines = [line.split("\t") for line in printed.splitlines()]
    assert ["x", f"{DIRECTION} = 10 to 60, 4"] in lines
    assert ["runs", "12"] in lines
    assert not list(tmp_path.iterdir())


def test_map_writes_pictures_and_facts(tmp_path: Path) -> None:
    out = tmp_path / "out"
    printed = json.loads(fine(*ASKED, "--show", "blue.x", "--out", out, "--format", "png,svg", "--json"))
    assert {path.name for path in out.iterdir()} == {"map.png", "map.svg", "map.json"} == set(printed["files"])
    kept = json.loads((out / "map.json").read_text(encoding="utf-8"))
    assert all(kept[key] == printed[key] for key in kept if key not in ("command", "content"))
    grid = carom.Grid({SPEED: np.linspace(1, 4, 3), DIRECTION: np.linspace(10, 60, 4)})
    expected = MIDTERM.ensemble(grid)["blue.x"]
    assert [kept[key] for key in ("min", "median", "max")] == [
        expected.min(),
        np.median(expected),
        expected.max(),
    ]
    assert (kept["column"], kept["runs"], kept["without"]) == ("blue.x", 12, 0)
    assert carom.Scenario.from_dict(kept["content"]) == MIDTERM
    again = json.loads(fine(*kept["command"].split()[1:], "--threads", "1", "--json"))
    assert again["digest"] == kept["digest"]
    assert shell(*ASKED, "--show", "blue.x", "--out", out).code == 1
    fine(*ASKED, "--show", "blue.y", "--out", out, "--overwrite")
    assert {path.name for path in out.iterdir()} == {"map.png", "map.json"}
    assert json.loads((out / "map.json").read_text(encoding="utf-8"))["digest"] != kept["digest"]


def test_map_counts_categories_and_keeps_what_makes_no_scenario() -> None:
    places = ("--x", "balls.red.position[0]=0.01:0.3:2", "--y", f"{SPEED}=1:2:2")
    status = json.loads(fine("map", "midterm", *places, "--show", "status", "--json"))
    assert status["counts"] == status["statuses"] == {"rejected": 2, "time_limit": 2}
    hits = json.loads(fine("map", "midterm", *places, "--show", "events.ball_ball", "--set", "duration=0", "--json"))
    assert (hits["counts"], hits["without"]) == ({"0": 2}, 2)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--show", "blu.x"), "no column 'blu.x'; did you mean blue.x? known: status; end_time; events.ball_ball"),
        (("--show", "1.pocket"), "red.x, red.y, blue.x, blue.y; red.vx"),
        (("--show", "blue.x", "--set", "balls.red.spede=1"), "did you mean speed"),
        (("--show", "blue.x", "--set", "balls.blue.position=[2, 2]"), "outside the table"),
    ],
)
def test_map_says_what_is_wrong(words: tuple[str, ...], message: str) -> None:
    done = shell(*ASKED, *words)
    assert (done.code, done.stdout) == (1, "")
    assert message in done.stderr


@pytest.mark.parametrize(
    ("axis", "message"),
    [
        (f"{SPEED}", "is not PATH=FROM:TO:COUNT, such as balls.red.speed=1:8:200"),
        (f"{SPEED}=1:2", "is not PATH=FROM:TO:COUNT"),
        ("=1:2:3", "is not PATH=FROM:TO:COUNT"),
        (f"{SPEED}=1:inf:3", "is not PATH=FROM:TO:COUNT"),
        (f"{SPEED}=1:2:2.5", "is not PATH=FROM:TO:COUNT"),
        (f"{SPEED}=1:2:1", "COUNT must be 2 at least"),
        (f"{SPEED}=2:2:5", "FROM another number than TO"),
        (f"{DIRECTION}=1:2:3", "must name another path than --x"),
    ],
)
def test_map_says_how_an_axis_is_written(axis: str, message: str) -> None:
    done = shell("map", "midterm", "--x", f"{DIRECTION}=1:2:3", "--y", axis, "--show", "blue.x")
    assert done.code == 2
    assert message in " ".join(done.stderr.split())


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to a single child")
def test_an_interrupted_map_leaves_nothing(tmp_path: Path) -> None:
    axes = ["--x", "shot.phi_deg=95:98:3000", "--y", "shot.V0=6:9:3000"]
    command = [sys.executable, "-m", "carom", "map", "nine_ball_break", *axes, "--show", "1.pocket"]
    with subprocess.Popen([*command, "--out", tmp_path / "out"], stderr=subprocess.PIPE, text=True) as child:
        time.sleep(2)
        child.send_signal(signal.SIGINT)
        try:
            said = child.communicate(timeout=60)[1]
        finally:
            child.kill()
    assert child.returncode == 130
    assert "nothing is half written" in said
    assert not list(tmp_path.iterdir())
