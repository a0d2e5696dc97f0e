//! The point of a piece that is nearest to a given point.

use super::{Arc, Piece, Segment, Vec2};
use crate::scalar::direction;

/// Where on its piece a foot lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FootAt {
    /// At the first point.
    Start,
    /// Between the ends.
    Inside,
    /// At the last point.
    End,
}

/// The point of a piece that is nearest to a given point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The nearest point.
    pub point: Vec2<f64>,
    /// The distance to it, zero or positive.
    pub distance: f64,
    /// Where on the piece it lies.
    pub at: FootAt,
}

impl Piece<f64> {
    /// The point of the piece that is nearest to `point`.
    pub fn foot(&self, point: Vec2<f64>) -> Foot {
        match self {
            Piece::Line(line) => line.foot(point),
            Piece::Arc(arc) => arc.foot(point),
        }
    }

    /// The unit direction of the piece at one of its points.
    pub fn direction_at(&self, point: Vec2<f64>) -> Vec2<f64> {
        match self {
            Piece::Line(line) => line.along().unit(),
            Piece::Arc(arc) if arc.counter_clockwise => (point - arc.center).unit().left(),
            Piece::Arc(arc) => -(point - arc.center).unit().left(),
        }
    }

    /// The length along the piece.
    pub fn length(&self) -> f64 {
        match self {
            Piece::Line(line) => line.along().norm(),
            Piece::Arc(arc) => arc.radius * arc.sweep_deg.to_radians(),
        }
    }

    /// The point half-way along the piece.
    pub fn middle(&self) -> Vec2<f64> {
        match self {
            Piece::Line(line) => line.start + line.along() * 0.5,
            Piece::Arc(arc) => {
                let half = if arc.counter_clockwise { arc.sweep_deg / 2.0 } else { -arc.sweep_deg / 2.0 };
                let (cos, sin) = direction(half);
                arc.center + (arc.from * cos + arc.from.left() * sin) * arc.radius
            }
        }
    }
}

impl Segment<f64> {
    fn foot(&self, point: Vec2<f64>) -> Foot {
        let along = self.along();
        let part = (point - self.start).dot(along) / along.norm_squared();
        let (foot, at) = if part <= 0.0 {
            (self.start, FootAt::Start)
        } else if part >= 1.0 {
            (self.end, FootAt::End)
        } else {
            (self.start + along * part, FootAt::Inside)
        };
        Foot { point: foot, distance: (point - foot).norm(), at }
    }
}

impl Arc<f64> {
    fn foot(&self, point: Vec2<f64>) -> Foot {
        let ray = point - self.center;
        let reach = ray.norm();
        if self.spans(ray, 0.0) {
            let unit = if reach > 0.0 { ray * (1.0 / reach) } else { self.from };
            let distance = (self.radius - reach).abs();
            return Foot { point: self.center + unit * self.radius, distance, at: FootAt::Inside };
        }
        let (start, end) = (self.center + self.from * self.radius, self.center + self.to * self.radius);
        let (to_start, to_end) = ((point - start).norm(), (point - end).norm());
        if to_start <= to_end {
            Foot { point: start, distance: to_start, at: FootAt::Start }
        } else {
            Foot { point: end, distance: to_end, at: FootAt::End }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(from: f64, to: f64) -> Piece<f64> {
        Piece::Arc(Arc::from_degrees(Vec2::new(1.0, 2.0), 2.0, from, to))
    }

    #[test]
    fn the_foot_of_a_line_is_a_projection_or_an_end() {
        let line = Piece::Line(Segment { start: Vec2::new(0.0, 0.0), end: Vec2::new(4.0, 0.0) });
        let foot = |x, y| line.foot(Vec2::new(x, y));
        assert_eq!(foot(1.0, -2.0), Foot { point: Vec2::new(1.0, 0.0), distance: 2.0, at: FootAt::Inside });
        assert_eq!(foot(-3.0, 4.0), Foot { point: Vec2::new(0.0, 0.0), distance: 5.0, at: FootAt::Start });
        assert_eq!(foot(7.0, 4.0), Foot { point: Vec2::new(4.0, 0.0), distance: 5.0, at: FootAt::End });
    }

    #[test]
    fn the_foot_of_an_arc_is_on_its_circle_or_an_end() {
        let quarter = arc(0.0, 90.0);
        assert_eq!(quarter.foot(Vec2::new(4.0, 6.0)).distance, 3.0);
        assert_eq!(quarter.foot(Vec2::new(4.0, 6.0)).at, FootAt::Inside);
        assert_eq!(quarter.foot(Vec2::new(3.0, -1.0)).at, FootAt::Start);
        assert_eq!(quarter.foot(Vec2::new(-1.0, 4.0)).at, FootAt::End);
        assert_eq!(arc(0.0, 360.0).foot(Vec2::new(1.0, 2.0)).distance, 2.0);
    }

    #[test]
    fn the_middle_of_an_arc_lies_half_way_in_its_own_direction() {
        assert_eq!(arc(0.0, 180.0).middle(), Vec2::new(1.0, 4.0));
        assert_eq!(arc(180.0, 0.0).middle(), Vec2::new(1.0, 4.0));
        assert_eq!(arc(180.0, 360.0).middle(), Vec2::new(1.0, 0.0));
        assert_eq!(arc(0.0, 360.0).middle(), Vec2::new(-1.0, 2.0));
    }
}
