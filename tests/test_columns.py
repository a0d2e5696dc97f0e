"""Tables of columns: what they hold and how they are written."""

import csv
import sys
from pathlib import Path

import numpy as np
import pytest

import carom
from carom.columns import ColumnTable

AWKWARD = np.array([0.1, 1 / 3, -0.0, 1e-310, 123456789.12345679, np.nan])


@pytest.fixture
def table() -> ColumnTable:
    words = np.array(["a", 'say "b", c', None, "", "d", "e"], dtype=object)
    return ColumnTable({"x": AWKWARD, "n": np.arange(6), "word": words})


def test_csv_reads_back_to_the_same_bits(table: ColumnTable, tmp_path: Path) -> None:
    table.to_csv(tmp_path / "t.csv")
    with (tmp_path / "t.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert np.array([float(row["x"]) for row in rows]).tobytes() == AWKWARD.tobytes()
    assert [row["word"] for row in rows] == ["a", 'say "b", c', "", "", "d", "e"]


def test_csv_floats_have_17_significant_digits(table: ColumnTable, tmp_path: Path) -> None:
    table.to_csv(tmp_path / "t.csv")
    assert (tmp_path / "t.csv").read_text(encoding="utf-8").splitlines()[:2] == [
        "x,n,word",
        "0.10000000000000001,0,a",
    ]


def test_columns_cannot_be_written_to(table: ColumnTable) -> None:
    with pytest.raises(ValueError, match="read-only"):
        table["x"][0] = 1.0


def test_unknown_column_names_the_known_ones(table: ColumnTable) -> None:
    with pytest.raises(KeyError, match="the columns are x, n, word"):
        table["y"]


def test_tables_compare_by_what_they_hold(table: ColumnTable) -> None:
    assert table == ColumnTable(table.to_dict())
    assert table != ColumnTable({**table.to_dict(), "n": np.zeros(6, dtype=int)})


def test_pandas_gets_every_column(table: ColumnTable) -> None:
    pytest.importorskip("pandas", reason="carom[data] is not installed")
    frame = table.to_pandas()
    assert list(frame.columns) == table.names
    assert frame["x"].to_numpy().tobytes() == AWKWARD.tobytes()


def test_arrow_gets_every_column(table: ColumnTable) -> None:
    pytest.importorskip("pyarrow", reason="carom[data] is not installed")
    arrow = table.to_arrow()
    assert arrow.column_names == table.names
    assert arrow.column("x").to_numpy().tobytes() == AWKWARD.tobytes()
    assert arrow.column("word").null_count == 1


@pytest.mark.parametrize(("method", "module"), [("to_pandas", "pandas"), ("to_arrow", "pyarrow")])
def test_missing_extra_is_one_line(
    table: ColumnTable, monkeypatch: pytest.MonkeyPatch, method: str, module: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(carom.MissingExtraError, match=r"^\w+ is not installed: needs carom\[data\]$"):
        getattr(table, method)()


def test_arrow_tables_of_several_runs_join(run: carom.Run) -> None:
    arrow = pytest.importorskip("pyarrow")
    circle = carom.load("circle").run()
    joined = arrow.concat_tables([run.events.to_arrow(), circle.events.to_arrow(), run.events[:0].to_arrow()])
    assert joined.num_rows == len(run.events) + len(circle.events)


def test_what_is_in_no_cluster_is_absent_elsewhere(run: carom.Run, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    assert set(run.events["cluster"].tolist()) == {-1}
    assert run.events.to_pandas()["cluster"].isna().all()
    assert run.events.to_arrow()["cluster"].null_count == len(run.events)
    run.events.to_csv(tmp_path / "events.csv")
    assert all(line.endswith(",") for line in (tmp_path / "events.csv").read_text().splitlines()[1:])
    struck = carom.load("one_into_two").run().events
    assert struck.to_pandas()["cluster"].tolist() == struck.to_arrow()["cluster"].to_pylist() == [1, 1]


def test_a_table_holds_its_names(run: carom.Run) -> None:
    trajectory = run.trajectory([0.0, 1.0])
    assert "time" in trajectory
    assert "green.x" not in trajectory
    assert list(trajectory)[:2] == ["time", "red.x"]
    assert "time" in run.events
    assert run.events[0] in run.events
