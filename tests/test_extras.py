"""What an extra brings: without it, one line says what is needed, in Python and on the shell."""

import ast
import re
import subprocess
import sys
from importlib.metadata import requires
from pathlib import Path

import pytest
from packaging.requirements import Requirement

import carom

PACKAGE = Path(carom.__file__).parent
OPTIONAL = {"pandas": "data", "pyarrow": "data", "imageio_ffmpeg": "movie", "gsd": "gas", "distributed": "cluster"}

# Python starts as if the optional packages were not installed: nothing finds them.
HIDING = f"""
import sys
from importlib.abc import MetaPathFinder

class Hiding(MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in {set(OPTIONAL)}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)

sys.meta_path.insert(0, Hiding())
"""


def without_extras(code: str, *words: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", HIDING + code, *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)


@pytest.mark.parametrize(
    ("call", "line"),
    [
        ("run.events.to_pandas()", "pandas is not installed: needs carom[data]"),
        ("run.trajectory([0, 1]).to_arrow()", "pyarrow is not installed: needs carom[data]"),
        ("run.animate('film.mp4')", "imageio_ffmpeg is not installed: needs carom[movie]"),
        ("records.read_snapshot('gas.gsd')", "gsd is not installed: needs carom[gas]"),
        ("records.GsdWriter('gas.gsd').write(disc)", "gsd is not installed: needs carom[gas]"),
        ("records.read_snapshot('gas.parquet')", "pyarrow is not installed: needs carom[data]"),
        ("records.ParquetWriter('gas.parquet').write(disc)", "pyarrow is not installed: needs carom[data]"),
        ("records.events_to_parquet(run.events, 'e.parquet')", "pyarrow is not installed: needs carom[data]"),
    ],
)
def test_a_missing_extra_is_one_line(call: str, line: str, tmp_path: Path) -> None:
    code = f"""
import os, carom
from carom import records
os.chdir({str(tmp_path)!r})
run = carom.load("midterm").run()
disc = records.Snapshot(0.0, 0, (4, 3), (True, True), [[1, 1]], [[0, 0]], [0.5], [1])
try:
    {call}
except carom.MissingExtraError as missing:
    print(missing)
"""
    done = without_extras(code)
    assert (done.stdout, done.stderr) == (line + "\n", "")
    assert not list(tmp_path.iterdir())


def test_a_missing_extra_is_one_line_on_the_shell(tmp_path: Path) -> None:
    code = "from carom.cli import main; sys.argv[0] = 'carom'; main()"
    done = without_extras(code, "run", "midterm", "--animation", "mp4", "--out", tmp_path / "out")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "error: imageio_ffmpeg is not installed: needs carom[movie]\n"
    assert not list(tmp_path.iterdir())


def test_what_the_base_install_promises_works_without_extras(tmp_path: Path) -> None:
    code = "from carom.cli import main; sys.argv[0] = 'carom'; main()"
    done = without_extras(code, "run", "midterm", "--format", "png,svg,pdf", "--out", tmp_path / "out")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "out" / "animation.gif").stat().st_size > 0


def test_a_package_that_does_not_load_keeps_its_own_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "imageio_ffmpeg.py").write_text("import a_module_that_is_not_there\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "imageio_ffmpeg", raising=False)
    with pytest.raises(ModuleNotFoundError, match="a_module_that_is_not_there"):
        carom.load("midterm").run().animate(tmp_path / "film.mp4")


def test_optional_packages_are_asked_for_by_their_extra_and_imported_nowhere_else() -> None:
    asked: set[tuple[str, str]] = set()
    for path in PACKAGE.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        asked |= set(re.findall(r'needed\("(\w+)", "(\w+)"\)', text))
        assert not (imported_when_run(ast.parse(text)) & set(OPTIONAL)), path
    assert asked == set(OPTIONAL.items())


def imported_when_run(tree: ast.AST) -> set[str]:
    """The packages that a module imports, but for those that only a type checker sees."""
    if isinstance(tree, ast.If) and ast.unparse(tree.test) == "TYPE_CHECKING":
        return set()
    if isinstance(tree, ast.Import):
        return {alias.name.split(".")[0] for alias in tree.names}
    if isinstance(tree, ast.ImportFrom):
        return {(tree.module or "").split(".")[0]}
    return set().union(*map(imported_when_run, ast.iter_child_nodes(tree)))


def test_extras_bring_what_is_asked_of_them_and_all_brings_everything() -> None:
    brought: dict[str, set[str]] = {}
    for requirement in map(Requirement, requires("carom") or []):
        for extra in ("data", "movie", "gas", "cluster", "all"):
            # A marker holds for an extra where it does not hold without one.
            if requirement.marker and requirement.marker.evaluate({"extra": extra}):
                brought.setdefault(extra, set()).add(requirement.name.replace("-", "_"))
    assert brought.pop("all") == set().union(*brought.values())
    assert {(name, extra) for extra, names in brought.items() for name in names} == set(OPTIONAL.items())
