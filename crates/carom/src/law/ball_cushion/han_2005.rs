//! The blow at the nose on a ball that the cloth keeps down.
//!
//! With x into the cushion, y along it, z up, and for a ball on the cloth v_z = 0:
//!
//! ```text
//! s_x = v_x sinθ + R ω_y                                                                      (1)
//! s_y = −v_y − R ω_z cosθ + R ω_x sinθ                                                        (2)
//! P_zE = (1 + e) m v_x cosθ ,   P_zS = (2/7) m |s|                                            (3)
//! (P_xE, P_yE) = (2/7) m s  if P_zS ≤ μ P_zE,  else  μ P_zE s/|s|                             (4)
//! P_X = −P_xE sinθ − P_zE cosθ ,  P_Y = P_yE ,  P_Z = P_xE cosθ − P_zE sinθ                   (5)
//! dv_x = P_X/m ,  dv_y = P_Y/m                                                                (6)
//! dω = (5/(2mR)) (−P_Y sinθ, P_X sinθ − P_Z cosθ, P_Y cosθ)                                   (7)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | θ | contact angle: the nose touches R sin θ above the centre | rad |
//! | s | slip at the nose, against the friction | m/s |
//! | P_zE, P_xE, P_yE | impulse along the normal of the nose and across it | kg m/s |
//! | P_zS | normal impulse whose friction stops the slip, times μ | kg m/s |
//! | P_X, P_Y, P_Z | the same impulse in x, y and z | kg m/s |
//!
//! That is the impact of a sphere on a plane, (1) to (5), after which the cloth or the air takes the vertical part: (6).
//!
//! Source: Han (2005), whose own coefficients are `e = 0.39 + 0.257 u − 0.044 u²` of the closing speed u in m/s and
//! `μ = 0.471 − 0.241 θ` of the angle θ of incidence in rad.

use super::CushionHit;
use crate::geometry::Vec3;
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[Reference {
    law: "ball_cushion.han_2005",
    text: "I. Han, Dynamics in carom and three cushion billiards, Journal of Mechanical Science and Technology 19 (2005) 976–984",
    doi: Some("10.1007/BF02919180"),
}];

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Han2005<S> {
    /// Coefficient of restitution e.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ with the nose.
    pub friction: IncidenceFriction<S>,
}

impl<S: Scalar> Han2005<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        let blow = hit.blow(restitution, hit.friction(&self.friction));
        Twist { velocity: Vec3::above(blow.velocity.plan(), S::ZERO), ..blow }
    }
}
