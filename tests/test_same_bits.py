"""However a run is taken, its bits are the same."""

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

import carom


def _bits(run: carom.Run) -> tuple[str, str, list[carom.Event], bytes]:
    flights = run.positions(run.sample_times(0.37)).tobytes()
    return run.status, run.digest, list(run.events), flights


def test_resumed_run_is_the_longer_run(midterm: carom.Scenario, run: carom.Run) -> None:
    part = midterm.run(duration=0.4)
    for end in (1.1, 1.1, 3.0):
        part = part.resume(duration=end)
    assert _bits(part.resume(duration=5)) == _bits(run)


def test_resumed_from_a_file_or_after_a_stop(midterm: carom.Scenario, run: carom.Run) -> None:
    from carom import _engine

    stopped = midterm.run(until="ball_ball")
    loaded = carom.Run(_engine.Run.from_json(stopped.to_json()))
    assert _bits(loaded.resume(duration=5)) == _bits(run)


def test_resume_by_collisions_counts_from_the_start(midterm: carom.Scenario, run: carom.Run) -> None:
    part = midterm.run(collisions=3).resume(collisions=7)
    assert (part.status, len(part.events)) == ("collision_limit", 7)
    assert list(part.events) == list(run.events[:7])


def test_resume_to_an_earlier_time_is_an_error(run: carom.Run) -> None:
    with pytest.raises(carom.ScenarioError, match=r"duration: .*5"):
        run.resume(duration=4)


def test_single_steps_give_the_same_run(midterm: carom.Scenario, run: carom.Run) -> None:
    simulation = midterm.start()
    assert list(simulation) == list(run.events)
    assert simulation.status == "time_limit"
    assert simulation.step() is None
    assert _bits(simulation.finish()) == _bits(run)


def test_looking_on_changes_nothing(midterm: carom.Scenario, run: carom.Run) -> None:
    simulation = midterm.start()
    for time in (0.0, 0.1, 0.1, 0.5, 2.0):
        simulation.run_until(time)
        simulation.candidates()
        assert simulation.time == time
        assert np.array_equal(simulation.positions, run.positions(time))
        assert np.array_equal(simulation.velocities, run.velocities(time))
    assert simulation.step() == run.events.by_time(2.0, 5.0)[0]
    assert _bits(simulation.finish()) == _bits(run)


def test_stopped_simulation_is_the_beginning_of_the_run(midterm: carom.Scenario, run: carom.Run) -> None:
    simulation = midterm.start()
    simulation.run_until(1.0)
    simulation.run_until(1.0)
    simulation.stop()
    part = simulation.finish()
    assert (part.status, part.end_time) == ("stopped", 1.0)
    assert list(part.events) == list(run.events.by_time(0, 1))
    assert part.verify()


def test_candidates_foresee_the_next_event() -> None:
    balls = [
        carom.Ball("a", radius=0.125, position=(0, 1), velocity=(1, 0)),
        carom.Ball("b", radius=0.125, position=(1, 1), velocity=(-1, 0)),
        carom.Ball("c", radius=0.125, position=(0, -1)),
    ]
    simulation = carom.Scenario(carom.Table.circle(radius=4), balls, duration=5).start()
    a, b, c = simulation.candidates()
    assert a == carom.Candidate("a", "ball_ball", "b", None, 0.375, 0.75)
    assert b == carom.Candidate("b", "ball_ball", "a", None, 0.375, 0.75)
    assert c == carom.Candidate("c", None, None, None, None, None)
    event = simulation.step()
    assert event is not None
    assert event.time == 0.375
    a, _, _ = simulation.candidates()
    assert (a.kind, a.cushion) == ("ball_cushion", "rim")


def test_stepped_method_does_not_go_event_by_event(midterm: carom.Scenario) -> None:
    with pytest.raises(carom.ScenarioError, match="method: only the exact method"):
        midterm.start(method=carom.Stepped(dt=0.1))


@pytest.mark.parametrize(
    "environment", [{"OMP_NUM_THREADS": "1", "LC_ALL": "C"}, {"LC_ALL": "C.UTF-8", "TZ": "Asia/Tokyo"}]
)
def test_other_processes_give_the_same_digest(run: carom.Run, environment: dict[str, str]) -> None:
    code = "import carom; print(carom.load('midterm').run().digest)"
    done = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
    )
    assert done.stdout.strip() == run.digest


@pytest.mark.parametrize("name", carom.scenarios())
def test_ready_made_scenario_has_the_same_bits_saved_resumed_and_stepped(name: str) -> None:
    scenario = carom.load(name)
    run = scenario.run()
    loaded = pickle.loads(pickle.dumps(run))
    assert loaded == run
    assert loaded.digest == run.digest
    assert loaded.verify()
    ends = {
        "duration": scenario.to_dict().get("duration"),
        "collisions": scenario.to_dict().get("collisions"),
    }
    part = scenario.run(max_events=len(run.events) // 2).resume(**ends)
    assert (part.digest, part.events) == (run.digest, run.events)
    if run.steps is None:
        assert list(scenario.start()) == list(run.events)
