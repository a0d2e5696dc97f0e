//! Every run ends, and says why.

use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, random_balls, rectangle};
use carom::flight::State;
use carom::run::{Event, Kind, Run, Status};
use carom::scenario::Scenario;
use carom::simulate::{simulate, simulate_until};
use serde_json::{Value, json};

/// A scenario with these limits: the fields `duration`, `collisions`, `max_events`.
fn scenario(limits: &Value, table: &Value, physics: &Value, balls: &[Ball]) -> Scenario {
    let entry = |(k, ball): (usize, &Ball)| {
        json!({ "id": k.to_string(), "radius": ball.radius, "mass": ball.mass, "position": ball.position,
            "velocity": ball.velocity })
    };
    let balls: Vec<Value> = balls.iter().enumerate().map(entry).collect();
    let mut text = json!({ "table": table, "physics": physics, "balls": balls });
    for (key, value) in limits.as_object().unwrap() {
        text[key] = value.clone();
    }
    Scenario::from_json(&text.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

fn run(limits: &Value, table: &Value, physics: &Value, balls: &[Ball]) -> Run<f64> {
    simulate(&scenario(limits, table, physics, balls)).unwrap_or_else(|error| panic!("{error}"))
}

/// A field, and cushions that give back `e` of the normal speed.
fn field(acceleration: [f64; 2], e: f64) -> Value {
    json!({ "flight": { "law": "field", "acceleration": acceleration },
        "ball_cushion": { "law": "restitution", "normal": e } })
}

const DOWN: [f64; 2] = [0.0, -1.2];
const TILTED: [f64; 2] = [-0.4, -1.2];

fn table() -> Value {
    rectangle(1.0, 1.5)
}

fn kinds(run: &Run<f64>) -> Vec<Kind> {
    run.log.events.iter().map(|event| event.kind).collect()
}

/// Asserts that the run's one ball rests at a place.
fn assert_rests(run: &Run<f64>, place: [f64; 2], what: &str) {
    assert_eq!(run.status, Status::AtRest, "{what}");
    let State { position: found, velocity } = run.final_state()[0];
    assert_eq!([velocity.x, velocity.y], [0.0, 0.0], "{what}");
    // A hit is found to within the contact tolerance, 2e-10 of the radius.
    let error = (found.x - place[0]).abs() + (found.y - place[1]).abs();
    assert!(error < 1e-9, "{what}: rests at {found:?}, not {place:?}");
}

#[test]
fn a_dropped_ball_bounces_is_held_and_rests() {
    for e in [0.0, 0.2, 0.5, 0.8, 0.95] {
        let run = run(&json!({}), &table(), &field(DOWN, e), &[ball(0.08, [0.4, 1.2], [0.0; 2])]);
        assert_rests(&run, [0.4, 0.08], &format!("e = {e}"));
        let kinds = kinds(&run);
        let (last, bounces) = kinds.split_last().unwrap();
        assert_eq!(*last, Kind::Hold);
        assert!(!bounces.is_empty() && bounces.iter().all(|kind| *kind == Kind::BallCushion), "{kinds:?}");
        // The infinitely many bounces that the hold stands for end at t (1 + e) / (1 − e), t being the fall; the hold
        // leaves out bounces shorter than t_c, all together less than t_c / (1 − e).
        let fall = (2.0 * 1.12 / 1.2f64).sqrt();
        let (end, shortest) = (fall * (1.0 + e) / (1.0 - e), 1e-3 * (0.16 / 1.2f64).sqrt());
        let early = end - run.end_time;
        assert!((-1e-12..shortest / (1.0 - e)).contains(&early), "e = {e}: ends {early} before its time");
    }
}

#[test]
fn on_a_tilted_table_it_slides_into_the_corner_and_rests() {
    for e in [0.0, 0.2, 0.5, 0.8] {
        for velocity in [[0.0, 0.0], [0.7, 0.5], [-1.0, 0.3]] {
            let run = run(&json!({}), &table(), &field(TILTED, e), &[ball(0.08, [0.4, 1.2], velocity)]);
            assert_rests(&run, [0.08, 0.08], &format!("e = {e}, thrown at {velocity:?}"));
            assert!(kinds(&run).iter().filter(|kind| **kind == Kind::Hold).count() >= 2);
        }
    }
}

#[test]
fn a_ball_pressed_into_a_corner_rests_from_the_start() {
    let run = run(&json!({}), &table(), &field(TILTED, 0.5), &[ball(0.08, [0.08, 0.08], [0.0; 2])]);
    assert_rests(&run, [0.08, 0.08], "in the corner");
    assert_eq!(run.end_time, 0.0);
}

#[test]
fn a_ball_may_start_on_a_cushion() {
    let on = |velocity| [ball(0.08, [0.5, 0.08], velocity)];
    let resting = run(&json!({}), &table(), &field(DOWN, 0.5), &on([0.0, 0.0]));
    assert_rests(&resting, [0.5, 0.08], "at rest");
    assert_eq!(resting.end_time, 0.0);

    // It slides to the right cushion, 0.42 away, comes back at half the speed and so on: 0.84 apart, and slower each
    // time.
    let sliding = run(&json!({ "duration": 10.0 }), &table(), &field(DOWN, 0.5), &on([0.6, 0.0]));
    assert_eq!(sliding.status, Status::TimeLimit);
    let hits: Vec<&Event<f64>> =
        sliding.log.events.iter().filter(|event| event.kind == Kind::BallCushion).collect();
    for (hit, expected) in hits.iter().zip([0.7, 0.7 + 0.84 / 0.3, 0.7 + 0.84 / 0.3 + 0.84 / 0.15]) {
        assert!((hit.time - expected).abs() < 1e-12, "{} for {expected}", hit.time);
    }
    assert_eq!(hits.len(), 3);
    assert!((sliding.final_state()[0].position.y - 0.08).abs() < 1e-12);

    let falling = run(&json!({}), &table(), &field(DOWN, 0.5), &on([0.0, -1.0]));
    let first = falling.log.events[0];
    assert_eq!((first.kind, first.time, first.closing_speed), (Kind::BallCushion, 0.0, 1.0));
    assert_rests(&falling, [0.5, 0.08], "thrown onto it");
}

#[test]
fn without_a_duration_even_ever_slower_bounces_end_at_rest() {
    // The speed halves with each crossing, which takes twice as long, until no number holds the time.
    let balls = [ball(0.08, [0.5, 0.08], [0.6, 0.0])];
    let run = run(&json!({}), &table(), &field(DOWN, 0.5), &balls);
    assert_eq!(run.status, Status::AtRest);
    assert!(run.log.events.len() < 3000, "{} events", run.log.events.len());
}

fn gas(limits: &Value) -> Scenario {
    let balls = random_balls(&mut Random::new(3), &table(), 12, [0.03, 0.06], [0.5, 2.0]);
    scenario(limits, &table(), &json!({}), &balls)
}

#[test]
fn a_number_of_collisions_is_kept_exactly() {
    for count in [0, 1, 7, 500] {
        let run = simulate(&gas(&json!({ "collisions": count }))).unwrap();
        assert_eq!(run.status, Status::CollisionLimit);
        // Only a cluster, which is not broken off, could make it more.
        assert_eq!(run.diagnostics.clusters, 0);
        assert_eq!((run.diagnostics.collisions(), run.log.events.len() as u64), (count, count));
        assert_eq!(run.end_time, run.log.events.last().map_or(0.0, |event| event.time));
    }
}

#[test]
fn an_exhausted_event_budget_is_not_reported_as_success() {
    let run = simulate(&gas(&json!({ "duration": 1e9, "max_events": 100 }))).unwrap();
    assert_eq!((run.status, run.diagnostics.total_events()), (Status::EventLimit, 100));
    assert_eq!(run.status.name(), "event_limit");
}

#[test]
fn a_run_can_be_broken_off() {
    let scenario = gas(&json!({ "duration": 1e9, "record": "none" }));
    let run: Run<f64> = simulate_until(&scenario, None, &mut || true).unwrap();
    assert_eq!(run.status, Status::Interrupted);
}

#[test]
fn a_run_ends_at_its_duration() {
    let run = simulate(&gas(&json!({ "duration": 1.25 }))).unwrap();
    assert_eq!((run.status, run.end_time), (Status::TimeLimit, 1.25));
    assert!(run.log.events.iter().all(|event| event.time <= 1.25));
}

#[test]
fn every_status_has_the_documented_word() {
    let words = [
        (Status::TimeLimit, "time_limit"),
        (Status::CollisionLimit, "collision_limit"),
        (Status::Stopped, "stopped"),
        (Status::AtRest, "at_rest"),
        (Status::Collapsed, "collapsed"),
        (Status::EventLimit, "event_limit"),
        (Status::Interrupted, "interrupted"),
    ];
    for (status, word) in words {
        assert_eq!(status.name(), word);
        assert_eq!(serde_json::to_value(status).unwrap(), word);
    }
}
