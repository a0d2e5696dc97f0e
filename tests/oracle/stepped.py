"""The fixed-step method for N balls in a rectangle, in plain doubles: the oracle of the engine's stepped method.

    run = simulate(scenario, dt=0.03, after_hit="wait", normal="before", last_step="short", steps=None)
    run.steps, run.events, run.state_at(1.0)

Step k goes from t_k to t_(k+1) = t_k + h. Per step: Euler positions y = x + v h; a wall candidate for each ball and
axis on which y leaves the box [r, W - r] x [r, H - r] moving outwards; a ball candidate for each approaching pair
with |y_a - y_b| <= r_a + r_b; candidates in order of their times, at most one per ball; a ball with a candidate moves
to its contact place, gets its new velocity and waits there; all others take y.

Readings of the method:

* `after_hit`: "wait", or "restart": only the earliest candidate is resolved, all balls and the clock advance by its
  time, then a new full step begins.
* `normal`: "before" (n between the centres before the move to the contact place) or "contact" (after it).
* `last_step`: "short" (a last, shorter step ends exactly at the duration) or "full" (every step is h).
* `steps`: this many steps of h each, whatever the duration.

Where the method's text leaves a choice, this is the one made here:

1.  t_k is the double k h, not a sum of k terms; under "restart", t_hit + j h for the j-th step after the last hit.
2.  "short": when what is left of the duration is at most h (1 + 1e-9), the step is the last one, it is exactly
    duration - t_k long, and its end time is the duration itself. So 5 / 0.01 gives 500 steps and no sliver.
3.  "full": steps begin while more than 1e-9 h of the duration is left; the run ends at or after the duration.
4.  `steps` counts rows of the table, so under "restart" a step cut short by a hit counts as one.
5.  "Leaves the box" is strict: y < r or y > W - r; "moving outwards" is v < 0 or v > 0 on that axis.
6.  "within r_a + r_b" and "approaching" are tested with plain square roots: sqrt(dx dx + dy dy), no hypot.
7.  A candidate's time is clamped to [0, h] with the h of this very step, the short last one included.
8.  At equal times: ball-ball before wall; pairs by (a, b) with a < b; walls by ball, then x before y.
9.  Every candidate is found from the state at the start of the step; a ball that is resolved does not make new ones.
10. The exchange along n is done whether or not the pair still approaches along the n of the reading "contact".
11. The velocity along the unit vector n is replaced (v + (new - old) n), which leaves the tangential part alone and
    needs no tangent; with masses: new_a = ((m_a - m_b) old_a + 2 m_b old_b)/(m_a + m_b).
12. Under "restart" a step without a candidate is a full one; two balls hit by two candidates of the very same time are
    two steps, the second (usually) of length zero.
13. The step table has a row for the start (step 0, time 0, no hits); row k is the state at t_k, and its hits are
    those of the step that ends there. An event's `step` is the number of the step it lies in, counted from 0.
14. Between t_k and t_(k+1) a ball without a hit is at x + v (t - t_k); from the time of its hit on (that instant
    included) a ball has its new velocity while it waits. At t_(k+1) the state is the table's.
15. `lost_time` adds t_(k+1) - t_event over the balls in events; `deepest_overlap` is the largest r_a + r_b - |x_a -
    x_b| at the ends of steps, 0 if there is none.
"""

import bisect
import math
from dataclasses import dataclass, field

CUSHIONS = {(0, -1): "left", (0, 1): "right", (1, -1): "bottom", (1, 1): "top"}
SLIVER = 1e-9  # of a step: less than this is not worth a step of its own
STUCK = 10_000  # so many steps at one and the same time are an error


@dataclass(frozen=True)
class Event:
    """A hit. `time` = t_k + dt; `ball_b` is None at a cushion, `cushion` (a name) None between balls."""

    step: int
    time: float
    kind: str
    ball_a: int
    ball_b: int | None = None
    cushion: str | None = None


