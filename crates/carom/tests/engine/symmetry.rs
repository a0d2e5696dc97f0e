//! A run does not depend on numbers and units: renumbering gives the same bits, powers of two give the same bits scaled,
//! and mirrors, other units and the reversal of time give the same motion up to round-off and its growth.

use crate::kit::images::{assert_renumbering_changes_nothing, distance, mirrored, reflect_state};
use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, grid_balls, polygon, rack, random_balls, rectangle, scenario, tables};
use crate::kit::{bits, bundled, scenario_files};
use carom::flight::State;
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde_json::{Value, json};

#[test]
fn renumbering_balls_and_cushions_changes_no_bit() {
    for seed in 0..120 {
        let mut random = Random::new(seed);
        let tables = tables();
        let (name, table) = random.choose(&tables);
        let count = 2 + random.below(20);
        let balls = random_balls(&mut random, table, count, [0.01, 0.1], [0.1, 10.0]);
        let mut scenario = scenario(table, &json!({}), &balls);
        scenario.duration = Some(3.0);
        assert_renumbering_changes_nothing(&scenario, &mut random, &format!("seed {seed}, {name}"));
    }
}

/// Laws under which contacts at one instant are resolved.
fn cluster_physics(number: u64) -> Value {
    match number % 6 {
        0 => json!({}),
        1 => json!({ "ball_ball": { "law": "restitution", "normal": 0.5 },
            "ball_cushion": { "law": "restitution", "normal": 0.7 } }),
        2 => json!({ "ball_cushion": { "law": "damping", "factor": 0.5 } }),
        3 => json!({ "cluster": "hertz" }),
        4 => json!({ "cluster": "hertz", "ball_ball": { "law": "restitution", "normal": 0.5 },
            "ball_cushion": { "law": "restitution", "normal": 0.7 } }),
        _ => json!({ "cluster": "pairwise" }),
    }
}

#[test]
fn renumbering_changes_no_bit_where_everything_happens_at_once() {
    let mut clusters = 0;
    for seed in 0..800 {
        let mut random = Random::new(seed);
        let balls = grid_balls(&mut random);
        let mut scenario = scenario(&rectangle(2.0, 2.0), &cluster_physics(seed), &balls);
        (scenario.duration, scenario.max_events) = (Some(3.0), Some(3000));
        clusters += assert_renumbering_changes_nothing(&scenario, &mut random, &format!("seed {seed}"));
    }
    assert!(clusters > 300, "{clusters} clusters");
}

#[test]
fn renumbering_changes_no_bit_where_mirror_images_meet() {
    // Two mirror images of irrational numbers hit a third ball on the axis at the very same time, again and again.
    let mut clusters = 0;
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let (width, length) = (random.between(1.0, 2.0), random.between(2.0, 3.0));
        let radius = random.between(0.05, 0.12);
        let mut balls: Vec<Ball> = Vec::new();
        let mut add = |position: [f64; 2], velocity: [f64; 2], mass: f64| {
            let is_free = |b: &Ball| {
                let [x, y] = [0, 1].map(|axis| b.position[axis] - position[axis]);
                (x * x + y * y).sqrt() > 2.0 * radius + 1e-6
            };
            if balls.iter().all(is_free) {
                balls.push(Ball { radius, mass, position, velocity });
            }
        };
        for _ in 0..1 + random.below(3) {
            let (x, y) =
                (random.between(radius + 0.01, width - radius), random.between(radius, length - radius));
            let ([vx, vy], mass) = (random.direction(), random.between(0.5, 2.0));
            add([x, y], [vx, vy], mass);
            add([-x, y], [-vx, vy], mass);
        }
        for _ in 0..1 + random.below(3) {
            let (y, vy) = (random.between(radius, length - radius), random.between(-1.0, 1.0));
            add([0.0, y], [0.0, vy], random.between(0.5, 2.0));
        }
        let table = polygon(&[[-width, 0.0], [width, 0.0], [width, length], [-width, length]]);
        let mut scenario = scenario(&table, &cluster_physics(seed), &balls);
        (scenario.duration, scenario.max_events) = (Some(6.0), Some(3000));
        clusters += assert_renumbering_changes_nothing(&scenario, &mut random, &format!("seed {seed}"));
    }
    assert!(clusters > 150, "{clusters} clusters");
}

#[test]
fn renumbering_changes_no_bit_of_any_scenario_file() {
    for (name, text) in scenario_files() {
        let mut scenario = Scenario::from_toml(&text).unwrap();
        if name.contains("stepped") {
            continue; // the steps' own rule orders candidates of one time by number
        }
        if scenario.gas.is_some() {
            continue; // cushions are renumbered as those of a path, and no path has open sides
        }
        scenario.max_events = Some(2000);
        for seed in 0..4 {
            assert_renumbering_changes_nothing(&scenario, &mut Random::new(seed), &name);
        }
    }
}

