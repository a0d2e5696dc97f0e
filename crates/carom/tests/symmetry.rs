//! What should not matter does not: the order of the balls, left and right, the units, and the direction of time.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod kit;

use carom::run::Run;
use carom::scenario::Scenario;
use carom::simulate::simulate;
use kit::random::Random;
use kit::scenes::{Ball, random_balls, rectangle, scenario};
use kit::{State, bits, bundled};
use serde_json::json;

const WIDTH: f64 = 1.3;
const LENGTH: f64 = 2.1;
const SEEDS: u64 = 40;

fn run_for(table: [f64; 2], balls: &[Ball], duration: f64) -> Run<f64> {
    let mut scenario = scenario(&rectangle(table[0], table[1]), &json!({}), balls);
    scenario.duration = Some(duration);
    simulate(&scenario).unwrap()
}

/// Random balls, and a time after so many collisions, in the middle between two.
fn scene(seed: u64, count: usize, collisions: usize) -> (Vec<Ball>, f64) {
    let table = rectangle(WIDTH, LENGTH);
    let balls = random_balls(&mut Random::new(seed), &table, count, [0.06, 0.12], [0.5, 2.0]);
    assert_eq!(balls.len(), count);
    let mut scenario = scenario(&table, &json!({}), &balls);
    scenario.duration = None;
    scenario.collisions = Some(collisions as u64 + 1);
    let events = simulate(&scenario).unwrap().log.events;
    (balls, 0.5 * (events[collisions - 1].time + events[collisions].time))
}

/// The largest difference of two states, each number in its own unit (of length, of velocity).
fn difference(a: &[State], b: &[State], length: f64, speed: f64) -> f64 {
    let of = |((x, v), (y, w)): (&State, &State)| {
        let place = (x.x - y.x).abs().max((x.y - y.y).abs()) / length;
        place.max((v.x - w.x).abs().max((v.y - w.y).abs()) / speed)
    };
    a.iter().zip(b).map(of).fold(0.0, f64::max)
}

fn map_states(states: &[State], length: f64, speed: f64) -> Vec<State> {
    states.iter().map(|&(x, v)| (x * length, v * speed)).collect()
}

fn scaled(balls: &[Ball], length: f64, time: f64) -> Vec<Ball> {
    let scale = |ball: &Ball| Ball {
        radius: ball.radius * length,
        mass: ball.mass,
        position: ball.position.map(|c| c * length),
        velocity: ball.velocity.map(|c| c * length / time),
    };
    balls.iter().map(scale).collect()
}

#[test]
fn the_order_of_the_balls_changes_no_bit() {
    let names = [
        "one_into_two",
        "triangle_break",
        "newtons_cradle",
        "fifty_random",
        "l_shape",
        "stadium",
        "sinai",
        "pinball",
    ];
    for name in names {
        let original = bundled(name);
        let known = simulate(&original).unwrap();
        let count = original.balls.len();
        let reverse: Vec<usize> = (0..count).rev().collect();
        let turned: Vec<usize> = (0..count).map(|k| (k + count.div_ceil(3)) % count).collect();
        for order in [reverse, turned] {
            let relabelled = Scenario {
                balls: order.iter().map(|&k| original.balls[k].clone()).collect(),
                ..original.clone()
            };
            let run = simulate(&relabelled).unwrap();
            assert_eq!(
                (run.status, run.end_time.to_bits()),
                (known.status, known.end_time.to_bits()),
                "{name}"
            );
            let states = known.final_state();
            let expected: Vec<State> = order.iter().map(|&k| states[k]).collect();
            assert_eq!(bits(&run.final_state()), bits(&expected), "{name} in the order {order:?}");
        }
    }
}

#[test]
fn the_mirror_image_runs_as_the_scene_does() {
    for seed in 0..SEEDS {
        let (balls, time) = scene(seed, 8, 30);
        let mirror = |ball: &Ball| Ball {
            position: [WIDTH - ball.position[0], ball.position[1]],
            velocity: [-ball.velocity[0], ball.velocity[1]],
            ..ball.clone()
        };
        let image: Vec<Ball> = balls.iter().map(mirror).collect();
        let mut found = run_for([WIDTH, LENGTH], &image, time).final_state();
        for (position, velocity) in &mut found {
            position.x = WIDTH - position.x;
            velocity.x = -velocity.x;
        }
        let far = difference(&found, &run_for([WIDTH, LENGTH], &balls, time).final_state(), 1.0, 1.0);
        // 1e-16 grows by some 2 l/r = 10 to 30 in each meeting of balls, of which each has about four: 1e-16 · 30^4 = 1e-10.
        assert!(far < 1e-9, "seed {seed}: {far:e}");
    }
}

#[test]
fn scaling_by_powers_of_two_scales_every_bit() {
    let (length, time) = (1024.0, 0.125);
    for seed in 0..SEEDS {
        let (balls, end) = scene(seed, 8, 30);
        let known = map_states(&run_for([WIDTH, LENGTH], &balls, end).final_state(), length, length / time);
        let table = [WIDTH * length, LENGTH * length];
        let found = run_for(table, &scaled(&balls, length, time), end * time).final_state();
        assert_eq!(bits(&found), bits(&known), "seed {seed}");
    }
}

#[test]
fn scaling_by_a_thousand_changes_round_off_only() {
    for seed in 0..SEEDS {
        let (balls, end) = scene(seed, 8, 30);
        let known = map_states(&run_for([WIDTH, LENGTH], &balls, end).final_state(), 1000.0, 1000.0);
        let found =
            run_for([WIDTH * 1000.0, LENGTH * 1000.0], &scaled(&balls, 1000.0, 1.0), end).final_state();
        let far = difference(&found, &known, 1000.0, 1000.0);
        // As for the mirror image.
        assert!(far < 1e-9, "seed {seed}: {far:e}");
    }
}

#[test]
fn time_turned_round_brings_every_ball_back() {
    for seed in 0..SEEDS {
        // A meeting of two balls is one for each, a cushion one for one: 15 rows make about two for each of ten.
        let (balls, end) = scene(seed, 10, 15);
        let there = run_for([WIDTH, LENGTH], &balls, end).final_state();
        let turn = |(ball, (position, velocity)): (&Ball, &State)| Ball {
            position: position.to_f64(),
            velocity: [-velocity.x, -velocity.y],
            ..ball.clone()
        };
        let turned: Vec<Ball> = balls.iter().zip(&there).map(turn).collect();
        let back = run_for([WIDTH, LENGTH], &turned, end).final_state();
        let back = map_states(&back, 1.0, -1.0);
        let first: Vec<State> = balls
            .iter()
            .map(|ball| {
                let vector = |[x, y]: [f64; 2]| carom::geometry::Vec2::new(x, y);
                (vector(ball.position), vector(ball.velocity))
            })
            .collect();
        let far = difference(&back, &first, 1.0, 1.0);
        // Two meetings there and two back: 1e-16 · 30^4 = 1e-10.
        assert!(far < 1e-9, "seed {seed}: {far:e}");
    }
}
