"""Extended XYZ is what OVITO and ASE read and write; what is not clear in it is refused."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gases import FILES, gas

from carom.errors import RecordError
from carom.records import ExtendedXyzWriter, Snapshot, frames, read_snapshot, recover

PLAIN = """\
2
Lattice="4 0 0 0 3 0 0 0 1" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1 pbc="T F F" Time=1.5 Events=7
A 0.5 1 0 1 2 0 0.25 2
B 1.5 1 0 -1 2 0 0.5 1
"""


def text(path: Path, *changes: tuple[str, str]) -> Path:
    content = PLAIN
    for old, new in changes:
        assert old in content, old
        content = content.replace(old, new)
    path.write_text(content, encoding="utf-8")
    return path


def test_a_file_holds_what_readers_look_for(tmp_path: Path) -> None:
    snapshot = Snapshot(1.5, 7, (4, 3), (True, False), [[-7.5, 1]], [[1, 0.1]], [0.25], [2], [[-2, 0]], ["d0"])
    ExtendedXyzWriter(tmp_path / "gas.extxyz").write(snapshot)
    assert (tmp_path / "gas.extxyz").read_text(encoding="utf-8") == (
        "1\n"
        'Lattice="4 0 0 0 3 0 0 0 1" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1'
        ':unwrapped:R:2:map_shift:I:3:id:S:1 pbc="T F F" Time=1.5 Events=7\n'
        "X 0.5 1 0 1 0.10000000000000001 0 0.25 2 -7.5 1 -2 0 0 d0\n"
    )


def test_a_plain_file_is_read(tmp_path: Path) -> None:
    wanted = Snapshot(1.5, 7, (4, 3), (True, False), [[0.5, 1], [1.5, 1]], [[1, 2], [-1, 2]], [0.25, 0.5], [2, 1])
    assert read_snapshot(text(tmp_path / "gas.xyz")) == wanted


def test_ases_files_are_read() -> None:
    one, two = frames(FILES / "ase.extxyz")
    assert (one.time, two.time, one.periodic.tolist()) == (0.0, 0.5, [True, True])
    assert two.positions.tolist() == [[0.5, 0.25], [2.5, 1.0], [3.0, 2.5]]
    assert (two.radii.tolist(), two.masses.tolist()) == ([0.5, 0.5, 0.25], [2.0, 2.0, 4.0])
    assert two.velocities.tolist() == [[0.5, 1.0], [1.0, 1.5], [-1.0, 0.125]], "momenta over masses"


def test_ovitos_files_are_read() -> None:
    """OVITO wrote what it had read of the GSD file of these frames, in float32 and with ten digits."""
    for frame, read in enumerate(frames(FILES / "ovito.xyz")):
        snapshot = gas(frame, 3)
        assert np.array_equal(read.images, snapshot.images)
        assert np.allclose(read.positions, snapshot.positions, rtol=0, atol=4 * 2.0**-24 * snapshot.size.max() * 3)
        assert np.allclose(read.velocities, snapshot.velocities, rtol=2.0**-24, atol=1e-10)
        assert np.allclose(read.masses, snapshot.masses, rtol=2.0**-24)
        assert read.time == float(frame), "the file has no time, so the frames count"


def test_frames_without_a_time_count(tmp_path: Path) -> None:
    path = text(tmp_path / "gas.xyz", (" Time=1.5 Events=7", ""))
    path.write_text(path.read_text() * 3)
    assert [snapshot.time for snapshot in frames(path, time_step=0.25)] == [0.0, 0.25, 0.5]
    assert read_snapshot(path).events == 0


def test_what_a_file_lacks_must_be_given(tmp_path: Path) -> None:
    bare = tmp_path / "bare.xyz"
    bare.write_text('1\nLattice="4 0 0 0 3 0 0 0 1" Properties=species:S:1:pos:R:3\nA 1 2 0\n')
    for given, problem in (
        ({}, "masses: the file has no column mass or masses: give mass=... to take one for all"),
        ({"mass": 1}, "velocities: the file has no column velo or vel or velocity or velocities: give velocity=..."),
        ({"mass": 1, "velocity": 0}, "radii: the file has no column radius or radii: give radius=..."),
    ):
        with pytest.raises(RecordError) as caught:
            read_snapshot(bare, **given)
        assert f"{bare}, frame 0, {problem}" in str(caught.value)
    snapshot = read_snapshot(bare, radius=0.5, mass=1, velocity=0)
    assert snapshot == Snapshot(0.0, 0, (4, 3), (True, True), [[1, 2]], [[0, 0]], [0.5], [1])


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        (
            '"4 0 0 0 3 0 0 0 1"',
            '"4 0 0 0.5 3 0 0 0 1"',
            "frame 0, box: must be a rectangle, but it has the tilt b_x = 0.5",
        ),
        ('"4 0 0 0 3 0 0 0 1"', '"4 0 0 0 3 0"', "frame 0, Lattice: must be 9 numbers, got '4 0 0 0 3 0'"),
        ('Lattice="4 0 0 0 3 0 0 0 1" ', "", "frame 0, Lattice: must be 9 numbers, got none"),
        ('"4 0 0 0 3 0 0 0 1"', '"-4 0 0 0 3 0 0 0 1"', "frame 0, size[0]: must be positive and finite, got -4.0"),
        ('"T F F"', '"T F"', "frame 0, pbc: must be three of T and F, got 'T F'"),
        ("Time=1.5", "Time=late", "frame 0, Time: must be a number, got 'late'"),
        ("Events=7", "Events=7.5", "frame 0, Events: must be a whole number, got '7.5'"),
        ("Properties=", "Columns=", "frame 0, comment line: must have Properties=..., as extended XYZ has it"),
        ("mass:R:1", "mass:R", "frame 0, Properties: must be name:kind:columns and so on"),
        ("pos:R:3", "place:R:3", "frame 0, Properties: must have pos"),
        ("radius:R:1", "pos:R:1", "frame 0, Properties: names pos twice"),
        ("pos:R:3:velo:R:3", "pos:R:4:velo:R:2", "frame 0, Properties: pos must have 2 or 3 columns, got 4"),
        (
            "1.5 1 0 -1",
            "1.5 1 0.5 -1",
            "frame 0, positions[1, 2]: z must be the same for all, as discs lie in one plane",
        ),
        ("-1 2 0", "-1 2 3", "frame 0, velocities[1, 2]: z must be zero, got 3"),
        ("1.5 1 0 -1", "1.5 nan 0 -1", "frame 0, positions[1, 1]: must be finite, got nan"),
        ("1.5 1 0 -1", "1.5 north 0 -1", "frame 0, rows: could not convert string 'north' to float64"),
        (
            "B 1.5 1 0 -1 2 0 0.5 1",
            "B 1.5 1 0 -1 2 0 0.5",
            "frame 0, rows: invalid column index 8 at row 2 with 8 columns",
        ),
        ("B 1.5 1 0 -1 2 0 0.5 1", "", "frame 0, rows: must be 2, got 1 and empty lines"),
        ("2\n", "two\n", "frame 0: must begin with its number of discs, got 'two'"),
        ("2\n", "-2\n", "frame 0: must begin with its number of discs, got '-2'"),
        ("2\n", "1\n", "frame 1: must begin with its number of discs, got 'B 1.5 1 0 -1 2 0 0.5 1'"),
    ],
)
def test_what_is_no_gas_of_discs_is_refused_by_file_frame_and_field(
    tmp_path: Path, old: str, new: str, problem: str
) -> None:
    path = text(tmp_path / "gas.xyz", (old, new))
    with pytest.raises(RecordError) as caught:
        read_snapshot(path)
    assert str(caught.value).startswith(f"{path}, {problem}")


def test_images_that_are_no_whole_numbers_are_refused(tmp_path: Path) -> None:
    path = text(
        tmp_path / "gas.xyz",
        ("mass:R:1", "mass:R:1:map_shift:I:3"),
        ("0.25 2\n", "0.25 2 1 0 0\n"),
        ("0.5 1\n", "0.5 1 0 0.5 0\n"),
    )
    with pytest.raises(RecordError, match=r"frame 0, images\[1, 1\]: must be a whole number of 32 bits, got 0.5"):
        read_snapshot(path)


def test_ids_with_blanks_have_no_place_in_this_format(tmp_path: Path) -> None:
    snapshot = Snapshot(0.0, 0, (4, 3), (True, True), [[1, 1]], [[0, 0]], [0.5], [1], ids=["a b"])
    with pytest.raises(RecordError, match=r"frame 0, ids\[0\]: must have no blanks in this format, got 'a b'"):
        ExtendedXyzWriter(tmp_path / "gas.xyz").write(snapshot)
    assert not list(tmp_path.iterdir())


def test_a_last_frame_cut_anywhere_is_told_apart(tmp_path: Path) -> None:
    whole, cut, saved = tmp_path / "whole.xyz", tmp_path / "cut.xyz", tmp_path / "saved.xyz"
    writer, snapshots = ExtendedXyzWriter(whole), [gas(frame, 3) for frame in range(3)]
    for snapshot in snapshots[:2]:
        writer.write(snapshot)
    start = whole.stat().st_size
    writer.write(snapshots[2])
    data = whole.read_bytes()
    for length in range(start + 1, len(data)):
        cut.write_bytes(data[:length])
        with pytest.raises(
            RecordError, match=r"cut\.xyz, frame 2: is cut short.*the 2 frames before are whole, and recover\("
        ):
            read_snapshot(cut)
        got = []
        with pytest.raises(RecordError, match="frame 2: is cut short"):
            got.extend(frames(cut))
        with pytest.raises(RecordError, match="frame 2: is cut short"):
            ExtendedXyzWriter(cut, append=True)
    stream = frames(cut)
    assert [next(stream), next(stream)] == snapshots[:2], "the whole frames come first"
    assert recover(cut, saved) == 2
    assert saved.read_bytes() == data[:start]
    cut.write_bytes(data[: start // 3])
    with pytest.raises(RecordError, match="has no whole frame"):
        recover(cut, tmp_path / "none.xyz")


def test_empty_lines_at_the_end_are_no_frame(tmp_path: Path) -> None:
    path = text(tmp_path / "gas.xyz")
    path.write_text(path.read_text() + "\n \n")
    assert len(list(frames(path))) == 1


@pytest.mark.parametrize("options", [{}, {"periodic": (True, False), "images": False, "ids": True}])
def test_ase_reads_what_is_written(tmp_path: Path, options: dict[str, Any]) -> None:
    ase = pytest.importorskip("ase.io", reason="ASE is not installed")
    snapshot = gas(1, **options)
    ExtendedXyzWriter(tmp_path / "gas.xyz").write(snapshot)
    atoms = ase.read(tmp_path / "gas.xyz", format="extxyz")
    assert atoms.cell.lengths().tolist() == [*snapshot.size.tolist(), 1.0]
    assert np.array_equal(atoms.arrays["unwrapped"], snapshot.positions)
    assert np.array_equal(atoms.arrays["velo"][:, :2], snapshot.velocities)
    assert atoms.info["Time"] == snapshot.time


def test_ovito_reads_what_is_written(tmp_path: Path) -> None:
    ovito = pytest.importorskip("ovito.io", reason="OVITO is not installed")
    snapshot = gas(1)
    ExtendedXyzWriter(tmp_path / "gas.xyz").write(snapshot)
    data = ovito.import_file(str(tmp_path / "gas.xyz")).compute(0)
    assert np.array_equal(data.particles["Periodic Image"][:, :2], snapshot.images)
    assert np.array_equal(data.particles["Mass"], snapshot.masses)
    # OVITO reads texts to the last bit but one.
    assert np.allclose(data.particles["Velocity"][:, :2], snapshot.velocities, rtol=2.0**-51, atol=0)
    assert np.allclose(data.particles["unwrapped"], snapshot.positions, rtol=2.0**-51, atol=0)
