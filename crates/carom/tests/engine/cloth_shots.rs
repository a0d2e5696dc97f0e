//! Random shots against brute force, struck balls, and runs in other number types.

use crate::kit::cloth::{
    ClothRun, MASS, RADIUS, at, between, bits_of, checked, deepest_overlap, energy, first, on_table, run,
    sampled_times, still, strewn_shot, wide,
};
use crate::kit::random::Random;
use carom::engine::{Limits, Simulation, Spheres};
use carom::flight::Motion;
use carom::geometry::{Vec2, Vec3};
use carom::model::Face;
use carom::run::{Event, Kind, Log, OnCloth, Run, Status};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::ClothSystem;
use serde_json::{Value, json};
use std::sync::Arc;

#[test]
fn between_the_events_of_strewn_shots_nothing_overlaps() {
    for seed in 0..150 {
        let value = strewn_shot(seed);
        let run = run(&value);
        let tolerance = run.system.tolerance.of(2.0 * run.system.spheres[0].radius);
        let deepest = deepest_overlap(&run, 12);
        assert!(deepest <= tolerance, "seed {seed}: {deepest:e} deep\n{value}");
    }
}

/// The gap at an event, in which the two that meet touch.
fn gap(run: &ClothRun, event: &Event<f64>) -> Option<f64> {
    let states = at(run, event.time);
    let (a, system) = (event.ball_a as usize, &run.system);
    let (place, radius) = (states[a].position, system.spheres[a].radius);
    match event.kind {
        Kind::BallBall => {
            let b = event.ball_b? as usize;
            Some((states[b].position - place).norm() - radius - system.spheres[b].radius)
        }
        Kind::BallCushion => {
            let face = &system.faces[event.cushion? as usize];
            let across = match face {
                Face::Line(line) => (place.plan() - line.start).dot(line.along.left()),
                Face::Round(round) => ((place.plan() - round.arc.center).norm() - round.arc.radius).abs(),
            };
            let nose = system.noses[a];
            // On the cloth the nose is touched where it is; `reach` says so even for the one that is met in plan.
            let on_cloth = place.z <= radius * (1.0 + 1e-12);
            let in_air = libm::hypot(across, place.z - nose.height) - radius;
            Some(if on_cloth { across - nose.reach } else { in_air })
        }
        _ => None,
    }
}

#[test]
fn whatever_meets_in_strewn_shots_touches_and_closes() {
    let mut contacts = 0;
    for seed in 0..150 {
        let value = strewn_shot(seed);
        let run = run(&value);
        let tolerance = run.system.tolerance.of(2.0 * run.system.spheres[0].radius);
        for (k, event) in run.log.events.iter().enumerate() {
            let Some(gap) = gap(&run, event) else { continue };
            // A cluster takes in what is a hair apart.
            let hair = if event.cluster.is_some() { 1e4 } else { 1.0 };
            assert!(gap.abs() <= hair * tolerance, "seed {seed}, event {k}: gap {gap:e}, {event:?}\n{value}");
            // What is pressed together need not close by more than round-off.
            let closes = event.closing_speed > -1e-13 || event.cluster.is_some();
            assert!(closes, "seed {seed}, event {k}: {event:?}");
            assert!(event.impulse >= 0.0, "seed {seed}, event {k}: {event:?}");
            contacts += 1;
        }
    }
    assert!(contacts > 500, "{contacts}");
}

