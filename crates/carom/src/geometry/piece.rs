//! The pieces a boundary is made of: line segments and circular arcs, each with a direction.
//!
//! A piece faces the left of its direction: the table lies there. So the outer boundary of a table runs
//! counter-clockwise and an obstacle clockwise; a counter-clockwise arc is hollow (the table is inside its circle), a
//! clockwise one bulges into the table.

use super::Vec2;
use crate::scalar::{Scalar, direction};

/// A directed line segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment<S> {
    /// First point.
    pub start: Vec2<S>,
    /// Last point.
    pub end: Vec2<S>,
}

/// A directed circular arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc<S> {
    /// Centre of the circle.
    pub center: Vec2<S>,
    /// Radius of the circle.
    pub radius: S,
    /// Unit vector from the centre to the first point.
    pub from: Vec2<S>,
    /// Unit vector from the centre to the last point.
    pub to: Vec2<S>,
    /// Whether the arc runs counter-clockwise, which makes it hollow.
    pub counter_clockwise: bool,
    /// The angle swept, in degrees, between 0 and 360; 360 is a full circle.
    pub sweep_deg: f64,
}

/// A piece of boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece<S> {
    /// A line segment.
    Line(Segment<S>),
    /// A circular arc.
    Arc(Arc<S>),
}

impl<S: Scalar> Segment<S> {
    /// The vector from the first point to the last.
    pub fn along(&self) -> Vec2<S> {
        self.end - self.start
    }
}

impl<S: Scalar> Arc<S> {
    /// The arc of a circle between two angles in degrees: counter-clockwise when `to_deg > from_deg`, else clockwise.
    pub fn from_degrees(center: Vec2<S>, radius: S, from_deg: S, to_deg: S) -> Self {
        let unit = |degrees| {
            let (x, y) = direction(degrees);
            Vec2::new(x, y)
        };
        Self {
            center,
            radius,
            from: unit(from_deg),
            to: unit(to_deg),
            counter_clockwise: to_deg > from_deg,
            sweep_deg: (to_deg - from_deg).to_f64().abs(),
        }
    }

    /// The same arc from its last point to its first.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from, counter_clockwise: !self.counter_clockwise, ..*self }
    }

    /// Whether the arc is a full circle, which has no end points.
    pub fn is_full_circle(&self) -> bool {
        self.sweep_deg >= 360.0
    }

    /// Whether the ray from the centre along `ray` meets the arc, up to a distance `tolerance` past both ends
    /// (`ray` and `tolerance` in units of length, `ray` not longer than a table).
    pub fn spans(&self, ray: Vec2<S>, tolerance: S) -> bool {
        if self.is_full_circle() {
            return true;
        }
        let (first, last) = if self.counter_clockwise { (self.from, self.to) } else { (self.to, self.from) };
        let after_first = first.cross(ray) >= -tolerance;
        let before_last = ray.cross(last) >= -tolerance;
        if self.sweep_deg <= 180.0 {
            // Both half planes also meet opposite the arc, within the tolerance of the centre line.
            after_first && before_last && ray.dot(first + last) >= -tolerance
        } else {
            after_first || before_last
        }
    }
}

impl<S: Scalar> Piece<S> {
    /// The first point.
    pub fn start(&self) -> Vec2<S> {
        match self {
            Piece::Line(line) => line.start,
            Piece::Arc(arc) => arc.center + arc.from * arc.radius,
        }
    }

    /// The last point.
    pub fn end(&self) -> Vec2<S> {
        match self {
            Piece::Line(line) => line.end,
            Piece::Arc(arc) => arc.center + arc.to * arc.radius,
        }
    }

    /// The unit direction at the first point.
    pub fn start_direction(&self) -> Vec2<S> {
        match self {
            Piece::Line(line) => line.along().unit(),
            Piece::Arc(arc) => arc.direction_at(arc.from),
        }
    }

    /// The unit direction at the last point.
    pub fn end_direction(&self) -> Vec2<S> {
        match self {
            Piece::Line(line) => line.along().unit(),
            Piece::Arc(arc) => arc.direction_at(arc.to),
        }
    }
}

impl<S: Scalar> Arc<S> {
    fn direction_at(&self, ray: Vec2<S>) -> Vec2<S> {
        if self.counter_clockwise { ray.left() } else { -ray.left() }
    }
}
