"""What pooltool saved, as a scenario: its tables, balls, cue and laws in Carom's keys.

pooltool itself is not needed. What only pooltool's window draws (models, ball sets, orientations, lamps, the cue's
brand) is left out; whatever else has no counterpart is an error, or stands in the scenario's description.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom.errors import ScenarioError
from carom.files import read_text
from carom.pooltool.laws import DEFAULT_RESOLVER, physics_of_resolver
from carom.pooltool.table import table_of
from carom.pooltool.values import at

if TYPE_CHECKING:
    from carom.scenario import Scenario

__all__ = ["DEFAULT_RESOLVER", "physics_of_resolver", "read_system", "scenario_of_system"]

POCKETED = 4
"""pooltool's number for a ball in a pocket."""

SAME_HEIGHT = 1e-9
"""A ball whose centre is this near to its radius above the cloth lies on it, in metres."""


def read_system(source: str | os.PathLike[str], *, resolver: Mapping[str, Any] | None = None) -> Scenario:
    """Read a system that pooltool 0.6 saved with ``system.save("shot.json")``.

    Of a system that was simulated the shot is read as it began.

    Parameters
    ----------
    source : str or path-like
        The ``.json`` file.
    resolver : mapping, optional
        The laws, with the keys of pooltool's ``resolver.yaml``, as `yaml.safe_load` gives them; absent: pooltool's
        own defaults.

    Returns
    -------
    Scenario
        The same table, balls, laws and shot; its description says what was left out.

    Raises
    ------
    ScenarioError
        When the file is no such system, or holds something that Carom has no counterpart for; the places are those of
        pooltool's file.
    """
    from carom.scenario import Scenario

    path = Path(source)
    if path.suffix.lower() != ".json":
        raise ScenarioError(f"{path}: in pooltool, save the system as .json")
    try:
        system = json.loads(read_text(path, ScenarioError, "a pooltool system"))
    except json.JSONDecodeError as error:
        raise ScenarioError(f"{path}: line {error.lineno}: {error.msg}") from None
    return Scenario.from_dict(scenario_of_system(system, resolver=resolver))


