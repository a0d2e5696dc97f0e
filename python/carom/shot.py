"""What came of a shot, as rules and planners ask it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from carom.errors import RunError
from carom.summary import block

if TYPE_CHECKING:
    from carom.run import Run

COLUMNS = ("time", "kind", "ball_a", "ball_b", "cushion", "pocket")


@dataclass(frozen=True, repr=False)
class ShotResult:
    """What came of a shot; every field is a plain value.

    Jaws and facings of pockets are cushions too. A contact of the cue ball with several balls at one instant counts in
    the order of the events.

    Attributes
    ----------
    cue_ball : str
        The ball that was struck.
    is_miscue : bool
        Whether the tip slipped off; then nothing else happened.
    first_ball_hit : str or None
        The ball that the cue ball hit first.
    first_hit_time : float or None
        When it hit it.
    balls_hit : tuple of str
        The balls that the cue ball hit, each once, in the order in which it first hit them.
    cushions_before_hits : tuple of int
        How many cushion contacts the cue ball had had before it first hit each of them.
    cushions_before, cushions_after : tuple of str
        The cushions that the cue ball touched before and after its first contact with a ball, one entry for each
        contact, in order; where it hit no ball, all of them are before.
    all_cushions_before, all_cushions_after : tuple of str
        The same for all balls together.
    balls_to_cushion : tuple of str
        The other balls that touched a cushion after that first contact, each once, in order.
    pocketed : tuple of str
        The balls that fell into pockets, in order, the cue ball too if it did.
    pockets : tuple of str
        The pocket of each of them.
    pocket_times : tuple of float
        The time of each of them.
    is_cue_ball_pocketed : bool
        Whether the cue ball was among them.
    off_table : tuple of str
        The balls that left the table, in order.
    """

    cue_ball: str
    is_miscue: bool
    first_ball_hit: str | None
    first_hit_time: float | None
    balls_hit: tuple[str, ...]
    cushions_before_hits: tuple[int, ...]
    cushions_before: tuple[str, ...]
    cushions_after: tuple[str, ...]
    all_cushions_before: tuple[str, ...]
    all_cushions_after: tuple[str, ...]
    balls_to_cushion: tuple[str, ...]
    pocketed: tuple[str, ...]
    pockets: tuple[str, ...]
    pocket_times: tuple[float, ...]
    is_cue_ball_pocketed: bool
    off_table: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """Give the fields as a new dict, tuples as lists, as JSON holds them."""
        return {name: list(value) if isinstance(value, tuple) else value for name, value in asdict(self).items()}

    def __repr__(self) -> str:
        first = "none" if self.first_ball_hit is None else f"{self.first_ball_hit} at {self.first_hit_time:.6g}"
        falls = zip(self.pocketed, self.pockets, self.pocket_times, strict=True)
        facts = [
            ("first ball", first),
            ("pocketed", ", ".join(f"{ball} in {pocket} at {time:.6g}" for ball, pocket, time in falls) or "none"),
            ("cushions of the cue ball", f"{len(self.cushions_before)} before, {len(self.cushions_after)} after"),
            ("of all balls", f"{len(self.all_cushions_before)} before, {len(self.all_cushions_after)} after"),
            ("balls to a cushion", ", ".join(self.balls_to_cushion) or "none"),
        ]
        facts += [("cue ball", "pocketed")] if self.is_cue_ball_pocketed else []
        facts += [("off the table", ", ".join(self.off_table))] if self.off_table else []
        return block(f"Shot at {self.cue_ball}", [("miscue", "the tip slipped off")] if self.is_miscue else facts)


class _Row(NamedTuple):
    """What is asked of an event."""

    time: float
    kind: str
    ball_a: str
    ball_b: str | None
    cushion: str | None
    pocket: str | None

    def other(self, ball: str) -> str | None:
        """Give what a ball hit, where this is a contact of two balls and it is one of them."""
        if self.kind != "ball_ball" or ball not in (self.ball_a, self.ball_b):
            return None
        return self.ball_b if self.ball_a == ball else self.ball_a


def shot_result(run: Run) -> ShotResult:
    """Tell what came of the shot of a run; see `Run.shot`."""
    shot = run.scenario.to_dict().get("shot")
    if shot is None:
        raise RunError("the scenario has no shot, so nothing can be told of one")
    cue_ball = shot.get("cue_ball", "cue")
    rows = list(_rows(run))
    hits = [(place, row) for place, row in enumerate(rows) if row.other(cue_ball) is not None]
    first, first_row = hits[0] if hits else (len(rows), None)
    before, after = _cushions(rows[:first]), _cushions(rows[first:])
    falls = [row for row in rows if row.kind == "ball_pocket"]
    first_hits: dict[str, int] = {}
    for place, row in hits:
        first_hits.setdefault(str(row.other(cue_ball)), place)
    return ShotResult(
        cue_ball=cue_ball,
        is_miscue=any(row.kind == "miscue" for row in rows),
        first_ball_hit=first_row and first_row.other(cue_ball),
        first_hit_time=first_row and first_row.time,
        balls_hit=tuple(first_hits),
        cushions_before_hits=tuple(len(_of(cue_ball, _cushions(rows[:place]))) for place in first_hits.values()),
        cushions_before=_of(cue_ball, before),
        cushions_after=_of(cue_ball, after),
        all_cushions_before=tuple(cushion for _, cushion in before),
        all_cushions_after=tuple(cushion for _, cushion in after),
        balls_to_cushion=tuple(dict.fromkeys(ball for ball, _ in after if ball != cue_ball)),
        pocketed=tuple(row.ball_a for row in falls),
        pockets=tuple(str(row.pocket) for row in falls),
        pocket_times=tuple(row.time for row in falls),
        is_cue_ball_pocketed=any(row.ball_a == cue_ball for row in falls),
        off_table=tuple(row.ball_a for row in rows if row.kind == "off_table"),
    )


def _rows(run: Run) -> Iterator[_Row]:
    return map(_Row, *(run.events[name].tolist() for name in COLUMNS))


def _cushions(rows: list[_Row]) -> list[tuple[str, str]]:
    """Give the contacts with cushions, as ball and cushion."""
    return [(row.ball_a, str(row.cushion)) for row in rows if row.kind == "ball_cushion"]


def _of(ball: str, contacts: list[tuple[str, str]]) -> tuple[str, ...]:
    return tuple(cushion for one, cushion in contacts if one == ball)
