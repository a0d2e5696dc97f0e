//! Meetings on the cloth: those of discs, with a cheap proof first that there is none.

use crate::detect::{Surroundings, detect_ball_ball, detect_ball_cushion};
use crate::flight::{Flight, SphereFlight};
use crate::geometry::{Bounds, Vec2};
use crate::model::{ContactTolerance, Face, Hole};
use crate::scalar::Scalar;

/// Two balls on the cloth, whose centres are `2 √(R₁ R₂)` apart in plan when they touch.
pub(super) fn detect_ball<S: Scalar>(
    a: &SphereFlight<S>,
    b: &SphereFlight<S>,
    [radius_a, radius_b]: [S; 2],
    tolerance: &ContactTolerance<S>,
    horizon: S,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    let distance = contact_distance(radius_a, radius_b);
    if are_apart(&a.plan, &b.plan, distance, horizon) {
        return None;
    }
    detect_ball_ball([&a.plan, &b.plan], None, distance, tolerance, false, seen)
        .filter(|offset| *offset <= horizon)
}

/// The distance in plan of the centres of two balls that lie on the cloth and touch.
#[inline(always)]
fn contact_distance<S: Scalar>(radius_a: S, radius_b: S) -> S {
    if radius_a == radius_b { radius_a + radius_b } else { S::from_f64(2.0) * (radius_a * radius_b).sqrt() }
}

/// Whether two flights stay further apart than `distance` for the time `horizon`: they part, or the path of one as seen
/// from the other stays clear.
#[inline(always)]
fn are_apart<S: Scalar>(a: &Flight<S>, b: &Flight<S>, distance: S, horizon: S) -> bool {
    let start = a.later_start(b);
    let (after_a, after_b) = (start - a.start, start - b.start);
    let between = b.position_after(after_b) - a.position_after(after_a);
    let velocity = b.velocity_after(after_b) - a.velocity_after(after_a);
    let acceleration = b.acceleration - a.acceleration;
    let distance = distance * S::from_f64(1.0 + 1e-6);
    let parts = between.dot(velocity) > S::ZERO && between.dot(acceleration) >= S::ZERO;
    if parts && between.norm_squared() > distance.squared() {
        return true;
    }
    if horizon >= S::INFINITY {
        return false;
    }
    let path = Bounds::of_path(between, velocity, acceleration, horizon);
    path.is_apart(&Bounds { min: Vec2::ZERO, max: Vec2::ZERO }, distance)
}

/// The offset at which a ball on the cloth meets a cushion, whose nose it touches at the distance `reach` in plan.
#[inline]
pub fn detect_nose<S: Scalar>(
    flight: &SphereFlight<S>,
    reach: S,
    face: &Face<S>,
    tolerance: S,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    if is_far(&flight.plan, reach + tolerance, face, flight.length) {
        return None;
    }
    detect_ball_cushion(&flight.plan, reach, face, tolerance, false, seen)
        .filter(|offset| *offset <= flight.length)
}

/// Whether a flight stays further than `reach` from a cushion.
#[inline(always)]
fn is_far<S: Scalar>(flight: &Flight<S>, reach: S, face: &Face<S>, length: S) -> bool {
    match face {
        Face::Line(line) => {
            let slope = line.normal.dot(flight.velocity);
            let bend = line.normal.dot(flight.acceleration) * S::from_f64(0.5);
            let closing = |rate: S| if rate < S::ZERO { rate } else { S::ZERO };
            let gap = line.height(flight.position) - reach;
            gap > S::ZERO && gap + (closing(slope) + closing(bend) * length) * length > S::ZERO
        }
        Face::Round(_) => false,
    }
}

/// The offset at which the centre of a ball on the cloth comes over a pocket.
pub fn detect_pocket<S: Scalar>(flight: &SphereFlight<S>, hole: &Hole<S>, tolerance: S) -> Option<S> {
    let mut seen = Surroundings::CLEAR;
    detect_nose(flight, S::ZERO, &hole.rim, tolerance, &mut seen)
}
