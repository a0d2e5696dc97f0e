"""Reads a scenario (a plain dict) into high-precision numbers for `exact.simulate`.

Every float is taken as the exact binary value it is. Lengths, times and masses are in the scenario's own units.

What is understood, and nothing else (anything unknown raises `ScenarioError`):

* `table.shape`: `rectangle` (width, length; origin at the lower left corner; cushions left, right, bottom, top are
  numbers 0 to 3), `circle` (radius; centre at the origin; one cushion, number 0) or `path` (pieces, numbered from 0).
* a piece: `{line = [[x, y], [x, y]]}` or `{arc = {center, radius, from_deg, to_deg}}`, with an optional `id`. The table
  lies to the left: an arc with to_deg > from_deg is concave (table inside), one with to_deg < from_deg convex.
* `table.obstacles`, for every shape, each with an optional `id`, their cushions numbered on from the boundary's:
  `{circle = {center, radius}}`, `{path = [pieces]}` running clockwise, `{wall = [[x, y], [x, y]]}` (two cushions back
  to back: first the face to the left of the direction, then the other one).
* `physics.ball_ball`: `{law = "elastic"}` or `{law = "restitution", normal}`.
* `physics.ball_cushion`: `{law = "elastic"}`, `{law = "restitution", normal, tangential}` or `{law = "damping",
  factor}`; `physics.ball_cushion.cushions.<id>` holds another such law for one cushion (ids of obstacle pieces
  included).
* `physics.flight`: `{law = "free"}` or `{law = "field", acceleration = [ax, ay]}`.
* balls: id, radius, mass (1 where absent), position, and velocity or speed with direction_deg (turned into a velocity
  in double precision); `ball_defaults` fills what a ball leaves out.
* `duration` and `collisions`: the run ends at whichever comes first.

A cushion's end becomes a corner point (a disc of radius 0) where the boundary turns right or back on itself, so at
reflex joints and at the free ends of walls. A corner point belongs to the piece that ends there.
"""

import math
from dataclasses import dataclass

import mpmath

JOINT_TOLERANCE = 1e-10  # of the table's size: ends further apart than this do not meet
SMOOTH = 1e-14  # sine of a turn that counts as none
FOOT_SLACK = 1e-13  # of the table's size: how far past a smooth or concave joint a foot is accepted


class ScenarioError(ValueError):
    """The scenario is malformed, or asks for something this oracle does not know."""


@dataclass
class CushionLaw:
    """v_n -> -normal v_n, v_t -> tangential v_t."""

    normal: object
    tangential: object


class Line:
    """A straight cushion; the table lies to the left of start -> end."""

    corner, full = False, False
    id, index, law = None, None, None

    def __init__(self, ctx, start, end):
        self.start, self.end = start, end
        dx, dy = end[0] - start[0], end[1] - start[1]
        self.length = ctx.hypot(dx, dy)
        if self.length == 0:
            raise ScenarioError("a line of length zero")
        self.direction = (dx / self.length, dy / self.length)
        self.normal = (-self.direction[1], self.direction[0])
        self.slack = [ctx.mpf(0), ctx.mpf(0)]  # accepted past start and end (length)

    start_direction = end_direction = property(lambda self: self.direction)

    def area(self):
        """This piece's share of the signed area of its path."""
        return (self.start[0] * self.end[1] - self.end[0] * self.start[1]) / 2

    def gap(self, position, radius):
        """Signed distance between the disc and the line."""
        dx, dy = position[0] - self.start[0], position[1] - self.start[1]
        return dx * self.normal[0] + dy * self.normal[1] - radius

    def along(self, position):
        dx, dy = position[0] - self.start[0], position[1] - self.start[1]
        return dx * self.direction[0] + dy * self.direction[1]

    def has_foot(self, position):
        """Does the perpendicular from `position` meet the segment?"""
        return -self.slack[0] <= self.along(position) <= self.length + self.slack[1]

    def foot(self, position):
        s = self.along(position)
        return (self.start[0] + s * self.direction[0], self.start[1] + s * self.direction[1])

    def normal_at(self, _position):
        """Unit normal into the table."""
        return self.normal


