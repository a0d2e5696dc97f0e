//! `[[balls]]` and `[ball_defaults]`.

use super::Color;
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
    /// Centre [x, y] at time 0, in length.
    pub position: [f64; 2],
    /// Velocity [x, y] at time 0, in length per time; absent: at rest, unless `speed` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<[f64; 2]>,
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
