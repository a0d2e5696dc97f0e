//! Laws of the contact between a ball and a cushion: one in each file, and a variant of [`Law`] for discs, of
//! [`SphereLaw`] for spheres.
//!
//! A unit normal `n` comes with a scale, one over the squared length that it has as rounded: `(v·n) n · scale` is the
//! part of v along it.

mod frictional;
mod han_2005;
mod mathavan_2010;
mod restitution;
mod sphere;
mod stronge_compliant;

pub use frictional::Frictional;
pub use han_2005::Han2005;
pub use mathavan_2010::Mathavan2010;
pub use restitution::Restitution;
pub use sphere::{CushionHit, SphereLaw};
pub use stronge_compliant::StrongeCompliant;

use crate::geometry::Vec2;
use crate::law::Reference;
use crate::scalar::Scalar;

/// A law with its parameters, and what the engine asks of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<S> {
    /// A normal and a tangential factor.
    Restitution(Restitution<S>),
}

/// What a cushion does to a ball of unit mass.
#[derive(Clone, Copy, Debug)]
pub struct Rebound<S> {
    /// Velocity after the contact.
    pub velocity: Vec2<S>,
    /// Normal velocity before the contact, negative while closing.
    pub normal_velocity: S,
    /// Kinetic energy lost.
    pub energy_loss: S,
}

impl<S: Scalar> Law<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self::Restitution(Restitution::ELASTIC);

    /// The coefficient of restitution of a ball that closes at this speed; of one that does not close, which asks with a
    /// speed of zero or less, anything: it is not used.
    #[inline(always)]
    pub fn restitution(&self, closing_speed: S) -> S {
        match self {
            Self::Restitution(law) => law.restitution(closing_speed),
        }
    }

    /// What a contact by itself does, with this coefficient of restitution: the law's own, unless the ball hops on through
    /// a collapse or has no room to bounce.
    #[inline(always)]
    pub fn rebound(&self, velocity: Vec2<S>, normal: (Vec2<S>, S), restitution: S) -> Rebound<S> {
        match self {
            Self::Restitution(law) => law.rebound(velocity, normal, restitution),
        }
    }

    /// What the law does along the cushion, where a cluster has seen to the normal part: the velocity after it, none if
    /// it does nothing.
    pub fn slide(&self, velocity: Vec2<S>, normal: (Vec2<S>, S)) -> Option<Vec2<S>> {
        match self {
            Self::Restitution(law) => law.slide(velocity, normal),
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

    /// Whether every ball that touches the cushion stops.
    pub fn is_dead(&self) -> bool {
        match self {
            Self::Restitution(law) => law.is_dead(),
        }
    }
}
