"""Importing the package is quick, because it loads next to nothing."""

import ast
import importlib
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import carom

HEAVY = ["matplotlib", "pandas", "pyarrow", "numpy", "typer", "rich", "jinja2", "carom._engine"]


def _in_a_fresh_python(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    return done.stdout


def test_import_loads_no_heavy_module() -> None:
    loaded = _in_a_fresh_python(f"import sys, carom; print([m for m in {HEAVY} if m in sys.modules])")
    assert loaded.strip() == "[]"


def test_a_shot_is_computed_without_numpy() -> None:
    code = "import sys, carom; run = carom.load('two_ball_shot').run(); print(run.status, 'numpy' in sys.modules)"
    assert _in_a_fresh_python(code).strip() == "at_rest False"


def test_computing_and_saving_a_run_draws_nothing(tmp_path: Path) -> None:
    code = (
        "import sys, carom; run = carom.load('midterm').run(); run.events; run.positions([1.0]);"
        f"run.save({str(tmp_path / 'run.json')!r}); run.trajectory([0, 1]).to_csv({str(tmp_path / 't.csv')!r});"
        "print([m for m in ('matplotlib', 'jinja2', 'pandas', 'pyarrow') if m in sys.modules])"
    )
    assert _in_a_fresh_python(code).strip() == "[]"


def test_import_time_is_reported(record_property: Callable[[str, object], None]) -> None:
    code = "import time; t = time.perf_counter(); import carom; print(time.perf_counter() - t)"
    seconds = min(float(_in_a_fresh_python(code)) for _ in range(3))
    record_property("import_carom_ms", round(seconds * 1000, 1))


@pytest.mark.parametrize("name", carom.__all__)
def test_public_name_is_the_one_of_its_module(name: str) -> None:
    home = importlib.import_module(f"carom.{carom._HOME_OF[name]}")
    assert getattr(carom, name) is getattr(home, name)


def test_public_names_are_said_the_same_to_type_checkers() -> None:
    tree = ast.parse(Path(carom.__file__).read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    told = {alias.name: node.module for node in imports for alias in node.names if node.module != "__future__"}
    public = {name: f"carom.{home}" for name, home in carom._HOME_OF.items()}
    assert {name: told.get(name) for name in public} == public
    assert sorted(public) == sorted(carom.__all__)


def test_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'Bal'"):
        carom.Bal  # noqa: B018
