"""What Carom says of itself agrees everywhere: CITATION.cff, the printed citation, the package, the engine."""

import re
from importlib.metadata import metadata
from pathlib import Path

import yaml

import carom

ROOT = Path(__file__).parents[1]
CITATION = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))


def test_the_engine_has_the_version_of_the_citation_file() -> None:
    cargo = (ROOT / "Cargo.toml").read_text(encoding="utf-8")
    assert re.findall(r'(?m)^version = "(.*)"', cargo) == [CITATION["version"]]
    assert carom.__version__ == CITATION["version"]


def test_the_changelog_speaks_of_this_version_first() -> None:
    versions = re.findall(r"(?m)^## (\S+)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
    assert versions[0] == CITATION["version"]


def test_the_printed_citation_is_that_of_the_citation_file() -> None:
    (author,) = CITATION["authors"]
    text, entry = carom.citation().split("\n\n")
    assert text == f"{author['name']}. {CITATION['title']}. Version {CITATION['version']}. Computer software."
    fields = dict(re.findall(r"(\w+) += \{+(.*?)\}+,", entry))
    assert fields == {"author": author["name"], "title": CITATION["title"], "version": CITATION["version"]}
    assert entry.startswith(f"@{CITATION['type']}{{carom,\n")


def test_the_package_has_the_authors_and_the_licence_of_the_citation_file() -> None:
    said = metadata("carom")
    assert said["Author"] == CITATION["authors"][0]["name"]
    assert said["License-Expression"] == " OR ".join(CITATION["license"])
