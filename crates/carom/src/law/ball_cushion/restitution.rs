//! Restitution with a normal and a tangential factor: `v_n → −e v_n`, `v_t → β v_t`.
//!
//! `elastic` is e = β = 1; `damping` with one factor α, the law of the course exercise, is e = β = α. The energy lost is
//! `½ m [(1 − e²) v_n² + (1 − β²) v_t²]`.

use crate::geometry::Vec2;
use crate::scalar::Scalar;

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution<S> {
    /// Factor e of the normal velocity, from 0 to 1.
    pub normal: S,
    /// Factor β of the tangential velocity, from 0 to 1.
    pub tangential: S,
}

/// What a cushion does to a ball of unit mass.
#[derive(Clone, Copy, Debug)]
pub struct Rebound<S> {
    /// Velocity after the contact.
    pub velocity: Vec2<S>,
    /// Normal velocity before the contact, negative while closing.
    pub normal_velocity: S,
    /// Kinetic energy lost.
    pub energy_loss: S,
}

impl<S: Scalar> Restitution<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self { normal: S::ONE, tangential: S::ONE };

    /// The velocity after a contact with unit normal `normal`, whose squared length as rounded is `1 / normal_scale`.
    #[inline(always)]
    pub fn rebound(&self, velocity: Vec2<S>, normal: Vec2<S>, normal_scale: S) -> Rebound<S> {
        let normal_velocity = velocity.dot(normal) * normal_scale;
        let turned = normal * ((self.tangential + self.normal) * normal_velocity);
        let tangential_squared = velocity.norm_squared() - normal_velocity.squared();
        let lost = (S::ONE - self.normal.squared()) * normal_velocity.squared()
            + (S::ONE - self.tangential.squared()) * tangential_squared;
        Rebound {
            velocity: velocity * self.tangential - turned,
            normal_velocity,
            energy_loss: S::from_f64(0.5) * lost,
        }
    }

    /// The velocity with its tangential part scaled, the normal part as it is.
    pub fn scale_tangential(&self, velocity: Vec2<S>, normal: Vec2<S>, normal_scale: S) -> Vec2<S> {
        let along_normal = normal * (velocity.dot(normal) * normal_scale);
        along_normal + (velocity - along_normal) * self.tangential
    }
}
