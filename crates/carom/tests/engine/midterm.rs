//! The course exercise, in every kind of number and by both methods, against computations made elsewhere.

use carom::engine::{Limits, Simulation};
use carom::flight::State;
use carom::run::{Event, Kind, Log, Run, Status};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::schema::{AfterHit, LastStep, Method, NormalTaken};
use carom::scenario::{Scenario, System};
use carom::simulate::simulate;
use serde_json::Value;
use std::sync::Arc;

fn midterm() -> Scenario {
    Scenario::from_toml(include_str!("../../../../scenarios/midterm.toml")).unwrap()
}

/// The exact motion in 50 digits, by `tests/oracle/exact.py`.
fn reference() -> Value {
    serde_json::from_str(include_str!("../../../../tests/oracle/midterm_reference.json")).unwrap()
}

/// Runs a system for the exercise's five seconds.
fn run_of<S: Scalar>(system: System<S>) -> Run<S> {
    let mut log: Log<S> = Log::new(true, true);
    let mut simulation: Simulation<S> =
        Simulation::new(Arc::new(system), Limits::duration(S::from_f64(5.0)), &mut log);
    simulation.run(&mut log).unwrap();
    simulation.finish(log)
}

/// The four numbers of each ball at the end.
fn final_numbers<S: Scalar>(run: &Run<S>) -> Vec<S> {
    run.final_state().iter().flat_map(|s| [s.position.x, s.position.y, s.velocity.x, s.velocity.y]).collect()
}

fn event_numbers<S: Scalar>(event: &Event<S>) -> [S; 7] {
    let Event { time, point, normal, closing_speed, impulse, .. } = *event;
    [time, point.x, point.y, normal.x, normal.y, closing_speed, impulse]
}

/// A decimal number in double-double.
fn decimal(text: &Value) -> DoubleDouble {
    let text = text.as_str().unwrap();
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let digits = mantissa.trim_start_matches('-');
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let ten = DoubleDouble::from_f64(10.0);
    let mut value = DoubleDouble::ZERO;
    for digit in whole.bytes().chain(fraction.bytes()) {
        value = value * ten + DoubleDouble::from_f64(f64::from(digit - b'0'));
    }
    let places = fraction.len() as i32 - exponent.parse::<i32>().unwrap();
    for _ in 0..places.max(0) {
        value = value / ten;
    }
    if mantissa.starts_with('-') { -value } else { value }
}

fn reference_final() -> Vec<DoubleDouble> {
    let balls = &reference()["final"]["balls"];
    let numbers = |ball: &str| {
        let ball = &balls[ball];
        [&ball["position"], &ball["velocity"]].map(|v| [decimal(&v[0]), decimal(&v[1])]).concat()
    };
    [numbers("red"), numbers("blue")].concat()
}

#[test]
fn first_hits_come_at_their_closed_form_times() {
    let run = simulate(&midterm()).unwrap();
    assert_eq!(run.status, Status::TimeLimit);
    assert_eq!(run.log.events.len(), 12);
    let first = [0.275, 0.5015625, 0.661_067_708_333_333_3, 0.864_725_500_820_186];
    for (event, expected) in run.log.events.iter().zip(first) {
        assert!((event.time / expected - 1.0).abs() < 1e-14, "{} for {expected}", event.time);
    }
    let red = run.state(run.log.events[0].time).unwrap()[0].position;
    assert!((red.x - 0.925).abs() < 1e-15);
    let kinds: Vec<Kind> = run.log.events.iter().map(|event| event.kind).collect();
    assert_eq!(kinds.iter().filter(|kind| **kind == Kind::BallBall).count(), 1);
    assert_eq!(kinds[3], Kind::BallBall);
}

#[test]
fn state_at_the_end_agrees_with_fifty_digits() {
    let run = simulate(&midterm()).unwrap();
    for (number, expected) in final_numbers(&run).iter().zip(reference_final()) {
        assert!((number - expected.to_f64()).abs() < 1e-13, "{number} for {}", expected.to_f64());
    }
}

#[test]
fn double_double_agrees_with_fifty_digits_to_1e_28() {
    let run = run_of(System::<DoubleDouble>::new(&midterm()));
    for (number, expected) in final_numbers(&run).iter().zip(reference_final()) {
        assert!((*number - expected).to_f64().abs() < 1e-28, "{number:?} for {expected:?}");
    }
    let reference = reference();
    for (event, expected) in run.log.events.iter().zip(reference["events"].as_array().unwrap()) {
        assert_eq!(event.kind.name(), expected["kind"].as_str().unwrap());
        assert_eq!(run.system.ball_ids[event.ball_a as usize], expected["ball_a"].as_str().unwrap());
        let numbers = [
            (event.time, &expected["time"]),
            (event.point.x, &expected["point"][0]),
            (event.point.y, &expected["point"][1]),
            (event.normal.x, &expected["normal"][0]),
            (event.normal.y, &expected["normal"][1]),
            (event.closing_speed, &expected["closing_speed"]),
            (event.impulse, &expected["impulse"]),
        ];
        for (number, expected) in numbers {
            let difference = (number - decimal(expected)).to_f64().abs();
            assert!(difference < 1e-28, "{number:?} for {expected}, off by {difference:e}");
        }
    }
}

/// The number at `place` as the variable, everything else constant.
fn dual_run(place: &str) -> Run<Dual<1>> {
    let place = midterm().place(place).unwrap();
    run_of(System::with(&midterm(), &mut |at, value| {
        if at.to_string() == place { Dual::variable(value, 0) } else { Dual::constant(value) }
    }))
}

