//! A cloth that does not rub, and none that pulls: balls are then discs.

use crate::kit::cloth::{ClothRun, RADIUS, at, checked, energy, kinds_of, on_table, sampled_times};
use crate::kit::random::Random;
use crate::kit::scenes::{Ball, random_balls, rectangle, scenario, stadium};
use carom::flight::Motion;
use carom::run::{Kind, OnCloth, Status};
use carom::simulate::{simulate, simulate_until};
use serde_json::{Value, json};

/// The run of a value for a time.
fn run_for(mut value: Value, duration: f64) -> ClothRun {
    value["duration"] = json!(duration);
    simulate_until::<OnCloth>(&checked(&value), None, &mut || false).unwrap()
}

/// Both ways not to rub.
fn slippery() -> [(Value, Value); 2] {
    let smooth = json!({ "sliding_friction": 0.0, "rolling_friction": 0.0, "spin_decay": 0.0 });
    [
        (json!({ "law": "cloth" }), smooth),
        (json!({ "law": "cloth", "gravity": 0.0 }), json!({ "spin_decay": 0.0 })),
    ]
}

/// The same balls on a cloth that does not rub.
fn on_ice(table: &Value, balls: &[Ball], flight: &Value, frictions: &Value) -> Value {
    let entry = |(k, ball): (usize, &Ball)| json!({ "id": k.to_string(), "mass": ball.mass, "position": ball.position, "velocity": ball.velocity });
    let balls: Vec<Value> = balls.iter().enumerate().map(entry).collect();
    let mut value = on_table(table, &json!({ "flight": flight, "cluster": "reflections" }), &balls);
    value["ball_defaults"] = frictions.clone();
    value["ball_defaults"]["radius"] = json!(0.05);
    value
}

#[test]
fn balls_on_a_cloth_that_does_not_rub_are_discs() {
    let mut compared = 0;
    for (name, table) in [("rectangle", rectangle(1.3, 2.1)), ("stadium", stadium(1.5, 0.7))] {
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let balls = random_balls(&mut random, &table, 4, [0.05, 0.05], [0.5, 2.0]);
            let mut discs = scenario(&table, &json!({}), &balls);
            discs.duration = Some(3.0);
            let discs = simulate(&discs).unwrap();
            for (flight, frictions) in slippery() {
                let spheres = run_for(on_ice(&table, &balls, &flight, &frictions), 3.0);
                let mut error = 1e-14;
                for (disc, sphere) in discs.log.events.iter().zip(&spheres.log.events) {
                    // Each meeting of balls makes errors grow by up to (free path)/(radius).
                    error *= if disc.kind == Kind::BallBall { 100.0 } else { 4.0 };
                    if error > 1e-5 {
                        break;
                    }
                    assert_eq!(
                        (disc.kind, disc.ball_a, disc.ball_b),
                        (sphere.kind, sphere.ball_a, sphere.ball_b)
                    );
                    assert!(
                        (disc.time - sphere.time).abs() < error,
                        "{name}, seed {seed}: {disc:?} {sphere:?}"
                    );
                    compared += 1;
                }
                assert!(spheres.diagnostics.energy_drift < 1e-13 * spheres.diagnostics.initial_energy * 10.0);
                assert_eq!(spheres.status, Status::TimeLimit);
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn a_ball_that_does_not_rub_keeps_its_velocity_and_its_spin() {
    for (flight, frictions) in slippery() {
        let mut value = on_table(
            &rectangle(40.0, 40.0),
            &json!({ "flight": flight }),
            &[
                json!({ "id": "a", "position": [10.0, 10.0], "velocity": [1.0, 0.5], "spin": [3.0, -4.0, 5.0] }),
            ],
        );
        value["ball_defaults"] = frictions;
        value["ball_defaults"]["radius"] = json!(RADIUS);
        let run = run_for(value, 10.0);
        assert!(run.log.events.is_empty());
        let state = run.final_state()[0];
        assert_eq!((state.position.to_f64(), state.motion), ([20.0, 15.0, RADIUS], Motion::Sliding));
        assert_eq!(state.twist.velocity.to_f64(), [1.0, 0.5, 0.0]);
        assert_eq!(state.twist.spin.to_f64(), [3.0, -4.0, 5.0]);
    }
}

#[test]
fn one_ball_that_does_not_rub_goes_on_among_others_that_stop() {
    let ball = |id: &str, x: f64| json!({ "id": id, "position": [x, 1.0], "velocity": [0.0, 1.0] });
    let mut value = on_table(&rectangle(40.0, 40.0), &json!({}), &[ball("ice", 10.0), ball("cloth", 20.0)]);
    value["balls"][0]["sliding_friction"] = json!(0.0);
    value["balls"][0]["rolling_friction"] = json!(0.0);
    let run = run_for(value, 30.0);
    assert_eq!(run.final_state()[0].position.y, 31.0);
    assert_eq!(kinds_of(&run, 1), [Kind::SlideToRoll, Kind::RollToRest]);
}

#[test]
fn a_ball_that_rolls_without_friction_of_rolling_rolls_for_ever() {
    let ball = json!({ "id": "a", "position": [10.0, 1.0], "velocity": [0.0, 1.0], "rolling_friction": 0.0 });
    let run = run_for(on_table(&rectangle(40.0, 40.0), &json!({}), &[ball]), 40.0);
    assert_eq!(kinds_of(&run, 0), [Kind::SlideToRoll]);
    assert_eq!(run.final_state()[0].motion, Motion::Rolling);
    assert!((run.final_state()[0].twist.velocity.y - 5.0 / 7.0).abs() < 1e-15);
}

#[test]
fn a_ball_that_spins_in_place_without_decay_spins_for_ever() {
    let ball = json!({ "id": "a", "position": [10.0, 1.0], "spin": [0.0, 0.0, 5.0], "spin_decay": 0.0 });
    let run = run_for(on_table(&rectangle(40.0, 40.0), &json!({}), &[ball]), 40.0);
    assert_eq!((run.status, run.log.events.len()), (Status::TimeLimit, 0));
    let state = run.final_state()[0];
    assert_eq!((state.motion, state.twist.spin.z), (Motion::Spinning, 5.0));
}

#[test]
fn without_gravity_what_rises_rises_for_ever() {
    let ball = json!({ "id": "a", "position": [1.0, 1.0], "velocity": [0.0, 0.25, 0.5] });
    let physics = json!({ "flight": { "law": "cloth", "gravity": 0.0 } });
    let run = run_for(on_table(&rectangle(2.0, 2.0), &physics, &[ball]), 10.0);
    assert_eq!(kinds_of(&run, 0), [Kind::OffTable]);
    assert_eq!(run.log.events[0].time, 4.0);
    assert_eq!(at(&run, 2.0)[0].position.to_f64(), [1.0, 1.5, RADIUS + 1.0]);
}

#[test]
fn elastic_balls_that_do_not_rub_keep_all_their_energy() {
    for (flight, frictions) in slippery() {
        let table = rectangle(1.0, 1.0);
        let balls = random_balls(&mut Random::new(2), &table, 6, [0.05, 0.05], [0.5, 2.0]);
        let run = run_for(on_ice(&table, &balls, &flight, &frictions), 20.0);
        assert!(run.diagnostics.collisions() > 100);
        let start = energy(&run, 0.0);
        for time in sampled_times(&run, 1) {
            // Each collision rounds the energy a few times.
            assert!((energy(&run, time) - start).abs() < 1e-12 * start);
        }
    }
}
