"""What a scenario says, as rows to read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from carom.colours import ball_colours
from carom.report.rows import Row
from carom.report.text import column, counted, exact, head, listed, point, short, with_unit
from carom.report.words import choices
from carom.units import unit_of

if TYPE_CHECKING:
    from carom.scenario import Scenario

MOST_PARTS = 12
MOST_BALLS = 100
DEFAULT_EVENTS = 10_000_000

Values = Mapping[str, Any]


def table_rows(scenario: Scenario) -> list[Row]:
    """Give the table's shape, its sizes, and the pieces and obstacles that it has."""
    table: Values = scenario.to_dict()["table"]
    length = scenario.units.get("length")
    rows = [Row("shape", table["shape"])]
    sizes = {name: value for name, value in table.items() if name not in ("shape", "pieces", "obstacles")}
    # A whole number counts something, and is no length.
    rows += [
        Row(name, exact(value) if isinstance(value, int) else with_unit(short(value), length))
        for name, value in sizes.items()
    ]
    if "pieces" in table:
        x_min, y_min, x_max, y_max = scenario.outline()["bounds"]
        extent = f"{short(x_max - x_min)} × {short(y_max - y_min)}"
        rows.append(Row("extent", with_unit(extent, length)))
    return rows + _part_rows("pieces", table.get("pieces", [])) + _part_rows("obstacles", table.get("obstacles", []))


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
    circle = f"{kind} around {point(shape['center'])}, radius {short(shape['radius'])}"
    return circle if kind == "circle" else f"{circle}, from {short(shape['from_deg'])}° to {short(shape['to_deg'])}°"


def ball_table(scenario: Scenario) -> dict[str, Any]:
    """Give the balls as a table: ``heads``, ``rows`` of colour, id and numbers, and how many are ``left`` out."""
    balls = scenario.balls
    colours = ball_colours([ball.id for ball in balls], [ball.color for ball in balls])
    shown = balls[:MOST_BALLS]
    places = [ball.position if ball.position is not None else (0.0, 0.0) for ball in shown]
    speed = unit_of(scenario.units, "speed")
    length, mass = scenario.units.get("length"), scenario.units.get("mass")
    columns = {
        head("radius", length): column([ball.radius or 0.0 for ball in shown]),
        head("mass", mass): column([1.0 if ball.mass is None else ball.mass for ball in shown]),
        head("x", length): column([place[0] for place in places]),
        head("y", length): column([place[1] for place in places]),
        head("velocity x", speed): column([ball.velocity[0] if ball.velocity else 0.0 for ball in shown]),
        head("velocity y", speed): column([ball.velocity[1] if ball.velocity else 0.0 for ball in shown]),
    }
    numbers = zip(*columns.values(), strict=True)
    rows = [
        {"colour": colour, "id": ball.id, "numbers": row}
        for colour, ball, row in zip(colours[:MOST_BALLS], shown, numbers, strict=True)
    ]
    return {"heads": list(columns), "rows": rows, "count": len(balls), "left": len(balls) - len(shown)}


def law_rows(scenario: Scenario) -> list[Row]:
    """Give the laws of motion and of contact, those that the scenario leaves out too."""
    physics: Values = scenario.to_dict().get("physics", {})
    elastic, cushion_laws, own = {"law": "elastic"}, choices("BallCushion"), physics.get("cushions", {})
    rows = [_law_row("between events", physics.get("flight", {"law": "free"}), choices("Flight"), scenario.units)]
    rows += [_law_row("two balls", physics.get("ball_ball", elastic), choices("BallBall"), scenario.units)]
    rows += [_law_row("ball and cushion", physics.get("ball_cushion", elastic), cushion_laws, scenario.units)]
    rows += [_law_row(f"at {name}", law, cushion_laws, scenario.units) for name, law in own.items()]
    for name, key, meanings in (
        ("several at once", "cluster", choices("Cluster")),
        ("without end", "collapse", choices("Collapse")),
    ):
        word = physics.get(key, next(iter(meanings)))
        rows.append(Row(name, word, meanings.get(word, "")))
    return rows


def _law_row(name: str, law: Values, meanings: Mapping[str, str], units: Mapping[str, str]) -> Row:
    parts = [law["law"]]
    for key, value in law.items():
        if key != "law":
            text = point(value) if isinstance(value, list) else short(value)
            parts.append(f"{key} {with_unit(text, unit_of(units, key))}")
    return Row(name, ", ".join(parts), meanings.get(law["law"], ""))


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
