//! The faces of cushions: the boundary as a ball meets it.

use crate::geometry::{Arc, Bounds, Piece, Vec2};
use crate::scalar::Scalar;

/// A piece of boundary made ready for detection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Face<S> {
    /// A straight cushion.
    Line(Line<S>),
    /// A circular cushion, or a corner point.
    Round(Round<S>),
}

/// A straight cushion, which faces the left of its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<S> {
    /// First point.
    pub start: Vec2<S>,
    /// Unit vector along it.
    pub along: Vec2<S>,
    /// Unit vector into the table.
    pub normal: Vec2<S>,
    /// One over the squared length of `normal` as rounded, so that a slanted wall does not feed or drain energy.
    pub normal_scale: S,
    /// Length.
    pub length: S,
    /// `normal · start`, from which heights are measured.
    pub level: S,
    /// `along · start`, from which feet are measured.
    pub origin: S,
}

/// A circular cushion: an arc, a full circle, or a corner point (a full circle of radius zero).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round<S> {
    /// The arc.
    pub arc: Arc<S>,
}

/// All faces of a table; where the first four are the walls of a rectangle along the axes, that is known, for they are
/// quicker to search.
#[derive(Clone, Debug)]
pub struct Faces<S> {
    /// The faces, in the order of their numbers.
    pub all: Vec<Face<S>>,
    /// The rectangle whose walls the first four faces are: bottom, right, top, left.
    pub room: Option<Room<S>>,
    /// Whether these walls are all there is.
    pub is_room: bool,
    /// Whether there is nothing to meet, not even walls: the table is periodic on both axes.
    pub is_open: bool,
}

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room<S> {
    /// Lower left corner.
    pub lower: Vec2<S>,
    /// Upper right corner.
    pub upper: Vec2<S>,
}

impl<S: Scalar> Faces<S> {
    /// The faces, searched for a room.
    pub fn new(all: Vec<Face<S>>) -> Self {
        let room = Room::of(&all);
        Self { is_room: room.is_some() && all.len() == 4, is_open: false, all, room }
    }

    /// Opens the sides of a room across the axes that are periodic: those walls are infinitely far away, and the others
    /// infinitely long.
    pub fn open(&mut self, [across_x, across_y]: [bool; 2]) {
        self.is_open = self.is_room && across_x && across_y;
        let Some(room) = &mut self.room else { return };
        let far = S::INFINITY;
        if across_x {
            (room.lower.x, room.upper.x) = (-far, far);
        }
        if across_y {
            (room.lower.y, room.upper.y) = (-far, far);
        }
        for (number, face) in self.all.iter_mut().enumerate().take(4) {
            let Face::Line(line) = face else { continue };
            // Bottom, right, top, left.
            let (is_open, is_endless) =
                if number % 2 == 0 { (across_y, across_x) } else { (across_x, across_y) };
            if is_open {
                line.level = -far;
            }
            if is_endless {
                (line.origin, line.length) = (-far, far);
            }
        }
    }

    /// The faces that are not walls of the room.
    pub fn others(&self) -> &[Face<S>] {
        let walls = if self.room.is_some() { 4 } else { 0 };
        self.all.get(walls..).unwrap_or_default()
    }
}

impl<S: Scalar> Room<S> {
    fn of(faces: &[Face<S>]) -> Option<Self> {
        let [Face::Line(bottom), Face::Line(right), Face::Line(top), Face::Line(left), ..] = faces else {
            return None;
        };
        let (x, y) = (Vec2::new(S::ONE, S::ZERO), Vec2::new(S::ZERO, S::ONE));
        let room =
            Self { lower: Vec2::new(left.level, bottom.level), upper: Vec2::new(-right.level, -top.level) };
        let is_along_axes = bottom.normal == y && right.normal == -x && top.normal == -y && left.normal == x;
        let is_closed =
            bottom.length == room.upper.x - room.lower.x && right.length == room.upper.y - room.lower.y;
        (is_along_axes && is_closed).then_some(room)
    }
}

