"""The files about the project agree: the Makefile's help, the workflows' rights, the floors."""

import re
from importlib.metadata import metadata, requires
from pathlib import Path
from typing import Any

import pytest
import yaml
from packaging.requirements import Requirement

ROOT = Path(__file__).parents[1]
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def test_make_help_lists_every_target() -> None:
    phony = set(" ".join(re.findall(r"(?m)^\.PHONY: (.*)", MAKEFILE)).split())
    assert phony == set(re.findall(r"(?m)^([a-z-]+):.*## ", MAKEFILE))


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_workflows_have_no_more_rights_than_they_need(path: Path) -> None:
    workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
    assert workflow["permissions"] == {"contents": "read"}
    assert "concurrency" in workflow
    for name, job in workflow["jobs"].items():
        assert "timeout-minutes" in job, name
        assert "permissions" not in job or name == "publish"
        for step in steps_using(job, "actions/checkout"):
            assert step["with"]["persist-credentials"] is False


def steps_using(job: dict[str, Any], action: str) -> list[dict[str, Any]]:
    return [step for step in job["steps"] if step.get("uses", "").startswith(action)]


def test_the_floors_are_the_oldest_versions_that_the_package_allows() -> None:
    lines = (ROOT / "tests" / "packaging" / "floors.txt").read_text(encoding="utf-8").splitlines()
    tried = {floor.name: floor.specifier for floor in map(Requirement, lines[1:])}
    allowed = {needed.name: needed.specifier for needed in map(Requirement, requires("carom") or [])}
    assert tried.keys() == allowed.keys()
    for name, specifiers in allowed.items():
        (floor,) = (specifier.version for specifier in specifiers if specifier.operator == ">=")
        assert tried[name].contains(floor), name


def test_the_oldest_python_is_the_one_of_the_stable_interface() -> None:
    binding = (ROOT / "crates" / "carom-python" / "Cargo.toml").read_text(encoding="utf-8")
    (minor,) = re.findall(r"abi3-py3(\d+)", binding)
    assert metadata("carom")["Requires-Python"] == f">=3.{minor}"
