//! The blow at the nose: the impact of a sphere on the plane that touches it there.
//!
//! The normal points from the nose to the centre of the ball, `cosθ n − sinθ ẑ`, with n level. The rest is the impact of a
//! sphere on a plane, `law/sphere_plane.rs`. It gives the ball a vertical velocity, mostly downwards: what the cloth does
//! about that is not part of this law.
//!
//! Source: Newton (1687) for the restitution, Coulomb (1785) for the friction.

use super::CushionHit;
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::law::reference::{coulomb, newton};
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] =
    &[newton("ball_cushion.frictional"), coulomb("ball_cushion.frictional")];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictional<S> {
    /// Coefficient of restitution e.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ with the nose.
    pub friction: IncidenceFriction<S>,
}

impl<S: Scalar> Frictional<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        hit.blow(restitution, hit.friction(&self.friction))
    }
}
