//! The impact of a sphere on a plane, with restitution and Coulomb friction: the kernel of landings and of cushions.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | n | unit normal of the plane, towards the centre of the ball | – |
//! | e, μ | restitution, friction | – |
//! | J_n | normal impulse, `m (1 + e) (−v·n)` | kg m/s |
//! | c | slip of the contact point, `v − (v·n) n + R ω × (−n)` | m/s |
//! | J_t | friction impulse, `−min(μ J_n, (2/7) m │c│) ĉ`: in the second case the slip stops | kg m/s |

use crate::geometry::Vec3;
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;

/// The plane that a ball meets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<S> {
    pub normal: Vec3<S>,
    pub restitution: S,
    pub friction: S,
}

/// The motion of a ball after it met a plane.
#[inline(always)]
pub(super) fn bounce<S: Scalar>(sphere: &Sphere<S>, plane: &Plane<S>, twist: Twist<S>) -> Twist<S> {
    let normal = plane.normal;
    let closing_speed = -twist.velocity.dot(normal);
    let pushed = sphere.mass * (S::ONE + plane.restitution) * closing_speed;
    let slip = tangential(twist.surface_velocity(sphere.radius, -normal), normal);
    let stopping = S::from_f64(2.0) / S::from_f64(7.0) * sphere.mass;
    let rubbed = slip * -friction_per_slip(plane.friction * pushed, stopping, slip.norm());
    twist.after_impulse(sphere, -normal, normal * pushed + rubbed)
}

/// The part of a vector across a unit normal.
#[inline(always)]
pub(super) fn tangential<S: Scalar>(vector: Vec3<S>, normal: Vec3<S>) -> Vec3<S> {
    vector - normal * vector.dot(normal)
}

/// The friction impulse over the slip: all that friction can give, but no more than stops the slip.
///
/// `stopping` is the impulse that stops a slip of one. A slip of zero counts as stopped, so nothing is divided by it.
#[inline(always)]
pub(super) fn friction_per_slip<S: Scalar>(largest: S, stopping: S, slip_speed: S) -> S {
    if largest >= stopping * slip_speed { stopping } else { largest / slip_speed }
}
