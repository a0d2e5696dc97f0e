//! Over a million events on tables of every kind: nothing overlaps, nobody leaves, energy and momentum are kept, and
//! what a run says about itself is what the tests find by their own means.
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::panic)]

mod kit;

use carom::engine::Simulation;
use carom::geometry::Vec2;
use carom::run::Nothing;
use kit::random::Random;
use kit::room::Room;
use kit::scenes::{Ball, random_balls, scenario, tables};
use kit::{State, start_endless};
use serde_json::{Value, json};

/// What is measured at the event times of a run, from the states alone.
struct Watch {
    room: Room,
    radii: Vec<f64>,
    masses: Vec<f64>,
    field: [f64; 2],
    /// Deepest overlap of two balls, in units of 1e-9 of the smaller radius + 1e-13 of the table.
    overlap: f64,
    /// Deepest reach past a cushion, in the same unit.
    outside: f64,
    /// Deepest overlap of two balls as a length.
    deepest: f64,
}

impl Watch {
    fn new(room: Room, balls: &[Ball], field: [f64; 2]) -> Self {
        let radii = balls.iter().map(|ball| ball.radius).collect();
        let masses = balls.iter().map(|ball| ball.mass).collect();
        Self { room, radii, masses, field, overlap: 0.0, outside: f64::NEG_INFINITY, deepest: 0.0 }
    }

    fn look(&mut self, states: &[State]) {
        let table = 1e-13 * self.room.size();
        for (a, (here, _)) in states.iter().enumerate() {
            for (b, (there, _)) in states.iter().enumerate().skip(a + 1) {
                let radii = self.radii[a] + self.radii[b];
                let apart = Vec2::new(there.x - here.x, there.y - here.y);
                let squared = apart.x * apart.x + apart.y * apart.y;
                if squared < radii * radii && radii > 0.0 {
                    let depth = radii - squared.sqrt();
                    let smaller = self.radii[a].min(self.radii[b]);
                    self.deepest = self.deepest.max(depth);
                    self.overlap = self.overlap.max(depth / (1e-9 * smaller + table));
                }
            }
        }
    }

    /// The same for the balls' places on the table, which takes longer.
    fn look_round(&mut self, states: &[State]) {
        let table = 1e-13 * self.room.size();
        for ((place, _), radius) in states.iter().zip(&self.radii) {
            let depth = self.room.depth([place.x, place.y], *radius);
            self.outside = self.outside.max(depth / (1e-9 * radius + table));
        }
    }

    fn energy(&self, states: &[State]) -> f64 {
        let energy = |((place, velocity), mass): (&State, &f64)| {
            let kinetic = 0.5 * (velocity.x * velocity.x + velocity.y * velocity.y);
            mass * (kinetic - self.field[0] * place.x - self.field[1] * place.y)
        };
        states.iter().zip(&self.masses).map(energy).sum()
    }

    fn check(&self, what: &str) {
        assert!(self.overlap <= 1.0, "{what}: overlap {} of what is allowed", self.overlap);
        assert!(self.outside <= 1.0, "{what}: a ball reaches out by {} of what is allowed", self.outside);
    }
}

/// A run watched for a number of steps.
fn watched(
    what: &str,
    table: &Value,
    physics: &Value,
    balls: &[Ball],
    steps: u64,
) -> (Watch, Simulation<f64>) {
    let scenario = scenario(table, physics, balls);
    let field = &physics["flight"]["acceleration"];
    let field = [0, 1].map(|axis| field[axis].as_f64().unwrap_or(0.0));
    let mut watch = Watch::new(Room::of(&scenario), balls, field);
    let mut simulation = start_endless(&scenario);
    for step in 0..steps {
        let goes_on = simulation.step(&mut Nothing).unwrap_or_else(|error| panic!("{what}: {error}"));
        if !goes_on {
            break;
        }
        let states = simulation.state();
        watch.look(&states);
        if step % 8 == 0 {
            watch.look_round(&states);
        }
    }
    watch.check(what);
    (watch, simulation)
}

#[test]
fn explore() {
    let steps: u64 = std::env::var("STEPS").map_or(2000, |s| s.parse().unwrap());
    let first: u64 = std::env::var("SEED").map_or(0, |s| s.parse().unwrap());
    let seeds: u64 = std::env::var("SEEDS").map_or(60, |s| s.parse().unwrap());
    let mut total = 0;
    for seed in first..first + seeds {
        let mut random = Random::new(seed);
        let tables = tables();
        let (name, table) = random.choose(&tables);
        let count = 2 + random.below(49);
        let equal = random.flips();
        let masses = if equal { [1.0, 1.0] } else { [0.1, 10.0] };
        let radii = [0.004, 0.08];
        let balls = random_balls(&mut random, table, count, radii, masses);
        let field = if random.below(4) == 0 { Some(random.direction()) } else { None };
        let physics = match field {
            Some(acceleration) => json!({ "flight": { "law": "field", "acceleration": acceleration } }),
            None => json!({}),
        };
        let what = format!("seed {seed}, {} balls, {name}, field {field:?}, equal {equal}", balls.len());
        let (watch, simulation) = watched(&what, table, &physics, &balls, steps);
        let d = simulation.diagnostics();
        let energy = watch.energy(&simulation.state());
        println!(
            "{what}: events {:?} clusters {} overlap {:.2e} outside {:.2e} drift {:.2e} per event {:.2e} status {:?}, own energy {:.2e}",
            d.events,
            d.clusters,
            watch.overlap,
            watch.outside,
            d.energy_drift / d.initial_energy.abs(),
            d.energy_drift / d.initial_energy.abs() / d.total_events() as f64,
            simulation.status(),
            (energy - d.initial_energy).abs() / d.initial_energy.abs()
        );
        total += d.total_events();
    }
    println!("total {total}");
}
