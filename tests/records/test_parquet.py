"""Parquet is for tables: other libraries read a run's frames as one, and events keep their bits."""

from pathlib import Path

import numpy as np
import pytest
from gases import gas

import carom
from carom.errors import RecordError
from carom.records import ParquetWriter, events_to_parquet, frames, read_snapshot

pandas = pytest.importorskip("pandas", reason="carom[data] is not installed")
parquet = pytest.importorskip("pyarrow.parquet", reason="carom[data] is not installed")


def folder(path: Path, count: int) -> Path:
    writer = ParquetWriter(path)
    for frame in range(count):
        writer.write(gas(frame, ids=True))
    return path


def test_pandas_reads_all_frames_as_one_table(tmp_path: Path) -> None:
    table = pandas.read_parquet(folder(tmp_path / "gas.parquet", 3))
    assert table["frame"].tolist() == np.repeat([0, 1, 2], 7).tolist()
    assert table.groupby("frame")["time"].first().tolist() == [gas(frame).time for frame in range(3)]
    last = table[table["frame"] == 2]
    assert last[["x", "y"]].to_numpy().tolist() == gas(2).positions.tolist()
    assert (last["width"] == gas(2).size[0]).all()
    assert last["periodic_x"].all()


def test_one_file_with_these_columns_is_read_too(tmp_path: Path) -> None:
    pandas.read_parquet(folder(tmp_path / "gas.parquet", 3)).to_parquet(tmp_path / "one.parquet")
    assert list(frames(tmp_path / "one.parquet")) == [gas(frame, ids=True) for frame in range(3)]
    with pytest.raises(RecordError, match="is one file, which cannot go on: append=True needs a folder of frames"):
        ParquetWriter(tmp_path / "one.parquet", append=True)
    with pytest.raises(RecordError, match="is one file, and a folder of frames is to be there"):
        ParquetWriter(tmp_path / "one.parquet", overwrite=True).write(gas())


def test_a_folder_keeps_what_is_not_its_frames(tmp_path: Path) -> None:
    path = folder(tmp_path / "gas.parquet", 3)
    (path / "notes.txt").write_text("keep me")
    ParquetWriter(path, overwrite=True).write(gas(9))
    assert sorted(part.name for part in path.iterdir()) == ["frame-000000000.parquet", "notes.txt"]
    assert list(frames(path)) == [gas(9)]


def test_a_frame_that_is_missing_or_cut_is_told(tmp_path: Path) -> None:
    path = folder(tmp_path / "gas.parquet", 3)
    middle = path / "frame-000000001.parquet"
    data = middle.read_bytes()
    for length in (0, 10, len(data) // 2, len(data) - 1):
        middle.write_bytes(data[:length])
        with pytest.raises(RecordError, match=r"frame 1 \(frame-000000001\.parquet\): cannot be read, it is cut short"):
            read_snapshot(path, 1)
        assert read_snapshot(path, 2) == gas(2, ids=True)
    middle.unlink()
    with pytest.raises(RecordError, match="frame 1: is missing, and later ones are there"):
        read_snapshot(path)


def test_other_tables_are_refused_by_their_columns(tmp_path: Path) -> None:
    pandas.DataFrame({"price": [1.0]}).to_parquet(tmp_path / "shop.parquet")
    with pytest.raises(RecordError, match=r"shop\.parquet, frame: there is no such column"):
        read_snapshot(tmp_path / "shop.parquet")
    table = pandas.read_parquet(folder(tmp_path / "gas.parquet", 1))
    table.drop(columns="vx").to_parquet(tmp_path / "still.parquet")
    with pytest.raises(RecordError, match=r"frame 0, vx: there is no such column"):
        read_snapshot(tmp_path / "still.parquet")
    table.loc[3, "time"] = 9.0
    table.to_parquet(tmp_path / "torn.parquet")
    with pytest.raises(RecordError, match="frame 0, time: must be the same for all discs of a frame"):
        read_snapshot(tmp_path / "torn.parquet")
    table.loc[:, "time"] = 9.0
    table.loc[3, "x"] = None
    table.to_parquet(tmp_path / "holes.parquet")
    with pytest.raises(RecordError, match="frame 0, x: must have no empty places"):
        read_snapshot(tmp_path / "holes.parquet")


def test_events_come_back_with_their_bits(run: carom.Run, tmp_path: Path) -> None:
    events_to_parquet(run.events, tmp_path / "events.parquet")
    assert parquet.read_table(tmp_path / "events.parquet").equals(run.events.to_arrow())
    table = pandas.read_parquet(tmp_path / "events.parquet")
    for name in ("time", "x", "normal_x", "impulse"):
        assert table[name].to_numpy().tobytes() == run.events[name].tobytes()
    assert list(table.columns) == run.events.names


def test_a_stream_of_events_becomes_row_groups(run: carom.Run, tmp_path: Path) -> None:
    events_to_parquet((run.events[place : place + 4] for place in range(0, len(run.events), 4)), tmp_path / "e.parquet")
    file = parquet.ParquetFile(tmp_path / "e.parquet")
    assert file.num_row_groups == -(-len(run.events) // 4)
    assert file.read().equals(run.events.to_arrow())


def test_a_stream_that_breaks_leaves_the_older_file(run: carom.Run, tmp_path: Path) -> None:
    path = tmp_path / "events.parquet"
    events_to_parquet(run.events, path)

    def broken() -> object:
        yield run.events
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        events_to_parquet(broken(), path)  # type: ignore[arg-type]
    assert parquet.read_table(path).equals(run.events.to_arrow())
    assert [each.name for each in tmp_path.iterdir()] == ["events.parquet"]
    with pytest.raises(RecordError, match="there is no piece of the stream"):
        events_to_parquet([], path)
    with pytest.raises(RecordError, match=r"must end in \.parquet"):
        events_to_parquet(run.events, tmp_path / "events.csv")
