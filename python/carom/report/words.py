"""What statuses, events, diagnostics and laws mean, in a few words each."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from carom import _engine

STATUSES = {
    "time_limit": "Ran to its time limit",
    "collision_limit": "Ended after the number of collisions asked for",
    "stopped": "Stopped where it was asked to",
    "at_rest": "Ended with everything at rest",
    "collapsed": "Ended early: contacts followed each other without end",
    "event_limit": "Ended at its limit of events",
    "interrupted": "Was interrupted",
    "miscue": "Ended at once: the tip of the cue slipped off the ball",
}
"""How a run ended, by its status."""

EARLY = ("collapsed", "event_limit", "interrupted", "miscue")
"""The statuses of runs that may have ended before what they were to show."""

KINDS = {
    "ball_ball": "two balls hit each other",
    "ball_cushion": "a ball hit a cushion or an obstacle",
    "hold": "a ball whose hops on a cushion had become too small to follow was held there",
    "release": "a held ball went on its way again",
    "cue_ball": "the cue struck a ball",
    "miscue": "the tip of the cue slipped off the ball",
    "slide_to_roll": "a ball that slid on the cloth began to roll",
    "slide_to_spin": "a ball that slid stopped, and spun on in place",
    "slide_to_rest": "a ball that slid stopped",
    "roll_to_spin": "a ball that rolled stopped, and spun on in place",
    "roll_to_rest": "a ball that rolled stopped",
    "spin_to_rest": "a ball that spun in place stopped",
    "ball_cloth": "a ball fell onto the cloth, and bounced or stayed",
    "ball_pocket": "a ball dropped into a pocket",
    "off_table": "a ball flew over a cushion, off the table",
}
"""Events, by kind."""

DIAGNOSTICS = {
    "predictions": "how often a ball's next event was computed",
    "stale": "pending events dropped, since the other ball had meanwhile changed its course",
    "deepest_overlap": "how deep two balls ever were in each other; zero up to round-off in an exact run",
    "clusters": "contacts of several balls at one instant, resolved together",
    "cluster_passes": "passes made to resolve them",
    "forced_clusters": "clusters that came to an end only by a last pass without restitution",
    "initial_energy": "at the start: kinetic, and potential in a field or of height; after the strike of a cue",
    "final_energy": "at the end",
    "energy_loss": "what the laws of contact took away, and the cloth",
    "energy_error": "the largest change in one event that its law does not account for: round-off",
    "energy_gain": "the largest energy that a cluster gained; laws never give any, so round-off",
    "momentum_error": "the largest change of momentum in one ball-ball event: round-off",
    "energy_drift": "how far energy and losses together ever were from the energy at the start",
    "lost_time": "time that balls waited at contacts for the end of a step, over all balls; zero in an exact run",
    "corrections": "states that the engine corrected: none, as it never does",
}
"""What a run measures of itself, by the name in `Run.diagnostics`."""

QUANTITIES = {
    "deepest_overlap": "length",
    "initial_energy": "energy",
    "final_energy": "energy",
    "energy_loss": "energy",
    "energy_error": "energy",
    "energy_gain": "energy",
    "momentum_error": "momentum",
    "energy_drift": "energy",
    "lost_time": "time",
}
"""What some of them are measured in."""


@cache
def choices(kind: str) -> dict[str, str]:
    """Give what may be chosen of a kind in the schema, each with the first sentence said of it, the default first.

    Examples
    --------
    >>> choices("BallBall")["elastic"]
    'The closing speed is reversed; no energy is lost.'
    """
    found = json.loads(_engine.schema())["$defs"][kind]["oneOf"]
    return {_word(choice): _first_sentence(choice["description"]) for choice in found}


def _word(choice: dict[str, Any]) -> str:
    """Give the word of a choice: its own, or that of its key ``law`` or ``kind``."""
    if "const" in choice:
        return str(choice["const"])
    keys = choice["properties"]
    return str(keys["law" if "law" in keys else "kind"]["const"])


def _first_sentence(text: str) -> str:
    return text.replace("\n", " ").replace("`", "").split(". ")[0].rstrip(".") + "."
