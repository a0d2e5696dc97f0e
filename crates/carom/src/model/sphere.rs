//! A ball of the cue-balls dynamics, which rolls and spins.

use crate::geometry::{Vec2, Vec3};
use crate::scalar::Scalar;

/// A uniform sphere on a cloth: what stays the same about a ball while it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S> {
    /// Radius R.
    pub radius: S,
    /// Mass m.
    pub mass: S,
    /// One over the mass.
    pub inverse_mass: S,
    /// Coefficient of sliding friction with the cloth, μ_s.
    pub sliding: S,
    /// Coefficient of rolling friction with the cloth, μ_r.
    pub rolling: S,
    /// Rate at which the cloth slows the spin about the vertical, α_z, an angle per time squared.
    pub spin_decay: S,
}

/// How a ball moves at a moment: the velocity of its centre, and its spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<S> {
    /// Velocity of the centre.
    pub velocity: Vec3<S>,
    /// Angular velocity, by the right-hand rule.
    pub spin: Vec3<S>,
}

impl<S: Scalar> Sphere<S> {
    /// The moment of inertia, I = (2/5) m R².
    pub fn inertia(&self) -> S {
        S::from_f64(2.0) / S::from_f64(5.0) * self.mass * self.radius.squared()
    }

    /// The change of spin per unit of impulse and lever arm as a fraction of the radius: R/I = 5/(2 m R).
    #[inline(always)]
    pub fn spin_gain(&self) -> S {
        S::from_f64(2.5) * self.inverse_mass / self.radius
    }

    /// The kinetic energy of a motion: ½ m v² + ½ I ω².
    pub fn kinetic_energy(&self, twist: &Twist<S>) -> S {
        let spin = self.inertia() * twist.spin.norm_squared();
        (self.mass * twist.velocity.norm_squared() + spin) * S::from_f64(0.5)
    }
}

impl<S: Scalar> Twist<S> {
    /// No motion.
    pub const REST: Self = Self { velocity: Vec3::ZERO, spin: Vec3::ZERO };

    /// The change from another motion to this.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self { velocity: self.velocity - other.velocity, spin: self.spin - other.spin }
    }

    /// The velocity of the point of the ball's surface that lies from its centre in the unit direction `outward`.
    #[inline(always)]
    pub fn surface_velocity(&self, radius: S, outward: Vec3<S>) -> Vec3<S> {
        self.velocity + self.spin.cross(outward) * radius
    }

    /// The slip of a ball on the cloth: the velocity of its lowest point, `(v_x − R ω_y, v_y + R ω_x)`.
    #[inline(always)]
    pub fn slip(&self, radius: S) -> Vec2<S> {
        Vec2::new(self.velocity.x - radius * self.spin.y, self.velocity.y + radius * self.spin.x)
    }

    /// The motion after an impulse that acts at the point of the surface in the unit direction `outward`.
    #[inline(always)]
    #[must_use]
    pub fn after_impulse(self, sphere: &Sphere<S>, outward: Vec3<S>, impulse: Vec3<S>) -> Self {
        Self {
            velocity: self.velocity + impulse * sphere.inverse_mass,
            spin: self.spin + outward.cross(impulse) * sphere.spin_gain(),
        }
    }
}
