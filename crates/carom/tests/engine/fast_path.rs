//! The short way of prediction, taken where no field pulls and no thin wall stands, finds what the general way finds.
use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, rack, random_balls, rectangle, scenario, tables};
use crate::kit::{assert_same_events, assert_same_run, bits};
use carom::engine::Simulation;
use carom::run::{Event, Run};
use carom::scenario::{Scenario, System};
use carom::simulate::{limits_of, log_of};
use serde_json::{Value, json};
use std::sync::Arc;

const SMALLEST: f64 = 0.01;

/// Random balls on every table without thin walls, 2 to 30 of them, without loss and with it; and balls that touch.
fn scenes() -> Vec<(String, Scenario, Value)> {
    let physics = [
        json!({}),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.9 },
            "ball_cushion": { "law": "restitution", "normal": 0.95, "tangential": 0.9 } }),
    ];
    let mut scenes = Vec::new();
    for (name, table) in tables().into_iter().filter(|(name, _)| !["divider", "walls"].contains(name)) {
        for (seed, count) in (0..).zip([2, 3, 8, 15, 30, 30]) {
            let mut random = Random::new(seed);
            let balls = random_balls(&mut random, &table, count, [SMALLEST, 0.06], [0.1, 10.0]);
            let law = &physics[(seed % 2) as usize];
            scenes.push((format!("{name}, seed {seed}, {law}"), ended(&table, law, &balls), table.clone()));
        }
    }
    for law in &physics {
        let mut balls = rack(0.0625, [1.0, 1.0], 4);
        balls.push(ball(0.0625, [1.0, 0.25], [0.0, 2.0]));
        let table = rectangle(2.0, 2.0);
        scenes.push((format!("rack, {law}"), ended(&table, law, &balls), table));
    }
    scenes
}

fn ended(table: &Value, physics: &Value, balls: &[Ball]) -> Scenario {
    let mut scenario = scenario(table, physics, balls);
    (scenario.duration, scenario.max_events) = (Some(20.0), Some(2000));
    scenario
}

/// A run of a scenario's system, changed before the start.
fn run(scenario: &Scenario, change: impl FnOnce(&mut System<f64>)) -> Run<f64> {
    let mut system = System::new(scenario);
    change(&mut system);
    let mut log: carom::run::Log<f64> = log_of(scenario);
    let mut simulation: Simulation<f64> =
        Simulation::new(Arc::new(system), limits_of(scenario, None), &mut log);
    simulation.run(&mut log).unwrap_or_else(|error| panic!("{error}"));
    simulation.finish(log)
}

#[test]
fn the_short_way_finds_what_the_general_way_finds() {
    let mut events = 0;
    for (name, mut scenario, _) in scenes() {
        for has_point in [false, true] {
            if has_point {
                scenario.balls[0].radius = Some(0.0);
            }
            let short = run(&scenario, |system| assert!(!system.has_backs));
            // Told that there are thin walls, although none of its cushions is one, the engine takes the general way.
            let general = run(&scenario, |system| system.has_backs = true);
            assert_same_run(&short, &general, &name);
            events += short.log.events.len();
        }
    }
    assert!(events > 50_000, "only {events} events");
}

/// The same scenario with a thin wall in its lower left corner, too small and too near for any ball to reach.
fn with_a_wall_out_of_reach(scenario: &Scenario, table: &Value) -> Scenario {
    let mut table = table.clone();
    let size = 0.01 * SMALLEST;
    let wall = json!({ "wall": [[2.0 * size, size], [4.0 * size, 1.5 * size]], "id": "unreachable" });
    match table["obstacles"].as_array_mut() {
        Some(obstacles) => obstacles.push(wall),
        None => table["obstacles"] = json!([wall]),
    }
    scenario.with_values(&[("table", table)]).unwrap_or_else(|error| panic!("{error}"))
}

/// The events with the number of each cushion as another run's table has it.
fn renumbered(run: &Run<f64>, as_in: &Run<f64>) -> Vec<Event<f64>> {
    let ids = &as_in.system.cushion_ids;
    let number = |cushion: u32| {
        let id = &run.system.cushion_ids[cushion as usize];
        ids.iter().position(|other| other == id).unwrap_or_else(|| panic!("{id} was reached")) as u32
    };
    run.log.events.iter().map(|event| Event { cushion: event.cushion.map(number), ..*event }).collect()
}

#[test]
fn a_thin_wall_that_no_ball_can_reach_changes_no_bit() {
    let has_that_corner = ["rectangle", "l_shape", "acute", "pillar", "wedge", "rack"];
    let mut tried = 0;
    for (name, scenario, table) in scenes() {
        if !has_that_corner.iter().any(|table| name.starts_with(table)) {
            continue;
        }
        let plain = run(&scenario, |system| assert!(!system.has_backs));
        let walled = run(&with_a_wall_out_of_reach(&scenario, &table), |system| assert!(system.has_backs));
        assert_same_events(&plain.log.events, &renumbered(&walled, &plain), &name);
        assert_eq!(plain.log.flights, walled.log.flights, "{name}");
        assert_eq!((plain.status, plain.end_time), (walled.status, walled.end_time), "{name}");
        assert_eq!(bits(&plain.final_state()), bits(&walled.final_state()), "{name}");
        tried += 1;
    }
    assert_eq!(tried, 5 * 6 + 2);
}
