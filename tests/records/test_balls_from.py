"""`[balls_from]`: a scenario's balls in a file of their own, read when it is loaded."""

import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gases import SUFFIXES, WRITERS

import carom
from carom.errors import MissingExtraError, ScenarioError
from carom.records import Snapshot, content_hash

pytest.importorskip("gsd.hoomd", reason="carom[gas] is not installed")
pytest.importorskip("pyarrow", reason="carom[data] is not installed")
GAS = carom.gas(60, 0.3, seed=5, collisions=200)


def start(**changes: Any) -> Snapshot:
    """The start of a gas."""
    table, balls = GAS.expanded().to_dict()["table"], GAS.balls
    values = {
        "time": 0.0,
        "events": 0,
        "size": (table["width"], table["length"]),
        "periodic": (True, True),
        "positions": [ball.position for ball in balls],
        "velocities": [ball.velocity for ball in balls],
        "radii": [ball.radius for ball in balls],
        "masses": [ball.mass for ball in balls],
    }
    return Snapshot(**values | changes)


def scenario(folder: Path, keys: str, more: str = "collisions = 200") -> Path:
    path = folder / "mine.toml"
    path.write_text(f"{more}\n[balls_from]\n{keys}\n", encoding="utf-8")
    return path


def problems(folder: Path, keys: str, more: str = "collisions = 200") -> list[tuple[str, str]]:
    return carom.Scenario.check(scenario(folder, keys, more))


def foreign(path: Path, **particles: Any) -> Path:
    """A file that HOOMD-blue's own library writes."""
    import gsd.hoomd

    frame, snapshot = gsd.hoomd.Frame(), start()
    frame.configuration.box = [*snapshot.size, 0, 0, 0, 0]
    frame.particles.N = len(snapshot)
    frame.particles.position = np.column_stack([snapshot.positions - snapshot.size / 2, np.zeros(len(snapshot))])
    for name, value in particles.items():
        setattr(frame.configuration if name == "box" else frame.particles, name, value)
    with gsd.hoomd.open(str(path), "w") as file:
        file.append(frame)
    return path


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_carom_wrote_is_the_same_run(tmp_path: Path, suffix: str) -> None:
    WRITERS[suffix](tmp_path / f"start{suffix}").write(start())
    read = carom.load(scenario(tmp_path, f"path = 'start{suffix}'"))
    assert read.balls == GAS.balls
    assert read.to_dict()["table"] == GAS.expanded().to_dict()["table"]
    assert read.run(record="none").digest == GAS.run().digest


def test_the_file_is_named_in_the_record_of_a_run_that_needs_it_no_more(tmp_path: Path) -> None:
    file = tmp_path / "start.gsd"
    WRITERS[".gsd"](file).write(start())
    path = scenario(tmp_path, "path = 'start.gsd'")
    carom.load(path).run(record="none").save(tmp_path / "run.json")
    sha256 = content_hash(file).removeprefix("sha256:")
    file.unlink()
    kept = carom.load_run(tmp_path / "run.json").scenario
    assert kept.to_dict()["balls_source"] == {"path": "start.gsd", "frame": 0, "sha256": sha256, "table": True}
    assert "balls_from" not in kept.to_dict()
    assert kept.run(record="none").digest == GAS.run().digest
    kept.save(tmp_path / "again.toml")
    assert carom.load(tmp_path / "again.toml") == kept == pickle.loads(pickle.dumps(kept))
    assert problems(tmp_path, "path = 'start.gsd'") == [("balls_from.path", f"{file}: no such file")]


