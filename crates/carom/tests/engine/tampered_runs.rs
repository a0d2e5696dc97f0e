//! Whatever is taken from a saved run or changed in it is found: when it is read, or else when it is run again.
use crate::kit::random::Random;
use crate::kit::scenes::{random_balls, scenario, tables};
use carom::run::{Plane, Run, Status, from_json, to_json};
use carom::scenario::Scenario;
use carom::simulate::{prolonged, resume, simulate, verify};
use serde_json::{Value, json};

/// The saved run of a ready-made scenario.
fn saved(name: &str) -> Value {
    let scenario = crate::kit::bundled(name);
    serde_json::from_str(&to_json(&scenario, &simulate(&scenario).unwrap()).unwrap()).unwrap()
}

/// The place of the first difference that a run made again has.
fn difference(file: &Value) -> Option<String> {
    let (scenario, run) = from_json::<Plane>(&file.to_string()).unwrap_or_else(|error| panic!("{error}"));
    verify(&scenario, &run, &mut || false).unwrap().map(|found| found.place)
}

/// Why a file is refused, with a value at a path changed.
fn complaint(name: &str, path: &str, value: Value) -> String {
    let mut file = saved(name);
    *file.pointer_mut(path).unwrap_or_else(|| panic!("no {path}")) = value;
    let error = from_json::<Plane>(&file.to_string()).map(|_| ()).expect_err(path).to_string();
    error.strip_prefix("not a saved run: ").unwrap_or_else(|| panic!("{error}")).to_owned()
}

fn shorten(columns: &mut Value, by: usize) {
    for column in columns.as_object_mut().unwrap().values_mut() {
        let rows = column.as_array_mut().unwrap();
        rows.truncate(rows.len().saturating_sub(by));
    }
}

#[test]
fn rows_that_are_missing_are_found() {
    for name in ["midterm", "newtons_cradle", "tilted", "midterm_stepped"] {
        assert_eq!(difference(&saved(name)), None, "{name}");
        for (columns, by) in [("events", 1), ("events", usize::MAX), ("flights", 1), ("flights", 2)] {
            let mut file = saved(name);
            if !file[columns].is_null() {
                shorten(&mut file[columns], by);
                assert_eq!(difference(&file).as_deref(), Some(columns), "{name}: {by} rows less");
            }
        }
        for columns in ["events", "flights"] {
            let mut file = saved(name);
            if !file[columns].is_null() {
                file[columns] = Value::Null;
                assert_eq!(difference(&file).as_deref(), Some(columns), "{name}: none at all");
            }
        }
    }
}

#[test]
fn rows_that_are_too_many_are_found() {
    let mut file = saved("midterm");
    for column in file["events"].as_object_mut().unwrap().values_mut() {
        let rows = column.as_array_mut().unwrap();
        rows.push(rows.last().unwrap().clone());
    }
    assert_eq!(difference(&file).as_deref(), Some("events"));
}

#[test]
fn a_digest_or_a_measure_that_is_not_the_runs_own_is_found() {
    for (path, value, place) in [
        ("/digest/state", json!("sha256:00"), "digest.state"),
        ("/digest/events", json!(1), "digest.events"),
        ("/digest/end_time", json!("0"), "digest.end_time"),
        ("/diagnostics/events", json!([0, 1, 2, 3]), "diagnostics.events"),
        ("/diagnostics/deepest_overlap", json!(0.5), "diagnostics.deepest_overlap"),
        ("/diagnostics/clusters", json!(77), "diagnostics.clusters"),
        ("/diagnostics/initial_energy", json!(1e9), "diagnostics.initial_energy"),
        ("/diagnostics/final_energy", json!(1e9), "diagnostics.final_energy"),
        ("/diagnostics/energy_loss", json!(1e9), "diagnostics.energy_loss"),
        ("/diagnostics/energy_error", json!(1e9), "diagnostics.energy_error"),
        ("/diagnostics/momentum_error", json!(1e9), "diagnostics.momentum_error"),
        ("/diagnostics/corrections", json!(1), "diagnostics.corrections"),
        ("/end_time", json!(5.0_f64.next_up()), "end_time"),
        ("/balls/1/changes", json!(77), "balls[1]"),
        ("/balls/1/last_contact", json!(0.25), "balls[1]"),
    ] {
        let mut file = saved("midterm");
        *file.pointer_mut(path).unwrap_or_else(|| panic!("no {path}")) = value;
        assert_eq!(difference(&file).as_deref(), Some(place));
    }
    let mut file = saved("midterm_stepped");
    file["steps"]["lost_time"] = json!(1e9);
    assert_eq!(difference(&file).as_deref(), Some("steps"));
}

