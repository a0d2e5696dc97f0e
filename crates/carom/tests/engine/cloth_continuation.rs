//! A run on the cloth in pieces is the run at once, to the last bit; and in other numbers it is the same run.

use crate::kit::cloth::{ball, bits, checked, played, random_shot, scene};
use crate::kit::random::Random;
use carom::engine::{Limits, Simulation, Spheres};
use carom::flight::SphereState;
use carom::run::{Log, OnCloth, Run, Status, from_json, to_json};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::{ClothSystem, Scenario};
use carom::simulate::{resume, start, verify};
use serde_json::json;
use std::sync::Arc;

fn shots() -> impl Iterator<Item = (u64, Scenario, Run<f64, OnCloth>)> {
    (0..24).map(|seed| {
        let scenario = checked(&random_shot(seed));
        let run = played(&scenario);
        (seed, scenario, run)
    })
}

fn assert_same(a: &Run<f64, OnCloth>, b: &Run<f64, OnCloth>, what: &str) {
    assert_eq!(a.log.events, b.log.events, "{what}");
    assert_eq!(a.log.flights, b.log.flights, "{what}");
    assert_eq!((a.status, a.end_time.to_bits()), (b.status, b.end_time.to_bits()), "{what}");
    assert_eq!(bits(a), bits(b), "{what}");
}

fn saved_and_read(scenario: &Scenario, run: &Run<f64, OnCloth>) -> Run<f64, OnCloth> {
    from_json::<OnCloth>(&to_json(scenario, run).unwrap()).unwrap().1
}

#[test]
fn one_event_at_a_time_is_the_run_at_once() {
    for (seed, scenario, whole) in shots() {
        let (mut simulation, mut log) = start::<OnCloth>(&scenario, None);
        while simulation.step(&mut log).unwrap() {
            let coming = simulation.candidates();
            assert!(coming.iter().all(|next| next.time >= simulation.time()), "shot {seed}");
        }
        assert_same(&simulation.finish(log), &whole, &format!("shot {seed}"));
    }
}

#[test]
fn a_run_up_to_many_times_is_the_run_at_once() {
    for (seed, scenario, whole) in shots() {
        let mut random = Random::new(seed);
        let mut times: Vec<f64> = (0..20).map(|_| random.between(0.0, whole.end_time)).collect();
        times.extend(whole.log.events.iter().step_by(5).map(|event| event.time));
        times.sort_by(f64::total_cmp);
        let (mut simulation, mut log) = start::<OnCloth>(&scenario, None);
        for time in times {
            simulation.run_until(time, &mut log).unwrap();
            if simulation.status().is_none() {
                assert_eq!(simulation.state(), whole.state(time).unwrap(), "shot {seed} at {time}");
            }
        }
        simulation.run(&mut log).unwrap();
        assert_same(&simulation.finish(log), &whole, &format!("shot {seed}"));
    }
}

#[test]
fn a_resumed_run_is_the_run_at_once() {
    for (seed, scenario, whole) in shots() {
        let mut random = Random::new(seed);
        for k in 0..6 {
            let mut first = scenario.clone();
            let at = if k % 2 == 0 {
                random.between(0.0, whole.end_time)
            } else {
                random.choose(&whole.log.events).time
            };
            first.duration = Some(at);
            let part = saved_and_read(&first, &played(&first));
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same(&joined, &whole, &format!("shot {seed}, cut at {at}"));
        }
        for collisions in [0, 1, 2, 5, 13] {
            let mut first = scenario.clone();
            first.collisions = Some(collisions);
            let part = saved_and_read(&first, &played(&first));
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same(&joined, &whole, &format!("shot {seed}, after {collisions} collisions"));
        }
    }
}

#[test]
fn a_miscue_stays_one_when_the_run_is_resumed() {
    let scenario = checked(&random_shot(1)).with_values(&[("shot.a", json!(0.8))]).unwrap();
    let whole = played(&scenario);
    assert_eq!(whole.status, Status::Miscue);
    let joined = resume(&scenario, &saved_and_read(&scenario, &whole), None, &mut || false).unwrap();
    assert_same(&joined, &whole, "miscue");
}

