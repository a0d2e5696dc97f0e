//! What the fixed-step method says of itself is what happens between its steps.

use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, random_balls, rectangle, scenario};
use carom::run::Run;
use carom::simulate::simulate;
use serde_json::{Value, json};

fn stepped(balls: &[Ball], method: &Value, duration: f64) -> Run<f64> {
    let exact = scenario(&rectangle(1.0, 1.5), &json!({}), balls);
    let changes = [("method", method.clone()), ("duration", json!(duration))];
    let scenario = exact.with_values(&changes).unwrap();
    simulate(&scenario).unwrap()
}

/// The deepest overlap in `count` states of each step, and the farthest that two balls approach from one to the next.
fn sampled(run: &Run<f64>, balls: &[Ball], count: usize) -> (f64, f64) {
    let (mut deepest, mut resolution) = (0.0, 0.0);
    let steps = &run.steps.as_ref().unwrap().steps;
    for pair in steps.windows(2) {
        let length = pair[1].time - pair[0].time;
        let fastest = pair[0].balls.iter().map(|s| s.velocity.norm()).fold(0.0, f64::max);
        resolution = f64::max(resolution, 2.0 * fastest * length / count as f64);
        for k in 0..count {
            let states = run.state(pair[0].time + length * k as f64 / count as f64).unwrap();
            for a in 0..balls.len() {
                for b in a + 1..balls.len() {
                    let apart = (states[a].position - states[b].position).norm();
                    deepest = f64::max(deepest, balls[a].radius + balls[b].radius - apart);
                }
            }
        }
    }
    (deepest, resolution)
}

#[test]
fn the_deepest_overlap_is_that_of_the_motion_within_the_steps() {
    let mut overlapping = 0;
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let balls = random_balls(&mut random, &rectangle(1.0, 1.5), 6, [0.05, 0.12], [0.5, 2.0]);
        let after_hit = ["wait", "restart"][seed as usize % 2];
        let dt = [0.3, 0.1, 0.03][seed as usize % 3];
        let run = stepped(&balls, &json!({ "kind": "stepped", "dt": dt, "after_hit": after_hit }), 3.0);
        let (deepest, resolution) = sampled(&run, &balls, 200);
        let said = run.diagnostics.deepest_overlap;
        assert!(said >= deepest - 1e-12, "seed {seed}: {said} for {deepest}");
        assert!(said <= deepest + resolution, "seed {seed}: {said} for {deepest} +- {resolution}");
        overlapping += u32::from(deepest > 1e-3);
    }
    assert!(overlapping > 10, "only {overlapping} runs have overlaps");
}

#[test]
fn a_ball_that_passes_through_another_within_one_step_is_seen() {
    let balls = [ball(0.05, [0.2, 0.5], [1.0, 0.0]), ball(0.05, [0.5, 0.53], [0.0, 0.0])];
    let run = stepped(&balls, &json!({ "kind": "stepped", "dt": 0.6 }), 0.6);
    assert_eq!(run.log.events.len(), 0);
    assert!((run.diagnostics.deepest_overlap - 0.07).abs() < 1e-15, "{}", run.diagnostics.deepest_overlap);
}
