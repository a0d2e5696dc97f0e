//! When two balls meet.

use super::Surroundings;
use crate::flight::Flight;
use crate::geometry::{Vec2, Vector};
use crate::model::{ContactTolerance, closing_threshold};
use crate::roots::{Polynomial, first_contact};
use crate::scalar::Scalar;

/// Two flights seen from a common moment, the later of their starts: the second ball relative to the first.
struct Relative<S> {
    position: Vec2<S>,
    velocity: Vec2<S>,
    /// The velocities that this is the difference of.
    speeds: [Vec2<S>; 2],
}

impl<S: Scalar> Relative<S> {
    #[inline(always)]
    fn straight(a: &Flight<S>, b: &Flight<S>) -> Self {
        let start = a.later_start(b);
        let (after_a, after_b) = (start - a.start, start - b.start);
        Self {
            position: (b.position + b.velocity * after_b) - (a.position + a.velocity * after_a),
            velocity: b.velocity - a.velocity,
            speeds: [a.velocity, b.velocity],
        }
    }

    fn new(a: &Flight<S>, b: &Flight<S>) -> Self {
        let start = a.later_start(b);
        let (after_a, after_b) = (start - a.start, start - b.start);
        let (velocity_a, velocity_b) = (a.velocity_after(after_a), b.velocity_after(after_b));
        Self {
            position: b.position_after(after_b) - a.position_after(after_a),
            velocity: velocity_b - velocity_a,
            speeds: [velocity_a, velocity_b],
        }
    }

    /// The gap as a polynomial sees it: `|Δ|² − r²`.
    #[inline(always)]
    fn squared_gap(&self, radii: S) -> S {
        self.position.norm_squared() - radii.squared()
    }
}

/// The offset, from the later start of the two flights, at which two balls meet; `None` when they never do.
///
/// `radii` is the sum of the radii, which must be positive. Notes contact (unless they have just been `struck`) and overlap
/// at the start in `seen`.
pub fn detect_ball_ball<S: Scalar>(
    a: &Flight<S>,
    b: &Flight<S>,
    radii: S,
    tolerance: &ContactTolerance<S>,
    struck: bool,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    let relative = Relative::new(a, b);
    let gap = relative.squared_gap(radii);
    let tolerance = squared_tolerance(tolerance, radii);
    if gap > tolerance && a.acceleration == b.acceleration {
        let offset = straight_meeting(&relative, gap, radii);
        return (offset < S::INFINITY).then_some(offset);
    }
    let tolerance = tolerance + rounding_of_time(a, b, &relative, radii);
    if gap <= tolerance {
        note_contact(gap, radii, tolerance, struck, seen);
    }
    detect_near(a, b, &relative, [gap, radii], tolerance)
}

/// The offset at which two balls in straight flight meet, infinite when they never do; `None` when they are so near each
/// other that [`detect_ball_ball`] has to be asked, of which this is the quick part.
#[inline(always)]
pub fn detect_ball_in_the_clear<S: Scalar>(
    a: &Flight<S>,
    b: &Flight<S>,
    radii: S,
    tolerance: &ContactTolerance<S>,
) -> Option<S> {
    let relative = Relative::straight(a, b);
    let gap = relative.squared_gap(radii);
    (gap > squared_tolerance(tolerance, radii)).then(|| straight_meeting(&relative, gap, radii))
}

/// The contact tolerance of the squared gap: `(r + δ)² − r²`, to first order `2 r δ`.
#[inline(always)]
fn squared_tolerance<S: Scalar>(tolerance: &ContactTolerance<S>, radii: S) -> S {
    S::from_f64(2.0) * radii * tolerance.of(radii)
}

/// What the rounding of the starts of two flights may have taken from their squared gap: late in a run it is more than
/// the contact tolerance, for a third ball that was just not touched by two that met.
#[cold]
fn rounding_of_time<S: Scalar>(a: &Flight<S>, b: &Flight<S>, relative: &Relative<S>, radii: S) -> S {
    let start = a.later_start(b);
    let speed = closing_threshold(relative.speeds[0], relative.speeds[1]);
    S::from_f64(2.0) * radii * speed * start.abs()
}

/// Two balls that touch, or whose accelerations differ.
#[cold]
fn detect_near<S: Scalar>(
    a: &Flight<S>,
    b: &Flight<S>,
    relative: &Relative<S>,
    [gap, radii]: [S; 2],
    tolerance: S,
) -> Option<S> {
    // A closing speed within round-off of zero is none; twice the threshold of the laws, so that what is found to close
    // here is closing for them too.
    let threshold = closing_threshold(relative.speeds[0], relative.speeds[1]) * S::from_f64(2.0) * radii;
    let slope = relative.position.dot(relative.velocity);
    let acceleration = b.acceleration - a.acceleration;
    if acceleration == Vec2::ZERO {
        return (slope < -threshold).then_some(S::ZERO);
    }
    let mut gap = squared_gap(relative.position, relative.velocity, acceleration, gap);
    let [start, slope_of_gap, ..] = gap.coefficients;
    if start.abs() <= tolerance && slope.abs() <= threshold {
        gap.coefficients[1] = slope_of_gap - slope_of_gap.detached();
    }
    first_contact(&gap, tolerance, |_| true)
}

/// Straight relative motion from apart: `s = c / (−b + √D)`, free of cancellation as `b < 0`; infinite for a miss.
///
/// `D = |w|² r² − (Δ × w)²` instead of `b² − |w|² c`: the two are equal, but this one keeps its accuracy in a graze
/// from far away.
#[inline(always)]
fn straight_meeting<S: Scalar>(relative: &Relative<S>, gap: S, radii: S) -> S {
    let slope = relative.position.dot(relative.velocity);
    if slope >= S::ZERO {
        return S::INFINITY;
    }
    let miss = relative.position.cross(relative.velocity);
    let discriminant = relative.velocity.norm_squared() * radii.squared() - miss.squared();
    if discriminant > S::ZERO { gap / (discriminant.sqrt() - slope) } else { S::INFINITY }
}

/// The squared gap `|Δ + w s + k s²|² − r²` with `k` half the relative acceleration, in the plane or in space.
pub(super) fn squared_gap<S: Scalar, V: Vector<S>>(
    position: V,
    velocity: V,
    acceleration: V,
    gap: S,
) -> Polynomial<S> {
    let two = S::from_f64(2.0);
    let half = acceleration * S::from_f64(0.5);
    Polynomial::new([
        gap,
        two * velocity.dot(position),
        velocity.dot(velocity) + two * half.dot(position),
        two * half.dot(velocity),
        half.dot(half),
    ])
}

#[cold]
fn note_contact<S: Scalar>(gap: S, radii: S, tolerance: S, struck: bool, seen: &mut Surroundings<S>) {
    seen.touching |= !struck && gap >= -tolerance;
    seen.broken |= gap < -tolerance;
    let overlap = -gap / (S::from_f64(2.0) * radii);
    if overlap > seen.overlap {
        seen.overlap = overlap;
    }
}
