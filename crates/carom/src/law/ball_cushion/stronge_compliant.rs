//! StrongeCompliant.

use super::CushionHit;
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::law::reference::newton;
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[newton("ball_cushion.stronge_compliant")];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrongeCompliant<S> {
    /// Coefficient of restitution e.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ.
    pub friction: IncidenceFriction<S>,
    /// Frequency of the tangential spring over that of the normal one, from 1 to 2.
    pub frequency_ratio: S,
}

impl<S: Scalar> StrongeCompliant<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        hit.blow(restitution, hit.friction(&self.friction))
    }
}
