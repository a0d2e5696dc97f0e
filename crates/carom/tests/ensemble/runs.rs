//! Rows are runs: the parts of an ensemble are the whole, and each row is the run that its numbers give.

use carom::ensemble::{Design, Distribution, Ending, Ensemble, Inputs, Outcome, Source, Table};
use carom::run::Status;
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde_json::json;

fn midterm() -> Scenario {
    Scenario::from_toml(include_str!("../../../../scenarios/midterm.toml")).unwrap()
}

fn everything() -> Vec<Outcome> {
    let all = Outcome::ALL.into_iter().filter(|o| ![Outcome::FinalSpin, Outcome::Pockets].contains(o));
    all.chain([Outcome::ClosestApproach(["red".into(), "blue".into()])]).collect()
}

/// Two thousand runs with speed and direction by chance, some speeds below zero.
fn ensemble(sources: Vec<(String, Source)>) -> Ensemble {
    let inputs = Inputs::new(sources, Some(2000), Design::Independent, 4).unwrap();
    Ensemble::new(&midterm(), inputs, &everything()).unwrap()
}

fn by_chance() -> Vec<(String, Source)> {
    let speed = Distribution::Normal { mean: 5.0, standard_deviation: 3.0 };
    let direction = Distribution::Uniform { low: -180.0, high: 180.0 };
    vec![
        ("balls.red.speed".into(), Source::Drawn(speed)),
        ("balls.red.direction_deg".into(), Source::Drawn(direction)),
    ]
}

fn bits(table: &Table) -> Vec<Vec<u64>> {
    table.columns.iter().map(|column| column.iter().map(|number| number.to_bits()).collect()).collect()
}

#[test]
fn parts_are_the_whole_on_any_number_of_threads() {
    let ensemble = ensemble(by_chance());
    let whole = ensemble.run(0..2000, Some(1), &mut |_| false).unwrap();
    assert!(
        whole.problems.len() > 20 && whole.endings.contains(&Ending::Rejected),
        "{}",
        whole.problems.len()
    );
    for threads in [1, 2, 5] {
        let parts =
            [0..1, 1..700, 700..2000].map(|rows| ensemble.run(rows, Some(threads), &mut |_| false).unwrap());
        for (column, whole) in bits(&whole).into_iter().enumerate() {
            let joined: Vec<u64> = parts.iter().flat_map(|part| bits(part)[column].clone()).collect();
            assert_eq!(joined, whole, "{threads} threads, {}", ensemble.columns()[column].name);
        }
        assert_eq!(parts.iter().flat_map(|part| part.endings.clone()).collect::<Vec<_>>(), whole.endings);
        assert_eq!(parts.iter().flat_map(|part| part.problems.clone()).collect::<Vec<_>>(), whole.problems);
    }
}

#[test]
fn a_row_is_the_run_of_its_scenario() {
    let laws =
        ("physics.ball_cushion.factor".into(), Source::Drawn(Distribution::Uniform { low: 0.2, high: 1.0 }));
    for sources in [by_chance(), [by_chance(), vec![laws]].concat()] {
        let ensemble = ensemble(sources);
        let table = ensemble.run(0..200, None, &mut |_| false).unwrap();
        for row in 0..200 {
            let Ok(scenario) = ensemble.scenario(row as u64) else {
                assert_eq!(table.endings[row], Ending::Rejected);
                assert!(table.columns.iter().all(|column| column[row].is_nan()));
                continue;
            };
            let run = simulate(&scenario).unwrap();
            assert_eq!(table.endings[row], Ending::Ended(run.status));
            let of = |name: &str| {
                let place = ensemble.columns().iter().position(|column| column.name == name);
                table.columns[place.unwrap()][row]
            };
            let ends = run.final_state();
            for (id, end) in run.system.ball_ids.iter().zip(&ends) {
                let (position, velocity) = (end.position, end.velocity);
                assert_eq!([of(&format!("{id}.x")), of(&format!("{id}.y"))], [position.x, position.y]);
                assert_eq!([of(&format!("{id}.vx")), of(&format!("{id}.vy"))], [velocity.x, velocity.y]);
            }
            assert_eq!(of("end_time"), run.end_time);
            assert_eq!(of("events.ball_cushion"), run.diagnostics.events[1] as f64);
            let times: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
            assert_eq!(of("first_event").to_bits(), times.first().copied().unwrap_or(f64::NAN).to_bits());
            assert_eq!(of("last_event").to_bits(), times.last().copied().unwrap_or(f64::NAN).to_bits());
        }
    }
}

