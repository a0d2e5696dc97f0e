"""pooltool's tables: the numbers that one was built from, found again from its cushions and pockets."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from carom.errors import ScenarioError
from carom.pooltool.values import at

Point = tuple[float, float]
Places = dict[str, list[Point]]

SAME = 1e-9
"""Places nearer to each other than this are the same, in metres; pooltool writes all digits of its own."""

MIRRORED = {
    (False, False): {"3": "3", "18": "18", "1": "1", "2": "2", "4": "4", "lb": "lb", "lc": "lc"},
    (True, False): {"3": "15", "18": "18", "1": "17", "2": "16", "4": "14", "lb": "rb", "lc": "rc"},
    (False, True): {"3": "6", "18": "9", "1": "8", "2": "7", "4": "5", "lb": "lt", "lc": "lc"},
    (True, True): {"3": "12", "18": "9", "1": "10", "2": "11", "4": "13", "lb": "rt", "lc": "rc"},
}
"""What the cushions and pockets of the lower left quarter are called when mirrored left to right, bottom to top."""


def table_of(table: Mapping[str, Any]) -> dict[str, Any]:
    """Give the keys of `table` for one of pooltool's; one that its specifications cannot build is an error."""
    places = _places(table)
    heights = _heights(table)
    if not {"3", "9", "12", "18"} <= places.keys() or len(heights) != 1:
        raise _foreign()
    width = _tidy(places["12"][0][0] - places["3"][0][0])
    length = _tidy(places["9"][0][1] - places["18"][0][1])
    size = {"width": width, "length": length, "nose_height": heights.pop(), "nose_contact": "plan"}
    if len(places) == 4:
        _check(places, _rectangle(width, length))
        return {"shape": "rectangle", **size}
    numbers = _numbers(table, places, length)
    _check(places, _six_pockets(width, length, numbers))
    _check_radii(table, numbers)
    return {"shape": "pocket_table", **size, **numbers}


def _places(table: Mapping[str, Any]) -> Places:
    """Give the ends of each line, and the centre of each arc and pocket."""
    lines = {name: [line["p1"][:2], line["p2"][:2]] for name, line in at(table, "cushion_segments", "linear").items()}
    round_ones = {**at(table, "cushion_segments", "circular"), **at(table, "pockets")}
    return {**lines, **{name: [circle["center"][:2]] for name, circle in round_ones.items()}}


def _heights(table: Mapping[str, Any]) -> set[float]:
    cushions = table["cushion_segments"]
    ends = {line[end][2] for line in cushions["linear"].values() for end in ("p1", "p2")}
    return ends | {arc["center"][2] for arc in cushions["circular"].values()}


def _numbers(table: Mapping[str, Any], places: Places, length: float) -> dict[str, Any]:
    """Find the numbers of the mouths in the lower left quarter."""
    if places.keys() != _six_pockets(1, 2, NO_MOUTHS).keys():
        raise _foreign()
    arcs, pockets = table["cushion_segments"]["circular"], table["pockets"]
    (end_x, end_y), (start_x, start_y) = places["1"]
    corner_angle = math.degrees(math.atan2(start_x - end_x, start_y - end_y)) - 45
    corner = {
        "width": _tidy((places["3"][0][1] - _tangent(arcs["1t"]["radius"], 45 + corner_angle)) * math.sqrt(2)),
        "angle_deg": _tidy(corner_angle),
        "depth": _tidy(-places["lb"][0][0] * math.sqrt(2)),
        "radius": pockets["lb"]["radius"],
        "jaw_radius": arcs["1t"]["radius"],
    }
    side_angle = _side_angle(places)
    side = {
        "width": _tidy(length - 2 * (places["3"][1][1] + _tangent(arcs["4t"]["radius"], side_angle))),
        "angle_deg": _tidy(side_angle),
        "depth": _tidy(-places["lc"][0][0]),
        "radius": pockets["lc"]["radius"],
        "jaw_radius": arcs["4t"]["radius"],
    }
    return {"cushion_width": _tidy(-end_y), "corner": corner, "side": side}


