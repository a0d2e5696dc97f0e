"""Films of runs: GIF with Pillow, MP4 with the ffmpeg that carom[movie] brings.

The table is drawn once; on a copy of it every frame gets its trails, its discs and its time, at a multiple of
the size, and is reduced: that is what makes the edges smooth.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.extras import needed
from carom.files import replacing

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from PIL.Image import Image
    from PIL.ImageFont import FreeTypeFont

    from carom.figures.repeats import Repeats
    from carom.figures.scene import Scene
    from carom.run import Run

FORMATS = (".gif", ".mp4")
OVERSAMPLING = 2
CAPTION = 26
FADES = 16
SAMPLES_PER_FRAME = 3
MOST_TRAILS = 32
EXACT_COLOURS = 128
SHADOW = 0.6
"""How far right and down the shadow of a flying ball falls, over its height."""
SHADE = "#c3cdc6"
MOST_FRAMES = 1e5
SHORT_FILM = 20.0
SHORTEST_DELAY = 2  # hundredths of a second; viewers slow a GIF down below it


def animate(
    run: Run,
    path: str | os.PathLike[str],
    *,
    fps: float = 30.0,
    speed: float = 1.0,
    size: int = 640,
    trail: float | None = None,
    progress: bool | None = None,
) -> Path:
    """Write a film of a run; its suffix chooses GIF or MP4.

    A GIF can show a frame only for whole hundredths of a second: each frame shows the run at the moment that
    it appears, so that the film as a whole is neither faster nor slower than asked.

    Parameters
    ----------
    run : Run
        The run to film, from time 0 to its end.
    path : str or path-like
        The file to write, ``.gif`` or ``.mp4``.
    fps : float
        Frames per second of the film, at most 50 in a GIF.
    speed : float
        How much time of the run passes in a second of the film.
    size : int
        Length of the film's longer side, in pixels.
    trail : float, optional
        For how long a ball's path stays to be seen, in time of the run. If not given: half a second of the
        film, and none where there are more than 32 balls.
    progress : bool, optional
        Show a progress bar on stderr. If not given: where stderr is a terminal.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        If the suffix is neither of the two, or a number is out of its range, or the film would have more than
        100 000 frames.
    MissingExtraError
        If an MP4 is asked for without carom[movie].
    """
    target = Path(path)
    suffix = target.suffix.lower()
    if suffix not in FORMATS:
        raise ValueError(f"{target}: a film ends in {' or '.join(FORMATS)}")
    _check_range("fps", fps, 100.0 / SHORTEST_DELAY if suffix == ".gif" else 1000.0)
    _check_range("speed", speed, np.inf)
    _check_range("size", size, 10_000)
    _check_length(target, run.end_time, speed, fps)
    ffmpeg = needed("imageio_ffmpeg", "movie") if suffix == ".mp4" else None
    delays = gif_delays(run.end_time / speed, fps) if ffmpeg is None else None
    times = speed * (film_times(run.end_time / speed, fps) if delays is None else _starts(delays) / 100.0)
    film = _Film.of(run, np.minimum(times, run.end_time), size, 0.5 * speed if trail is None else trail)
    with replacing(target) as temporary, _counting(film.frames(), len(times), progress) as frames:
        if delays is None:
            _write_mp4(ffmpeg, temporary, frames, film.size, fps)
        else:
            _write_gif(temporary, frames, delays, film.palette())
    return target


def gif_delays(duration: float, fps: float) -> NDArray[np.int64]:
    """Give for how long each frame of a GIF is shown, in hundredths of a second; their sum is `duration`.

    Examples
    --------
    >>> gif_delays(0.2, 30)
    array([3, 4, 3, 3, 4, 3])
    """
    total = max(round(100.0 * duration), SHORTEST_DELAY)
    count = max(1, int(np.ceil(total * fps / 100.0)))
    starts = np.floor(100.0 * np.arange(count) / fps + 0.5).astype(np.int64)
    starts = starts[starts <= total - SHORTEST_DELAY]
    return np.diff(np.append(starts, total))


def film_times(duration: float, fps: float) -> NDArray[np.float64]:
    """Give the times of a film's frames, evenly spaced from 0."""
    return np.arange(max(1, round(duration * fps))) / fps


