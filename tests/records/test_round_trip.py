"""What is written is read back with all its bits, and every frame is whole or not there."""

import errno
import hashlib
import os
import shutil
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from gases import SUFFIXES, WRITERS, gas

from carom.errors import RecordError
from carom.records import GsdWriter, Snapshot, content_hash, frames, read_snapshot, recover

KINDS: list[dict[str, Any]] = [
    {},
    {"images": False},
    {"ids": True},
    {"periodic": (False, False), "images": False},
    {"periodic": (True, False)},
    {"discs": 1, "ids": True},
]
EDGES = [0.0, -0.0, 5e-324, -5e-324, 1.7976931348623157e308, 0.1, 1.0 / 3.0, np.nextafter(1.0, 2.0)]


@pytest.fixture(params=SUFFIXES)
def suffix(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def written(path: Path, snapshots: list[Snapshot], **options: bool) -> list[Snapshot]:
    writer = WRITERS[path.suffix](path, **options)
    for snapshot in snapshots:
        writer.write(snapshot)
    return snapshots


@pytest.mark.parametrize("kind", KINDS, ids=str)
def test_frames_come_back_with_their_bits(tmp_path: Path, suffix: str, kind: dict[str, Any]) -> None:
    path = tmp_path / f"gas{suffix}"
    snapshots = written(path, [gas(frame, **kind) for frame in range(5)])
    assert list(frames(path)) == snapshots
    assert [read_snapshot(path, frame) for frame in (0, 4, -1, -5)] == [snapshots[place] for place in (0, 4, 4, 0)]
    assert read_snapshot(path).single_precision == ()


def test_velocities_at_the_ends_of_what_numbers_can_be_come_back(tmp_path: Path, suffix: str) -> None:
    # HOOMD's float32 holds less, and Carom refuses what it cannot hold.
    edges = [edge for edge in EDGES if suffix != ".gsd" or edge < 1e38]
    count = len(edges)
    snapshot = Snapshot(
        5e-324,
        2**62,
        (0.1, 1.0 / 3.0),
        (True, True),
        np.zeros((count, 2)),
        np.array([edges, edges]).T,
        np.zeros(count),
        np.ones(count),
    )
    written(tmp_path / f"gas{suffix}", [snapshot])
    assert read_snapshot(tmp_path / f"gas{suffix}") == snapshot


def test_radii_that_grow_and_discs_that_vanish_come_back(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"gas{suffix}"
    growing = [gas(0), gas(1), gas(2, 5), gas(3, 7, periodic=(False, True)), gas(4, images=False)]
    grown = Snapshot(1.0, 9, growing[0].size, (True, True), *np.ones((2, 7, 2)), np.full(7, 0.25), np.full(7, 2.0))
    snapshots = written(path, [*growing, grown])
    assert list(frames(path)) == snapshots


def test_appending_goes_on_where_the_file_ends(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"gas{suffix}"
    snapshots = [gas(frame) for frame in range(6)]
    written(path, snapshots[:2], append=True)
    written(path, snapshots[2:], append=True)
    assert list(frames(path)) == snapshots
    assert repr(WRITERS[suffix](path, append=True)) == f"{WRITERS[suffix].__name__}: 6 frames in {path}"


def test_an_older_file_is_refused_unless_its_fate_is_said(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"gas{suffix}"
    written(path, [gas(0), gas(1)])
    with pytest.raises(RecordError, match="is there already: overwrite=True replaces it, append=True goes on"):
        WRITERS[suffix](path)
    with pytest.raises(RecordError, match="either overwrite or append"):
        WRITERS[suffix](path, overwrite=True, append=True)
    WRITERS[suffix](path, overwrite=True)
    assert len(list(frames(path))) == 2, "until the first frame the older file stays"
    written(path, [gas(5)], overwrite=True)
    assert list(frames(path)) == [gas(5)]


def test_another_suffix_is_refused(tmp_path: Path, suffix: str) -> None:
    with pytest.raises(RecordError, match=r"gas\.npz: must end in \.\w+"):
        WRITERS[suffix](tmp_path / "gas.npz")
    with pytest.raises(RecordError, match=r"gas\.npz: must end in \.gsd or \.xyz or \.extxyz or \.parquet"):
        read_snapshot(tmp_path / "gas.npz")


def test_a_missing_folder_is_told(tmp_path: Path, suffix: str) -> None:
    writer = WRITERS[suffix](tmp_path / "missing" / f"gas{suffix}")
    with pytest.raises(RecordError, match=r"frame 0: not written, .*; nothing was changed"):
        writer.write(gas())
    assert list(tmp_path.iterdir()) == []


def test_a_file_or_frame_that_is_not_there_is_told(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"gas{suffix}"
    with pytest.raises(RecordError, match=f"gas{suffix}: no such file"):
        read_snapshot(path)
    written(path, [gas(0)])
    with pytest.raises(RecordError, match="there is no frame 1; it has frame 0 only"):
        read_snapshot(path, 1)
    written(path, [gas(1)], append=True)
    for frame in (2, -3):
        with pytest.raises(RecordError, match=f"there is no frame {frame}; it has frames 0 to 1"):
            read_snapshot(path, frame)


def test_what_something_else_wrote_in_between_is_noticed(tmp_path: Path) -> None:
    for suffix in (".gsd", ".xyz"):
        path = tmp_path / f"gas{suffix}"
        one, other = WRITERS[suffix](path), WRITERS[suffix](path, append=True)
        one.write(gas(0))
        other = WRITERS[suffix](path, append=True)
        other.write(gas(1))
        with pytest.raises(RecordError, match="something else wrote to it"):
            one.write(gas(1))
        assert list(frames(path)) == [gas(0), gas(1)]


def test_a_full_disk_is_told_and_costs_no_frame(tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / f"gas{suffix}"
    snapshots = written(path, [gas(0), gas(1)])
    before = content_hash(path)
    writer = WRITERS[suffix](path, append=True)

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        patch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=10_000))  # GSD asks beforehand
        patch.setattr(Path, "replace", full)
        patch.setattr(os, "fsync", full)
        with pytest.raises(RecordError) as caught:
            writer.write(gas(2))
    assert str(caught.value) == f"{path}, frame 2: not written, the disk is full; the 2 before it are whole and stay"
    assert content_hash(path) == before
    writer.write(gas(2))
    assert list(frames(path)) == [*snapshots, gas(2)]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no limit on the size of files")
@pytest.mark.parametrize("suffix", [".gsd", ".xyz"])
def test_a_file_that_may_not_grow_is_as_it_was(tmp_path: Path, suffix: str) -> None:
    """The index of a GSD file must grow at frames 7 and 14 here, and gsd writes over its beginning when it cannot."""
    import resource

    path = tmp_path / f"gas{suffix}"
    writer, snapshots = WRITERS[suffix](path), [gas(frame, 3) for frame in range(20)]
    writer.write(snapshots[0])
    unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
    for snapshot in snapshots[1:]:
        before = path.read_bytes()
        for room in (0, 50, 500, 5000):
            resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) + room, unlimited[1]))
            try:
                writer.write(snapshot)
                break
            except RecordError:
                assert path.read_bytes() == before
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
        else:
            writer.write(snapshot)
    assert list(frames(path)) == snapshots


def test_ctrl_c_within_a_frame_costs_no_other(tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / f"gas{suffix}"
    snapshots = written(path, [gas(0), gas(1)])
    writer, before = WRITERS[suffix](path, append=True), content_hash(path)

    def pressed(*_: object) -> None:
        raise KeyboardInterrupt

    def pressed_between_chunks(_: object, file: Any, chunks: dict[str, Any]) -> None:
        file.write_chunk("particles/position", chunks["particles/position"])
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(GsdWriter, "_write", pressed_between_chunks)
        patch.setattr(Path, "replace", pressed)
        patch.setattr(os, "fsync", pressed if suffix == ".xyz" else os.fsync)
        with pytest.raises(KeyboardInterrupt):
            writer.write(gas(2))
    assert content_hash(path) == before
    writer.write(gas(2))
    assert list(frames(path)) == [*snapshots, gas(2)]


def test_the_hash_of_a_file_is_that_of_its_bytes(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"gas{suffix}"
    written(path, [gas(0)])
    first = content_hash(path)
    if path.is_file():
        assert first == "sha256:" + hashlib.sha256(path.read_bytes()).hexdigest()
    written(path, [gas(0)], overwrite=True)
    assert content_hash(path) == first, "the same frames give the same file"
    written(path, [gas(1)], append=True)
    assert content_hash(path) != first
    with pytest.raises(RecordError, match="no such file"):
        content_hash(tmp_path / "missing.gsd")


def test_only_what_can_be_cut_is_recovered(tmp_path: Path) -> None:
    written(tmp_path / "gas.xyz", [gas(0)])
    for to, problem in (("gas.xyz", "is there already"), ("gas.gsd", r"must end in \.xyz or \.extxyz")):
        with pytest.raises(RecordError, match=problem):
            recover(tmp_path / "gas.xyz", tmp_path / to)
    with pytest.raises(RecordError, match=r"must end in \.gsd or"):
        recover(tmp_path / "gas.parquet", tmp_path / "saved.parquet")
    with pytest.raises(RecordError, match="no such file"):
        recover(tmp_path / "missing.xyz", tmp_path / "saved.xyz")
