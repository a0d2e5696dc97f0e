//! Balls in the air: over cushions and pockets, and at the noses of cushions, against plain bisection.

use crate::kit::cloth::{RADIUS, ball, run};
use crate::kit::random::Random;
use carom::run::{Kind, OnCloth, Run};
use serde_json::{Value, json};

const GRAVITY: f64 = 9.81;
const NOSE: f64 = 0.0365;

fn launched(table: &Value, position: [f64; 2], velocity: [f64; 3]) -> Run<f64, OnCloth> {
    run(&json!({
        "table": table,
        "physics": { "flight": { "law": "cloth" } },
        "ball_defaults": { "radius": RADIUS, "mass": 0.170_097 },
        "balls": [ball("a", position, &json!({ "velocity": velocity }))],
    }))
}

/// The first time at which a function is zero or less, by small steps and bisection.
fn first_zero(value: impl Fn(f64) -> f64, end: f64) -> Option<f64> {
    let steps = 20_000;
    let at = |k: i32| end * f64::from(k) / f64::from(steps);
    let step = (1..=steps).find(|&k| value(at(k)) <= 0.0)?;
    let (mut low, mut high) = (at(step - 1), at(step));
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if value(middle) > 0.0 { low = middle } else { high = middle }
    }
    Some(high)
}

fn height(rise: f64, time: f64) -> f64 {
    RADIUS + rise * time - 0.5 * GRAVITY * time * time
}

#[test]
fn a_ball_in_the_air_meets_a_nose_flies_over_it_or_lands_before() {
    let table = json!({ "shape": "rectangle", "width": 1, "length": 1, "nose_height": NOSE });
    let mut random = Random::new(1);
    let mut seen = std::collections::BTreeMap::new();
    for _ in 0..500 {
        let (speed, rise) = (random.between(0.5, 6.0), random.between(0.4, 3.0));
        let start = random.between(0.3, 0.9);
        let run = launched(&table, [start, 0.5], [speed, 0.0, rise]);
        let (landing, over) = (2.0 * rise / GRAVITY, (1.0 - start) / speed);
        let gap = |t: f64| (1.0 - start - speed * t).hypot(height(rise, t) - NOSE) - RADIUS;
        let expected = match first_zero(gap, landing.min(over)) {
            Some(time) => (Kind::BallCushion, time),
            None if over < landing => (Kind::OffTable, over),
            None => (Kind::BallCloth, landing),
        };
        let event = &run.log.events[0];
        assert_eq!(event.kind, expected.0, "{start} {speed} {rise}");
        // A graze within 1e-4 of a radius has a time known to a square root of roundings.
        assert!((event.time - expected.1).abs() < 1e-8, "{start} {speed} {rise}: {event:?}, {expected:?}");
        *seen.entry(event.kind.name()).or_insert(0) += 1;
    }
    assert!(seen.len() == 3 && seen.values().all(|count| *count > 20), "{seen:?}");
}

#[test]
fn a_ball_in_the_air_meets_a_round_nose_where_bisection_has_it() {
    let (center, radius) = ([0.5, 0.5], 0.1);
    let post = json!({ "id": "post", "circle": { "center": center, "radius": radius } });
    let table = json!({
        "shape": "rectangle", "width": 1, "length": 1, "nose_height": NOSE, "obstacles": [post] });
    let mut random = Random::new(2);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..300 {
        let (speed, rise) = (random.between(0.5, 4.0), random.between(0.4, 2.0));
        let offset = random.between(-0.15, 0.15);
        let start = [0.2, 0.5 + offset];
        let run = launched(&table, start, [speed, 0.0, rise]);
        let landing = 2.0 * rise / GRAVITY;
        let gap = |t: f64| {
            let distance = (start[0] + speed * t - center[0]).hypot(offset) - radius;
            distance.hypot(height(rise, t) - NOSE) - RADIUS
        };
        let inside = |t: f64| (start[0] + speed * t - center[0]).hypot(offset) - radius;
        let over = first_zero(inside, landing);
        let event = &run.log.events[0];
        match first_zero(gap, over.unwrap_or(landing)) {
            Some(time) => {
                hits += 1;
                assert_eq!(event.kind, Kind::BallCushion, "{speed} {rise} {offset}");
                assert!((event.time - time).abs() < 1e-8, "{speed} {rise} {offset}: {event:?}, {time}");
            }
            None => {
                misses += 1;
                let expected = over.unwrap_or(landing);
                // A ball that misses the post may meet the far cushion before it lands.
                let far = (1.0 - RADIUS - start[0]) / speed;
                let kind = if over.is_some() { Kind::OffTable } else { Kind::BallCloth };
                assert!(
                    event.kind == kind && (event.time - expected).abs() < 1e-9 || landing > far,
                    "{event:?}"
                );
            }
        }
    }
    assert!(hits > 50 && misses > 50, "{hits} {misses}");
}

#[test]
fn a_ball_that_flies_over_a_pocket_drops_if_it_is_low_at_its_back() {
    let (center, hole) = (0.5, 0.06);
    let table = json!({ "shape": "rectangle", "width": 2, "length": 1,
        "pockets": [{ "id": "p", "center": [center, 0.5], "radius": hole }] });
    let mut random = Random::new(3);
    let mut counts = [0; 4];
    for _ in 0..400 {
        let (speed, rise) = (random.between(0.5, 3.0), random.between(0.35, 1.0));
        let start = random.between(0.1, 0.4);
        let run = launched(&table, [start, 0.5], [speed, 0.0, rise]);
        let landing = 2.0 * rise / GRAVITY;
        let (front, back) = ((center - hole - start) / speed, (center + hole - start) / speed);
        let (case, kind, time) = if landing < front {
            (0, Kind::BallCloth, landing)
        } else if landing < back {
            (1, Kind::BallPocket, landing)
        } else if height(rise, back) <= 1.4 * RADIUS {
            (2, Kind::BallPocket, back)
        } else {
            (3, Kind::BallCloth, landing)
        };
        let event = &run.log.events[0];
        assert_eq!(event.kind, kind, "{start} {speed} {rise}: case {case}");
        assert!((event.time - time).abs() < 1e-14, "{event:?}, {time}");
        counts[case] += 1;
    }
    assert!(counts.iter().all(|count| *count > 3), "{counts:?}");
}
