//! `[[balls]]` and `[ball_defaults]`.

use super::{Color, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What balls have that do not say it themselves.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallDefaults {
    /// Radius, in length; zero (a point) or positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub radius: Option<f64>,
    /// Mass; positive; absent: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub mass: Option<f64>,
    /// Coefficient of sliding friction with the cloth; zero or positive; absent: 0.2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub sliding_friction: Option<f64>,
    /// Coefficient of rolling friction with the cloth; zero or positive; absent: 0.01.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub rolling_friction: Option<f64>,
    /// Rate at which the cloth slows the spin about the vertical, in radians per time squared; zero or positive; absent: 10.9.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub spin_decay: Option<f64>,
    /// Colour in figures and films.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<Color>,
}

/// A ball and how it starts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ball {
    /// The name of this ball, unlike that of any other; not empty.
    #[schemars(length(min = 1))]
    pub id: String,
    /// Radius, in length; zero (a point) or positive; absent: that of `ball_defaults`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub radius: Option<f64>,
    /// Mass; positive; absent: that of `ball_defaults`, or 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub mass: Option<f64>,
    /// Coefficient of sliding friction with the cloth; zero or positive; absent: that of `ball_defaults`, or 0.2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub sliding_friction: Option<f64>,
    /// Coefficient of rolling friction with the cloth; zero or positive; absent: that of `ball_defaults`, or 0.01.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub rolling_friction: Option<f64>,
    /// Rate at which the cloth slows the spin about the vertical, in radians per time squared; zero or positive; absent: that of `ball_defaults`, or 10.9.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub spin_decay: Option<f64>,
    /// Centre [x, y] at time 0, in length; over a cloth [x, y, z], with the height of the centre. To be left out only by a
    /// ball of the rack.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<Vector>,
    /// Velocity [x, y] at time 0, in length per time; over a cloth [x, y, z] too; absent: at rest, unless `speed` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<Vector>,
    /// Angular velocity [x, y, z] at time 0, in radians per time, by the right-hand rule; absent: none. On a cloth only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spin: Option<[f64; 3]>,
    /// Speed at time 0, in length per time, zero or positive; together with `direction_deg`, in place of `velocity`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub speed: Option<f64>,
    /// Direction of motion at time 0, in degrees from the x axis towards the y axis; together with `speed`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction_deg: Option<f64>,
    /// Colour in figures and films; absent: that of `ball_defaults`, or one given by the drawing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<Color>,
}
