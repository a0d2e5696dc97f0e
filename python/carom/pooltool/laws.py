"""pooltool's laws, by its names, and the parameters that its balls carry for them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from carom.errors import ScenarioError
from carom.pooltool.values import at

DEFAULT_RESOLVER: Mapping[str, Any] = {
    "ball_ball": {
        "model": "frictional_inelastic",
        "friction": {"model": "alciatore", "a": 0.009951, "b": 0.108, "c": 1.088},
    },
    "ball_linear_cushion": {"model": "stronge_compliant", "omega_ratio": 1.8},
    "ball_circular_cushion": {"model": "stronge_compliant", "omega_ratio": 1.8},
    "ball_pocket": {"model": "canonical"},
    "stick_ball": {"model": "instantaneous_point", "english_throttle": 1.0, "squirt_throttle": 1.0},
    "transition": {"model": "canonical"},
}
"""The laws of pooltool 0.6.0 where nobody changed them. A system's file holds none: they lie in ``resolver.yaml``."""

BALL_BALL = {"frictional_inelastic": "frictional", "frictional_mathavan": "mathavan_2014"}
"""pooltool's ball-ball laws with friction, and Carom's words for them."""

BALL_CUSHION = {
    "stronge_compliant": "stronge_compliant",
    "mathavan_2010": "mathavan_2010",
    "han_2005": "han_2005",
    "impulse_frictional_inelastic": "frictional",
}
"""pooltool's cushion laws with friction, and Carom's words for them."""

Params = Mapping[str, Mapping[str, float]]


def physics_of_resolver(resolver: Mapping[str, Any], params: Params) -> dict[str, Any]:
    """Turn pooltool's laws, and the parameters that its balls have for them, into the keys of `physics`.

    Parameters
    ----------
    resolver : mapping
        The keys of pooltool's ``resolver.yaml``.
    params : mapping of str to mapping
        The parameters of each ball by its id.

    Raises
    ------
    ScenarioError
        When a law is none of pooltool's, when rails and jaws have unlike ones, or when balls differ in a number of
        which Carom's law has one.
    """
    rails, jaws = at(resolver, "ball_linear_cushion"), at(resolver, "ball_circular_cushion")
    if rails != jaws:
        raise ScenarioError([("ball_circular_cushion", "must be the same law as ball_linear_cushion")])
    return {
        "flight": {"law": "cloth", "gravity": _common(params, "g"), "air": False},
        "ball_ball": _ball_ball(resolver, params),
        "ball_cushion": _ball_cushion(resolver, params),
    }


def _ball_ball(resolver: Mapping[str, Any], params: Params) -> dict[str, Any]:
    law, model = resolver["ball_ball"], at(resolver, "ball_ball", "model")
    if model == "frictionless_elastic":
        return {"law": "elastic"}
    if model not in BALL_BALL:
        raise _unknown("ball_ball.model", model, [*BALL_BALL, "frictionless_elastic"])
    friction = {**DEFAULT_RESOLVER["ball_ball"]["friction"], **law.get("friction", {})}
    if friction["model"] not in ("alciatore", "average"):
        raise _unknown("ball_ball.friction.model", friction["model"], ["alciatore", "average"])
    fit = {name: friction[name] for name in "abc"}
    averaged = friction["model"] == "average"
    normal = _common(params, "e_b")
    values = {
        "law": BALL_BALL[model],
        "normal": normal,
        "friction": _common(params, "u_b") if averaged else fit,
    }
    # pooltool takes the friction of the speed of parting, e, where the impulse is that of (1 + e)/2.
    return {**values, "cling": 2 * normal / (1 + normal)} if model == "frictional_inelastic" else values


def _ball_cushion(resolver: Mapping[str, Any], params: Params) -> dict[str, Any]:
    law, model = resolver["ball_linear_cushion"], at(resolver, "ball_linear_cushion", "model")
    if model == "unrealistic":
        normal = _common(params, "e_c") if law.get("restitution", False) else 1.0
        return {"law": "restitution", "normal": normal, "tangential": 1.0}
    if model not in BALL_CUSHION:
        raise _unknown("ball_linear_cushion.model", model, [*BALL_CUSHION, "unrealistic"])
    values = {"law": BALL_CUSHION[model], "normal": _common(params, "e_c"), "friction": _common(params, "f_c")}
    if model == "stronge_compliant":
        values["frequency_ratio"] = law.get("omega_ratio", 1.7)
    return values


def _common(params: Params, name: str) -> float:
    """Give a number that all balls share, as Carom's laws have one of it."""
    values = {ball: at(numbers, name) for ball, numbers in params.items()}
    if len(set(values.values())) != 1:
        each = ", ".join(f"{value} for {ball}" for ball, value in values.items())
        raise ScenarioError([(f"balls.*.params.{name}", f"must be the same for all balls, got {each or 'no ball'}")])
    common: float = next(iter(values.values()))
    return common


def _unknown(place: str, model: object, known: list[str]) -> ScenarioError:
    return ScenarioError([(place, f"must be one of {', '.join(known)}, got {model!r}")])
