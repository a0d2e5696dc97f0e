//! `[physics]`: the laws of motion and of collision.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The laws of motion and of collision.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Physics {
    /// How balls move between events; absent: free flight.
    #[serde(default, skip_serializing_if = "is_default")]
    pub flight: Flight,
    /// What happens when two balls meet; absent: elastic.
    #[serde(default, skip_serializing_if = "is_default")]
    pub ball_ball: BallBall,
    /// What happens when a ball meets a cushion; absent: elastic.
    #[serde(default, skip_serializing_if = "is_default")]
    pub ball_cushion: BallCushion,
    /// Laws of single cushions and corners, by their ids, in place of `ball_cushion`. A corner without one has the law of
    /// the first of its two cushions.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub cushions: BTreeMap<String, BallCushion>,
    /// How contacts at one instant are resolved; absent: reflections.
    #[serde(default, skip_serializing_if = "is_default")]
    pub cluster: Cluster,
    /// What is done when a ball's contacts follow each other without end in a finite time; absent: stop.
    #[serde(default, skip_serializing_if = "is_default")]
    pub collapse: Collapse,
}

impl Physics {
    /// The law of a cushion: its own where it has one.
    pub fn law_of_cushion(&self, id: &str) -> &BallCushion {
        self.cushions.get(id).unwrap_or(&self.ball_cushion)
    }
}

/// How balls move between events.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum Flight {
    /// Straight ahead at constant velocity.
    #[default]
    Free,
    /// With the same constant acceleration for all balls.
    Field {
        /// Acceleration [x, y], in length per time squared.
        acceleration: [f64; 2],
    },
}

/// What happens when two balls meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum BallBall {
    /// The closing speed is reversed; no energy is lost.
    #[default]
    Elastic,
    /// The balls part at a fraction of their closing speed.
    Restitution {
        /// That fraction, from 0 (they stay together) to 1 (elastic).
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
    },
}

/// What happens when a ball meets a cushion.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum BallCushion {
    /// Reflected as light by a mirror; no energy is lost.
    #[default]
    Elastic,
    /// The normal and the tangential part of the velocity are each multiplied by a factor.
    Restitution {
        /// Speed away from the cushion over speed towards it, from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
        /// Speed along the cushion after over before, from 0 to 1; absent: 1.
        #[serde(default = "one")]
        #[schemars(range(min = 0.0, max = 1.0))]
        tangential: f64,
    },
    /// The reflected velocity is multiplied by a factor: `restitution` with `normal` and `tangential` both this.
    Damping {
        /// That factor, from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        factor: f64,
    },
}

/// How contacts at one instant are resolved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cluster {
    /// All closing contacts at once, again and again until none closes.
    #[default]
    Reflections,
    /// As stiff elastic balls do, which press on all their neighbours for the short while that a contact takes.
    Hertz,
    /// One contact after the other.
    Pairwise,
}

/// What is done when a ball's contacts follow each other without end in a finite time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Collapse {
    /// The run ends with the status `collapsed`.
    #[default]
    Stop,
    /// Contacts less than t_c after a ball's last one lose nothing, and in a field balls part from each other and from
    /// cushions with a hop of about t_c at least: so they go on hopping, with hops too small to see, and do not come to
    /// rest. t_c is `1e-3 √(2r/|a|)` in a field a, `1e-6 r` over the greatest speed at the start without.
    Tc,
}

fn one() -> f64 {
    1.0
}
