//! Laws of several contacts at one instant.
//!
//! A cluster is the balls and cushions that touch each other when one of them is struck. Its contacts are given in order
//! of their place, never of their numbers, so that a renumbering changes no bit.

mod complementarity;
pub mod pairwise;
pub mod reflections;

pub use pairwise::resolve_pairwise;
pub use reflections::resolve_reflections;

use crate::geometry::Vec2;
use crate::law::collapse::restitution_keeping;
use crate::law::{Reference, ball_ball, ball_cushion};
use crate::scalar::Scalar;

/// A study of both laws: which of them end, and how losses are to be built in.
const fn vouga_2017(law: &'static str) -> Reference {
    Reference {
        law,
        text: "E. Vouga, B. Smith, D. M. Kaufman, R. Tamstorf, E. Grinspun, All's well that ends well: guaranteed resolution of simultaneous rigid body impact, ACM Transactions on Graphics 36 (2017) 151",
        doi: Some("10.1145/3072959.3073689"),
    }
}

/// A ball in a cluster.
#[derive(Clone, Copy, Debug)]
pub struct Body<S> {
    /// Its velocity, which the law changes.
    pub velocity: Vec2<S>,
    /// One over its mass.
    pub inverse_mass: S,
    /// Sum of the sizes of its velocity at first and of all changes since, which rounding errors are proportional to.
    scale: S,
}

/// The law of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TouchLaw<S> {
    /// Between two balls.
    Balls(ball_ball::Law<S>),
    /// Between a ball and a cushion.
    Cushion(ball_cushion::Law<S>),
}

/// A contact in a cluster: between two bodies, or of one with a cushion.
#[derive(Clone, Copy, Debug)]
pub struct Touch<S> {
    /// The first body.
    pub a: usize,
    /// The second body; `None` for a cushion.
    pub b: Option<usize>,
    /// Unit vector from the first body to the second, or into the cushion.
    pub normal: Vec2<S>,
    /// What says how much of the closing speed it gives back.
    pub law: TouchLaw<S>,
    /// Closing speeds up to this are given back in full, faster ones at least that far.
    pub kept_speed: S,
    /// Normal impulse received so far.
    pub impulse: S,
    /// Closing speed when the contact first closed; zero if it never did.
    pub closing_speed: S,
}

/// How a cluster was resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Passes {
    /// Passes made.
    pub count: u32,
    /// Whether the last one had to be without restitution.
    pub forced: bool,
}

/// Passes allowed for each ball of a cluster before the last one, which is without restitution.
const PASSES_PER_BALL: usize = 8;

impl<S: Scalar> Body<S> {
    /// A ball that has not been pushed yet.
    pub fn new(velocity: Vec2<S>, inverse_mass: S) -> Self {
        Self { velocity, inverse_mass, scale: size(velocity) }
    }

    /// Gives it a new velocity.
    pub fn turn(&mut self, velocity: Vec2<S>) {
        self.scale += size(velocity - self.velocity);
        self.velocity = velocity;
    }

    /// The speed that is not told from standing still: sixteen round-offs of all that the velocity is the sum of.
    pub fn threshold(&self) -> S {
        self.scale * S::from_f64(16.0 * S::EPSILON)
    }

    /// Stops a ball whose velocity is nothing but round-off: so one that a cluster brings to rest is at rest.
    pub fn drop_round_off(&mut self) {
        let velocity = self.velocity;
        if size(velocity) <= self.threshold() {
            self.velocity = velocity - Vec2::new(velocity.x.detached(), velocity.y.detached());
        }
    }
}

fn size<S: Scalar>(velocity: Vec2<S>) -> S {
    velocity.x.abs() + velocity.y.abs()
}

impl<S: Scalar> Touch<S> {
    /// A contact that has received nothing yet.
    pub fn new(a: usize, b: Option<usize>, normal: Vec2<S>, law: TouchLaw<S>) -> Self {
        Self { a, b, normal, law, kept_speed: S::ZERO, impulse: S::ZERO, closing_speed: S::ZERO }
    }

    /// The speed at which the gap opens (negative while closing).
    fn gap_rate(&self, bodies: &[Body<S>]) -> S {
        (self.velocity_b(bodies) - bodies[self.a].velocity).dot(self.normal)
    }

    /// The restitution of the contact as it closes now.
    fn restitution_now(&self, bodies: &[Body<S>]) -> S {
        let closing_speed = -self.gap_rate(bodies);
        let own = match self.law {
            TouchLaw::Balls(law) => law.restitution(closing_speed),
            TouchLaw::Cushion(law) => law.restitution(closing_speed),
        };
        restitution_keeping(own, self.kept_speed, closing_speed)
    }

    /// Whether the gap closes, beyond the round-off of the velocities.
    fn is_closing(&self, bodies: &[Body<S>]) -> bool {
        let threshold = bodies[self.a].threshold() + self.b.map_or(S::ZERO, |b| bodies[b].threshold());
        self.gap_rate(bodies) < -threshold
    }

    fn velocity_b(&self, bodies: &[Body<S>]) -> Vec2<S> {
        self.b.map_or(Vec2::ZERO, |b| bodies[b].velocity)
    }

    /// Gives both bodies the normal impulse `impulse` and adds it to the contact's account.
    fn apply(&mut self, impulse: S, bodies: &mut [Body<S>]) {
        let push = self.normal * impulse;
        let a = &mut bodies[self.a];
        a.turn(a.velocity - push * a.inverse_mass);
        if let Some(b) = self.b {
            let b = &mut bodies[b];
            b.turn(b.velocity + push * b.inverse_mass);
        }
        self.impulse += impulse;
    }

    /// Remembers the closing speed of the contact's first closing.
    fn note_closing(&mut self, speed: S) {
        if self.closing_speed == S::ZERO {
            self.closing_speed = speed;
        }
    }
}

/// The indices of the contacts that close.
fn closing_touches<S: Scalar>(touches: &[Touch<S>], bodies: &[Body<S>]) -> Vec<usize> {
    (0..touches.len()).filter(|&k| touches[k].is_closing(bodies)).collect()
}
