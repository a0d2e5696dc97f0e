"""GSD files are HOOMD-blue's: its own library reads what Carom writes, and Carom reads what it writes."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gases import gas

from carom.errors import RecordError
from carom.records import GsdWriter, Snapshot, frames, read_snapshot, recover

hoomd = pytest.importorskip("gsd.hoomd", reason="carom[gas] is not installed")
fl = pytest.importorskip("gsd.fl")


def written(path: Path, count: int, **options: Any) -> list[Snapshot]:
    writer, snapshots = GsdWriter(path), [gas(frame, **options) for frame in range(count)]
    for snapshot in snapshots:
        writer.write(snapshot)
    return snapshots


def foreign(path: Path, **changes: Any) -> Path:
    """A file as HOOMD-blue has it, with changes of ``<part>_<field>``."""
    frame = hoomd.Frame()
    frame.configuration.step = 40
    frame.configuration.box = [4, 3, 0, 0, 0, 0]
    frame.particles.N = 3
    frame.particles.position = np.array([[-2, -1.5, 0], [0.25, 0.5, 0], [1.9, 1.4, 0]], dtype=np.float32)
    for name, value in changes.items():
        part, _, field = name.partition("_")
        setattr(getattr(frame, part), field, value)
    with hoomd.open(str(path), "w") as file:
        file.append(frame)
    return path


def test_hoomds_library_finds_its_schema(tmp_path: Path) -> None:
    (one, two) = written(tmp_path / "gas.gsd", 2, ids=True)
    with hoomd.open(str(tmp_path / "gas.gsd"), "r") as file:
        assert file.file.application.startswith("Carom ")
        frame = file[1]
    assert (frame.configuration.step, frame.configuration.dimensions) == (1000, 2)
    assert frame.configuration.box.tolist() == [*two.size.astype(np.float32).tolist(), 0, 0, 0, 0]
    assert (frame.particles.N, frame.particles.types) == (7, ["A", "B"])
    assert frame.particles.typeid.tolist() == [0, 1, 0, 1, 0, 1, 0]
    assert frame.particles.diameter.tolist() == (2 * two.radii).astype(np.float32).tolist()
    assert frame.particles.mass.tolist() == two.masses.astype(np.float32).tolist()
    assert frame.particles.velocity[:, :2].tolist() == two.velocities.astype(np.float32).tolist()
    half = frame.configuration.box[:2] / 2
    places = frame.particles.position[:, :2]
    assert (places >= -half).all()
    assert (places < half).all()
    # Float32 rounds places within the box by half a unit of its last place, and the box's size too, times the images.
    allowed = 2.0**-24 * two.size * (np.abs(frame.particles.image[:, :2]) + 2)
    back = places.astype(float) + half + frame.particles.image[:, :2] * frame.configuration.box[:2].astype(float)
    assert (np.abs(back - two.positions) <= allowed).all()
    assert not frame.particles.position[:, 2].any()
    assert frame.log["carom/time"].tolist() == [two.time]
    assert frame.log["particles/carom/position"].tolist() == two.positions.tolist()
    assert one != two


def test_what_does_not_change_is_written_once(tmp_path: Path) -> None:
    written(tmp_path / "gas.gsd", 2, discs=1000)
    with fl.open(str(tmp_path / "gas.gsd"), "r") as file:
        there = {
            name: [file.chunk_exists(frame, name) for frame in (0, 1)] for name in file.find_matching_chunk_names("")
        }
    assert (
        there["particles/diameter"] == there["log/particles/carom/radius"] == there["particles/typeid"] == [True, False]
    )
    assert there["particles/position"] == there["log/particles/carom/position"] == [True, True]


def test_discs_on_the_boxs_edge_are_within_it_for_hoomd(tmp_path: Path) -> None:
    size = np.array([3.3, 0.1])
    edges = np.array([-1e-30, 0.0, 1e-30, 0.5, np.nextafter(1.0, 0.0), 1.0, np.nextafter(1.0, 2.0), 3.0, -7.0])
    positions = np.stack(np.meshgrid(edges, edges), axis=-1).reshape(-1, 2) * size
    count = len(positions)
    snapshot = Snapshot(0.0, 0, size, (True, True), positions, np.zeros((count, 2)), np.ones(count), np.ones(count))
    GsdWriter(tmp_path / "gas.gsd").write(snapshot)
    with hoomd.open(str(tmp_path / "gas.gsd"), "r") as file:
        places, box = file[0].particles.position[:, :2], file[0].configuration.box[:2]
    assert (places >= -box / 2).all()
    assert (places < box / 2).all()
    assert read_snapshot(tmp_path / "gas.gsd") == snapshot


def test_a_disc_beyond_a_wall_is_refused_and_one_beyond_by_round_off_is_not(tmp_path: Path) -> None:
    good = gas(periodic=(False, False), images=False)
    positions = good.positions.copy()
    positions[3, 0] = good.size[0] * (1.0 + 1e-15)
    pair = (good.time, good.events, good.size, good.periodic)
    rest = (good.velocities, good.radii, good.masses)
    writer = GsdWriter(tmp_path / "gas.gsd")
    writer.write(Snapshot(*pair, positions, *rest))
    positions[3, 0] = good.size[0] + 0.1
    with pytest.raises(RecordError, match=r"gas\.gsd, frame 1, positions\[3\]: is beyond a wall of the box"):
        writer.write(Snapshot(*pair, positions, *rest))


def test_many_species_are_a_distribution_of_one_type(tmp_path: Path) -> None:
    radii = np.linspace(0.4, 0.6, 27)
    for count, types in ((26, 26), (27, 1)):
        snapshot = Snapshot(
            0.0, 0, (50, 50), (True, True), np.zeros((count, 2)), np.zeros((count, 2)), radii[:count], np.ones(count)
        )
        GsdWriter(tmp_path / "gas.gsd", overwrite=True).write(snapshot)
        with hoomd.open(str(tmp_path / "gas.gsd"), "r") as file:
            assert len(file[0].particles.types) == types
        assert read_snapshot(tmp_path / "gas.gsd") == snapshot


def test_what_float32_cannot_hold_is_refused(tmp_path: Path) -> None:
    fast = Snapshot(0.0, 0, (4, 3), (True, True), [[1, 1]], [[1e39, 0]], [0.5], [1])
    with pytest.raises(RecordError, match=r"frame 0, velocities: must be below 3\.4e38"):
        GsdWriter(tmp_path / "gas.gsd").write(fast)
    assert not list(tmp_path.iterdir())


def test_ids_must_stay(tmp_path: Path) -> None:
    writer = GsdWriter(tmp_path / "gas.gsd")
    writer.write(gas(0, ids=True))
    with pytest.raises(RecordError, match="frame 1, ids: must be there, as the first frame has them"):
        writer.write(gas(1))


def test_hoomds_files_are_read_with_the_schemas_defaults(tmp_path: Path) -> None:
    snapshot = read_snapshot(foreign(tmp_path / "h.gsd"))
    assert (snapshot.time, snapshot.events, snapshot.periodic.tolist()) == (40.0, 0, [True, True])
    assert snapshot.positions.tolist() == [
        [0, 0],
        [2.25, 2],
        [float(np.float32(1.9)) + 2, float(np.float32(1.4)) + 1.5],
    ]
    assert (snapshot.radii.tolist(), snapshot.masses.tolist()) == ([0.5] * 3, [1.0] * 3)
    assert not snapshot.velocities.any()
    assert snapshot.images is None
    assert snapshot.single_precision == ("size", "positions")


def test_what_a_file_lacks_can_be_given(tmp_path: Path) -> None:
    snapshot = read_snapshot(foreign(tmp_path / "h.gsd"), radius=0.25, mass=2.0, velocity=1.5, time_step=0.005)
    assert (snapshot.time, snapshot.radii.tolist(), snapshot.masses.tolist()) == (0.2, [0.25] * 3, [2.0] * 3)
    assert snapshot.velocities.tolist() == [[1.5, 1.5]] * 3


def test_wrapped_positions_and_images_are_joined_and_float32_is_said(tmp_path: Path) -> None:
    changes: dict[str, Any] = {
        "particles_image": [[1, 0, 0], [0, -2, 0], [0, 0, 0]],
        "particles_velocity": np.array([[1, 2, 0], [0.1, 0, 0], [0, 0, 0]]),
        "particles_diameter": [0.2, 0.2, 0.4],
        "particles_mass": [1, 1, 4],
    }
    snapshot = read_snapshot(foreign(tmp_path / "h.gsd", **changes))
    assert snapshot.positions[:2].tolist() == [[4, 0], [2.25, -4]]
    assert snapshot.images is not None
    assert snapshot.images.tolist() == [[1, 0], [0, -2], [0, 0]]
    assert snapshot.velocities[1, 0] == np.float32(0.1)
    assert snapshot.single_precision == ("size", "positions", "velocities", "radii", "masses")


def test_later_frames_take_from_the_first_what_they_lack(tmp_path: Path) -> None:
    path = foreign(tmp_path / "h.gsd", particles_mass=[1, 1, 4], particles_image=[[1, 0, 0], [0, 0, 0], [0, 0, 0]])
    later, fewer = hoomd.Frame(), hoomd.Frame()
    later.configuration.step, later.particles.N = 50, 3
    later.particles.position = np.zeros((3, 3), dtype=np.float32)
    fewer.configuration.step, fewer.particles.N = 60, 2
    with hoomd.open(str(path), "r+") as file:
        file.extend([later, fewer])
    _, second, third = frames(path)
    assert (second.time, second.masses.tolist(), second.positions.tolist()) == (
        50.0,
        [1, 1, 4],
        [[6, 1.5], [2, 1.5], [2, 1.5]],
    )
    assert (third.time, third.masses.tolist(), third.positions.tolist()) == (60.0, [1, 1], [[2, 1.5], [2, 1.5]])


def test_a_layer_of_a_box_with_three_dimensions_is_flat(tmp_path: Path) -> None:
    layer = np.array([[0, 0, 0.5], [1, 0, 0.5], [1, 1, 0.5]], dtype=np.float32)
    path = foreign(tmp_path / "h.gsd", configuration_box=[4, 3, 2, 0, 0, 0], particles_position=layer)
    assert read_snapshot(path).positions.tolist() == [[2, 1.5], [3, 1.5], [3, 2.5]]


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"configuration_box": [4, 3, 0, 0.1, 0, 0]}, "box: must be a rectangle, but it has the tilt xy = 0.1"),
        ({"configuration_box": [4, 3, 1, 0, 0, 0.5]}, "box: must be a rectangle, but it has the tilt yz = 0.5"),
        (
            {"particles_position": [[0, 0, 0], [1, 1, 0.25], [0, 0, 0]]},
            "positions[1, 2]: z must be the same for all, as discs lie in one plane, got 0.25",
        ),
        ({"particles_velocity": [[0, 0, 0], [0, 0, 0], [0, 0, 2]]}, "velocities[2, 2]: z must be zero, got 2"),
        ({"particles_image": [[0, 0, 0], [0, 0, 1], [0, 0, 0]]}, "images[1, 2]: z must be the same for all"),
        ({"particles_mass": [1, 0, 1]}, "masses[1]: must be positive and finite, got 0.0"),
        ({"particles_position": [[0, 0, 0], [np.nan, 1, 0], [0, 0, 0]]}, "positions[1, 0]: must be finite, got nan"),
        ({"particles_N": 0, "particles_position": np.zeros((0, 3))}, "positions: must hold at least one disc"),
    ],
)
def test_what_is_no_gas_of_discs_is_refused_by_file_frame_and_field(
    tmp_path: Path, changes: dict[str, Any], problem: str
) -> None:
    path = foreign(tmp_path / "h.gsd", **changes)
    with pytest.raises(RecordError) as caught:
        read_snapshot(path)
    assert str(caught.value).startswith(f"{path}, frame 0, {problem}")


def test_other_files_are_refused(tmp_path: Path) -> None:
    (tmp_path / "text.gsd").write_text("no gsd file\n" * 100)
    with pytest.raises(RecordError, match=r"text\.gsd: Not a GSD file$"):
        read_snapshot(tmp_path / "text.gsd")
    with fl.open(str(tmp_path / "other.gsd"), "w", "other", "weather", (1, 0)):
        pass
    with pytest.raises(RecordError, match=r"is of the schema 'weather', and must be of 'hoomd'"):
        read_snapshot(tmp_path / "other.gsd")
    with fl.open(str(tmp_path / "empty.gsd"), "w", "other", "hoomd", (1, 4)):
        pass
    with pytest.raises(RecordError, match="there is no frame -1; it has none"):
        read_snapshot(tmp_path / "empty.gsd")


def test_a_file_cut_anywhere_gives_up_its_whole_frames(tmp_path: Path) -> None:
    """The index grows twice; cuts are 211 bytes apart, a step that meets each block at another place."""
    whole, cut = tmp_path / "whole.gsd", tmp_path / "cut.gsd"
    writer, snapshots, ends = GsdWriter(whole), [gas(frame, 3) for frame in range(30)], []
    for snapshot in snapshots:
        writer.write(snapshot)
        ends.append(whole.stat().st_size)
    data, met = whole.read_bytes(), set()
    for length in range(0, len(data), 211):
        cut.write_bytes(data[:length])
        saved = tmp_path / f"saved{length}.gsd"
        complete = sum(end <= length for end in ends)
        with pytest.raises(
            RecordError, match=r"cut\.gsd: (is cut short or damaged: recover\('.*cut\.gsd', to\)|Not a GSD)"
        ):
            read_snapshot(cut)
        if complete == 0:
            with pytest.raises(RecordError, match="nothing to recover"):
                recover(cut, saved)
            continue
        kept = recover(cut, saved)
        # A frame that made the index longer is whole before the empty rest of the index is there.
        assert complete <= kept <= complete + 1
        met.add(kept - complete)
        assert list(frames(saved)) == snapshots[:kept]
        GsdWriter(saved, append=True).write(snapshots[-1])
        assert read_snapshot(saved) == snapshots[-1]
        assert read_snapshot(saved, kept - 1) == snapshots[kept - 1]
    assert met == {0, 1}


def test_a_frame_whose_entries_are_not_all_there_is_told(tmp_path: Path) -> None:
    path = tmp_path / "gas.gsd"
    snapshots = written(path, 2, discs=3)
    # As a power cut may leave it: the last entry of the last frame, of 32 bytes, is not there yet.
    data = bytearray(path.read_bytes())
    index = np.frombuffer(
        data, np.dtype([("frame", "<u8"), ("rows", "<u8"), ("place", "<u8"), ("rest", "<u8")]), 128, 256
    )
    last = int(np.flatnonzero(index["place"])[-1])
    data[256 + 32 * last : 256 + 32 * (last + 1)] = bytes(32)
    path.write_bytes(data)
    with pytest.raises(RecordError, match=r"gas\.gsd, frame 1: part of it is missing"):
        read_snapshot(path)
    with pytest.raises(RecordError, match="frame 1: part of it is missing"):
        GsdWriter(path, append=True)
    assert read_snapshot(path, 0) == snapshots[0]
    assert recover(path, tmp_path / "saved.gsd") == 1
    assert list(frames(tmp_path / "saved.gsd")) == snapshots[:1]


def test_a_cut_file_of_hoomds_is_recovered_but_for_its_last_frame(tmp_path: Path) -> None:
    path = foreign(tmp_path / "h.gsd")
    for step in (50, 60):
        frame = hoomd.Frame()
        frame.configuration.step, frame.particles.N = step, 3
        frame.particles.position = np.full((3, 3), step / 100, dtype=np.float32) * [1, 1, 0]
        with hoomd.open(str(path), "r+") as file:
            file.append(frame)
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(RecordError, match="is cut short or damaged"):
        read_snapshot(path)
    assert recover(path, tmp_path / "saved.gsd") == 2
    assert [snapshot.time for snapshot in frames(tmp_path / "saved.gsd")] == [40.0, 50.0]


def test_ovito_shows_the_gas(tmp_path: Path) -> None:
    ovito = pytest.importorskip("ovito.io", reason="OVITO is not installed")
    (_, two) = written(tmp_path / "gas.gsd", 2)
    data = ovito.import_file(str(tmp_path / "gas.gsd")).compute(1)
    assert data.cell.is2D
    assert data.attributes["carom/time"] == two.time
    assert np.array_equal(data.particles["carom_position"], two.positions)
    assert np.array_equal(data.particles["Radius"], two.radii.astype(np.float32))
    assert data.particles["Periodic Image"].shape == (7, 3)