impl<S: Scalar> Face<S> {
    /// The face of a piece of boundary.
    pub fn of_piece(piece: &Piece<S>) -> Self {
        match piece {
            Piece::Line(segment) => {
                let length = segment.along().norm();
                let along = segment.along().unit();
                let normal = along.left();
                let normal_scale = S::ONE / normal.norm_squared();
                let (level, origin) = (normal.dot(segment.start), along.dot(segment.start));
                Face::Line(Line { start: segment.start, along, normal, normal_scale, length, level, origin })
            }
            Piece::Arc(arc) => Face::Round(Round { arc: *arc }),
        }
    }

    /// The box around it; for an arc, around its whole circle.
    pub fn bounds(&self) -> Bounds<S> {
        match self {
            Face::Line(line) => {
                let end = line.start + line.along * line.length;
                Bounds::of_path(line.start, end - line.start, Vec2::ZERO, S::ONE)
            }
            Face::Round(round) => {
                let reach = Vec2::new(round.arc.radius, round.arc.radius);
                Bounds { min: round.arc.center - reach, max: round.arc.center + reach }
            }
        }
    }

    /// A corner point that balls of positive radius can hit.
    pub fn corner(point: Vec2<S>) -> Self {
        let arc = Arc::from_degrees(point, S::ZERO, S::from_f64(360.0), S::ZERO);
        Face::Round(Round { arc })
    }

    /// The point of the cushion nearest to `position`: where a ball that touches it does.
    pub fn foot(&self, position: Vec2<S>) -> Vec2<S> {
        match self {
            Face::Line(line) => position - line.normal * (line.height(position) * line.normal_scale),
            Face::Round(round) => round.arc.center + (position - round.arc.center).unit() * round.arc.radius,
        }
    }

    /// The unit vector into the table at the foot of `position`, with one over its squared length.
    pub fn normal_at(&self, position: Vec2<S>) -> (Vec2<S>, S) {
        match self {
            Face::Line(line) => (line.normal, line.normal_scale),
            Face::Round(round) => {
                let outward = (position - round.arc.center).unit();
                (if round.is_hollow() { -outward } else { outward }, S::ONE)
            }
        }
    }

    /// How fast what goes along it at some distance is carried into it, an acceleration: `v²/d` at a hollow one, d the
    /// distance from its centre; away from a round one, so less than zero there.
    pub fn bend(&self, position: Vec2<S>, velocity: Vec2<S>) -> S {
        match self {
            Face::Line(_) => S::ZERO,
            Face::Round(round) => {
                let ray = position - round.arc.center;
                let distance = ray.norm();
                let along = ray.cross(velocity) / distance;
                let bend = along.squared() / distance;
                if round.is_hollow() { bend } else { -bend }
            }
        }
    }
}

impl<S: Scalar> Line<S> {
    /// Signed distance of a point from the line, positive on the table's side.
    #[inline(always)]
    pub fn height(&self, point: Vec2<S>) -> S {
        self.normal.dot(point) - self.level
    }

    /// Whether the foot of a point lies on the segment, up to `tolerance` past both ends.
    #[inline(always)]
    pub fn spans(&self, point: Vec2<S>, tolerance: S) -> bool {
        let foot = self.along.dot(point) - self.origin;
        foot >= -tolerance && foot <= self.length + tolerance
    }
}

impl<S: Scalar> Round<S> {
    /// Whether the table lies inside the circle.
    pub fn is_hollow(&self) -> bool {
        self.arc.counter_clockwise
    }

    /// The distance from the circle's centre at which a ball of the given radius touches; negative when the ball is
    /// too large for a hollow arc.
    #[inline(always)]
    pub fn contact_distance(&self, radius: S) -> S {
        if self.is_hollow() { self.arc.radius - radius } else { self.arc.radius + radius }
    }
}
