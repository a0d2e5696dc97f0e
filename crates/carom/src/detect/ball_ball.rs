//! When two balls meet.

use super::Surroundings;
use crate::flight::Flight;
use crate::geometry::{Vec2, Vector};
use crate::model::{ContactTolerance, closing_threshold};
use crate::roots::{Polynomial, first_contact};
use crate::scalar::Scalar;

/// Two flights seen from a common moment, the later of their starts: the second ball relative to the first.
pub struct Relative<S> {
    /// That moment.
    pub start: S,
    position: Vec2<S>,
    velocity: Vec2<S>,
    /// The velocities that this is the difference of.
    speeds: [Vec2<S>; 2],
}

impl<S: Scalar> Relative<S> {
    /// Two straight flights, the second seen elsewhere by `shift` than it says, on the other side of a periodic table.
    #[inline(always)]
    pub fn straight(a: &Flight<S>, b: &Flight<S>, shift: Option<Vec2<S>>) -> Self {
        let start = a.later_start(b);
        let (after_a, after_b) = (start - a.start, start - b.start);
        let position = (b.position + b.velocity * after_b) - (a.position + a.velocity * after_a);
        Self {
            start,
            position: shifted(position, shift),
            velocity: b.velocity - a.velocity,
            speeds: [a.velocity, b.velocity],
        }
    }

    fn new(a: &Flight<S>, b: &Flight<S>, shift: Option<Vec2<S>>) -> Self {
        let start = a.later_start(b);
        let (after_a, after_b) = (start - a.start, start - b.start);
        let (velocity_a, velocity_b) = (a.velocity_after(after_a), b.velocity_after(after_b));
        Self {
            start,
            position: shifted(b.position_after(after_b) - a.position_after(after_a), shift),
            velocity: velocity_b - velocity_a,
            speeds: [velocity_a, velocity_b],
        }
    }

    /// The gap as a polynomial sees it: `|Δ|² − r²`.
    #[inline(always)]
    pub fn squared_gap(&self, radii: S) -> S {
        self.position.norm_squared() - radii.squared()
    }

    /// Whether the two come nearer to each other.
    #[inline(always)]
    pub fn closes(&self) -> bool {
        self.position.dot(self.velocity) < S::ZERO
    }

    /// The offset at which two balls in straight flight meet that are as far apart as `gap` says, which is positive; infinite
    /// for a miss.
    ///
    /// `s = c / (−b + √D)` is free of cancellation as `b < 0`. `D = |w|² r² − (Δ × w)²` instead of `b² − |w|² c`: the two are
    /// equal, but this one keeps its accuracy in a graze from far away.
    #[inline(always)]
    pub fn meeting(&self, gap: S, radii: S) -> S {
        let slope = self.position.dot(self.velocity);
        if slope >= S::ZERO {
            return S::INFINITY;
        }
        let miss = self.position.cross(self.velocity);
        let discriminant = self.velocity.norm_squared() * radii.squared() - miss.squared();
        if discriminant > S::ZERO { gap / (discriminant.sqrt() - slope) } else { S::INFINITY }
    }
}

/// The second of two balls seen elsewhere; as it is where it is not, and not even zero is added.
#[inline(always)]
fn shifted<S: Scalar>(position: Vec2<S>, shift: Option<Vec2<S>>) -> Vec2<S> {
    match shift {
        Some(shift) => position + shift,
        None => position,
    }
}

/// The offset, from the later start of the two flights, at which two balls meet; `None` when they never do.
///
/// `radii` is the sum of the radii, which must be positive. Notes contact (unless they have just been `struck`) and overlap
/// at the start in `seen`. On a periodic table the second ball may be seen elsewhere, by a `shift`, than its flight says.
pub fn detect_ball_ball<S: Scalar>(
    [a, b]: [&Flight<S>; 2],
    shift: Option<Vec2<S>>,
    radii: S,
    tolerance: &ContactTolerance<S>,
    struck: bool,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    let relative = Relative::new(a, b, shift);
    let gap = relative.squared_gap(radii);
    let tolerance = squared_tolerance(tolerance, radii);
    if gap > tolerance && a.acceleration == b.acceleration {
        let offset = relative.meeting(gap, radii);
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
    let relative = Relative::straight(a, b, None);
    let gap = relative.squared_gap(radii);
    (gap > squared_tolerance(tolerance, radii)).then(|| relative.meeting(gap, radii))
}

/// The contact tolerance of the squared gap: `(r + δ)² − r²`, to first order `2 r δ`.
#[inline(always)]
pub fn squared_tolerance<S: Scalar>(tolerance: &ContactTolerance<S>, radii: S) -> S {
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
