//! Where two pieces of boundary cross or touch.

use super::{Arc, Piece, Segment, Vec2};

/// How two pieces meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetingKind {
    /// Each passes through the other.
    Cross,
    /// They have a point in common but neither passes through the other there: an end, or a tangent.
    Touch,
    /// They have a stretch in common, in the same direction.
    Along,
    /// They have a stretch in common, in opposite directions: they lie back to back.
    Against,
}

/// A place where two pieces meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// How they meet.
    pub kind: MeetingKind,
    /// Where: for a stretch, one point of it.
    pub point: Vec2<f64>,
}

/// The places where two pieces meet; what is nearer than `tolerance`, a length, counts as common.
pub fn meetings(first: &Piece<f64>, second: &Piece<f64>, tolerance: f64) -> Vec<Meeting> {
    if let Some(stretch) = common_stretch(first, second, tolerance) {
        return vec![stretch];
    }
    let (points, tangent) = match (first, second) {
        (Piece::Line(a), Piece::Line(b)) => (lines_meet(a, b), false),
        (Piece::Line(line), Piece::Arc(arc)) | (Piece::Arc(arc), Piece::Line(line)) => {
            line_meets_circle(line, arc, tolerance)
        }
        (Piece::Arc(a), Piece::Arc(b)) => circles_meet(a, b, tolerance),
    };
    let is_end = |point| is_near_end(first, point, tolerance) || is_near_end(second, point, tolerance);
    let meeting = |point| {
        let kind = if tangent || is_end(point) { MeetingKind::Touch } else { MeetingKind::Cross };
        Meeting { kind, point }
    };
    let is_common = |point: &Vec2<f64>| {
        first.foot(*point).distance <= tolerance && second.foot(*point).distance <= tolerance
    };
    points.into_iter().filter(is_common).map(meeting).collect()
}

/// A stretch that both pieces run along: they lie on one line or circle, and a point inside one is inside the other.
fn common_stretch(first: &Piece<f64>, second: &Piece<f64>, tolerance: f64) -> Option<Meeting> {
    let on_one_curve = match (first, second) {
        (Piece::Line(a), Piece::Line(b)) => {
            let unit = a.along().unit();
            [b.start, b.end].into_iter().all(|end| unit.cross(end - a.start).abs() <= tolerance)
        }
        (Piece::Arc(a), Piece::Arc(b)) => {
            (a.center - b.center).norm() <= tolerance && (a.radius - b.radius).abs() <= tolerance
        }
        _ => false,
    };
    if !on_one_curve {
        return None;
    }
    let is_inside = |piece: &Piece<f64>, point| {
        piece.foot(point).distance <= tolerance && !is_near_end(piece, point, tolerance)
    };
    let candidates = |from: &Piece<f64>| [from.middle(), from.start(), from.end()];
    let point = candidates(first)
        .into_iter()
        .find(|point| is_inside(second, *point))
        .or_else(|| candidates(second).into_iter().find(|point| is_inside(first, *point)))?;
    let same = first.direction_at(point).dot(second.direction_at(point)) > 0.0;
    Some(Meeting { kind: if same { MeetingKind::Along } else { MeetingKind::Against }, point })
}

/// Whether a point is one of the ends of a piece; a full circle has none.
fn is_near_end(piece: &Piece<f64>, point: Vec2<f64>, tolerance: f64) -> bool {
    let full = matches!(piece, Piece::Arc(arc) if arc.is_full_circle());
    !full && [piece.start(), piece.end()].into_iter().any(|end| (end - point).norm() <= tolerance)
}

fn lines_meet(a: &Segment<f64>, b: &Segment<f64>) -> Vec<Vec2<f64>> {
    let (along_a, along_b) = (a.along(), b.along());
    let part = (b.start - a.start).cross(along_b) / along_a.cross(along_b);
    if part.is_finite() { vec![a.start + along_a * part] } else { Vec::new() }
}

fn line_meets_circle(line: &Segment<f64>, arc: &Arc<f64>, tolerance: f64) -> (Vec<Vec2<f64>>, bool) {
    let unit = line.along().unit();
    let foot = line.start + unit * (arc.center - line.start).dot(unit);
    let reach = (foot - arc.center).norm();
    if (reach - arc.radius).abs() <= tolerance {
        return (vec![foot], true);
    }
    (on_both_sides(foot, unit, half_chord(arc.radius, reach)), false)
}

fn circles_meet(a: &Arc<f64>, b: &Arc<f64>, tolerance: f64) -> (Vec<Vec2<f64>>, bool) {
    let between = b.center - a.center;
    let distance = between.norm();
    if distance <= tolerance {
        return (Vec::new(), false);
    }
    let unit = between * (1.0 / distance);
    // The common chord crosses the line of centres at this distance from the centre of a.
    let reach = (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance) / 2.0;
    let touch_outside = (distance - (a.radius + b.radius)).abs() <= tolerance;
    let touch_inside = (distance - (a.radius - b.radius).abs()).abs() <= tolerance;
    if touch_outside || touch_inside {
        return (vec![a.center + unit * a.radius.copysign(reach)], true);
    }
    (on_both_sides(a.center + unit * reach, unit.left(), half_chord(a.radius, reach)), false)
}

/// Half the chord of a circle at a distance from its centre; not a number where there is none.
fn half_chord(radius: f64, reach: f64) -> f64 {
    ((radius - reach) * (radius + reach)).sqrt()
}

