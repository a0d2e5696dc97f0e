//! Closed chains of pieces: the area they enclose and how far inside them a point lies.

use super::{Foot, FootAt, Piece, Vec2, turn};
use crate::scalar::Scalar;

/// The area enclosed, positive where the chain runs counter-clockwise.
pub fn signed_area(pieces: &[Piece<f64>]) -> f64 {
    let origin = pieces.first().map_or(Vec2::ZERO, Piece::start);
    let part = |piece: &Piece<f64>| {
        let chord = (piece.start() - origin).cross(piece.end() - origin);
        chord
            + if let Piece::Arc(arc) = piece {
                let angle = arc.sweep_deg.to_radians();
                let beyond_chord = arc.radius.squared() * (angle - angle.cos_sin().1);
                if arc.counter_clockwise { beyond_chord } else { -beyond_chord }
            } else {
                0.0
            }
    };
    pieces.iter().map(part).sum::<f64>() / 2.0
}

/// The distance of a point to a closed chain of pieces: positive on the left of the chain, where the table is.
///
/// The sign is that of the side of the nearest piece; where the nearest point is a joint, the side there. An empty
/// chain is infinitely far away.
pub fn signed_distance(pieces: &[Piece<f64>], point: Vec2<f64>) -> f64 {
    let mut nearest: Option<(usize, Foot)> = None;
    for (index, piece) in pieces.iter().enumerate() {
        let foot = piece.foot(point);
        if nearest.is_none_or(|(_, known)| foot.distance < known.distance) {
            nearest = Some((index, foot));
        }
    }
    let Some((index, foot)) = nearest else { return f64::INFINITY };
    let count = pieces.len();
    let on_left = match foot.at {
        FootAt::Inside => is_on_left(&pieces[index], point),
        FootAt::Start => joint_has_on_left(&pieces[(index + count - 1) % count], &pieces[index], point),
        FootAt::End => joint_has_on_left(&pieces[index], &pieces[(index + 1) % count], point),
    };
    if on_left { foot.distance } else { -foot.distance }
}

fn is_on_left(piece: &Piece<f64>, point: Vec2<f64>) -> bool {
    match piece {
        Piece::Line(line) => line.along().cross(point - line.start) >= 0.0,
        Piece::Arc(arc) => ((point - arc.center).norm() <= arc.radius) == arc.counter_clockwise,
    }
}

/// Whether a point whose nearest point is a joint lies left of it: at a sharp joint the side follows from the turn,
/// at a nearly straight one from the common direction.
fn joint_has_on_left(before: &Piece<f64>, after: &Piece<f64>, point: Vec2<f64>) -> bool {
    let common = before.end_direction() + after.start_direction();
    if common.norm_squared() > 1.0 {
        common.cross(point - after.start()) >= 0.0
    } else {
        turn(before, after) < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Segment};

    fn polygon(corners: &[[f64; 2]]) -> Vec<Piece<f64>> {
        let corner = |index: usize| Vec2::from_f64(corners[index % corners.len()]);
        let side = |index| Piece::Line(Segment { start: corner(index), end: corner(index + 1) });
        (0..corners.len()).map(side).collect()
    }

    #[test]
    fn areas_of_a_square_a_disc_and_a_stadium() {
        let square = polygon(&[[5.0, 5.0], [7.0, 5.0], [7.0, 7.0], [5.0, 7.0]]);
        assert_eq!(signed_area(&square), 4.0);
        let disc = [Piece::Arc(Arc::from_degrees(Vec2::new(3.0, 4.0), 2.0, 360.0, 0.0))];
        assert!((signed_area(&disc) + 4.0 * core::f64::consts::PI).abs() < 1e-14);
        let mut stadium = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        stadium[1] = Piece::Arc(Arc::from_degrees(Vec2::new(2.0, 1.0), 1.0, -90.0, 90.0));
        stadium[3] = Piece::Arc(Arc::from_degrees(Vec2::new(0.0, 1.0), 1.0, 90.0, 270.0));
        assert!((signed_area(&stadium) - 4.0 - core::f64::consts::PI).abs() < 1e-14);
        assert_eq!(signed_distance(&stadium, Vec2::new(2.0, 1.0)), 1.0);
        assert_eq!(signed_distance(&stadium, Vec2::new(2.5, 1.0)), 0.5);
        assert_eq!(signed_distance(&stadium, Vec2::new(-2.0, 1.0)), -1.0);
    }

    #[test]
    fn distances_in_an_l_have_the_right_sign_at_both_kinds_of_corner() {
        let l_shape = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
        let distance = |x, y| signed_distance(&l_shape, Vec2::new(x, y));
        assert_eq!(distance(0.5, 0.5), 0.5);
        assert_eq!(distance(1.5, 1.5), -0.5);
        assert_eq!(distance(-3.0, -4.0), -5.0);
        assert_eq!(distance(0.7, 0.6), 0.5);
        assert_eq!(distance(4.0, 0.5), -2.0);
    }

    #[test]
    fn a_slit_has_the_table_beyond_its_ends_and_a_cusp_has_not() {
        let slit = polygon(&[[0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(signed_distance(&slit, Vec2::new(2.0, 0.0)), 1.0);
        assert_eq!(signed_distance(&slit, Vec2::new(-3.0, 4.0)), 5.0);
        let bulge = |x: f64, y: f64, from: f64| {
            Piece::Arc(Arc::from_degrees(Vec2::new(x, y), 1.0, from, from - 90.0))
        };
        // An astroid-like table of four arcs that bulge into it; its cusps are at (0, 1), (-1, 0), (0, -1), (1, 0).
        let astroid = [
            bulge(1.0, 1.0, 270.0),
            bulge(-1.0, 1.0, 360.0),
            bulge(-1.0, -1.0, 90.0),
            bulge(1.0, -1.0, 180.0),
        ];
        assert!(signed_area(&astroid) > 0.0);
        assert!(signed_distance(&astroid, Vec2::new(0.0, 0.0)) > 0.4);
        assert_eq!(signed_distance(&astroid, Vec2::new(0.0, 1.5)), -0.5);
    }
}
