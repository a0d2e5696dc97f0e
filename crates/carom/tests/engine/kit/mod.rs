//! What the tests of the engine share: a random generator, tables and scenarios, and measurements of their own.

pub mod cloth;
pub mod images;
pub mod random;
pub mod room;
pub mod scenes;
pub mod spheres;
pub mod touching;

use carom::engine::{Limits, Simulation};
use carom::flight::State;
use carom::run::{Event, Log, Run};
use carom::scenario::{Scenario, System};
use std::path::PathBuf;
use std::sync::Arc;

/// The name and text of every file in `scenarios/` that is one of discs, in order.
pub fn scenario_files() -> Vec<(String, String)> {
    let has_cloth = |text: &str| Scenario::from_toml(text).unwrap().expanded().physics.has_cloth();
    all_files().into_iter().filter(|(_, text)| !has_cloth(text)).collect()
}

/// The name of every scenario in `scenarios/` that is one of balls on a cloth, in order.
pub fn cue_sports() -> Vec<(String, Scenario)> {
    let all = all_files().into_iter().map(|(name, text)| (name, Scenario::from_toml(&text).unwrap()));
    all.filter(|(_, scenario)| scenario.expanded().physics.has_cloth()).collect()
}

fn all_files() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenarios");
    let mut files: Vec<PathBuf> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let stem = |path: &PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    files.iter().map(|path| (stem(path), std::fs::read_to_string(path).unwrap())).collect()
}

/// The scenario of that name in `scenarios/`.
pub fn bundled(name: &str) -> Scenario {
    let (_, text) = scenario_files().into_iter().find(|(stem, _)| stem == name).unwrap();
    Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A simulation of a scenario, to be driven by hand.
pub fn start(scenario: &Scenario) -> Simulation<f64> {
    let mut log = Log::new(false, false);
    let limits = carom::simulate::limits_of(scenario, None);
    Simulation::new(Arc::new(System::new(scenario)), limits, &mut log)
}

/// A simulation without an end of its own.
pub fn start_endless(scenario: &Scenario) -> Simulation<f64> {
    let limits = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };
    Simulation::new(Arc::new(System::new(scenario)), limits, &mut Log::new(false, false))
}

/// The bits of a state, so that equal means equal to the last of them (with −0 as +0).
pub fn bits(states: &[State<f64>]) -> Vec<[u64; 4]> {
    let numbers = |State { position: x, velocity: v }: &State<f64>| [x.x, x.y, v.x, v.y];
    states.iter().map(|state| numbers(state).map(|number| (number + 0.0).to_bits())).collect()
}

/// Asserts that two runs have the same events, end and state, bit for bit.
pub fn assert_same_run(a: &Run<f64>, b: &Run<f64>, what: &str) {
    assert_same_events(&a.log.events, &b.log.events, what);
    assert_eq!(a.log.flights.len(), b.log.flights.len(), "{what}: number of flights");
    for (k, (x, y)) in a.log.flights.iter().zip(&b.log.flights).enumerate() {
        assert_eq!(x, y, "{what}: flight {k}");
    }
    assert_eq!((a.status, a.end_time.to_bits()), (b.status, b.end_time.to_bits()), "{what}: end");
    assert_eq!(bits(&a.final_state()), bits(&b.final_state()), "{what}: final state");
    assert_eq!(a.diagnostics.events, b.diagnostics.events, "{what}: counts of events");
}

/// Asserts that two event logs are the same, bit for bit.
pub fn assert_same_events(a: &[Event<f64>], b: &[Event<f64>], what: &str) {
    for (k, (x, y)) in a.iter().zip(b).enumerate() {
        assert_eq!(x, y, "{what}: event {k}");
    }
    assert_eq!(a.len(), b.len(), "{what}: number of events");
}
