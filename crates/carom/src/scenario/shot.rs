//! The shot in numbers: both spellings give the same, and offsets become those of the point that is touched.

use super::layout::Number;
use super::schema::{Cue, OffsetOf, Scenario, Shot};
use crate::geometry::Vec2;
use crate::scalar::{Scalar, direction};
use core::fmt::Display;

/// A cue at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueStart<S> {
    /// Mass.
    pub mass: S,
    /// Radius of the tip's rounding.
    pub tip_radius: S,
    /// Mass of the end of the shaft that is pushed aside; zero: no squirt.
    pub end_mass: S,
    /// Coefficient of restitution of the tip.
    pub restitution: S,
    /// The greatest offset of the contact from the middle, over the ball's radius, at which the tip holds.
    pub miscue_offset: S,
    /// Length of the stick.
    pub length: S,
    /// Radius of the stick at the tip.
    pub shaft_radius: S,
    /// Radius of the stick at the butt.
    pub butt_radius: S,
}

/// A stroke of the cue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShotStart<S> {
    /// The place of the struck ball in the list of balls.
    pub ball: usize,
    /// Speed of the cue.
    pub speed: S,
    /// Unit vector of the stroke as seen from above.
    pub direction: Vec2<S>,
    /// Cosine and sine of the elevation of the butt.
    pub elevation: (S, S),
    /// Offset of the point of contact to the shooter's left, over the ball's radius.
    pub left: S,
    /// Offset of the point of contact upwards in the cue's own frame, over the ball's radius.
    pub top: S,
}

impl Cue {
    /// A pool cue, and the tip that touches without loss: pooltool's default.
    pub(super) const POOL: Self = Self {
        mass: Some(0.567),
        tip_radius: Some(0.0106045),
        end_mass: Some(0.170097 / 30.0),
        restitution: Some(1.0),
        miscue_offset: Some(0.55),
        length: Some(1.4732),
        shaft_radius: Some(0.0065),
        butt_radius: Some(0.02),
    };

    /// This cue, what is absent being that of a pool cue.
    pub fn start<S: Scalar>(&self, number: Number<'_, S>) -> CueStart<S> {
        let mut either = |key: &str, own: Option<f64>, default: Option<f64>| {
            number(&format_args!("cue.{key}"), own.or(default).unwrap_or_default())
        };
        CueStart {
            mass: either("mass", self.mass, Self::POOL.mass),
            tip_radius: either("tip_radius", self.tip_radius, Self::POOL.tip_radius),
            end_mass: either("end_mass", self.end_mass, Self::POOL.end_mass),
            restitution: either("restitution", self.restitution, Self::POOL.restitution),
            miscue_offset: either("miscue_offset", self.miscue_offset, Self::POOL.miscue_offset),
            length: either("length", self.length, Self::POOL.length),
            shaft_radius: either("shaft_radius", self.shaft_radius, Self::POOL.shaft_radius),
            butt_radius: either("butt_radius", self.butt_radius, Self::POOL.butt_radius),
        }
    }
}

impl Shot {
    /// The speed, with the key that gives it.
    pub(super) fn speed(&self) -> Option<(&'static str, f64)> {
        either(("V0", self.v0), ("cue_speed", self.cue_speed))
    }

    pub(super) fn direction(&self) -> Option<(&'static str, f64)> {
        either(("phi_deg", self.phi_deg), ("direction_deg", self.direction_deg))
    }

    fn elevation(&self) -> Option<(&'static str, f64)> {
        either(("theta_deg", self.theta_deg), ("elevation_deg", self.elevation_deg))
    }

    fn side(&self) -> Option<(&'static str, f64)> {
        either(("a", self.a), ("left", self.left))
    }

    fn height(&self) -> Option<(&'static str, f64)> {
        either(("b", self.b), ("top", self.top))
    }

    /// What an offset as it is written is taken times, to be that of the point of contact.
    pub(super) fn offset_scale<S: Scalar>(&self, tip_radius: S, radius: S) -> S {
        match self.offset_of {
            OffsetOf::Contact => S::ONE,
            OffsetOf::TipCenter => radius / (radius + tip_radius),
        }
    }

    /// The offsets (left, top) of the point of contact over the radius, with a tip and a ball of these radii.
    pub(super) fn offsets<S: Scalar>(&self, tip_radius: S, radius: S, number: Number<'_, S>) -> (S, S) {
        let scale = self.offset_scale(tip_radius, radius);
        (entered(self.side(), number) * scale, entered(self.height(), number) * scale)
    }
}

impl Scenario {
    /// The shot of a checked and expanded scenario, each of whose numbers enters through `number` with its place as it is
    /// written, `shot.V0` or `shot.cue_speed`; none where there is none, or its ball is not there.
    pub fn shot_start<S: Scalar>(&self, number: Number<'_, S>) -> Option<ShotStart<S>> {
        let shot = self.shot.as_ref()?;
        let ball = self.balls.iter().position(|ball| ball.id == shot.cue_ball)?;
        let tip_radius = self.cue.start(number).tip_radius;
        let radius = self.balls[ball].start(ball, &self.ball_defaults, number).radius;
        let (left, top) = shot.offsets(tip_radius, radius, number);
        let (x, y) = direction(entered(shot.direction(), number));
        Some(ShotStart {
            ball,
            speed: entered(shot.speed(), number),
            direction: Vec2::new(x, y),
            elevation: direction(entered(shot.elevation(), number)),
            left,
            top,
        })
    }
}

/// The one of two keys that is given.
fn either(
    (key, value): (&'static str, Option<f64>),
    (other, else_value): (&'static str, Option<f64>),
) -> Option<(&'static str, f64)> {
    value.map(|value| (key, value)).or_else(|| else_value.map(|value| (other, value)))
}

/// A number of the shot as it enters a computation; zero where it is absent.
fn entered<S: Scalar>(value: Option<(&'static str, f64)>, number: Number<'_, S>) -> S {
    value.map_or(S::ZERO, |(key, value)| number(&format_args!("shot.{key}") as &dyn Display, value))
}
