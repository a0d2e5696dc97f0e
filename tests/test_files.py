"""Files appear whole or not at all, and only where they were asked for."""

import os
from pathlib import Path

import pytest

import carom
from carom.files import replacing, write_text


def _tree(folder: Path) -> set[Path]:
    return {path.relative_to(folder) for path in folder.rglob("*")}


def _fail_half_way(path: Path) -> None:
    with replacing(path) as temporary:
        temporary.write_text("half", encoding="utf-8")
        raise KeyboardInterrupt


def test_interrupted_write_leaves_no_file(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        _fail_half_way(tmp_path / "a.txt")
    assert _tree(tmp_path) == set()


def test_interrupted_write_keeps_the_older_file(tmp_path: Path) -> None:
    write_text(tmp_path / "a.txt", "older")
    with pytest.raises(KeyboardInterrupt):
        _fail_half_way(tmp_path / "a.txt")
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == "older"
    assert _tree(tmp_path) == {Path("a.txt")}


def test_temporary_name_keeps_the_suffix_and_stays_in_the_folder(tmp_path: Path) -> None:
    with replacing(tmp_path / "film.gif") as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".gif"
        temporary.write_bytes(b"")


def test_text_has_the_same_line_ends_everywhere(tmp_path: Path) -> None:
    write_text(tmp_path / "a.txt", "one\ntwo\n")
    assert (tmp_path / "a.txt").read_bytes() == b"one\ntwo\n"


def test_missing_folder_is_not_made(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        write_text(tmp_path / "missing" / "a.txt", "text")
    assert _tree(tmp_path) == set()


def test_errors_speak_of_the_file_asked_for(tmp_path: Path, run: carom.Run) -> None:
    missing = tmp_path / "missing"
    for write in (lambda: run.save(missing / "a.json"), lambda: run.animate(missing / "a.gif", fps=1, size=40)):
        with pytest.raises(FileNotFoundError, match=f"the folder {missing} does not exist: .*missing.a.") as caught:
            write()
        assert caught.value.filename in (str(missing / "a.json"), str(missing / "a.gif"))
    with pytest.raises(OSError) as too_long:
        write_text(tmp_path / ("a" * 300), "text")
    assert too_long.value.filename == str(tmp_path / ("a" * 300))
    write_text(tmp_path / ("a" * 250), "text")


def test_what_is_no_file_is_not_replaced(tmp_path: Path) -> None:
    with pytest.raises(IsADirectoryError):
        write_text(tmp_path, "text")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no named pipes in folders")
def test_a_pipe_or_a_device_is_not_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(OSError, match="not a file"):
        write_text(tmp_path / "pipe", "text")
    assert (tmp_path / "pipe").is_fifo()


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "a.txt").symlink_to(tmp_path / "other" / "a.txt")
    write_text(tmp_path / "a.txt", "text")
    assert (tmp_path / "a.txt").is_symlink()
    assert (tmp_path / "other" / "a.txt").read_text(encoding="utf-8") == "text"


def test_everything_that_is_saved_stays_in_the_folder_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, run: carom.Run
) -> None:
    for name in ("work", "home", "named"):
        (tmp_path / name).mkdir()
    monkeypatch.chdir(tmp_path / "work")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    named = tmp_path / "named"
    run.save(named / "run.json")
    run.scenario.save(named / "scenario.toml")
    run.scenario.save(named / "scenario.json")
    run.events.to_csv(named / "events.csv")
    run.trajectory([0.0, 1.0]).to_csv(named / "trajectory.csv")
    files = {"run.json", "scenario.toml", "scenario.json", "events.csv", "trajectory.csv"}
    assert _tree(tmp_path) == {Path(name) for name in ("work", "home", "named")} | {
        Path("named") / name for name in files
    }
