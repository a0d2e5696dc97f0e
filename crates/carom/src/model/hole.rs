//! A pocket made ready for detection.

use super::{Face, Round};
use crate::geometry::{Arc, Bounds, Vec2};
use crate::scalar::Scalar;

/// A circle over which a ball's centre is captured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole<S> {
    /// Its centre.
    pub center: Vec2<S>,
    /// Its radius.
    pub radius: S,
    /// The same as a face, which the centres of balls meet from outside.
    pub rim: Face<S>,
}

impl<S: Scalar> Hole<S> {
    /// The hole around a point.
    pub fn new(center: Vec2<S>, radius: S) -> Self {
        let arc = Arc::from_degrees(center, radius, S::from_f64(360.0), S::ZERO);
        Self { center, radius, rim: Face::Round(Round { arc }) }
    }

    /// The box around it.
    pub fn bounds(&self) -> Bounds<S> {
        self.rim.bounds()
    }

    /// Whether a point lies over it.
    pub fn is_under(&self, point: Vec2<S>) -> bool {
        (point - self.center).norm_squared() <= self.radius.squared()
    }
}
