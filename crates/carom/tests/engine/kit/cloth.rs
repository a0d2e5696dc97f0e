//! Balls on a cloth in whole runs.

use super::random::Random;
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

/// A shot on a table with pockets: a rack or balls anywhere, with the strike, the laws and the elevation drawn by lot.
pub fn random_shot(seed: u64) -> Value {
    for attempt in 0.. {
        let mut random = Random::new(seed * 1000 + attempt);
        let mut value = json!({ "table": { "preset": "pool_9ft" } });
        if seed.is_multiple_of(3) {
            let spacing = if random.flips() { 0.0 } else { 1e-3 };
            let game = *random.choose(&["eight_ball", "nine_ball"]);
            value["rack"] = json!({ "game": game, "seed": seed, "spacing": spacing });
        } else {
            let place = |random: &mut Random| [random.between(0.05, 1.2), random.between(0.05, 2.4)];
            let mut balls = vec![ball("cue", place(&mut random), &json!({}))];
            for k in 0..1 + random.below(8) {
                balls.push(ball(&k.to_string(), place(&mut random), &json!({})));
            }
            value["balls"] = json!(balls);
        }
        let cluster = *random.choose(&["hertz", "hertz", "reflections", "pairwise"]);
        value["physics"] = json!({ "cluster": cluster });
        let (offset, turn) = (0.5 * random.unit(), random.direction());
        let elevation = if random.flips() { random.between(0.0, 5.0) } else { random.between(5.0, 70.0) };
        value["shot"] = json!({
            "cue_ball": "cue", "V0": random.between(0.5, 8.0), "phi_deg": random.between(0.0, 360.0),
            "theta_deg": elevation, "a": offset * turn[0], "b": offset * turn[1],
        });
        if seed.is_multiple_of(3) {
            value["shot"]["phi_deg"] = json!(90);
        }
        if Scenario::from_json(&value.to_string()).is_ok() {
            return value;
        }
    }
    panic!("some placement has no overlap")
}
