//! Vectors in space.

use super::{Vec2, Vector};
use crate::scalar::Scalar;
use core::ops::{Add, Mul, Neg, Sub};

/// A vector in space: z points up from the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<S> {
    /// Component across the table.
    pub x: S,
    /// Component along the table.
    pub y: S,
    /// Component up from the table.
    pub z: S,
}

impl<S: Scalar> Vec3<S> {
    /// The zero vector.
    pub const ZERO: Self = Self { x: S::ZERO, y: S::ZERO, z: S::ZERO };

    /// The unit vector that points up.
    pub const UP: Self = Self { x: S::ZERO, y: S::ZERO, z: S::ONE };

    /// The vector with the given components.
    #[inline(always)]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    /// The vector over a point of the plane, at a height.
    #[inline(always)]
    pub const fn above(plan: Vec2<S>, z: S) -> Self {
        Self { x: plan.x, y: plan.y, z }
    }

    /// The vector as seen from above.
    #[inline(always)]
    pub const fn plan(self) -> Vec2<S> {
        Vec2::new(self.x, self.y)
    }

    /// The scalar version of a vector of `f64`.
    pub fn from_f64([x, y, z]: [f64; 3]) -> Self {
        Self::new(S::from_f64(x), S::from_f64(y), S::from_f64(z))
    }

    /// The components as `f64`.
    pub fn to_f64(self) -> [f64; 3] {
        [self.x.to_f64(), self.y.to_f64(), self.z.to_f64()]
    }

    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Cross product.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Squared length.
    #[inline(always)]
    pub fn norm_squared(self) -> S {
        self.dot(self)
    }

    /// Length.
    #[inline(always)]
    pub fn norm(self) -> S {
        self.norm_squared().sqrt()
    }

    /// The unit vector of the same direction; not a number for the zero vector.
    #[must_use]
    pub fn unit(self) -> Self {
        let norm = self.norm();
        Self::new(self.x / norm, self.y / norm, self.z / norm)
    }

    /// Whether all components are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<S: Scalar> Vector<S> for Vec3<S> {
    const ZERO: Self = Self::ZERO;

    #[inline(always)]
    fn dot(self, other: Self) -> S {
        self.dot(other)
    }

    #[inline(always)]
    fn size(self) -> S {
        self.x.abs() + self.y.abs() + self.z.abs()
    }

    #[inline(always)]
    fn detached(self) -> Self {
        Self::new(self.x.detached(), self.y.detached(), self.z.detached())
    }
}

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: S) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}
