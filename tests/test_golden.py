"""The Python package gives the engine's golden digests, bit for bit."""

import json
from pathlib import Path

import carom
import pytest

GOLDEN = Path(__file__).parent.parent / "crates" / "carom" / "tests" / "golden" / "digests.json"


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_ready_made_scenario_ends_in_its_golden_bits(name):
    golden = json.loads(GOLDEN.read_text())["digests"][name]
    run = carom.load(name).run()
    assert len(run.events) == golden["events"]
    assert run.end_time.hex() == float(memoryview(bytes.fromhex(golden["end_time"])[::-1]).cast("d")[0]).hex()
    assert run.digest == golden["state"]