def test_a_run_refuses_a_file_that_has_changed(tmp_path: Path) -> None:
    file = tmp_path / "start.xyz"
    WRITERS[".xyz"](file).write(start())
    sha256 = content_hash(file)
    for written in (sha256, sha256.removeprefix("sha256:"), sha256.removeprefix("sha256:").upper()):
        assert problems(tmp_path, f"path = 'start.xyz'\nsha256 = '{written}'") == []
    file.write_text(file.read_text(encoding="utf-8").replace("0.5", "0.4", 1), encoding="utf-8")
    (found,) = problems(tmp_path, f"path = 'start.xyz'\nsha256 = '{sha256}'")
    now = content_hash(file).removeprefix("sha256:")
    assert found == ("balls_from.sha256", f"start.xyz has changed: its SHA-256 is {now}")


def test_frames_are_counted_from_both_ends(tmp_path: Path) -> None:
    writer = WRITERS[".gsd"](tmp_path / "start.gsd")
    for frame in range(3):
        writer.write(start(velocities=np.full((60, 2), float(frame))))
    for keys, frame in (("", 2), ("frame = 1", 1), ("frame = -3", 0)):
        read = carom.load(scenario(tmp_path, f"path = 'start.gsd'\n{keys}"))
        assert read.balls[7].velocity == [frame, frame]
        assert read.value("balls_source.frame") == frame
    for frame in (3, -4):
        (found,) = problems(tmp_path, f"path = 'start.gsd'\nframe = {frame}")
        assert found == ("balls_from.frame", f"there is no frame {frame} in start.gsd; it has frames 0 to 2")


def test_discs_that_went_round_are_put_into_the_box(tmp_path: Path) -> None:
    turns = np.arange(120).reshape(60, 2) % 7 - 3
    size = start().size
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start(positions=start().positions + turns * size, images=turns))
    read = carom.load(scenario(tmp_path, "path = 'start.gsd'"))
    places = np.array([ball.position for ball in read.balls])
    # Three boxes away a position has two bits less.
    assert np.abs(places - start().positions).max() < 4 * np.finfo(float).eps * size.max()


def test_a_table_that_is_given_goes_before_the_box_of_the_file(tmp_path: Path) -> None:
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start())
    table = "collisions = 200\n[table]\nshape = 'rectangle'\nwidth = 14\nlength = 15\nperiodic = ['x', 'y']"
    read = carom.load(scenario(tmp_path, "path = 'start.gsd'", table))
    assert read.to_dict()["table"] == {"shape": "rectangle", "width": 14.0, "length": 15.0, "periodic": ["x", "y"]}
    assert "table" not in read.to_dict()["balls_source"]
    small = table.replace("14", "8")
    assert any(
        "reaches past" in what or "outside the table" in what
        for _, what in problems(tmp_path, "path = 'start.gsd'", small)
    )


def test_a_file_of_hoomds_library_is_read(tmp_path: Path) -> None:
    snapshot = start()
    velocities = np.column_stack([snapshot.velocities, np.zeros(60)])
    foreign(tmp_path / "hoomd.gsd", velocity=velocities, diameter=[0.9] * 60, mass=[2.0] * 60)
    read = carom.load(scenario(tmp_path, "path = 'hoomd.gsd'"))
    ball = read.balls[3]
    assert (ball.radius, ball.mass) == (float(np.float32(0.9)) / 2, 2.0)
    assert np.allclose(ball.position, snapshot.positions[3], atol=1e-6, rtol=0.0)
    assert ball.velocity == snapshot.velocities[3].astype(np.float32).astype(float).tolist()
    assert read.to_dict()["table"]["periodic"] == ["x", "y"]
    assert read.run(record="none").status == "collision_limit"


