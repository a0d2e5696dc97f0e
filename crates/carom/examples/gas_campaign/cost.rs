//! What measuring costs: the same gas with and without, in turns.

use crate::verdict::{Bounded, Verdict, progress};
use carom::observe::{Observables, Request};
use carom::scenario::Scenario;
use carom::simulate::{Sampling, simulate, simulate_observed};
use std::time::Instant;

/// Turns, of which the median counts.
const TURNS: usize = 9;
/// By how much slower a measured run may be.
const MOST: f64 = 0.15;

const NAMES: [&str; 3] = ["pressure", "speeds", "radial_distribution"];

/// Pressure, speeds and g(r) up to five diameters, together and at one density alone, every ten collisions of each disc.
pub fn cost(scale: f64, verdict: &mut Verdict) {
    for packing_fraction in [0.2, 0.5, 0.7] {
        let text = format!(
            "collisions = {:.0}\n[gas]\nn = 10000\npacking_fraction = {packing_fraction}\nstart = 'hexagonal'",
            2e6 * scale
        );
        let scenario = Scenario::from_toml(&text).expect("a gas of the campaign's own");
        measure(packing_fraction, &scenario, &NAMES, verdict);
        if packing_fraction == 0.5 {
            NAMES.iter().for_each(|name| measure(packing_fraction, &scenario, &[name], verdict));
        }
    }
}

fn measure(packing_fraction: f64, scenario: &Scenario, names: &[&str], verdict: &mut Verdict) {
    let case = format!("packing {packing_fraction}  {}", names.join(", "));
    let mut turns: Vec<[f64; 2]> = Vec::new();
    for turn in 0..TURNS {
        progress(&case, turn as f64 / TURNS as f64);
        // Whoever goes first in one turn goes second in the next.
        let mut times = [0.0; 2];
        for k in 0..2 {
            let is_measured = (k + turn) % 2 == 1;
            let begin = Instant::now();
            if is_measured {
                measured(scenario, names)
            } else {
                plain(scenario)
            }
            times[usize::from(is_measured)] = begin.elapsed().as_secs_f64();
        }
        turns.push(times);
    }
    let slower = median(turns.iter().map(|[plain, measured]| measured / plain - 1.0));
    let rate = scenario.collisions.unwrap_or(0) as f64 / 1e6 / median(turns.iter().map(|times| times[0]));
    let number = Bounded { name: "slower", value: slower, bound: MOST };
    verdict.line(&format!("{case}  {rate:.2} million/s without"), &[number]);
}

fn plain(scenario: &Scenario) {
    simulate(scenario).expect("a run");
}

fn measured(scenario: &Scenario, names: &[&str]) {
    let requests: Vec<Request> = names.iter().map(|name| Request::new(name)).collect();
    let observables = Observables::new(&requests).expect("known names");
    simulate_observed(scenario, None, observables, &Sampling::default(), &mut |_| false).expect("a run");
}

fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}
