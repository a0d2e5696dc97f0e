//! What a disc costs in memory, counted by the allocator.

use crate::ALLOCATOR;
use crate::verdict::{Bounded, Verdict, progress};
use carom::engine::{Limits, Simulation};
use carom::run::Nothing;
use carom::scenario::{Scenario, System};
use std::sync::Arc;

const COUNT: usize = 1_000_000;
/// Bytes that a disc may cost the engine.
const MOST: f64 = 400.0;
/// Collisions after which queues and cells have the size that they keep.
const COLLISIONS: f64 = 4e6;

/// A million discs: what the engine takes for itself, beside the system that it computes.
pub fn memory(scale: f64, verdict: &mut Verdict) {
    for packing_fraction in [0.2, 0.5, 0.7] {
        let name = format!("packing {packing_fraction}");
        progress(&name, 0.0);
        let text = format!(
            "collisions = 1\n[gas]\nn = {COUNT}\npacking_fraction = {packing_fraction}\nstart = 'hexagonal'"
        );
        let scenario = Scenario::from_toml(&text).expect("a gas of the campaign's own");
        let before = ALLOCATOR.current_usage();
        let system = Arc::new(System::new(&scenario));
        let of_system = per_disc(ALLOCATOR.current_usage() - before);
        drop(scenario);
        let before = ALLOCATOR.current_usage();
        ALLOCATOR.reset_peak_usage();
        let limits = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };
        let mut simulation: Simulation<f64> = Simulation::new(system, limits, &mut Nothing);
        let at_first = per_disc(ALLOCATOR.current_usage() - before);
        if let Err(error) = simulation.advance((COLLISIONS * scale) as u64, &mut Nothing) {
            return verdict.failure(&name, &error.to_string());
        }
        let later = per_disc(ALLOCATOR.current_usage() - before);
        let peak = per_disc(ALLOCATOR.peak_usage() - before);
        let case = format!(
            "{name}  bytes a disc: system {of_system:.0}, engine at first {at_first:.0}, later {later:.0}"
        );
        verdict.line(&case, &[Bounded { name: "engine at most", value: peak, bound: MOST }]);
    }
}

fn per_disc(bytes: usize) -> f64 {
    bytes as f64 / COUNT as f64
}
