//! How a ball starts: its defaults filled in, its velocity in components.

use super::layout::{Number, vector};
use super::schema::{Ball, BallDefaults, Vector};
use crate::geometry::{Vec2, Vec3};
use crate::model::{Sphere, Twist};
use crate::scalar::{Scalar, direction};
use core::fmt::Display;

/// A ball at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallStart<S> {
    /// Radius; zero for a point.
    pub radius: S,
    /// Mass.
    pub mass: S,
    /// Coefficient of sliding friction with the cloth.
    pub sliding_friction: S,
    /// Coefficient of rolling friction with the cloth.
    pub rolling_friction: S,
    /// Rate at which the cloth slows the spin about the vertical.
    pub spin_decay: S,
    /// Centre; one radius above the cloth where no height is given.
    pub position: Vec3<S>,
    /// Velocity.
    pub velocity: Vec3<S>,
    /// Angular velocity.
    pub spin: Vec3<S>,
}

impl<S: Scalar> BallStart<S> {
    /// What stays the same about the ball, as a sphere on a cloth.
    pub fn sphere(&self) -> Sphere<S> {
        Sphere {
            radius: self.radius,
            mass: self.mass,
            inverse_mass: S::ONE / self.mass,
            sliding: self.sliding_friction,
            rolling: self.rolling_friction,
            spin_decay: self.spin_decay,
        }
    }

    /// How it moves.
    pub fn twist(&self) -> Twist<S> {
        Twist { velocity: self.velocity, spin: self.spin }
    }
}

impl Ball {
    /// How this ball, at a place of the list, starts.
    ///
    /// A number that comes from the defaults enters with its place there, `ball_defaults.radius`, so that a derivative
    /// by it sees all balls that share it. A radius or a position that stands nowhere, which a check refuses, is zero.
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
        let sliding_friction =
            either("sliding_friction", self.sliding_friction, defaults.sliding_friction, 0.2);
        let rolling_friction =
            either("rolling_friction", self.rolling_friction, defaults.rolling_friction, 0.01);
        let spin_decay = either("spin_decay", self.spin_decay, defaults.spin_decay, 10.9);
        let position = self.position.unwrap_or([0.0, 0.0].into());
        let position = in_space(&format_args!("balls[{index}].position"), position, radius, number);
        let velocity = self.start_velocity(index, number);
        let spin = self.start_spin(index, number);
        BallStart { radius, mass, sliding_friction, rolling_friction, spin_decay, position, velocity, spin }
    }

    fn start_velocity<S: Scalar>(&self, index: usize, number: Number<'_, S>) -> Vec3<S> {
        match (self.velocity, self.speed, self.direction_deg) {
            (Some(velocity), ..) => {
                in_space(&format_args!("balls[{index}].velocity"), velocity, S::ZERO, number)
            }
            (None, Some(speed), Some(degrees)) => {
                let speed = number(&format_args!("balls[{index}].speed"), speed);
                let (x, y) = direction(number(&format_args!("balls[{index}].direction_deg"), degrees));
                Vec3::above(Vec2::new(x, y) * speed, S::ZERO)
            }
            _ => Vec3::ZERO,
        }
    }

    fn start_spin<S: Scalar>(&self, index: usize, number: Number<'_, S>) -> Vec3<S> {
        let spin = self.spin.map(Vector::in_space);
        spin.map_or(Vec3::ZERO, |spin| in_space(&format_args!("balls[{index}].spin"), spin, S::ZERO, number))
    }
}

/// A vector in space, whose third component is `else_up` where it is not given.
fn in_space<S: Scalar>(place: &dyn Display, value: Vector, else_up: S, number: Number<'_, S>) -> Vec3<S> {
    let plan = vector(place, value.plan, number);
    let up = value.up.map_or(else_up, |up| number(&format_args!("{place}[2]"), up));
    Vec3::above(plan, up)
}
