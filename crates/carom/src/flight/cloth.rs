//! The cloth: which motion a ball begins, and how long that lasts.

use super::Flight;
use super::sphere::{Motion, SphereFlight, rolling_spin};
use crate::geometry::{Vec2, Vec3};
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// The cloth, and what pulls balls onto it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cloth<S> {
    /// Gravity g; zero is legal: then nothing slows a ball.
    pub gravity: S,
    /// Restitution of a ball that falls onto it.
    pub restitution: S,
    /// Friction of a landing; none for each ball's own sliding friction.
    pub friction: Option<S>,
    /// Hops lower than this are left out.
    pub min_hop: S,
    /// Whether balls leave the cloth at all.
    pub has_air: bool,
}

/// Speeds below this many roundings of those that they are the difference of are round-off.
const ROUND_OFF: f64 = 16.0;

/// The same as a part of the speed √(2 g R) of a fall by a radius, for what is left of contacts one after the other: with
/// it a ball would roll 1e-22 of its radius.
const STANDSTILL: f64 = 1e-12;

impl<S: Scalar> Cloth<S> {
    /// Whether a ball on the cloth with this velocity upwards leaves it.
    pub fn lets_hop(&self, rise: S) -> bool {
        self.has_air && rise > S::ZERO && rise.squared() > S::from_f64(2.0) * self.gravity * self.min_hop
    }

    /// The flight that a ball begins.
    ///
    /// `scale` is the size of the speeds that the motion is the difference of: slips and velocities that are round-off of
    /// it are none.
    pub fn begin(
        &self,
        sphere: &Sphere<S>,
        start: S,
        position: Vec3<S>,
        twist: Twist<S>,
        scale: S,
    ) -> SphereFlight<S> {
        if position.z > sphere.radius || twist.velocity.z > S::ZERO {
            return self.airborne(sphere, start, position, twist);
        }
        let fall = (S::from_f64(2.0) * self.gravity * sphere.radius).sqrt();
        let threshold = scale * S::from_f64(ROUND_OFF * S::EPSILON) + fall * S::from_f64(STANDSTILL);
        let position = Vec3::new(position.x, position.y, sphere.radius);
        let (velocity, slip) = (twist.velocity.plan(), twist.slip(sphere.radius));
        let (slip_speed, speed) = (slip.norm(), velocity.norm());
        let mut flight = SphereFlight::still(Motion::Resting, start, position);
        flight.spin = Vec3::new(S::ZERO, S::ZERO, twist.spin.z);
        flight.spin_rate.z = self.spin_decay(sphere, twist.spin.z);
        if slip_speed > threshold {
            self.slide(&mut flight, sphere, &twist, slip, slip_speed);
        } else if speed > threshold {
            self.roll(&mut flight, sphere, velocity, speed);
        } else if twist.spin.z != S::ZERO {
            flight.motion = Motion::Spinning;
            flight.length = quotient(twist.spin.z.abs(), sphere.spin_decay);
        }
        flight
    }

    fn airborne(
        &self,
        sphere: &Sphere<S>,
        start: S,
        position: Vec3<S>,
        Twist { velocity, spin }: Twist<S>,
    ) -> SphereFlight<S> {
        let fall = position.z - sphere.radius;
        let rise = velocity.z;
        let speed = (rise.squared() + S::from_f64(2.0) * self.gravity * fall).sqrt();
        // The later root, in the form without cancellation.
        let length = if rise >= S::ZERO {
            quotient(rise + speed, self.gravity)
        } else {
            S::from_f64(2.0) * fall / (speed - rise)
        };
        let plan =
            Flight { start, position: position.plan(), velocity: velocity.plan(), acceleration: Vec2::ZERO };
        SphereFlight {
            motion: Motion::Airborne,
            plan,
            height: position.z,
            rise,
            lift: -self.gravity,
            spin,
            spin_rate: Vec3::ZERO,
            length,
        }
    }

    fn slide(
        &self,
        flight: &mut SphereFlight<S>,
        sphere: &Sphere<S>,
        twist: &Twist<S>,
        slip: Vec2<S>,
        slip_speed: S,
    ) {
        let braking = sphere.sliding * self.gravity;
        let direction = Vec2::new(slip.x / slip_speed, slip.y / slip_speed);
        let gain = S::from_f64(2.5) * braking / sphere.radius;
        flight.motion = Motion::Sliding;
        flight.plan.velocity = twist.velocity.plan();
        flight.plan.acceleration = direction * -braking;
        flight.spin = twist.spin;
        flight.spin_rate = Vec3::new(-direction.y * gain, direction.x * gain, flight.spin_rate.z);
        flight.length = quotient(S::from_f64(2.0) * slip_speed, S::from_f64(7.0) * braking);
    }

    fn roll(&self, flight: &mut SphereFlight<S>, sphere: &Sphere<S>, velocity: Vec2<S>, speed: S) {
        let braking = sphere.rolling * self.gravity;
        let acceleration = Vec2::new(velocity.x / speed, velocity.y / speed) * -braking;
        flight.motion = Motion::Rolling;
        (flight.plan.velocity, flight.plan.acceleration) = (velocity, acceleration);
        (flight.spin.x, flight.spin.y) = rolling_spin(velocity, sphere.radius);
        (flight.spin_rate.x, flight.spin_rate.y) = rolling_spin(acceleration, sphere.radius);
        flight.length = quotient(speed, braking);
    }

    /// The rate at which the spin about the vertical changes.
    fn spin_decay(&self, sphere: &Sphere<S>, spin: S) -> S {
        if spin > S::ZERO {
            -sphere.spin_decay
        } else if spin < S::ZERO {
            sphere.spin_decay
        } else {
            S::ZERO
        }
    }
}

/// How long something lasts that goes down at a rate: for ever at none.
fn quotient<S: Scalar>(amount: S, rate: S) -> S {
    if rate > S::ZERO { amount / rate } else { S::INFINITY }
}
