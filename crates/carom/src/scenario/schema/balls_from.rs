//! `[balls_from]`: balls that stand in a file of their own, and `[balls_source]`, which says where they came from.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Discs read from a file of snapshots when the scenario is loaded, which then lists them as `balls`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallsFrom {
    /// The file, which ends in .gsd, .xyz, .extxyz or .parquet; relative to the folder of the scenario file.
    #[schemars(length(min = 1))]
    pub path: String,
    /// Which frame of it, from 0; −1 is the last; absent: −1.
    #[serde(default = "last", skip_serializing_if = "is_last")]
    pub frame: i64,
    /// The SHA-256 of the file, as `sha256sum` prints it; a file with another one is refused; absent: not looked at.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1))]
    pub sha256: Option<String>,
    /// The radius of every disc where the file has no radii, in length; zero or positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub radius: Option<f64>,
    /// What all radii are multiplied by, from 0.5 to 1; absent: 1. A hair less than 1 parts discs that a file in single
    /// precision lets overlap.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.5, max = 1.0))]
    pub radius_factor: Option<f64>,
    /// The mass of every disc where the file has no masses; positive; absent: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub mass: Option<f64>,
    /// The temperature kT of Maxwell's velocities where the file has no velocities; zero, at rest, or positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub temperature: Option<f64>,
    /// What those velocities are drawn from; absent: 0.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(range(max = 9_223_372_036_854_775_807_u64))]
    pub seed: u64,
}

/// Which file the balls were read from. Written when they are; nothing is read again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallsSource {
    /// The file, as the scenario named it.
    pub path: String,
    /// Which frame of it, from 0.
    pub frame: u64,
    /// The SHA-256 of the file when it was read.
    pub sha256: String,
    /// Whether the table is the box of that file, too; absent: no.
    #[serde(default, skip_serializing_if = "is_default")]
    pub table: bool,
}

fn last() -> i64 {
    -1
}

/// Serde hands over a reference.
fn is_last(frame: &i64) -> bool {
    *frame == last()
}