def _starts(delays: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.cumsum(delays) - delays


def _check_range(name: str, value: float, most: float) -> None:
    if not 0 < value <= most:
        raise ValueError(f"{name}: must be above 0 and at most {most:g}, got {value!r}")


def _check_length(target: Path, end: float, speed: float, fps: float) -> None:
    """Refuse a film that nobody will see the end of, and say how to have a shorter one."""
    frames = end / speed * fps
    if frames > MOST_FRAMES:
        raise ValueError(
            f"{target}: {frames:.3g} frames, more than {MOST_FRAMES:g}; a larger speed makes fewer, and "
            f"speed={end / SHORT_FILM:.3g} a film of {SHORT_FILM:g} seconds"
        )


@dataclass(frozen=True)
class _Film:
    """All that its frames need, in pixels of the enlarged picture.

    Attributes
    ----------
    background : Image
        The table.
    repeats : Repeats
        The table's box, and along which axes it repeats itself.
    discs : (n_frames, n_balls, 2) float64
        Centres, in the box.
    radii : (n_balls,) float64
        Radii.
    trails : (n_samples, n_balls, 2) float64
        Places along the paths, at the ascending `trail_times`; no rows where none are drawn.
    turns : (n_frames, n_balls, 3, 3) float64 or None
        How balls on a cloth have turned.
    lifts : (n_frames, n_balls) float64 or None
        How high over the cloth they fly, in pixels.
    """

    background: Image
    scene: Scene
    repeats: Repeats
    times: NDArray[np.float64]
    discs: NDArray[np.float64]
    radii: NDArray[np.float64]
    trails: NDArray[np.float64]
    trail_times: NDArray[np.float64]
    trail: float
    font: FreeTypeFont
    digits: int
    turns: NDArray[np.float64] | None
    lifts: NDArray[np.float64] | None

    @classmethod
    def of(cls, run: Run, times: NDArray[np.float64], size: int, trail: float) -> _Film:
        """Prepare the film of a run: one evaluation of the run, one drawing of the table."""
        from PIL import ImageFont

        from carom.figures.repeats import Repeats
        from carom.figures.scene import Scene
        from carom.figures.style import font_file
        from carom.figures.turning import turned

        scene = Scene.of(run.scenario)
        background, to_pixels = _draw_background(scene, size)
        fine = _trail_times(run, times) if trail > 0 and len(scene.ids) <= MOST_TRAILS else np.empty(0)
        places, origin = run.positions(times), to_pixels(np.zeros((1, 2)))
        point = 0.009 * scene.size
        reach = np.stack([np.where(scene.radii > 0, scene.radii, point), np.zeros(len(scene.ids))], axis=-1)
        radii = (to_pixels(reach) - origin)[:, 0]
        # Pixels are counted from the top, so the upper left corner is the first.
        low, high = to_pixels(np.array([[scene.bounds[0], scene.bounds[3]], [scene.bounds[2], scene.bounds[1]]]))
        repeats = Repeats(low, high - low, scene.repeats.axes)
        step = float(times[1] - times[0]) if len(times) > 1 else 0.1
        return cls(
            background=background,
            scene=scene,
            repeats=repeats,
            times=times,
            discs=repeats.wrapped(to_pixels(places[..., :2])),
            radii=radii,
            trails=to_pixels(run.positions(fine)[..., :2]),
            trail_times=fine,
            trail=trail,
            font=ImageFont.truetype(font_file(), 13 * OVERSAMPLING),
            digits=int(np.clip(np.ceil(-np.log10(step)), 0, 9)),
            turns=turned(run, times) if scene.on_cloth else None,
            lifts=radii * (places[..., 2] / scene.radii - 1.0) if scene.on_cloth else None,
        )

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of a frame in pixels."""
        width, height = self.background.size
        return width // OVERSAMPLING, height // OVERSAMPLING

    def frames(self) -> Iterator[Image]:
        """Draw the frames, one after the other."""
        return (self.frame(index) for index in range(len(self.times)))

    def frame(self, index: int) -> Image:
        """Draw one frame."""
        from PIL import ImageDraw

        picture = self.background.copy()
        draw = ImageDraw.Draw(picture)
        self._draw_trails(draw, float(self.times[index]))
        self._draw_balls(picture, draw, index)
        self._clear_outside(picture)
        unit = self.scene.unit("time")
        words = f"t = {self.times[index]:.{self.digits}f}" + (f" {unit}" if unit else "")
        draw.text((12 * OVERSAMPLING, 5 * OVERSAMPLING), words, font=self.font, fill="#22292f")
        return picture.reduce(OVERSAMPLING)

    def _draw_balls(self, picture: Image, draw: Any, index: int) -> None:
        """Draw discs, or balls on a cloth with their marks; those out of play beside the time, as they are named."""
        gone = 0
        places, which = self.repeats.copies(self.discs[index], self.radii)
        for place, ball in zip(places, which.tolist(), strict=True):
            radius = float(self.radii[ball])
            if self.lifts is not None and self.lifts[index, ball] > 0.1 * radius:
                x, y = (place + SHADOW * self.lifts[index, ball]).tolist()
                draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=SHADE)
            if not np.isfinite(place[0]):
                x, y = picture.width - (14 + 15 * gone) * OVERSAMPLING, 13 * OVERSAMPLING
                gone += 1
                self._paste(picture, ball, np.array([x, y]), 5.5 * OVERSAMPLING, np.eye(3))
            elif self.turns is None:
                x, y = place.tolist()
                box = (x - radius, y - radius, x + radius, y + radius)
                draw.ellipse(box, fill=self.scene.colours[ball], outline="#1d2327", width=OVERSAMPLING)
            else:
                self._paste(picture, ball, place, radius, self.turns[index, ball])

    def _paste(
        self, picture: Image, ball: int, place: NDArray[np.float64], radius: float, turn: NDArray[np.float64]
    ) -> None:
        from PIL import Image

        from carom.figures.turning import seen_from_above

        middle = np.floor(place)
        right, down = (place - middle - 0.5).tolist()
        seen = Image.fromarray(seen_from_above(self.scene, ball, turn, radius, (right, down)))
        corner = middle.astype(int) - seen.width // 2
        picture.paste(seen, (int(corner[0]), int(corner[1])), seen)

    def _draw_trails(self, draw: Any, time: float) -> None:
        """Draw the last part of every path, the older the closer to the colour of the cloth."""
        first, last = np.searchsorted(self.trail_times, [time - self.trail, time], side="right")
        if last - first < 2:
            return
        age = (time - self.trail_times[first : last - 1]) / self.trail
        shades = np.clip((FADES * age).astype(int), 0, FADES - 1)
        for ball, colours in enumerate(_faded(self.scene.lines)):
            places = self.trails[first:last, ball]
            for shade in np.unique(shades[np.any(np.diff(places, axis=0) != 0, axis=1)])[::-1]:
                part = np.flatnonzero(shades == shade)
                for points in _pieces(self.repeats.broken(places[part[0] : part[-1] + 2])):
                    draw.line(points.ravel().tolist(), fill=colours[shade], width=2 * OVERSAMPLING, joint="curve")

    def _clear_outside(self, picture: Image) -> None:
        """Take away what discs show beyond sides at which the table repeats itself."""
        ends = np.rint(np.stack([self.repeats.low, self.repeats.low + self.repeats.size])).astype(int)
        for axis in np.flatnonzero(self.repeats.axes):
            for first, last in ((0, ends[0, axis]), (ends[1, axis], picture.size[axis])):
                start, end = int(first), int(last)
                box = (start, 0, end, picture.height) if axis == 0 else (0, start, picture.width, end)
                picture.paste(self.background.crop(box), box[:2])

    def palette(self) -> _Palette:
        """Choose the colours of a GIF from a few frames that are spread over the film."""
        chosen = np.unique(np.linspace(0, len(self.times) - 1, 6).astype(int)).tolist()
        return _Palette.of(np.concatenate([_packed(self.frame(index)).ravel() for index in chosen]))


class _Palette:
    """The colours of a GIF, and for every colour met so far the nearest of them.

    The most frequent colours are kept exactly, so that cloth and paper have the colours they have in figures.
    """

    unknown = 255

    def __init__(self, colours: NDArray[np.uint8]) -> None:
        self.colours = colours
        self._nearest = np.full(1 << 24, self.unknown, dtype=np.uint8)

    @classmethod
    def of(cls, pixels: NDArray[np.uint32]) -> _Palette:
        """Choose 255 colours for some packed pixels, (n_pixels,) uint32."""
        from PIL import Image

        packed, counts = np.unique(pixels, return_counts=True)
        kept = packed[np.argsort(counts)[::-1][:EXACT_COLOURS]]
        rest = packed[np.isin(packed, kept, invert=True)]
        spread = Image.fromarray(_unpacked(rest if len(rest) else kept)[None])
        count = cls.unknown - EXACT_COLOURS
        mixed = spread.quantize(count, method=Image.Quantize.MEDIANCUT).getpalette()
        # Older Pillows fill the palette up to 256 colours.
        return cls(np.concatenate([_unpacked(kept), np.array(mixed, dtype=np.uint8).reshape(-1, 3)[:count]]))

    def apply(self, picture: Image) -> Image:
        """Give a picture in these colours."""
        from PIL import Image

        packed = _packed(picture)
        chosen = self._nearest[packed]
        new = np.unique(packed[chosen == self.unknown])
        if len(new):
            apart = _unpacked(new).astype(int)[:, None] - self.colours.astype(int)
            self._nearest[new] = np.argmin(np.sum(apart**2, axis=-1), axis=-1)
            chosen = self._nearest[packed]
        indexed = Image.fromarray(chosen)
        indexed.putpalette(self.colours.tobytes())
        return indexed


def _packed(picture: Image) -> NDArray[np.uint32]:
    """Give every pixel of a picture as one number, (height, width) uint32: red, green, blue from the low end."""
    pixels: NDArray[np.uint32] = np.asarray(picture.convert("RGBA")).view("<u4")[..., 0] & np.uint32(0xFFFFFF)
    return pixels


def _unpacked(packed: NDArray[np.uint32]) -> NDArray[np.uint8]:
    return np.stack([packed & 255, packed >> 8 & 255, packed >> 16], axis=-1).astype(np.uint8)


def _draw_background(scene: Scene, size: int) -> tuple[Image, Any]:
    """Draw the table on an enlarged picture, and give the function from places (..., 2) to its pixels."""
    from PIL import Image

    from carom.figures.style import new_figure
    from carom.figures.table import draw_table, framed_ratio

    ratio = framed_ratio(scene)
    across = min(size, (size - CAPTION) / ratio)
    width, height = (2 * round(extent / 2) for extent in (across, across * ratio + CAPTION))
    figure = new_figure(width / 100, height / 100)
    figure.set_dpi(100 * OVERSAMPLING)
    ax = figure.add_axes((0, 0, 1, 1 - CAPTION / height))
    draw_table(ax, scene)
    ax.set_axis_off()
    figure.canvas.draw()
    picture = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])  # type: ignore[attr-defined]
    transform, rows = ax.transData, picture.height

    def to_pixels(places: NDArray[np.float64]) -> NDArray[np.float64]:
        pixels = transform.transform(places.reshape(-1, 2)).reshape(places.shape)
        pixels[..., 1] = rows - pixels[..., 1]
        return pixels

    return picture, to_pixels


def _trail_times(run: Run, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the frames' times, some between them, and the events' times."""
    fine = np.interp(np.arange(0, len(times) - 1 + 1e-9, 1 / SAMPLES_PER_FRAME), np.arange(len(times)), times)
    events = np.asarray(run.events["time"], dtype=float)
    return np.unique(np.concatenate([times, fine, events if len(events) < 20 * len(times) else []]))


def _pieces(path: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Give the parts of a path (n, 2) between rows of NaN."""
    gaps = np.flatnonzero(np.isnan(path[:, 0]))
    return [part[np.isfinite(part[:, 0])] for part in np.split(path, gaps)]


def _faded(colours: Sequence[tuple[float, float, float]]) -> list[list[tuple[int, int, int]]]:
    """Give for every ball the colours of its trail, from fresh to nearly gone."""
    from matplotlib.colors import to_rgb

    from carom.figures.style import CLOTH

    cloth = np.array(to_rgb(CLOTH))
    share = 0.7 * (1.0 - (np.arange(FADES) + 0.5) / FADES)[:, None]
    blends = [share * np.array(colour) + (1.0 - share) * cloth for colour in colours]
    return [[(r, g, b) for r, g, b in np.rint(255 * blend).astype(int).tolist()] for blend in blends]


def _write_gif(path: Path, frames: Iterable[Image], delays: NDArray[np.int64], palette: _Palette) -> None:
    pictures = map(palette.apply, frames)
    first = next(pictures)
    durations = [10 * delay for delay in delays.tolist()]
    first.save(path, format="GIF", save_all=True, append_images=pictures, duration=durations, loop=0)


def _write_mp4(ffmpeg: Any, path: Path, frames: Iterable[Image], size: tuple[int, int], fps: float) -> None:
    options = ["-crf", "18", "-preset", "medium", "-movflags", "+faststart"]
    writer = ffmpeg.write_frames(
        str(path), size, fps=fps, codec="libx264", quality=None, macro_block_size=2, output_params=options
    )
    try:
        writer.send(None)
        for frame in frames:
            writer.send(frame.tobytes())
    finally:
        writer.close()


@contextmanager
def _counting(frames: Iterable[Image], total: int, progress: bool | None) -> Iterator[Iterable[Image]]:
    """Pass the frames on, with a progress bar where it is wanted."""
    if not (sys.stderr.isatty() if progress is None else progress):
        yield frames
        return
    from rich.console import Console
    from rich.progress import Progress

    console = Console(stderr=True, force_terminal=progress)
    with Progress(console=console, transient=True) as bar:
        yield bar.track(frames, total=total, description="film")
