"""The pages of the site say all there is, and nothing that is gone; the links beside the site lead somewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

pytest.importorskip("tomllib", reason="reading scenarios apart needs Python 3.11")
pytest.importorskip("markdown_it", reason="reading Markdown needs markdown-it-py")
pytest.importorskip("carom_docs", reason="the pages are not beside the tests")

import tomllib

import carom
from carom import _engine
from carom_docs import api, blocks, links, pictures, schema
from carom_docs.blocks import DOCS, ROOT

WORDS = (DOCS / "reference" / "events-and-statuses.md").read_text(encoding="utf-8")


def stems(folder: str) -> set[str]:
    return {page.stem for page in (DOCS / folder).glob("*.md")} - {"index"}


def first_column(title: str) -> list[str]:
    """The words in the first column of the table under a heading of the page of words."""
    (section,) = re.findall(rf"^## {title}\n(.*?)(?=^## |\Z)", WORDS, re.DOTALL | re.MULTILINE)
    return re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE)


def test_each_law_has_its_page() -> None:
    assert stems("laws") == schema.laws() | {"cue-ball"}


def test_each_shape_has_its_page() -> None:
    assert stems("tables") == schema.shapes()


@pytest.mark.parametrize("folder", ["laws", "tables"])
def test_each_page_is_listed(folder: str) -> None:
    index = (DOCS / folder / "index.md").read_text(encoding="utf-8")
    for page in stems(folder):
        assert f"({page}.md)" in index
        assert f"\n{page}\n" in index


def test_each_section_of_the_scenario_reference_has_an_example() -> None:
    assert {path.stem for path in schema.FRAGMENTS.glob("*.toml")} == set(schema.sections())


@pytest.mark.parametrize("section", schema.sections())
def test_example_shows_every_key(section: str) -> None:
    values = tomllib.loads((schema.FRAGMENTS / f"{section}.toml").read_text(encoding="utf-8"))
    assert set(schema.sections()[section]) <= keys_in(values)


def keys_in(value: object) -> set[str]:
    """Every key at or below a value."""
    if isinstance(value, dict):
        return set(value).union(*map(keys_in, value.values()))
    return set().union(*map(keys_in, value)) if isinstance(value, list) else set()


def test_kinds_of_events_are_those_of_the_engine() -> None:
    assert first_column("Kinds of events") == list(_engine.EVENT_KINDS)


def test_what_is_checked_names_tests_that_are_there() -> None:
    sources = {path.stem: path.read_text(encoding="utf-8") for path in (ROOT / "crates/carom/tests").rglob("*.rs")}
    if not sources:
        pytest.skip("the engine's tests are not beside these")
    named = re.findall(r"`(\w+)::(\w+)`", (DOCS / "validation.md").read_text(encoding="utf-8"))
    assert len(named) > 40
    assert [f"{file}::{test}" for file, test in named if f"fn {test}(" not in sources.get(file, "")] == []


def test_motions_are_those_of_the_engine() -> None:
    assert first_column("Motions") == list(_engine.MOTIONS)


def test_statuses_are_those_of_the_engine() -> None:
    source = ROOT / "crates" / "carom" / "src" / "run" / "status.rs"
    if not source.exists():
        pytest.skip("the engine's source is not beside the tests")
    assert first_column("Statuses") == re.findall(r'Self::\w+ => "(\w+)"', source.read_text(encoding="utf-8"))


def test_diagnostics_are_those_of_a_run(run: carom.Run) -> None:
    assert first_column("Diagnostics") == list(run.diagnostics)


def test_each_public_name_is_on_a_page_of_the_reference(tmp_path: Path) -> None:
    api.write(tmp_path / "api")
    pages = "\n".join(page.read_text(encoding="utf-8") for page in (tmp_path / "api").glob("*.md"))
    documented = re.findall(
        r"^\.\. (?:auto(?:class|exception|function)|py:(?:data|function)):: (\w+)", pages, re.MULTILINE
    )
    assert sorted(set(documented) & set(carom.__all__)) == sorted(carom.__all__)


def test_pages_beside_the_site_link_to_what_is_there() -> None:
    for page in blocks.pages():
        if page.parent == ROOT:
            for target in re.findall(r"\]\((?!https?:|#)([^)\s#]+)", page.read_text(encoding="utf-8")):
                assert (ROOT / target).exists(), f"{page.name}: {target}"


def test_pictures_of_a_page_are_found() -> None:
    assert pictures.shown_files(DOCS / "laws" / "flight-field.md") == ["energy.svg"]


def test_dead_links_and_foreign_files_are_found(tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text(
        '<h1 id="top-of-all">x</h1><a href="other.html#here">fine</a><a href="#top-of-all">fine</a>'
        '<a href="https://example.org">fine</a><a href="gone.html">dead</a><a href="other.html#there">dead</a>'
        '<script src="https://example.org/script.js"></script>',
        encoding="utf-8",
    )
    (tmp_path / "other.html").write_text('<p id="here">y</p>', encoding="utf-8")
    assert [problem.split(": ", 1)[1] for problem in links.problems(tmp_path)] == [
        "gone.html: no such file",
        "https://example.org/script.js: is fetched from elsewhere",
        "other.html#there: no such place on the page",
    ]
