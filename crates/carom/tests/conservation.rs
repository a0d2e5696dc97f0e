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

/// A random scene: its name, the simulation when it has made its steps, and what was seen on the way.
fn random_scene(
    seed: u64,
    physics: &Value,
    equal_masses: bool,
    steps: u64,
) -> (String, Watch, Simulation<f64>) {
    let mut random = Random::new(seed);
    let tables = tables();
    let (name, table) = random.choose(&tables);
    let masses = if equal_masses { [1.0, 1.0] } else { [0.1, 10.0] };
    let count = 2 + random.below(49);
    let balls = random_balls(&mut random, table, count, [0.004, 0.08], masses);
    let what = format!("seed {seed}, {} balls, {name}", balls.len());
    let (watch, simulation) = watched(&what, table, physics, &balls, steps);
    (what, watch, simulation)
}

/// Events per scene: with the numbers of scenes below, over a million in all.
const STEPS: u64 = 20_000;

#[test]
fn elastic_balls_of_equal_masses_keep_their_energy_to_1e_12() {
    for seed in 0..24 {
        let (what, watch, simulation) = random_scene(seed, &json!({}), true, STEPS);
        let diagnostics = simulation.diagnostics();
        let own = watch.energy(&simulation.state());
        let drift = (own - diagnostics.initial_energy).abs() / diagnostics.initial_energy;
        assert!(drift < 1e-12, "{what}: {drift:e}");
        assert!(diagnostics.energy_drift < 1e-12 * diagnostics.initial_energy, "{what}: its own account");
        assert!(diagnostics.deepest_overlap >= 0.0 && diagnostics.corrections == 0);
    }
}

#[test]
fn elastic_balls_of_unequal_masses_drift_by_less_than_2e_16_per_event() {
    for seed in 100..124 {
        let (what, watch, simulation) = random_scene(seed, &json!({}), false, STEPS);
        let diagnostics = simulation.diagnostics();
        let own = watch.energy(&simulation.state());
        let drift = (own - diagnostics.initial_energy).abs() / diagnostics.initial_energy;
        let events = diagnostics.total_events() as f64;
        assert!(drift < 2e-16 * events, "{what}: {:e} per event", drift / events);
    }
}

#[test]
fn energy_is_kept_in_a_field() {
    for seed in 200..208 {
        let physics = json!({ "flight": { "law": "field", "acceleration": [0.3, -0.8] } });
        let (what, watch, simulation) = random_scene(seed, &physics, seed % 2 == 0, STEPS / 2);
        let diagnostics = simulation.diagnostics();
        // The flights themselves round here: a few units of the largest energy ever, kinetic or potential, per event.
        let own = watch.energy(&simulation.state());
        let scale = diagnostics.initial_energy.abs() + watch.masses.iter().sum::<f64>();
        let events = diagnostics.total_events() as f64;
        let drift = (own - diagnostics.initial_energy + diagnostics.energy_loss).abs() / scale;
        assert!(drift < 1e-15 * events, "{what}: {:e} per event", drift / events);
    }
}

#[test]
fn lossy_laws_never_give_energy() {
    for seed in 300..312 {
        let physics = json!({
            "ball_ball": { "law": "restitution", "normal": 0.95 },
            "ball_cushion": { "law": "restitution", "normal": 0.9, "tangential": 0.97 },
        });
        let scene = random_scene(seed, &physics, false, 0);
        let (what, watch, mut simulation) = scene;
        let mut before = watch.energy(&simulation.state());
        for _ in 0..STEPS / 4 {
            if !simulation.step(&mut Nothing).unwrap_or_else(|error| panic!("{what}: {error}")) {
                break;
            }
            let energy = watch.energy(&simulation.state());
            // A sum of fifty terms rounds by some units in its last place.
            assert!(energy <= before * (1.0 + 64.0 * f64::EPSILON), "{what}: {before} to {energy}");
            before = energy;
        }
        let diagnostics = simulation.diagnostics();
        assert!(diagnostics.energy_gain <= 64.0 * f64::EPSILON * diagnostics.initial_energy, "{what}");
    }
}
