//! The contact of a sphere with a cushion, and the laws for it.

use super::{
    Frictional, Han2005, Mathavan2010, Restitution, StrongeCompliant, frictional, han_2005, mathavan_2010,
    restitution, stronge_compliant,
};
use crate::geometry::{Vec2, Vec3};
use crate::law::Reference;
use crate::law::coefficient::IncidenceFriction;
use crate::law::sphere_plane::{self, Plane, tangential};
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// A law of cushions for spheres with its parameters, and what the engine asks of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereLaw<S> {
    /// A normal and a tangential factor.
    Restitution(Restitution<S>),
    /// Restitution and Coulomb friction in one blow at the nose.
    Frictional(Frictional<S>),
    /// Han's: at the nose, with the ball held on the cloth.
    Han2005(Han2005<S>),
    /// Mathavan's: impulse by impulse, with the friction of nose and cloth.
    Mathavan2010(Mathavan2010<S>),
    /// Stronge's: springs across and along the cushion.
    StrongeCompliant(StrongeCompliant<S>),
}

/// A ball at a cushion.
#[derive(Clone, Copy, Debug)]
pub struct CushionHit<S> {
    /// The ball.
    pub sphere: Sphere<S>,
    /// Unit normal in plan, from the cushion into the table.
    pub normal: Vec2<S>,
    /// Sine of the contact angle θ: the nose touches the ball R sin θ above its centre.
    pub sin: S,
    /// Cosine of the contact angle.
    pub cos: S,
    /// How the ball moves.
    pub twist: Twist<S>,
    /// Whether it is in the air, where the cloth holds nothing.
    pub is_airborne: bool,
}

impl<S: Scalar> SphereLaw<S> {
    /// The law without loss.
    pub const ELASTIC: Self = Self::Restitution(Restitution::ELASTIC);

    /// The coefficient of restitution of a ball that closes at this speed.
    #[inline(always)]
    pub fn restitution(&self, closing_speed: S) -> S {
        match self {
            Self::Restitution(law) => law.restitution(closing_speed),
            Self::Frictional(law) => law.normal.at(closing_speed),
            Self::Han2005(law) => law.normal.at(closing_speed),
            Self::Mathavan2010(law) => law.normal.at(closing_speed),
            Self::StrongeCompliant(law) => law.normal.at(closing_speed),
        }
    }

    /// How a ball moves after a contact by itself, with this coefficient of restitution: the law's own, unless the ball is
    /// to leave faster.
    ///
    /// A ball in the air meets the nose as a sphere meets a plane.
    #[inline(always)]
    pub fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        match self {
            Self::Restitution(law) => law.rebound_of_sphere(hit, restitution),
            Self::Frictional(law) => law.rebound(hit, restitution),
            Self::Han2005(law) if hit.is_airborne => hit.blow(restitution, hit.friction(&law.friction)),
            Self::Mathavan2010(law) if hit.is_airborne => hit.blow(restitution, hit.friction(&law.friction)),
            Self::StrongeCompliant(law) if hit.is_airborne => {
                hit.blow(restitution, hit.friction(&law.friction))
            }
            Self::Han2005(law) => law.rebound(hit, restitution),
            Self::Mathavan2010(law) => law.rebound(hit, restitution),
            Self::StrongeCompliant(law) => law.rebound(hit, restitution),
        }
    }

    /// Whether the blow goes from the nose to the centre of the ball; other laws go by the height of the nose alone. Where a
    /// ball touches the nose itself that is the same.
    pub fn acts_towards_nose(&self) -> bool {
        matches!(self, Self::Frictional(_) | Self::StrongeCompliant(_))
    }

    /// Its sources.
    pub fn references(&self) -> &'static [Reference] {
        match self {
            Self::Restitution(_) => restitution::REFERENCES,
            Self::Frictional(_) => frictional::REFERENCES,
            Self::Han2005(_) => han_2005::REFERENCES,
            Self::Mathavan2010(_) => mathavan_2010::REFERENCES,
            Self::StrongeCompliant(_) => stronge_compliant::REFERENCES,
        }
    }

    /// Whether no contact loses any energy. Laws that leave a part to the cloth may lose some without friction of their own.
    pub fn is_lossless(&self) -> bool {
        match self {
            Self::Restitution(law) => law.is_lossless(),
            Self::Frictional(law) => law.normal.is_one() && law.friction.is_zero(),
            Self::Han2005(_) | Self::Mathavan2010(_) | Self::StrongeCompliant(_) => false,
        }
    }
}

impl<S: Scalar> CushionHit<S> {
    /// The normal at the contact, from the nose towards the centre of the ball: it points down where the nose lies above
    /// the centre.
    #[inline(always)]
    pub fn contact_normal(&self) -> Vec3<S> {
        Vec3::above(self.normal * self.cos, -self.sin)
    }

    /// The normal along which the ball closes: level for a ball on the cloth, that of the contact in the air.
    #[inline(always)]
    pub fn closing_normal(&self) -> Vec3<S> {
        if self.is_airborne { self.contact_normal() } else { Vec3::above(self.normal, S::ZERO) }
    }

    /// Speed at which the ball closes.
    #[inline(always)]
    pub fn closing_speed(&self) -> S {
        -self.twist.velocity.dot(self.closing_normal())
    }

    /// The coefficient of friction at the angle at which the ball comes in.
    #[inline(always)]
    pub(super) fn friction(&self, friction: &IncidenceFriction<S>) -> S {
        let along = tangential(self.twist.velocity, self.closing_normal());
        friction.at(self.closing_speed(), along.norm())
    }

    /// The impact of a sphere on the plane that touches it at the nose.
    #[inline(always)]
    pub(super) fn blow(&self, restitution: S, friction: S) -> Twist<S> {
        let plane = Plane { normal: self.contact_normal(), restitution, friction };
        sphere_plane::bounce(&self.sphere, &plane, self.twist)
    }
}
