//! A run on a cloth in pieces is the run at once, to the last bit; and a saved one verifies.

use crate::kit::cloth::{ClothRun, bits_of, checked, random_shot};
use crate::kit::cue_sports;
use crate::kit::random::Random;
use carom::run::{Event, Kind, Log, Nothing, OnCloth, Status, from_json, to_json};
use carom::scenario::Scenario;
use carom::scenario::schema::Record;
use carom::simulate::{resume, simulate_until, start, verify};
use serde_json::json;

fn scenes() -> Vec<(String, Scenario)> {
    let mut scenes = cue_sports();
    scenes.extend((0..25).map(|seed| (format!("seed {seed}"), checked(&random_shot(seed)))));
    scenes
}

fn run(scenario: &Scenario) -> ClothRun {
    simulate_until(scenario, None, &mut || false).unwrap_or_else(|error| panic!("{error}"))
}

fn saved_and_read(scenario: &Scenario, run: &ClothRun) -> (Scenario, ClothRun) {
    from_json::<OnCloth>(&to_json(scenario, run).unwrap()).unwrap()
}

fn assert_same(a: &ClothRun, b: &ClothRun, what: &str) {
    for (k, (x, y)) in a.log.events.iter().zip(&b.log.events).enumerate() {
        assert_eq!(x, y, "{what}: event {k}");
    }
    assert_eq!(a.log.events.len(), b.log.events.len(), "{what}: number of events");
    assert_eq!(a.log.flights, b.log.flights, "{what}: flights");
    assert_eq!((a.status, a.end_time.to_bits()), (b.status, b.end_time.to_bits()), "{what}: end");
    assert_eq!(bits_of(&a.final_state()), bits_of(&b.final_state()), "{what}: final state");
    assert_eq!(a.diagnostics.events, b.diagnostics.events, "{what}: counts of events");
    assert_eq!(a.digest(), b.digest(), "{what}: digest");
}

#[test]
fn a_shot_cut_anywhere_is_the_shot_at_once() {
    for (k, (name, scenario)) in scenes().into_iter().enumerate() {
        let mut random = Random::new(k as u64);
        let whole = run(&scenario);
        for cut in 0..5 {
            let at = if cut % 2 == 0 {
                random.between(0.0, whole.end_time)
            } else {
                random.choose(&whole.log.events).time
            };
            let mut part = scenario.clone();
            part.duration = Some(at);
            let (_, first) = saved_and_read(&part, &run(&part));
            let joined = resume(&scenario, &first, None, &mut || false).unwrap();
            assert_same(&joined, &whole, &format!("{name}, cut at {at}"));
        }
    }
}

#[test]
fn a_shot_resumed_ten_times_is_the_shot_at_once() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        let mut part = scenario.clone();
        part.duration = Some(0.0);
        let mut so_far = run(&part);
        for k in 1..=10 {
            part.duration = Some(whole.end_time * f64::from(k) / 10.0);
            (_, so_far) = saved_and_read(&part, &so_far);
            so_far = resume(&part, &so_far, None, &mut || false).unwrap();
        }
        so_far = resume(&scenario, &so_far, None, &mut || false).unwrap();
        assert_same(&so_far, &whole, &name);
    }
}

#[test]
fn a_shot_resumed_after_the_first_event_of_any_kind_is_the_shot_at_once() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        for kind in Kind::ALL {
            let part: ClothRun = simulate_until(&scenario, Some(kind), &mut || false).unwrap();
            let joined = resume(&scenario, &part, None, &mut || false).unwrap();
            assert_same(&joined, &whole, &format!("{name}, after the first {}", kind.name()));
        }
    }
}

#[test]
fn a_miscue_stays_one_when_the_run_is_resumed() {
    let mut scenario = checked(&random_shot(0));
    scenario = scenario.with_values(&[("shot.a", json!(0.8))]).unwrap();
    let whole = run(&scenario);
    assert_eq!(whole.status, Status::Miscue);
    let (_, read) = saved_and_read(&scenario, &whole);
    let joined = resume(&scenario, &read, None, &mut || false).unwrap();
    assert_same(&joined, &whole, "miscue");
}

