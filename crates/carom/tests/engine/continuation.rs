//! A run in pieces is the run at once, to the last bit: resumed from a file, step by step, up to times, after a reset; and
//! a saved run is verified by running it again.

use crate::kit::random::Random;
use crate::kit::scenes::{ball, grid_balls, random_balls, rectangle, scenario, tables};
use crate::kit::{assert_same_events, assert_same_run, bits, bundled, scenario_files};
use carom::engine::Simulation;
use carom::run::{
    Event, Kind, Log, Nothing, PHYSICS_VERSION, Plane, QueryError, Run, Status, from_json, to_json,
};
use carom::scenario::schema::Record;
use carom::scenario::{Scenario, System};
use carom::simulate::{Difference, limits_of, log_of, resume, simulate, simulate_until, verify};
use serde_json::{Value, json};
use std::sync::Arc;

/// Scenes of every kind, with their names: the ready-made ones, random ones on all tables, and crowded ones.
fn scenes() -> Vec<(String, Scenario)> {
    let mut scenes = Vec::new();
    for (name, text) in scenario_files() {
        let mut scenario = Scenario::from_toml(&text).unwrap();
        if scenario.collisions.is_none() {
            scenario.duration = Some(scenario.duration.unwrap_or(20.0).min(20.0));
        }
        scenes.push((name, scenario));
    }
    let physics = [
        json!({}),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.8 },
            "ball_cushion": { "law": "restitution", "normal": 0.9, "tangential": 0.9 } }),
        json!({ "flight": { "law": "field", "acceleration": [-0.3, -0.8] },
            "ball_cushion": { "law": "damping", "factor": 0.7 } }),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.3 }, "collapse": "tc" }),
        json!({ "cluster": "pairwise" }),
        json!({ "cluster": "hertz", "ball_ball": { "law": "restitution", "normal": 0.9 } }),
    ];
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let law = &physics[seed as usize % physics.len()];
        let crowded = seed % 2 == 0;
        let tables = tables();
        let (name, table) = &tables[seed as usize % tables.len()];
        let mut scenario = if crowded {
            scenario(&rectangle(2.0, 2.0), law, &grid_balls(&mut random))
        } else {
            let count = 2 + random.below(10);
            let mut balls = random_balls(&mut random, table, count, [0.01, 0.1], [0.1, 10.0]);
            if random.flips() {
                balls[0].radius = 0.0;
            }
            self::scenario(table, law, &balls)
        };
        (scenario.duration, scenario.max_events) = (Some(4.0), Some(3000));
        let name = if crowded { "crowded" } else { *name };
        scenes.push((format!("seed {seed}, {name}, {law}"), scenario));
    }
    scenes
}

/// The exact scenes.
fn exact_scenes() -> impl Iterator<Item = (String, Scenario)> {
    scenes().into_iter().filter(|(name, _)| !name.contains("stepped"))
}

fn run(scenario: &Scenario) -> Run<f64> {
    simulate(scenario).unwrap_or_else(|error| panic!("{error}"))
}

/// The run written to its file and read again.
fn saved_and_read(scenario: &Scenario, run: &Run<f64>) -> (Scenario, Run<f64>) {
    let (scenario, run) = from_json::<Plane>(&to_json(scenario, run).unwrap()).unwrap();
    (scenario, run)
}

/// A time to cut a run at: some time, an event's own time, or a round number.
fn cut(random: &mut Random, whole: &Run<f64>) -> f64 {
    let events = &whole.log.events;
    match random.below(3) {
        0 => random.between(0.0, whole.end_time.min(100.0)),
        1 if !events.is_empty() => random.choose(events).time,
        _ => (0.5 * random.below(8) as f64).min(whole.end_time),
    }
}