/// From many states of the run on the way, which lie close together.
#[test]
fn ways_and_the_closest_approach_are_those_of_the_flights() {
    let mut met = 0;
    let ensemble = ensemble(by_chance());
    let table = ensemble.run(0..60, None, &mut |_| false).unwrap();
    let of = |name: &str, row: usize| {
        table.columns[ensemble.columns().iter().position(|column| column.name == name).unwrap()][row]
    };
    for row in (0..60).filter(|row| table.endings[*row] != Ending::Rejected) {
        let run = simulate(&ensemble.scenario(row as u64).unwrap()).unwrap();
        let steps = 4000;
        let state = |k: i32| run.state(run.end_time * f64::from(k) / f64::from(steps)).unwrap();
        let (mut lengths, mut nearest, mut before) = ([0.0; 2], f64::INFINITY, state(0));
        for k in 1..=steps {
            let now = state(k);
            (0..2).for_each(|ball| lengths[ball] += (now[ball].position - before[ball].position).norm());
            nearest = (now[0].position - now[1].position).norm().min(nearest);
            before = now;
        }
        // A piece across a bounce is cut short, and between two states balls may come nearer.
        let fastest = 15.0 * run.end_time / f64::from(steps);
        let names = ["red.distance", "blue.distance"];
        for (name, length) in names.iter().zip(lengths) {
            let found = of(name, row);
            assert!(found >= length - 1e-9 && found < length + 100.0 * fastest, "{row}: {found} {length}");
        }
        let found = of("closest_approach.red.blue", row);
        assert!(found <= nearest + 1e-12 && found > nearest - fastest, "{row}: {found} {nearest}");
        let hits = run.diagnostics.events[0];
        assert_eq!(hits > 0, found < 0.15 + 1e-12, "{row}: {found}");
        met += hits;
    }
    assert!(met > 10, "{met}");
}

#[test]
fn what_cannot_be_told_is_refused() {
    let refused = |scenario: Scenario, outcome: &str| {
        let speeds = ("balls[0].speed".to_owned(), Source::Given(vec![1.0]));
        let inputs = Inputs::new(vec![speeds], None, Design::Independent, 0).unwrap();
        let outcome = Outcome::from_name(outcome).unwrap();
        Ensemble::new(&scenario, inputs, &[outcome]).map(|_| ()).unwrap_err().to_string()
    };
    assert_eq!(
        refused(midterm(), "closest_approach.red.bleu"),
        "outcomes: closest_approach: there is no ball \"bleu\"; did you mean blue? known: red, blue"
    );
    assert_eq!(
        refused(midterm(), "closest_approach.red.red"),
        "outcomes: closest_approach: names \"red\" twice"
    );
    let stepped = midterm().with_values(&[("method", json!({ "kind": "stepped", "dt": 0.1 }))]).unwrap();
    assert_eq!(
        refused(stepped, "distance"),
        "outcomes: distance: the stepped method has no flights; use the exact one"
    );
    let open =
        midterm().with_values(&[("table.periodic", json!(["x"])), ("physics.ball_cushion", json!(null))]);
    assert_eq!(
        refused(open.unwrap(), "closest_approach.red.blue"),
        "outcomes: closest_approach: is not for tables with periodic sides"
    );
    assert!(Outcome::from_name("closest_approach.red").is_none());
    assert_eq!(Outcome::from_name("closest_approach.\"8\".cue").unwrap().name(), "closest_approach");
}

#[test]
fn an_ensemble_may_be_ended_early() {
    let ensemble = ensemble(by_chance());
    let table = ensemble.run(0..2000, Some(1), &mut |_| true).unwrap();
    for (row, ending) in table.endings.iter().enumerate() {
        let is_empty = table.columns.iter().all(|column| column[row].is_nan());
        assert_eq!(is_empty, *ending != Ending::Ended(Status::TimeLimit), "{row}");
    }
}
