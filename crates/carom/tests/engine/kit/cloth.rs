//! Balls on a cloth in whole runs.

use carom::run::{Kind, OnCloth, Run};
use carom::scenario::Scenario;
use carom::simulate::simulate_until;
use serde_json::{Value, json};

/// Radius of the balls, those of pool.
pub const RADIUS: f64 = 0.028_575;

/// A table of 20 × 20 around the origin with a cloth, and these balls of pool.
pub fn scene(balls: &Value) -> Value {
    let corners = [[-10, -10], [10, -10], [10, 10], [-10, 10]];
    let pieces: Vec<_> = (0..4).map(|k| json!({ "line": [corners[k], corners[(k + 1) % 4]] })).collect();
    json!({
        "table": { "shape": "path", "pieces": pieces },
        "physics": { "flight": { "law": "cloth" } },
        "ball_defaults": { "radius": RADIUS, "mass": 0.170_097 },
        "balls": balls,
    })
}

/// A ball of that name and place, with more keys or other ones.
pub fn ball(id: &str, position: [f64; 2], keys: &Value) -> Value {
    let mut ball = json!({ "id": id, "position": position });
    for (key, value) in keys.as_object().unwrap() {
        ball[key] = value.clone();
    }
    ball
}

pub fn checked(value: &Value) -> Scenario {
    Scenario::from_json(&value.to_string()).unwrap_or_else(|error| panic!("{error}\n{value}"))
}

pub fn play(value: &Value) -> Run<f64, OnCloth> {
    run(&checked(value))
}

pub fn run(scenario: &Scenario) -> Run<f64, OnCloth> {
    simulate_until(scenario, None, &mut || false).unwrap_or_else(|error| panic!("{error}"))
}

/// The kinds of all events.
pub fn only(run: &Run<f64, OnCloth>) -> Vec<Kind> {
    run.log.events.iter().map(|event| event.kind).collect()
}

/// Energy of all kinds at a time.
pub fn energy(run: &Run<f64, OnCloth>, time: f64) -> f64 {
    run.energy(time).unwrap() + run.potential_energy(time).unwrap()
}

/// The bits of where all balls end, and how.
pub fn bits(run: &Run<f64, OnCloth>) -> Vec<[u64; 9]> {
    let numbers = |state: &carom::flight::SphereState<f64>| {
        let (x, v, w) = (state.position, state.twist.velocity, state.twist.spin);
        [x.x, x.y, x.z, v.x, v.y, v.z, w.x, w.y, w.z].map(|number| (number + 0.0).to_bits())
    };
    run.final_state().iter().map(numbers).collect()
}

/// Asserts that two balls of these radii are never higher than they lie.
pub fn no_higher(run: &Run<f64, OnCloth>, a: f64, b: f64) {
    for (ball, flight) in &run.log.flights {
        assert_eq!(flight.height, [a, b][*ball as usize]);
    }
}