/// The run with the number at `place` moved by `step`, in double-double.
fn moved_run(place: &str, step: DoubleDouble) -> Run<DoubleDouble> {
    let place = midterm().place(place).unwrap();
    run_of(System::with(&midterm(), &mut |at, value| {
        let value = DoubleDouble::from_f64(value);
        if at.to_string() == place { value + step } else { value }
    }))
}

const VARIED: [&str; 6] = [
    "balls.red.velocity[0]",
    "balls.red.position[1]",
    "balls.blue.position[0]",
    "ball_defaults.radius",
    "physics.ball_cushion.factor",
    "table.width",
];

#[test]
fn real_part_of_a_dual_run_is_the_f64_run_bit_for_bit() {
    let plain = simulate(&midterm()).unwrap();
    for place in VARIED {
        let dual = dual_run(place);
        assert_eq!(dual.log.events.len(), plain.log.events.len());
        for (a, b) in dual.log.events.iter().zip(&plain.log.events) {
            let values = event_numbers(a).map(|number| number.value.to_bits());
            assert_eq!(values, event_numbers(b).map(f64::to_bits), "{place}");
        }
        let ends = final_numbers(&dual).iter().map(|number| number.value.to_bits()).collect::<Vec<_>>();
        assert_eq!(ends, final_numbers(&plain).iter().map(|number| number.to_bits()).collect::<Vec<_>>());
    }
}

#[test]
fn derivatives_through_all_events_agree_with_differences_in_double_double() {
    // A central difference of step h errs by h²/6 times the third derivative; in double-double its round-off is 1e-31/h.
    let step = DoubleDouble::from_f64(1e-9);
    for place in VARIED {
        let dual = final_numbers(&dual_run(place));
        let (ahead, behind) =
            (final_numbers(&moved_run(place, step)), final_numbers(&moved_run(place, -step)));
        for ((dual, ahead), behind) in dual.iter().zip(ahead).zip(behind) {
            let difference = ((ahead - behind) / (step + step)).to_f64();
            let derivative = dual.derivatives[0];
            let scale = 1.0 + derivative.abs();
            assert!(
                (derivative - difference).abs() < 1e-11 * scale,
                "{place}: {derivative} for {difference}"
            );
        }
    }
}

fn stepped(dt: f64) -> Scenario {
    let method = Method::Stepped {
        dt,
        after_hit: AfterHit::default(),
        normal: NormalTaken::default(),
        last_step: LastStep::default(),
        steps: None,
    };
    Scenario { method, ..midterm() }
}

#[test]
fn stepped_hits_come_where_the_scheme_puts_them() {
    let run = simulate(&stepped(0.03)).unwrap();
    let expected = [0.275, 0.5265625, 0.699_505_208_333_333_5, 0.923_316_581_680_325_2];
    for (event, expected) in run.log.events.iter().zip(expected) {
        assert!((event.time - expected).abs() < 1e-15, "{} for {expected}", event.time);
    }
    let collision = run.log.events[3];
    assert_eq!(collision.kind, Kind::BallBall);
    let step = run.steps.unwrap().steps.iter().position(|step| step.hits[1].is_some()).unwrap();
    assert_eq!(step, 30);
}

#[test]
fn every_reading_of_the_scheme_agrees_with_a_program_written_elsewhere() {
    let text = include_str!("../../../../tests/oracle/stepped_readings.json");
    let readings: Value = serde_json::from_str(text).unwrap();
    for entry in readings["readings"].as_array().unwrap() {
        let mut method = entry["reading"].clone();
        method["kind"] = "stepped".into();
        method["dt"] = readings["dt"].clone();
        let scenario = midterm().with_values(&[("method", method)]).unwrap();
        let run = simulate(&scenario).unwrap();
        let what = &entry["reading"];
        assert_eq!(run.log.events.len() as u64, entry["event_count"].as_u64().unwrap(), "{what}");
        let steps = run.steps.as_ref().unwrap();
        assert_eq!(steps.steps.len() as u64, entry["steps"].as_u64().unwrap() + 1, "{what}");
        // The two programs add in different orders: a few units in the last place, which no later event magnifies much.
        let near =
            |a: f64, b: &Value| assert!((a - b.as_f64().unwrap()).abs() < 1e-14, "{what}: {a} for {b}");
        near(run.end_time, &entry["end_time"]);
        for (event, time) in run.log.events.iter().zip(entry["event_times"].as_array().unwrap()) {
            near(event.time, time);
        }
        for (ball, &State { position: x, velocity: v }) in run.final_state().iter().enumerate() {
            let (position, velocity) = (&entry["positions"][ball], &entry["velocities"][ball]);
            [(x.x, &position[0]), (x.y, &position[1]), (v.x, &velocity[0]), (v.y, &velocity[1])]
                .into_iter()
                .for_each(|(a, b)| near(a, b));
        }
        near(steps.lost_time, &entry["lost_time"]);
        near(run.diagnostics.final_energy, &entry["energy"]);
    }
}

#[test]
fn stepped_runs_converge_to_the_exact_one_at_first_order() {
    let exact = final_numbers(&simulate(&midterm()).unwrap());
    let error = |dt: f64| {
        let run = simulate(&stepped(dt)).unwrap();
        let squares = final_numbers(&run).iter().zip(&exact).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        squares.sqrt()
    };
    // The time lost at a hit is anything from nothing to a whole step, so single errors jump; a fit over many smooths it.
    let points: Vec<(f64, f64)> = (0..37)
        .map(|k| 10_f64.powf(-2.5 - f64::from(k) / 12.0))
        .map(|dt| (dt.ln(), error(dt).ln()))
        .collect();
    let count = points.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>()
        / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>();
    assert!((slope - 1.0).abs() < 0.1, "slope {slope}");
}
