//! Runs audit themselves.

use super::event::Kind;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// What a run found out about itself. All sums are in `f64`; none of them acts back on the run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Diagnostics {
    /// Events of each kind, in the order of [`Kind::ALL`]; a saved run may know fewer kinds.
    #[serde(deserialize_with = "counts")]
    pub events: [u64; Kind::ALL.len()],
    /// Predictions of a ball's next event.
    pub predictions: u64,
    /// Pending events dropped because the partner had meanwhile changed its course.
    pub stale: u64,
    /// The deepest overlap of two balls ever seen, as a length; in a stepped run at any time, within its steps too.
    pub deepest_overlap: f64,
    /// Clusters resolved.
    pub clusters: u64,
    /// Passes made in them.
    pub cluster_passes: u64,
    /// Clusters that needed a last pass without restitution.
    pub forced_clusters: u64,
    /// Energy at the start: kinetic, and potential in a field.
    pub initial_energy: f64,
    /// Energy at the end, or when last summed.
    pub final_energy: f64,
    /// Energy that the laws took away.
    pub energy_loss: f64,
    /// The largest change of the participants' energy in one event that its law does not account for.
    pub energy_error: f64,
    /// The largest energy that a cluster gained; laws never give any.
    pub energy_gain: f64,
    /// The largest change of momentum in one ball-ball event.
    pub momentum_error: f64,
    /// The largest of |energy − initial energy + losses| seen in full sums at 2^k events and at the end.
    pub energy_drift: f64,
    /// Time that balls lost waiting for the end of a step, summed over balls; zero for an exact run.
    pub lost_time: f64,
    /// States corrected by the engine: none, as it never does.
    pub corrections: u64,
}

/// Counts of the kinds that there were when a run was saved; there are none of later ones.
fn counts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[u64; Kind::ALL.len()], D::Error> {
    let saved = Vec::<u64>::deserialize(deserializer)?;
    let mut counts = [0; Kind::ALL.len()];
    if saved.len() > counts.len() {
        return Err(D::Error::invalid_length(saved.len(), &"a count for each kind of event"));
    }
    counts[..saved.len()].copy_from_slice(&saved);
    Ok(counts)
}

impl Diagnostics {
    /// All events.
    pub fn total_events(&self) -> u64 {
        self.events.iter().sum()
    }

    /// Ball-ball and ball-cushion events.
    pub fn collisions(&self) -> u64 {
        self.events[Kind::BallBall as usize] + self.events[Kind::BallCushion as usize]
    }

    /// Counts an event.
    #[inline(always)]
    pub fn count(&mut self, kind: Kind) {
        self.events[kind as usize] += 1;
    }

    /// Accounts for an event: what its participants' energy changed by, and what the law says it took.
    #[inline(always)]
    pub fn account(&mut self, change: f64, loss: f64) {
        self.energy_loss += loss;
        let error = (change + loss).abs();
        if error > self.energy_error {
            self.energy_error = error;
        }
    }
}
