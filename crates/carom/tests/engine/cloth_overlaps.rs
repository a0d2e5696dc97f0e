//! Recorded flights looked at densely: no two balls overlap at any time, and where balls meet they touch.

use crate::kit::cloth::{random_shot, run};
use carom::flight::SphereState;
use carom::run::{Kind, OnCloth, Run};

/// Looks between two events.
const LOOKS: u32 = 6;

/// The distance of two balls' surfaces, over their radius.
fn gap(run: &Run<f64, OnCloth>, states: &[SphereState<f64>], a: usize, b: usize) -> f64 {
    let radii = run.system.spheres[a].radius + run.system.spheres[b].radius;
    ((states[a].position - states[b].position).norm() - radii) / radii
}

#[test]
fn no_two_balls_overlap_between_events_and_at_events_they_touch() {
    let (mut looks, mut meetings) = (0_u64, 0_u64);
    for seed in 0..100 {
        let run = run(&random_shot(seed));
        let mut times: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
        times.insert(0, 0.0);
        times.push(run.end_time);
        for pair in times.windows(2) {
            for look in 0..LOOKS {
                let time = pair[0] + (pair[1] - pair[0]) * f64::from(look) / f64::from(LOOKS);
                let states = run.state(time).unwrap();
                for a in 0..states.len() {
                    for b in 0..a {
                        if states[a].motion.is_out() || states[b].motion.is_out() {
                            continue;
                        }
                        // Places are exact to some roundings of the table's size, 3.6 m or 100 radii.
                        let gap = gap(&run, &states, a, b);
                        assert!(gap > -1e-12, "shot {seed}: balls {a} and {b} overlap at {time}: {gap:e}");
                        looks += 1;
                    }
                }
            }
        }
        for event in run.log.events.iter().filter(|event| event.kind == Kind::BallBall) {
            let states = run.state(event.time).unwrap();
            let gap = gap(&run, &states, event.ball_a as usize, event.ball_b.unwrap() as usize);
            // A meeting in a cluster may be that of balls within the tolerance δ of touching.
            let most = if event.cluster.is_some() { 1e-8 } else { 1e-12 };
            assert!(gap.abs() <= most, "shot {seed}: {event:?} at a gap of {gap:e}");
            meetings += 1;
        }
    }
    assert!(looks > 100_000 && meetings > 500, "{looks} looks, {meetings} meetings");
}
