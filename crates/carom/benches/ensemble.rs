//! A million runs of the course exercise, with the speed and the direction of the red ball on a grid.
#![allow(clippy::expect_used)]

use carom::ensemble::{Design, Ensemble, Inputs, Outcome, Source};
use carom::scenario::Scenario;
use divan::Bencher;

fn main() {
    divan::main();
}

/// Numbers from `low` on, `count` of them, `step` apart.
fn axis(low: f64, step: f64, count: u32) -> Source {
    Source::Axis((0..count).map(|k| low + step * f64::from(k)).collect())
}

fn midterms(side: u32) -> Ensemble {
    let text = include_str!("../../../scenarios/midterm.toml");
    let scenario = Scenario::from_toml(text).expect("the bundled scenario is sound");
    let speeds = ("balls.red.speed".to_owned(), axis(1.0, 8.0 / f64::from(side), side));
    let directions = ("balls.red.direction_deg".to_owned(), axis(0.0, 90.0 / f64::from(side), side));
    let inputs = Inputs::new(vec![speeds, directions], None, Design::Independent, 0).expect("a grid");
    Ensemble::new(&scenario, inputs, &[Outcome::FinalPosition, Outcome::FinalVelocity]).expect("an ensemble")
}

/// Final states out.
#[divan::bench(args = [1, 2], sample_count = 7, sample_size = 1)]
fn a_million_midterms(bencher: Bencher, threads: usize) {
    let ensemble = midterms(1000);
    bencher.bench_local(|| ensemble.run(0..1_000_000, Some(threads), &mut |_| false).expect("threads"));
}
