"""Writes reference/pooltool/shots.json anew: shots that pooltool played, for tests without pooltool.

    .venv/bin/python benches/pooltool/reference.py

reference/pooltool/README.md says what is in it.
"""

import json
import tempfile
from collections import Counter
from pathlib import Path

import pooltool_process
import shots
from agreement import OWN, TILTED, TIME, place_difference, time_difference

from carom.pooltool import physics_of_resolver, scenario_of_system

TARGET = Path(__file__).parents[2] / "reference" / "pooltool" / "shots.json"

KINDS = {
    "stick_ball": "cue_ball",
    "ball_ball": "ball_ball",
    "ball_linear_cushion": "ball_cushion",
    "ball_circular_cushion": "ball_cushion",
    "ball_pocket": "ball_pocket",
    "sliding_rolling": "slide_to_roll",
    "rolling_stationary": "roll_to_rest",
    "rolling_spinning": "roll_to_spin",
    "spinning_stationary": "spin_to_rest",
}
"""pooltool's kinds of events in Carom's words."""

SPREAD = {0: 5e-5, 1: 5e-5, 2: 1e-3}
"""How far balls may end elsewhere with a tenth of the spacer, in m, by the number of ball-ball contacts."""

SPACERS = 1e-6, 1e-7, 1e-8
"""How far balls are moved apart at a contact, in m: pooltool's own, and finer."""

EACH, KEPT = 24, 3
"""Shots tried and shots kept for each pair of laws."""


def main():
    with pooltool_process.started() as pooltool:
        example, *played = [entry(pooltool, shot) for shot in [shots.EXAMPLE, *shots.two_ball_shots(EACH, seed=11)]]
        kept = [example, *varied(filter(None, played))]
        kept += [break_entry(pooltool, shot) for shot in shots.breaks(4)]
        base = base_of(pooltool)
    values = {"about": ABOUT, **base, "shots": kept}
    TARGET.parent.mkdir(exist_ok=True)
    TARGET.write_text(formatted(values), encoding="utf-8")
    print(f"{len(kept)} shots, {TARGET.stat().st_size} bytes")
    print(Counter(tag for shot in kept for tag in shot["shows"]))


ABOUT = {
    "what": "shots that pooltool 0.6.0 played; README.md beside this file says what each key means",
    "command": ".venv/bin/python benches/pooltool/reference.py",
    "environment": "benches/pooltool/requirements.txt",
}


def base_of(pooltool):
    """What all shots have in common, and the laws by name, in pooltool's words and in Carom's."""
    with tempfile.TemporaryDirectory() as folder:
        path = pooltool.ask("system", shots.EXAMPLE, path=f"{folder}/shot.json")
        system = json.loads(Path(path).read_text(encoding="utf-8"))
    scenario = scenario_of_system(system)
    params = {name: ball["params"] for name, ball in system["balls"].items()}
    resolvers = {laws: shots.resolver_of(laws) for laws in shots.LAWS}
    return {
        "pooltool_ball": params["cue"],
        "scenario": {key: scenario[key] for key in ("table", "cue", "ball_defaults")},
        "laws": {
            laws: {"pooltool": resolver, "physics": physics_of_resolver(resolver, params)}
            for laws, resolver in resolvers.items()
        },
    }


def entry(pooltool, shot):
    """Play a shot with three spacers; None where that is no measure for anyone."""
    plays = [pooltool.ask("play", shot, spacer=spacer) for spacer in SPACERS]
    played, finer, _ = plays
    if any(play["faults"] or kinds(play) != kinds(played) for play in plays):
        return None
    contacts = sum(event[1] == "ball_ball" for event in played["events"])
    spread = place_difference(played, finer)
    if spread > SPREAD.get(contacts, -1) or (contacts and time_difference(played, finer) > OWN * TIME):
        return None
    return {
        **described(shot, played),
        "shows": sorted(tags(shot, played["events"])),
        "events": [in_words(event) for event in played["events"]],
        "end": {name: place or pocket_of(name, played["events"]) for name, place in played["end"].items()},
        "spread": float(f"{spread:.1e}"),
        "valid_until": tilted_from(shot, played["events"]),
        "limit": {"times": limit_of_times(plays), "end": limit_of_ends(plays)},
    }


def break_entry(pooltool, shot):
    """The first events of a break, up to the tenth contact: what follows is chaos."""
    plays = [pooltool.ask("play", shot, spacer=spacer) for spacer in SPACERS]
    for play in plays:
        play["events"] = play["events"][: tenth_contact(play["events"])]
        assert not play["faults"] and kinds(play) == kinds(plays[0]), shot
    return {
        **described(shot, plays[0]),
        "shows": ["break"],
        "events": [in_words(event) for event in plays[0]["events"]],
        "limit": {"times": limit_of_times(plays)},
    }