#[test]
fn a_struck_ball_rolls_in_the_end_along_coriolis_line() {
    let mut random = Random::new(12);
    for case in 0..300 {
        let (radius, angle) = (0.5 * random.unit().sqrt(), random.between(0.0, 360.0).to_radians());
        let (left, top) = (radius * libm::cos(angle), radius * libm::sin(angle));
        let (heading, elevation) = (random.between(0.0, 360.0), random.between(20.0, 85.0));
        let sliding = random.between(0.05, 0.5);
        let mut value = wide(&json!({}), &[still("cue", [20.0, 20.0])]);
        value["ball_defaults"]["sliding_friction"] = json!(sliding);
        value["cue"] = json!({ "end_mass": 0.0 });
        value["shot"] = json!({ "V0": random.between(0.5, 4.0), "phi_deg": heading, "theta_deg": elevation,
            "a": left, "b": top });
        let run = run(&value);
        // The cue comes along d; l points to the shooter's left, and u up, across both.
        let [(c, s), (cos, sin)] =
            [heading, elevation].map(|a| (libm::cos(a.to_radians()), libm::sin(a.to_radians())));
        let d = Vec3::new(cos * c, cos * s, -sin);
        let l = Vec3::new(-s, c, 0.0);
        let u = Vec3::new(sin * c, sin * s, cos);
        let r = (l * left + u * top - d * (1.0 - left * left - top * top).sqrt()) * RADIUS;
        let impulse = first(&run, Kind::CueBall, 0).impulse;
        // From the ball's resting point to where the axis of the cue meets the cloth.
        let aim = r.plan() - d.plan() * ((RADIUS + r.z) / d.z);
        let rolls = run.log.flights.iter().find(|(_, flight)| flight.motion == Motion::Rolling);
        let Some((_, rolls)) = rolls else {
            assert!(aim.norm() < 0.01 * RADIUS, "case {case}");
            continue;
        };
        let velocity = rolls.plan.velocity;
        let expected = aim * (5.0 * impulse * sin / (7.0 * MASS * RADIUS));
        assert!(
            (velocity - expected).norm() < 1e-12 * (1.0 + impulse / MASS),
            "case {case}: {velocity:?} {expected:?}"
        );
        assert!(between(velocity, aim).abs() < 1e-8, "case {case}");
    }
}

/// A cut shot that meets a cushion or two.
fn cut_shot() -> Value {
    let balls = [still("cue", [0.5, 0.5]), still("1", [0.6, 1.1])];
    let mut value = on_table(
        &json!({ "preset": "carom_10ft" }),
        &json!({ "ball_ball": { "law": "frictional", "normal": 0.95 },
            "ball_cushion": { "law": "han_2005", "normal": 0.85, "friction": 0.2 } }),
        &balls,
    );
    value["shot"] = json!({ "V0": 2.5, "phi_deg": 78.0, "a": 0.2, "b": 0.2 });
    value
}

fn run_in<S: Scalar>(value: &Value, number: impl Fn(&str, f64) -> S) -> Run<S, OnCloth> {
    let scenario = checked(value);
    let system = ClothSystem::<S>::with(&scenario, &mut |place, value| number(&place.to_string(), value));
    let limits = Limits { duration: None, collisions: None, max_events: 100_000, until: None };
    let mut log = Log::new(true, true);
    let mut simulation: Simulation<S, Spheres<S>> = Simulation::new(Arc::new(system), limits, &mut log);
    assert_eq!(simulation.run(&mut log).unwrap(), Status::AtRest);
    simulation.finish(log)
}

/// Where the object ball comes to rest.
fn resting_place(value: &Value, key: &str, number: f64) -> Vec2<f64> {
    let mut value = value.clone();
    value["shot"][key] = json!(number);
    run(&value).final_state()[1].position.plan()
}

#[test]
fn the_resting_place_of_the_object_ball_has_exact_derivatives_by_the_shot() {
    let value = cut_shot();
    let plain = run(&value);
    assert!(plain.diagnostics.collisions() >= 3, "it meets cushions too: {:?}", plain.log.events);
    for (key, at, step) in [("phi_deg", 78.0, 1e-5), ("V0", 2.5, 1e-6), ("a", 0.2, 1e-6)] {
        let name = format!("shot.{key}");
        let variable = |place: &str, value: f64| {
            if place == name { Dual::<1>::variable(value, 0) } else { Dual::constant(value) }
        };
        let dual = run_in(&value, variable);
        let place = dual.final_state()[1].position;
        let [ahead, behind] = [at + step, at - step].map(|number| resting_place(&value, key, number));
        for (coordinate, ahead, behind, real) in [
            (place.x, ahead.x, behind.x, plain.final_state()[1].position.x),
            (place.y, ahead.y, behind.y, plain.final_state()[1].position.y),
        ] {
            assert_eq!(coordinate.value.to_bits(), real.to_bits(), "the real part is the plain run");
            let difference = (ahead - behind) / (2.0 * step);
            let derivative = coordinate.derivatives[0];
            // A difference of places rounded to 1e-15 and amplified some 1e3 times, and its third derivative times step².
            let tolerance = 1e-12 / step + 1e-5 * derivative.abs();
            assert!((derivative - difference).abs() < tolerance, "{key}: {derivative} for {difference}");
            assert!(derivative.abs() > 1e-6, "{key}");
        }
    }
}