/// Random balls on a table of every kind, without a field and in one.
fn scenes() -> impl Iterator<Item = (String, Scenario)> {
    let physics = [
        json!({ "ball_cushion": { "law": "restitution", "normal": 0.9, "tangential": 0.9 } }),
        json!({ "flight": { "law": "field", "acceleration": [-0.3, -0.8] },
            "ball_cushion": { "law": "damping", "factor": 0.7 } }),
    ];
    tables().into_iter().zip(0..).flat_map(move |((name, table), seed)| {
        physics.clone().map(|law| {
            let mut random = Random::new(seed);
            let balls = random_balls(&mut random, &table, 9, [0.02, 0.1], [0.1, 10.0]);
            let mut scenario = scenario(&table, &law, &balls);
            (scenario.duration, scenario.max_events) = (Some(5.0), Some(3000));
            (format!("{name}, {law}, seed {seed}"), scenario)
        })
    })
}

#[test]
fn a_run_made_in_pieces_verifies_with_all_that_it_measured() {
    for (name, scenario) in scenes() {
        let mut part = scenario.clone();
        part.duration = Some(0.5);
        let mut run = simulate(&part).unwrap();
        for end in [1.0, 1.1, 3.0, 5.0] {
            part.duration = Some(end);
            run = resume(&part, &run, None, &mut || false).unwrap();
        }
        assert_eq!(verify(&scenario, &run, &mut || false).unwrap(), None, "{name}");
        let (read, saved) = from_json::<Plane>(&to_json(&scenario, &run).unwrap()).unwrap();
        assert_eq!(verify(&read, &saved, &mut || false).unwrap(), None, "{name}");
    }
}

#[test]
fn a_ball_bound_to_no_cushion_of_the_table_is_refused() {
    for (path, value, expected) in [
        (
            "/balls/0/held_by",
            json!([99, null]),
            "balls[0].held_by: a cushion that the scenario does not have",
        ),
        ("/balls/1/held_by", json!([0, 4]), "balls[1].held_by: a cushion that the scenario does not have"),
        ("/balls/0/held_by", json!([null, 1]), "balls[0].held_by: the second cushion without a first"),
        (
            "/balls/1/last_cushion",
            json!(4),
            "balls[1].last_cushion: a cushion that the scenario does not have",
        ),
    ] {
        assert_eq!(complaint("midterm", path, value), expected);
    }
    let said = complaint("sinai", "/balls/0/held_by", json!([4, null]));
    assert_eq!(said, "balls[0].held_by: a cushion that is not straight");
}

#[test]
fn an_end_that_does_not_fit_is_refused() {
    let events = saved("midterm")["events"]["time"].as_array().unwrap().clone();
    let late = events.iter().position(|time| time.as_f64().unwrap() > 2.0).unwrap();
    for (value, expected) in [
        (json!(-1.0), "end_time: before the start".to_owned()),
        (json!(2.0), format!("end_time: before events.time[{late}]")),
    ] {
        assert_eq!(complaint("midterm", "/end_time", value), expected);
    }
    for text in ["null", "\"NaN\""] {
        let value = serde_json::from_str(text).unwrap();
        assert!(complaint("midterm", "/end_time", value).starts_with("end_time: invalid type"));
    }
    let text = saved("midterm").to_string().replacen("\"end_time\":5.0", "\"end_time\":NaN", 1);
    assert!(from_json::<Plane>(&text).is_err());
    let mut file = saved("midterm");
    (file["events"], file["flights"]) = (Value::Null, Value::Null);
    file["end_time"] = json!(0.5);
    let said = from_json::<Plane>(&file.to_string()).map(|_| ()).unwrap_err().to_string();
    assert!(said.starts_with("not a saved run: end_time: before balls["), "{said}");
    assert!(
        complaint("midterm_stepped", "/end_time", json!(0.5)).starts_with("end_time: before steps.time[")
    );
}

