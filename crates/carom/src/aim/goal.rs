//! Where a ball has to come to be in a pocket.

use super::obstacle::{Circle, Obstacle};
use crate::geometry::{Piece, Segment, Vec2};
use crate::model::Pocket;

/// The hole of a pocket, and its mouth, where it has one: whichever a centre meets first.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    hole: Circle,
    /// From one horn tip to the other; the table lies to the left.
    mouth: Option<Segment<f64>>,
}

impl Goal {
    pub fn new(pocket: &Pocket<f64>) -> Self {
        let mouth = pocket.tips.map(|[start, end]| Segment { start, end });
        Self { hole: Circle { center: pocket.center, radius: pocket.radius }, mouth }
    }

    /// How far along a ray from `start` a centre has passed both jaws, or is over the hole; none where the ray passes the
    /// pocket.
    pub fn passage(&self, start: Vec2<f64>, unit: Vec2<f64>) -> Option<f64> {
        let way = self.entry(start, unit)? + self.mouth.map_or(0.0, |mouth| mouth.along().norm());
        Some(self.hole.entry(start, unit).map_or(way, |hole| if hole < way { hole } else { way }))
    }

    /// How far along a ray from `start` a centre is in the pocket; none where the ray passes it.
    pub fn entry(&self, start: Vec2<f64>, unit: Vec2<f64>) -> Option<f64> {
        let into_hole = self.hole.entry(start, unit);
        let into_mouth = self
            .mouth
            .filter(|mouth| is_before(mouth, start))
            .and_then(|mouth| crossing(&mouth, start, unit));
        match (into_hole, into_mouth) {
            (Some(a), Some(b)) => Some(if b < a { b } else { a }),
            (a, b) => a.or(b),
        }
    }

    /// Whether a ball that lies at a point behind the mouth is in the way of every ball that comes so near to it.
    pub fn is_closed_by(&self, point: Vec2<f64>, reach: f64) -> bool {
        self.mouth.is_some_and(|mouth| {
            let middle = mouth.start + mouth.along() * 0.5;
            let throat = Piece::Line(Segment { start: middle, end: self.hole.center });
            !is_before(&mouth, point) && throat.foot(point).distance < reach
        })
    }

    /// The points to which rays from `eye` lead that meet the end of the mouth or the edge of the hole.
    pub fn edges(&self, eye: Vec2<f64>) -> Vec<Vec2<f64>> {
        let tips = self.mouth.iter().flat_map(|mouth| [mouth.start, mouth.end]);
        self.hole.tangents(eye).into_iter().chain(tips).collect()
    }

    /// The points on the rim of the hole or on the mouth where a centre just touches something.
    pub fn meetings(&self, obstacle: &Obstacle) -> Vec<Vec2<f64>> {
        let of_mouth = self.mouth.iter().flat_map(|mouth| obstacle.meetings_with_line(mouth));
        obstacle.meetings(&self.hole).into_iter().chain(of_mouth).collect()
    }
}

fn is_before(mouth: &Segment<f64>, point: Vec2<f64>) -> bool {
    mouth.along().cross(point - mouth.start) > 0.0
}

/// How far along a ray it crosses a segment from the left.
fn crossing(segment: &Segment<f64>, start: Vec2<f64>, unit: Vec2<f64>) -> Option<f64> {
    let (along, between) = (segment.along(), start - segment.start);
    let sine = along.cross(unit);
    let part = between.cross(unit) / sine;
    (sine < 0.0 && (0.0..=1.0).contains(&part)).then(|| between.cross(along) / sine)
}
