"""Where the events of two runs part."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from carom.events import Event
    from carom.run import Run

Sort = tuple[Any, ...]


@dataclass(frozen=True)
class Parting:
    """How long the events of two runs are the same, ball by ball, and the first one that is not.

    Events are the same that are of one kind, of the same balls and at the same cushion; their times may differ. The
    order of events without a common ball does not count.

    Attributes
    ----------
    same : int
        How many events come before any ball of theirs meets something else.
    ball : str or None
        The ball that first meets something else in `b` than in `a`; None where none does.
    event_a, event_b : Event or None
        What it meets in each; None where it meets nothing more before the earlier end.
    """

    same: int
    ball: str | None = None
    event_a: Event | None = None
    event_b: Event | None = None

    @property
    def event(self) -> Event | None:
        """The earlier of the two events; None where all are the same."""
        events = [event for event in (self.event_a, self.event_b) if event is not None]
        return min(events, key=lambda event: event.time, default=None)

    @property
    def time(self) -> float | None:
        """The time of the earlier of the two events; None where all are the same."""
        return None if self.event is None else self.event.time

    def speak(self, names: tuple[str, str]) -> str:
        """Put it into a line."""
        count = f"{self.same} {'is' if self.same == 1 else 'are'} the same"
        if self.event is None:
            return f"all {count} in kind, balls and cushion" if self.same else "there are none"
        told = [self._told(event) for event in (self.event_a, self.event_b)]
        verbs = [verb for verb, _ in told]
        # One verb is enough where it is the same.
        said = [what if verb == verbs[0] and number else f"{verb} {what}" for number, (verb, what) in enumerate(told)]
        parts = ", ".join(f"{words} in {name}" for words, name in zip(said, names, strict=True))
        return f"{count}; then {self.ball} {parts}"

    def _told(self, event: Event | None) -> tuple[str, str]:
        """Give what the ball does in an event, as a verb and the rest."""
        if event is None:
            return "meets", "nothing more"
        at = f"at t = {event.time:.6g}"
        others = " and ".join(name for name in event.balls if name != self.ball)
        if event.pocket is not None:
            return "falls", f"into {event.pocket} {at}"
        if others or event.kind == "ball_cushion":
            return "meets", f"{others or f'the {event.cushion} cushion'} {at}"
        if "_to_" in event.kind:
            return "goes", f"from {event.kind.replace('_to_', ' to ')} {at}"
        return "comes", f"to {event.kind} {at}"


def find_parting(a: Run, b: Run, balls: list[str], end: float) -> Parting:
    """Compare the events of two runs up to a time, ball by ball."""
    sequences = [_by_ball(run, end) for run in (a, b)]
    partings = []
    agreeing: dict[str, int] = {}
    for ball in balls:
        one, two = (sequence[ball] for sequence in sequences)
        pairs = zip(one, two, strict=False)
        shorter = min(len(one), len(two))
        agreeing[ball] = next((n for n, (x, y) in enumerate(pairs) if _sort(x) != _sort(y)), shorter)
        rest = [next(iter(events[agreeing[ball] :]), None) for events in (one, two)]
        if rest != [None, None]:
            partings.append(Parting(0, ball, *rest))
    same = _count_same(sequences[0], agreeing)
    if not partings:
        return Parting(same)
    first = min(partings, key=lambda parting: (parting.time, balls.index(str(parting.ball))))
    return Parting(same, first.ball, first.event_a, first.event_b)


def _count_same(sequence: dict[str, list[Event]], agreeing: dict[str, int]) -> int:
    """Count the events that are among the agreeing ones of each of their balls."""
    held = {ball: {event.index for event in sequence[ball][:count]} for ball, count in agreeing.items()}
    events = {event.index: event for ball in agreeing for event in sequence[ball]}
    return sum(all(index in held.get(ball, ()) for ball in event.balls) for index, event in events.items())


def _by_ball(run: Run, end: float) -> dict[str, list[Event]]:
    found: dict[str, list[Event]] = defaultdict(list)
    for event in run.events.by_time(0.0, end):
        for ball in event.balls:
            found[ball].append(event)
    return found


def _sort(event: Event) -> Sort:
    return event.kind, frozenset(event.balls), event.cushion or event.pocket
