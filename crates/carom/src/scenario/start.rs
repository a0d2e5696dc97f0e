//! How a ball starts: its defaults filled in, its velocity in components.

use super::layout::{Number, vector};
use super::schema::{Ball, BallDefaults};
use crate::geometry::Vec2;
use crate::scalar::{Scalar, direction};

/// A ball at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallStart<S> {
    /// Radius; zero for a point.
    pub radius: S,
    /// Mass.
    pub mass: S,
    /// Centre.
    pub position: Vec2<S>,
    /// Velocity.
    pub velocity: Vec2<S>,
}

impl Ball {
    /// How this ball, at a place of the list, starts.
    ///
    /// A number that comes from the defaults enters with its place there, `ball_defaults.radius`, so that a derivative
    /// by it sees all balls that share it. A radius that stands nowhere, which a check refuses, is zero.
    pub fn start<S: Scalar>(
        &self,
        index: usize,
        defaults: &BallDefaults,
        number: Number<'_, S>,
    ) -> BallStart<S> {
        let mut either =
            |key: &str, own: Option<f64>, default: Option<f64>, else_value: f64| match (own, default) {
                (Some(value), _) => number(&format_args!("balls[{index}].{key}"), value),
                (None, Some(value)) => number(&format_args!("ball_defaults.{key}"), value),
                (None, None) => S::from_f64(else_value),
            };
        let radius = either("radius", self.radius, defaults.radius, 0.0);
        let mass = either("mass", self.mass, defaults.mass, 1.0);
        let position = vector(&format_args!("balls[{index}].position"), self.position, number);
        BallStart { radius, mass, position, velocity: self.start_velocity(index, number) }
    }

    fn start_velocity<S: Scalar>(&self, index: usize, number: Number<'_, S>) -> Vec2<S> {
        match (self.velocity, self.speed, self.direction_deg) {
            (Some(velocity), ..) => vector(&format_args!("balls[{index}].velocity"), velocity, number),
            (None, Some(speed), Some(degrees)) => {
                let speed = number(&format_args!("balls[{index}].speed"), speed);
                let (x, y) = direction(number(&format_args!("balls[{index}].direction_deg"), degrees));
                Vec2::new(x, y) * speed
            }
            _ => Vec2::ZERO,
        }
    }
}
