//! Laws of the contact between two balls: one in each file, and a variant of [`Law`] for discs, of [`SphereLaw`] for
//! spheres.

mod frictional;
mod mathavan_2014;
mod restitution;
mod sphere;

pub use frictional::Frictional;
pub use mathavan_2014::Mathavan2014;
pub use restitution::Restitution;
pub use sphere::{SphereImpact, SphereLaw, SpherePair};

use crate::geometry::Vec2;
use crate::law::Reference;
use crate::model::Disc;
use crate::scalar::Scalar;

/// A law with its parameters, and what the engine asks of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<S> {
    /// A coefficient of restitution, without friction.
    Restitution(Restitution<S>),
}

/// The contact of two discs.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S> {
    /// Distance of the centres.
    pub distance: S,
    /// Unit vector from the first ball to the second.
    pub normal: Vec2<S>,
    /// Speed at which the gap closes.
    pub closing_speed: S,
    /// Reduced mass of the two.
    pub reduced_mass: S,
}

/// What a contact does to two balls.
#[derive(Clone, Copy, Debug)]
pub struct Impact<S> {
    /// Normal impulse, which pushes them apart.
    pub impulse: S,
    /// Kinetic energy lost.
    pub energy_loss: S,
}

impl<S: Scalar> Law<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self::Restitution(Restitution::ELASTIC);

    /// The coefficient of restitution of two balls that close at this speed.
    #[inline(always)]
    pub fn restitution(&self, closing_speed: S) -> S {
        match self {
            Self::Restitution(law) => law.restitution(closing_speed),
        }
    }

    /// What a contact by itself does, with this coefficient of restitution: the law's own, unless the balls hop on through
    /// a collapse.
    #[inline(always)]
    pub fn impact(&self, pair: &Pair<S>, restitution: S) -> Impact<S> {
        match self {
            Self::Restitution(law) => law.impact(pair, restitution),
        }
    }

    /// Its sources.
    pub fn references(&self) -> &'static [Reference] {
        match self {
            Self::Restitution(_) => restitution::REFERENCES,
        }
    }

    /// Whether no contact loses any energy.
    pub fn is_lossless(&self) -> bool {
        match self {
            Self::Restitution(law) => law.is_lossless(),
        }
    }
}

impl<S: Scalar> Pair<S> {
    /// The contact of two discs whose centres are `separation` apart (from the first to the second).
    pub fn new(discs: [&Disc<S>; 2], separation: Vec2<S>, velocities: [Vec2<S>; 2]) -> Self {
        let square = separation.norm_squared();
        let distance = square.sqrt();
        let normal = Vec2::new(separation.x / distance, separation.y / distance);
        // Where the root is not exact the normal is none of length one. As a root of nearly one is more often rounded down
        // than up, it is too long in the mean, and would make energy of every contact.
        let approach = velocities[0] - velocities[1];
        let closing_speed = if distance * distance == square {
            approach.dot(normal)
        } else {
            approach.dot(separation) / square * distance
        };
        let reduced_mass = S::ONE / (discs[0].inverse_mass + discs[1].inverse_mass);
        Self { distance, normal, closing_speed, reduced_mass }
    }
}
