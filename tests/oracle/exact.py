"""An exact event-driven simulator of hard discs, in high precision and by brute force: the oracle of the engine.

It is written to be right and easy to check, not fast. At every event it looks at every pair of balls and at every ball
and cushion, takes the earliest closing crossing from the current state, moves all balls to it and resolves it.
Numbers are mpmath's, with as many digits as asked for; the inputs are the exact values of the floats given.

    run = simulate(scenario, dps=60)
    run.events[0].time, run.positions, run.state_at(1.5), run.energy()

`exact_scenario` says which scenarios are understood. The motion between events is x + v t + a t^2/2, with one constant
acceleration a for all balls. A ball-ball gap is therefore quadratic in time (the accelerations cancel), a ball-line gap
linear or quadratic, and a ball-arc gap quadratic or, in a field, quartic (taken squared).

Rules of contact. `touching` is 10^(-dps/2) of the table's size; `overlap` is 1e-10 (r_a + r_b) + 1e-13 of the table's
size.

* gap > touching: the first time at which the gap falls through zero (for a cushion: with the foot on it).
* -overlap <= gap <= touching: in contact; closing -> at once, opening -> the first time after that at which it falls
  through zero again.
* gap < -overlap: between balls an error; at a cushion the ball is behind it, and must come out in front first.

A graze (a gap that touches zero without changing sign) is no event. Contacts at one instant are resolved one after the
other: ball-ball before ball-cushion, then by index, each in the state the last one left. So a shot into a corner
gives two events at one time; but where several balls touch at once this order is a choice, and other laws give other
answers. A ball held on a cushion by the field, or sliding along a concave arc, has no next event, and raises
`OracleError`; so does one that bounces ever lower, when its normal speed has fallen below 10^(-dps/2) of the speed of
a fall across the table.
"""

import bisect
import itertools
from dataclasses import dataclass, field, replace

from .exact_scenario import Line, ScenarioError, read_scenario

__all__ = ["Event", "OracleError", "Result", "ScenarioError", "simulate"]

FILTER = 1e-10  # relative safety margin of every double-precision bound, some 1e5 times its rounding error


class OracleError(RuntimeError):
    """The run reached a state this oracle has no answer for: an overlap, or a lasting contact."""


@dataclass(frozen=True)
class Event:
    """One contact. Numbers are mpf; lengths and times in the scenario's units.

    `ball_a`, `ball_b` and `cushion` are indices (`ball_b` is None at a cushion, `cushion` None between balls);
    `corner` is true where the contact is with a corner point. `point` is the point of contact. `normal` is the unit
    vector from ball a to ball b, or from the cushion into the table. `closing_speed` is positive. `impulse` is that
    along the normal.
    """

    index: int
    time: object
    kind: str
    ball_a: int
    ball_b: int | None
    cushion: int | None
    cushion_id: str | None
    corner: bool
    point: tuple
    normal: tuple
    closing_speed: object
    impulse: object


@dataclass
class Result:
    """What came out. `status` is time_limit, collision_limit, event_limit or no_more_events."""

    system: object
    status: str = ""
    events: list = field(default_factory=list)
    _states: list = field(default_factory=list)  # (time, positions, velocities) after each event, the start first

    @property
    def end_time(self):
        return self._states[-1][0]

    @property
    def positions(self):
        """Final positions: a list of (x, y)."""
        return self._states[-1][1]

    @property
    def velocities(self):
        """Final velocities: a list of (vx, vy)."""
        return self._states[-1][2]

    def state_at(self, time):
        """(positions, velocities) at 0 <= time <= end_time; at the time of an event, those after it."""
        time = self.system.ctx.mpf(time)
        if not 0 <= time <= self.end_time:
            raise ValueError(f"the run covers 0 to {self.end_time}, not {time}")
        start, positions, velocities = self._states[bisect.bisect_right(self._states, time, key=lambda s: s[0]) - 1]
        return _flown(self.system, positions, velocities, time - start)

    def kinetic_energy(self, time=None):
        """The sum of m v^2/2, at the end where no time is given."""
        velocities = self.velocities if time is None else self.state_at(time)[1]
        return sum(m * _dot(v, v) / 2 for m, v in zip(self.system.masses, velocities, strict=True))

    def energy(self, time=None):
        """Kinetic energy plus the potential -m a.x in the field, at the end where no time is given."""
        positions = self.positions if time is None else self.state_at(time)[0]
        a = self.system.acceleration
        potential = sum(-m * _dot(a, x) for m, x in zip(self.system.masses, positions, strict=True))
        return self.kinetic_energy(time) + potential


