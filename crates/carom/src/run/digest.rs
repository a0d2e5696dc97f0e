//! The digest of a run's end: a hash that two runs share only if they agree to the last bit.

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

/// What tells two runs apart: so that a difference says whether logic or arithmetic moved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Digest {
    /// Number of events.
    pub events: u64,
    /// Bits of the end time, in hexadecimal digits.
    pub end_time: String,
    /// SHA-256 of the end time and every ball's numbers (of a disc x, y, v_x, v_y), in file order, as little-endian `f64`.
    pub state: String,
}

/// The digest of `events` events and the numbers of each ball's state at `end_time`.
///
/// Negative zero counts as zero. `None` if any number is NaN.
pub fn digest(events: u64, end_time: f64, states: impl Iterator<Item = f64>) -> Option<Digest> {
    let mut hasher = Sha256::new();
    let mut is_complete = true;
    let mut add = |value: f64| {
        is_complete &= !value.is_nan();
        // Adding zero turns −0 into +0 and leaves every other number as it is.
        hasher.update((value + 0.0).to_le_bytes());
    };
    add(end_time);
    states.for_each(&mut add);
    let state: String = hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    let end_time = format!("{:016x}", (end_time + 0.0).to_bits());
    is_complete.then_some(Digest { events, end_time, state: format!("sha256:{state}") })
}

impl Digest {
    /// The digest of a run that has NaN in its end: equal to no real one.
    pub fn none() -> Self {
        Self { events: 0, end_time: String::new(), state: "not a number".to_owned() }
    }
}
