//! What is counted at events: a few sums, taken out at each sample.

use super::free_path::FreeTimes;
use crate::run::{Event, Kind};
use serde::{Deserialize, Serialize};

/// Sums over the events since the last sample.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct EventSums {
    /// Whether anybody wants them, and observing has begun.
    is_watching: bool,
    collisions: u64,
    virial: f64,
    wall_impulse: f64,
    radii: Radii,
    /// The times between the collisions of each disc, where they are wanted.
    pub free_times: Option<FreeTimes>,
}

/// The radii of the discs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Radii {
    Equal(f64),
    Each(Vec<f64>),
}

impl Default for Radii {
    fn default() -> Self {
        Self::Equal(0.0)
    }
}

impl Radii {
    fn new(radii: &[f64]) -> Self {
        match radii {
            [first, rest @ ..] if rest.iter().all(|radius| radius == first) => Self::Equal(*first),
            _ => Self::Each(radii.to_vec()),
        }
    }

    #[inline(always)]
    fn sum(&self, ball_a: u32, ball_b: u32) -> f64 {
        match self {
            Self::Equal(radius) => radius + radius,
            Self::Each(radii) => radii[ball_a as usize] + radii[ball_b as usize],
        }
    }
}

impl EventSums {
    /// From now on events count.
    pub fn watch(&mut self, radii: &[f64], wants_free_times: bool) {
        self.is_watching = true;
        self.radii = Radii::new(radii);
        self.free_times = wants_free_times.then(|| FreeTimes::new(radii.len()));
    }

    #[inline(always)]
    pub fn event(&mut self, event: &Event<f64>) {
        if !self.is_watching {
            return;
        }
        match (event.kind, event.ball_b) {
            (Kind::BallBall, Some(ball_b)) => {
                self.collisions += 1;
                self.virial += event.impulse * self.radii.sum(event.ball_a, ball_b);
                if let Some(free_times) = &mut self.free_times {
                    free_times.collision(event.time, event.ball_a, ball_b);
                }
            }
            (Kind::BallCushion, _) => self.wall_impulse += event.impulse,
            _ => {}
        }
    }

    /// Collisions, virial and impulse at walls since this was last asked.
    pub fn take(&mut self) -> [f64; 3] {
        let sums = [self.collisions as f64, self.virial, self.wall_impulse];
        (self.collisions, self.virial, self.wall_impulse) = (0, 0.0, 0.0);
        sums
    }
}
