//! Frictionless impact with a coefficient of restitution; `elastic` is the case e = 1.
//!
//! `J = (1 + e) m_red u`, with the reduced mass `m_red = m1 m2 / (m1 + m2)` and the closing speed
//! `u = (v1 − v2)·n`; then `v1 −= J n / m1`, `v2 += J n / m2`. The energy lost is `½ m_red (1 − e²) u²`.
//!
//! Source: any text on mechanics, e.g. Halliday, Resnick, Walker, *Fundamentals of Physics*, chapter 9.

use crate::geometry::Vec2;
use crate::model::Disc;
use crate::scalar::Scalar;

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution<S> {
    /// Coefficient of restitution e, from 0 to 1.
    pub normal: S,
}

/// The contact of two discs.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S> {
    /// Distance of the centres.
    pub distance: S,
    /// Unit vector from the first ball to the second.
    pub normal: Vec2<S>,
    /// Speed at which the gap closes.
    pub closing_speed: S,
    /// Reduced mass of the two.
    pub reduced_mass: S,
}

impl<S: Scalar> Restitution<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self { normal: S::ONE };

    /// The normal impulse J.
    pub fn impulse(&self, pair: &Pair<S>) -> S {
        (S::ONE + self.normal) * pair.reduced_mass * pair.closing_speed
    }

    /// The kinetic energy that the contact takes away.
    pub fn energy_loss(&self, pair: &Pair<S>) -> S {
        let kept = S::ONE - self.normal.squared();
        S::from_f64(0.5) * pair.reduced_mass * kept * pair.closing_speed.squared()
    }
}

impl<S: Scalar> Pair<S> {
    /// The contact of two discs whose centres are `separation` apart (from the first to the second).
    pub fn new(discs: [&Disc<S>; 2], separation: Vec2<S>, velocities: [Vec2<S>; 2]) -> Self {
        let distance = separation.norm();
        let normal = Vec2::new(separation.x / distance, separation.y / distance);
        let closing_speed = (velocities[0] - velocities[1]).dot(normal);
        let reduced_mass = S::ONE / (discs[0].inverse_mass + discs[1].inverse_mass);
        Self { distance, normal, closing_speed, reduced_mass }
    }
}
