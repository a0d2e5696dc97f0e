//! Shots on a cloth: the nine-ball break, and a two-ball shot.

use carom::engine::{Limits, Simulation, Spheres};
use carom::run::{Log, Nothing, OnCloth};
use carom::scenario::{ClothSystem, Scenario};
use divan::{Bencher, black_box};
use std::sync::Arc;

fn main() {
    divan::main();
}

fn system(name: &str) -> Arc<ClothSystem<f64>> {
    let text = if name == "nine_ball_break" { BREAK } else { TWO_BALLS };
    let scenario = Scenario::from_toml(text).expect("the bundled scenario is sound");
    Arc::new(ClothSystem::new(&scenario))
}

const BREAK: &str = include_str!("../../../scenarios/nine_ball_break.toml");
const TWO_BALLS: &str = include_str!("../../../scenarios/two_ball_shot.toml");

const LIMITS: Limits<f64> = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };

/// Without recording: the simulation is set back to time zero and run again.
#[divan::bench(args = ["nine_ball_break", "two_ball_shot"], sample_size = 100, sample_count = 100)]
fn without_recording(bencher: Bencher, name: &str) {
    let mut simulation: Simulation<f64, Spheres<f64>> = Simulation::new(system(name), LIMITS, &mut Nothing);
    bencher.bench_local(|| {
        simulation.reset(&mut Nothing);
        black_box(simulation.run(&mut Nothing)).ok()
    });
}

/// Events and flights kept.
#[divan::bench(args = ["nine_ball_break", "two_ball_shot"], sample_size = 100, sample_count = 100)]
fn with_events_and_flights(bencher: Bencher, name: &str) {
    let mut log: Log<f64, OnCloth> = Log::new(true, true);
    let mut simulation: Simulation<f64, Spheres<f64>> = Simulation::new(system(name), LIMITS, &mut log);
    bencher.bench_local(|| {
        log.events.clear();
        log.flights.clear();
        simulation.reset(&mut log);
        black_box(simulation.run(&mut log)).ok()
    });
}

/// From the text of a scenario to what is ready to run.
#[divan::bench(args = ["nine_ball_break", "two_ball_shot"])]
fn read_and_check(name: &str) -> Arc<ClothSystem<f64>> {
    system(name)
}