@dataclass(frozen=True)
class Step:
    """A row of the step table: time, and per ball (x, y), (vx, vy) and whether it was hit in the step ending here."""

    step: int
    time: float
    positions: list
    velocities: list
    hit: list


@dataclass(frozen=True)
class _Ball:
    id: str
    radius: float
    mass: float


@dataclass(frozen=True)
class _Candidate:
    """Sorts as the method says: by time, ball-ball (rank 0) before wall (rank 1), then by `place`."""

    dt: float
    rank: int
    place: tuple

    @property
    def balls(self):
        return self.place if self.rank == 0 else self.place[:1]


@dataclass
class Run:
    """What came out of a stepped run; `steps`, `events` and the state at any time."""

    balls: list
    steps: list = field(default_factory=list)
    events: list = field(default_factory=list)

    @property
    def end_time(self):
        return self.steps[-1].time

    @property
    def positions(self):
        return self.steps[-1].positions

    @property
    def velocities(self):
        return self.steps[-1].velocities

    def state_at(self, time):
        """(positions, velocities) at 0 <= time <= end_time, as lists of pairs."""
        if not 0 <= time <= self.end_time:
            raise ValueError(f"the run covers 0 to {self.end_time}, not {time}")
        k = bisect.bisect_right(self.steps, time, key=lambda row: row.time) - 1
        row = self.steps[k]
        if row.time == time:
            return list(row.positions), list(row.velocities)
        hits = {ball: e for e in self.events if e.step == k for ball in (e.ball_a, e.ball_b) if ball is not None}
        states = [self._ball_at(i, time, row, self.steps[k + 1], hits.get(i)) for i in range(len(self.balls))]
        return [x for x, _ in states], [v for _, v in states]

    @staticmethod
    def _ball_at(i, time, row, following, event):
        if event is not None and following.hit[i] and time >= event.time:
            return following.positions[i], following.velocities[i]
        return _moved(row.positions[i], row.velocities[i], time - row.time), row.velocities[i]

    def energy(self, time=None):
        """The sum of m v^2/2, at the end where no time is given."""
        velocities = self.velocities if time is None else self.state_at(time)[1]
        return sum(b.mass * (v[0] * v[0] + v[1] * v[1]) / 2 for b, v in zip(self.balls, velocities, strict=True))

    @property
    def lost_time(self):
        ends = [self.steps[e.step + 1].time - e.time for e in self.events]
        return sum(lost * (2 if e.kind == "ball_ball" else 1) for lost, e in zip(ends, self.events, strict=True))

    @property
    def deepest_overlap(self):
        return max([0.0, *(depth for row in self.steps for depth in _overlaps(self.balls, row.positions))])


def simulate(scenario, dt, after_hit="wait", normal="before", last_step="short", steps=None):
    """Run a scenario (a dict: rectangle, no obstacles, free flight, elastic balls) with steps of `dt`."""
    for value, known in (
        (after_hit, ("wait", "restart")),
        (normal, ("before", "contact")),
        (last_step, ("short", "full")),
    ):
        if value not in known:
            raise ValueError(f"{value!r} is not one of {known}")
    if not dt > 0:
        raise ValueError("dt must be positive")
    method = _Method(scenario, normal, restart=after_hit == "restart")
    clock = _Clock(dt, scenario.get("duration"), last_step, steps)
    run = Run(method.balls)
    run.steps.append(Step(0, 0.0, *method.start, [False] * len(method.balls)))
    while (h := clock.next_step()) is not None:
        row = run.steps[-1]
        positions, velocities, taken = method.step(row.positions, row.velocities, h)
        run.events += [method.event(row, candidate) for candidate in taken]
        if taken and method.restart:
            clock.advance_to_hit(taken[0].dt)
        else:
            clock.advance_whole()
        hit = {ball for candidate in taken for ball in candidate.balls}
        run.steps.append(Step(clock.done, clock.time, positions, velocities, [i in hit for i in range(len(run.balls))]))
        _check_progress(run)
    return run


