//! Restitution with a normal and a tangential factor: `v_n → −e v_n`, `v_t → β v_t`.
//!
//! `elastic` is e = β = 1; `damping` with one factor α, the law of the course exercise, is e = β = α. The energy lost is
//! `½ m [(1 − e²) v_n² + (1 − β²) v_t²]`.
//!
//! Source: Newton (1687) for e; the factor β is the course exercise's.

use super::{CushionHit, Rebound};
use crate::geometry::Vec2;
use crate::law::Reference;
use crate::law::reference::newton;
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[newton("ball_cushion.restitution")];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution<S> {
    /// Factor e of the normal velocity, from 0 to 1.
    pub normal: S,
    /// Factor β of the tangential velocity, from 0 to 1.
    pub tangential: S,
}

impl<S: Scalar> Restitution<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self { normal: S::ONE, tangential: S::ONE };

    #[inline(always)]
    pub(super) fn restitution(&self, _closing_speed: S) -> S {
        self.normal
    }

    #[inline(always)]
    pub(super) fn rebound(
        &self,
        velocity: Vec2<S>,
        (normal, scale): (Vec2<S>, S),
        restitution: S,
    ) -> Rebound<S> {
        let normal_velocity = velocity.dot(normal) * scale;
        let turned = normal * ((self.tangential + restitution) * normal_velocity);
        let tangential_squared = velocity.norm_squared() - normal_velocity.squared();
        let lost = (S::ONE - restitution.squared()) * normal_velocity.squared()
            + (S::ONE - self.tangential.squared()) * tangential_squared;
        Rebound {
            velocity: velocity * self.tangential - turned,
            normal_velocity,
            energy_loss: S::from_f64(0.5) * lost,
        }
    }

    /// Along the normal and across it a sphere does as a disc; in the air that normal is the nose's. Its spin stays.
    #[inline(always)]
    pub(super) fn rebound_of_sphere(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        let normal = hit.closing_normal();
        let Twist { velocity, spin } = hit.twist;
        let turned = normal * ((self.tangential + restitution) * velocity.dot(normal));
        Twist { velocity: velocity * self.tangential - turned, spin }
    }

    pub(super) fn slide(&self, velocity: Vec2<S>, (normal, scale): (Vec2<S>, S)) -> Option<Vec2<S>> {
        if self.tangential == S::ONE {
            return None;
        }
        let along_normal = normal * (velocity.dot(normal) * scale);
        Some(along_normal + (velocity - along_normal) * self.tangential)
    }

    pub(super) fn is_lossless(&self) -> bool {
        self.normal == S::ONE && self.tangential == S::ONE
    }

    pub(super) fn is_dead(&self) -> bool {
        self.normal == S::ZERO && self.tangential == S::ZERO
    }
}