class Arc:
    """A circular cushion, concave (table inside) or convex (table outside); a corner point is convex, of radius 0."""

    id, index, law = None, None, None

    def __init__(self, ctx, center, radius, from_angle=None, to_angle=None, concave=False, corner=False):
        self.ctx, self.center, self.radius, self.concave, self.corner = ctx, center, radius, concave, corner
        self.full = from_angle is None
        self.slack = [ctx.mpf(0), ctx.mpf(0)]  # accepted past start and end (length)
        if not self.full:
            self.from_angle, self.to_angle = from_angle, to_angle
            self.span = abs(to_angle - from_angle)
            self.start, self.end = self._point(from_angle), self._point(to_angle)
            self.start_direction, self.end_direction = self._tangent(from_angle), self._tangent(to_angle)

    def _point(self, angle):
        return (
            self.center[0] + self.radius * self.ctx.cos(angle),
            self.center[1] + self.radius * self.ctx.sin(angle),
        )

    def _tangent(self, angle):
        sign = 1 if self.concave else -1
        return (-sign * self.ctx.sin(angle), sign * self.ctx.cos(angle))

    def area(self):
        """This piece's share of the signed area of its path, (1/2) of the integral of x dy - y dx."""
        (cx, cy), (x0, y0), (x1, y1) = self.center, self.start, self.end
        turn = self.to_angle - self.from_angle
        return (self.radius**2 * turn + cx * (y1 - y0) - cy * (x1 - x0)) / 2

    def contact_distance(self, radius):
        """Distance of a touching disc's centre from the arc's centre; zero or less: they never touch."""
        return self.radius - radius if self.concave else self.radius + radius

    def _from_center(self, position):
        dx, dy = position[0] - self.center[0], position[1] - self.center[1]
        return dx, dy, self.ctx.hypot(dx, dy)

    def gap(self, position, radius):
        """Signed distance between the disc and the whole circle."""
        distance = self._from_center(position)[2]
        return (-1 if self.concave else 1) * (distance - self.contact_distance(radius))

    def has_foot(self, position):
        """Does the ray from the centre through `position` meet the arc?"""
        if self.full:
            return True
        dx, dy, _ = self._from_center(position)
        turn = 2 * self.ctx.pi
        past_start = (self.ctx.atan2(dy, dx) - self.from_angle) * (1 if self.concave else -1)
        past_start -= turn * self.ctx.floor(past_start / turn)
        before, after = self.slack[0] / self.radius, self.slack[1] / self.radius
        return past_start <= self.span + after or past_start >= turn - before

    def foot(self, position):
        dx, dy, distance = self._from_center(position)
        return (self.center[0] + self.radius * dx / distance, self.center[1] + self.radius * dy / distance)

    def normal_at(self, position):
        """Unit normal into the table."""
        dx, dy, distance = self._from_center(position)
        sign = -1 if self.concave else 1
        return (sign * dx / distance, sign * dy / distance)


@dataclass
class System:
    """A scenario in high-precision numbers. Positions and velocities are lists of (x, y)."""

    ctx: object
    ids: list
    radii: list
    masses: list
    positions: list
    velocities: list
    acceleration: tuple
    restitution: object
    cushions: list
    size: object
    duration: object
    collisions: object


def read_scenario(scenario, dps):
    """The `System` of a scenario dict, with numbers of `dps` decimal digits."""
    ctx = mpmath.MPContext()
    ctx.dps = dps
    physics = scenario.get("physics", {})
    _only(physics, {"ball_ball", "ball_cushion", "flight"}, "physics")
    cushions, size = _read_table(ctx, _required(scenario, "table", "scenario"))
    _give_laws(ctx, cushions, physics.get("ball_cushion", {"law": "elastic"}))
    balls = [_read_ball(ctx, scenario.get("ball_defaults", {}), ball, k) for k, ball in enumerate(scenario["balls"])]
    duration, collisions = scenario.get("duration"), scenario.get("collisions")
    if duration is None and collisions is None:
        raise ScenarioError("a duration or a number of collisions is needed")
    return System(
        ctx=ctx,
        ids=[ball["id"] for ball in balls],
        radii=[ball["radius"] for ball in balls],
        masses=[ball["mass"] for ball in balls],
        positions=[ball["position"] for ball in balls],
        velocities=[ball["velocity"] for ball in balls],
        acceleration=_read_flight(ctx, physics.get("flight", {"law": "free"})),
        restitution=_read_ball_law(ctx, physics.get("ball_ball", {"law": "elastic"})),
        cushions=cushions,
        size=size,
        duration=None if duration is None else ctx.mpf(duration),
        collisions=collisions,
    )


def _required(table, key, place):
    if key not in table:
        raise ScenarioError(f"{place}: {key} is missing")
    return table[key]


def _only(table, known, place):
    unknown = set(table) - set(known)
    if unknown:
        raise ScenarioError(f"{place}: this oracle does not know {sorted(unknown)}")


def _vector(ctx, pair):
    x, y = pair
    return (ctx.mpf(x), ctx.mpf(y))


