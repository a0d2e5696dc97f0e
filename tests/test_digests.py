"""The package gives the same bits as the engine's own tests."""

import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import carom

GOLDEN = json.loads((Path(__file__).parents[1] / "reference" / "digests.json").read_text(encoding="utf-8"))


def test_two_threads_at_once_give_the_golden_digests() -> None:
    names = list(carom.scenarios())
    with ThreadPoolExecutor(2) as threads:
        digests = list(threads.map(lambda name: carom.load(name).run().digest, [*names, *reversed(names)]))
    assert digests == [GOLDEN["digests"][name]["state"] for name in [*names, *reversed(names)]]


@pytest.mark.parametrize("name", carom.scenarios())
def test_ready_made_scenario_ends_on_its_golden_digest(name: str) -> None:
    run = carom.load(name).run()
    golden = GOLDEN["digests"][name]
    assert (sum(run.diagnostics["events"].values()), run.digest) == (golden["events"], golden["state"])
    assert run.physics_version == GOLDEN["physics_version"]
