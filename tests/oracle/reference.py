"""The midterm scenario, and the numbers the two oracles give for it.

    python -m tests.oracle.reference

run from the folder that holds `tests`, writes `midterm_reference.json` (the exact run: 50 digits, computed with 80) and
`stepped_readings.json` (the fixed-step run with dt = 0.03 in each of its readings, in doubles that read back exactly)
beside this file, and prints the latter's event counts and final states.
"""

import itertools
import json
import pathlib

from . import exact, stepped

DIGITS, WORKING_DIGITS = 50, 80
DT = 0.03
FOLDER = pathlib.Path(__file__).parent
EXACT_FILE, STEPPED_FILE = FOLDER / "midterm_reference.json", FOLDER / "stepped_readings.json"

MIDTERM = {
    "format": 1,
    "title": "Two balls on an L x 2L table",
    "duration": 5.0,
    "table": {"shape": "rectangle", "width": 1.0, "length": 2.0},
    "physics": {"ball_ball": {"law": "elastic"}, "ball_cushion": {"law": "damping", "factor": 0.8}},
    "ball_defaults": {"radius": 0.075},
    "balls": [
        {"id": "red", "position": [0.1, 0.1], "velocity": [3.0, 4.0]},
        {"id": "blue", "position": [0.5, 1.0]},
    ],
}


def exact_reference():
    """The exact midterm as a dict of strings of 50 digits. Masses are 1."""
    run = exact.simulate(MIDTERM, dps=WORKING_DIGITS)
    balls = zip(run.system.ids, run.positions, run.velocities, strict=True)
    return {
        "about": "exact midterm; inputs are the exact values of their doubles, all balls of mass 1",
        "command": "python -m tests.oracle.reference",
        "digits": DIGITS,
        "scenario": MIDTERM,
        "events": [_event(run, event) for event in run.events],
        "final": {
            "time": _text(run, run.end_time),
            "energy": _text(run, run.energy()),
            "balls": {key: {"position": _texts(run, x), "velocity": _texts(run, v)} for key, x, v in balls},
        },
    }


def _event(run, event):
    ids = run.system.ids
    return {
        "index": event.index,
        "time": _text(run, event.time),
        "kind": event.kind,
        "ball_a": ids[event.ball_a],
        "ball_b": None if event.ball_b is None else ids[event.ball_b],
        "cushion": event.cushion_id,
        "point": _texts(run, event.point),
        "normal": _texts(run, event.normal),
        "closing_speed": _text(run, event.closing_speed),
        "impulse": _text(run, event.impulse),
    }


def _text(run, number):
    return run.system.ctx.nstr(number, DIGITS)


def _texts(run, pair):
    return [_text(run, number) for number in pair]


def readings():
    """Every combination of the stepped method's options, and two given numbers of steps."""
    for after_hit, normal in itertools.product(("wait", "restart"), ("before", "contact")):
        for last_step in ("short", "full"):
            yield {"after_hit": after_hit, "normal": normal, "last_step": last_step}
        for steps in (166, 167):
            yield {"after_hit": after_hit, "normal": normal, "steps": steps}


def stepped_reference():
    """The stepped midterm in each reading."""
    rows = []
    for reading in readings():
        run = stepped.simulate(MIDTERM, DT, **reading)
        rows.append(
            {
                "reading": reading,
                "steps": run.steps[-1].step,
                "end_time": run.end_time,
                "event_count": len(run.events),
                "event_times": [event.time for event in run.events],
                "positions": run.positions,
                "velocities": run.velocities,
                "energy": run.energy(),
                "lost_time": run.lost_time,
                "deepest_overlap": run.deepest_overlap,
            }
        )
    return {
        "about": "stepped midterm; positions and velocities are those of red, then blue",
        "command": "python -m tests.oracle.reference",
        "dt": DT,
        "scenario": MIDTERM,
        "readings": rows,
    }


def main():
    table = stepped_reference()
    EXACT_FILE.write_text(json.dumps(exact_reference(), indent=1) + "\n")
    STEPPED_FILE.write_text(json.dumps(table, indent=1) + "\n")
    for row in table["readings"]:
        print(*row["reading"].values(), f"{row['event_count']} events, {row['steps']} steps, t = {row['end_time']}")
        print("   ", *row["positions"], *row["velocities"])


if __name__ == "__main__":
    main()
