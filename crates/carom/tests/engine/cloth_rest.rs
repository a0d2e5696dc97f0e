//! Balls that are pressed onto each other or onto cushions come to rest after a number of events that has a bound.

use crate::kit::cloth::{RADIUS, ball, run};
use crate::kit::random::Random;
use carom::run::{OnCloth, Run};
use serde_json::{Value, json};

/// More events than that no scene of a few balls has.
const BOUND: u64 = 3000;

/// A rectangle of a cloth 1 × 2 with these balls, noses and laws.
fn boxed(balls: &[Value], nose_height: f64, cushion: &Value, ball_ball: &Value) -> Value {
    json!({
        "table": { "shape": "rectangle", "width": 1, "length": 2, "nose_height": nose_height },
        "physics": { "flight": { "law": "cloth" }, "ball_cushion": cushion, "ball_ball": ball_ball },
        "ball_defaults": { "radius": RADIUS, "mass": 0.170_097 },
        "balls": balls,
    })
}

fn cushions() -> [Value; 6] {
    [
        json!({ "law": "elastic" }),
        json!({ "law": "restitution", "normal": 0.85, "tangential": 0.9 }),
        json!({ "law": "frictional", "normal": 0.0, "friction": 0.2 }),
        json!({ "law": "han_2005", "normal": 0.85, "friction": 0.2 }),
        json!({ "law": "mathavan_2010", "normal": 0.9, "friction": 0.14 }),
        json!({ "law": "stronge_compliant", "normal": 0.85, "friction": 0.2 }),
    ]
}

fn meetings() -> [Value; 4] {
    [
        json!({ "law": "elastic" }),
        json!({ "law": "restitution", "normal": 0.0 }),
        json!({ "law": "frictional", "normal": 0.95 }),
        json!({ "law": "mathavan_2014", "normal": 0.89, "friction": 0.05 }),
    ]
}

/// Plays a scene under every law; all end at rest, soon, without overlap and without a gain of energy.
fn rests(what: &str, balls: &[Value]) {
    for nose in [RADIUS, 1.27 * RADIUS] {
        for cushion in cushions() {
            for meeting in meetings() {
                let run = run(&boxed(balls, nose, &cushion, &meeting));
                is_sound(&format!("{what}, nose {nose}, {cushion}, {meeting}"), &run);
            }
        }
    }
}

fn is_sound(what: &str, run: &Run<f64, OnCloth>) {
    let found = &run.diagnostics;
    assert_eq!(run.status.name(), "at_rest", "{what}");
    assert!(found.total_events() <= BOUND, "{what}: {} events", found.total_events());
    assert!(found.deepest_overlap <= 1e-9 * RADIUS, "{what}: overlap {:e}", found.deepest_overlap);
    assert!(found.energy_gain <= 1e-12 * found.initial_energy, "{what}: gain {:e}", found.energy_gain);
    assert!(found.energy_drift <= 1e-9 * found.initial_energy, "{what}: drift {:e}", found.energy_drift);
}

/// The distance of a ball that touches a cushion, for noses at the height of its centre; higher ones are nearer.
fn reach(nose: f64) -> f64 {
    RADIUS * (1.0 - (nose / RADIUS - 1.0).powi(2)).sqrt()
}

#[test]
fn a_ball_in_touch_with_one_that_brakes_harder() {
    let roll = |id: &str, x: f64, friction: f64| {
        let keys =
            json!({ "velocity": [0, 0.8], "spin": [-0.8 / RADIUS, 0, 0], "rolling_friction": friction });
        ball(id, [0.5, x], &keys)
    };
    rests("rolling", &[roll("a", 0.3, 0.01), roll("b", 0.3 + 2.0 * RADIUS, 0.05)]);
    let slides = ball("b", [0.5, 0.3 + 2.0 * RADIUS], &json!({ "velocity": [0, 0.8] }));
    rests("rolling onto a sliding one", &[roll("a", 0.3, 0.01), slides]);
    let row = (0..4).map(|k| {
        let friction = 0.01 * f64::from(k + 1);
        roll(&k.to_string(), 0.3 + 2.0 * RADIUS * f64::from(k), friction)
    });
    let row: Vec<Value> = row.collect();
    rests("four in a row", &row);
}

#[test]
fn a_ball_frozen_to_a_cushion_that_slides_into_it() {
    for nose in [RADIUS, 1.27 * RADIUS] {
        for (velocity, spin) in [
            ([0.0, 0.7], [0.0, -30.0, 0.0]),
            ([0.0, 0.0], [0.0, -60.0, 5.0]),
            ([0.0, 1.5], [-1.5 / RADIUS, 0.0, 20.0]),
            ([0.0, -0.4], [10.0, -80.0, -40.0]),
        ] {
            let at = ball("a", [reach(nose), 0.9], &json!({ "velocity": velocity, "spin": spin }));
            for cushion in cushions() {
                let run =
                    run(&boxed(std::slice::from_ref(&at), nose, &cushion, &json!({ "law": "elastic" })));
                is_sound(&format!("{velocity:?} {spin:?} {nose} {cushion}"), &run);
            }
        }
    }
}

#[test]
fn follow_pressed_onto_a_ball_frozen_to_a_cushion() {
    for nose in [RADIUS, 1.27 * RADIUS] {
        let edge = reach(nose);
        for (away, velocity, spin) in [
            (0.0, [0.0, 0.0], [0.0, -100.0, 0.0]),
            (0.0, [-1.0, 0.0], [0.0, -100.0, 0.0]),
            (0.3, [-2.0, 0.0], [0.0, -150.0, 0.0]),
            (0.3, [-2.0, 0.0], [0.0, -150.0, 30.0]),
        ] {
            let balls = [
                ball("a", [edge + 2.0 * RADIUS + away, 1.0], &json!({ "velocity": velocity, "spin": spin })),
                ball("b", [edge, 1.0], &json!({})),
            ];
            for cushion in cushions() {
                for meeting in meetings() {
                    let run = run(&boxed(&balls, nose, &cushion, &meeting));
                    is_sound(&format!("{away} {velocity:?} {spin:?} {nose} {cushion} {meeting}"), &run);
                }
            }
        }
    }
}

#[test]
fn balls_pressed_into_a_corner() {
    for nose in [RADIUS, 1.27 * RADIUS] {
        let edge = reach(nose);
        let mut random = Random::new(5);
        for _ in 0..20 {
            let spin = [random.between(0.0, 100.0), random.between(-100.0, 0.0), random.between(-50.0, 50.0)];
            let tilt = random.between(0.0, 90.0_f64).to_radians();
            let reached = 2.0 * RADIUS * (1.0 + 1e-15);
            let second = [edge + reached * tilt.cos(), edge + reached * tilt.sin()];
            let balls = [
                ball("a", [edge, edge], &json!({ "spin": spin })),
                ball("b", second, &json!({ "velocity": [-tilt.cos(), -tilt.sin()], "spin": spin })),
            ];
            for cushion in cushions() {
                for meeting in meetings() {
                    let run = run(&boxed(&balls, nose, &cushion, &meeting));
                    is_sound(&format!("{spin:?} {tilt} {nose} {cushion} {meeting}"), &run);
                }
            }
        }
    }
}
