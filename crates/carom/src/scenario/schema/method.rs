//! `[method]`: how a run is computed.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a run is computed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Method {
    /// From event to event, without a time step.
    #[default]
    Exact,
    /// The fixed-step scheme of programming courses: rectangle, elastic balls, no field, no obstacles.
    Stepped {
        /// The time step, in time; positive. A run that keeps its steps (`record = "all"`) may have 10 000 000 of them,
        /// counted for each ball.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        dt: f64,
        /// What the other balls do in a step in which something is hit; absent: wait.
        #[serde(default, skip_serializing_if = "is_default")]
        after_hit: AfterHit,
        /// When the normal of a ball-ball contact is taken; absent: before.
        #[serde(default, skip_serializing_if = "is_default")]
        normal: NormalTaken,
        /// What the last step does where the duration is no multiple of `dt`; absent: short.
        #[serde(default, skip_serializing_if = "is_default")]
        last_step: LastStep,
        /// How many full steps to make; given, it decides the end in place of `duration`.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(range(max = 9_223_372_036_854_775_807_u64))]
        steps: Option<u64>,
    },
}

/// What the other balls do in a step in which something is hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AfterHit {
    /// A ball that hit something waits there for the end of the step; the others make theirs in full.
    #[default]
    Wait,
    /// Only the earliest hit happens; all balls and the clock stop there, and a new full step begins.
    Restart,
}

/// When the normal of a ball-ball contact is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NormalTaken {
    /// Before the balls move to their contact.
    #[default]
    Before,
    /// At their contact.
    Contact,
}

/// What the last step does where the duration is no multiple of the time step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LastStep {
    /// It is shorter and ends exactly at the duration.
    #[default]
    Short,
    /// It is a full step and ends past the duration.
    Full,
}