#[test]
fn a_saved_run_verifies_and_a_wrong_bit_does_not() {
    for (seed, scenario, whole) in shots() {
        let mut saved = saved_and_read(&scenario, &whole);
        assert_same(&saved, &whole, &format!("shot {seed}"));
        assert_eq!(verify(&scenario, &saved, &mut || false).unwrap(), None, "shot {seed}");
        let middle = saved.log.events.len() / 2;
        saved.log.events[middle].time = f64::from_bits(saved.log.events[middle].time.to_bits() + 1);
        let difference = verify(&scenario, &saved, &mut || false).unwrap().expect("a wrong bit is found");
        assert_eq!(difference.place, format!("events[{middle}].time"), "shot {seed}");
    }
}

#[test]
fn a_reset_run_is_the_run_anew() {
    for (seed, scenario, whole) in shots() {
        let (mut simulation, _) = start::<OnCloth>(&scenario, None);
        simulation.advance(20, &mut carom::run::Nothing).unwrap();
        let mut log = carom::simulate::log_of(&scenario);
        simulation.reset(&mut log);
        simulation.run(&mut log).unwrap();
        assert_same(&simulation.finish(log), &whole, &format!("shot {seed}"));
    }
}

/// A cut shot with side that ends at a cushion: slides, rolls, a throw and a cushion.
fn cut_shot(phi_deg: f64) -> Scenario {
    let mut value = scene(&json!([ball("cue", [8.0, 0.0], &json!({})), ball("b", [8.6, 0.03], &json!({}))]));
    value["physics"]["ball_ball"] = json!({ "law": "frictional", "normal": 0.95 });
    value["physics"]["ball_cushion"] = json!({ "law": "han_2005", "normal": 0.85, "friction": 0.2 });
    value["shot"] = json!({ "cue_ball": "cue", "V0": 2.5, "phi_deg": phi_deg, "a": 0.2, "b": 0.1 });
    checked(&value)
}

/// The shot in other numbers, of which those of one place are made by `variable`.
fn states_in<S: Scalar>(
    scenario: &Scenario,
    variable: impl Fn(&str, f64) -> S,
) -> (u64, Vec<SphereState<S>>) {
    let system = ClothSystem::<S>::with(scenario, &mut |place, value| variable(&place.to_string(), value));
    let limits = Limits { duration: None, collisions: None, max_events: 1000, until: None };
    let mut log = Log::new(true, true);
    let mut simulation = Simulation::<S, Spheres<S>>::new(Arc::new(system), limits, &mut log);
    simulation.run(&mut log).unwrap();
    let run = simulation.finish(log);
    assert_eq!(run.status.name(), "at_rest");
    (run.diagnostics.collisions(), run.final_state())
}

#[test]
fn the_derivative_by_the_direction_of_a_shot_is_that_of_differences() {
    let (phi, step) = (1.0, 1e-5);
    let dual = |place: &str, value: f64| {
        if place == "shot.phi_deg" { Dual::<1>::variable(value, 0) } else { Dual::from_f64(value) }
    };
    let (collisions, states) = states_in(&cut_shot(phi), dual);
    assert!(collisions >= 3, "balls and cushions: {collisions}");
    let [low, high] = [-step, step].map(|change| played(&cut_shot(phi + change)).final_state());
    let plain = played(&cut_shot(phi)).final_state();
    for ball in 0..2 {
        let (found, at) = (states[ball].position, plain[ball].position);
        assert_eq!([found.x.value, found.y.value], [at.x, at.y], "the real part has the bits of f64");
        for (found, difference) in [
            (found.x.derivatives[0], high[ball].position.x - low[ball].position.x),
            (found.y.derivatives[0], high[ball].position.y - low[ball].position.y),
        ] {
            // Differences have an error of h² times a third derivative, and one of 1e-15/h = 1e-10.
            let expected = difference / (2.0 * step);
            assert!(
                (found - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                "ball {ball}: {found}, {expected}"
            );
            assert!(found != 0.0);
        }
    }
}

#[test]
fn twice_as_many_digits_give_the_same_shot() {
    let plain = played(&cut_shot(1.0)).final_state();
    let (_, states) = states_in(&cut_shot(1.0), |_, value| DoubleDouble::from_f64(value));
    for (found, plain) in states.iter().zip(&plain) {
        // Roundings of 1e-15 that a cut of two balls half a metre apart enlarges by 0.6/0.0286 and more.
        let place = found.position.to_f64();
        let at = plain.position.to_f64();
        for axis in 0..2 {
            assert!((place[axis] - at[axis]).abs() < 1e-11, "{place:?}, {at:?}");
        }
    }
}
