"""The code blocks of Markdown pages, and a reader who does what they say.

A block's language decides what is done with it; see `Reader`. A page may show output where it shows the code that
gives it; ``...`` stands for anything.
"""

from __future__ import annotations

import doctest
import io
import re
import shutil
from collections.abc import Iterator, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from markdown_it import MarkdownIt

import carom
from carom_docs import shell
from carom_docs.parts import with_parts

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
DIRECTIVES = {"toctree", "include", "figure", "image", "eval-rst", "math"}
MOST_EVENTS = 10_000
OF_A_KIND = {"shape", "preset", "law", "kind"}


@dataclass(frozen=True)
class Block:
    """A fenced block: where it stands, in which language, and its text."""

    page: Path
    line: int
    language: str
    text: str

    @property
    def place(self) -> str:
        """The page and the line, as an editor understands it."""
        return f"{self.page}:{self.line}"

    def fail(self, message: str) -> AssertionError:
        """Give an error that names the place of the block."""
        return AssertionError(f"{self.place}: {message}")


def pages() -> list[Path]:
    """Give every page whose blocks are run: the hand-written ones of the site and those beside the README."""
    beside = [ROOT / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    written = [page for page in sorted(DOCS.rglob("*.md")) if not page.is_relative_to(DOCS / "reference" / "api")]
    return [page for page in beside if page.exists()] + written


def blocks_of(page: Path) -> list[Block]:
    """Give the code blocks of a page in order, those of its generated parts too."""
    return list(_blocks(page, with_parts(page.read_text(encoding="utf-8")), 0))


def files_beside(page: Path) -> list[Path]:
    """Give the files of the project that a page links to and that are no pages or pictures of the site."""
    links = re.findall(r"\]\((?!https?:|#)([^)\s#]+)", page.read_text(encoding="utf-8"))
    found = {(page.parent / link).resolve() for link in links}
    return sorted(file for file in found if file.is_file() and not file.is_relative_to(DOCS))


def follow(page: Path) -> None:
    """Do all that a page says, in the working folder.

    The files that it links to are there: for a page of the site as if downloaded, else where the project has them.
    """
    for file in files_beside(page):
        place = Path(file.name) if page.is_relative_to(DOCS) else file.relative_to(ROOT)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, place)
    reader = Reader()
    for block in blocks_of(page):
        reader.follow(block)


def _blocks(page: Path, text: str, offset: int) -> Iterator[Block]:
    for token in MarkdownIt("commonmark").parse(text):
        if token.type not in ("fence", "code_block"):
            continue
        line = offset + (token.map or [0])[0] + 1
        language = token.info.strip() if token.type == "fence" else "an indented block"
        directive = re.fullmatch(r"\{([\w-]+)\}.*", language)
        if directive is None:
            yield Block(page, line, language, token.content)
        elif directive[1] not in DIRECTIVES:
            raise AssertionError(f"{page}:{line}: blocks in {{{directive[1]}}} would not be run; fence it with :::")


class Reader:
    """Someone who goes through a page from top to bottom and does what it says, in the working folder.

    ``python`` is run, all blocks of a page in one namespace, sessions (``>>>``) as doctests; ``toml`` is a scenario,
    or a part of one that is laid over the midterm, written to a file where its first line names one
    (``# mine.toml``); with ``[vary]`` it is a sweep, which has to be named; ``json`` is like a scenario, without a
    file; of ``console`` the lines that begin with ``$`` are run by a shell; ``text`` is output where it follows a
    block that printed something, and else nothing to run.
    """

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"__name__": "__main__"}
        self.printed = ""

    def follow(self, block: Block) -> None:
        """Do what a block says; an AssertionError says what is wrong with it."""
        known = {
            "python": self._python,
            "toml": self._toml,
            "json": self._json,
            "console": self._console,
            "text": self._text,
        }
        if block.language not in known:
            raise block.fail(f"a block of {block.language or 'no language'} would not be run; {', '.join(known)} are")
        known[block.language](block)

    def _python(self, block: Block) -> None:
        if block.text.lstrip().startswith(">>>"):
            self._session(block)
            return
        code = compile("\n" * block.line + block.text, str(block.page), "exec")
        printed = io.StringIO()
        with redirect_stdout(printed):
            exec(code, self.names)
        self.printed = printed.getvalue()

    def _session(self, block: Block) -> None:
        test = doctest.DocTestParser().get_doctest(block.text, self.names, block.place, str(block.page), block.line)
        said: list[str] = []
        result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append, clear_globs=False)
        if result.failed:
            raise block.fail("".join(said))
        self.names.update(test.globs)

    def _toml(self, block: Block) -> None:
        import tomllib

        named = re.match(r"# (\S+\.toml)\n", block.text)
        if named:
            Path(named[1]).write_text(block.text, encoding="utf-8")
        values = tomllib.loads(block.text)
        if named and "vary" in values:
            carom.Sweep.load(named[1])
        else:
            _try_scenario(block, values)

    def _json(self, block: Block) -> None:
        import json

        _try_scenario(block, json.loads(block.text))

    def _console(self, block: Block) -> None:
        for result in shell.run(block.text):
            if result.unseen_failure:
                raise block.fail(f"{result.command} ended with {result.status}:\n{result.output}")
            if result.shown and not same_output(result.shown, result.output):
                raise block.fail(f"{result.command} gave\n{result.output}\nand not\n{result.shown}")

    def _text(self, block: Block) -> None:
        if self.printed and not same_output(block.text, self.printed):
            raise block.fail(f"printed was\n{self.printed}\nand not\n{block.text}")
        self.printed = ""


def same_output(shown: str, given: str) -> bool:
    """Tell whether a page shows what was given: ``...`` stands for anything, white space does not count."""
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    return doctest.OutputChecker().check_output(shown.rstrip() + "\n", given.rstrip() + "\n", flags)


def _try_scenario(block: Block, values: Mapping[str, Any]) -> None:
    is_whole = {"table", "balls"} <= values.keys() or bool({"gas", "balls_from"} & values.keys())
    whole = values if is_whole else laid_over(carom.load("midterm").to_dict(), values)
    try:
        carom.Scenario.from_dict(whole).run(max_events=MOST_EVENTS, record="none")
    except carom.CaromError as error:
        raise block.fail(str(error)) from None


def laid_over(under: Mapping[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """Lay a part of a scenario over a whole one; what says of which kind it is takes the place of the other."""
    merged = dict(under)
    for key, value in over.items():
        old: Any = under.get(key)
        merge = isinstance(value, Mapping) and isinstance(old, Mapping) and not OF_A_KIND & value.keys()
        merged[key] = laid_over(old, value) if merge else value
    return merged