#[test]
fn one_event_at_a_time_and_up_to_many_times_is_the_shot_at_once() {
    for (k, (name, scenario)) in scenes().into_iter().enumerate() {
        let whole = run(&scenario);
        let (mut simulation, mut log) = start::<OnCloth>(&scenario, None);
        while simulation.step(&mut log).unwrap() {
            let coming = simulation.candidates();
            assert!(coming.iter().all(|next| next.time >= simulation.time()), "{name}: {coming:?}");
        }
        assert_same(&simulation.finish(log), &whole, &name);
        let mut random = Random::new(k as u64);
        let (mut simulation, mut log) = start::<OnCloth>(&scenario, None);
        let mut times: Vec<f64> = (0..20).map(|_| random.between(0.0, whole.end_time)).collect();
        times.sort_by(f64::total_cmp);
        for time in times {
            simulation.run_until(time, &mut log).unwrap();
            let due = |event: &&Event<f64>| event.time <= time;
            assert_eq!(log.events.len(), whole.log.events.iter().filter(due).count(), "{name}: up to {time}");
            let states = whole.state(time).unwrap();
            assert_eq!(bits_of(&simulation.state()), bits_of(&states), "{name}: the state at {time}");
        }
        simulation.run(&mut log).unwrap();
        assert_same(&simulation.finish(log), &whole, &name);
    }
}

#[test]
fn a_shot_played_anew_has_the_same_bits() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        let (mut simulation, _) = start::<OnCloth>(&scenario, None);
        for steps in [0, 1, 10, 100] {
            simulation.advance(steps, &mut Nothing).unwrap();
            let mut log = Log::new(true, true);
            simulation.reset(&mut log);
            let mut again = simulation.clone();
            again.run(&mut log).unwrap();
            let again = again.finish(log);
            assert_same(&again, &whole, &format!("{name}, after {steps} steps"));
            assert_eq!(again.diagnostics, whole.diagnostics, "{name}");
        }
    }
}

#[test]
fn what_a_run_keeps_changes_no_bit_of_it() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        for record in [Record::Events, Record::None] {
            let mut other = scenario.clone();
            other.record = record;
            let other = run(&other);
            assert_eq!((other.digest(), &other.diagnostics), (whole.digest(), &whole.diagnostics), "{name}");
        }
    }
}

#[test]
fn a_saved_shot_verifies_however_it_ended() {
    for (name, scenario) in scenes() {
        let whole = run(&scenario);
        let (read, saved) = saved_and_read(&scenario, &whole);
        assert_same(&saved, &whole, &name);
        assert_eq!(verify(&read, &saved, &mut || false).unwrap(), None, "{name}");
        for kind in [Kind::BallBall, Kind::BallCushion, Kind::SlideToRoll] {
            let part: ClothRun = simulate_until(&scenario, Some(kind), &mut || false).unwrap();
            assert_eq!(
                verify(&scenario, &part, &mut || false).unwrap(),
                None,
                "{name}, up to {}",
                kind.name()
            );
        }
        let broken_off: ClothRun = simulate_until(&scenario, None, &mut || true).unwrap();
        assert_eq!(verify(&scenario, &broken_off, &mut || false).unwrap(), None, "{name}, broken off");
    }
}

#[test]
fn a_single_wrong_bit_of_a_shot_is_found() {
    let scenario = checked(&random_shot(3));
    let whole = run(&scenario);
    let mut event = whole.clone();
    event.log.events[2].time = f64::from_bits(event.log.events[2].time.to_bits() ^ 1);
    let difference = verify(&scenario, &event, &mut || false).unwrap().unwrap();
    assert_eq!(difference.place, "events[2].time");
    let mut flight = whole.clone();
    let spin = &mut flight.log.flights[3].1.spin.x;
    *spin = f64::from_bits(spin.to_bits() ^ 1);
    let difference = verify(&scenario, &flight, &mut || false).unwrap().unwrap();
    assert!(difference.place.starts_with("flights[3]"), "{difference:?}");
}
