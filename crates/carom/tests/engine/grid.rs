//! A run in which a grid tells who is near has the bits of one in which everyone is asked.

use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, rack, random_balls, rectangle, scenario, stadium};
use crate::kit::{assert_same_events, assert_same_run, bits};
use carom::engine::{Discs, Limits, Simulation};
use carom::run::{Log, Nothing, Run};
use carom::scenario::{Scenario, System};
use carom::simulate::{limits_of, log_of};
use serde_json::{Value, json};
use std::sync::Arc;

const NEVER: usize = usize::MAX;

/// Balls of one size and of many, dense and thin, without loss and with it, in rooms of many shapes.
fn scenes() -> Vec<(String, Scenario)> {
    let tables = [
        ("square", rectangle(2.0, 2.0)),
        ("channel", rectangle(0.5, 8.0)),
        ("stadium", stadium(2.0, 1.0)),
        (
            "obstacle",
            json!({ "shape": "rectangle", "width": 2.0, "length": 2.0,
            "obstacles": [{ "circle": { "center": [1.0, 1.0], "radius": 0.3 } }] }),
        ),
    ];
    let physics = [
        json!({}),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.9 },
            "ball_cushion": { "law": "restitution", "normal": 0.95, "tangential": 0.9 } }),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.7 }, "collapse": "tc" }),
    ];
    let fields = [[0.0, -1.0], [0.3, -0.2], [-5.0, 0.0], [0.0, 20.0]];
    let mut scenes = Vec::new();
    for (name, table) in &tables {
        for (seed, (count, radii)) in
            (0..).zip([(60, [0.03_f64, 0.03]), (100, [0.001, 0.02]), (40, [0.01, 0.06]), (80, [0.0, 0.02])])
        {
            let mut random = Random::new(seed);
            let mut balls =
                random_balls(&mut random, table, count, [radii[0].max(1e-3), radii[1]], [0.1, 10.0]);
            if radii[0] == 0.0 {
                balls.iter_mut().step_by(3).for_each(|ball| ball.radius = 0.0);
            }
            let law = &physics[(seed % 3) as usize];
            scenes.push((format!("{name}, seed {seed}, {law}"), ended(table, law, &balls)));
            let mut pulled = law.clone();
            pulled["flight"] = json!({ "law": "field", "acceleration": fields[seed as usize] });
            scenes.push((format!("{name}, seed {seed}, {pulled}"), ended(table, &pulled, &balls)));
        }
    }
    // So few on so large a table that they crowd in its cells when they have fallen.
    let tall = rectangle(1.0, 100.0);
    let balls = random_balls(&mut Random::new(7), &tall, 100, [0.02, 0.03], [0.1, 1.0]);
    let falling = json!({ "ball_ball": { "law": "restitution", "normal": 0.5 }, "collapse": "tc",
        "flight": { "law": "field", "acceleration": [0.0, -10.0] } });
    scenes.push(("tall".into(), ended(&tall, &falling, &balls)));
    let mut balls = rack(0.0625, [2.0, 2.0], 8);
    balls.push(ball(0.0625, [2.0, 1.0], [0.0, 2.0]));
    scenes.push(("rack".into(), ended(&rectangle(4.0, 4.0), &physics[0], &balls)));
    scenes
}

fn ended(table: &Value, physics: &Value, balls: &[Ball]) -> Scenario {
    let mut scenario = scenario(table, physics, balls);
    (scenario.duration, scenario.max_events) = (Some(20.0), Some(5000));
    scenario
}

fn start(scenario: &Scenario, grid_from: usize) -> (Simulation<f64>, Log<f64>) {
    let system = System { grid_from, ..System::new(scenario) };
    let mut log = log_of(scenario);
    let simulation = Simulation::new(Arc::new(system), limits_of(scenario, None), &mut log);
    (simulation, log)
}

fn run(scenario: &Scenario, grid_from: usize) -> Run<f64> {
    let (mut simulation, mut log) = start(scenario, grid_from);
    simulation.run(&mut log).unwrap_or_else(|error| panic!("{error}"));
    simulation.finish(log)
}

#[test]
fn a_grid_changes_no_bit() {
    let mut events = 0;
    for (name, scenario) in scenes() {
        let (with, without) = (run(&scenario, 0), run(&scenario, NEVER));
        assert_same_events(&with.log.events, &without.log.events, &name);
        assert_same_run(&with, &without, &name);
        // Who comes into another cell is predicted once more: there was a grid.
        assert!(with.diagnostics.predictions > without.diagnostics.predictions, "{name}");
        events += with.log.events.len();
    }
    assert!(events > 30_000, "{events}");
}

#[test]
fn single_steps_candidates_and_resets_do_not_disturb_a_grid() {
    for (name, scenario) in scenes().into_iter().step_by(3) {
        let whole = run(&scenario, NEVER);
        let (mut simulation, mut log) = start(&scenario, 0);
        let mut asked = start(&scenario, NEVER).0;
        for k in 0..300 {
            if k % 50 == 0 {
                let times = |simulation: &mut Simulation<f64>| -> Vec<(f64, Option<u32>)> {
                    simulation.candidates().iter().map(|next| (next.time, next.other)).collect()
                };
                assert_eq!(times(&mut simulation), times(&mut asked), "{name}, step {k}");
            }
            simulation.step(&mut log).unwrap();
            asked.step(&mut Nothing).unwrap();
        }
        simulation.run(&mut log).unwrap();
        assert_same_run(&simulation.finish(log), &whole, &name);
        let (mut simulation, _) = start(&scenario, 0);
        simulation.run(&mut Nothing).unwrap();
        let mut log = log_of(&scenario);
        simulation.reset(&mut log);
        simulation.run(&mut log).unwrap();
        assert_same_run(&simulation.finish(log), &whole, &name);
    }
}

#[test]
fn a_run_that_goes_on_from_any_time_has_a_grid_again() {
    for (name, scenario) in scenes().into_iter().step_by(2) {
        let whole = run(&scenario, NEVER);
        let mut first = scenario.clone();
        first.duration = Some(whole.end_time * 0.37);
        let part = run(&first, 0);
        let mut log = part.log.clone();
        let mut simulation: Simulation<f64, Discs<f64>> =
            Simulation::resume(&part, limits_of(&scenario, None));
        simulation.run(&mut log).unwrap();
        assert_eq!(bits(&simulation.finish(log).final_state()), bits(&whole.final_state()), "{name}");
    }
}

#[test]
fn a_thousand_discs_never_overlap_and_keep_their_energy() {
    let mut random = Random::new(9);
    let table = rectangle(1.0, 1.0);
    let balls = random_balls(&mut random, &table, 1000, [0.006, 0.01], [0.5, 2.0]);
    assert!(balls.len() > 900, "{}", balls.len());
    let system = Arc::new(System::new(&scenario(&table, &json!({}), &balls)));
    let mut simulation: Simulation<f64> =
        Simulation::new(system, Limits { collisions: Some(100_000), ..Limits::duration(1e9) }, &mut Nothing);
    simulation.run(&mut Nothing).unwrap();
    let found = simulation.diagnostics();
    assert!(found.deepest_overlap < 1e-9 * 0.006, "{found:?}");
    assert!(found.energy_drift < 1e-11 * found.initial_energy, "{found:?}");
}
