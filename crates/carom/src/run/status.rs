//! How a run ended.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Why a run ended. This list is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// The duration was reached.
    TimeLimit,
    /// The number of collisions asked for was reached.
    CollisionLimit,
    /// What the caller waited for happened.
    Stopped,
    /// Nothing moves any more, and nothing will.
    AtRest,
    /// A ball's events followed each other without end.
    Collapsed,
    /// The event budget was used up.
    EventLimit,
    /// Broken off from outside.
    Interrupted,
    /// The cue slipped off the ball, and what that does no law says.
    Miscue,
}

impl Status {
    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::TimeLimit => "time_limit",
            Self::CollisionLimit => "collision_limit",
            Self::Stopped => "stopped",
            Self::AtRest => "at_rest",
            Self::Collapsed => "collapsed",
            Self::EventLimit => "event_limit",
            Self::Interrupted => "interrupted",
            Self::Miscue => "miscue",
        }
    }
}

/// A broken invariant: the engine's fault, not the scenario's.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SimulationError {
    /// Two balls were found in each other, deeper than the contact tolerance.
    #[error("ball {ball} overlaps another by {depth:e} at time {time}, more than the contact tolerance")]
    Overlap {
        /// Name of one of the two.
        ball: String,
        /// When.
        time: f64,
        /// How deep.
        depth: f64,
    },
    /// A position or velocity left the range of numbers.
    #[error("a position or velocity is no longer a finite number at time {time}")]
    NotFinite {
        /// When it was noticed.
        time: f64,
    },
    /// Balls move, and nothing stops them: one has left the table.
    #[error(
        "ball {ball} moves after time {time} and never meets anything again, although the run has no duration"
    )]
    Escape {
        /// Its name.
        ball: String,
        /// When.
        time: f64,
    },
}
