"""The package gives the same bits as the engine's own tests."""

import json
from pathlib import Path

import pytest

import carom

GOLDEN = json.loads((Path(__file__).parents[1] / "reference" / "digests.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", carom.scenarios())
def test_ready_made_scenario_ends_on_its_golden_digest(name: str) -> None:
    run = carom.load(name).run()
    golden = GOLDEN["digests"][name]
    assert (sum(run.diagnostics["events"].values()), run.digest) == (golden["events"], golden["state"])
    assert run.physics_version == GOLDEN["physics_version"]
