"""Long runs let other threads work, and end on Ctrl-C."""

import signal
import subprocess
import sys
import threading
import time

import pytest

import carom

LONG = """
import carom
from carom import _engine
table = carom.Table.rectangle(width=1, length=1)
balls = [carom.Ball("a", radius=0.1, position=(0.3, 0.3), velocity=(1, 0.7)),
         carom.Ball("b", radius=0.1, position=(0.7, 0.6), velocity=(-0.4, 0.9))]
scenario = carom.Scenario(table, balls, duration=1e12, record="none", max_events=10**12)
def longer_than_it_was(run):
    text = run.to_json().replace('"duration":1.0', '"duration":1e12')
    return carom.Run(_engine.Run.from_json(text))
scenario.run(duration=1), scenario.start().step()  # so that everything is imported
try:
    print("ready", flush=True)
    {call}
except KeyboardInterrupt:
    print("interrupted")
"""

CALLS = {
    "run": "scenario.run()",
    "finish": "scenario.start().finish()",
    "run_until": "scenario.start().run_until(1e11)",
    "predicate": "scenario.run(until=lambda event: False)",
    "resume": "scenario.run(duration=1).resume(duration=1e12)",
    "stepped": "scenario.run(method=carom.Stepped(dt=1e-6), duration=100)",
    "verify": "longer_than_it_was(scenario.run(duration=1)).verify()",
}


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to a single child")
@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS.keys())
def test_ctrl_c_ends_a_long_call(call: str) -> None:
    command = [sys.executable, "-c", LONG.format(call=call)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "ready\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        try:
            assert child.communicate(timeout=60)[0] == "interrupted\n"
        finally:
            child.kill()


def test_interrupted_simulation_can_still_give_its_beginning(long_running: carom.Scenario) -> None:
    simulation = long_running.start()
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.finish()
    simulation.stop()
    run = simulation.finish()
    assert run.status == "stopped"
    assert 0 < run.end_time < 1e12


def test_other_threads_work_during_a_run(long_running: carom.Scenario) -> None:
    done: list[carom.Run] = []
    scenario = long_running.with_values({"collisions": 1_000_000})
    worker = threading.Thread(target=lambda: done.append(scenario.run()))
    worker.start()
    turns = 0
    while worker.is_alive():
        turns += 1
        time.sleep(0.001)
    assert done[0].status == "collision_limit"
    # With the lock held during the run, this thread would get a turn or two.
    assert turns > 5