#[test]
fn renumbering_changes_no_bit_of_a_break() {
    for (k, e) in [1.0, 0.95, 0.6, 0.3, 0.0].into_iter().enumerate() {
        let mut balls = rack(0.1, [2.0, 2.5], 5);
        balls.push(ball(0.1, [2.013, 0.5], [0.0, 1.0]));
        let physics = json!({ "ball_ball": { "law": "restitution", "normal": e } });
        let mut scenario = scenario(&rectangle(4.0, 5.0), &physics, &balls);
        scenario.duration = Some(6.0);
        let clusters =
            assert_renumbering_changes_nothing(&scenario, &mut Random::new(k as u64), &format!("e = {e}"));
        assert!(clusters > 0);
    }
}

/// A scenario with all lengths, times and masses in other units.
fn in_units(scenario: &Scenario, length: f64, time: f64, mass: f64) -> Scenario {
    let mut value: Value = serde_json::from_str(&scenario.to_json().unwrap()).unwrap();
    scale_lengths(&mut value["table"], length);
    for ball in value["balls"].as_array_mut().unwrap().iter_mut() {
        scale(&mut ball["position"], length);
        scale(&mut ball["radius"], length);
        scale(&mut ball["velocity"], length / time);
        scale(&mut ball["mass"], mass);
    }
    scale(&mut value["physics"]["flight"]["acceleration"], length / time / time);
    scale(&mut value["duration"], time);
    prune(&mut value);
    Scenario::from_json(&value.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

/// Scales every number in a value, other than angles.
fn scale_lengths(value: &mut Value, factor: f64) {
    match value {
        Value::Object(keys) => {
            for (key, value) in keys.iter_mut() {
                if !key.ends_with("_deg") {
                    scale_lengths(value, factor);
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| scale_lengths(item, factor)),
        // Lengths are written as floats, 2.0; a whole number is a count.
        Value::Number(number) if number.is_u64() => {}
        other => scale(other, factor),
    }
}

fn scale(value: &mut Value, factor: f64) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| scale(item, factor)),
        Value::Number(number) => *value = json!(number.as_f64().unwrap() * factor),
        _ => {}
    }
}

/// Takes out what indexing has put in.
fn prune(value: &mut Value) {
    if let Value::Object(keys) = value {
        keys.iter_mut().for_each(|(_, value)| prune(value));
        keys.retain(|_, value| !value.is_null() && value.as_object().is_none_or(|keys| !keys.is_empty()));
    }
}

/// A few scenes for which units are changed, with fields and losses.
fn scenes() -> Vec<(String, Scenario)> {
    let mut scenes = Vec::new();
    for seed in 0..36 {
        let mut random = Random::new(seed);
        let tables = tables();
        let (name, table) = &tables[seed as usize % tables.len()];
        let count = 2 + random.below(12);
        let balls = random_balls(&mut random, table, count, [0.01, 0.1], [0.1, 10.0]);
        let physics = match seed % 3 {
            0 => json!({}),
            1 => json!({ "ball_ball": { "law": "restitution", "normal": 0.9 },
                "ball_cushion": { "law": "restitution", "normal": 0.8, "tangential": 0.9 } }),
            _ => json!({ "flight": { "law": "field", "acceleration": random.direction() },
                "ball_cushion": { "law": "damping", "factor": 0.7 } }),
        };
        let mut scenario = scenario(table, &physics, &balls);
        (scenario.duration, scenario.max_events) = (Some(5.0), Some(2000));
        scenes.push((format!("seed {seed}, {name}"), scenario));
    }
    for name in ["newtons_cradle", "one_into_two", "triangle_break", "tilted"] {
        let mut scenario = bundled(name);
        for ball in &mut scenario.balls {
            ball.radius = ball.radius.or(scenario.ball_defaults.radius);
            ball.mass = ball.mass.or(scenario.ball_defaults.mass).or(Some(1.0));
        }
        scenes.push((name.to_owned(), scenario));
    }
    scenes
}

#[test]
fn units_that_are_powers_of_two_change_no_bit_but_the_exponents() {
    for (what, scenario) in scenes() {
        // Masses by powers of four: a cluster takes roots of them.
        for (length, time, mass) in [(1024.0, 1.0, 1.0), (0.25, 0.5, 16.0), (1.0, 4096.0, 0.25)] {
            let (one, two) =
                (simulate(&scenario).unwrap(), simulate(&in_units(&scenario, length, time, mass)).unwrap());
            assert_eq!(one.status, two.status, "{what}, {length} {time}");
            assert_eq!(one.diagnostics.events, two.diagnostics.events, "{what}, {length} {time}");
            for (a, b) in one.log.events.iter().zip(&two.log.events) {
                assert_eq!(a.time * time, b.time, "{what}, {length} {time}");
                assert_eq!(a.impulse * mass * (length / time), b.impulse, "{what}, {length} {time}");
            }
            let scaled: Vec<State<f64>> = one
                .final_state()
                .into_iter()
                .map(|s| State { position: s.position * length, velocity: s.velocity * (length / time) })
                .collect();
            assert_eq!(bits(&scaled), bits(&two.final_state()), "{what}, {length} {time}");
        }
    }
}

#[test]
fn other_units_and_mirrors_change_a_run_by_round_off_only() {
    for seed in 0..24 {
        let mut random = Random::new(1000 + seed);
        let tables = tables();
        let (name, table) = &tables[seed as usize % tables.len()];
        let balls = random_balls(&mut random, table, 6, [0.01, 0.06], [0.5, 2.0]);
        let mut scenario = scenario(table, &json!({}), &balls);
        scenario.collisions = Some(12);
        let run = simulate(&scenario).unwrap();
        // A round-off of 1e-15 in each of 12 contacts, each of which multiplies what was before by up to 2 (path/radius):
        // a few balls have had more than three contacts with curved things.
        let tolerance = 1e-8;
        let scaled = simulate(&in_units(&scenario, 1000.0, 7.0, 3.0)).unwrap();
        assert_eq!(run.diagnostics.events, scaled.diagnostics.events, "seed {seed}, {name}: {run:?}");
        let apart = distance(&run.final_state(), &scaled.final_state(), 1000.0);
        assert!(apart < tolerance, "seed {seed}, {name}: {apart:e} apart in other units");
        for axis in 0..2 {
            let mirrored = simulate(&mirrored(&scenario, axis)).unwrap();
            assert_eq!(run.diagnostics.events, mirrored.diagnostics.events, "seed {seed}, {name}");
            let back: Vec<State<f64>> =
                mirrored.final_state().into_iter().map(|state| reflect_state(state, axis)).collect();
            let apart = distance(&run.final_state(), &back, 1.0);
            assert!(apart < tolerance, "seed {seed}, {name}: {apart:e} apart in the mirror {axis}");
        }
    }
}

#[test]
fn time_reversal_returns_as_far_as_chaos_allows() {
    // Validation case S10. The return error is about 4e-16 e^{λt}, e^{λt} growing some fifteenfold for each collision of
    // every disc: 4e-13, 4e-10 and 3e-4 after 2, 5 and 10 of them; a factor of 100 is allowed for.
    let cases = [(2, 4e-13), (5, 4e-10), (10, 3e-4)];
    for (collisions_per_disc, expected) in cases {
        let mut errors = Vec::new();
        for seed in 0..9 {
            let mut random = Random::new(seed);
            let table = rectangle(1.0, 2.0);
            let mut balls = random_balls(&mut random, &table, 20, [0.05, 0.05], [1.0, 1.0]);
            assert_eq!(balls.len(), 20);
            for ball in &mut balls {
                ball.velocity = random.direction();
            }
            let mut there = scenario(&table, &json!({}), &balls);
            there.duration = Some(time_of_collisions(&there, collisions_per_disc * 10));
            let run = simulate(&there).unwrap();
            let reversed: Vec<Ball> = run
                .final_state()
                .into_iter()
                .map(|s| ball(0.05, s.position.to_f64(), (-s.velocity).to_f64()))
                .collect();
            let mut back = scenario(&table, &json!({}), &reversed);
            back.duration = there.duration;
            let returned = simulate(&back).unwrap().final_state();
            errors.push(distance(&run.state(0.0).unwrap(), &returned, 1.0));
        }
        errors.sort_by(f64::total_cmp);
        println!("{collisions_per_disc} collisions per disc: {errors:?}");
        assert!(errors[4] < 100.0 * expected, "{collisions_per_disc}: {errors:?}");
        assert!(errors[4] > expected / 100.0, "{collisions_per_disc}: {errors:?}");
    }
}

/// A time after that many collisions of balls, half-way to the next event.
fn time_of_collisions(scenario: &Scenario, collisions: usize) -> f64 {
    let mut long = scenario.clone();
    (long.duration, long.collisions) = (None, Some(20_000));
    let run = simulate(&long).unwrap();
    let hits: Vec<f64> = run.log.events.iter().filter(|e| e.ball_b.is_some()).map(|e| e.time).collect();
    (hits[collisions - 1] + hits[collisions]) / 2.0
}
