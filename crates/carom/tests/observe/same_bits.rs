//! A small gas has the same bits with a grid and without, watched or not, whatever its sides are.

use crate::gases::gas;
use carom::engine::{Limits, Simulation};
use carom::observe::{Observables, Request, Snapshot};
use carom::run::Digest;
use carom::scenario::System;
use std::sync::Arc;

const TIME: f64 = 60.0;
const SAMPLES: u32 = 20;

/// The digest of fifty discs at a time, and how many events it took.
fn run(periodic: &str, grid_from: usize, names: &[&str]) -> (Option<Digest>, u64) {
    let scenario = gas(1, &format!("n = 50\npacking_fraction = 0.45\nperiodic = {periodic}\nseed = 2"), "");
    let system = Arc::new(System { grid_from, ..System::new(&scenario) });
    let requests: Vec<Request> = names.iter().map(|name| Request::new(name)).collect();
    let mut observables = Observables::new(&requests).unwrap();
    let limits = Limits::duration(2.0 * TIME);
    let mut simulation: Simulation<f64> = Simulation::new(system.clone(), limits, &mut observables);
    for sample in 1..=SAMPLES {
        let time = TIME * f64::from(sample) / f64::from(SAMPLES);
        simulation.run_until(time, &mut observables).unwrap();
        let states = simulation.state();
        let positions: Vec<_> = states.iter().map(|state| state.position).collect();
        let velocities: Vec<_> = states.iter().map(|state| state.velocity).collect();
        let radii: Vec<f64> = system.discs.iter().map(|disc| disc.radius).collect();
        let masses: Vec<f64> = system.discs.iter().map(|disc| disc.mass).collect();
        let size = (system.bounds.max - system.bounds.min).to_f64();
        let (positions, velocities, radii, masses) = (&positions, &velocities, &radii, &masses);
        let periods = system.periodic;
        let snapshot = Snapshot { time, size, periods, positions, velocities, radii, masses };
        observables.sample(&snapshot).unwrap();
    }
    let run = simulation.finish(carom::run::Log::new(false, false));
    (run.digest(), run.diagnostics.total_events())
}

#[test]
fn a_grid_and_observers_change_no_bit_of_a_small_gas() {
    for periodic in ["[]", "['x']", "['y']", "['x', 'y']"] {
        let plain = run(periodic, usize::MAX, &[]);
        assert!(plain.0.is_some() && plain.1 > 5000, "{periodic}: {plain:?}");
        for grid_from in [0, usize::MAX] {
            for names in [&[][..], &["pressure", "free_path", "speeds", "diffusion", "psi6"]] {
                assert_eq!(run(periodic, grid_from, names), plain, "{periodic}, {grid_from}, {names:?}");
            }
        }
    }
}
