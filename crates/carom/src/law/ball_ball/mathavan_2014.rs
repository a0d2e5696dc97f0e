//! Impulse by impulse, with friction between the balls and of the ball that it presses on the cloth.
//!
//! Per normal impulse P the balls rub on each other with `μ_b` against their slip. With follow or draw that slip has a
//! vertical part, so that one ball is pressed down: by `N`, the vertical part of the friction. The cloth then rubs on that
//! ball with `μ_s N` against its slip on the cloth, `(v_x − R ω_y, v_y + R ω_x)`.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | μ_b, μ_s | friction between the balls, and the pressed ball's with the cloth | – |
//! | N | load on the cloth per P | – |
//! | e | restitution: its square is the part of the normal work given back | – |
//!
//! A ball on the cloth stays on it: it is neither lifted nor pressed in. A ball in the air is free and meets no cloth. The
//! line between the centres need not be level: its slope adds to N, and the slips are taken across it. Two balls in the
//! air so meet as in the law `frictional`.
//!
//! `law/gradual` takes the steps, up to the work `e² W_c`; the friction of the balls is that of their slip as they meet.
//!
//! Source: Mathavan, Jackson, Parkin (2014). *Departs from source*: a slip that stops is held while friction can hold it,
//! where there it flickers about zero, to the same end for small steps; balls may differ, and may be in the air. The sign
//! of the slip on the cloth is the paper's: a port in use has both its parts reversed.

use super::{SphereImpact, SpherePair};
use crate::geometry::{Vec2, Vec3};
use crate::law::Reference;
use crate::law::coefficient::SlipFriction;
use crate::law::gradual::{Impulse, Touching, follow};
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[Reference {
    law: "ball_ball.mathavan_2014",
    text: "S. Mathavan, M. R. Jackson, R. M. Parkin, Numerical simulations of the frictional collisions of solid balls on a rough surface, Sports Engineering 17 (2014) 227–237",
    doi: Some("10.1007/s12283-014-0158-y"),
}];

/// Parameters of the law. Of snooker balls the authors used e = 0.89 and μ_b = 0.05.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mathavan2014<S> {
    /// Coefficient of restitution e, from 0 to 1: its square is the part of the normal work given back.
    pub normal: S,
    /// Coefficient of friction μ_b between the balls; with the cloth it is the ball's own.
    pub friction: SlipFriction<S>,
}

/// Two balls that touch each other, and the cloth.
struct Meeting<'a, S> {
    pair: &'a SpherePair<S>,
    friction: S,
    /// Level, along the line between the centres.
    ahead: Vec3<S>,
    /// Level, across it.
    side: Vec3<S>,
    /// Across both the line between the centres and `side`, upwards.
    rise: Vec3<S>,
}

impl<S: Scalar> Mathavan2014<S> {
    pub(super) fn impact(&self, pair: &SpherePair<S>, restitution: S) -> SphereImpact<S> {
        let meeting = Meeting::new(pair, self.friction.at(pair.slip().norm()));
        let (twists, impulse) = follow(&meeting, pair.twists, restitution);
        SphereImpact { twists, impulse }
    }
}

impl<'a, S: Scalar> Meeting<'a, S> {
    /// The places and directions of a contact. Between balls one above the other any direction is ahead.
    fn new(pair: &'a SpherePair<S>, friction: S) -> Self {
        let plan = pair.normal.plan();
        let plan = if plan == Vec2::ZERO { Vec2::new(S::ONE, S::ZERO) } else { plan.unit() };
        let (ahead, side) = (Vec3::above(plan, S::ZERO), Vec3::above(-plan.left(), S::ZERO));
        Self { pair, friction, ahead, side, rise: side.cross(pair.normal) }
    }

    /// The slip of a ball on the cloth, sideways and ahead.
    #[inline(always)]
    fn slip_on_cloth(&self, ball: &Sphere<S>, twist: &Twist<S>) -> Vec2<S> {
        let slip = Vec3::above(twist.slip(ball.radius), S::ZERO);
        Vec2::new(slip.dot(self.side), slip.dot(self.ahead))
    }

    /// A ball after the impulse of the other ball and the friction of the cloth.
    #[inline(always)]
    fn pushed_ball(&self, ball: usize, twist: Twist<S>, pushed: Vec3<S>, cloth: Vec2<S>) -> Twist<S> {
        let sphere = &self.pair.spheres[ball];
        let outward = if ball == 0 { self.pair.normal } else { -self.pair.normal };
        let after = twist.after_impulse(sphere, outward, pushed);
        if !self.pair.on_cloth[ball] {
            return after;
        }
        let rubbed = -(self.side * cloth.x + self.ahead * cloth.y);
        let after = after.after_impulse(sphere, -Vec3::UP, rubbed);
        Twist { velocity: Vec3::above(after.velocity.plan(), twist.velocity.z), ..after }
    }
}

/// The balls on each other, and each of them on the cloth.
impl<S: Scalar> Touching<S, 3> for Meeting<'_, S> {
    type Motion = [Twist<S>; 2];
    const REST: [Twist<S>; 2] = [Twist::REST; 2];

    #[inline(always)]
    fn closing_speed(&self, twists: &[Twist<S>; 2]) -> S {
        (twists[0].velocity - twists[1].velocity).dot(self.pair.normal)
    }

    #[inline(always)]
    fn slips(&self, twists: &[Twist<S>; 2]) -> [Vec2<S>; 3] {
        let slip = SpherePair { twists: *twists, ..*self.pair }.slip();
        let [first, second] = [0, 1].map(|k| self.slip_on_cloth(&self.pair.spheres[k], &twists[k]));
        [Vec2::new(slip.dot(self.side), slip.dot(self.rise)), first, second]
    }

    #[inline(always)]
    fn pushed(&self, twists: [Twist<S>; 2], impulse: &Impulse<S, 3>) -> [Twist<S>; 2] {
        let Impulse { normal, rubs: [between, first, second] } = *impulse;
        let on_first = -(self.pair.normal * normal + self.side * between.x + self.rise * between.y);
        [self.pushed_ball(0, twists[0], on_first, first), self.pushed_ball(1, twists[1], -on_first, second)]
    }

    fn frictions(&self) -> [S; 3] {
        let cloth = |k: usize| if self.pair.on_cloth[k] { self.pair.spheres[k].sliding } else { S::ZERO };
        [self.friction, cloth(0), cloth(1)]
    }

    /// What presses the first ball down lifts the second.
    fn loads(&self) -> [[S; 2]; 3] {
        let (normal, rise) = (self.pair.normal.z, self.rise.z);
        [[S::ONE, S::ZERO], [normal, rise], [-normal, -rise]]
    }
}