#[test]
fn a_resumed_run_is_the_run_at_once() {
    for (k, (name, scenario)) in scenes().into_iter().enumerate() {
        let mut random = Random::new(k as u64);
        let whole = run(&scenario);
        for _ in 0..6 {
            let at = cut(&mut random, &whole);
            let mut first = scenario.clone();
            first.duration = Some(at);
            let (_, part) = saved_and_read(&first, &run(&first));
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same_run(&joined, &whole, &format!("{name}, cut at {at}"));
        }
    }
}

#[test]
fn a_run_resumed_twenty_times_is_the_run_at_once() {
    for (name, scenario) in exact_scenes() {
        let whole = run(&scenario);
        let end = whole.end_time;
        let mut part = scenario.clone();
        part.duration = Some(0.0);
        let mut so_far = run(&part);
        for k in 1..=20 {
            part.duration = Some(end * f64::from(k) / 20.0);
            (_, so_far) = saved_and_read(&part, &so_far);
            so_far = resume(&part, &so_far, None, &mut || false).unwrap();
        }
        so_far = resume(&scenario, &so_far, None, &mut || false).unwrap();
        assert_same_run(&so_far, &whole, &name);
    }
}

#[test]
fn a_run_resumed_after_any_number_of_events_is_the_run_at_once() {
    for (name, scenario) in exact_scenes() {
        let whole = run(&scenario);
        for collisions in [0, 1, 2, 3, 5, 8, 13, 21] {
            let mut first = scenario.clone();
            first.collisions = Some(collisions);
            if scenario.collisions.is_some_and(|most| most < collisions) {
                continue;
            }
            let (_, part) = saved_and_read(&first, &run(&first));
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same_run(&joined, &whole, &format!("{name}, after {collisions} collisions"));
        }
        for kind in Kind::ALL {
            let part = simulate_until(&scenario, Some(kind), &mut || false).unwrap();
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same_run(&joined, &whole, &format!("{name}, after the first {}", kind.name()));
        }
    }
}

fn started(scenario: &Scenario) -> (Simulation<f64>, Log<f64>) {
    let mut log = log_of(scenario);
    let system = Arc::new(System::new(scenario));
    (Simulation::new(system, limits_of(scenario, None), &mut log), log)
}

#[test]
fn one_event_at_a_time_is_the_run_at_once() {
    for (name, scenario) in exact_scenes() {
        let whole = run(&scenario);
        let (mut simulation, mut log) = started(&scenario);
        while simulation.step(&mut log).unwrap() {
            // To ask what comes next must change nothing.
            let coming = simulation.candidates();
            assert!(coming.iter().all(|next| next.time >= simulation.time()), "{name}: {coming:?}");
        }
        assert_same_run(&simulation.finish(log), &whole, &name);
    }
}

#[test]
fn a_run_up_to_many_times_is_the_run_at_once() {
    for (k, (name, scenario)) in exact_scenes().enumerate() {
        let mut random = Random::new(k as u64);
        let whole = run(&scenario);
        let (mut simulation, mut log) = started(&scenario);
        let mut times: Vec<f64> = (0..20).map(|_| cut(&mut random, &whole)).collect();
        times.sort_by(f64::total_cmp);
        for time in times {
            let seen = log.events.len();
            simulation.run_until(time, &mut log).unwrap();
            assert!(log.events[seen..].iter().all(|event| event.time <= time), "{name}: past {time}");
            let due = |event: &&Event<f64>| event.time <= time;
            assert_eq!(log.events.len(), whole.log.events.iter().filter(due).count(), "{name}: up to {time}");
            if simulation.status().is_none() {
                assert_eq!(simulation.time(), time, "{name}");
                let states = whole.state(time).unwrap();
                assert_eq!(bits(&simulation.state()), bits(&states), "{name}: the state at {time}");
            }
        }
        simulation.run(&mut log).unwrap();
        assert_same_run(&simulation.finish(log), &whole, &name);
    }
}

