//! The keys of a scenario file: the one definition, from which the JSON Schema is made too.
//!
//! A number's range stands in its `schemars` attribute, so that an editor, the page and the structure check read the
//! same one. Any consistent units will do; "length" in a description means the scenario's own unit of length.

mod balls;
mod balls_from;
mod color;
mod cue;
mod gas;
mod method;
mod physics;
mod preset;
mod rack;
mod table;
mod vector;

pub use balls::{Ball, BallDefaults};
pub use balls_from::{BallsFrom, BallsSource};
pub use color::{COLOR_NAMES, Color};
pub use cue::{Cue, OffsetOf, Shot};
pub use gas::{Gas, Masses, Mixture, Sizes, Species, Start, Velocities};
pub use method::{AfterHit, LastStep, Method, NormalTaken};
pub use physics::{
    BallBall, BallCushion, Cluster, Collapse, CushionFriction, Flight, Physics, Rebound, SlipFriction,
};
pub use preset::Preset;
pub use rack::{Game, Rack};
pub use table::{
    ArcShape, Axis, CircleShape, MouthChange, MouthShape, NoseContact, Obstacle, Piece, PocketShape,
    PresetTable, Table,
};
pub use vector::Vector;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The newest scenario format that this engine reads, and the one it writes.
pub const FORMAT: u32 = 1;

/// A carom scenario: everything a run needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// The version of the scenario format; absent means 1, the only one so far.
    #[serde(default = "first_format")]
    #[schemars(range(min = 1))]
    pub format: u32,
    /// A short title, for headings and lists.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// What the scenario shows and what to look at.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// How long to run, in time; zero or positive. With neither this nor `collisions` the run goes on until everything
    /// rests, which is an error where nothing can come to rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub duration: Option<f64>,
    /// End after this many collisions of balls with balls and cushions.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(max = 9_223_372_036_854_775_807_u64))]
    pub collisions: Option<u64>,
    /// End after this many events of any kind. Absent: 10 000 000, or no such end where `collisions` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 9_223_372_036_854_775_807_u64))]
    pub max_events: Option<u64>,
    /// What a run keeps; absent: all, and of a gas none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub record: Option<Record>,
    /// The region the balls move in; to be left out only where there is a gas, which has its own box, or where balls are read
    /// from a file, whose box then is the table.
    #[serde(default, skip_serializing_if = "is_default")]
    pub table: Table,
    /// The laws of motion and of collision; absent: free flight and elastic collisions.
    #[serde(default, skip_serializing_if = "is_default")]
    pub physics: Physics,
    /// How the run is computed; absent: exact.
    #[serde(default, skip_serializing_if = "is_default")]
    pub method: Method,
    /// What balls have that do not say it themselves.
    #[serde(default, skip_serializing_if = "is_default")]
    pub ball_defaults: BallDefaults,
    /// Balls set up for a game; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rack: Option<Rack>,
    /// The balls; at least one, unless there is a rack or a gas, or they are read from a file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(min = 1))]
    pub balls: Vec<Ball>,
    /// Balls that are read from a file, in place of `balls`; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balls_from: Option<BallsFrom>,
    /// Which file the balls were read from; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balls_source: Option<BallsSource>,
    /// A gas: so many discs in a box of their own, in place of a table and balls; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gas: Option<Gas>,
    /// The cue.
    #[serde(default, skip_serializing_if = "is_default")]
    pub cue: Cue,
    /// A stroke of the cue at time 0; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shot: Option<Shot>,
    /// Names of the units, for labels of axes and columns and nothing else.
    #[serde(default, skip_serializing_if = "is_default")]
    pub units: Units,
}

/// What a run keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Record {
    /// Events and flights (of a stepped run, its steps), so that the state at any time can be asked for.
    #[default]
    All,
    /// Events only.
    Events,
    /// Neither: the final state and the diagnostics only.
    None,
}

/// Names of the units, such as "m", "s" and "kg".
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// The unit of length.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<String>,
    /// The unit of time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<String>,
    /// The unit of mass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<String>,
}

impl Scenario {
    /// What a run of it keeps.
    pub fn record(&self) -> Record {
        self.record.unwrap_or(self.usual_record())
    }

    /// A gas has too many events to keep them unasked.
    fn usual_record(&self) -> Record {
        if self.gas.is_some() { Record::None } else { Record::All }
    }

    /// This scenario without a `record` that says what is so anyway.
    pub(super) fn with_plain_record(self) -> Self {
        let usual = self.usual_record();
        Self { record: self.record.filter(|kept| *kept != usual), ..self }
    }
}

fn first_format() -> u32 {
    1
}

/// Whether a value is its type's default, and so need not be written.
pub(crate) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
