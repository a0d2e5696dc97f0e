//! The course exercise: two balls on a 1 x 2 table, walls that damp both components by 0.8.

use carom::engine::{Limits, Simulation};
use carom::run::{Kind, Log, Nothing, Status};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::{Scenario, System};
use carom::simulate::simulate;
use std::sync::Arc;

const MIDTERM: &str = include_str!("../../../scenarios/midterm.toml");

fn midterm() -> Scenario {
    Scenario::from_toml(MIDTERM).unwrap()
}

#[test]
fn first_hits_come_at_their_closed_form_times() {
    let run = simulate(&midterm()).unwrap();
    let times: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
    for e in &run.log.events {
        println!("{e:?}");
    }
    println!("{:?}", run.diagnostics);
    println!("{:?}", run.final_state());
    assert_eq!(run.status, Status::TimeLimit);
    assert_eq!(times.len(), 12);
    for (time, expected) in times.iter().zip([0.275, 0.5015625, 0.661067708333333333, 0.86472550082018593]) {
        assert!((time / expected - 1.0).abs() < 1e-14, "{time} for {expected}");
    }
}
