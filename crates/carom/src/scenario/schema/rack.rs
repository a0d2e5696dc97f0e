//! `[rack]`: balls set up for a game.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Balls set up for a game. An entry of `balls` with the id of one of them replaces what it gives; others are added.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rack {
    /// The game.
    pub game: Game,
    /// What the order and the displacements are drawn from, where they are random; absent: 0.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(range(max = 9_223_372_036_854_775_807_u64))]
    pub seed: u64,
    /// The gap between neighbours over a ball's diameter; absent: 0, so that they touch.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(range(min = 0.0))]
    pub spacing: f64,
    /// How far at most each racked ball is moved from its place, at random, over its radius; absent: 0.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(range(min = 0.0))]
    pub jitter: f64,
}

/// A game, and so how its balls are set up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Game {
    /// Balls 1 to 15 in a triangle, the 8 in the middle of its third row, a stripe and a solid in the rear corners.
    EightBall,
    /// Balls 1 to 9 in a diamond, the 1 at its head and the 9 in the middle.
    NineBall,
    /// Balls 1 to 10 in a triangle, the 1 at its head and the 10 in the middle of its third row.
    TenBall,
    /// Balls 1 to 15 in a triangle, in any order.
    StraightPool,
    /// Fifteen reds in a triangle behind the pink, and six colours on their spots.
    Snooker,
    /// One red and two cue balls on their spots.
    ThreeCushion,
    /// Seven reds and seven yellows in a triangle around the 8, which stands on the foot spot.
    EnglishPool,
}

impl Game {
    /// The ball that the cue strikes first.
    pub fn cue_ball(self) -> &'static str {
        match self {
            Self::Snooker | Self::ThreeCushion => "white",
            Self::EightBall | Self::NineBall | Self::TenBall | Self::StraightPool | Self::EnglishPool => {
                "cue"
            }
        }
    }
}
