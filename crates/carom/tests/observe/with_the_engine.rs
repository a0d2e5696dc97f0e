//! A gas that the engine computes, between hard walls.

use crate::kit::{assert_within_errors, gaussian};
use carom::geometry::Vec2;
use carom::observe::{Observables, Request, Results, Snapshot};
use carom::random::Random;
use carom::run::{Log, Plane};
use carom::scenario::{Scenario, System};
use carom::simulate::{SimulationOf, start};
use serde_json::json;

const SIDE: f64 = 28.0;
const DISCS: usize = 196;

/// 14 × 14 discs of diameter and mass one on a square lattice, with kT = 1 exactly: η = 0.196.
fn scenario() -> Scenario {
    let mut random = Random::new(51, "gas");
    let mut velocities: Vec<Vec2<f64>> = (0..DISCS).map(|_| gaussian(&mut random)).collect();
    let energy: f64 = velocities.iter().map(|velocity| velocity.norm_squared()).sum();
    velocities.iter_mut().for_each(|velocity| *velocity = *velocity * (2.0 * DISCS as f64 / energy).sqrt());
    let ball = |(k, velocity): (usize, &Vec2<f64>)| {
        let place = [1.0 + 2.0 * (k % 14) as f64, 1.0 + 2.0 * (k / 14) as f64];
        json!({ "id": format!("d{k}"), "radius": 0.5, "mass": 1.0, "position": place,
            "velocity": velocity.to_f64() })
    };
    let balls: Vec<_> = velocities.iter().enumerate().map(ball).collect();
    let table = json!({ "shape": "rectangle", "width": SIDE, "length": SIDE });
    let text =
        json!({ "format": 1, "duration": 1e6, "record": "none", "table": table, "balls": balls }).to_string();
    Scenario::from_json(&text).unwrap()
}

struct Watched {
    simulation: SimulationOf<Plane>,
    observables: Observables,
}

impl Watched {
    fn new(names: &[&str]) -> Self {
        let requests: Vec<Request> = names.iter().map(|name| Request::new(name)).collect();
        let (simulation, _): (_, Log<f64, Plane>) = start(&scenario(), None);
        Self { simulation, observables: Observables::new(&requests).unwrap() }
    }

    fn sample(&mut self, time: f64) {
        self.simulation.run_until(time, &mut self.observables).unwrap();
        let states = self.simulation.state();
        let positions: Vec<Vec2<f64>> = states.iter().map(|state| state.position).collect();
        let velocities: Vec<Vec2<f64>> = states.iter().map(|state| state.velocity).collect();
        let system: &System<f64> = self.simulation.system();
        let radii: Vec<f64> = system.discs.iter().map(|disc| disc.radius).collect();
        let masses: Vec<f64> = system.discs.iter().map(|disc| disc.mass).collect();
        let snapshot = Snapshot {
            time,
            size: [SIDE; 2],
            periods: [false; 2],
            positions: &positions,
            velocities: &velocities,
            radii: &radii,
            masses: &masses,
        };
        self.observables.sample(&snapshot).unwrap();
    }

    /// Samples after the lattice is forgotten.
    fn run(&mut self, samples: u32) -> Vec<Results> {
        for sample in 0..samples {
            self.sample(20.0 + 2.0 * f64::from(sample));
        }
        self.observables.results()
    }
}

#[test]
fn pressures_rates_and_contacts_of_a_gas_agree() {
    let mut watched =
        Watched::new(&["pressure", "collision_rate", "free_path", "radial_distribution", "speeds"]);
    let results = watched.run(1000);
    let find = |place: usize, name: &str| {
        let results: &Results = &results[place];
        results.quantity(name).unwrap().clone()
    };
    let z = find(0, "compressibility_factor").value.unwrap();

    // The virial theorem ties both pressures: Z of the walls is Z (1 + ...) L/(L − 2r), but for the ends of the run.
    assert_within_errors(&find(0, "wall_compressibility_factor"), z * SIDE / (SIDE - 1.0), 0.01);
    assert!((find(0, "temperature").value.unwrap() - 1.0).abs() < 1e-9);

    // Walls take a radius from each side: the gas is as dense as 196 discs on 27 × 27 and thinner at walls, which is an
    // effect of a few per cent.
    let expected = find(0, "compressibility_factor").expected.unwrap();
    assert!((z / expected - 1.0).abs() < 0.05, "{z} {expected}");

    // Collisions counted against momentum exchanged: 1 % for an error of Z of some 0.2 %.
    let (counted, by_pressure) = (find(1, "reduced_collision_rate"), find(1, "reduced_rate_from_pressure"));
    assert!((counted.value.unwrap() / by_pressure.value.unwrap() - 1.0).abs() < 0.015);
    assert!(counted.error.unwrap() < 0.01 && by_pressure.error.unwrap() < 0.01);

    // The path between collisions is the mean speed over the rate.
    let (path, time) = (find(2, "mean_free_path"), find(2, "mean_free_time"));
    let speed = find(4, "mean_speed");
    assert!((path.value.unwrap() / (time.value.unwrap() * speed.value.unwrap()) - 1.0).abs() < 1e-3);

    // g at contact and the rate of collisions are one thing too, where the gas is away from walls.
    let contact = find(3, "contact_value");
    assert!((contact.value.unwrap() / contact.expected.unwrap() - 1.0).abs() < 0.1, "{contact:?}");
    assert_within_errors(&find(4, "fourth_moment_ratio"), 2.0 * 196.0 / 197.0, 0.01);
}

#[test]
fn watching_changes_no_bit_of_a_run() {
    let mut watched = Watched::new(&["pressure", "free_path", "psi6"]);
    watched.run(10);
    let (mut alone, mut log): (SimulationOf<Plane>, Log<f64, Plane>) = start(&scenario(), None);
    alone.run_until(38.0, &mut log).unwrap();
    assert_eq!(alone.state(), watched.simulation.state());
}
