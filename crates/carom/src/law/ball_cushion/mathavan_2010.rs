//! Impulse by impulse, with friction at the nose and on the cloth.
//!
//! The nose touches the ball above its centre and so presses it on the cloth: with y into the cushion and x along it, per
//! normal impulse P at the nose,
//!
//! ```text
//! A    = sinθ + μ_w sinΦ cosθ                                                                 (1)
//! dv_x = −(1/m) [μ_w cosΦ + μ_s cosΦ′ A] dP                                                   (2)
//! dv_y = −(1/m) [cosθ − μ_w sinθ sinΦ + μ_s sinΦ′ A] dP                                       (3)
//! dω_x = −5/(2mR) [μ_w sinΦ + μ_s sinΦ′ A] dP                                                 (4)
//! dω_y = −5/(2mR) [μ_w cosΦ sinθ − μ_s cosΦ′ A] dP                                            (5)
//! dω_z = 5/(2mR) μ_w cosΦ cosθ dP                                                             (6)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | θ | contact angle: the nose touches R sin θ above the centre | rad |
//! | Φ, Φ′ | direction of the slip at the nose, and on the cloth, from x | rad |
//! | μ_w, μ_s | friction with the nose, and the ball's with the cloth | – |
//! | A | load on the cloth per P | – |
//!
//! They follow from the two places alone: `law/gradual` makes them so and takes the steps, up to the work `e² W_c`. The
//! answer scales with the speed.
//!
//! Source: Mathavan, Jackson, Parkin (2010). *Departs from source*: a slip that stops is held while friction can hold it,
//! where there it flickers about zero, to the same end for small steps; A is none below zero, which with a large friction
//! it could be. The ball stays on the cloth, as there.

use super::CushionHit;
use crate::geometry::{Vec2, Vec3};
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::law::gradual::{Impulse, Touching, follow};
use crate::model::Twist;
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[Reference {
    law: "ball_cushion.mathavan_2010",
    text: "S. Mathavan, M. R. Jackson, R. M. Parkin, A theoretical analysis of billiard ball dynamics under cushion impacts, Proceedings of the Institution of Mechanical Engineers C 224 (2010) 1863–1873",
    doi: Some("10.1243/09544062JMES1964"),
}];

/// Parameters of the law. Of snooker the authors found e = 0.98 and μ_w = 0.14.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mathavan2010<S> {
    /// Coefficient of restitution e: its square is the part of the normal work given back.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ_w with the nose; with the cloth it is the ball's own.
    pub friction: IncidenceFriction<S>,
}

/// A ball between nose and cloth.
struct Wedged<'a, S> {
    hit: &'a CushionHit<S>,
    friction: S,
}

impl<S: Scalar> Mathavan2010<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        follow(&Wedged { hit, friction: hit.friction(&self.friction) }, hit.twist, restitution).0
    }
}

impl<S: Scalar> Wedged<'_, S> {
    /// Along the cushion, x.
    fn side(&self) -> Vec3<S> {
        Vec3::above(self.hit.normal.left(), S::ZERO)
    }

    /// Into the cushion, y.
    fn ahead(&self) -> Vec3<S> {
        Vec3::above(-self.hit.normal, S::ZERO)
    }

    /// Across x at the nose, away from the cloth.
    fn rise(&self) -> Vec3<S> {
        Vec3::above(self.hit.normal * self.hit.sin, self.hit.cos)
    }
}

impl<S: Scalar> Touching<S, 2> for Wedged<'_, S> {
    type Motion = Twist<S>;
    const REST: Twist<S> = Twist::REST;

    #[inline(always)]
    fn closing_speed(&self, twist: &Twist<S>) -> S {
        -twist.velocity.dot(self.hit.contact_normal())
    }

    #[inline(always)]
    fn slips(&self, twist: &Twist<S>) -> [Vec2<S>; 2] {
        let at_nose = twist.surface_velocity(self.hit.sphere.radius, -self.hit.contact_normal());
        let on_cloth = Vec3::above(twist.slip(self.hit.sphere.radius), S::ZERO);
        let (side, rise, ahead) = (self.side(), self.rise(), self.ahead());
        [Vec2::new(at_nose.dot(side), at_nose.dot(rise)), Vec2::new(on_cloth.dot(side), on_cloth.dot(ahead))]
    }

    #[inline(always)]
    fn pushed(&self, twist: Twist<S>, impulse: &Impulse<S, 2>) -> Twist<S> {
        let Impulse { normal, rubs: [nose, cloth] } = impulse;
        let (side, outward) = (self.side(), self.hit.contact_normal());
        let at_nose = outward * *normal - side * nose.x - self.rise() * nose.y;
        let on_cloth = -(side * cloth.x + self.ahead() * cloth.y);
        let pushed = twist.after_impulse(&self.hit.sphere, -outward, at_nose).after_impulse(
            &self.hit.sphere,
            -Vec3::UP,
            on_cloth,
        );
        Twist { velocity: Vec3::above(pushed.velocity.plan(), twist.velocity.z), ..pushed }
    }

    fn frictions(&self) -> [S; 2] {
        [self.friction, self.hit.sphere.sliding]
    }

    fn loads(&self) -> [[S; 2]; 2] {
        [[S::ONE, S::ZERO], [self.hit.sin, self.hit.cos]] // (1)
    }
}
