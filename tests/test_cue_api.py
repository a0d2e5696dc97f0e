"""Cue sports from Python: what runs on a cloth tell, held to closed forms, and the shot after the shot."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import _engine

RADIUS, MASS, GRAVITY, SLIDING = 0.028575, 0.170097, 9.81, 0.2
CLOTH = carom.Physics(flight=carom.Cloth())
PLAIN = carom.Table.rectangle(width=2, length=20)


def ball(name: str = "cue", **values: Any) -> carom.Ball:
    return carom.Ball(name, **{"radius": RADIUS, "mass": MASS, "position": (1, 1), **values})


def alone(**values: Any) -> carom.Run:
    """One ball on a long table, until it rests."""
    return carom.Scenario(PLAIN, [ball(**values)], physics=CLOTH).run()


@pytest.fixture(scope="module")
def scenario() -> carom.Scenario:
    return carom.Scenario(
        carom.Table.preset("pool_9ft"),
        [carom.Ball("cue", position=(0.78, 0.55))],
        rack=carom.Rack("nine_ball", seed=7),
        shot=carom.Shot(V0=8, phi_deg=96.3, b=0.1),
    )


@pytest.fixture(scope="module")
def table_run(scenario: carom.Scenario) -> carom.Run:
    return scenario.run()


@pytest.fixture(scope="module")
def potted() -> carom.Run:
    """A ball straight into the pocket at the upper left, the cue ball left behind."""
    table = carom.Table.preset("pool_9ft")
    balls = [carom.Ball("cue", position=(0.4, 2.14)), carom.Ball("1", position=(0.2, 2.34))]
    return carom.Scenario(table, balls, shot=carom.Shot(V0=1.5, phi_deg=135)).run()


# A ball by itself; the numbers are those of the closed forms, not of the engine


@pytest.mark.parametrize(
    ("speed", "slide", "path", "roll"),
    [(1.0, 0.145624, 0.124821, 7.281200), (2.0, 0.291248, 0.499282, 14.562400)],
)
def test_a_ball_slides_and_then_rolls(speed: float, slide: float, path: float, roll: float) -> None:
    run = alone(velocity=(0, speed))
    rolls, rests = run.events
    assert (rolls.kind, rests.kind, run.status) == ("slide_to_roll", "roll_to_rest", "at_rest")
    assert rolls.time == pytest.approx(slide, abs=1e-6)
    assert rests.time == pytest.approx(slide + roll, abs=1e-5)
    assert run.positions(rolls.time)[0, 1] - 1 == pytest.approx(path, abs=1e-6)
    assert run.velocities(rolls.time)[0, 1] == pytest.approx(5 / 7 * speed, abs=1e-12)


@pytest.mark.parametrize(
    ("spin", "share", "motion"), [(-1.0, 3 / 7, "rolling"), (1.0, 1.0, "rolling"), (-2.5, 0.0, "resting")]
)
def test_draw_and_follow_end_as_the_slip_says(spin: float, share: float, motion: str) -> None:
    """The ball that rolls forward along y turns about −x."""
    run = alone(velocity=(0, 1), spin=(-spin / RADIUS, 0, 0))
    ends = [event.time for event in run.events if event.kind.startswith("slide")]
    when = ends[0] if ends else 0.0
    assert run.velocities(when)[0, 1] == pytest.approx(share, abs=1e-9)
    assert run.motion(when)[0] == motion


def test_side_spin_decays_by_itself() -> None:
    run = alone(spin=(0, 0, 50))
    assert [event.kind for event in run.events] == ["spin_to_rest"]
    assert run.end_time == pytest.approx(50 / 10.9, abs=1e-9)
    assert run.spins(1.0)[0] == pytest.approx([0, 0, 50 - 10.9])


def test_a_thrown_ball_flies_and_lands() -> None:
    run = alone(velocity=(0, 0, 1))
    landing = run.events.by_kind("ball_cloth")[0]
    assert landing.time == pytest.approx(2 / GRAVITY)
    assert run.positions(1 / GRAVITY)[0, 2] - RADIUS == pytest.approx(1 / (2 * GRAVITY))
    assert run.motion([0.1, 10.0])[:, 0].tolist() == ["airborne", "resting"]


@pytest.mark.parametrize(("side", "top", "speed"), [(0, 0, 3.07694), (0, 0.4, 2.35295), (0.3, 0.3, 2.28572)])
def test_the_cue_gives_the_ball_its_speed(side: float, top: float, speed: float) -> None:
    """V0 = 2 and a cue of 0.567 kg, without squirt and elastic: equation (1) of Leckie and Greenspan."""
    cue = carom.Cue(mass=0.567, end_mass=0, restitution=1)
    struck = carom.Scenario(
        PLAIN, [ball()], physics=CLOTH, cue=cue, shot=carom.Shot(V0=2, phi_deg=90, a=side, b=top)
    ).run()
    assert np.linalg.norm(struck.velocities(0.0)[0]) == pytest.approx(speed, abs=1e-5)
    assert struck.spins(0.0)[0, 2] == pytest.approx(-2.5 * side * speed / RADIUS, rel=1e-5)
    assert struck.motion(0.0)[0] == ("rolling" if top == 0.4 else "sliding")


def test_english_squirts_to_the_other_side() -> None:
    """Alciatore, TP A.31: half a radius of left and an end of 1/30 of the mass give 1.886 degrees to the right."""
    cue = carom.Cue(end_mass=MASS / 30, restitution=1)
    struck = carom.Scenario(PLAIN, [ball()], physics=CLOTH, cue=cue, shot=carom.Shot(V0=2, phi_deg=90, a=0.5)).run()
    vx, vy, _ = struck.velocities(0.0)[0]
    assert np.degrees(np.arctan2(vx, vy)) == pytest.approx(1.8860, abs=1e-3)


def test_stun_leaves_at_right_angles() -> None:
    """Elastic balls without friction: 90 degrees apart, and the parts of the velocity are cos and sin of the cut."""
    cut = np.radians(30)
    other = ball("object", position=(1 + 2 * RADIUS * np.cos(cut), 1 + 2 * RADIUS * np.sin(cut)))
    run = carom.Scenario(PLAIN, [ball(velocity=(1, 0)), other], physics=CLOTH).run()
    cue, object_ball = run.velocities(0.0)
    assert float(cue @ object_ball) == pytest.approx(0, abs=1e-12)
    assert np.linalg.norm(object_ball) == pytest.approx(np.cos(cut))


# What a run gives, and in which shapes


def test_shapes_of_a_run_on_a_cloth(table_run: carom.Run) -> None:
    times = np.array([[0.0, 0.5], [1.0, 2.0]])
    for vectors in (table_run.positions(times), table_run.velocities(times), table_run.spins(times)):
        assert vectors.shape == (2, 2, 10, 3)
    assert table_run.motion(times).shape == (2, 2, 10)
    assert table_run.motion(1.0).shape == (10,)
    assert table_run.momentum(times).shape == (2, 2, 3)
    assert set(table_run.motion(times).ravel()) <= set(_engine.MOTIONS)
    assert table_run.is_on_cloth


def test_discs_have_no_spin(run: carom.Run) -> None:
    assert not run.is_on_cloth
    assert run.pocket_ids == []
    for ask in (run.spins, run.motion):
        with pytest.raises(carom.RunError, match=r'no spin.*physics\.flight\.law = "cloth"'):
            ask(0.0)


def test_trajectory_has_heights_spins_and_motions(table_run: carom.Run) -> None:
    times = [0.0, 0.3, 1.0]
    trajectory = table_run.trajectory(times)
    keys = ["x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "motion"]
    assert trajectory.names[:11] == ["time", *(f"cue.{key}" for key in keys)]
    assert len(trajectory.names) == 1 + 10 * len(keys)
    assert trajectory["9.wy"].tolist() == table_run.spins(times)[:, table_run.ball_ids.index("9"), 1].tolist()
    assert trajectory["cue.motion"].tolist() == table_run.motion(times)[:, 0].tolist()


def test_a_pocketed_ball_is_nowhere(potted: carom.Run) -> None:
    (fall,) = potted.events.by_kind("ball_pocket")
    assert (fall.ball_a, fall.pocket, fall.cushion) == ("1", "lt", None)
    after = potted.positions([fall.time - 1e-3, fall.time, potted.end_time])[:, 1]
    assert np.isfinite(after[0]).all()
    assert np.isnan(after[1:]).all()
    assert np.isnan(potted.spins(potted.end_time)[1]).all()
    assert potted.motion([0.0, fall.time])[:, 1].tolist() == ["resting", "pocketed"]


def test_events_name_pockets(potted: carom.Run, tmp_path: Path) -> None:
    assert potted.pocket_ids == ["lb", "rb", "rc", "rt", "lt", "lc"]
    assert not set(potted.pocket_ids) & set(potted.cushion_ids)
    assert len(potted.events.by_pocket("lt")) == 1
    assert len(potted.events.by_pocket("lb")) == 0
    with pytest.raises(ValueError, match="unknown pocket 'xx'; known are lb"):
        potted.events.by_pocket("xx")
    potted.events.to_csv(tmp_path / "events.csv")
    head, *rows = (tmp_path / "events.csv").read_text().splitlines()
    assert head.endswith(",cluster,pocket")
    assert [row.rpartition(",")[2] for row in rows].count("lt") == 1


def test_runs_are_saved_copied_and_taken_step_by_step(table_run: carom.Run, tmp_path: Path) -> None:
    table_run.save(tmp_path / "run.json")
    again = carom.load_run(tmp_path / "run.json")
    assert again == table_run == pickle.loads(pickle.dumps(table_run))
    assert again.shot == table_run.shot
    assert again.verify()
    simulation = table_run.scenario.start()
    assert list(simulation) == list(table_run.events)
    at_end = table_run.end_time
    np.testing.assert_array_equal(simulation.positions, table_run.positions(at_end))
    np.testing.assert_array_equal(simulation.spins, table_run.spins(at_end))
    assert simulation.motion.tolist() == table_run.motion(at_end).tolist()


@pytest.mark.parametrize("record", ["all", "events", "none"])
def test_the_first_step_is_the_strike_whatever_is_kept(scenario: carom.Scenario, record: str) -> None:
    event = scenario.with_values({"record": record}).start().step()
    assert event is not None
    assert event.kind == "cue_ball"


def test_only_kinds_that_can_happen_are_counted(run: carom.Run, table_run: carom.Run) -> None:
    discs, cloth = run.diagnostics["events"], table_run.diagnostics["events"]
    assert list(discs) == ["ball_ball", "ball_cushion", "hold", "release"]
    assert set(discs) | set(cloth) == set(_engine.EVENT_KINDS)
    assert set(discs) & set(cloth) == {"ball_ball", "ball_cushion"}
    assert cloth["cue_ball"] == 1


def test_references_name_the_laws_that_acted(table_run: carom.Run) -> None:
    laws = {reference.law for reference in table_run.references}
    assert {"flight.cloth", "cue_ball.point_contact", "ball_ball.frictional"} <= laws


# The shot


def test_a_shot_is_told_as_its_events_say(table_run: carom.Run) -> None:
    """Every field anew, by the events one by one."""
    shot, events = table_run.shot, list(table_run.events)
    first = next(k for k, event in enumerate(events) if event.kind == "ball_ball" and "cue" in event.balls)
    contacts = [(k > first, event) for k, event in enumerate(events) if event.kind == "ball_cushion"]
    own = [(late, event.cushion) for late, event in contacts if event.ball_a == "cue"]
    falls = [event for event in events if event.kind == "ball_pocket"]
    assert (shot.first_ball_hit, shot.first_hit_time) == ("1", events[first].time)
    assert shot.cushions_before == tuple(cushion for late, cushion in own if not late)
    assert shot.cushions_after == tuple(cushion for late, cushion in own if late)
    assert shot.all_cushions_before == tuple(event.cushion for late, event in contacts if not late)
    assert shot.all_cushions_after == tuple(event.cushion for late, event in contacts if late)
    assert set(shot.balls_to_cushion) == {event.ball_a for late, event in contacts if late} - {"cue"}
    assert shot.pocketed == tuple(event.ball_a for event in falls)
    assert shot.pockets == tuple(event.pocket for event in falls)
    assert shot.pocket_times == tuple(event.time for event in falls)
    assert not shot.is_miscue
    assert shot.balls_hit[0] == "1"


def test_a_straight_pot_is_told(potted: carom.Run) -> None:
    shot = potted.shot
    assert (shot.first_ball_hit, shot.pocketed, shot.pockets) == ("1", ("1",), ("lt",))
    assert (shot.is_cue_ball_pocketed, shot.off_table, shot.balls_hit) == (False, (), ("1",))
    assert "pocketed: 1 in lt" in repr(shot)


def test_a_result_is_plain(table_run: carom.Run) -> None:
    values = table_run.shot.to_dict()
    assert json.loads(json.dumps(values)) == values
    flat = [item for value in values.values() for item in (value if isinstance(value, list) else [value])]
    assert all(type(item) in (str, int, float, bool, type(None)) for item in flat)


def test_cushions_are_counted_before_each_ball() -> None:
    """Off the side cushion into the first ball, and from there straight on into the second."""
    table = carom.Table.rectangle(width=1, length=2)
    balls = [
        ball("cue", position=(0.5, 0.5), velocity=None),
        ball("a", position=(0.2, 0.5)),
    ]
    struck = carom.Scenario(table, balls, physics=CLOTH, shot=carom.Shot(V0=2, phi_deg=0))
    shot = struck.run(until="ball_ball").shot
    assert (shot.balls_hit, shot.cushions_before_hits, shot.cushions_before) == (("a",), (1,), ("right",))
    assert shot.cushions_after == ()


def test_a_shot_that_hits_nothing_has_all_its_cushions_before() -> None:
    table = carom.Table.rectangle(width=1, length=2)
    shot = (
        carom.Scenario(table, [ball(position=(0.5, 0.5))], physics=CLOTH, shot=carom.Shot(V0=1, phi_deg=0)).run().shot
    )
    assert (shot.first_ball_hit, shot.first_hit_time, shot.cushions_after) == (None, None, ())
    assert shot.cushions_before[:2] == ("right", "left")


def test_a_scratch_is_told() -> None:
    table = carom.Table.preset("pool_9ft")
    scratch = carom.Scenario(table, [carom.Ball("cue", position=(0.2, 2.34))], shot=carom.Shot(V0=1, phi_deg=135)).run()
    assert (scratch.shot.pocketed, scratch.shot.is_cue_ball_pocketed) == (("cue",), True)
    with pytest.raises(carom.ScenarioError, match="balls: must not be empty"):
        scratch.final_scenario()


def test_after_a_scratch_the_next_shot_says_how_to_put_the_ball_back() -> None:
    balls = [carom.Ball("cue", position=(0.2, 2.34)), carom.Ball("1", position=(0.6, 0.6))]
    run = carom.Scenario(carom.Table.preset("pool_9ft"), balls, shot=carom.Shot(V0=1, phi_deg=135)).run()
    with pytest.raises(carom.ScenarioError, match=r'no ball "cue".*out of play: cue; final_scenario\(\)\.with_ball'):
        run.next(V0=1, phi_deg=0)


def test_a_miscue_ends_the_run(scenario: carom.Scenario) -> None:
    run = scenario.with_shot(V0=2, phi_deg=90, a=0.5, b=0.3).run()
    assert (run.status, run.end_time, [event.kind for event in run.events]) == ("miscue", 0.0, ["miscue"])
    assert run.shot.is_miscue
    assert "miscue" in repr(run.shot)


def test_a_run_without_a_shot_tells_of_none(run: carom.Run) -> None:
    with pytest.raises(carom.RunError, match="no shot"):
        run.shot  # noqa: B018


# From shot to shot


def test_the_final_scenario_has_the_balls_where_they_lie(scenario: carom.Scenario, table_run: carom.Run) -> None:
    rest = table_run.final_scenario()
    values, before = rest.to_dict(), scenario.to_dict()
    assert not {"rack", "shot"} & values.keys()
    assert {key: values[key] for key in values if key != "balls"} == {
        key: before[key] for key in before if key not in ("rack", "shot", "balls")
    }
    gone = set(table_run.shot.pocketed) | set(table_run.shot.off_table)
    assert rest.ball_ids == [name for name in table_run.ball_ids if name not in gone]
    for one in rest.balls:
        place = table_run.positions(table_run.end_time)[table_run.ball_ids.index(one.id)]
        assert one.position == pytest.approx(place, abs=0)
    assert [one.color for one in rest.balls] == [one.color for one in scenario.balls if one.id not in gone]


def test_balls_that_still_move_go_on(scenario: carom.Scenario) -> None:
    """A run that was cut goes on from its final scenario as the whole one does, but for the moment of the cut."""
    whole, cut = scenario.run(duration=1.2), scenario.run(duration=0.5)
    rest = cut.final_scenario().run(duration=0.1)
    np.testing.assert_allclose(rest.positions(0.1)[0], whole.positions(0.6)[0], atol=1e-9)
    np.testing.assert_allclose(rest.spins(0.1)[0], whole.spins(0.6)[0], atol=1e-6)


def test_next_is_the_shot_from_there(table_run: carom.Run) -> None:
    shot = carom.Shot(V0=2, phi_deg=45)
    one = table_run.next(shot)
    assert one == table_run.next(V0=2, phi_deg=45)
    assert one == table_run.final_scenario().with_shot(shot).run()
    assert one.scenario.value("shot.V0") == 2.0


def test_a_run_that_kept_little_still_gives_the_next_shot(scenario: carom.Scenario, table_run: carom.Run) -> None:
    assert scenario.run(record="none").final_scenario().with_values({"record": "all"}) == (
        table_run.final_scenario().with_values({"record": "all"})
    )
    assert scenario.run(record="events").shot == table_run.shot


def test_with_shot_takes_the_place_of_the_other_one(scenario: carom.Scenario) -> None:
    changed = scenario.with_shot(cue_speed=3, direction_deg=80)
    assert changed.to_dict()["shot"] == {"cue_speed": 3.0, "direction_deg": 80.0}
    assert scenario.value("shot.V0") == 8.0
    same = [scenario.with_shot(V0=3, phi_deg=80, a=0.1, b=0.2, theta_deg=5).run().digest]
    same.append(scenario.with_shot(cue_speed=3, direction_deg=80, left=0.1, top=0.2, elevation_deg=5).run().digest)
    assert same[0] == same[1]
    for wrong in ({}, {"shot": carom.Shot(V0=1), "phi_deg": 3}):
        with pytest.raises(TypeError, match=r"needs a carom\.Shot or its keys"):
            scenario.with_shot(**wrong)


def test_a_ball_is_put_back(potted: carom.Run) -> None:
    rest = potted.final_scenario()
    assert rest.ball_ids == ["cue"]
    again = rest.with_ball(carom.Ball("1", position=(0.6, 1.9)))
    moved = again.with_ball(carom.Ball("cue", position=(0.6, 0.6)))
    assert (again.ball_ids, moved.ball_ids) == (["cue", "1"], ["cue", "1"])
    assert moved.balls[0].position == pytest.approx((0.6, 0.6, RADIUS), abs=1e-12)


def test_where_two_shots_part_is_said_in_words(scenario: carom.Scenario) -> None:
    """The one runs on where the other, weaker, comes to rest; and one that falls is said to fall."""
    table = carom.Table.preset("pool_9ft")
    alone = carom.Scenario(table, [carom.Ball("cue", position=(0.2, 2.34))], shot=carom.Shot(V0=1, phi_deg=135))
    said = " ".join(str(carom.compare(alone.run(), alone.with_shot(V0=0.1, phi_deg=135).run())).split())
    assert "then cue falls into lt at t = " in said
    assert "goes from roll to rest at t = " in said


# What can be said in Python


def test_presets_are_those_of_the_schema() -> None:
    found = json.loads(carom.schema())["$defs"]["Preset"]["oneOf"]
    assert list(carom.presets()) == [one["const"] for one in found]
    for name, title in carom.presets().items():
        assert title
        one = carom.Scenario(carom.Table.preset(name), [carom.Ball("cue", position=(0.3, 0.4))])
        assert one.is_on_cloth
        assert one.units["length"] == "m"


def test_a_preset_in_plain_keys_runs_the_same(scenario: carom.Scenario, table_run: carom.Run) -> None:
    plain = scenario.expanded()
    assert "preset" not in plain.to_dict()["table"]
    assert "rack" not in plain.to_dict()
    assert plain.run().digest == table_run.digest
    assert plain.units == scenario.units


def test_a_pocket_table_of_ones_own_is_the_preset_with_its_numbers() -> None:
    preset = carom.Scenario(carom.Table.preset("pool_9ft"), [carom.Ball("cue", position=(0.3, 0.4))])
    table = preset.expanded().to_dict()["table"]
    corner, side = (carom.Mouth(**table[key]) for key in ("corner", "side"))
    own = carom.Table.pocket_table(
        **{key: table[key] for key in ("width", "length", "cushion_width", "nose_height")}, corner=corner, side=side
    )
    same = carom.Scenario(own, [ball(position=(0.3, 0.4))], physics=CLOTH)
    assert same.outline() == preset.outline()


def test_games_are_those_of_the_schema() -> None:
    import typing

    from carom.rack import Game

    found = json.loads(carom.schema())["$defs"]["Game"]["oneOf"]
    assert list(typing.get_args(Game)) == [one["const"] for one in found]


@pytest.mark.parametrize(("section", "made"), [("Shot", carom.Shot), ("Cue", carom.Cue), ("Rack", carom.Rack)])
def test_sections_have_the_keys_of_the_schema(section: str, made: Any) -> None:
    keys = json.loads(carom.schema())["$defs"][section]["properties"]
    assert set(made.__dataclass_fields__) - {"_", "tag"} == set(keys)


def test_a_ball_has_the_keys_of_the_schema() -> None:
    keys = json.loads(carom.schema())["$defs"]["Ball"]["properties"]
    assert set(carom.Ball.__dataclass_fields__) - {"_", "tag"} == set(keys)


def test_coefficients_are_written_as_the_file_has_them() -> None:
    physics = carom.Physics(
        flight=carom.Cloth(gravity=9.8, air=False),
        ball_ball=carom.Frictional(normal=0.9, friction=carom.FallingFriction(0.01, 0.1, 1.1), cling=1.5),
        ball_cushion=carom.Han2005(
            normal=carom.BySpeed((0.39, 0.257, -0.044), up_to=2.92), friction=carom.ByIncidence((0.471, -0.241))
        ),
        cushions={"left": carom.StrongeCompliant(normal=0.8, friction=0.2, frequency_ratio=1.7)},
    )
    made = carom.Scenario(PLAIN, [ball()], physics=physics)
    found = made.to_dict()["physics"]
    assert found["flight"]["gravity"] == 9.8
    assert found["flight"]["air"] is False
    assert found["ball_ball"]["friction"] == {"a": 0.01, "b": 0.1, "c": 1.1}
    assert found["ball_cushion"]["normal"] == {"by_speed": [0.39, 0.257, -0.044], "up_to": 2.92}
    assert found["ball_cushion"]["friction"] == {"by_incidence": [0.471, -0.241]}
    assert carom.Scenario.from_toml(made.to_toml()) == made
