//! Where two pieces of boundary meet.

use super::Piece;
use crate::scalar::Scalar;

/// How sharply the boundary turns from one piece to the next: the sine of the angle, positive to the left.
///
/// Where the angle is more than a quarter turn, ±1; where the boundary turns right back, the side is that on which the
/// pieces bend apart, and a line that is run through there and back turns right, so that its end sticks out.
pub fn turn<S: Scalar>(before: &Piece<S>, after: &Piece<S>) -> S {
    let (arriving, leaving) = (before.end_direction(), after.start_direction());
    let (sine, cosine) = (arriving.cross(leaving), arriving.dot(leaving));
    if cosine > S::ZERO {
        return sine;
    }
    let reversal = S::from_f64(1e-12);
    let right = if sine.abs() > reversal {
        sine < S::ZERO
    } else {
        // Along the arriving direction, the table lies above κ_a s²/2 and below −κ_b s²/2, a distance s before the tip.
        before.curvature() + after.curvature() >= S::ZERO
    };
    if right { -S::ONE } else { S::ONE }
}

impl<S: Scalar> Piece<S> {
    /// The inverse radius, positive where the piece bends to the left.
    pub fn curvature(&self) -> S {
        match self {
            Piece::Line(_) => S::ZERO,
            Piece::Arc(arc) if arc.counter_clockwise => S::ONE / arc.radius,
            Piece::Arc(arc) => -(S::ONE / arc.radius),
        }
    }
}
