"""Scenarios: ways to make one, and what one can be asked."""

import copy
import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import carom


def _by_hand() -> carom.Scenario:
    return carom.Scenario(
        carom.Table.rectangle(width=1, length=2),
        [
            carom.Ball("red", radius=0.075, position=(0.1, 0.1), velocity=(3, 4)),
            carom.Ball("blue", radius=0.075, position=(0.5, 1)),
        ],
        physics=carom.Physics(ball_ball=carom.Elastic(), ball_cushion=carom.Damping(0.8)),
        duration=5,
    )


@pytest.mark.parametrize("name", carom.scenarios())
def test_ready_made_scenario_survives_every_round_trip(name: str, tmp_path: Path) -> None:
    scenario = carom.load(name)
    scenario.save(tmp_path / "s.toml")
    scenario.save(tmp_path / "s.json")
    scenario.save(tmp_path / "S.TOML")
    scenario.save(tmp_path / "S.Json")
    (tmp_path / "bom.toml").write_text(scenario.to_toml(), encoding="utf-8-sig")
    (tmp_path / "bom.json").write_text(scenario.to_json(), encoding="utf-8-sig")
    again = [
        carom.Scenario.from_toml(scenario.to_toml()),
        carom.Scenario.from_json(scenario.to_json()),
        carom.Scenario.from_dict(scenario.to_dict()),
        carom.load(tmp_path / "s.toml"),
        carom.load(tmp_path / "S.TOML"),
        carom.load(tmp_path / "S.Json"),
        carom.load(tmp_path / "bom.toml"),
        carom.load(tmp_path / "bom.json"),
        carom.Scenario.from_json("\ufeff" + scenario.to_json()),
        carom.load(str(tmp_path / "s.json")),
        pickle.loads(pickle.dumps(scenario)),
        copy.copy(scenario),
        copy.deepcopy(scenario),
    ]
    assert again == [scenario] * len(again)
    assert {hash(other) for other in again} == {hash(scenario)}


def test_scenario_written_in_python_gives_the_run_of_the_file(run: carom.Run) -> None:
    assert _by_hand().run().digest == run.digest


def test_numpy_values_are_as_good_as_python_ones() -> None:
    values = _by_hand().to_dict()
    values["balls"][0]["velocity"] = np.array([3.0, 4.0])
    values["duration"] = np.float32(5)
    assert carom.Scenario.from_dict(values) == _by_hand()


def test_with_values_changes_a_new_scenario_only(midterm: carom.Scenario) -> None:
    before = midterm.to_json()
    variant = midterm.with_values({"balls.red.velocity[0]": 3.1, "duration": 10})
    assert midterm.to_json() == before
    assert variant != midterm
    assert variant.value("balls.red.velocity[0]") == 3.1
    assert variant.value("balls[0].velocity") == [3.1, 4.0]
    assert variant.value("duration") == 10
    assert variant.with_values({"balls[0].velocity[0]": 3, "duration": 5}) == midterm


def test_attributes_cannot_be_added(midterm: carom.Scenario) -> None:
    with pytest.raises(AttributeError):
        midterm.duration = 3  # type: ignore[attr-defined]


def test_balls_are_complete(midterm: carom.Scenario) -> None:
    red, blue = midterm.balls
    assert (red.id, red.radius, red.mass, red.velocity) == ("red", 0.075, 1.0, [3.0, 4.0])
    assert blue.velocity == [0.0, 0.0]
    assert midterm.ball_ids == ["red", "blue"]


def test_outline_tells_every_cushion_and_obstacle() -> None:
    table = carom.Table.rectangle(
        width=2,
        length=1,
        obstacles=[carom.Circle((0.5, 0.5), 0.1, "pillar"), carom.Wall((1, 0.2), (1, 0.8), "fence")],
    )
    outline = carom.Scenario(table, [carom.Ball("a", radius=0, position=(0.1, 0.1))], duration=1).outline()
    assert (outline["bounds"], outline["size"]) == ([0, 0, 2, 1], 2)
    assert [(piece["id"], piece["part"], piece["kind"]) for piece in outline["pieces"]] == [
        ("bottom", "boundary", "line"),
        ("right", "boundary", "line"),
        ("top", "boundary", "line"),
        ("left", "boundary", "line"),
        ("pillar", "obstacle", "arc"),
        ("fence.a", "obstacle", "line"),
        ("fence.b", "obstacle", "line"),
    ]


def test_path_of_lines_and_arcs_makes_a_stadium() -> None:
    pieces = [
        carom.Line((0, 0), (1, 0), id="front"),
        carom.Arc((1, 0.5), 0.5, from_deg=-90, to_deg=90),
        carom.Line((1, 1), (0, 1)),
        carom.Arc((0, 0.5), 0.5, from_deg=90, to_deg=270),
    ]
    ball = carom.Ball("a", radius=0.05, position=(0.5, 0.5), speed=1, direction_deg=20)
    scenario = carom.Scenario(carom.Table.path(pieces), [ball], duration=20)
    assert scenario.outline()["bounds"] == [-0.5, 0, 1.5, 1]
    assert set(scenario.run().events["cushion"]) == {"front", "1", "2", "3"}


def _is_one_screen(text: str) -> bool:
    lines = text.splitlines()
    return len(lines) <= 24 and max(map(len, lines)) <= 80


@pytest.mark.parametrize("name", carom.scenarios())
def test_repr_fits_one_screen(name: str) -> None:
    assert _is_one_screen(repr(carom.load(name)))


def test_repr_of_the_largest_and_oddest_fits_one_screen() -> None:
    corners = [(0, 0), (10, 0), (20, 0), (20, 20.5), (10, 20.5), (0, 20.5)]
    pieces = [
        carom.Line(start, end, id=f"a cushion with quite a long name, number {place}")
        for place, (start, end) in enumerate(zip(corners, [*corners[1:], corners[0]], strict=True))
    ]
    obstacles = [carom.Circle((0.5 + k, 0.5), 0.2, id=f"pillar {k}") for k in range(19)]
    grid = [carom.Ball(f"ball {k}", radius=0.01, position=(0.1 + k % 20, 1.1 + k // 20)) for k in range(380)]
    scenario = carom.Scenario(
        carom.Table.path(pieces, obstacles=obstacles),
        grid,
        title="A title\nin two lines, " + 20 * "longer and longer ",
        physics=carom.Physics(
            flight=carom.Field((0, -9.81)),
            ball_ball=carom.Restitution(normal=0.9),
            cushions={f"pillar {k}": carom.Damping(0.5) for k in range(19)},
        ),
        duration=1,
        max_events=10,
        units={"length": "m", "time": "s", "mass": "kg"},
    )
    assert _is_one_screen(repr(scenario))
    assert "  balls: 380 (ball 0, ball 1, ball 2, ball 3, ball 4, ball 5, ball 6, ...)" in repr(scenario).splitlines()
    assert "  physics.cushions: and 13 more" in repr(scenario).splitlines()
    assert "  duration: 1 s" in repr(scenario).splitlines()
    assert _is_one_screen(repr(scenario.run()))
    one = carom.Ball(200 * "long", radius=0.01, position=(1, 1))
    assert _is_one_screen(repr(carom.Scenario(carom.Table.rectangle(width=2, length=2), [one], duration=1)))


def test_schema_is_json_that_knows_the_tables_of_a_file() -> None:
    schema = json.loads(carom.schema())
    assert {"table", "balls", "physics", "method", "duration"} <= set(schema["properties"])
