//! Frictional.

use super::CushionHit;
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::law::reference::newton;
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[newton("ball_cushion.frictional")];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictional<S> {
    /// Coefficient of restitution e.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ.
    pub friction: IncidenceFriction<S>,
}

impl<S: Scalar> Frictional<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        hit.blow(restitution, hit.friction(&self.friction))
    }
}
