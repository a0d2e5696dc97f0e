//! `[cue]` and `[shot]`: the stick, and how it strikes.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The cue. What is absent is that of the table's preset, or else that of a pool cue.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cue {
    /// Mass; positive; absent: 0.567.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub mass: Option<f64>,
    /// Radius of the tip's rounding, in length; absent: 0.0106.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub tip_radius: Option<f64>,
    /// Mass of the end of the shaft that is pushed aside, which makes squirt; zero: no squirt; absent: 0.00567.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub end_mass: Option<f64>,
    /// Coefficient of restitution of the tip, from 0 to 1; absent: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub restitution: Option<f64>,
    /// The tip slips off where it touches the ball further from the middle than this, over the radius; at most 1, which it
    /// never does; absent: 0.55.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(max = 1.0), extend("exclusiveMinimum" = 0.0))]
    pub miscue_offset: Option<f64>,
    /// Length, for drawings; absent: 1.4732.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub length: Option<f64>,
    /// Radius of the shaft at the tip, in length, for drawings; absent: 0.0065.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub shaft_radius: Option<f64>,
    /// Radius of the butt, in length, for drawings; absent: 0.02.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub butt_radius: Option<f64>,
}

impl Cue {
    /// The numbers that are given, by their keys.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> {
        [
            ("mass", self.mass),
            ("tip_radius", self.tip_radius),
            ("end_mass", self.end_mass),
            ("restitution", self.restitution),
            ("miscue_offset", self.miscue_offset),
            ("length", self.length),
            ("shaft_radius", self.shaft_radius),
            ("butt_radius", self.butt_radius),
        ]
        .into_iter()
        .filter_map(|(key, value)| Some((key, value?)))
    }
}

/// A stroke of the cue at time 0, in the words of pooltool or in plain ones. On a cloth only.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Shot {
    /// The id of the ball that is struck; absent: cue.
    #[serde(default = "cue_ball", skip_serializing_if = "is_cue_ball")]
    #[schemars(length(min = 1))]
    pub cue_ball: String,
    /// Speed of the cue as it meets the ball, in length per time, zero or positive; or `cue_speed`.
    #[serde(rename = "V0", skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub v0: Option<f64>,
    /// Speed of the cue as it meets the ball, in length per time, zero or positive; or `V0`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub cue_speed: Option<f64>,
    /// Direction of the stroke seen from above, in degrees from the x axis towards the y axis; or `direction_deg`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub phi_deg: Option<f64>,
    /// Direction of the stroke seen from above, in degrees from the x axis towards the y axis; or `phi_deg`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction_deg: Option<f64>,
    /// How high the butt is raised, in degrees from 0 (level) to 90 (straight down); or `elevation_deg`; absent: 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0, max = 90.0))]
    pub theta_deg: Option<f64>,
    /// How high the butt is raised, in degrees from 0 (level) to 90 (straight down); or `theta_deg`; absent: 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0, max = 90.0))]
    pub elevation_deg: Option<f64>,
    /// How far to the left of the middle the ball is struck, over its radius, as the shooter sees it; or `left`; absent: 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub a: Option<f64>,
    /// How far to the left of the middle the ball is struck, over its radius, as the shooter sees it; or `a`; absent: 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<f64>,
    /// How far above the middle the ball is struck, over its radius, as the shooter sees it along the cue; or `top`; absent:
    /// 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub b: Option<f64>,
    /// How far above the middle the ball is struck, over its radius, as the shooter sees it along the cue; or `b`; absent: 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub top: Option<f64>,
    /// What is offset from the middle by this much; absent: contact.
    #[serde(default, skip_serializing_if = "is_default")]
    pub offset_of: OffsetOf,
}

/// What a shot's offsets are those of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OffsetOf {
    /// The point of the ball that is touched.
    #[default]
    Contact,
    /// The centre of the tip's rounding, which is further out by the tip's radius.
    TipCenter,
}

fn cue_ball() -> String {
    "cue".into()
}

fn is_cue_ball(id: &String) -> bool {
    id == "cue"
}
