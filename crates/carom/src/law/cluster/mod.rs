//! Laws of several contacts at one instant.
//!
//! A cluster is the balls and cushions that touch each other when one of them is struck. Its contacts are given in order
//! of their place, never of their numbers, so that a renumbering changes no bit.

mod complementarity;
pub mod hertz;
pub mod pairwise;
pub mod reflections;
mod spring;

pub use hertz::{Collision, resolve_hertz};
pub use pairwise::resolve_pairwise;
pub use reflections::resolve_reflections;

use crate::geometry::{Vec2, Vector};
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
pub struct Body<S, V = Vec2<S>> {
    /// Its velocity, which the law changes.
    pub velocity: V,
    /// One over its mass.
    pub inverse_mass: S,
    /// Sum of the sizes of its velocity at first and of all changes since, which rounding errors are proportional to.
    scale: S,
}

/// What a cluster has to know of the law of a contact.
pub trait TouchLaw<S>: Copy {
    /// The coefficient of restitution of a contact that closes at this speed.
    fn restitution(&self, closing_speed: S) -> S;
}

/// The law of a contact of discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiscLaw<S> {
    /// Between two balls.
    Balls(ball_ball::Law<S>),
    /// Between a ball and a cushion.
    Cushion(ball_cushion::Law<S>),
}

impl<S: Scalar> TouchLaw<S> for ball_ball::SphereLaw<S> {
    fn restitution(&self, closing_speed: S) -> S {
        ball_ball::SphereLaw::restitution(self, closing_speed)
    }
}

impl<S: Scalar> TouchLaw<S> for DiscLaw<S> {
    fn restitution(&self, closing_speed: S) -> S {
        match self {
            Self::Balls(law) => law.restitution(closing_speed),
            Self::Cushion(law) => law.restitution(closing_speed),
        }
    }
}

/// A contact in a cluster: between two bodies, or of one with a cushion.
#[derive(Clone, Copy, Debug)]
pub struct Touch<S, V = Vec2<S>, L = DiscLaw<S>> {
    /// The first body.
    pub a: usize,
    /// The second body; `None` for a cushion.
    pub b: Option<usize>,
    /// Unit vector from the first body to the second, or into the cushion.
    pub normal: V,
    /// What says how much of the closing speed it gives back.
    pub law: L,
    /// What the law `hertz` takes its stiffness from: see [`effective_radius`]. Zero, where a point is in contact, counts as
    /// the largest of the cluster.
    pub effective_radius: S,
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

impl<S: Scalar, V: Vector<S>> Body<S, V> {
    /// A ball that has not been pushed yet.
    pub fn new(velocity: V, inverse_mass: S) -> Self {
        Self { velocity, inverse_mass, scale: velocity.size() }
    }

    /// Gives it a new velocity.
    pub fn turn(&mut self, velocity: V) {
        self.scale += (velocity - self.velocity).size();
        self.velocity = velocity;
    }

    /// The speed that is not told from standing still: sixteen round-offs of all that the velocity is the sum of.
    pub fn threshold(&self) -> S {
        self.scale * S::from_f64(16.0 * S::EPSILON)
    }

    /// Stops a ball whose velocity is nothing but round-off: so one that a cluster brings to rest is at rest.
    pub fn drop_round_off(&mut self) {
        let velocity = self.velocity;
        if velocity.size() <= self.threshold() {
            self.velocity = velocity - velocity.detached();
        }
    }
}

/// The radius of the sphere that presses on a plane as two balls do on each other: `R₁R₂/(R₁ + R₂)`; of a ball at a
/// cushion its own. Zero for a point.
pub fn effective_radius<S: Scalar>(radius: S, other: Option<S>) -> S {
    match other {
        Some(other) if radius * other > S::ZERO => radius * other / (radius + other),
        Some(_) => S::ZERO,
        None => radius,
    }
}

impl<S: Scalar, V: Vector<S>, L: TouchLaw<S>> Touch<S, V, L> {
    /// A contact that has received nothing yet, as large as all others.
    pub fn new(a: usize, b: Option<usize>, normal: V, law: L) -> Self {
        let (effective_radius, zero) = (S::ONE, S::ZERO);
        Self { a, b, normal, law, effective_radius, kept_speed: zero, impulse: zero, closing_speed: zero }
    }

    /// The speed at which the gap opens (negative while closing).
    fn gap_rate(&self, bodies: &[Body<S, V>]) -> S {
        (self.velocity_b(bodies) - bodies[self.a].velocity).dot(self.normal)
    }

    /// The restitution of the contact as it closes now.
    fn restitution_now(&self, bodies: &[Body<S, V>]) -> S {
        self.restitution_at(-self.gap_rate(bodies))
    }

    /// The restitution of the contact if it closes at this speed.
    fn restitution_at(&self, closing_speed: S) -> S {
        restitution_keeping(self.law.restitution(closing_speed), self.kept_speed, closing_speed)
    }

    /// Whether the gap closes, beyond the round-off of the velocities.
    fn is_closing(&self, bodies: &[Body<S, V>]) -> bool {
        let threshold = bodies[self.a].threshold() + self.b.map_or(S::ZERO, |b| bodies[b].threshold());
        self.gap_rate(bodies) < -threshold
    }

    fn velocity_b(&self, bodies: &[Body<S, V>]) -> V {
        self.b.map_or(V::ZERO, |b| bodies[b].velocity)
    }

    /// Gives both bodies the normal impulse `impulse` and adds it to the contact's account.
    fn apply(&mut self, impulse: S, bodies: &mut [Body<S, V>]) {
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
fn closing_touches<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    touches: &[Touch<S, V, L>],
    bodies: &[Body<S, V>],
) -> impl Iterator<Item = usize> {
    (0..touches.len()).filter(|&k| touches[k].is_closing(bodies))
}
