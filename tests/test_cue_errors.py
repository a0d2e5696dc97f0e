"""What is mistyped about a shot, a table or a law is said with its place, from Python and from the shell."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import carom
from carom.cli.app import app

POOL = carom.Table.preset("pool_9ft")
CUE = carom.Ball("cue", position=(0.6, 0.6))
RACK = carom.Rack("nine_ball")


def shot(**keys: Any) -> Callable[[], object]:
    return lambda: carom.Scenario(POOL, [CUE]).with_shot(**keys)


def made(*arguments: Any, **keys: Any) -> Callable[[], object]:
    return lambda: carom.Scenario(*arguments, **keys)


def law(kind: str, value: Any) -> Callable[[], object]:
    return made(POOL, [CUE], physics={kind: value})


WRONG: list[tuple[Callable[[], object], str, str]] = [
    (shot(V0=2, phi=90), "shot.phi", "phi_deg"),
    (shot(V0=2), "shot.phi_deg", "missing"),
    (shot(phi_deg=90), "shot.V0", "missing"),
    (shot(V0=2, cue_speed=2, phi_deg=90), "shot.V0", "beside cue_speed"),
    (shot(V0=2, phi_deg=90, a=0.1, left=0.1), "shot.a", "beside left"),
    (shot(V0=-2, phi_deg=90), "shot.V0", "-2"),
    (shot(V0=2, phi_deg=90, theta_deg=100), "shot.theta_deg", "100"),
    (shot(V0=2, phi_deg=90, a=0.9, b=0.9), "shot", "misses the ball"),
    (shot(V0=2, phi_deg=90, cue_ball="cua"), "shot.cue_ball", "did you mean cue"),
    (shot(V0=2, phi_deg=90, offset_of="tip"), "shot.offset_of", "tip_center"),
    (made(carom.Table.preset("pool_10ft"), [CUE]), "table.preset", "pool_9ft"),
    (made(carom.Table.preset("carom_10ft", corner=carom.Mouth(width=0.1)), [CUE]), "table.corner", "no pockets"),
    (made(POOL, rack=carom.Rack("nineball")), "rack.game", "nine_ball"),  # type: ignore[arg-type]
    (made(POOL, rack=carom.Rack("nine_ball", spacing=-1)), "rack.spacing", "-1"),
    (made(POOL), "balls", "or a rack"),
    (made(POOL, [carom.Ball("a")]), "balls[0].position", ""),
    (made(POOL, [carom.Ball("a", position=(0.5, 0.5, 0.01))]), "balls[0].position[2]", "height of the centre"),
    (made(POOL, [carom.Ball("a", position=(0.5, 0.5), spin=(0, 1))]), "balls[0].spin", ""),
    (law("ball_ball", carom.Frictional(normal=1.2)), "physics.ball_ball.normal", "1.2"),
    (law("ball_ball", {"law": "mathavan_2010", "normal": 1}), "physics.ball_ball.law", "mathavan_2014"),
    (law("ball_cushion", carom.Frictional(normal=0.9)), "physics.ball_cushion.friction", "missing"),
    (law("flight", carom.Cloth(gravity=-1)), "physics.flight.gravity", "-1"),
    (law("collapse", "tc"), "physics.collapse", "discs"),
]


@pytest.mark.parametrize(("wrong", "place", "words"), WRONG, ids=[f"{place} {words}" for _, place, words in WRONG])
def test_a_mistype_is_named_with_its_place(wrong: Callable[[], object], place: str, words: str) -> None:
    with pytest.raises(carom.ScenarioError) as caught:
        wrong()
    messages = dict(caught.value.problems)
    assert place in messages, caught.value
    assert words in messages[place]


@pytest.mark.parametrize(
    ("place", "keys"),
    [
        ("shot", {"shot": carom.Shot(V0=1, phi_deg=0, cue_ball="a")}),
        ("physics.ball_ball.law", {"physics": carom.Physics(ball_ball=carom.Frictional(normal=0.9))}),
        ("physics.ball_cushion.law", {"physics": carom.Physics(ball_cushion=carom.Mathavan2010(normal=1, friction=0))}),
        ("ball_defaults.spin_decay", {"ball_defaults": {"spin_decay": 10.9}}),
    ],
)
def test_what_needs_a_cloth_says_so_among_discs(place: str, keys: dict[str, Any]) -> None:
    table = carom.Table.rectangle(width=1, length=1)
    with pytest.raises(carom.ScenarioError, match="cloth") as caught:
        carom.Scenario(table, [carom.Ball("a", radius=0.1, position=(0.5, 0.5))], duration=1, **keys)
    assert place in dict(caught.value.problems)


def test_every_problem_is_said_at_once() -> None:
    with pytest.raises(carom.ScenarioError) as caught:
        carom.Scenario(POOL, [CUE], rack=carom.Rack("nine_ball", jitter=-1), shot=carom.Shot(V0=-1, phi_deg=0))
    assert {place for place, _ in caught.value.problems} == {"rack.jitter", "shot.V0"}


def test_a_moving_ball_cannot_be_struck() -> None:
    moving = carom.Scenario(POOL, [carom.Ball("cue", position=(0.6, 0.6), velocity=(0, 1))])
    with pytest.raises(carom.ScenarioError, match=r"shot\.cue_ball: ball \"cue\" moves already"):
        moving.with_shot(V0=1, phi_deg=0)


# The shell


def shell(*words: str) -> Any:
    return CliRunner().invoke(app, list(words))


def test_a_break_is_computed_and_told() -> None:
    done = shell("run", "nine_ball_break")
    assert done.exit_code == 0, done.output
    rows = dict(line.split("\t")[:2] for line in done.stdout.splitlines() if line.count("\t") == 1)
    assert rows["status"] == "at_rest"
    assert rows["first_ball_hit"] == "1"
    assert "time\tkind\tball_a\tball_b\tcushion\tpocket\tx\ty\tclosing_speed" in done.stdout


def test_json_of_a_break_has_the_shot() -> None:
    import json

    found = json.loads(shell("run", "nine_ball_break", "--json").stdout)
    assert found["shot"] == carom.load("nine_ball_break").run().shot.to_dict()
    assert json.loads(shell("run", "midterm", "--json").stdout)["shot"] is None


def test_a_break_is_written(tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = shell("run", "nine_ball_break", "--out", str(out), "--no-figures", "--no-animation")
    assert done.exit_code == 0, done.output
    assert {"run.json", "events.csv", "trajectory.csv", "report.html"} <= {path.name for path in out.iterdir()}
    page = (out / "report.html").read_text(encoding="utf-8")
    for words in ("pool_9ft", "stronge_compliant", "What came of the shot", "struck ball"):
        assert words in page
    assert carom.load_run(out / "run.json").verify()


def test_a_value_of_the_shot_is_set() -> None:
    done = shell("run", "nine_ball_break", "--set", "shot.V0=9", "--json")
    assert done.exit_code == 0
    faster = carom.load("nine_ball_break").with_values({"shot.V0": 9})
    assert f'"{faster.run().digest}"' in done.stdout


@pytest.mark.parametrize(
    ("setting", "place"),
    [("shot.V0=-1", "shot.V0"), ("shot.cue_speed=3", "shot.V0"), ("table.preset='pool'", "table.preset")],
)
def test_a_mistype_on_the_shell_is_named(setting: str, place: str) -> None:
    done = shell("run", "nine_ball_break", "--set", setting)
    assert done.exit_code == 1
    assert f"error: {place}" in done.stderr


def test_a_file_is_checked(tmp_path: Path) -> None:
    file = tmp_path / "shot.toml"
    file.write_text("table.preset = 'pool_9ft'\nrack.game = 'nine_ball'\n[shot]\nV0 = 8\nphi = 90\n")
    done = shell("check", str(file))
    assert done.exit_code == 1
    assert "shot.phi" in done.stderr
    assert "phi_deg" in done.stderr


def test_a_miscue_is_no_success() -> None:
    done = shell("run", "nine_ball_break", "--set", "shot.a=0.6")
    assert done.exit_code == 1
    assert "ended by miscue" in done.stderr
    assert "cue.miscue_offset" in done.stderr


def test_cue_sports_are_listed() -> None:
    listed = shell("scenarios").stdout
    assert "nine_ball_break\t10\t" in listed
    assert "snooker_break\t22\t" in listed
