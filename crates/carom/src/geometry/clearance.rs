//! How near a straight path comes to a piece.

use super::{Arc, Piece, Segment, Vec2};
use crate::scalar::Scalar;

/// The least distance between a straight path and a piece; zero where they meet. A path may be a single point.
pub fn clearance(path: &Segment<f64>, piece: &Piece<f64>) -> f64 {
    if path.along() == Vec2::ZERO {
        return piece.foot(path.start).distance;
    }
    let crosses = match piece {
        Piece::Line(line) => lines_cross(path, line),
        Piece::Arc(arc) => line_crosses_arc(path, arc),
    };
    if crosses {
        return 0.0;
    }
    let line = Piece::Line(*path);
    let from_path = [path.start, path.end].map(|end| piece.foot(end).distance);
    let from_piece = [piece.start(), piece.end()].map(|end| line.foot(end).distance);
    let inside = match piece {
        Piece::Line(_) => f64::INFINITY,
        // Where both points lie inside, the line between them runs through the centre, square to the path.
        Piece::Arc(arc) => piece.foot(line.foot(arc.center).point).distance,
    };
    from_path
        .into_iter()
        .chain(from_piece)
        .fold(inside, |least, distance| if distance < least { distance } else { least })
}

fn lines_cross(a: &Segment<f64>, b: &Segment<f64>) -> bool {
    let parts = |line: &Segment<f64>, other: &Segment<f64>| {
        line.along().cross(other.start - line.start) * line.along().cross(other.end - line.start) < 0.0
    };
    parts(a, b) && parts(b, a)
}

fn line_crosses_arc(line: &Segment<f64>, arc: &Arc<f64>) -> bool {
    let (length, unit) = (line.along().norm(), line.along().unit());
    let middle = unit.dot(arc.center - line.start);
    let off = unit.cross(arc.center - line.start);
    // Half the chord; not a number, which is in no range, where the line misses the circle.
    let half = (arc.radius.squared() - off.squared()).sqrt();
    [middle - half, middle + half]
        .into_iter()
        .any(|part| (0.0..=length).contains(&part) && arc.spans(line.start + unit * part - arc.center, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn path(start: [f64; 2], end: [f64; 2]) -> Segment<f64> {
        Segment { start: Vec2::from_f64(start), end: Vec2::from_f64(end) }
    }

    #[test]
    fn of_a_line_it_is_between_ends_or_zero() {
        let wall = Piece::Line(path([0.0, 0.0], [4.0, 0.0]));
        assert_eq!(clearance(&path([1.0, 2.0], [3.0, 1.0]), &wall), 1.0);
        assert_eq!(clearance(&path([-3.0, 9.0], [-3.0, -4.0]), &wall), 3.0);
        assert_eq!(clearance(&path([1.0, 2.0], [1.0, -2.0]), &wall), 0.0);
        assert_eq!(clearance(&path([7.0, 4.0], [7.0, 4.0]), &wall), 5.0);
    }

    #[test]
    fn of_an_arc_it_is_to_its_round_or_to_an_end() {
        let bow = |from, to| Piece::Arc(Arc::from_degrees(Vec2::ZERO, 1.0, from, to));
        let over = path([-4.0, 3.0], [4.0, 3.0]);
        assert_eq!(clearance(&over, &bow(180.0, 0.0)), 2.0, "over the top");
        assert!((clearance(&over, &bow(270.0, 180.0)) - 3.0).abs() < 1e-15, "to the end at the left");
        let inside = path([0.0, 0.0], [0.5, 0.0]);
        assert_eq!(clearance(&inside, &bow(0.0, 360.0)), 0.5, "in a hollow arc");
        assert_eq!(clearance(&path([0.0, 0.0], [0.0, 2.0]), &bow(180.0, 0.0)), 0.0);
        assert_eq!(clearance(&path([0.0, 0.0], [0.0, -2.0]), &bow(180.0, 0.0)), 1.0);
    }
}