def _read_ball(ctx, defaults, ball, k):
    ball = {"id": str(k), "mass": 1, **defaults, **ball}
    place = f"balls[{k}]"
    _only(ball, {"id", "radius", "mass", "position", "velocity", "speed", "direction_deg", "color"}, place)
    if "speed" in ball:
        speed, angle = float(ball["speed"]), math.radians(float(_required(ball, "direction_deg", place)))
        velocity = (speed * math.cos(angle), speed * math.sin(angle))
    else:
        velocity = ball.get("velocity", (0, 0))
    radius, mass = ctx.mpf(_required(ball, "radius", place)), ctx.mpf(ball["mass"])
    if radius < 0 or mass <= 0:
        raise ScenarioError(f"{place}: negative radius, or mass not positive")
    position = _vector(ctx, _required(ball, "position", place))
    return {"id": ball["id"], "radius": radius, "mass": mass, "position": position, "velocity": _vector(ctx, velocity)}


def _read_flight(ctx, flight):
    law = _required(flight, "law", "physics.flight")
    if law == "free":
        _only(flight, {"law"}, "physics.flight")
        return _vector(ctx, (0, 0))
    if law == "field":
        _only(flight, {"law", "acceleration"}, "physics.flight")
        return _vector(ctx, _required(flight, "acceleration", "physics.flight"))
    raise ScenarioError(f"physics.flight: this oracle does not know the law {law!r}")


def _read_ball_law(ctx, entry):
    law = _required(entry, "law", "physics.ball_ball")
    if law == "elastic":
        _only(entry, {"law"}, "physics.ball_ball")
        return ctx.mpf(1)
    if law == "restitution":
        _only(entry, {"law", "normal"}, "physics.ball_ball")
        return ctx.mpf(_required(entry, "normal", "physics.ball_ball"))
    raise ScenarioError(f"physics.ball_ball: this oracle does not know the law {law!r}")


def _read_cushion_law(ctx, entry, place):
    law = _required(entry, "law", place)
    if law == "elastic":
        _only(entry, {"law"}, place)
        return CushionLaw(ctx.mpf(1), ctx.mpf(1))
    if law == "restitution":
        _only(entry, {"law", "normal", "tangential"}, place)
        return CushionLaw(ctx.mpf(_required(entry, "normal", place)), ctx.mpf(entry.get("tangential", 1)))
    if law == "damping":
        _only(entry, {"law", "factor"}, place)
        factor = ctx.mpf(_required(entry, "factor", place))
        return CushionLaw(factor, factor)
    raise ScenarioError(f"{place}: this oracle does not know the law {law!r}")


def _give_laws(ctx, cushions, entry):
    place = "physics.ball_cushion"
    entry = dict(entry)
    overrides = entry.pop("cushions", {})
    default = _read_cushion_law(ctx, entry, place)
    laws = {key: _read_cushion_law(ctx, law, f"{place}.cushions.{key}") for key, law in overrides.items()}
    _only(laws, {cushion.id for cushion in cushions}, f"{place}.cushions")
    for cushion in cushions:
        cushion.law = laws.get(cushion.id, default)


def _read_table(ctx, table):
    """All cushions, corner points last, and the table's size (the diagonal of its bounding box)."""
    boundary, round_trip, size = _read_boundary(ctx, table)
    obstacles = [_read_obstacle(ctx, entry, k) for k, entry in enumerate(table.get("obstacles", []))]
    cushions = boundary + [piece for obstacle in obstacles for piece in obstacle]
    for index, cushion in enumerate(cushions):
        cushion.index = index
        if cushion.id is None:
            cushion.id = str(index)
    corners = _join(ctx, round_trip, 1, size)
    for obstacle in obstacles:
        corners += _join(ctx, obstacle, -1, size)
    return cushions + corners, size


def _read_boundary(ctx, table):
    """The boundary's pieces in order of number, the same counter-clockwise, and the table's size."""
    shape = _required(table, "shape", "table")
    if shape == "rectangle":
        _only(table, {"shape", "width", "length", "obstacles"}, "table")
        return _rectangle(ctx, ctx.mpf(table["width"]), ctx.mpf(table["length"]))
    if shape == "circle":
        _only(table, {"shape", "radius", "obstacles"}, "table")
        rim = Arc(ctx, _vector(ctx, (0, 0)), ctx.mpf(table["radius"]), concave=True)
        return [rim], [rim], 2 * ctx.sqrt(2) * rim.radius
    if shape == "path":
        _only(table, {"shape", "pieces", "obstacles"}, "table")
        pieces = [_read_piece(ctx, entry) for entry in table["pieces"]]
        return pieces, pieces, _size(ctx, pieces)
    raise ScenarioError(f"table: this oracle does not know the shape {shape!r}")


