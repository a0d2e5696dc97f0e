"""CONTRIBUTING.md is true: what its lists name exists, and they name every place."""

import json
import re
import typing
from pathlib import Path

import pytest

import carom
from carom import physics

ROOT = Path(__file__).parents[1]
TEXT = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")

# For each list, a name that stands wherever one more of its kind would have to be added.
LISTS = {
    "a ball-cushion law": r"\b(BallCushion::Restitution|ball_cushion::Restitution|Self::Restitution|Damping)\b",
    "a table shape": r"\b(Table::Circle|pub fn circle|circle, rectangle|cls\(\"circle\")",
    "a flight law": r"\b(Flight::Field|class Field)\b",
    "an observable": r"\bcorrections\b",
}


def section(title: str) -> str:
    """The text of a list."""
    (found,) = re.findall(rf"^## Add {title}\n(.*?)(?=^## |\Z)", TEXT, re.DOTALL | re.MULTILINE)
    return found


def words(text: str) -> list[str]:
    """What stands in backticks, other than blocks and commands."""
    text = re.sub(r"(?ms)^```.*?^```$", "", text)
    return [word for word in re.findall(r"`([^`]+)`", text) if not word.startswith(("make ", "cargo ", ".venv/"))]


def is_path(word: str) -> bool:
    return (ROOT / word).exists() or "/" in word or word.endswith((".md", ".py", ".rs"))


def text_of(path: Path) -> str:
    if path.is_dir():
        return " ".join(path.name for path in path.iterdir())
    return path.read_text(encoding="utf-8")


@pytest.mark.parametrize("title", LISTS)
def test_what_a_list_names_exists(title: str) -> None:
    paths: list[Path] = []
    checked = 0
    for word in words(section(title)):
        if "<" in word:
            assert (ROOT / word).parent.is_dir(), word
        elif is_path(word):
            assert (ROOT / word).exists(), word
            paths.append(ROOT / word)
        else:
            # A name stands in the file before it; in the last lines of a list, in one of its files.
            near = paths if "goes the same way" in section(title).split(f"`{word}`")[0] else paths[-1:]
            assert any(word in text_of(path) for path in near), f"{word} is not in {[str(path) for path in near]}"
            checked += 1
    assert len(paths) >= 5
    assert checked >= 5


@pytest.mark.parametrize("title", LISTS)
def test_a_list_names_every_place(title: str) -> None:
    listed = {(ROOT / word).resolve() for word in words(section(title)) if is_path(word)}
    files = [*ROOT.glob("crates/*/src/**/*.rs"), *ROOT.glob("crates/carom/tests/engine/kit/*.rs")]
    files += ROOT.glob("python/carom/**/*.py")
    places = {path for path in files if re.search(LISTS[title], path.read_text(encoding="utf-8"))}
    assert len(places) >= 2
    missing = sorted(str(path.relative_to(ROOT)) for path in places - listed)
    assert missing == []


def test_paths_elsewhere_on_the_page_exist() -> None:
    head = TEXT.split("## Add ")[0]
    paths = [word for word in words(head) if "/" in word or word.endswith(".md")]
    assert len(paths) >= 3
    assert [path for path in paths if not (ROOT / path).exists()] == []


def test_commands_on_the_page_are_targets() -> None:
    named = set(re.findall(r"make ([a-z-]+)", TEXT))
    assert len(named) >= 5
    assert named <= set(targets())


def targets() -> list[str]:
    return re.findall(r"^([a-z][a-z-]*):", MAKEFILE, re.MULTILINE)


@pytest.mark.parametrize(("definition", "union"), [("BallBall", physics.BallLaw), ("BallCushion", physics.CushionLaw)])
def test_every_law_of_the_schema_has_a_class_in_python(definition: str, union: object) -> None:
    in_schema = {
        choice["properties"]["law"]["const"]: set(choice["properties"]) - {"law"}
        for choice in json.loads(carom.schema())["$defs"][definition]["oneOf"]
    }
    in_python = {law.tag["law"]: set(law.__dataclass_fields__) - {"_", "tag"} for law in typing.get_args(union)}
    assert in_schema.keys() == in_python.keys()
    assert all(keys <= in_python[law] for law, keys in in_schema.items())