#[test]
fn rest_is_refused_where_a_ball_moves() {
    let said = complaint("midterm", "/status", json!("at_rest"));
    assert!(said.starts_with("status: at_rest, but balls["), "{said}");
    let resting = saved("damped_drop");
    assert_eq!(resting["status"], "at_rest");
    assert_eq!(difference(&resting), None);
}

fn refused(change: impl FnOnce(&mut Run<f64>)) -> String {
    let scenario = crate::kit::bundled("midterm");
    let mut run = simulate(&scenario).unwrap();
    change(&mut run);
    to_json(&scenario, &run).map(|_| ()).expect_err("it is refused").to_string()
}

#[test]
fn a_run_with_a_number_that_is_none_is_never_written() {
    let said = |place: &str| format!("the run cannot be saved: {place} is not a finite number");
    assert_eq!(refused(|run| run.end_time = f64::INFINITY), said("end_time"));
    assert_eq!(refused(|run| run.log.events[3].impulse = f64::NAN), said("events.impulse[3]"));
    assert_eq!(refused(|run| run.log.flights[2].1.velocity.y = f64::INFINITY), said("flights.state[2]"));
    assert_eq!(refused(|run| run.log.flights[2].1.start = f64::NAN), said("flights.start[2]"));
    assert_eq!(refused(|run| run.balls[1].0.velocity.x = f64::INFINITY), said("balls[1].state"));
    assert_eq!(refused(|run| run.balls[1].1.last_contact = f64::NAN), said("balls[1].last_contact"));
    assert_eq!(refused(|run| run.balls[0].1.burst_start = f64::INFINITY), said("balls[0].burst_start"));
    assert_eq!(refused(|run| run.diagnostics.energy_loss = f64::NAN), said("diagnostics.energy_loss"));
    assert_eq!(refused(|run| run.balls[0].0.position.x = f64::NAN), said("balls[0].state"));
    let too_long = |run: &mut Run<f64>| {
        // A time of flight beyond all numbers, at rest along x: no place comes of it.
        (run.balls[0].0.start, run.end_time) = (-f64::MAX, f64::MAX);
        run.balls[0].0.velocity.x = 0.0;
    };
    assert_eq!(refused(too_long), said("the state at the end"));
    let scenario = crate::kit::bundled("midterm_stepped");
    let mut run = simulate(&scenario).unwrap();
    run.steps.as_mut().unwrap().steps[7].balls[1].position.y = f64::NAN;
    assert_eq!(to_json(&scenario, &run).map(|_| ()).unwrap_err().to_string(), said("steps.state[7]"));
}

#[test]
fn a_longer_run_needs_an_end_as_any_run_does() {
    let scenario = crate::kit::bundled("midterm");
    let free = Scenario::from_toml(&scenario.to_toml().unwrap().replace("duration = 5.0\n", ""));
    let said = prolonged(&scenario, &[]).unwrap_err();
    assert_eq!(said, free.unwrap_err());
    assert!(said.to_string().starts_with("duration: missing, and not everything comes to rest"), "{said}");
    let longer = prolonged(&scenario, &[("duration".to_owned(), json!(7))]).unwrap();
    assert_eq!((longer.duration, longer.collisions), (Some(7.0), None));
    let run = simulate(&scenario).unwrap();
    let joined = resume(&longer, &run, None, &mut || false).unwrap();
    assert_eq!((joined.status, joined.saved_digest), (Status::TimeLimit, None));
}
