//! Restitution and Coulomb friction in one blow.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | n | unit normal from ball 1 to ball 2 | – |
//! | e, μ | restitution, friction | – |
//! | m | reduced mass, `m1 m2 / (m1 + m2)` | kg |
//! | J_n | normal impulse, `(1 + e) m (v1 − v2)·n` | kg m/s |
//! | c | slip at the contact, the part of `v1 − v2 + (R1 ω1 + R2 ω2) × n` across n | m/s |
//! | J_t | friction impulse on ball 1, `−min(μ(│c│) J_n, (2/7) m │c│) ĉ` | kg m/s |
//!
//! Then `v1 += (J_t − J_n n)/m1`, `v2 += (J_n n − J_t)/m2`, `ω_k += 5/(2 m_k R_k) n × J_t`, the same sign for both. The
//! 2/7 comes from `dc = (7/2)(1/m1 + 1/m2) dJ_t`: in the second case the slip stops. The slip keeps its direction, so one
//! blow is the exact answer for a friction that does not change while the balls touch.
//!
//! Friction has a part along z where the cue ball rolls or draws: one ball is lifted and the other pressed on the cloth.
//! What the cloth does about it is not part of this law.
//!
//! Source: Alciatore, TP A.14, with the fit `μ(s) = a + b exp(−c s)` to Marlow's measurements. *Departs from source*:
//! there e = 1, both balls are alike and one is at rest; here neither need be so.

use super::{SphereImpact, SpherePair};
use crate::law::Reference;
use crate::law::coefficient::SlipFriction;
use crate::law::sphere_plane::friction_per_slip;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[
    Reference {
        law: "ball_ball.frictional",
        text: "D. G. Alciatore, TP A.14: The effects of cut angle, speed, and spin on object ball throw (rev. 2025), billiards.colostate.edu",
        doi: None,
    },
    Reference {
        law: "ball_ball.frictional",
        text: "W. C. Marlow, The Physics of Pocket Billiards (1995), table 10",
        doi: None,
    },
];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictional<S> {
    /// Coefficient of restitution e, from 0 to 1.
    pub normal: S,
    /// Coefficient of friction μ.
    pub friction: SlipFriction<S>,
    /// Factor of the friction between balls that cling.
    pub cling: S,
}

impl<S: Scalar> Frictional<S> {
    /// The coefficient of friction of contacts that slip at this speed, cling included.
    #[inline(always)]
    pub(super) fn friction(&self, slip_speed: S) -> S {
        self.cling * self.friction.at(slip_speed)
    }

    #[inline(always)]
    pub(super) fn impact(&self, pair: &SpherePair<S>, restitution: S) -> SphereImpact<S> {
        let reduced_mass = pair.reduced_mass();
        let impulse = (S::ONE + restitution) * reduced_mass * pair.closing_speed();
        let slip = pair.slip();
        let slip_speed = slip.norm();
        let stopping = S::from_f64(2.0) / S::from_f64(7.0) * reduced_mass;
        let largest = self.friction(slip_speed) * impulse;
        let rubbed = slip * -friction_per_slip(largest, stopping, slip_speed);
        pair.after_impulse(impulse, rubbed)
    }

    pub(super) fn is_lossless(&self) -> bool {
        self.normal == S::ONE && (self.friction.is_zero() || self.cling == S::ZERO)
    }
}