#[test]
fn twice_the_digits_give_the_same_shot() {
    let value = cut_shot();
    let plain = run(&value);
    let twin = run_in(&value, |_, value| DoubleDouble::from_f64(value));
    let kinds = |events: Vec<Kind>| events;
    let of_plain = kinds(plain.log.events.iter().map(|event| event.kind).collect());
    let of_twin = kinds(twin.log.events.iter().map(|event| event.kind).collect());
    assert_eq!(of_plain, of_twin);
    for (a, b) in plain.log.events.iter().zip(&twin.log.events) {
        // Round-off of 1e-16, amplified at one meeting of balls and at cushions.
        assert!((a.time - b.time.to_f64()).abs() < 1e-11, "{a:?}");
    }
    for (a, b) in plain.final_state().iter().zip(twin.final_state()) {
        let [x, y, z] = b.position.to_f64();
        assert!((a.position - Vec3::new(x, y, z)).norm() < 1e-11);
    }
    let [initial, gain] = [twin.diagnostics.initial_energy, twin.diagnostics.energy_gain];
    assert!(gain <= 1e-30 * initial, "{gain:e}");
}

#[test]
fn the_numbers_of_balls_change_no_bit_of_a_shot() {
    for seed in 0..80 {
        let value = strewn_shot(seed);
        let plain = run(&value);
        let expected = bits_of(&plain.final_state());
        let mut random = Random::new(seed);
        for _ in 0..2 {
            let balls = value["balls"].as_array().unwrap();
            let order = random.permutation(balls.len());
            let mut other = value.clone();
            other["balls"] = order.iter().map(|&k| balls[k].clone()).collect();
            let other = run(&other);
            let found = bits_of(&other.final_state());
            for (place, &ball) in order.iter().enumerate() {
                assert_eq!(
                    found[place], expected[ball],
                    "seed {seed}, ball {ball} as number {place}\n{value}"
                );
            }
            assert_eq!(other.diagnostics.events, plain.diagnostics.events, "seed {seed}");
        }
    }
}

#[test]
fn a_run_that_ends_in_a_miscue_has_one_event_and_no_motion() {
    let mut value = cut_shot();
    value["shot"]["a"] = json!(0.7);
    let run = run(&value);
    assert_eq!(run.status, Status::Miscue);
    assert_eq!(run.log.events.iter().map(|event| event.kind).collect::<Vec<_>>(), [Kind::Miscue]);
    assert!(run.final_state().iter().all(|state| state.motion == Motion::Resting));
}

#[test]
fn energy_never_rises_in_strewn_shots() {
    for seed in 0..150 {
        let value = strewn_shot(seed);
        let run = run(&value);
        let scale = run.diagnostics.initial_energy;
        // Each energy is a sum of up to seven balls' terms, each with some ten roundings.
        let tolerance = 1e-14 * scale;
        let mut last = f64::INFINITY;
        for time in sampled_times(&run, 3) {
            let now = energy(&run, time);
            let out = run.state(time).unwrap().iter().filter(|state| state.motion.is_out()).count();
            assert!(now <= last + tolerance, "seed {seed}, {time}, {out} out: {now} after {last}\n{value}");
            last = now;
        }
        assert!(run.diagnostics.energy_gain <= tolerance, "seed {seed}: {:?}", run.diagnostics);
        assert!(run.diagnostics.energy_drift <= 1e-12 * scale, "seed {seed}: {:?}", run.diagnostics);
    }
}

/// Friction holds the balls on each other and the smaller one on the cloth, where each hold leans on the other.
#[test]
fn energy_does_not_rise_where_friction_holds_two_balls_and_one_of_them_on_the_cloth() {
    let run = run(&json!({
        "max_events": 1,
        "table": { "preset": "english_pool" },
        "physics": {
            "flight": { "law": "cloth", "restitution": 0.0, "friction": 1.0 },
            "ball_ball": { "law": "mathavan_2014", "normal": 1.0, "friction": 1.0 },
        },
        "balls": [
            { "id": "a", "radius": 0.03425278010748897, "mass": 1.2570362559609929, "sliding_friction": 0.2,
                "position": [0.1654249177831818, 1.6164376829581304],
                "velocity": [1.2303310474621918, -1.40916360952688],
                "spin": [21.73908098111483, 5.424191156897429, 31.75149234743116] },
            { "id": "b", "radius": 0.020945926856446535, "mass": 0.5050443906394976, "sliding_friction": 1.0,
                "position": [0.21869174538141084, 1.6107394389596523],
                "velocity": [-0.03524374493819969, -0.03335300889119509, -0.021373379353292424] },
        ],
    }));
    let found = &run.diagnostics;
    assert_eq!(run.log.events[0].kind, Kind::BallBall);
    assert!(found.energy_gain <= 1e-14 * found.initial_energy, "{found:?}");
}