def _check_progress(run):
    """Under "restart" overlapping balls could in principle exchange hits for ever without time going on."""
    if len(run.steps) > STUCK and run.steps[-1].time == run.steps[-STUCK].time:
        raise RuntimeError(f"no progress at t = {run.end_time}")


class _Clock:
    """Says how long the next step is, and what time it is after it."""

    def __init__(self, dt, duration, last_step, steps):
        if duration is None and steps is None:
            raise ValueError("a duration or a number of steps is needed")
        self.dt, self.duration, self.short, self.steps = dt, duration, last_step == "short", steps
        self.time, self.origin, self.since_origin, self.done = 0.0, 0.0, 0, 0

    def _is_last(self):
        return self.steps is None and self.short and self.duration - self.time <= self.dt * (1 + SLIVER)

    def next_step(self):
        """The length of the next step, or None at the end."""
        if self.steps is not None:
            return self.dt if self.done < self.steps else None
        left = self.duration - self.time
        if left <= (0.0 if self.short else SLIVER * self.dt):
            return None
        return left if self._is_last() else self.dt

    def advance_whole(self):
        """To the end of the step."""
        last, self.since_origin = self._is_last(), self.since_origin + 1
        self.time = self.duration if last else self.origin + self.since_origin * self.dt
        self.done += 1

    def advance_to_hit(self, dt):
        """To a hit within the step, where the clock starts anew."""
        time = self.time + dt
        if self.steps is None and self.short:
            time = min(time, self.duration)
        self.time, self.origin, self.since_origin = time, time, 0
        self.done += 1


class _Method:
    """One step of the method."""

    def __init__(self, scenario, normal, restart):
        self.at_contact, self.restart = normal == "contact", restart
        self.box = _read_box(scenario)
        self.factors = _read_laws(scenario.get("physics", {}))
        self.balls, *self.start = _read_balls(scenario)

    def step(self, positions, velocities, h):
        """(positions, velocities, candidates resolved) after a step of h; with `restart`, up to its first hit."""
        tentative = [_moved(x, v, h) for x, v in zip(positions, velocities, strict=True)]
        candidates = self._candidates(positions, velocities, tentative, h)
        if self.restart and candidates:
            taken = candidates[:1]
            tentative = [_moved(x, v, taken[0].dt) for x, v in zip(positions, velocities, strict=True)]
        else:
            taken = _one_per_ball(candidates)
        places, speeds = list(tentative), list(velocities)
        for candidate in taken:
            for ball in candidate.balls:
                places[ball] = _moved(positions[ball], velocities[ball], candidate.dt)
            if candidate.rank == 0:
                self._exchange(*candidate.balls, places if self.at_contact else positions, speeds)
            else:
                self._reflect(*candidate.place, speeds)
        return places, speeds, taken

    def event(self, row, candidate):
        """The hit of a candidate in the step that begins at `row`."""
        time = row.time + candidate.dt
        if candidate.rank == 0:
            return Event(row.step, time, "ball_ball", *candidate.balls)
        ball, axis, side = candidate.place
        return Event(row.step, time, "ball_cushion", ball, cushion=CUSHIONS[axis, side])

    def _candidates(self, positions, velocities, tentative, h):
        found = []
        for a in range(len(positions)):
            found += self._wall_candidates(a, positions[a], velocities[a], tentative[a])
            for b in range(a + 1, len(positions)):
                found += self._ball_candidate(a, b, positions, velocities, tentative, h)
        return sorted(found, key=lambda c: (c.dt, c.rank, c.place))

    def _wall_candidates(self, a, x, v, y):
        r = self.balls[a].radius
        for axis in (0, 1):
            low, high = r, self.box[axis] - r
            if y[axis] < low and v[axis] < 0:
                yield _Candidate(max(0.0, (low - x[axis]) / v[axis]), 1, (a, axis, -1))
            elif y[axis] > high and v[axis] > 0:
                yield _Candidate(max(0.0, (high - x[axis]) / v[axis]), 1, (a, axis, 1))

    def _ball_candidate(self, a, b, positions, velocities, tentative, h):
        reach = self.balls[a].radius + self.balls[b].radius
        d, w = _minus(positions[a], positions[b]), _minus(velocities[a], velocities[b])
        if _length(_minus(tentative[a], tentative[b])) <= reach and d[0] * w[0] + d[1] * w[1] < 0:
            dt = (_length(d) - reach) / _length(w)
            yield _Candidate(min(max(0.0, dt), h), 0, (a, b))

    def _reflect(self, ball, axis, _side, velocities):
        normal, tangential = self.factors
        v = [tangential * component for component in velocities[ball]]
        v[axis] = -normal * velocities[ball][axis]
        velocities[ball] = tuple(v)

    def _exchange(self, a, b, positions, velocities):
        d = _minus(positions[a], positions[b])
        length = _length(d)
        n = (d[0] / length, d[1] / length)
        ma, mb = self.balls[a].mass, self.balls[b].mass
        old_a = velocities[a][0] * n[0] + velocities[a][1] * n[1]
        old_b = velocities[b][0] * n[0] + velocities[b][1] * n[1]
        new_a = ((ma - mb) * old_a + 2 * mb * old_b) / (ma + mb)
        new_b = ((mb - ma) * old_b + 2 * ma * old_a) / (ma + mb)
        velocities[a] = _moved(velocities[a], n, new_a - old_a)
        velocities[b] = _moved(velocities[b], n, new_b - old_b)


