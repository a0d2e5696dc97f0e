"""What is wrong with a scenario is said at once, all of it, each with its place."""

from pathlib import Path
from typing import Any

import pytest

import carom

TABLE = carom.Table.rectangle(width=1, length=2)


def _ball(name: str = "a", **values: Any) -> carom.Ball:
    return carom.Ball(name, **{"radius": 0.1, "position": (0.5, 0.5), **values})


def _places(*balls: carom.Ball, **more: Any) -> list[str]:
    with pytest.raises(carom.ScenarioError) as caught:
        carom.Scenario(TABLE, balls, **{"duration": 1, **more})
    return [place for place, _ in caught.value.problems]


def test_every_problem_is_listed_with_its_place() -> None:
    places = _places(_ball("a", radius=-1), _ball("b", mass=0, position=(0.2, 1.5)), duration=-3)
    assert set(places) == {"balls[0].radius", "balls[1].mass", "duration"}


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
def test_number_that_is_not_finite_is_named_by_its_place(value: float) -> None:
    assert _places(_ball(velocity=(0, value))) == ["balls[0].velocity[1]"]


def test_message_says_what_it_got() -> None:
    with pytest.raises(carom.ScenarioError, match=r"balls\[0\]\.radius: .*-0\.075"):
        carom.Scenario(TABLE, [_ball(radius=-0.075)], duration=1)


def test_unknown_key_names_the_nearest_known_one() -> None:
    values = carom.load("midterm").to_dict()
    values["balls"][1]["velocty"] = [0, 0]
    with pytest.raises(carom.ScenarioError, match=r"velocty.*velocity"):
        carom.Scenario.from_dict(values)


def test_text_nested_without_end_is_refused() -> None:
    nested = "[" * 1_000_000
    for read, text in ((carom.Scenario.from_toml, f"balls = {nested}"), (carom.Scenario.from_json, nested)):
        with pytest.raises(carom.ScenarioError, match=r"line 1, column \d+: .*(recurs)"):
            read(text)


def test_overlapping_balls_are_named() -> None:
    with pytest.raises(carom.ScenarioError, match=r"a.*b|b.*a"):
        carom.Scenario(TABLE, [_ball("a"), _ball("b", position=(0.55, 0.5))], duration=1)


def test_bad_path_of_a_value_is_a_scenario_error() -> None:
    for path in ("balls.green.velocity[0]", "balls[7].radius", "no.such.key", "balls..x"):
        with pytest.raises(carom.ScenarioError):
            carom.load("midterm").value(path)
        with pytest.raises(carom.ScenarioError):
            carom.load("midterm").with_values({path: 1})


def test_unknown_name_gives_the_nearest_ready_made_ones() -> None:
    with pytest.raises(carom.ScenarioError, match=r"no scenario 'mitderm'.*midterm"):
        carom.load("mitderm")


@pytest.mark.parametrize("path", ["./midterm", "some/where/midterm.toml", "midterm.json", Path("midterm")])
def test_slash_suffix_or_path_object_means_a_file(path: str | Path) -> None:
    with pytest.raises(carom.ScenarioError, match=r"no such file.*nearest ready-made: midterm|ends in \.toml"):
        carom.load(path)


def test_file_that_is_no_scenario_says_why(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(carom.ScenarioError, match="not a text in UTF-8"):
        carom.load(tmp_path / "a.toml")
    (tmp_path / "b.toml").write_text("format = \n", encoding="utf-8")
    with pytest.raises(carom.ScenarioError, match=r"b\.toml: line 1, column"):
        carom.load(tmp_path / "b.toml")
    (tmp_path / "b.json").write_text("{", encoding="utf-8")
    with pytest.raises(carom.ScenarioError, match=r"b\.json: line 1, column"):
        carom.load(tmp_path / "b.json")
    (tmp_path / "c.yaml").write_text("", encoding="utf-8")
    with pytest.raises(carom.ScenarioError, match=r"ends in \.toml or \.json"):
        carom.load(tmp_path / "c.yaml")


@pytest.mark.parametrize("limit", ["collisions", "max_events"])
@pytest.mark.parametrize("value", [2.0, "2", True])
def test_a_count_is_an_int_here_as_in_a_run(limit: str, value: Any) -> None:
    with pytest.raises(TypeError, match=f"^{limit}: must be an int"):
        carom.Scenario(TABLE, [_ball()], duration=1, **{limit: value})


def test_check_gives_the_problems_instead_of_raising(midterm: carom.Scenario) -> None:
    assert carom.Scenario.check("midterm") == []
    assert carom.Scenario.check({**midterm.to_dict(), "duration": -1})[0][0] == "duration"


@pytest.mark.parametrize(
    "options",
    [
        {"collisions": 3.0},
        {"collisions": True},
        {"max_events": "10"},
        {"duration": "5"},
        {"duration": True},
        {"method": "stepped"},
        {"record": 1},
    ],
)
def test_option_of_the_wrong_type_is_a_type_error(midterm: carom.Scenario, options: dict[str, Any]) -> None:
    with pytest.raises(TypeError, match=f"^{next(iter(options))}: must be"):
        midterm.run(**options)


@pytest.mark.parametrize(
    ("options", "place"),
    [
        ({"duration": float("nan")}, "duration"),
        ({"duration": -1}, "duration"),
        ({"collisions": -1}, "collisions"),
        ({"record": "some"}, "record"),
        ({"until": "ball_bal"}, "until"),
        ({"method": carom.Stepped(dt=0)}, "method.dt"),
    ],
)
def test_option_out_of_range_is_named(midterm: carom.Scenario, options: dict[str, Any], place: str) -> None:
    with pytest.raises(carom.ScenarioError) as caught:
        midterm.run(**options)
    assert [place for place, _ in caught.value.problems] == [place]


def test_stepped_method_says_where_it_does_not_apply() -> None:
    scenario = carom.Scenario(carom.Table.circle(radius=1), [_ball(position=(0, 0))], duration=1)
    with pytest.raises(carom.ScenarioError):
        scenario.run(method=carom.Stepped(dt=0.1))