fn on_both_sides(foot: Vec2<f64>, unit: Vec2<f64>, half: f64) -> Vec<Vec2<f64>> {
    if half.is_nan() { Vec::new() } else { vec![foot + unit * half, foot + unit * -half] }
}

#[cfg(test)]
mod tests {
    use super::MeetingKind::{Against, Along, Cross, Touch};
    use super::*;

    fn line(start: [f64; 2], end: [f64; 2]) -> Piece<f64> {
        Piece::Line(Segment { start: Vec2::from_f64(start), end: Vec2::from_f64(end) })
    }

    fn arc(center: [f64; 2], radius: f64, from: f64, to: f64) -> Piece<f64> {
        Piece::Arc(Arc::from_degrees(Vec2::from_f64(center), radius, from, to))
    }

    fn kinds(a: &Piece<f64>, b: &Piece<f64>) -> Vec<MeetingKind> {
        let kinds = |a, b| meetings(a, b, 1e-9).into_iter().map(|meeting| meeting.kind).collect::<Vec<_>>();
        let result = kinds(a, b);
        assert_eq!(kinds(b, a), result, "the order of the pieces does not matter");
        result
    }

    #[test]
    fn lines_cross_touch_and_miss() {
        let base = line([0.0, 0.0], [4.0, 0.0]);
        assert_eq!(kinds(&base, &line([1.0, -1.0], [2.0, 1.0])), [Cross]);
        assert_eq!(kinds(&base, &line([1.0, 0.0], [2.0, 1.0])), [Touch]);
        assert_eq!(kinds(&base, &line([4.0, 0.0], [4.0, 1.0])), [Touch]);
        assert_eq!(kinds(&base, &line([5.0, -1.0], [5.0, 1.0])), []);
        assert_eq!(kinds(&base, &line([0.0, 1.0], [4.0, 1.0])), []);
        // Two lines that continue each other meet nowhere but at their joint, which is nobody's concern.
        assert_eq!(kinds(&base, &line([4.0, 0.0], [6.0, 0.0])), []);
    }

    #[test]
    fn pieces_share_a_stretch_along_or_against() {
        let base = line([0.0, 0.0], [4.0, 0.0]);
        assert_eq!(kinds(&base, &line([3.0, 0.0], [6.0, 0.0])), [Along]);
        assert_eq!(kinds(&base, &line([4.0, 0.0], [0.0, 0.0])), [Against]);
        assert_eq!(kinds(&base, &line([2.0, 0.0], [1.0, 0.0])), [Against]);
        let round = arc([0.0, 0.0], 1.0, 0.0, 100.0);
        assert_eq!(kinds(&round, &arc([0.0, 0.0], 1.0, 90.0, 190.0)), [Along]);
        assert_eq!(kinds(&round, &arc([0.0, 0.0], 1.0, 190.0, 90.0)), [Against]);
        assert_eq!(kinds(&round, &arc([0.0, 0.0], 1.0, 100.0, 200.0)), []);
        assert_eq!(kinds(&arc([0.0, 0.0], 1.0, 0.0, 360.0), &arc([0.0, 0.0], 1.0, 90.0, 450.0)), [Along]);
    }

    #[test]
    fn lines_and_arcs_cross_touch_and_miss() {
        let round = arc([0.0, 0.0], 1.0, 0.0, 180.0);
        assert_eq!(kinds(&round, &line([-2.0, 0.5], [2.0, 0.5])), [Cross, Cross]);
        assert_eq!(kinds(&round, &line([0.0, 0.5], [2.0, 0.5])), [Cross]);
        assert_eq!(kinds(&round, &line([-2.0, 1.0], [2.0, 1.0])), [Touch]);
        assert_eq!(kinds(&round, &line([-2.0, -0.5], [2.0, -0.5])), []);
        assert_eq!(kinds(&round, &line([0.5, 0.0], [1.0, 0.0])), [Touch]);
        assert_eq!(kinds(&arc([0.0, 0.0], 1.0, 0.0, 360.0), &line([0.5, 0.0], [1.5, 0.0])), [Cross]);
    }

    #[test]
    fn arcs_cross_touch_and_miss() {
        let circle = |x, radius| arc([x, 0.0], radius, 0.0, 360.0);
        assert_eq!(kinds(&circle(0.0, 1.0), &circle(1.0, 1.0)), [Cross, Cross]);
        assert_eq!(kinds(&circle(0.0, 1.0), &circle(2.0, 1.0)), [Touch]);
        assert_eq!(kinds(&circle(0.0, 3.0), &circle(2.0, 1.0)), [Touch]);
        assert_eq!(kinds(&circle(0.0, 3.0), &circle(-2.0, 1.0)), [Touch]);
        assert_eq!(kinds(&circle(0.0, 3.0), &circle(1.0, 1.0)), []);
        assert_eq!(kinds(&circle(0.0, 1.0), &circle(3.0, 1.0)), []);
        assert_eq!(kinds(&circle(0.0, 1.0), &circle(0.0, 2.0)), []);
        let (upper, right) = (arc([0.0, 0.0], 1.0, 0.0, 180.0), arc([1.0, 0.0], 1.0, 90.0, 270.0));
        assert_eq!(kinds(&upper, &right), [Cross]);
    }
}