def _side_angle(places: Places) -> float:
    """Give the angle of a side's facing in degrees: from where its arc ends, or without an arc from its own ends.

    With the arc's centre at height y, tangent length d and angle s, the arc ends at (−d cos s, y + d + d sin s).
    """
    (far_x, far_y), (near_x, near_y) = places["4"]
    across, along = -near_x, near_y - places["4t"][0][1]
    if across > 0:
        return 90 - 2 * math.degrees(math.atan2(across, along))
    if not abs(far_y - near_y) < -far_x:
        raise _foreign()
    return math.degrees(math.asin((far_y - near_y) / -far_x))


def _tangent(radius: float, angle_deg: float) -> float:
    """How far an arc that rounds a facing at this angle begins from where the lines would meet."""
    return radius * math.tan(math.radians(45 - angle_deg / 2))


def _rectangle(width: float, length: float) -> Places:
    corners = [(0.0, 0.0), (width, 0.0), (width, length), (0.0, length)]
    sides = zip(["18", "12", "9", "3"], corners, [*corners[1:], corners[0]], strict=True)
    return {name: [start, end] for name, start, end in sides}


def _six_pockets(width: float, length: float, numbers: Mapping[str, Any]) -> Places:
    """Give the places of a whole table: those of a quarter, mirrored."""
    quarter = _quarter(width, length, numbers)
    whole: Places = {}
    for (right, top), names in MIRRORED.items():
        for name, points in quarter.items():
            mirrored = [(width - x if right else x, length - y if top else y) for x, y in points]
            whole[names[name.removesuffix("t")] + "t" * name.endswith("t")] = mirrored
    return whole


def _quarter(width: float, length: float, numbers: Mapping[str, Any]) -> Places:
    back, corner, side = numbers["cushion_width"], numbers["corner"], numbers["side"]
    corner_angle, side_angle = 45 + corner["angle_deg"], side["angle_deg"]
    first, second = _tangent(corner["jaw_radius"], corner_angle), _tangent(side["jaw_radius"], side_angle)
    sin, cos = math.sin(math.radians(corner_angle)), math.cos(math.radians(corner_angle))
    side_sin, side_cos = math.sin(math.radians(side_angle)), math.cos(math.radians(side_angle))
    mouth, middle = corner["width"] / math.sqrt(2), (length - side["width"]) / 2
    facing = [(mouth - back * sin / cos, -back), (mouth - first * sin, -first * cos)]
    hole = corner["depth"] / math.sqrt(2)
    return {
        "3": [(0, mouth + first), (0, middle - second)],
        "18": [(mouth + first, 0), (width - mouth - first, 0)],
        "1": facing,
        "2": [(y, x) for x, y in facing],
        "4": [(-back, middle + back * side_sin), (-second * side_cos, middle + second * side_sin)],
        "1t": [(mouth + first, -corner["jaw_radius"])],
        "2t": [(-corner["jaw_radius"], mouth + first)],
        "4t": [(-side["jaw_radius"], middle - second)],
        "lb": [(-hole, -hole)],
        "lc": [(-side["depth"], length / 2)],
    }


_NO_MOUTH = {"width": 0.1, "angle_deg": 0.0, "depth": 0.0, "radius": 0.0, "jaw_radius": 0.0}
NO_MOUTHS = {"cushion_width": 0.1, "corner": _NO_MOUTH, "side": _NO_MOUTH}
"""Any numbers: which cushions and pockets a table has does not depend on them."""


def _check(places: Places, expected: Places) -> None:
    """Refuse a table whose cushions or pockets lie elsewhere than its numbers say; ends may be swapped."""
    for name, points in expected.items():
        found = places.get(name, [])
        if not any(_same(points, ends) for ends in (found, found[::-1])):
            raise _foreign()


def _same(points: list[Point], others: list[Point]) -> bool:
    return len(points) == len(others) and all(map(lambda a, b: math.dist(a, b) < SAME, points, others))


def _check_radii(table: Mapping[str, Any], numbers: Mapping[str, Any]) -> None:
    sides = {"4t", "5t", "13t", "14t", "lc", "rc"}
    for key, circles in (("jaw_radius", table["cushion_segments"]["circular"]), ("radius", table["pockets"])):
        for name, circle in circles.items():
            if abs(circle["radius"] - numbers["side" if name in sides else "corner"][key]) > SAME:
                raise _foreign()


def _tidy(number: float) -> float:
    """Take off the round-off of finding a number again, and the sign of a zero."""
    return round(number, 12) + 0.0


def _foreign() -> ScenarioError:
    return ScenarioError([("table", "must be one that pooltool builds from table specifications")])
