//! A table as the tests see it: whether a point is inside, and how far it is from the boundary. Nothing of the engine's
//! own geometry is used.

use carom::scenario::Scenario;
use carom::scenario::schema::{ArcShape, Obstacle, Piece, Table};

type Point = [f64; 2];

/// A direction along no wall of any table.
const RAY: Point = [0.573_576_436_351_046, 0.819_152_044_288_992];

/// A piece of boundary.
#[derive(Clone, Debug)]
pub enum Edge {
    Line(Point, Point),
    /// Centre, radius, and whether a direction (a unit vector from the centre) belongs to it.
    Arc(Point, f64, Sector),
}

/// A range of directions: counter-clockwise from an angle by a sweep, in radians.
#[derive(Clone, Copy, Debug)]
pub struct Sector {
    from: f64,
    sweep: f64,
}

/// The boundary of a table and what stands on it.
#[derive(Clone, Debug)]
pub struct Room {
    /// Pieces that separate inside from outside.
    pub edges: Vec<Edge>,
    /// Thin walls.
    pub walls: Vec<[Point; 2]>,
    pub min: Point,
    pub max: Point,
}

impl Room {
    pub fn of(scenario: &Scenario) -> Self {
        let mut room = Self { edges: Vec::new(), walls: Vec::new(), min: [0.0; 2], max: [0.0; 2] };
        match &scenario.table {
            Table::Rectangle { width, length, .. } => {
                let corners = [[0.0, 0.0], [*width, 0.0], [*width, *length], [0.0, *length]];
                room.edges.extend((0..4).map(|k| Edge::Line(corners[k], corners[(k + 1) % 4])));
            }
            Table::Circle { radius, .. } => room.edges.push(Edge::circle([0.0; 2], *radius)),
            Table::Path { pieces, .. } => room.edges.extend(pieces.iter().map(Edge::of)),
            Table::PocketTable { .. } | Table::Preset(_) | Table::Absent => {
                panic!("discs have no such table")
            }
        }
        (room.min, room.max) = bounds(&room.edges);
        for obstacle in scenario.table.obstacles() {
            match obstacle {
                Obstacle::Circle { circle, .. } => {
                    room.edges.push(Edge::circle(circle.center, circle.radius))
                }
                Obstacle::Path { path, .. } => room.edges.extend(path.iter().map(Edge::of)),
                Obstacle::Wall { wall, .. } => room.walls.push(*wall),
            }
        }
        room
    }

    /// The larger side of the box around the table.
    pub fn size(&self) -> f64 {
        (self.max[0] - self.min[0]).max(self.max[1] - self.min[1])
    }

    /// Whether a ray from the point crosses the boundary an odd number of times.
    pub fn is_inside(&self, point: Point) -> bool {
        self.edges.iter().map(|edge| edge.crossings(point)).sum::<usize>() % 2 == 1
    }

    /// The distance to the nearest piece of boundary or wall.
    pub fn distance(&self, point: Point) -> f64 {
        let edges = self.edges.iter().map(|edge| edge.distance(point));
        let walls = self.walls.iter().map(|[a, b]| Edge::Line(*a, *b).distance(point));
        edges.chain(walls).fold(f64::INFINITY, f64::min)
    }

    /// How far a ball reaches past the boundary: its radius, less the distance inside.
    pub fn depth(&self, point: Point, radius: f64) -> f64 {
        let distance = self.distance(point);
        radius - if self.is_inside(point) { distance } else { -distance }
    }
}

impl Edge {
    fn of(piece: &Piece) -> Self {
        match piece {
            Piece::Line { line, .. } => Self::Line(line[0], line[1]),
            Piece::Arc { arc: ArcShape { center, radius, from_deg, to_deg }, .. } => {
                let from = if from_deg < to_deg { from_deg } else { to_deg };
                let sector =
                    Sector { from: from.to_radians(), sweep: (to_deg - from_deg).abs().to_radians() };
                Self::Arc(*center, *radius, sector)
            }
        }
    }

    fn circle(center: Point, radius: f64) -> Self {
        Self::Arc(center, radius, Sector { from: 0.0, sweep: 7.0 })
    }

    fn crossings(&self, point: Point) -> usize {
        match self {
            Self::Line(a, b) => {
                // Half open in the coordinate across the ray, so that a ray through a joint crosses once.
                let side = |p: Point| cross(RAY, minus(p, point)) > 0.0;
                let along = minus(*b, *a);
                let reach = cross(minus(*a, point), along) / cross(RAY, along);
                usize::from(side(*a) != side(*b) && reach > 0.0)
            }
            Self::Arc(center, radius, sector) => {
                let offset = minus(point, *center);
                let half = dot(offset, RAY);
                let discriminant = half * half - (dot(offset, offset) - radius * radius);
                if discriminant <= 0.0 {
                    return 0;
                }
                let root = discriminant.sqrt();
                let hits = |reach: f64| reach > 0.0 && sector.has(plus(offset, RAY, reach));
                usize::from(hits(-half - root)) + usize::from(hits(-half + root))
            }
        }
    }

    fn distance(&self, point: Point) -> f64 {
        match self {
            Self::Line(a, b) => {
                let along = minus(*b, *a);
                let part = (dot(minus(point, *a), along) / dot(along, along)).clamp(0.0, 1.0);
                norm(minus(point, plus(*a, along, part)))
            }
            Self::Arc(center, radius, sector) => {
                let offset = minus(point, *center);
                if sector.has(offset) {
                    return (norm(offset) - radius).abs();
                }
                let end = |angle: f64| plus(*center, [libm::cos(angle), libm::sin(angle)], *radius);
                let [first, last] = [sector.from, sector.from + sector.sweep].map(end);
                norm(minus(point, first)).min(norm(minus(point, last)))
            }
        }
    }
}

impl Sector {
    fn has(&self, ray: Point) -> bool {
        let turn = core::f64::consts::TAU;
        let angle = libm::atan2(ray[1], ray[0]) - self.from;
        angle - turn * libm::floor(angle / turn) <= self.sweep
    }
}

fn bounds(edges: &[Edge]) -> (Point, Point) {
    let (mut min, mut max) = ([f64::INFINITY; 2], [-f64::INFINITY; 2]);
    let mut include = |point: Point| {
        for axis in 0..2 {
            min[axis] = min[axis].min(point[axis]);
            max[axis] = max[axis].max(point[axis]);
        }
    };
    for edge in edges {
        match edge {
            Edge::Line(a, b) => [*a, *b].into_iter().for_each(&mut include),
            Edge::Arc(center, radius, sector) => {
                let rays = (0..=360).map(|k| sector.from + sector.sweep.min(6.3) * f64::from(k) / 360.0);
                rays.for_each(|a| include(plus(*center, [libm::cos(a), libm::sin(a)], *radius)));
            }
        }
    }
    (min, max)
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn plus(a: Point, b: Point, factor: f64) -> Point {
    [a[0] + b[0] * factor, a[1] + b[1] * factor]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn norm(a: Point) -> f64 {
    dot(a, a).sqrt()
}
