//! When balls on a cloth, or in the air above it, meet each other, cushions and pockets.
//!
//! Seen from above a flight on the cloth is a disc's in a field, so it is the discs' functions that are asked there, with
//! the distances at which spheres touch; only what is in the air needs more. A meeting later than the end of a flight is
//! none: after that end it is predicted anew.

mod air;
mod cloth;

pub use air::{Crossing, detect_nose_in_the_air, detect_pocket_from_above};
pub use cloth::{detect_nose, detect_pocket};

use super::Surroundings;
use crate::flight::{Motion, SphereFlight};
use crate::model::ContactTolerance;
use crate::scalar::Scalar;

/// The offset, from the later start of the two flights, at which two balls meet; `None` when they do not on these flights,
/// or not before `until`. `radii` are the balls'. Notes contact and overlap at the start in `seen`.
pub fn detect_spheres<S: Scalar>(
    a: &SphereFlight<S>,
    b: &SphereFlight<S>,
    radii: [S; 2],
    tolerance: &ContactTolerance<S>,
    until: S,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    if a.motion.is_still() && b.motion.is_still() {
        return None;
    }
    let horizon = common_length(a, b, until)?;
    if a.motion == Motion::Airborne || b.motion == Motion::Airborne {
        air::detect_ball(a, b, radii[0] + radii[1], tolerance, horizon)
    } else {
        cloth::detect_ball(a, b, radii, tolerance, horizon, seen)
    }
}

/// How long both flights last, from the later of their starts, up to a time; an event at that very time counts. `None` where
/// one has ended, for what that ball does next is another flight, and where the time is past.
fn common_length<S: Scalar>(a: &SphereFlight<S>, b: &SphereFlight<S>, until: S) -> Option<S> {
    let start = a.plan.later_start(&b.plan);
    let (left_a, left_b) = (a.length - (start - a.start()), b.length - (start - b.start()));
    let length = if left_a < left_b { left_a } else { left_b };
    let left = (until - start) + until.abs() * S::from_f64(4.0 * S::EPSILON);
    let horizon = if left < length { left } else { length };
    (length > S::ZERO && left >= S::ZERO).then_some(horizon)
}
