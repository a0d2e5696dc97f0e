//! What the centre of a moving ball cannot come near, and the directions in which it just passes.

use crate::geometry::{Arc, Piece, Segment, Vec2, clearance};
use crate::scalar::Scalar;

/// Something that a ball touches when its centre comes within `reach` of it.
#[derive(Clone, Copy, Debug)]
pub struct Obstacle {
    core: Core,
    reach: f64,
}

#[derive(Clone, Copy, Debug)]
enum Core {
    Point(Vec2<f64>),
    Piece(Piece<f64>),
}

/// A circle.
#[derive(Clone, Copy, Debug)]
pub struct Circle {
    pub center: Vec2<f64>,
    pub radius: f64,
}

impl Obstacle {
    /// A ball or a hole.
    pub fn round(center: Vec2<f64>, reach: f64) -> Self {
        Self { core: Core::Point(center), reach }
    }

    /// A cushion.
    pub fn cushion(piece: Piece<f64>, reach: f64) -> Self {
        Self { core: Core::Piece(piece), reach }
    }

    /// Whether a centre that goes along a path stays clear of it, up to a tolerance.
    pub fn lets_pass(&self, path: &Segment<f64>, tolerance: f64) -> bool {
        let distance = match &self.core {
            Core::Point(point) if path.along() == Vec2::ZERO => (path.start - *point).norm(),
            Core::Point(point) => Piece::Line(*path).foot(*point).distance,
            Core::Piece(piece) => clearance(path, piece),
        };
        distance >= self.reach - tolerance
    }

    /// The points to which straight paths from `eye` lead that just pass it.
    pub fn tangents(&self, eye: Vec2<f64>) -> Vec<Vec2<f64>> {
        self.circles().iter().flat_map(|circle| circle.tangents(eye)).collect()
    }

    /// The points of a circle where a centre just touches it.
    pub fn meetings(&self, circle: &Circle) -> Vec<Vec2<f64>> {
        let round = self.circles().into_iter().flat_map(|own| own.meetings(circle));
        let straight = match &self.core {
            Core::Piece(Piece::Line(line)) => circle.meetings_with_line(line, self.reach),
            _ => Vec::new(),
        };
        round.chain(straight).collect()
    }

    /// The points of the line through a segment where a centre just touches it.
    pub fn meetings_with_line(&self, line: &Segment<f64>) -> Vec<Vec2<f64>> {
        let round = self.circles().into_iter().flat_map(|own| own.meetings_with_line(line, 0.0));
        let straight = match &self.core {
            Core::Piece(Piece::Line(own)) => lines_meet(line, own, self.reach),
            _ => None,
        };
        round.chain(straight).collect()
    }

    /// The circles of which the places of a centre that touches it are made; of a straight cushion those around its ends.
    fn circles(&self) -> Vec<Circle> {
        let around = |center| Circle { center, radius: self.reach };
        match &self.core {
            Core::Point(point) => vec![around(*point)],
            Core::Piece(piece) => {
                let ends = [piece.start(), piece.end()].map(around);
                let round = match piece {
                    Piece::Line(_) => None,
                    Piece::Arc(arc) => Some(self.beside(arc)),
                };
                ends.into_iter().chain(round).collect()
            }
        }
    }

    fn beside(&self, arc: &Arc<f64>) -> Circle {
        let inwards = if arc.counter_clockwise { -self.reach } else { self.reach };
        Circle { center: arc.center, radius: (arc.radius + inwards).abs() }
    }
}

impl Circle {
    /// The points in which straight lines from `eye` touch it; none from inside. From its rim, points along the tangent.
    pub fn tangents(&self, eye: Vec2<f64>) -> Vec<Vec2<f64>> {
        let between = self.center - eye;
        let distance = between.norm();
        let sin = self.radius / distance;
        if sin >= 1.0 {
            let along = if distance > 0.0 { between.unit().left() } else { return Vec::new() };
            // A ball in contact may lie inside by round-off.
            return if sin < 1.0 + 1e-6 { vec![eye + along, eye - along] } else { Vec::new() };
        }
        let cos = (1.0 - sin.squared()).sqrt();
        let (ahead, aside) = (between * cos.squared(), between.left() * (sin * cos));
        vec![eye + ahead + aside, eye + ahead - aside]
    }

    /// How far along a ray from `start` it is first met from outside; none where the ray passes or points away.
    pub fn entry(&self, start: Vec2<f64>, unit: Vec2<f64>) -> Option<f64> {
        let between = self.center - start;
        let (middle, off) = (between.dot(unit), between.cross(unit));
        let squared = self.radius.squared() - off.squared();
        if middle <= 0.0 || squared < 0.0 {
            return None;
        }
        let before = middle - squared.sqrt();
        Some(if before > 0.0 { before } else { 0.0 })
    }

    fn meetings(&self, other: &Self) -> Vec<Vec2<f64>> {
        let between = other.center - self.center;
        let distance = between.norm();
        let along = (distance + (self.radius.squared() - other.radius.squared()) / distance) / 2.0;
        let half = (self.radius.squared() - along.squared()).sqrt();
        let unit = between.unit();
        on_both_sides(self.center + unit * along, unit.left(), half)
    }

    /// Where it meets a line at a distance to the left of another.
    fn meetings_with_line(&self, line: &Segment<f64>, left: f64) -> Vec<Vec2<f64>> {
        let unit = line.along().unit();
        let start = line.start + unit.left() * left;
        let foot = start + unit * unit.dot(self.center - start);
        let half = (self.radius.squared() - (foot - self.center).norm_squared()).sqrt();
        on_both_sides(foot, unit, half)
    }
}

/// Where a line meets another that lies at a distance to the left of a third.
fn lines_meet(line: &Segment<f64>, other: &Segment<f64>, left: f64) -> Option<Vec2<f64>> {
    let start = other.start + other.along().unit().left() * left;
    let part = (start - line.start).cross(other.along()) / line.along().cross(other.along());
    part.is_finite().then(|| line.start + line.along() * part)
}

fn on_both_sides(foot: Vec2<f64>, unit: Vec2<f64>, half: f64) -> Vec<Vec2<f64>> {
    if half.is_nan() { Vec::new() } else { vec![foot + unit * half, foot + unit * -half] }
}