def test_what_the_file_lacks_is_said_and_nothing_is_guessed(tmp_path: Path) -> None:
    foreign(tmp_path / "hoomd.gsd")
    message = "missing: the file has no radii; GSD means 0.5 when it has none"
    assert problems(tmp_path, "path = 'hoomd.gsd'") == [("balls_from.radius", message)]
    ((place, message),) = problems(tmp_path, "path = 'hoomd.gsd'\nradius = 0.45")
    assert place == "balls_from.temperature"
    assert message.startswith("missing: the file has no velocities")
    path = scenario(tmp_path, "path = 'hoomd.gsd'\nradius = 0.45\nmass = 3\ntemperature = 2\nseed = 4")
    read = carom.load(path)
    balls = read.balls
    velocities = np.array([ball.velocity for ball in balls])
    assert {(ball.radius, ball.mass) for ball in balls} == {(0.45, 3.0)}
    assert np.abs(velocities.sum(axis=0)).max() < 1e-12
    assert 1.5 * (velocities**2).sum() == pytest.approx(2 * 59)
    other = carom.load(scenario(tmp_path, "path = 'hoomd.gsd'\nradius = 0.45\ntemperature = 2\nseed = 5"))
    assert other.balls[0].velocity != balls[0].velocity
    still = carom.load(scenario(tmp_path, "path = 'hoomd.gsd'\nradius = 0.45\ntemperature = 0"))
    assert all(ball.velocity == [0.0, 0.0] for ball in still.balls)


def test_what_the_file_has_is_not_given_again(tmp_path: Path) -> None:
    WRITERS[".xyz"](tmp_path / "start.xyz").write(start())
    found = problems(tmp_path, "path = 'start.xyz'\nradius = 0.4\nmass = 2")
    assert [place for place, _ in found] == ["balls_from.radius", "balls_from.mass"]
    ((place, message),) = problems(tmp_path, "path = 'start.xyz'\ntemperature = 1")
    assert (place, "leave it out" in message) == ("balls_from.temperature", True)


def test_discs_of_single_precision_that_overlap_are_named_with_what_helps(tmp_path: Path) -> None:
    lattice = carom.gas(64, 0.78, start="square", aspect=1.0, collisions=200)
    places = np.array([ball.position for ball in lattice.balls])
    size = np.full(2, lattice.expanded().value("table.width"))
    spacing = size[0] / 8
    shifted = np.column_stack([places - size / 2, np.zeros(64)])
    foreign(tmp_path / "dense.gsd", N=64, box=[*size, 0, 0, 0, 0], position=shifted)
    keys = f"path = 'dense.gsd'\nradius = {spacing / 2}\ntemperature = 1"
    *overlaps, (place, message) = problems(tmp_path, keys)
    assert overlaps
    assert all("overlaps ball" in what for _, what in overlaps)
    assert (place, "0.99999 parts them" in message) == ("balls_from.radius_factor", True)
    read = carom.load(scenario(tmp_path, f"{keys}\nradius_factor = 0.99999"))
    assert read.balls[0].radius == spacing / 2 * 0.99999


def test_discs_that_overlap_are_named(tmp_path: Path) -> None:
    places = np.array(start().positions)
    places[8] = places[3]
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start(positions=places))
    assert ("balls[8].position", 'ball "8" overlaps ball "3" by 1') in problems(tmp_path, "path = 'start.gsd'")


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"position": np.arange(180).reshape(60, 3)}, "z must be the same for all"),
        ({"box": [12, 12, 1, 0.3, 0, 0]}, "but it has the tilt xy = 0.3"),
    ],
)
def test_what_is_no_plane_rectangle_is_refused(tmp_path: Path, changes: dict[str, Any], said: str) -> None:
    foreign(tmp_path / "start.gsd", **changes)
    ((place, message),) = problems(tmp_path, "path = 'start.gsd'\nradius = 0.5\ntemperature = 1")
    assert place == "balls_from.path"
    assert said in message


@pytest.mark.parametrize(
    ("keys", "place", "said"),
    [
        ("path = 'start.pdb'", "balls_from.path", "must end in .gsd"),
        ("path = ''", "balls_from.path", "must not be empty"),
        ("frame = 0", "balls_from.path", "missing: expected text"),
        ("path = 'start.gsd'\nfrmae = 0", "balls_from.frmae", "did you mean frame?"),
        ("path = 'start.gsd'\nradius_factor = 2", "balls_from.radius_factor", "1"),
        ("path = 'torn.gsd'", "balls_from.path", "torn.gsd"),
    ],
)
def test_mistakes_are_named_at_their_places(tmp_path: Path, keys: str, place: str, said: str) -> None:
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start())
    (tmp_path / "torn.gsd").write_bytes((tmp_path / "start.gsd").read_bytes()[:300])
    ((found, message),) = problems(tmp_path, keys)
    assert found == place
    assert said in message


