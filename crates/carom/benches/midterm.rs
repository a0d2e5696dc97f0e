//! The course exercise: one exact run in the engine on one core.
#![allow(clippy::expect_used)]

use carom::engine::{Limits, Simulation};
use carom::run::{Log, Nothing};
use carom::scenario::{Scenario, System};
use divan::{Bencher, black_box};
use std::sync::Arc;

fn main() {
    divan::main();
}

fn midterm() -> Arc<System<f64>> {
    let text = include_str!("../../../scenarios/midterm.toml");
    let scenario = Scenario::from_toml(text).expect("the bundled scenario is sound");
    Arc::new(System::new(&scenario))
}

/// Without recording: the simulation is set back to time zero and run again.
#[divan::bench(sample_size = 1000, sample_count = 200)]
fn without_recording(bencher: Bencher) {
    let mut simulation: Simulation<f64> = Simulation::new(midterm(), Limits::duration(5.0), &mut Nothing);
    bencher.bench_local(|| {
        simulation.reset(&mut Nothing);
        black_box(simulation.run(&mut Nothing)).ok()
    });
}

/// Events and flights kept.
#[divan::bench(sample_size = 1000, sample_count = 200)]
fn with_events_and_flights(bencher: Bencher) {
    let mut simulation: Simulation<f64> = Simulation::new(midterm(), Limits::duration(5.0), &mut Nothing);
    let mut log = Log::new(true, true);
    bencher.bench_local(|| {
        log.events.clear();
        log.flights.clear();
        simulation.reset(&mut log);
        black_box(simulation.run(&mut log)).ok()
    });
}
