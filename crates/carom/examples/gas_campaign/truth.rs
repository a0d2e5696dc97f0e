//! The fluid in equilibrium, against its equation of state and what follows from it.

use crate::verdict::{Bounded, Verdict, progress};
use carom::observe::{Observables, Request, Results, compressibility};
use carom::scenario::Scenario;
use carom::simulate::{Progress, Sampling, simulate_observed};
use core::f64::consts::PI;

const COUNT: usize = 10_000;
const NAMES: [&str; 4] = ["pressure", "collision_rate", "free_path", "speeds"];

/// A packing fraction, and how it is measured.
struct Case {
    packing_fraction: f64,
    /// Collisions of each disc that come before.
    equilibrate: f64,
    /// Collisions of all discs that are measured.
    collisions: f64,
    /// By how much Z may be off, as a part of it.
    bound: f64,
    /// By how much wider all bounds are, as the runs are shorter.
    wider: f64,
}

/// Z within 1e-3 after a hundred collisions of each disc. Of 1e7 collisions the rate still has an error of some 3e-4, so there
/// are 4e7.
pub fn fluid(scale: f64, verdict: &mut Verdict) {
    for packing_fraction in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65] {
        let (collisions, wider) = (4e7 * scale, widening(scale));
        Case { packing_fraction, equilibrate: 100.0, collisions, bound: 1e-3, wider }.run(verdict);
    }
}

/// Z within 2e-3 close to freezing, where two thousand collisions of each disc are left out.
pub fn dense(scale: f64, verdict: &mut Verdict) {
    for packing_fraction in [0.67, 0.68, 0.69] {
        let (collisions, wider) = (3e7 * scale, widening(scale));
        Case { packing_fraction, equilibrate: 2000.0, collisions, bound: 2e-3, wider }.run(verdict);
    }
}

/// A run that is shorter by a factor has errors that are larger by its root.
fn widening(scale: f64) -> f64 {
    (1.0 / scale).sqrt().max(1.0)
}

impl Case {
    fn scenario(&self) -> Scenario {
        let all = self.collisions + 0.5 * COUNT as f64 * self.equilibrate;
        let text = format!(
            "collisions = {all:.0}\n[gas]\nn = {COUNT}\npacking_fraction = {}\nseed = 1",
            self.packing_fraction
        );
        Scenario::from_toml(&text).expect("a gas of the campaign's own")
    }

    fn run(&self, verdict: &mut Verdict) {
        let name = format!("packing {:.2}", self.packing_fraction);
        let scenario = self.scenario();
        let all = scenario.collisions.unwrap_or(0) as f64;
        let observables = Observables::new(&NAMES.map(Request::new)).expect("known names");
        let sampling = Sampling { equilibrate: self.equilibrate, interval: None };
        let mut show = |so_far: &Progress| {
            progress(&name, so_far.collisions as f64 / all);
            false
        };
        match simulate_observed(&scenario, None, observables, &sampling, &mut show) {
            Ok((_, observables)) => self.report(&name, &observables.results(), verdict),
            Err(error) => verdict.failure(&name, &error.to_string()),
        }
    }

    fn report(&self, name: &str, results: &[Results], verdict: &mut Verdict) {
        let find = |place: usize, name: &str| {
            let quantity = results[place].quantity(name).expect("a number of this observable");
            [quantity.value, quantity.error, quantity.expected].map(|number| number.unwrap_or(f64::NAN))
        };
        let theory = compressibility(self.packing_fraction).expect("a fluid");
        // N discs have N (N − 1)/2 pairs, where a large gas has N²/2.
        let pairs = COUNT as f64 / (COUNT as f64 - 1.0);
        let [z, error, _] = find(0, "compressibility_factor");
        let z = 1.0 + (z - 1.0) * pairs;
        let [[rate, ..], [from_pressure, ..]] =
            ["reduced_collision_rate", "reduced_rate_from_pressure"].map(|name| find(1, name));
        let path = (PI / 2.0).sqrt() / (4.0 / PI.sqrt() * (theory - 1.0));
        let [[mean, _, maxwell], [fourth, _, fixed_energy]] =
            ["mean_speed", "fourth_moment_ratio"].map(|name| find(3, name));
        let wide = |bound: f64| bound * self.wider;
        let case = format!("{name}  Z {z:.5} ± {error:.5}, expected {theory:.5}");
        verdict.line(
            &case,
            &[
                Bounded::relative("Z", z, theory, wide(self.bound)),
                Bounded::relative("rate", rate, from_pressure, wide(5e-4)),
                Bounded::relative("path", find(2, "mean_free_path")[0], path, wide(2.0 * self.bound)),
                Bounded::relative("⟨v⟩", mean, maxwell, wide(1e-3)),
                Bounded::relative("⟨v⁴⟩", fourth, fixed_energy, wide(5e-3)),
            ],
        );
    }
}