@pytest.mark.parametrize(
    "beside",
    [
        "balls = [{ id = 'a', radius = 0.1, position = [1, 1] }]",
        "gas = { n = 10, packing_fraction = 0.1 }",
        "ball_defaults = { radius = 0.5 }",
    ],
)
def test_balls_come_from_one_place(tmp_path: Path, beside: str) -> None:
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start())
    ((place, message),) = problems(tmp_path, "path = 'start.gsd'", f"collisions = 9\n{beside}")
    assert place == "balls_from"
    assert f"is given beside {beside.split(' = ')[0]}" in message


def test_values_of_a_file_that_was_read_cannot_be_set(tmp_path: Path) -> None:
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start())
    read = carom.load(scenario(tmp_path, "path = 'start.gsd'"))
    with pytest.raises(ScenarioError, match="balls_from"):
        read.with_values({"balls_from": {"path": "start.gsd"}})
    assert read.with_values({"balls[0].velocity[0]": 0.25}).balls[0].velocity[0] == 0.25


def test_what_is_wrong_elsewhere_is_said_too(tmp_path: Path) -> None:
    found = problems(tmp_path, "path = 'gone.gsd'", "duration = -1")
    assert [place for place, _ in found] == ["duration", "balls_from.path"]


def test_paths_in_python_are_relative_to_the_working_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    WRITERS[".xyz"](tmp_path / "start.xyz").write(start())
    monkeypatch.chdir(tmp_path)
    values = {"collisions": 200, "balls_from": {"path": "start.xyz"}}
    assert carom.Scenario.from_dict(values).ball_ids == GAS.ball_ids
    table = carom.Table.rectangle(width=20, length=20, periodic=("x", "y"))
    assert carom.Scenario(table, balls_from=values["balls_from"], collisions=9).value("table.width") == 20


def test_a_missing_package_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start())
    path = scenario(tmp_path, "path = 'start.gsd'")

    def missing(module: str) -> None:
        raise ModuleNotFoundError(name=module)

    monkeypatch.setattr("carom.extras.import_module", missing)
    with pytest.raises(MissingExtraError, match=r"carom\[gas\]"):
        carom.load(path)


def test_a_saved_name_of_a_ball_is_kept(tmp_path: Path) -> None:
    ids = [f"disc {disc}" for disc in range(60)]
    WRITERS[".gsd"](tmp_path / "start.gsd").write(start(ids=ids))
    assert carom.load(scenario(tmp_path, "path = 'start.gsd'")).ball_ids == ids


def test_the_command_line_reads_and_measures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from carom.cli import main

    writer = WRITERS[".gsd"](tmp_path / "start.gsd")
    writer.write(start())
    writer.write(start(velocities=2.0 * start().velocities))
    path = str(scenario(tmp_path, "path = 'start.gsd'", "collisions = 3000"))

    def carom_says(*words: str) -> str:
        monkeypatch.setattr("sys.argv", ["carom", *words])
        with pytest.raises(SystemExit) as ended:
            main()
        assert not ended.value.code
        return capsys.readouterr().out

    assert "no problems" in carom_says("check", path)
    temperatures = []
    for frame in ("0", "1"):
        words = ("gas", path, "--set", f"balls_from.frame={frame}", "--json")
        found = json.loads(carom_says(*words))["observables"]["pressure"]
        temperatures.append(found["quantities"]["temperature"]["value"])
    assert temperatures == pytest.approx([1.0, 4.0])
