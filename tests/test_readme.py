"""What the README says is true: its scenario is the midterm, the paths it names exist."""

import re
from pathlib import Path

import carom

ROOT = Path(__file__).parents[1]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def block(language: str) -> str:
    """The text of the one block in a language."""
    (found,) = re.findall(rf"```{language}\n(.*?)```", TEXT, re.DOTALL)
    return found


def test_scenario_block_is_the_midterm():
    assert carom.Scenario.from_toml(block("toml")).run().digest == carom.load("midterm").run().digest


def test_files_that_it_names_exist():
    paths = re.findall(r"`([A-Za-z]+(?:/[A-Za-z_.]+)+|[A-Z-]+(?:\.md)?)`", TEXT) + re.findall(
        r"\]\((?!https?:)(\S+?)\)", TEXT
    )
    assert len(paths) > 4
    for path in paths:
        assert (ROOT / path).exists(), path
