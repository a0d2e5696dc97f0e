"""Every code block of the README, of the pages beside it and of the site is run, as a reader would."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("tomllib", reason="reading scenarios apart needs Python 3.11")
pytest.importorskip("pty", reason="the shell's blocks are run in a terminal of Unix")
pytest.importorskip("markdown_it", reason="reading Markdown needs markdown-it-py")
pytest.importorskip("carom_docs", reason="the pages are not beside the tests")

from carom_docs import blocks, shell
from carom_docs.blocks import ROOT, Block, Reader

PAGES = blocks.pages()


@pytest.mark.parametrize("page", PAGES, ids=[str(page.relative_to(ROOT)) for page in PAGES])
def test_blocks_run(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks.follow(page)


def test_pages_are_found() -> None:
    found = {str(page.relative_to(ROOT)) for page in PAGES}
    assert {"README.md", "docs/index.md", "docs/reference/scenario.md"} <= found
    assert len(blocks.blocks_of(ROOT / "README.md")) > 2


WRONG = [
    ("python", "1 / 0"),
    ("python", ">>> 1 + 1\n3"),
    ("toml", "duration = -1.0"),
    ("json", '{"balls": []}'),
    ("console", "$ carom check nothing-there"),
    ("console", "$ echo yes\nno"),
    ("console", "$ make no-such-target"),
    ("console", '$ pip install "carom[nothing]"'),
    ("console", "carom run midterm"),
    ("fortran", "print *, 1"),
    ("", "no language"),
]


@pytest.mark.parametrize(("language", "text"), WRONG)
def test_a_wrong_block_fails(language: str, text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises((AssertionError, ZeroDivisionError)):
        Reader().follow(Block(Path("page.md"), 1, language, text))


def test_printed_output_is_held_against_the_page() -> None:
    reader = Reader()
    reader.follow(Block(Path("page.md"), 1, "python", "print(2 + 2)"))
    with pytest.raises(AssertionError, match="printed was\n4"):
        reader.follow(Block(Path("page.md"), 5, "text", "5"))


def test_indented_blocks_and_unknown_directives_are_refused(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("Words:\n\n    indented = True\n", encoding="utf-8")
    (block,) = blocks.blocks_of(page)
    with pytest.raises(AssertionError, match="an indented block would not be run"):
        Reader().follow(block)
    page.write_text("```{code-block} python\n1 / 0\n```\n", encoding="utf-8")
    with pytest.raises(AssertionError, match="would not be run"):
        blocks.blocks_of(page)


def test_a_command_that_fails_is_fine_where_the_page_asks_for_its_status() -> None:
    failing, asking = shell.run("$ false\n$ echo $?\n1")
    assert not failing.unseen_failure
    assert asking.output.strip() == "1"


def test_files_that_a_page_links_to_are_found() -> None:
    page = ROOT / "docs" / "reference" / "commands.md"
    assert blocks.files_beside(page) == [ROOT / "examples" / "exercise.py"]