def scenario_of_system(system: Mapping[str, Any], *, resolver: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Turn the contents of a saved system into the keys of a scenario; see `read_system`."""
    notes: list[str] = []
    balls = _balls_on_table(system, notes)
    laws = {**DEFAULT_RESOLVER, **(resolver or {})}
    scenario: dict[str, Any] = {
        "title": "A shot of pooltool",
        "description": "",
        "table": table_of(at(system, "table")),
        "cue": _cue(at(system, "cue"), at(laws, "stick_ball")),
        "physics": physics_of_resolver(laws, {name: ball["params"] for name, ball in balls.items()}),
        **_balls(balls),
    }
    shot = _shot(system, balls, notes)
    if shot is not None:
        scenario["shot"] = shot
    scenario["description"] = " ".join(["Read from a system of pooltool.", *notes])
    return scenario


def _balls_on_table(system: Mapping[str, Any], notes: list[str]) -> dict[str, dict[str, Any]]:
    """Give the state with which each ball begins, and its parameters; those in pockets are noted."""
    events = at(system, "events")
    time = at(system, "t")
    if events:
        notes.append(f"It had been simulated; its {len(events)} events are left out.")
    elif time != 0:
        raise ScenarioError([("t", f"must be 0, as nothing was simulated, got {time}")])
    states = {name: _first_state(ball, simulated=bool(events)) for name, ball in at(system, "balls").items()}
    pocketed = sorted(name for name, state in states.items() if state["s"] == POCKETED)
    if pocketed:
        notes.append(f"In pockets, and left out: {', '.join(pocketed)}.")
    return {
        name: {"state": state, "params": at(system, f"balls.{name}.params")}
        for name, state in states.items()
        if state["s"] != POCKETED
    }


def _first_state(ball: Mapping[str, Any], *, simulated: bool) -> Mapping[str, Any]:
    states = at(ball, "history.states") if simulated else [at(ball, "state")]
    if not states:
        raise ScenarioError([(f"balls.{ball['id']}.history", "must hold how the ball began, as there are events")])
    state: Mapping[str, Any] = states[0]
    return state


def _balls(balls: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Give `ball_defaults`, what all balls have in common, and `balls`."""
    written = {name: _parameters(ball["params"]) for name, ball in balls.items()}
    first = next(iter(written.values()), {})
    common = {key: value for key, value in first.items() if all(values[key] == value for values in written.values())}
    entries = [
        {"id": name, **_motion(name, ball), **{key: written[name][key] for key in first if key not in common}}
        for name, ball in balls.items()
    ]
    return {"ball_defaults": common, "balls": entries}


def _parameters(params: Mapping[str, float]) -> dict[str, float]:
    return {
        "radius": at(params, "R"),
        "mass": at(params, "m"),
        "sliding_friction": at(params, "u_s"),
        "rolling_friction": at(params, "u_r"),
        # Its spinning friction is a length, u_sp = u_sp_proportionality R, and the spin's decay 5 u_sp g / (2 R).
        "spin_decay": 2.5 * at(params, "u_sp_proportionality") * at(params, "g"),
    }


def _motion(name: str, ball: Mapping[str, Any]) -> dict[str, Any]:
    (x, y, z), velocity, spin = at(ball, "state.rvw")
    if not math.isfinite(x + y):
        raise ScenarioError([(f"balls.{name}.state.rvw", "has no place on the table")])
    if abs(z - ball["params"]["R"]) > SAME_HEIGHT or velocity[2] != 0:
        raise ScenarioError([(f"balls.{name}.state.rvw", "must lie on the cloth")])
    motion = {"velocity": velocity[:2], "spin": spin}
    return {"position": [x, y], **{key: value for key, value in motion.items() if any(value)}}


def _shot(system: Mapping[str, Any], balls: Mapping[str, Mapping[str, Any]], notes: list[str]) -> dict[str, Any] | None:
    """Give the shot; as in pooltool there is none while a ball moves, nor with a cue that does not."""
    cue = at(system, "cue")
    moving = [name for name, ball in balls.items() if any(map(any, ball["state"]["rvw"][1:]))]
    if moving:
        notes.append(f"No shot, as {', '.join(moving)} moved already.")
        return None
    if at(cue, "V0") == 0:
        notes.append("No shot, as the cue's speed was 0.")
        return None
    if at(cue, "cue_ball_id") not in balls:
        raise ScenarioError([("cue.cue_ball_id", f"{cue['cue_ball_id']!r} must be a ball on the table")])
    return {
        "cue_ball": cue["cue_ball_id"],
        "V0": cue["V0"],
        "phi_deg": at(cue, "phi"),
        "theta_deg": at(cue, "theta"),
        "a": at(cue, "a"),
        "b": at(cue, "b"),
    }


def _cue(cue: Mapping[str, Any], law: Mapping[str, Any]) -> dict[str, Any]:
    if law.get("english_throttle", 1.0) != 1.0:
        raise ScenarioError([("stick_ball.english_throttle", "must be 1: a stroke's spin follows from its point")])
    squirt = law.get("squirt_throttle", 1.0)
    if squirt not in (0.0, 1.0):
        raise ScenarioError([("stick_ball.squirt_throttle", "must be 1 or 0: squirt follows from the end's mass")])
    return {
        "mass": at(cue, "specs.M"),
        "tip_radius": at(cue, "specs.tip_radius"),
        "end_mass": squirt * at(cue, "specs.end_mass"),
        "miscue_offset": 1.0,
        "length": at(cue, "specs.length"),
        "shaft_radius": at(cue, "specs.shaft_radius_at_tip"),
        "butt_radius": at(cue, "specs.shaft_radius_at_butt"),
    }
