//! How fast a gas of equal discs in a periodic box runs, and how well it keeps what it has to keep.
//!
//! `gas [packing fraction] [discs] [collisions]` prints one line; without numbers the whole table. The rate is the median of
//! five stretches, in millions of collisions a second; predictions are those per collision.

#![allow(clippy::print_stdout, clippy::unwrap_used)]

use carom::engine::{Limits, Simulation};
use carom::run::Nothing;
use carom::scenario::{Scenario, System};
use std::sync::Arc;
use std::time::Instant;

/// A gas on a hexagonal lattice with Maxwell's velocities.
fn gas(packing_fraction: f64, count: usize) -> System<f64> {
    let text = format!(
        "collisions = 1\n[gas]\nn = {count}\npacking_fraction = {packing_fraction}\nstart = 'hexagonal'"
    );
    System::new(&Scenario::from_toml(&text).unwrap())
}

/// Runs a gas until its lattice is gone and then measures; prints a line.
fn measure(packing_fraction: f64, count: usize, collisions: u64) {
    let system = Arc::new(gas(packing_fraction, count));
    let limits = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };
    let mut simulation: Simulation<f64> = Simulation::new(system, limits, &mut Nothing);
    let melting = (30 * count as u64).min(4_000_000);
    let mut steps = |count: u64| {
        let begin = Instant::now();
        let mut left = count;
        while left > 0 {
            let slice = left.min(1_000_000);
            simulation.advance(slice, &mut Nothing).unwrap();
            left -= slice;
        }
        begin.elapsed().as_secs_f64()
    };
    steps(melting);
    let mut rates: Vec<f64> = (0..5).map(|_| (collisions / 5) as f64 / steps(collisions / 5) / 1e6).collect();
    rates.sort_by(f64::total_cmp);
    let found = simulation.diagnostics();
    let drift = found.energy_drift / found.initial_energy;
    println!(
        "{packing_fraction:7} {count:8} {:9.2} {:9.1e} {drift:9.1e} {:7.2}",
        rates[2],
        found.deepest_overlap,
        found.predictions as f64 / found.total_events() as f64,
    );
}

fn main() {
    // The first argument is the program itself.
    let arguments: Result<Vec<f64>, _> = std::env::args().skip(1).map(|argument| argument.parse()).collect();
    println!("packing    discs million/s   overlap     drift  predictions");
    match arguments.as_deref() {
        Ok([]) => {
            for packing_fraction in [0.2, 0.5, 0.7] {
                for count in [1_000, 10_000, 100_000, 1_000_000] {
                    measure(packing_fraction, count, 10_000_000);
                }
            }
        }
        Ok(&[packing_fraction, count, collisions]) => {
            measure(packing_fraction, count as usize, collisions as u64);
        }
        _ => println!("give nothing, or three numbers: packing fraction, discs, collisions"),
    }
}
