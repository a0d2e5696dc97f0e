"""Runs: what they hold and what they can be asked."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import carom


def test_run_says_how_it_ended(midterm: carom.Scenario, run: carom.Run) -> None:
    assert (run.status, run.end_time) == ("time_limit", 5.0)
    short = midterm.run(collisions=3)
    assert (short.status, len(short.events)) == ("collision_limit", 3)
    assert midterm.run(max_events=2).status == "event_limit"


def test_until_a_kind_of_event(midterm: carom.Scenario, run: carom.Run) -> None:
    stopped = midterm.run(until="ball_ball")
    assert stopped.status == "stopped"
    assert stopped.events[-1] == run.events.by_kind("ball_ball")[0]


def test_until_a_condition_on_an_event(midterm: carom.Scenario, run: carom.Run) -> None:
    stopped = midterm.run(until=lambda event: event.cushion == "left")
    assert stopped.status == "stopped"
    assert stopped.events[-1] == run.events.by_cushion("left")[0]
    assert midterm.run(until=lambda event: False) == run


def test_a_simulation_goes_to_a_time_that_is_one_and_lies_ahead(midterm: carom.Scenario) -> None:
    simulation = midterm.start()
    with pytest.raises(ValueError, match="time: must be a number, got nan"):
        simulation.run_until(float("nan"))
    assert simulation.time == 0.0
    simulation.run_until(2.0)
    with pytest.raises(carom.RunError, match=r"time: 1\.5 lies before 2, where the simulation is"):
        simulation.run_until(1.5)
    simulation.run_until(np.inf)
    assert (simulation.status, simulation.time) == ("time_limit", 5.0)


def test_references_are_those_of_the_laws_that_acted(midterm: carom.Scenario, run: carom.Run) -> None:
    assert [reference.law for reference in run.references] == ["ball_cushion.restitution"]
    assert midterm.run(duration=1e-3).references == []
    stepped = midterm.run(method=carom.Stepped(dt=0.03))
    assert (stepped.references[-1].law, stepped.references[-1].doi) == ("method.stepped", None)
    cradle = carom.load("newtons_cradle").run()
    dois = {reference.doi for reference in cradle.references if reference.law == "cluster.reflections"}
    assert dois == {"10.1145/2185520.2185602", "10.1145/3072959.3073689"}
    assert carom.Run(cradle._native).references == cradle.references


def test_arrays_have_time_ball_and_axis(run: carom.Run) -> None:
    times = np.linspace(0, 5, 7)
    assert run.positions(times).shape == run.velocities(times).shape == (7, 2, 2)
    assert run.positions(1.5).shape == (2, 2)
    assert run.energy(times).shape == (7,)
    assert run.energy(1.5).shape == ()
    assert run.momentum(times).shape == (7, 2)
    assert run.positions([]).shape == (0, 2, 2)


def test_times_may_come_in_any_order_and_layout(run: carom.Run) -> None:
    times = np.linspace(0, 5, 20)
    backwards = run.positions(times[::-1])
    assert np.array_equal(backwards[::-1], run.positions(times))
    assert np.array_equal(run.positions([0, 1]), run.positions(np.array([0.0, 1.0])))


def test_start_is_what_the_scenario_says(run: carom.Run) -> None:
    assert run.positions(0.0).tolist() == [[0.1, 0.1], [0.5, 1.0]]
    assert run.velocities(0.0).tolist() == [[3.0, 4.0], [0.0, 0.0]]
    assert run.energy(0.0) == 12.5
    assert run.momentum(0.0).tolist() == [3.0, 4.0]


def test_kinetic_and_potential_energy_are_the_audited_one(run: carom.Run) -> None:
    tilted = carom.load("tilted").run()
    audit = tilted.diagnostics
    energy = tilted.energy([0.0, tilted.end_time]) + tilted.potential_energy([0.0, tilted.end_time])
    np.testing.assert_allclose(energy, [audit["initial_energy"], audit["final_energy"]], rtol=1e-14)
    assert tilted.potential_energy(0.0) != 0.0
    assert run.potential_energy([0.0, 1.5]).tolist() == [0.0, 0.0]


def test_state_at_an_event_is_the_one_after_it(run: carom.Run) -> None:
    event = run.events.by_kind("ball_ball")[0]
    before, after = run.velocities([np.nextafter(event.time, 0), event.time])
    assert before[1].tolist() == [0.0, 0.0]
    assert after[1].tolist() != [0.0, 0.0]


@pytest.mark.parametrize("time", [-0.1, 5.0000001, np.nan, np.inf])
def test_time_outside_the_run_is_an_error(run: carom.Run, time: float) -> None:
    with pytest.raises(carom.RunError, match="outside the run"):
        run.positions([1.0, time])


def test_what_was_not_kept_is_an_error(midterm: carom.Scenario, run: carom.Run) -> None:
    events_only = midterm.run(record="events")
    assert events_only.events == run.events
    with pytest.raises(carom.RunError, match="kept no flights"):
        events_only.positions([1.0])
    with pytest.raises(carom.RunError, match="kept no events"):
        midterm.run(record="none").events  # noqa: B018
    assert midterm.run(record="none").digest == run.digest


def test_trajectory_is_states_as_columns(run: carom.Run) -> None:
    times = run.sample_times(0.7)
    table = run.trajectory(times)
    assert table.names == ["time"] + [f"{b}.{c}" for b in ("red", "blue") for c in ("x", "y", "vx", "vy")]
    assert np.array_equal(table["blue.vy"], run.velocities(times)[:, 1, 1])


def test_sample_times_end_with_the_run(run: carom.Run) -> None:
    assert run.sample_times(2).tolist() == [0, 2, 4, 5]
    assert run.sample_times(2.5).tolist() == [0, 2.5, 5]
    assert run.sample_times(9).tolist() == [0, 5]
    with pytest.raises(ValueError, match="step: must be positive"):
        run.sample_times(0)
    for step in (float("inf"), float("nan")):
        with pytest.raises(ValueError, match="step: must be positive and finite"):
            run.sample_times(step)
    for step in (1e-9, 1e-300):
        with pytest.raises(ValueError, match=r"step: .* would make more than 1e\+08 times"):
            run.sample_times(step)


def test_a_trajectory_has_a_row_for_each_time(run: carom.Run) -> None:
    with pytest.raises(ValueError, match=r"times: must be a number or a list of them, got the shape \(2, 2\)"):
        run.trajectory([[0, 1], [2, 3]])
    assert len(run.trajectory(1.0)) == 1


def test_diagnostics_count_the_events(run: carom.Run) -> None:
    counts = run.diagnostics["events"]
    assert counts["ball_ball"] == len(run.events.by_kind("ball_ball"))
    assert sum(counts.values()) == len(run.events)


def test_scenario_of_a_run_has_its_options_in_it(midterm: carom.Scenario) -> None:
    run = midterm.run(method=carom.Stepped(dt=0.03), duration=1, collisions=99)
    assert run.scenario.value("method") == {"kind": "stepped", "dt": 0.03}
    assert (run.scenario.value("duration"), run.scenario.value("collisions")) == (1, 99)
    assert run.scenario.run() == run


def test_steps_of_a_stepped_run_are_a_table(stepped: carom.Run, run: carom.Run) -> None:
    assert run.steps is None
    steps = stepped.steps
    assert steps is not None
    assert steps.names[:7] == ["step", "time", "red.x", "red.y", "red.vx", "red.vy", "red.hit"]
    assert steps["step"].tolist() == list(range(168))
    assert steps["time"][-1] == 5.0
    assert set(steps["red.hit"]) == {None, "ball_ball", "ball_cushion"}
    states = np.stack([steps["blue.x"], steps["blue.y"]], axis=1)
    assert np.array_equal(stepped.positions(steps["time"])[:, 1], states)


def test_stepped_run_reports_its_lost_time(stepped: carom.Run) -> None:
    assert stepped.diagnostics["lost_time"] > 0


def test_saved_run_is_the_same_run(run: carom.Run, stepped: carom.Run, tmp_path: Path) -> None:
    for one in (run, stepped):
        one.save(tmp_path / "run.json")
        again = carom.load_run(tmp_path / "run.json")
        assert again == one
        assert (again.digest, again.status, again.events) == (one.digest, one.status, one.events)
        assert again.scenario == one.scenario


def test_run_pickles_and_copies(run: carom.Run) -> None:
    assert pickle.loads(pickle.dumps(run)) == run
    assert copy.deepcopy(run) == run
    assert run != run.scenario.run(duration=4)


def test_runs_are_equal_that_came_out_equal_however_they_were_computed(
    midterm: carom.Scenario, run: carom.Run, stepped: carom.Run
) -> None:
    resumed = midterm.run(duration=2).resume(duration=5)
    assert resumed.diagnostics["predictions"] != run.diagnostics["predictions"]
    assert resumed == run
    in_steps = midterm.start()
    in_steps.run_until(1.234)
    assert in_steps.finish() == run
    for record in ("events", "none"):
        little = midterm.run(record=record)
        assert little == midterm.run(duration=2, record=record).resume(duration=5)
        assert little != run
    moved = midterm.with_values({"balls.red.position[0]": np.nextafter(0.1, 1.0)})
    assert moved.run(record="none") != midterm.run(record="none")
    assert stepped != run
    assert stepped == copy.copy(stepped)
    assert run != "run"


def test_verify_says_same_bits(run: carom.Run, stepped: carom.Run, midterm: carom.Scenario) -> None:
    parts = [midterm.run(until="ball_ball", method=method) for method in (carom.Exact(), carom.Stepped(dt=0.03))]
    for one in (run, stepped, *parts, midterm.run(record="none")):
        assert one.verify()
        assert one.verify().difference is None


def test_verify_names_the_first_difference(run: carom.Run) -> None:
    from carom import _engine

    text = run.to_json()
    time = repr(float(run.events["time"][2]))
    assert time in text
    changed = carom.Run(_engine.Run.from_json(text.replace(time, repr(np.nextafter(float(time), 9).item()), 1)))
    found = changed.verify()
    assert not found
    assert found.difference is not None
    assert found.difference["place"] == "events[2].time"


def test_a_run_of_another_physics_says_so(run: carom.Run) -> None:
    from carom import _engine

    here = carom.PHYSICS_VERSION
    text = run.to_json().replace(f'"physics_version":{here}', '"physics_version":7')
    older = carom.Run(_engine.Run.from_json(text))
    assert older.physics_version == 7
    assert older.to_json() == text
    assert older.verify()
    time = repr(float(run.events["time"][2]))
    text = text.replace(time, repr(np.nextafter(float(time), 9).item()), 1)
    found = carom.Run(_engine.Run.from_json(text)).verify()
    assert found.difference == {"place": "physics_version", "saved": "7", "now": str(here)}
    with pytest.raises(carom.RunError, match="version 7"):
        older.resume(duration=9)


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"format": 99}', '{"format": 1}'])
def test_text_that_is_no_run_is_an_error(text: str, tmp_path: Path) -> None:
    (tmp_path / "run.json").write_text(text, encoding="utf-8")
    with pytest.raises(carom.RunError, match=r"run\.json: .*saved"):
        carom.load_run(tmp_path / "run.json")


def test_file_that_is_no_text_or_not_there_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "run.json").write_bytes(b"\xff\xfe")
    with pytest.raises(carom.RunError, match=r"run\.json: not a text in UTF-8 \(byte 0\)"):
        carom.load_run(tmp_path / "run.json")
    with pytest.raises(carom.RunError, match=r"none\.json: no such file$"):
        carom.load_run(tmp_path / "none.json")
    with pytest.raises(carom.RunError, match="a folder, not a saved run"):
        carom.load_run(tmp_path)


def test_a_byte_order_mark_is_no_part_of_a_run(run: carom.Run, tmp_path: Path) -> None:
    (tmp_path / "run.json").write_text(run.to_json(), encoding="utf-8-sig")
    assert carom.load_run(tmp_path / "run.json") == run


def test_repr_says_how_it_ended_and_how_right_it_is(run: carom.Run, stepped: carom.Run) -> None:
    assert repr(run).splitlines() == [
        "Run of 'Two balls on an L x 2L table'",
        "  status: time_limit",
        "  end time: 5",
        "  balls: 2",
        "  events: 12 (1 ball_ball, 11 ball_cushion)",
        "  energy: 12.5 to 0.26986",
        f"  energy error: {run.diagnostics['energy_error']:.2g}",
        "  method: exact",
        f"  digest: {str(run.digest)[:23]}...",
    ]
    assert "  lost time: 0.148743" in repr(stepped).splitlines()
    assert "  record: none" in repr(run.scenario.run(record="none")).splitlines()


@pytest.mark.parametrize("name", carom.scenarios())
def test_repr_fits_one_screen(name: str) -> None:
    lines = repr(carom.load(name).run(collisions=40, max_events=80)).splitlines()
    assert len(lines) <= 24
    assert max(map(len, lines)) <= 80


def test_repr_has_units() -> None:
    lines = repr(carom.load("pinball").with_values({"units.mass": "kg"}).run(collisions=1)).splitlines()
    assert "  end time: 0.826928 s" in lines
    assert any(line.startswith("  energy: ") and line.endswith(" J") for line in lines)


def test_run_says_what_it_kept(midterm: carom.Scenario, run: carom.Run) -> None:
    assert run.record == "all"
    assert midterm.run(record="events").record == "events"
