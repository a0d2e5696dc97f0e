//! Hops too low to see: how balls under pressure go on.
//!
//! A ball that friction presses against another, or against a cushion, would meet it without end. It is let part with a
//! hop of a given speed instead, which all its motion pays for, so that the energy stays; what has not enough comes to
//! rest.

use crate::geometry::Vec3;
use crate::law::ball_ball::SphereImpact;
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// A hop that would need more than this part of the energy there is does not happen.
const LARGEST_PART: f64 = 0.75;

/// Two balls that are to part by so much faster.
pub(super) fn hop_apart<S: Scalar>(
    balls: [(Sphere<S>, Twist<S>); 2],
    normal: Vec3<S>,
    speed: S,
) -> SphereImpact<S> {
    let [(a, twist_a), (b, twist_b)] = balls;
    let impulse = speed / (a.inverse_mass + b.inverse_mass);
    let mut twists = [
        twist_a.after_impulse(&a, normal, -normal * impulse),
        twist_b.after_impulse(&b, -normal, normal * impulse),
    ];
    let before = a.kinetic_energy(&twist_a) + b.kinetic_energy(&twist_b);
    let after = a.kinetic_energy(&twists[0]) + b.kinetic_energy(&twists[1]);
    pay(&mut twists, before, after);
    SphereImpact { twists, impulse }
}

/// A ball that is to leave a cushion by so much faster along a normal.
pub(super) fn hop_away<S: Scalar>(
    sphere: &Sphere<S>,
    twist: Twist<S>,
    normal: Vec3<S>,
    speed: S,
) -> Twist<S> {
    let mut twists = [Twist { velocity: twist.velocity + normal * speed, ..twist }];
    let (before, after) = (sphere.kinetic_energy(&twist), sphere.kinetic_energy(&twists[0]));
    pay(&mut twists, before, after);
    twists[0]
}

/// Slows all motion until the energy is what it was, or stops it where there is too little.
fn pay<S: Scalar>(twists: &mut [Twist<S>], before: S, after: S) {
    if after <= before {
        return;
    }
    if after - before > after * S::from_f64(LARGEST_PART) {
        twists.iter_mut().for_each(stop);
        return;
    }
    // A few roundings less than all of it, so that the energy does not rise by one.
    let factor = (before / after).sqrt() * S::from_f64(1.0 - 4.0 * f64::EPSILON);
    for twist in twists {
        twist.velocity = twist.velocity * factor;
        twist.spin = twist.spin * factor;
    }
}

/// Brings a ball to a stop; spinning in place it may.
pub(super) fn stop<S: Scalar>(twist: &mut Twist<S>) {
    *twist = Twist { velocity: Vec3::ZERO, spin: Vec3::new(S::ZERO, S::ZERO, twist.spin.z) };
}
