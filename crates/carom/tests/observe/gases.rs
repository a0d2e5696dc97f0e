//! Gases from a few lines of a scenario, run and measured.

use carom::observe::{Observables, Request, Results};
use carom::run::Run;
use carom::scenario::Scenario;
use carom::simulate::{Sampling, simulate_observed};

/// So many collisions of a gas of which these are the keys, and then more tables of the scenario.
pub fn gas(collisions: u64, gas: &str, more: &str) -> Scenario {
    let text = format!("collisions = {collisions}\n{more}\n[gas]\n{gas}");
    Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

pub fn run(scenario: &Scenario, requests: &[Request], sampling: &Sampling) -> (Run<f64>, Vec<Results>) {
    let observables = Observables::new(requests).unwrap();
    let (run, observables) =
        simulate_observed(scenario, None, observables, sampling, &mut |_| false).unwrap();
    (run, observables.results())
}

/// A number and its standard error.
pub fn number(results: &Results, name: &str) -> (f64, f64) {
    let quantity = results.quantity(name).unwrap_or_else(|| panic!("no {name}"));
    (quantity.value.unwrap(), quantity.error.unwrap())
}
