//! Impulse by impulse, with the friction of the cloth.

use super::{Frictional, SphereImpact, SpherePair};
use crate::law::Reference;
use crate::law::coefficient::SlipFriction;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[Reference {
    law: "ball_ball.mathavan_2014",
    text: "S. Mathavan, M. R. Jackson, R. M. Parkin, Numerical simulations of the frictional collisions of solid balls on a rough surface, Sports Engineering 17 (2014) 227–237",
    doi: Some("10.1007/s12283-014-0158-y"),
}];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mathavan2014<S> {
    /// Coefficient of restitution e, from 0 to 1: its square is the part of the normal work given back.
    pub normal: S,
    /// Coefficient of friction between the balls; with the cloth it is the ball's own.
    pub friction: SlipFriction<S>,
}

impl<S: Scalar> Mathavan2014<S> {
    pub(super) fn impact(&self, pair: &SpherePair<S>, restitution: S) -> SphereImpact<S> {
        let law = Frictional { normal: self.normal, friction: self.friction, cling: S::ONE };
        law.impact(pair, restitution)
    }

    pub(super) fn is_lossless(&self) -> bool {
        self.normal == S::ONE && self.friction.is_zero()
    }
}