def simulate(scenario, dps=60, max_events=100_000):
    """Run a scenario (a dict, see `exact_scenario`) with `dps` decimal digits and return its `Result`."""
    system = read_scenario(scenario, dps)
    state = _State(system)
    run = Result(system)
    run._states.append(state.copy())
    while True:
        if system.collisions is not None and len(run.events) >= system.collisions:
            run.status = "collision_limit"
            return run
        if len(run.events) >= max_events:
            run.status = "event_limit"
            return run
        contact = state.next_contact()
        if contact is None or (system.duration is not None and state.time + contact.wait > system.duration):
            return _finish(run, state)
        state.advance(contact.wait)
        run.events.append(state.resolve(contact, len(run.events)))
        run._states.append(state.copy())


def _finish(run, state):
    """No further event in time: fly to the end of the duration, if there is one."""
    run.status = "no_more_events"
    if run.system.duration is not None:
        state.advance(run.system.duration - state.time)
        state.time = run.system.duration
        run._states.append(state.copy())
        run.status = "time_limit"
    return run


# --- the state, and what may happen next ---------------------------------------------------------------------------


@dataclass(frozen=True)
class _Contact:
    """A contact that comes after `wait`; `order` decides between contacts at one instant."""

    wait: object
    order: tuple
    ball_a: int
    ball_b: int | None = None
    cushion: object = None