def _rectangle(ctx, w, h):
    corners = [(ctx.mpf(0), ctx.mpf(0)), (w, ctx.mpf(0)), (w, h), (ctx.mpf(0), h)]
    bottom, right, top, left = (Line(ctx, corners[k], corners[(k + 1) % 4]) for k in range(4))
    bottom.id, right.id, top.id, left.id = "bottom", "right", "top", "left"
    return [left, right, bottom, top], [bottom, right, top, left], ctx.hypot(w, h)


def _size(ctx, pieces):
    """Diagonal of the bounding box; of an arc the whole circle's box, which is large enough."""
    xs, ys = [], []
    for piece in pieces:
        reach = 0 if isinstance(piece, Line) else piece.radius
        for x, y in [piece.start, piece.end] if reach == 0 else [piece.center]:
            xs += [x - reach, x + reach]
            ys += [y - reach, y + reach]
    return ctx.hypot(max(xs) - min(xs), max(ys) - min(ys))


def _read_piece(ctx, entry):
    if "line" in entry:
        _only(entry, {"line", "id"}, "piece")
        start, end = entry["line"]
        return _named(entry, Line(ctx, _vector(ctx, start), _vector(ctx, end)))
    _only(entry, {"arc", "id"}, "piece")
    arc = _required(entry, "arc", "piece")
    _only(arc, {"center", "radius", "from_deg", "to_deg"}, "arc")
    begin, end = ctx.mpf(arc["from_deg"]), ctx.mpf(arc["to_deg"])
    if not 0 < abs(end - begin) <= 360:
        raise ScenarioError("an arc must turn by more than 0 and at most 360 degrees")
    degree = ctx.pi / 180
    center, radius = _vector(ctx, arc["center"]), ctx.mpf(arc["radius"])
    return _named(entry, Arc(ctx, center, radius, begin * degree, end * degree, concave=bool(end > begin)))


def _named(entry, piece):
    piece.id = entry.get("id")
    return piece


def _read_obstacle(ctx, entry, k):
    place = f"table.obstacles[{k}]"
    _only(entry, {"circle", "path", "wall", "id"}, place)
    if "circle" in entry:
        circle = entry["circle"]
        _only(circle, {"center", "radius"}, place)
        return [_named(entry, Arc(ctx, _vector(ctx, circle["center"]), ctx.mpf(circle["radius"])))]
    if "wall" in entry:
        start, end = (_vector(ctx, point) for point in entry["wall"])
        return [_named(entry, Line(ctx, start, end)), _named(entry, Line(ctx, end, start))]
    return [_read_piece(ctx, piece) for piece in _required(entry, "path", place)]


def _join(ctx, pieces, sign, size):
    """Check that a path closes and runs the right way round; give each joint its slack or its corner point."""
    if len(pieces) == 1 and pieces[0].full:
        return []
    area = sum(piece.area() for piece in pieces)
    is_wall = len(pieces) == 2 and all(isinstance(piece, Line) for piece in pieces)
    if not is_wall and area * sign <= 0:
        raise ScenarioError("the boundary must run counter-clockwise, an obstacle clockwise")
    corners = []
    for piece, following in zip(pieces, pieces[1:] + pieces[:1], strict=True):
        dx, dy = following.start[0] - piece.end[0], following.start[1] - piece.end[1]
        mismatch = ctx.hypot(dx, dy)
        if mismatch > JOINT_TOLERANCE * size:
            raise ScenarioError(f"a path does not close: its pieces are {ctx.nstr(mismatch, 5)} apart")
        if _sticks_out(piece.end_direction, following.start_direction):
            corners.append(_corner(ctx, piece, following))
        else:
            piece.slack[1] = following.slack[0] = 2 * mismatch + FOOT_SLACK * size
    return corners


def _sticks_out(before, after):
    """Does the boundary turn right, or back on itself, so that its joint points into the table?"""
    cross = before[0] * after[1] - before[1] * after[0]
    dot = before[0] * after[0] + before[1] * after[1]
    return cross < -SMOOTH or (cross <= SMOOTH and dot < 0)


def _corner(ctx, piece, following):
    """The corner point at the end of `piece`, with that piece's number and id."""
    point = following.start if isinstance(following, Line) else piece.end
    corner = Arc(ctx, point, ctx.mpf(0), corner=True)
    corner.index, corner.id = piece.index, piece.id
    return corner
