//! Vectors in the plane, and what they share with those in space.

use crate::scalar::Scalar;
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};
use serde::{Deserialize, Serialize};

/// A vector in the plane or in space, for what does not depend on which.
pub trait Vector<S: Scalar>:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<S, Output = Self>
{
    /// The zero vector.
    const ZERO: Self;

    /// Scalar product.
    #[must_use]
    fn dot(self, other: Self) -> S;

    /// The sum of the components' absolute values.
    #[must_use]
    fn size(self) -> S;

    /// The same vector without the derivatives it carries.
    #[must_use]
    fn detached(self) -> Self;
}

/// A vector in the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Vec2<S> {
    /// Component across the table.
    pub x: S,
    /// Component along the table.
    pub y: S,
}

impl<S: Scalar> Vec2<S> {
    /// The zero vector.
    pub const ZERO: Self = Self { x: S::ZERO, y: S::ZERO };

    /// The vector with the given components.
    #[inline(always)]
    pub const fn new(x: S, y: S) -> Self {
        Self { x, y }
    }

    /// The scalar version of a vector of `f64`.
    pub fn from_f64(value: [f64; 2]) -> Self {
        Self::new(S::from_f64(value[0]), S::from_f64(value[1]))
    }

    /// The components as `f64`.
    pub fn to_f64(self) -> [f64; 2] {
        [self.x.to_f64(), self.y.to_f64()]
    }

    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y
    }

    /// The z component of the cross product: positive when `other` is to the left of `self`.
    #[inline(always)]
    pub fn cross(self, other: Self) -> S {
        self.x * other.y - self.y * other.x
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

    /// The vector turned a quarter to the left.
    #[inline(always)]
    #[must_use]
    pub fn left(self) -> Self {
        Self::new(S::ZERO - self.y, self.x)
    }

    /// The unit vector of the same direction; not a number for the zero vector.
    #[must_use]
    pub fn unit(self) -> Self {
        let norm = self.norm();
        Self::new(self.x / norm, self.y / norm)
    }

    /// Whether both components are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl<S: Scalar> Vector<S> for Vec2<S> {
    const ZERO: Self = Self::ZERO;

    #[inline(always)]
    fn dot(self, other: Self) -> S {
        self.dot(other)
    }

    #[inline(always)]
    fn size(self) -> S {
        self.x.abs() + self.y.abs()
    }

    #[inline(always)]
    fn detached(self) -> Self {
        Self::new(self.x.detached(), self.y.detached())
    }
}

impl<S: Scalar> Add for Vec2<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<S: Scalar> Sub for Vec2<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl<S: Scalar> Neg for Vec2<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<S: Scalar> Mul<S> for Vec2<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: S) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
