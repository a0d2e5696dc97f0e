"""The notebook of the exercise runs from top to bottom and shows what it speaks of."""

from pathlib import Path
from typing import Any

import nbclient
import nbformat
import pytest

import carom

NOTEBOOK = Path(__file__).parents[1] / "examples" / "exercise.ipynb"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("notebook")


@pytest.fixture(scope="module")
def cells(folder: Path) -> list[Any]:
    """The code cells after they ran, with this interpreter, in an empty folder."""
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    with pytest.MonkeyPatch.context() as patch:
        # Nothing of Jupyter's or IPython's is read or written outside the folder.
        for name in ("JUPYTER_RUNTIME_DIR", "JUPYTER_DATA_DIR", "JUPYTER_CONFIG_DIR", "IPYTHONDIR"):
            (folder / ".jupyter" / name).mkdir(parents=True)
            patch.setenv(name, str(folder / ".jupyter" / name))
        work = {"metadata": {"path": str(folder)}}
        nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", resources=work).execute()
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def shown(cells: list[Any], start: str) -> dict[str, str]:
    """What the one cell that contains a line shows, by kind."""
    (cell,) = [cell for cell in cells if start in cell.source.splitlines()]
    (result,) = [output for output in cell.outputs if output.output_type == "execute_result"]
    data: dict[str, str] = result.data
    return data


def test_it_is_stored_without_results() -> None:
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        assert cell.get("outputs", []) == []
        assert cell.get("execution_count") is None


def test_runs_and_scenarios_are_shown_with_their_pictures(cells: list[Any], run: carom.Run) -> None:
    for line in ("scenario", "run", "stepped"):
        assert "<img src=" in shown(cells, line)["text/html"]
    assert str(run.digest) in shown(cells, "run")["text/html"]
    assert repr(run) == shown(cells, "run")["text/plain"]
    assert "EventTable, 12 rows" in shown(cells, "run.events")["text/html"]


def test_figures_are_shown(cells: list[Any]) -> None:
    pictures = [output for cell in cells for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == 3


def test_its_last_results_are_those_of_the_package(cells: list[Any], folder: Path, midterm: carom.Scenario) -> None:
    variant = midterm.with_values({"balls.red.velocity[0]": 2.5, "physics.ball_cushion.factor": 0.95}).run()
    found = eval(shown(cells, 'variant_run.report("exercise.html")')["text/plain"])
    assert found == (variant.status, len(variant.events), variant.digest)
    assert str(variant.digest) in (folder / "exercise.html").read_text(encoding="utf-8")
    missed = shown(cells, "comparison.table")["text/html"]
    assert "ColumnTable, 6 rows" in missed


def test_nothing_is_written_to_the_error_stream(cells: list[Any]) -> None:
    assert [output for cell in cells for output in cell.outputs if output.get("name") == "stderr"] == []
