"""The course scheme, written from its text in plain Python for two balls on a table, as a student might.

Mistakes can be switched on by name. Nothing in it is taken from Carom.
"""

import math
from pathlib import Path

Row = tuple[float, float, float, float, float]
Pair = list[list[float]]

RADIUS, WIDTH, LENGTH, DAMPING = 0.075, 1.0, 2.0, 0.8
MISTAKES = (
    *("swapped", "tangent", "not unit", "normal only", "undamped", "missed", "whole", "one only"),
    *("full clock", "no radius", "past", "not turned", "long t", "long n and t", "exact time"),
)


def simulate(
    dt: float = 0.03,
    duration: float = 5.0,
    *,
    mistake: str = "",
    normal: str = "before",
    restart: bool = False,
    full: bool = False,
) -> list[Row]:
    """Rows t, red x, red y, blue x, blue y, one for each step."""
    assert mistake in ("", *MISTAKES)
    restart = restart or mistake == "full clock"
    x: Pair = [[0.1, 0.1], [0.5, 1.0]]
    v: Pair = [[3.0, 4.0], [0.0, 0.0]]
    rows = [(0.0, *x[0], *x[1])]
    t, begun, done = 0.0, 0.0, 0
    while duration - t > 1e-9 * dt:
        last = not full and duration - t <= dt * (1 + 1e-9)
        h = duration - t if last else dt
        y = [moved(x[i], v[i], h) for i in (0, 1)]
        hits = sorted(wall_hits(x, v, y, mistake) + ([] if mistake == "missed" else ball_hits(x, v, y, h, mistake)))
        if restart and hits:
            hits = hits[:1]
            h = hits[0][0]
            y = [moved(x[i], v[i], h) for i in (0, 1)]
        new_v = [list(v[0]), list(v[1])]
        busy: set[int] = set()
        for time, kind, ball, axis in hits:
            balls = {0, 1} if kind == 0 else {ball}
            if balls & busy:
                continue
            busy |= balls
            for i in balls:
                y[i] = moved(x[i], v[i], h if mistake == "past" and kind == 1 else time)
            if kind == 0:
                new_v = collide(x if normal == "before" else y, v, mistake)
            else:
                new_v[ball] = reflect(v[ball], axis, mistake)
        if restart and hits and mistake != "full clock":
            t, begun, done = t + h, t + h, 0
        else:
            done += 1
            t = duration if last else begun + done * dt
        x, v = y, new_v
        rows.append((t, *x[0], *x[1]))
    return rows


def moved(x: list[float], v: list[float], time: float) -> list[float]:
    return [x[0] + v[0] * time, x[1] + v[1] * time]


def wall_hits(x: Pair, v: Pair, y: Pair, mistake: str) -> list[tuple[float, int, int, int]]:
    hits = []
    edge = 0.0 if mistake == "no radius" else RADIUS
    for ball in (0, 1):
        for axis, size in ((0, WIDTH), (1, LENGTH)):
            if y[ball][axis] < edge and v[ball][axis] < 0:
                hits.append(((edge - x[ball][axis]) / v[ball][axis], 1, ball, axis))
            if y[ball][axis] > size - edge and v[ball][axis] > 0:
                hits.append(((size - edge - x[ball][axis]) / v[ball][axis], 1, ball, axis))
    return hits


def ball_hits(x: Pair, v: Pair, y: Pair, h: float, mistake: str) -> list[tuple[float, int, int, int]]:
    d = [x[0][c] - x[1][c] for c in (0, 1)]
    w = [v[0][c] - v[1][c] for c in (0, 1)]
    if math.dist(y[0], y[1]) > 2 * RADIUS or d[0] * w[0] + d[1] * w[1] >= 0:
        return []
    if mistake == "exact time":
        half, square = d[0] * w[0] + d[1] * w[1], w[0] ** 2 + w[1] ** 2
        return [((-half - math.sqrt(half**2 - square * (d[0] ** 2 + d[1] ** 2 - 4 * RADIUS**2))) / square, 0, 0, 0)]
    return [(min(max((math.hypot(*d) - 2 * RADIUS) / math.hypot(*w), 0.0), h), 0, 0, 0)]


def reflect(v: list[float], axis: int, mistake: str) -> list[float]:
    along = 1.0 if mistake in ("normal only", "undamped") else DAMPING
    across = 1.0 if mistake == "undamped" else DAMPING
    new = [along * v[0], along * v[1]]
    new[axis] = (across if mistake == "not turned" else -across) * v[axis]
    return new


def collide(places: Pair, v: Pair, mistake: str) -> Pair:
    if mistake == "whole":
        return [list(v[1]), list(v[0])]
    n = [places[0][c] - places[1][c] for c in (0, 1)]
    if mistake == "swapped":
        n = n[::-1]
    if mistake == "tangent":
        n = [-n[1], n[0]]
    if mistake not in ("not unit", "long n and t"):
        length = math.hypot(*n)
        n = [n[0] / length, n[1] / length]
    a, b = (v[i][0] * n[0] + v[i][1] * n[1] for i in (0, 1))
    if mistake in ("long t", "long n and t"):
        t = [1.0, -n[0] / n[1]]
        p, q = (v[i][0] * t[0] + v[i][1] * t[1] for i in (0, 1))
        return [[b * n[c] + p * t[c] for c in (0, 1)], [a * n[c] + q * t[c] for c in (0, 1)]]
    new = [[v[0][c] + (b - a) * n[c] for c in (0, 1)], [v[1][c] + (a - b) * n[c] for c in (0, 1)]]
    return [list(v[0]), new[1]] if mistake == "one only" else new


def without(rows: list[Row], place: int) -> list[Row]:
    """The rows without one, whose time is missing then."""
    return rows[:place] + rows[place + 1 :]


def lost(rows: list[Row], place: int) -> list[Row]:
    """The rows without one, and the clock set as if it had never been."""
    return [(row[0], *other[1:]) for row, other in zip(rows, without(rows, place), strict=False)]


def write(
    path: Path, rows: list[Row], header: str = "t,xr,yr,xb,yb", delimiter: str = ",", end: str = "\n", form: str = "%r"
) -> Path:
    lines = [header] if header else []
    lines += [delimiter.join(form % value for value in row) for row in rows]
    path.write_text(end.join([*lines, ""]), encoding="utf-8", newline="")
    return path