#[test]
fn a_reset_simulation_starts_anew_with_the_same_bits() {
    for (name, scenario) in exact_scenes() {
        let whole = run(&scenario);
        let (mut simulation, _) = started(&scenario);
        for steps in [0, 1, 10, 100] {
            simulation.advance(steps, &mut Nothing).unwrap();
            let mut log = log_of(&scenario);
            simulation.reset(&mut log);
            let mut again = simulation.clone();
            again.run(&mut log).unwrap();
            let again = again.finish(log);
            assert_same_run(&again, &whole, &format!("{name}, after {steps} steps"));
            assert_eq!(again.diagnostics, whole.diagnostics, "{name}");
        }
    }
}

#[test]
fn what_a_run_keeps_changes_no_bit_of_it() {
    for (name, scenario) in exact_scenes() {
        let whole = run(&scenario);
        for record in [Record::Events, Record::None] {
            let mut other = scenario.clone();
            other.record = Some(record);
            let other = run(&other);
            assert_eq!(other.digest(), whole.digest(), "{name}");
            assert_eq!(other.diagnostics, whole.diagnostics, "{name}");
            if record == Record::Events {
                assert_same_events(&other.log.events, &whole.log.events, &name);
            }
        }
    }
}

fn verified(scenario: &Scenario, run: &Run<f64>) -> Option<Difference> {
    verify(scenario, run, &mut || false).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_saved_run_verifies_however_it_ended() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        let (read, saved) = saved_and_read(&scenario, &whole);
        assert_same_run(&saved, &whole, &name);
        assert_eq!(verified(&read, &saved), None, "{name}");
        for kind in [Kind::BallBall, Kind::BallCushion] {
            let part = simulate_until(&scenario, Some(kind), &mut || false).unwrap();
            assert_eq!(verified(&scenario, &part), None, "{name}, up to the first {}", kind.name());
        }
        let broken_off = simulate_until(&scenario, None, &mut || true).unwrap();
        assert_eq!(verified(&scenario, &broken_off), None, "{name}, broken off");
    }
    for (name, scenario) in exact_scenes() {
        for steps in [0, 1, 7] {
            let (mut simulation, mut log) = started(&scenario);
            simulation.advance(steps, &mut log).unwrap();
            let stopped = simulation.finish(log);
            assert_eq!(verified(&scenario, &stopped), None, "{name}, stopped after {steps} steps");
        }
    }
}

#[test]
fn a_run_stopped_at_one_of_several_events_at_a_time_verifies() {
    // Two pairs meet at the same time, far from each other.
    let balls = [
        ball(0.125, [2.0, 0.5], [0.0, 0.0]),
        ball(0.125, [1.0, 3.5], [-1.0, 0.0]),
        ball(0.125, [2.0, 3.5], [0.0, 0.0]),
        ball(0.125, [1.0, 0.5], [-1.0, 0.0]),
    ];
    let mut scenario = scenario(&rectangle(4.0, 4.0), &json!({}), &balls);
    scenario.duration = Some(4.0);
    let stopped = simulate_until(&scenario, Some(Kind::BallBall), &mut || false).unwrap();
    assert_eq!((stopped.status, stopped.diagnostics.events[0]), (Status::Stopped, 1));
    assert_eq!(verified(&scenario, &stopped), None);
    let whole = run(&scenario);
    assert_eq!(whole.log.events[2].time, whole.log.events[3].time);
    let pairs: Vec<u32> = whole.log.events[2..4].iter().map(|event| event.ball_a).collect();
    assert_eq!(
        pairs,
        [0, 1],
        "events at one time come in the order of the balls, whoever was predicted last"
    );
}

