//! The contact of two spheres, and the laws for it.

use super::{Frictional, Mathavan2014, Restitution, frictional, mathavan_2014, restitution};
use crate::geometry::Vec3;
use crate::law::Reference;
use crate::law::sphere_plane::tangential;
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// A law between spheres with its parameters, and what the engine asks of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereLaw<S> {
    /// A coefficient of restitution, without friction.
    Restitution(Restitution<S>),
    /// Restitution and Coulomb friction in one blow.
    Frictional(Frictional<S>),
    /// Impulse by impulse, with the friction of the cloth.
    Mathavan2014(Mathavan2014<S>),
}

/// The contact of two spheres.
#[derive(Clone, Copy, Debug)]
pub struct SpherePair<S> {
    /// The two balls.
    pub spheres: [Sphere<S>; 2],
    /// Unit vector from the centre of the first ball to that of the second.
    pub normal: Vec3<S>,
    /// How they move.
    pub twists: [Twist<S>; 2],
    /// Which of them lie on the cloth: such a ball has no velocity upwards, and the cloth bears what presses it down.
    pub on_cloth: [bool; 2],
}

/// What a contact does to two spheres.
#[derive(Clone, Copy, Debug)]
pub struct SphereImpact<S> {
    /// How they move after it.
    pub twists: [Twist<S>; 2],
    /// Normal impulse, which pushes them apart.
    pub impulse: S,
}

impl<S: Scalar> SphereLaw<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self::Restitution(Restitution::ELASTIC);

    /// The coefficient of restitution of two balls that close at this speed.
    #[inline(always)]
    pub fn restitution(&self, closing_speed: S) -> S {
        match self {
            Self::Restitution(law) => law.restitution(closing_speed),
            Self::Frictional(law) => law.normal,
            Self::Mathavan2014(law) => law.normal,
        }
    }

    /// The coefficient of friction of two balls that slip on each other at this speed.
    pub fn friction(&self, slip_speed: S) -> S {
        match self {
            Self::Restitution(_) => S::ZERO,
            Self::Frictional(law) => law.friction(slip_speed),
            Self::Mathavan2014(law) => law.friction.at(slip_speed),
        }
    }

    /// What a contact by itself does, with this coefficient of restitution: the law's own, unless the balls are to part
    /// faster.
    #[inline(always)]
    pub fn impact(&self, pair: &SpherePair<S>, restitution: S) -> SphereImpact<S> {
        match self {
            Self::Restitution(law) => law.impact_of_spheres(pair, restitution),
            Self::Frictional(law) => law.impact(pair, restitution),
            Self::Mathavan2014(law) => law.impact(pair, restitution),
        }
    }

    /// Its sources.
    pub fn references(&self) -> &'static [Reference] {
        match self {
            Self::Restitution(_) => restitution::REFERENCES,
            Self::Frictional(_) => frictional::REFERENCES,
            Self::Mathavan2014(_) => mathavan_2014::REFERENCES,
        }
    }

    /// Whether no contact loses any energy. With the cloth's friction one may lose some without friction of its own.
    pub fn is_lossless(&self) -> bool {
        match self {
            Self::Restitution(law) => law.is_lossless(),
            Self::Frictional(law) => law.is_lossless(),
            Self::Mathavan2014(_) => false,
        }
    }
}

impl<S: Scalar> SpherePair<S> {
    /// Speed at which the gap closes.
    #[inline(always)]
    pub fn closing_speed(&self) -> S {
        (self.twists[0].velocity - self.twists[1].velocity).dot(self.normal)
    }

    /// Reduced mass of the two.
    #[inline(always)]
    pub fn reduced_mass(&self) -> S {
        S::ONE / (self.spheres[0].inverse_mass + self.spheres[1].inverse_mass)
    }

    /// How the surface of the first ball slips over that of the second.
    #[inline(always)]
    pub fn slip(&self) -> Vec3<S> {
        let first = self.twists[0].surface_velocity(self.spheres[0].radius, self.normal);
        let second = self.twists[1].surface_velocity(self.spheres[1].radius, -self.normal);
        tangential(first - second, self.normal)
    }

    /// The outcome of a normal impulse between the two and of a friction impulse on the first, its opposite on the second.
    #[inline(always)]
    pub(super) fn after_impulse(&self, impulse: S, rubbed: Vec3<S>) -> SphereImpact<S> {
        let on_first = rubbed - self.normal * impulse;
        let twists = [
            self.twists[0].after_impulse(&self.spheres[0], self.normal, on_first),
            self.twists[1].after_impulse(&self.spheres[1], -self.normal, -on_first),
        ];
        SphereImpact { twists, impulse }
    }
}
