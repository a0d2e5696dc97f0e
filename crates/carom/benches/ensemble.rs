//! Many runs of one scenario: the course exercise with other velocities and other laws, and a break under noise.
#![allow(clippy::expect_used)]

use carom::ensemble::{Design, Distribution, Ensemble, Inputs, Outcome, Source};
use carom::scenario::Scenario;
use divan::Bencher;

fn main() {
    divan::main();
}

/// Numbers from `low` on, `count` of them, `step` apart.
fn axis(low: f64, step: f64, count: u32) -> Source {
    Source::Axis((0..count).map(|k| low + step * f64::from(k)).collect())
}

const MIDTERM: &str = include_str!("../../../scenarios/midterm.toml");
const BREAK: &str = include_str!("../../../scenarios/nine_ball_break.toml");

/// An ensemble of a bundled scenario.
fn ensemble(text: &str, sources: Vec<(String, Source)>, rows: Option<u64>, outcomes: &[Outcome]) -> Ensemble {
    let scenario = Scenario::from_toml(text).expect("the bundled scenario is sound");
    let inputs = Inputs::new(sources, rows, Design::Independent, 0).expect("sources");
    Ensemble::new(&scenario, inputs, outcomes).expect("an ensemble")
}

/// The speed and the direction of the red ball on a grid.
fn midterms(side: u32) -> Ensemble {
    let speeds = ("balls.red.speed".to_owned(), axis(1.0, 8.0 / f64::from(side), side));
    let directions = ("balls.red.direction_deg".to_owned(), axis(0.0, 90.0 / f64::from(side), side));
    ensemble(MIDTERM, vec![speeds, directions], None, &[Outcome::FinalPosition, Outcome::FinalVelocity])
}

/// How much the cushions give back, by chance.
fn cushions(rows: u64) -> Ensemble {
    let factor = Distribution::Uniform { low: 0.5, high: 1.0 };
    let source = ("physics.ball_cushion.factor".to_owned(), Source::Drawn(factor));
    ensemble(MIDTERM, vec![source], Some(rows), &[Outcome::FinalPosition, Outcome::FinalVelocity])
}

/// The strokes of a player at a tournament who means to strike as the scenario says: see `ExecutionNoise` in Python.
fn breaks(rows: u64) -> Ensemble {
    let radius = 0.028575;
    let around = |key: &str, mean: f64, standard_deviation: f64| {
        (format!("shot.{key}"), Source::Drawn(Distribution::Normal { mean, standard_deviation }))
    };
    let elevation =
        Distribution::TruncatedNormal { mean: 0.0, standard_deviation: 0.1, low: 0.0, high: 90.0 };
    let sources = vec![
        around("V0", 8.0, 0.075),
        around("phi_deg", 96.3, 0.125),
        ("shot.theta_deg".to_owned(), Source::Drawn(elevation)),
        around("a", 0.0, 0.5e-3 / radius),
        around("b", 0.1, 0.5e-3 / radius),
    ];
    ensemble(BREAK, sources, Some(rows), &[Outcome::Pockets])
}

/// Final states out.
#[divan::bench(args = [1, 2], sample_count = 7, sample_size = 1)]
fn a_million_midterms(bencher: Bencher, threads: usize) {
    let ensemble = midterms(1000);
    bencher.bench_local(|| ensemble.run(0..1_000_000, Some(threads), &mut |_| false).expect("threads"));
}

/// The same, but for other laws.
#[divan::bench(args = [1, 2], sample_count = 7, sample_size = 1)]
fn a_hundred_thousand_midterms_with_other_cushions(bencher: Bencher, threads: usize) {
    let ensemble = cushions(100_000);
    bencher.bench_local(|| ensemble.run(0..100_000, Some(threads), &mut |_| false).expect("threads"));
}

/// Which ball falls where.
#[divan::bench(args = [1, 2], sample_count = 7, sample_size = 1)]
fn ten_thousand_breaks(bencher: Bencher, threads: usize) {
    let ensemble = breaks(10_000);
    bencher.bench_local(|| ensemble.run(0..10_000, Some(threads), &mut |_| false).expect("threads"));
}
