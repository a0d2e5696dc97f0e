//! The one vocabulary of events.

use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Two balls collided.
    BallBall,
    /// A ball hit a cushion or a corner.
    BallCushion,
    /// A ball in a field came to lie on a straight cushion: it slides along it from now on.
    Hold,
    /// A ball that lay on a cushion passed its end.
    Release,
}

impl Kind {
    /// Every kind, in the order of its code.
    pub const ALL: [Self; 4] = [Self::BallBall, Self::BallCushion, Self::Hold, Self::Release];

    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::BallBall => "ball_ball",
            Self::BallCushion => "ball_cushion",
            Self::Hold => "hold",
            Self::Release => "release",
        }
    }

    /// The kind of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// A row of the event log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event<S> {
    /// When.
    pub time: S,
    /// What.
    pub kind: Kind,
    /// The first ball.
    pub ball_a: u32,
    /// The second ball of a ball-ball event.
    pub ball_b: Option<u32>,
    /// The cushion of an event at one.
    pub cushion: Option<u32>,
    /// The place of contact.
    pub point: Vec2<S>,
    /// Unit normal: from the first ball to the second, or from the cushion into the table.
    pub normal: Vec2<S>,
    /// Speed at which the gap closed.
    pub closing_speed: S,
    /// Normal impulse.
    pub impulse: S,
    /// Number of the cluster it was resolved in, from 1; `None` for a contact by itself.
    pub cluster: Option<u32>,
}
