"""Films have the length, the speed and the pictures that they should."""

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import carom
from carom.animation import animate, film_times, gif_delays


def frames_of(path: Path) -> list[tuple[Image.Image, int]]:
    with Image.open(path) as film:
        shown = []
        for index in range(getattr(film, "n_frames", 1)):
            film.seek(index)
            shown.append((film.convert("RGB"), int(film.info["duration"])))
    return shown


def centre_of(picture: Image.Image, colour: tuple[int, int, int]) -> Any:
    near = np.abs(np.asarray(picture).astype(int) - colour).sum(axis=-1) < 40
    rows, columns = np.nonzero(near)
    return np.array([columns.mean(), rows.mean()])


@pytest.mark.parametrize("fps", [7, 24, 25, 30, 33.3, 50])
@pytest.mark.parametrize("duration", [0.004, 0.2, 1.0, 5.0, 12.345])
def test_gif_delays_make_the_duration_and_none_is_too_short(duration: float, fps: float) -> None:
    delays = gif_delays(duration, fps)
    assert delays.sum() == max(round(100 * duration), 2)
    assert delays.min() >= 2
    assert abs(len(delays) - duration * fps) <= 2
    starts = np.cumsum(delays) - delays
    assert np.abs(starts - 100 * np.arange(len(delays)) / fps).max() <= 0.5


def test_film_times_are_even() -> None:
    np.testing.assert_array_equal(film_times(0.5, 10), [0.0, 0.1, 0.2, 0.3, 0.4])


def test_a_gif_runs_at_true_speed(run: carom.Run, tmp_path: Path) -> None:
    path = run.animate(tmp_path / "film.gif", size=200)
    frames = frames_of(path)
    assert len(frames) == 150
    assert sum(delay for _, delay in frames) == 5000


def test_a_gif_can_run_slower_and_faster(run: carom.Run, tmp_path: Path) -> None:
    for speed, total in ((0.5, 10_000), (4.0, 1250)):
        frames = frames_of(animate(run, tmp_path / "film.gif", speed=speed, fps=10, size=120))
        assert sum(delay for _, delay in frames) == total


def test_discs_are_where_the_balls_are_at_the_moment_of_the_frame(midterm: carom.Scenario, tmp_path: Path) -> None:
    colours = {"balls.red.color": [1.0, 0.0, 0.0], "balls.blue.color": [0.0, 0.0, 1.0]}
    run = midterm.with_values(colours).run()
    frames = frames_of(animate(run, tmp_path / "film.gif", fps=10, size=640, trail=0.0))
    corner = centre_of(frames[0][0], (255, 0, 0)) - centre_of(frames[0][0], (0, 0, 255))
    scale = np.linalg.norm(corner) / np.hypot(0.4, 0.9)
    for index in (3, 12, 40):
        shift = centre_of(frames[index][0], (255, 0, 0)) - centre_of(frames[0][0], (255, 0, 0))
        x, y = run.positions(0.1 * index)[0] - run.positions(0.0)[0]
        np.testing.assert_allclose(shift, scale * np.array([x, -y]), atol=2.0)


def test_trails_are_drawn_behind_moving_balls(run: carom.Run, tmp_path: Path) -> None:
    with_trail, without = (
        frames_of(animate(run, tmp_path / "film.gif", fps=5, size=200, trail=trail))[3][0] for trail in (0.5, 0.0)
    )
    assert np.any(np.asarray(with_trail) != np.asarray(without))


def test_cloth_and_paper_keep_their_colours(run: carom.Run, tmp_path: Path) -> None:
    for picture, _ in frames_of(animate(run, tmp_path / "film.gif", fps=2, size=320)):
        assert picture.getpixel((picture.width - 2, 2)) == (255, 255, 255)
        assert picture.getpixel((picture.width - 16, picture.height - 16)) == (0xED, 0xF3, 0xEE)


def test_films_have_even_sides_of_the_size_asked_for(run: carom.Run, tmp_path: Path) -> None:
    for size in (121, 320):
        picture = frames_of(animate(run, tmp_path / "film.gif", fps=2, size=size))[0][0]
        assert abs(max(picture.size) - size) <= 1
        assert picture.width % 2 == picture.height % 2 == 0


def test_an_mp4_is_written(run: carom.Run, tmp_path: Path) -> None:
    ffmpeg = pytest.importorskip("imageio_ffmpeg")
    path = animate(run, tmp_path / "film.mp4", size=200, fps=20)
    frames, seconds = ffmpeg.count_frames_and_secs(str(path))
    assert frames == 100
    # Older ffmpegs tell when the last frame was decoded, which is up to three frames before it is shown.
    assert seconds == pytest.approx(5.0, abs=0.16)
    assert [each.name for each in tmp_path.iterdir()] == ["film.mp4"]


def test_an_mp4_without_its_extra_says_what_it_needs(
    run: carom.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(carom.MissingExtraError, match=r"needs carom\[movie\]"):
        animate(run, tmp_path / "film.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "options", "word"),
    [
        ("film.avi", {}, "ends in"),
        ("film.gif", {"fps": 60}, "fps"),
        ("film.gif", {"fps": 0}, "fps"),
        ("film.gif", {"speed": -1.0}, "speed"),
        ("film.gif", {"size": 0}, "size"),
    ],
)
def test_what_cannot_be_filmed_is_refused(
    run: carom.Run, tmp_path: Path, name: str, options: dict[str, Any], word: str
) -> None:
    with pytest.raises(ValueError, match=word):
        animate(run, tmp_path / name, **options)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["film.gif", "film.mp4"])
def test_a_film_without_end_is_refused_with_a_speed_that_does(
    midterm: carom.Scenario, tmp_path: Path, name: str
) -> None:
    run = midterm.run(duration=1e9)
    with pytest.raises(ValueError, match=r"3e\+10 frames, more than 100000; .* speed=5e\+07"):
        run.animate(tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_an_interrupted_film_leaves_nothing(run: carom.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(self: object, index: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("carom.animation._Film.frame", interrupt)
    with pytest.raises(KeyboardInterrupt):
        animate(run, tmp_path / "film.gif")
    assert not list(tmp_path.iterdir())


def test_a_progress_bar_shows_where_it_is_asked_for(
    run: carom.Run, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # The bar is fitted to the terminal that the environment speaks of: none on a dumb one, cut short on a narrow one.
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "80")
    animate(run, tmp_path / "film.gif", fps=2, size=80)
    assert capsys.readouterr().err == ""
    animate(run, tmp_path / "film.gif", fps=2, size=80, progress=True)
    assert "film" in capsys.readouterr().err
