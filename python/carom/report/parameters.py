"""What a scenario says, as rows to read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.colours import ball_colours
from carom.library import presets
from carom.report.rows import Row
from carom.report.text import column, counted, exact, head, listed, point, short, with_unit
from carom.report.words import choices
from carom.units import unit_of

if TYPE_CHECKING:
    from carom.scenario import Scenario
    from carom.vectors import Vector

MOST_PARTS = 12
MOST_BALLS = 100
DEFAULT_EVENTS = 10_000_000
FRICTIONS = {"sliding_friction": 0.2, "rolling_friction": 0.01, "spin_decay": 10.9}
"""What a ball has on a cloth of which nothing else is said."""
SHOT_UNITS = {"V0": "speed", "speed": "speed", "mass": "mass", "radius": "length", "length": "length"}
"""What the numbers of a shot and of a cue are measured in, by what is in their names."""

Values = Mapping[str, Any]


def table_rows(scenario: Scenario) -> list[Row]:
    """Give the table's shape, its sizes, and the pieces, pockets and obstacles that it has."""
    table: Values = scenario.expanded().to_dict()["table"]
    length = scenario.units.get("length")
    name = scenario.to_dict().get("table", {}).get("preset")
    rows = [Row("preset", name, presets()[name])] if name else []
    rows.append(Row("shape", table["shape"]))
    rows += [Row("periodic", " and ".join(table["periodic"]))] if "periodic" in table else []
    rows += [
        Row(key.replace("_", " "), _size(value, length))
        for key, value in table.items()
        if key != "shape" and not isinstance(value, (list, dict))
    ]
    rows += [row for key in ("corner", "side") if key in table for row in _mouth_rows(key, table[key], length)]
    rows += [Row(f"pocket {pocket['id']}", _circle("pocket", pocket, length)) for pocket in table.get("pockets", [])]
    if "pieces" in table:
        x_min, y_min, x_max, y_max = scenario.outline()["bounds"]
        extent = f"{short(x_max - x_min)} × {short(y_max - y_min)}"
        rows.append(Row("extent", with_unit(extent, length)))
    return rows + _part_rows("pieces", table.get("pieces", [])) + _part_rows("obstacles", table.get("obstacles", []))


def _size(value: float | int | str, unit: str | None) -> str:
    """Give a size with its unit; a whole number counts something, and is no length."""
    if isinstance(value, str):
        return value
    return exact(value) if isinstance(value, int) else with_unit(short(value), unit)


def _mouth_rows(name: str, mouth: Values, unit: str | None) -> list[Row]:
    """Give the sizes of the pockets at the corners, or of those at the sides."""
    return [
        Row(f"{name} angle", f"{short(value)}°")
        if key == "angle_deg"
        else Row(f"{name} {key.replace('_', ' ')}", with_unit(short(value), unit))
        for key, value in mouth.items()
    ]


def _circle(kind: str, circle: Values, unit: str | None = None) -> str:
    return f"{kind} around {point(circle['center'])}, radius {with_unit(short(circle['radius']), unit)}"


def _part_rows(name: str, parts: list[Values]) -> list[Row]:
    """Give how many parts there are of which kind, and each one where they are few."""
    if not parts:
        return []
    kinds = Counter(_kind(part) for part in parts)
    total = Row(name, listed(counted(number, kind) for kind, number in kinds.items()))
    if len(parts) > MOST_PARTS:
        return [total]
    return [total, *(Row(part.get("id", f"{name}[{place}]"), _part(part)) for place, part in enumerate(parts))]


def _kind(part: Values) -> str:
    return next(key for key in part if key != "id")


def _part(part: Values) -> str:
    kind = _kind(part)
    shape = part[kind]
    if kind in ("line", "wall"):
        return f"{kind} from {point(shape[0])} to {point(shape[1])}"
    if kind == "path":
        return f"path of {counted(len(shape), 'piece')}"
    circle = _circle(kind, shape)
    return circle if kind == "circle" else f"{circle}, from {short(shape['from_deg'])}° to {short(shape['to_deg'])}°"


def ball_table(scenario: Scenario) -> dict[str, Any]:
    """Give the balls as a table: ``heads``, ``rows`` of colour, id and numbers, and how many are ``left`` out."""
    balls = scenario.balls
    colours = ball_colours([ball.id for ball in balls], [ball.color for ball in balls])
    shown = balls[:MOST_BALLS]
    length, mass = scenario.units.get("length"), scenario.units.get("mass")
    columns = {
        head("radius", length): column([ball.radius or 0.0 for ball in shown]),
        head("mass", mass): column([1.0 if ball.mass is None else ball.mass for ball in shown]),
        **_vector_columns("", [ball.position for ball in shown], length),
    }
    motions = {"velocity ": ([ball.velocity for ball in shown], unit_of(scenario.units, "speed"))}
    if scenario.is_on_cloth:
        columns |= _friction_columns(scenario)
        motions["spin "] = ([ball.spin for ball in shown], unit_of(scenario.units, "angular_velocity"))
        # Where a cue strikes, as a rule nothing moves before.
        motions = {words: given for words, given in motions.items() if np.any(np.array(given[0], dtype=float))}
    for words, (vectors, unit) in motions.items():
        columns |= _vector_columns(words, vectors, unit)
    numbers = zip(*columns.values(), strict=True)
    rows = [
        {"colour": colour, "id": ball.id, "numbers": row}
        for colour, ball, row in zip(colours[:MOST_BALLS], shown, numbers, strict=True)
    ]
    return {"heads": list(columns), "rows": rows, "count": len(balls), "left": len(balls) - len(shown)}


