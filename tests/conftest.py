"""What the tests share."""

import signal

import course_scheme as course
import pytest

import carom

# A shell starts what runs in the background with Ctrl-C ignored, and children inherit that; these tests press it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def midterm() -> carom.Scenario:
    return carom.load("midterm")


@pytest.fixture(scope="session")
def run(midterm: carom.Scenario) -> carom.Run:
    return midterm.run()


@pytest.fixture(scope="session")
def stepped(midterm: carom.Scenario) -> carom.Run:
    return midterm.run(method=carom.Stepped(dt=0.03))


@pytest.fixture(scope="session")
def long_running() -> carom.Scenario:
    """Two elastic balls that go on for more events than any test would wait for."""
    table = carom.Table.rectangle(width=1, length=1)
    balls = [
        carom.Ball("a", radius=0.1, position=(0.3, 0.3), velocity=(1, 0.7)),
        carom.Ball("b", radius=0.1, position=(0.7, 0.6), velocity=(-0.4, 0.9)),
    ]
    return carom.Scenario(table, balls, duration=1e12, record="none", max_events=10**12)


@pytest.fixture(scope="session")
def scheme() -> carom.Scenario:
    """The exercise in steps, as a scenario."""
    return carom.load("midterm_stepped")


@pytest.fixture(scope="session")
def right() -> list[course.Row]:
    """What a right program for the exercise gives."""
    return course.simulate()