class _State:
    """All balls at one time."""

    def __init__(self, system):
        self.system, self.ctx = system, system.ctx
        self.time = self.ctx.mpf(0)
        self.positions, self.velocities = list(system.positions), list(system.velocities)
        self.small = self.ctx.mpf(10) ** (-(self.ctx.dps // 2))
        self.touching = self.small * system.size
        self.radii = [float(r) for r in system.radii]
        self.reach = float(system.size) + max(abs(float(c)) for p in _places(system) for c in p)
        field = self.ctx.hypot(*system.acceleration)
        self.field, self.fall_speed = float(field), self.ctx.sqrt(field * system.size)
        self.behind = set()  # (ball, cushion) with the ball behind a cushion that it may touch from there

    def copy(self):
        return self.time, list(self.positions), list(self.velocities)

    def advance(self, time):
        self.positions, self.velocities = _flown(self.system, self.positions, self.velocities, time)
        self.time += time

    def overlap(self, radii):
        """How deep an overlap still counts as contact (length, float)."""
        return 1e-10 * radii + 1e-13 * float(self.system.size)

    def next_contact(self):
        """The earliest contact from now on, or None.

        Double precision only orders the work: `bound` is never later than the contact it belongs to, so once the bounds
        pass the best time found so far, nothing that is left can be earlier.
        """
        best = None
        left = None if self.system.duration is None else self.system.duration - self.time
        guesses = sorted([*self._ball_guesses(), *self._cushion_guesses()], key=lambda guess: guess[0])
        for bound, contact in guesses:
            if best is not None and bound > best.wait + self._instant(best.wait):
                break
            wait = self._wait(contact, left if best is None else best.wait)
            if wait is None:
                continue
            contact = replace(contact, wait=wait)
            if best is None or self._comes_first(contact, best):
                best = contact
        return best

    def _instant(self, wait):
        """Waits closer together than this are one instant (they agree to about `dps` digits, then)."""
        return self.small * (wait + self.time)

    def _comes_first(self, contact, other):
        if abs(contact.wait - other.wait) <= self._instant(other.wait):
            return contact.order < other.order
        return contact.wait < other.wait

    def _ball_guesses(self):
        """(bound, contact) for each pair that may meet, from straight relative motion at constant relative speed."""
        xs = [(float(x), float(y)) for x, y in self.positions]
        vs = [(float(x), float(y)) for x, y in self.velocities]
        speeds = [abs(vx) + abs(vy) for vx, vy in vs]
        for a, ((xa, ya), (ua, va), ra) in enumerate(zip(xs, vs, self.radii, strict=True)):
            for b in range(a + 1, len(xs)):
                reach = ra + self.radii[b]
                dx, dy, wx, wy = xs[b][0] - xa, xs[b][1] - ya, vs[b][0] - ua, vs[b][1] - va
                distance, speed = (dx * dx + dy * dy) ** 0.5, speeds[a] + speeds[b]
                if reach > 0 and distance - reach < -self.overlap(reach) - 1e-15 * self.reach:
                    raise OracleError(f"balls {a} and {b} overlap by {reach - distance} at t = {float(self.time)}")
                if reach == 0 or speed == 0 or dx * wx + dy * wy > FILTER * self.reach * speed:
                    continue  # two points, at rest, or parting
                gap = max(0.0, distance - reach - FILTER * self.reach)
                bound = gap / ((wx * wx + wy * wy) ** 0.5 + FILTER * speed)
                yield bound, _Contact(None, (0, a, b), a, b)

    def _cushion_guesses(self):
        """(bound, contact) for each ball and cushion, from the ball's speed and the field alone."""
        for a, (position, velocity) in enumerate(zip(self.positions, self.velocities, strict=True)):
            speed = float(abs(velocity[0]) + abs(velocity[1]))
            if speed == 0 and self.field == 0:
                continue
            for place, cushion in enumerate(self.system.cushions):
                if self._never(a, cushion):
                    continue
                gap = float(cushion.gap(position, self.system.radii[a]))
                self._note_side(a, cushion, gap)
                gap = max(0.0, abs(gap) - FILTER * self.reach)
                bound = 2 * gap / (speed + (speed * speed + 2 * self.field * gap) ** 0.5) if gap else 0.0
                yield bound * (1 - FILTER), _Contact(None, (1, a, cushion.index, place), a, cushion=cushion)

    def _never(self, ball, cushion):
        return not isinstance(cushion, Line) and cushion.contact_distance(self.system.radii[ball]) <= 0

    def _note_side(self, ball, cushion, gap):
        overlap = 2 * self.overlap(self.radii[ball])
        if gap < -overlap:
            self.behind.add((ball, id(cushion)))
        elif gap > overlap:
            self.behind.discard((ball, id(cushion)))

    # --- when a gap closes ---

    def _wait(self, contact, horizon):
        if contact.cushion is None:
            return self._wait_for_ball(contact.ball_a, contact.ball_b)
        return self._wait_for_cushion(contact.ball_a, contact.cushion, horizon)

    def _wait_for_ball(self, a, b):
        reach = self.system.radii[a] + self.system.radii[b]
        offset = _minus(self.positions[b], self.positions[a])
        relative = _minus(self.velocities[b], self.velocities[a])
        distance = self.ctx.hypot(*offset)
        gap, slope = distance - reach, _dot(offset, relative) / distance
        squared = [gap * (distance + reach), 2 * _dot(offset, relative), _dot(relative, relative)]
        if gap <= self.touching:
            if slope < -self.small * self.ctx.hypot(*relative):
                return self.ctx.mpf(0)
            return None  # parting in a straight line: never again
        return next(iter(_falls(self.ctx, squared, None)), None)

    def _wait_for_cushion(self, a, cushion, horizon):
        radius, position, velocity = self.system.radii[a], self.positions[a], self.velocities[a]
        gap, slope, polynomial = self._cushion_gap(cushion, position, velocity, radius)
        still = abs(slope) <= self.small * (self.ctx.hypot(*velocity) + self.fall_speed)
        if -self.overlap(self.radii[a]) <= gap <= self.touching and self._is_held_off(a, cushion):
            if slope < 0 and not still:
                return self.ctx.mpf(0)
            if still and polynomial[2] < 0:
                raise OracleError(f"ball {a} stays on cushion {cushion.id} from t = {float(self.time)} on")
        if abs(gap) <= self.touching:
            polynomial = polynomial[2:] if still else polynomial[1:]  # the gap's root at t = 0, divided out
        for time in _falls(self.ctx, polynomial, horizon):
            if cushion.has_foot(_moved(position, velocity, self.system.acceleration, time)):
                return time
        return None

    def _is_held_off(self, a, cushion):
        """Is the ball in front of the cushion, with its foot on it?"""
        return (a, id(cushion)) not in self.behind and cushion.has_foot(self.positions[a])

    def _cushion_gap(self, cushion, position, velocity, radius):
        """The gap, its rate of change, and a polynomial in time with the gap's sign and zeros (lowest power first)."""
        a, gap = self.system.acceleration, cushion.gap(position, radius)
        if isinstance(cushion, Line):
            slope = _dot(cushion.normal, velocity)
            return gap, slope, [gap, slope, _dot(cushion.normal, a) / 2]
        offset = _minus(position, cushion.center)
        distance, touch = self.ctx.hypot(*offset), cushion.contact_distance(radius)
        sign = -1 if cushion.concave else 1
        slope = sign * _dot(offset, velocity) / distance if distance else self.ctx.mpf(0)
        squared = [
            sign * (distance - touch) * (distance + touch),
            2 * sign * _dot(offset, velocity),
            sign * (_dot(velocity, velocity) + _dot(offset, a)),
            sign * _dot(velocity, a),
            sign * _dot(a, a) / 4,
        ]
        return gap, slope, squared

    # --- what a contact does ---

    def resolve(self, contact, index):
        """Change the velocities; the event with this index."""
        if contact.cushion is None:
            return self._resolve_balls(contact.ball_a, contact.ball_b, index)
        return self._resolve_cushion(contact.ball_a, contact.cushion, index)

    def _resolve_balls(self, a, b, index):
        masses, radii = self.system.masses, self.system.radii
        offset = _minus(self.positions[b], self.positions[a])
        normal = _times(1 / self.ctx.hypot(*offset), offset)
        closing = _dot(_minus(self.velocities[a], self.velocities[b]), normal)
        impulse = (1 + self.system.restitution) * closing / (1 / masses[a] + 1 / masses[b])
        self.velocities[a] = _plus(self.velocities[a], _times(-impulse / masses[a], normal))
        self.velocities[b] = _plus(self.velocities[b], _times(impulse / masses[b], normal))
        point = _plus(self.positions[a], _times(radii[a], normal))
        return Event(index, self.time, "ball_ball", a, b, None, None, False, point, normal, closing, impulse)

    def _resolve_cushion(self, a, cushion, index):
        position, velocity, law = self.positions[a], self.velocities[a], cushion.law
        normal, foot = cushion.normal_at(position), cushion.foot(position)
        closing = -_dot(velocity, normal)
        tangential = _plus(velocity, _times(closing, normal))
        self.velocities[a] = _plus(_times(law.normal * closing, normal), _times(law.tangential, tangential))
        self._note_far_faces(a, cushion, foot, normal)
        impulse = self.system.masses[a] * (1 + law.normal) * closing
        which = (cushion.index, cushion.id, cushion.corner)
        return Event(index, self.time, "ball_cushion", a, None, *which, foot, normal, closing, impulse)

    def _note_far_faces(self, a, cushion, foot, normal):
        """A ball that touches one face of a thin divider is behind the other (which matters for a point)."""
        self.behind.discard((a, id(cushion)))
        position, overlap = self.positions[a], self.overlap(self.radii[a])
        for other in self.system.cushions:
            if other.corner or self._never(a, other) or abs(other.gap(position, self.system.radii[a])) > 2 * overlap:
                continue
            apart = self.ctx.hypot(*_minus(other.foot(position), foot))
            if apart <= 2 * overlap and _dot(other.normal_at(position), normal) < -0.999:
                self.behind.add((a, id(other)))


# --- roots ---------------------------------------------------------------------------------------------------------


def _falls(ctx, polynomial, horizon):
    """The times t > 0 at which a polynomial (lowest power first) falls through zero, ascending.

    Beyond degree two, only those up to `horizon` where one is given.
    """
    while len(polynomial) > 1 and polynomial[-1] == 0:
        polynomial = polynomial[:-1]
    if len(polynomial) <= 3:
        return _quadratic_falls(ctx, *polynomial, *[ctx.mpf(0)] * (3 - len(polynomial)))
    limit = 1 + max(abs(c / polynomial[-1]) for c in polynomial[:-1])  # Cauchy's bound of all roots
    if horizon is not None:
        limit = min(limit, horizon * (1 + ctx.mpf(10) ** (-(ctx.dps // 3))))
    crossings = _crossings(ctx, polynomial, ctx.mpf(0), limit)
    return [t for t in crossings if t > 0 and _value(_derivative(polynomial), t) < 0]


def _quadratic_falls(ctx, c0, c1, c2):
    """The root of c0 + c1 t + c2 t^2 at which the slope is -sqrt(D), if it lies ahead."""
    discriminant = c1 * c1 - 4 * c0 * c2
    if discriminant <= 0:
        return []
    root = ctx.sqrt(discriminant)
    if c1 < 0:
        time = 2 * c0 / (root - c1)
    elif c2 < 0:
        time = (-c1 - root) / (2 * c2)
    else:
        return []
    return [time] if time > 0 else []


def _value(polynomial, t):
    total = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        total = total * t + coefficient
    return total


def _derivative(polynomial):
    return [k * c for k, c in enumerate(polynomial)][1:]


def _crossings(ctx, polynomial, low, high):
    """The roots in (low, high) at which a polynomial changes sign: one at most between two turns of its own."""
    if len(polynomial) < 2:
        return []
    nodes = [low, *_crossings(ctx, _derivative(polynomial), low, high), high]
    pieces = itertools.pairwise(nodes)
    return [_root(ctx, polynomial, a, b) for a, b in pieces if _value(polynomial, a) * _value(polynomial, b) < 0]


def _root(ctx, polynomial, low, high):
    """The root of a polynomial that is monotone on [low, high] and changes sign: bisection, then guarded Newton."""
    rising, slope = _value(polynomial, high) > 0, _derivative(polynomial)
    t = (low + high) / 2
    for step in range(20 * ctx.dps):
        value = _value(polynomial, t)
        if value == 0:
            return t
        low, high = (low, t) if (value > 0) == rising else (t, high)
        newton = t - value / (_value(slope, t) or ctx.inf)
        following = newton if step >= 10 and step % 8 and low < newton < high else (low + high) / 2
        if abs(following - t) <= 2 * ctx.eps * abs(t) or high - low <= 2 * ctx.eps * abs(high):
            return following
        t = following
    raise OracleError("a root could not be found")


# --- vectors -------------------------------------------------------------------------------------------------------


def _places(system):
    """Points that bound every coordinate in the scenario."""
    yield from system.positions
    for cushion in system.cushions:
        yield cushion.start if isinstance(cushion, Line) else cushion.center


def _moved(position, velocity, acceleration, time):
    (x, y), (u, v), (a, b) = position, velocity, acceleration
    return (x + (u + a * time / 2) * time, y + (v + b * time / 2) * time)


def _flown(system, positions, velocities, time):
    """Positions and velocities after a flight of `time`."""
    a = system.acceleration
    moved = [_moved(x, v, a, time) for x, v in zip(positions, velocities, strict=True)]
    return moved, [(u + a[0] * time, v + a[1] * time) for u, v in velocities]


def _dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def _plus(u, v):
    return (u[0] + v[0], u[1] + v[1])


def _minus(u, v):
    return (u[0] - v[0], u[1] - v[1])


def _times(factor, v):
    return (factor * v[0], factor * v[1])
