//! The landing of a ball on the cloth: the impact of a sphere on a plane whose normal points up.
//!
//! Source: Newton (1687) for the restitution, Coulomb (1785) for the friction; the equations are those of
//! `law/sphere_plane.rs`.

use super::Reference;
use super::reference::{coulomb, newton};
use super::sphere_plane::{self, Plane};
use crate::geometry::Vec3;
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// The sources of the law.
pub const REFERENCES: &[Reference] = &[newton("cloth.bounce"), coulomb("cloth.bounce")];

/// The motion of a ball after it landed. Its spin about the vertical stays.
pub fn bounce<S: Scalar>(sphere: &Sphere<S>, twist: Twist<S>, restitution: S, friction: S) -> Twist<S> {
    sphere_plane::bounce(sphere, &Plane { normal: Vec3::UP, restitution, friction }, twist)
}