def limit_of_times(plays):
    """Each event's time without a spacer, and how well it is known."""
    return [limit([[event[0]] for event in events]) for events in zip(*(play["events"] for play in plays), strict=True)]


def limit_of_ends(plays):
    """Where each ball ends without a spacer, and how well that is known; balls in pockets are not among them."""
    return {name: limit([play["end"][name] for play in plays]) for name, place in plays[0]["end"].items() if place}


def limit(values):
    """Carry values at the three spacers on to a spacer of zero; last comes by how much the coarser two would miss it.

    Each spacer is a tenth of the one before, and values are straight lines in it, nearly.
    """
    coarse, finer, finest = values
    limits = [y + (y - x) / 9 for x, y in zip(finer, finest, strict=True)]
    missed = max(abs(y + (y - x) / 9 - end) for x, y, end in zip(coarse, finer, limits, strict=True))
    return [*limits, float(f"{missed:.0e}")]


def tenth_contact(events):
    contacts = [k for k, event in enumerate(events) if event[1] == "ball_ball"]
    return contacts[9] + 1


def described(shot, played):
    cue = shot["cue"]
    return {
        "name": shot["name"],
        "laws": shot["laws"],
        "balls": [{"id": name, "position": place} for name, place in played["balls"].items()],
        "shot": {"V0": cue["V0"], "phi_deg": cue["phi"], "theta_deg": cue["theta"], "a": cue["a"], "b": cue["b"]},
    }


def kinds(played):
    return [event[1:] for event in played["events"]]


def in_words(event):
    """An event as time, kind, balls; then the cushion or pocket in pooltool's naming."""
    time, kind, *ids = event
    return [time, KINDS[kind], *(ids[1:] if kind == "stick_ball" else ids)]


def pocket_of(name, events):
    (pocket,) = [ids[1] for _, kind, *ids in events if kind == "ball_pocket" and ids[0] == name]
    return pocket


def tilted_from(shot, events):
    """When pooltool's blow first has the wrong tilt; None where it never has."""
    if shots.LAWS[shot["laws"]][1] not in TILTED:
        return None
    return next((event[0] for event in events if event[1] == "ball_circular_cushion"), None)


def tags(shot, events):
    """What a shot shows: its contacts, and how the ball is struck."""
    counts = Counter(event[1] for event in events)
    cushions = counts["ball_linear_cushion"]
    yield f"{counts['ball_ball']} ball contacts"
    yield "no cushion" if cushions == 0 else "one cushion" if cushions == 1 else "cushions"
    yield from (word for word, kind in (("jaw", "ball_circular_cushion"), ("pocket", "ball_pocket")) if counts[kind])
    cue = shot["cue"]
    yield "elevated" if cue["theta"] else "level"
    yield "draw" if cue["b"] < -0.1 else "follow" if cue["b"] > 0.1 else "stun"
    if abs(cue["a"]) > 0.1:
        yield "side"
    kinds_so_far = [event[1] for event in events]
    if "ball_ball" in kinds_so_far and "ball_linear_cushion" in kinds_so_far[: kinds_so_far.index("ball_ball")]:
        yield "cushion first"


def varied(entries):
    """Keep some shots of each pair of laws: in turn the one that shows most of what was rarest so far."""
    seen, left, kept = Counter(), list(entries), []
    for laws in shots.LAWS:
        mine = [shot for shot in left if shot["laws"] == laws]
        for _ in range(min(KEPT, len(mine))):
            best = max(mine, key=lambda shot: sum(1 / (1 + seen[tag]) ** 2 for tag in shot["shows"]))
            mine.remove(best)
            seen.update(best["shows"])
            kept.append(best)
    return kept


def formatted(values):
    """JSON with one shot and one pair of laws a line."""
    parts = []
    for key, value in values.items():
        if key == "shots":
            body = "[\n" + ",\n".join(f"  {json.dumps(shot)}" for shot in value) + "\n ]"
        elif key == "laws":
            rows = (f"  {json.dumps(name)}: {json.dumps(laws)}" for name, laws in value.items())
            body = "{\n" + ",\n".join(rows) + "\n }"
        else:
            body = json.dumps(value)
        parts.append(f" {json.dumps(key)}: {body}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


if __name__ == "__main__":
    main()