def _vector_columns(words: str, vectors: Sequence[Vector | None], unit: str | None) -> dict[str, list[str]]:
    """Give a column for each component of some vectors."""
    numbers = np.array(vectors, dtype=float)
    return {
        head(f"{words}{axis}", unit): column(numbers[:, place]) for place, axis in enumerate("xyz"[: numbers.shape[1]])
    }


def _friction_columns(scenario: Scenario) -> dict[str, list[str]]:
    """Give what balls have of their own in place of the friction that the laws say of all."""
    balls = scenario.expanded().to_dict()["balls"][:MOST_BALLS]
    own = {key: [ball.get(key) for ball in balls] for key in FRICTIONS}
    return {
        key.replace("_", " "): ["" if value is None else short(value) for value in values]
        for key, values in own.items()
        if any(value is not None for value in values)
    }


def law_rows(scenario: Scenario) -> list[Row]:
    """Give the laws of motion and of contact, those that the scenario leaves out too."""
    values = scenario.expanded().to_dict()
    physics: Values = values.get("physics", {})
    elastic, cushion_laws, own = {"law": "elastic"}, choices("BallCushion"), physics.get("cushions", {})
    rows = [_law_row("between events", physics.get("flight", {"law": "free"}), choices("Flight"), scenario.units)]
    rows += [_law_row("two balls", physics.get("ball_ball", elastic), choices("BallBall"), scenario.units)]
    rows += [_law_row("ball and cushion", physics.get("ball_cushion", elastic), cushion_laws, scenario.units)]
    rows += [_law_row(f"at {name}", law, cushion_laws, scenario.units) for name, law in own.items()]
    clusters, collapses = choices("Cluster"), choices("Collapse")
    if scenario.is_on_cloth:
        frictions = {**FRICTIONS, **values.get("ball_defaults", {})}
        cloth = ", ".join(f"{key.replace('_', ' ')} {short(frictions[key])}" for key in FRICTIONS)
        rows.append(Row("on the cloth", cloth, "Of balls that say nothing else."))
        cluster = physics.get("cluster", "hertz")
        return [*rows, Row("several at once", cluster, clusters[cluster])]
    for name, key, meanings in (("several at once", "cluster", clusters), ("without end", "collapse", collapses)):
        word = physics.get(key, next(iter(meanings)))
        rows.append(Row(name, word, meanings.get(word, "")))
    return rows


def _law_row(name: str, law: Values, meanings: Mapping[str, str], units: Mapping[str, str]) -> Row:
    parts = [law["law"]]
    for key, value in law.items():
        if key != "law":
            unit = "acceleration" if key == "gravity" else "length" if key == "min_hop" else key
            parts.append(f"{key.replace('_', ' ')} {with_unit(_setting(value), unit_of(units, unit))}")
    return Row(name, ", ".join(parts), meanings.get(law["law"], ""))


def _setting(value: Any) -> str:
    """Give a value of a law: a number, a word, a list of numbers, or several of them by their names."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, Mapping):
        return f"({', '.join(f'{key} {_setting(item)}' for key, item in value.items())})"
    return point(value) if isinstance(value, list) else value if isinstance(value, str) else short(value)


def shot_rows(scenario: Scenario) -> list[Row]:
    """Give the rack, the shot and the cue that strikes it; none where there is no shot and no rack."""
    values = scenario.to_dict()
    rack, shot = values.get("rack", {}), values.get("shot", {})
    cue = scenario.expanded().to_dict().get("cue", {}) if shot else {}
    rows = [Row(key if key != "game" else "rack", _setting(value)) for key, value in rack.items()]
    rows += [Row("struck ball", shot.get("cue_ball", "cue"))] if shot else []
    rows += [_number_row(key, value, scenario.units) for key, value in shot.items() if key != "cue_ball"]
    return rows + [_number_row(f"cue {key}", value, scenario.units) for key, value in cue.items()]


def _number_row(key: str, value: Any, units: Mapping[str, str]) -> Row:
    """Give a number of the shot or the cue with its unit."""
    quantity = next((unit for word, unit in SHOT_UNITS.items() if word in key), "")
    name = key.removesuffix("_deg").replace("_", " ")
    text = with_unit(_setting(value), unit_of(units, quantity))
    return Row(name, f"{text}°" if key.endswith("_deg") else text)


def method_rows(scenario: Scenario) -> list[Row]:
    """Give the method, and how it reads what can be read in several ways."""
    method: Values = scenario.to_dict().get("method", {"kind": "exact"})
    rows = [Row("method", method["kind"], choices("Method")[method["kind"]])]
    if method["kind"] != "stepped":
        return rows
    rows.append(Row("time step", with_unit(short(method["dt"]), scenario.units.get("time"))))
    if "steps" in method:
        rows.append(Row("steps", exact(method["steps"])))
    for key, meanings in (
        ("after_hit", choices("AfterHit")),
        ("normal", choices("NormalTaken")),
        ("last_step", choices("LastStep")),
    ):
        word = method.get(key, next(iter(meanings)))
        rows.append(Row(key.replace("_", " "), word, meanings.get(word, "")))
    return rows


def limit_rows(scenario: Scenario) -> list[Row]:
    """Give when a run ends and what it keeps."""
    values = scenario.to_dict()
    rows = []
    if "duration" in values:
        rows.append(Row("duration", with_unit(short(values["duration"]), scenario.units.get("time"))))
    if "collisions" in values:
        rows.append(Row("collisions", exact(values["collisions"]), "it ends after so many"))
    if "duration" not in values and "collisions" not in values:
        rows.append(Row("duration", "none", "it goes on until everything rests"))
    if "max_events" in values:
        rows.append(Row("most events", exact(values["max_events"])))
    elif "collisions" not in values:
        rows.append(Row("most events", exact(DEFAULT_EVENTS), "the default"))
    record = values.get("record", "all")
    return [*rows, Row("record", record, choices("Record")[record])]