#[test]
fn a_stepped_run_keeps_what_it_is_told_to() {
    let mut scenario = bundled("midterm_stepped");
    let whole = run(&scenario);
    let steps = whole.steps.clone().unwrap();
    assert_eq!(steps.steps.len() as u64, steps.count + 1);
    for record in [Record::Events, Record::None] {
        scenario.record = Some(record);
        let short = run(&scenario);
        assert_eq!(short.steps.as_ref().unwrap().steps, steps.steps[steps.steps.len() - 1..]);
        assert_eq!(short.diagnostics, whole.diagnostics);
        assert_eq!(bits(&short.state(short.end_time).unwrap()), bits(&whole.final_state()));
        assert!(matches!(short.state(0.5 * short.end_time), Err(QueryError::NotKept { .. })));
        let (scenario, read) = saved_and_read(&scenario, &short);
        assert_eq!((&read.steps, &read.log), (&short.steps, &short.log));
        assert_eq!(verified(&scenario, &read), None);
    }
    let (_, read) = saved_and_read(&scenario, &whole);
    assert!(read.state(0.5 * read.end_time).is_ok());
}

#[test]
fn a_saved_run_keeps_the_version_of_the_physics_that_made_it() {
    let scenario = bundled("midterm");
    let text = to_json(&scenario, &run(&scenario)).unwrap();
    let mut older: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(older["physics_version"], PHYSICS_VERSION);
    older["physics_version"] = json!(7);
    let (read, saved) = from_json::<Plane>(&older.to_string()).unwrap();
    assert_eq!(saved.physics_version, 7);
    let again: Value = serde_json::from_str(&to_json(&read, &saved).unwrap()).unwrap();
    assert_eq!(again, older);
    assert_eq!(verified(&read, &saved), None, "the bits are the same, whatever made them");
    let (read, saved) = from_json::<Plane>(&tampered(&older.to_string(), "/events/time/3")).unwrap();
    let difference = verified(&read, &saved).unwrap();
    let said = [difference.place, difference.saved, difference.now];
    assert_eq!(said, ["physics_version", "7", &PHYSICS_VERSION.to_string()]);
}

/// The text of a saved run with the last bit of one number turned.
fn tampered(text: &str, path: &str) -> String {
    let mut value: Value = serde_json::from_str(text).unwrap();
    let number = value.pointer_mut(path).unwrap_or_else(|| panic!("no {path}"));
    let bits = number.as_f64().unwrap().to_bits() ^ 1;
    *number = json!(f64::from_bits(bits));
    value.to_string()
}

#[test]
fn a_single_wrong_bit_is_found_and_named() {
    for name in ["midterm", "newtons_cradle", "tilted", "u_divider"] {
        let scenario = bundled(name);
        let text = to_json(&scenario, &run(&scenario)).unwrap();
        for (path, place) in [
            ("/events/time/3", "events[3].time"),
            ("/events/x/1", "events[1].point"),
            ("/events/normal_y/2", "events[2].normal"),
            ("/events/closing_speed/4", "events[4].closing_speed"),
            ("/events/impulse/0", "events[0].impulse"),
            ("/flights/start/3", "flights[3]"),
            ("/flights/state/2/1", "flights[2]"),
            ("/balls/0/state/0", "balls[0]"),
        ] {
            let (read, saved) = from_json::<Plane>(&tampered(&text, path)).unwrap();
            let difference = verified(&read, &saved).unwrap_or_else(|| panic!("{name}: {path} is not found"));
            assert_eq!(difference.place, place, "{name}: {difference:?}");
            assert_ne!(difference.saved, difference.now, "{name}");
        }
        let mut value: Value = serde_json::from_str(&text).unwrap();
        value["status"] = json!("collapsed");
        let (read, saved) = from_json::<Plane>(&value.to_string()).unwrap();
        assert_eq!(verified(&read, &saved).unwrap().place, "status", "{name}");
    }
    let scenario = bundled("midterm_stepped");
    let text = to_json(&scenario, &run(&scenario)).unwrap();
    let (read, saved) = from_json::<Plane>(&tampered(&text, "/steps/state/17/0/1")).unwrap();
    assert_eq!(verified(&read, &saved).unwrap().place, "steps[17]");
}
