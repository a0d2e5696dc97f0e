//! How things move between events.
//!
//! A disc's flight is here; a ball's on the cloth, and through the air, is in `sphere` and `cloth`. A disc's is a polynomial of degree two: `x(t) = x0 + v0 (t − t0) + ½ a (t − t0)²`. The acceleration is zero
//! in free flight, the field's in a constant field, and the field's projection on the cushion for a held ball.

mod cloth;
mod sphere;

pub use cloth::Cloth;
pub use sphere::{Motion, SphereFlight, SphereState};

use crate::geometry::Vec2;
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// A disc's position and velocity at some moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<S> {
    /// Position of the centre.
    pub position: Vec2<S>,
    /// Velocity.
    pub velocity: Vec2<S>,
}

/// A disc's closed-form motion since its own last event. Nothing but an event of that disc replaces it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flight<S> {
    /// The time at which the flight begins.
    pub start: S,
    /// Position of the centre at that time.
    pub position: Vec2<S>,
    /// Velocity at that time.
    pub velocity: Vec2<S>,
    /// Constant acceleration.
    pub acceleration: Vec2<S>,
}

impl<S: Scalar> Flight<S> {
    /// Position a time `elapsed` after the start.
    #[inline(always)]
    pub fn position_after(&self, elapsed: S) -> Vec2<S> {
        self.position + (self.velocity + self.acceleration * (elapsed * S::from_f64(0.5))) * elapsed
    }

    /// Velocity a time `elapsed` after the start.
    #[inline(always)]
    pub fn velocity_after(&self, elapsed: S) -> Vec2<S> {
        self.velocity + self.acceleration * elapsed
    }

    /// Position and velocity a time `elapsed` after the start.
    #[inline(always)]
    pub fn state_after(&self, elapsed: S) -> State<S> {
        State { position: self.position_after(elapsed), velocity: self.velocity_after(elapsed) }
    }

    /// The same for a flight without acceleration, quicker: its velocity need not wait for the time.
    #[inline(always)]
    pub fn straight_state_after(&self, elapsed: S) -> State<S> {
        State { position: self.position + self.velocity * elapsed, velocity: self.velocity }
    }

    /// The later of the starts of two flights: the moment from which on both are known.
    #[inline(always)]
    pub fn later_start(&self, other: &Self) -> S {
        if self.start > other.start { self.start } else { other.start }
    }

    /// Whether the flight has no acceleration.
    #[inline(always)]
    pub fn is_straight(&self) -> bool {
        self.acceleration.x == S::ZERO && self.acceleration.y == S::ZERO
    }

    /// Whether the disc does not move, now or later.
    pub fn is_rest(&self) -> bool {
        self.is_straight() && self.velocity == Vec2::ZERO
    }

    /// Whether the disc does not move, or so slowly that it has not gone `distance` by the time `latest`.
    pub fn is_rest_within(&self, distance: S, latest: S) -> bool {
        let speed = self.velocity.x.abs() + self.velocity.y.abs();
        self.is_rest() || (self.is_straight() && self.start + distance / speed > latest)
    }
}
