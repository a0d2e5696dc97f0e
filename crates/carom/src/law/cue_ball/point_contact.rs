//! The strike of a cue as one impulse at a point of the ball.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | V0, M | speed and mass of the cue | m/s, kg |
//! | m, R | mass and radius of the ball | kg, m |
//! | a, b | offsets of the contact to the left and to the top, over R, across the axis of the cue | – |
//! | d, l, u | unit vectors: along the cue towards the ball; level, to the shooter's left; `u = d × l` | – |
//! | e | restitution between tip and ball | – |
//! | m_e | mass of the cue's end that the ball pushes aside | kg |
//! | α | squirt: the angle by which the ball leaves to the other side of the English | rad |
//!
//! The tip touches the ball at `r = R (a l + b u − √(1 − a² − b²) d)` and pushes it along d. The lever arm of that push is
//! `R √(a² + b²)` for every elevation, so that
//!
//! ```text
//! v = (1 + e) V0 / [1 + m/M + (5/2) (a² + b²)]                                                (1)
//! velocity = v d ,   ω = (5/2) (v/R) (r/R) × d = (5/2) (v/R) (b l − a u)                      (2)
//! tan α = (5/2) a √(1 − a²) / [1 + m/m_e + (5/2) (1 − a²)]                                    (3)
//! ```
//!
//! Squirt turns the velocity about the vertical, to the right where a > 0, and leaves the spin. The ball may be struck
//! down onto the cloth: what the cloth then does is not part of this law.
//!
//! Source: Leckie and Greenspan (2006) for (1) and (2) with e = 1; Alciatore, TP A.31, for (3). *Departs from source*:
//! there b is level with the table, which turns (2) into a longer formula for the same blow; here it is measured across
//! the cue, as players see it. The elastic 2 of (1) is `1 + e`: then tip and ball part with e times the speed at which
//! they meet, at every offset.

use crate::geometry::{Vec2, Vec3};
use crate::law::Reference;
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// The sources of the law.
pub const REFERENCES: &[Reference] = &[
    Reference {
        law: "cue_ball.point_contact",
        text: "W. Leckie, M. Greenspan, An event-based pool physics simulator, Advances in Computer Games 2005, Lecture Notes in Computer Science 4250 (2006) 247–262",
        doi: Some("10.1007/11922155_19"),
    },
    Reference {
        law: "cue_ball.point_contact",
        text: "D. G. Alciatore, TP A.31: The physics of squirt, billiards.colostate.edu",
        doi: None,
    },
];

/// A cue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointContact<S> {
    /// Mass M.
    pub mass: S,
    /// Mass m_e of its end, which makes the squirt; zero for none.
    pub end_mass: S,
    /// Coefficient of restitution e between tip and ball; one loses nothing.
    pub restitution: S,
    /// Largest offset over R at which the tip holds.
    pub miscue_offset: S,
}

/// How a cue strikes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike<S> {
    /// Speed V0 of the cue.
    pub speed: S,
    /// Unit vector in plan along which it strikes.
    pub direction: Vec2<S>,
    /// Cosine and sine of the elevation of its butt.
    pub elevation: (S, S),
    /// Offset a of the contact, over R, to the shooter's left.
    pub left: S,
    /// Offset b of the contact, over R, to the top, across the cue.
    pub top: S,
}

/// What a strike does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueImpact<S> {
    /// How the ball moves after it.
    pub twist: Twist<S>,
    /// Impulse of the cue.
    pub impulse: S,
    /// Where the tip touches, from the centre of the ball, over R.
    pub point: Vec3<S>,
}

/// The axes of a cue.
struct Axes<S> {
    ahead: Vec3<S>,
    left: Vec3<S>,
    up: Vec3<S>,
}

impl<S: Scalar> PointContact<S> {
    /// What a strike does to a ball at rest. The offsets have to lie on the ball: `a² + b² < 1`.
    pub fn strike(&self, sphere: &Sphere<S>, strike: &Strike<S>) -> CueImpact<S> {
        let Axes { ahead, left, up } = strike.axes();
        let turn = S::from_f64(2.5);
        let resisted = S::ONE + sphere.mass / self.mass + turn * strike.offset_squared();
        let speed = (S::ONE + self.restitution) * strike.speed / resisted; // (1)
        let rolled = turn * speed / sphere.radius;
        let spin = (left * strike.top - up * strike.left) * rolled; // (2)
        let velocity = self.squirted(sphere, strike.left, ahead * speed);
        CueImpact { twist: Twist { velocity, spin }, impulse: sphere.mass * speed, point: strike.point() }
    }

    /// Whether the tip slips off the ball.
    pub fn is_miscue(&self, strike: &Strike<S>) -> bool {
        strike.offset_squared() > self.miscue_offset.squared()
    }

    /// The velocity turned to the right by the squirt of an offset to the left.
    fn squirted(&self, sphere: &Sphere<S>, offset: S, velocity: Vec3<S>) -> Vec3<S> {
        let turn = S::from_f64(2.5);
        let inside = S::ONE - offset.squared();
        let aside = turn * offset * inside.sqrt() * self.end_mass; // (3), both parts times m_e
        let ahead = self.end_mass + sphere.mass + turn * inside * self.end_mass;
        let length = (aside.squared() + ahead.squared()).sqrt();
        let (cos, sin) = (ahead / length, aside / length);
        let Vec2 { x, y } = velocity.plan();
        Vec3::new(x * cos + y * sin, y * cos - x * sin, velocity.z)
    }
}

impl<S: Scalar> Strike<S> {
    /// The square of the offset of the contact, over R².
    pub fn offset_squared(&self) -> S {
        self.left.squared() + self.top.squared()
    }

    /// The unit vector along the cue, from its butt to its tip.
    pub fn ahead(&self) -> Vec3<S> {
        self.axes().ahead
    }

    /// Where the tip touches, from the centre of the ball, over R.
    pub fn point(&self) -> Vec3<S> {
        let Axes { ahead, left, up } = self.axes();
        let depth = (S::ONE - self.offset_squared()).sqrt();
        left * self.left + up * self.top - ahead * depth
    }

    fn axes(&self) -> Axes<S> {
        let (cos, sin) = self.elevation;
        Axes {
            ahead: Vec3::above(self.direction * cos, -sin),
            left: Vec3::above(self.direction.left(), S::ZERO),
            up: Vec3::above(self.direction * sin, cos),
        }
    }
}
