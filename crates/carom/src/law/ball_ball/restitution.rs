//! Frictionless impact with a coefficient of restitution; `elastic` is the case e = 1.
//!
//! `J = (1 + e) m_red u`, with the reduced mass `m_red = m1 m2 / (m1 + m2)` and the closing speed
//! `u = (v1 − v2)·n`; then `v1 −= J n / m1`, `v2 += J n / m2`. The energy lost is `½ m_red (1 − e²) u²`. Spheres keep
//! their spins.
//!
//! Source: Newton (1687), who found that balls of one material part with a fixed fraction of the speed with which they
//! meet.

use super::{Impact, Pair, SphereImpact, SpherePair};
use crate::geometry::Vec3;
use crate::law::Reference;
use crate::law::reference::newton;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[newton("ball_ball.restitution")];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution<S> {
    /// Coefficient of restitution e, from 0 to 1.
    pub normal: S,
}

impl<S: Scalar> Restitution<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self { normal: S::ONE };

    #[inline(always)]
    pub(super) fn restitution(&self, _closing_speed: S) -> S {
        self.normal
    }

    #[inline(always)]
    pub(super) fn impact(&self, pair: &Pair<S>, restitution: S) -> Impact<S> {
        let lost = S::ONE - restitution.squared();
        Impact {
            impulse: (S::ONE + restitution) * pair.reduced_mass * pair.closing_speed,
            energy_loss: S::from_f64(0.5) * pair.reduced_mass * lost * pair.closing_speed.squared(),
        }
    }

    #[inline(always)]
    pub(super) fn impact_of_spheres(&self, pair: &SpherePair<S>, restitution: S) -> SphereImpact<S> {
        let impulse = (S::ONE + restitution) * pair.reduced_mass() * pair.closing_speed();
        pair.after_impulse(impulse, Vec3::ZERO)
    }

    pub(super) fn is_lossless(&self) -> bool {
        self.normal == S::ONE
    }
}