def _one_per_ball(candidates):
    taken, busy = [], set()
    for candidate in candidates:
        if busy.isdisjoint(candidate.balls):
            taken.append(candidate)
            busy.update(candidate.balls)
    return taken


def _overlaps(balls, positions):
    for a in range(len(balls)):
        for b in range(a + 1, len(balls)):
            yield balls[a].radius + balls[b].radius - _length(_minus(positions[a], positions[b]))


def _read_box(scenario):
    table = scenario["table"]
    if table["shape"] != "rectangle" or set(table) - {"shape", "width", "length"}:
        raise ValueError("the stepped method needs a plain rectangle")
    return float(table["width"]), float(table["length"])


def _read_laws(physics):
    """(normal, tangential) of the cushions."""
    if physics.get("ball_ball", {"law": "elastic"}) != {"law": "elastic"}:
        raise ValueError("the stepped method needs elastic balls")
    if physics.get("flight", {"law": "free"}) != {"law": "free"}:
        raise ValueError("the stepped method needs free flight")
    entry = physics.get("ball_cushion", {"law": "elastic"})
    if entry["law"] == "elastic":
        return 1.0, 1.0
    if entry["law"] == "damping":
        return float(entry["factor"]), float(entry["factor"])
    if entry["law"] == "restitution":
        return float(entry["normal"]), float(entry.get("tangential", 1.0))
    raise ValueError(f"unknown cushion law {entry['law']!r}")


def _read_balls(scenario):
    balls, positions, velocities = [], [], []
    for k, entry in enumerate(scenario["balls"]):
        entry = {"id": str(k), "mass": 1.0, **scenario.get("ball_defaults", {}), **entry}
        balls.append(_Ball(entry["id"], float(entry["radius"]), float(entry["mass"])))
        positions.append(tuple(float(c) for c in entry["position"]))
        velocities.append(_velocity(entry))
    return balls, positions, velocities


def _velocity(entry):
    if "speed" in entry:
        angle = math.radians(entry["direction_deg"])
        return (entry["speed"] * math.cos(angle), entry["speed"] * math.sin(angle))
    return tuple(float(c) for c in entry.get("velocity", (0.0, 0.0)))


def _moved(x, v, time):
    return (x[0] + v[0] * time, x[1] + v[1] * time)


def _minus(u, v):
    return (u[0] - v[0], u[1] - v[1])


def _length(d):
    return math.sqrt(d[0] * d[0] + d[1] * d[1])
