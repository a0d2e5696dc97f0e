"""What statuses, diagnostics and laws mean, in a few words each."""

from __future__ import annotations

STATUSES = {
    "time_limit": "Ran to its time limit",
    "collision_limit": "Ended after the number of collisions asked for",
    "stopped": "Stopped where it was asked to",
    "at_rest": "Ended with everything at rest",
    "collapsed": "Ended early: contacts followed each other without end",
    "event_limit": "Ended at its limit of events",
    "interrupted": "Was interrupted",
}
"""How a run ended, by its status."""

EARLY = ("collapsed", "event_limit", "interrupted")
"""The statuses of runs that may have ended before what they were to show."""

KINDS = {
    "ball_ball": "two balls hit each other",
    "ball_cushion": "a ball hit a cushion or an obstacle",
    "hold": "a ball whose hops on a cushion had become too small to follow was held there",
    "release": "a held ball went on its way again",
}
"""Events, by kind."""

DIAGNOSTICS = {
    "predictions": "how often a ball's next event was computed",
    "stale": "pending events dropped, since the other ball had meanwhile changed its course",
    "deepest_overlap": "how deep two balls ever were in each other; zero up to round-off in an exact run",
    "clusters": "contacts of several balls at one instant, resolved together",
    "cluster_passes": "passes made to resolve them",
    "forced_clusters": "clusters that came to an end only by a last pass without restitution",
    "initial_energy": "at the start: kinetic, and potential in a field",
    "final_energy": "at the end",
    "energy_loss": "what the laws of contact took away",
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

FLIGHTS = {
    "free": "straight ahead at constant velocity",
    "field": "with the same constant acceleration for all balls",
}
BALL_LAWS = {
    "elastic": "the closing speed is reversed; no energy is lost",
    "restitution": "the balls part at this fraction of their closing speed",
}
CUSHION_LAWS = {
    "elastic": "as light by a mirror; no energy is lost",
    "restitution": "the speeds along the normal and along the cushion are multiplied by these factors",
    "damping": "the mirrored velocity times the factor",
}
CLUSTERS = {
    "reflections": "contacts at one instant are resolved together",
    "pairwise": "contacts at one instant are resolved one after the other",
}
COLLAPSES = {
    "stop": "contacts without end in a finite time end the run",
    "tc": "contacts that follow each other too fast lose no energy",
}
METHODS = {
    "exact": "from event to event, without a time step",
    "stepped": "the fixed-step scheme of programming courses",
}
READINGS = {
    "after_hit": {
        "wait": "a ball that hit something waits there for the end of the step",
        "restart": "all balls stop at the earliest hit, and a new step begins",
    },
    "normal": {
        "before": "taken before the balls move to their contact",
        "contact": "taken at the contact",
    },
    "last_step": {
        "short": "ends exactly at the duration",
        "full": "a full one, which may end past the duration",
    },
}
"""The readings of the stepped scheme, each with its default first."""

RECORDS = {
    "all": "events and flights, so that the state at any time can be asked for",
    "events": "events only",
    "none": "the end and the diagnostics only",
}
