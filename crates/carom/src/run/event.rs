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
    /// The cue struck a ball.
    CueBall,
    /// The tip of the cue slipped off the ball.
    Miscue,
    /// A ball that slid on the cloth rolls from now on.
    SlideToRoll,
    /// A ball that slid stopped, and spins in place.
    SlideToSpin,
    /// A ball that slid stopped.
    SlideToRest,
    /// A ball that rolled stopped, and spins in place.
    RollToSpin,
    /// A ball that rolled stopped.
    RollToRest,
    /// A ball that spun in place stopped.
    SpinToRest,
    /// A ball fell onto the cloth.
    BallCloth,
    /// A ball dropped into a pocket.
    BallPocket,
    /// A ball flew over a cushion, off the table.
    OffTable,
}

impl Kind {
    /// Every kind, in the order of its code.
    pub const ALL: [Self; 15] = [
        Self::BallBall,
        Self::BallCushion,
        Self::Hold,
        Self::Release,
        Self::CueBall,
        Self::Miscue,
        Self::SlideToRoll,
        Self::SlideToSpin,
        Self::SlideToRest,
        Self::RollToSpin,
        Self::RollToRest,
        Self::SpinToRest,
        Self::BallCloth,
        Self::BallPocket,
        Self::OffTable,
    ];

    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::BallBall => "ball_ball",
            Self::BallCushion => "ball_cushion",
            Self::Hold => "hold",
            Self::Release => "release",
            Self::CueBall => "cue_ball",
            Self::Miscue => "miscue",
            Self::SlideToRoll => "slide_to_roll",
            Self::SlideToSpin => "slide_to_spin",
            Self::SlideToRest => "slide_to_rest",
            Self::RollToSpin => "roll_to_spin",
            Self::RollToRest => "roll_to_rest",
            Self::SpinToRest => "spin_to_rest",
            Self::BallCloth => "ball_cloth",
            Self::BallPocket => "ball_pocket",
            Self::OffTable => "off_table",
        }
    }

    /// Whether it can happen to balls on a cloth, or else to discs.
    pub fn happens(self, on_cloth: bool) -> bool {
        match self {
            Self::BallBall | Self::BallCushion => true,
            Self::Hold | Self::Release => !on_cloth,
            Self::CueBall
            | Self::Miscue
            | Self::SlideToRoll
            | Self::SlideToSpin
            | Self::SlideToRest
            | Self::RollToSpin
            | Self::RollToRest
            | Self::SpinToRest
            | Self::BallCloth
            | Self::BallPocket
            | Self::OffTable => on_cloth,
        }
    }

    /// The kind of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// A row of the event log.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event<S> {
    /// When.
    pub time: S,
    /// What.
    pub kind: Kind,
    /// The first ball.
    pub ball_a: u32,
    /// The second ball of a ball-ball event.
    pub ball_b: Option<u32>,
    /// The cushion of an event at one, or the pocket, which are numbered after cushions and corners.
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
