"""What pooltool saved, as a scenario: its tables, balls, cue and laws in Carom's keys.

pooltool itself is not needed. What only pooltool's window draws (models, ball sets, orientations, lamps, the cue's
brand) is left out; whatever else has no counterpart is an error, or stands in the scenario's description.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping, Sequence
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
    laws = {**DEFAULT_RESOLVER, **(resolver or {})}
    try:
        return _scenario(system, laws)
    except (AttributeError, IndexError, KeyError, TypeError) as error:
        raise ScenarioError(f"no system as pooltool saves it: {type(error).__name__}: {error}") from error


def _scenario(system: Mapping[str, Any], laws: Mapping[str, Any]) -> dict[str, Any]:
    notes = ["Read from a system of pooltool."]
    states = _states_on_table(system, notes)
    params = {name: at(system, "balls", name, "params") for name in states}
    shot = _shot(system, states, notes)
    return {
        "title": "A shot of pooltool",
        "description": " ".join(notes),
        "table": table_of(at(system, "table")),
        "cue": _cue(system, laws),
        "physics": physics_of_resolver(laws, params),
        **_balls(system, states),
        **({"shot": shot} if shot else {}),
    }


def _states_on_table(system: Mapping[str, Any], notes: list[str]) -> dict[str, Mapping[str, Any]]:
    """Give the state with which each ball begins; those in pockets are noted."""
    events, time = at(system, "events"), at(system, "t")
    if events:
        notes.append(f"It had been simulated; its {len(events)} events are left out.")
    elif time != 0:
        raise ScenarioError([("t", f"must be 0, as nothing was simulated, got {time}")])
    states = {name: _first_state(system, name, simulated=bool(events)) for name in at(system, "balls")}
    pocketed = sorted(name for name, state in states.items() if state["s"] == POCKETED)
    if pocketed:
        notes.append(f"In pockets, and left out: {', '.join(pocketed)}.")
    return {name: state for name, state in states.items() if name not in pocketed}


def _first_state(system: Mapping[str, Any], name: str, *, simulated: bool) -> Mapping[str, Any]:
    ball = system["balls"][name]
    states: list[Mapping[str, Any]] = ball["history"]["states"] if simulated else [ball["state"]]
    if not states:
        raise ScenarioError([(f"balls.{name}.history", "must hold how the ball began, as there are events")])
    return states[0]


def _balls(system: Mapping[str, Any], states: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Give `ball_defaults`, what all balls have in common, and `balls`."""
    written = {name: _parameters(system, name) for name in states}
    first = next(iter(written.values()), {})
    common = {key: value for key, value in first.items() if all(values[key] == value for values in written.values())}
    own = {name: {key: value for key, value in values.items() if key not in common} for name, values in written.items()}
    entries = [
        {"id": name, **_motion(name, state["rvw"], written[name]["radius"]), **own[name]}
        for name, state in states.items()
    ]
    return {"ball_defaults": common, "balls": entries}


def _parameters(system: Mapping[str, Any], name: str) -> dict[str, float]:
    def parameter(key: str) -> float:
        value: float = at(system, "balls", name, "params", key)
        return value

    return {
        "radius": parameter("R"),
        "mass": parameter("m"),
        "sliding_friction": parameter("u_s"),
        "rolling_friction": parameter("u_r"),
        # Its spinning friction is a length, u_sp = u_sp_proportionality R, and the spin's decay 5 u_sp g / (2 R).
        "spin_decay": 2.5 * parameter("u_sp_proportionality") * parameter("g"),
    }


def _motion(name: str, rvw: Sequence[Sequence[float]], radius: float) -> dict[str, Any]:
    (x, y, z), velocity, spin = rvw
    if not math.isfinite(x + y):
        raise ScenarioError([(f"balls.{name}.state.rvw", "has no place on the table")])
    if abs(z - radius) > SAME_HEIGHT or velocity[2] != 0:
        raise ScenarioError([(f"balls.{name}.state.rvw", "must lie on the cloth")])
    motion = {"velocity": velocity[:2], "spin": spin}
    return {"position": [x, y], **{key: value for key, value in motion.items() if any(value)}}


def _shot(
    system: Mapping[str, Any], states: Mapping[str, Mapping[str, Any]], notes: list[str]
) -> dict[str, Any] | None:
    """Give the shot; as in pooltool there is none while a ball moves, nor with a cue that does not."""
    moving = [name for name, state in states.items() if any(map(any, state["rvw"][1:]))]
    if moving:
        notes.append(f"No shot, as {', '.join(moving)} moved already.")
        return None
    if at(system, "cue", "V0") == 0:
        notes.append("No shot, as the cue's speed was 0.")
        return None
    cue_ball = at(system, "cue", "cue_ball_id")
    if cue_ball not in states:
        raise ScenarioError([("cue.cue_ball_id", f"{cue_ball!r} must be a ball on the table")])
    return {
        "cue_ball": cue_ball,
        "V0": system["cue"]["V0"],
        "phi_deg": at(system, "cue", "phi"),
        "theta_deg": at(system, "cue", "theta"),
        "a": at(system, "cue", "a"),
        "b": at(system, "cue", "b"),
    }


def _cue(system: Mapping[str, Any], laws: Mapping[str, Any]) -> dict[str, Any]:
    stroke = laws["stick_ball"]
    if stroke.get("english_throttle", 1.0) != 1.0:
        raise ScenarioError([("stick_ball.english_throttle", "must be 1: a stroke's spin follows from its point")])
    squirt = stroke.get("squirt_throttle", 1.0)
    if squirt not in (0.0, 1.0):
        raise ScenarioError([("stick_ball.squirt_throttle", "must be 1 or 0: squirt follows from the end's mass")])
    return {
        "mass": at(system, "cue", "specs", "M"),
        "tip_radius": at(system, "cue", "specs", "tip_radius"),
        "end_mass": squirt * at(system, "cue", "specs", "end_mass"),
        "miscue_offset": 1.0,  # pooltool's tip never slips off
        "length": at(system, "cue", "specs", "length"),
        "shaft_radius": at(system, "cue", "specs", "shaft_radius_at_tip"),
        "butt_radius": at(system, "cue", "specs", "shaft_radius_at_butt"),
    }
