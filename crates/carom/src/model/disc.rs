//! A ball of the discs dynamics.

use crate::scalar::Scalar;

/// A disc: what stays the same about a ball while it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc<S> {
    /// Radius; zero for a point.
    pub radius: S,
    /// Mass.
    pub mass: S,
    /// One over the mass.
    pub inverse_mass: S,
}

impl<S: Scalar> Disc<S> {
    /// A disc of the given radius and mass.
    pub fn new(radius: S, mass: S) -> Self {
        Self { radius, mass, inverse_mass: S::ONE / mass }
    }
}
