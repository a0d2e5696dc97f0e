//! Several balls in touch on a cloth, struck in whole runs, by each law of clusters.

use crate::kit::cloth::{
    ClothRun, RADIUS, at, bits_of, checked, deepest_overlap, run_until, still, stun, wide,
};
use crate::kit::random::Random;
use crate::kit::scenes::rack;
use carom::flight::SphereState;
use carom::geometry::Vec2;
use carom::run::{Kind, OnCloth};
use carom::simulate::simulate_until;
use serde_json::{Value, json};

fn at_contact(cluster: &str, balls: &[Value]) -> Vec<Vec2<f64>> {
    let run = run_until(&wide(&json!({ "cluster": cluster }), balls), Some(Kind::BallBall));
    at(&run, run.end_time).iter().map(|state| state.twist.velocity.plan()).collect()
}

/// A ball that touches two that touch each other, and moves between them.
fn into_two() -> Vec<Value> {
    let (x, y) = (2.0 * RADIUS * 0.75_f64.sqrt(), RADIUS);
    vec![
        stun("cue", [20.0, 20.0], [1.0, 0.0]),
        still("upper", [20.0 + x, 20.0 + y]),
        still("lower", [20.0 + x, 20.0 - y]),
    ]
}

#[test]
fn one_ball_into_two_comes_back_with_a_fifth_of_its_speed() {
    for cluster in ["hertz", "reflections"] {
        let velocities = at_contact(cluster, &into_two());
        assert!((velocities[0].x + 0.2).abs() < 1e-4 && velocities[0].y.abs() < 1e-9, "{velocities:?}");
        for (ball, side) in [(1, 1.0), (2, -1.0)] {
            let v = velocities[ball];
            assert!((v.norm() - 0.6928).abs() < 1e-4, "{cluster}: {velocities:?}");
            assert!((libm::atan2(v.y, v.x).to_degrees() - side * 30.0).abs() < 1e-4);
        }
    }
    let pairwise = at_contact("pairwise", &into_two());
    let mut speeds = [pairwise[1].norm(), pairwise[2].norm()];
    speeds.sort_by(f64::total_cmp);
    assert!((speeds[1] - 0.8660).abs() < 1e-4 && (speeds[0] - 0.4330).abs() < 1e-4, "{pairwise:?}");
    assert!((pairwise[0].x + 0.125).abs() < 1e-4 && (pairwise[0].y.abs() - 0.2165).abs() < 1e-4);
}

#[test]
fn one_ball_into_two_in_line_leaves_some_speed_behind_by_hertz_alone() {
    let row = |k: u32| still(&k.to_string(), [20.0 + 2.0 * RADIUS * f64::from(k), 20.0]);
    let balls = [stun("cue", [20.0, 20.0], [1.0, 0.0]), row(1), row(2)];
    for (cluster, expected, tolerance) in [
        ("hertz", [-0.0710, 0.0764, 0.9945], 1e-3),
        ("reflections", [0.0, 0.0, 1.0], 1e-14),
        ("pairwise", [0.0, 0.0, 1.0], 1e-14),
    ] {
        let found = at_contact(cluster, &balls);
        for (v, expected) in found.iter().zip(expected) {
            assert!((v.x - expected).abs() <= tolerance && v.y.abs() < 1e-14, "{cluster}: {found:?}");
        }
        let momentum: f64 = found.iter().map(|v| v.x).sum();
        let energy: f64 = found.iter().map(|v| v.norm_squared()).sum();
        assert!((momentum - 1.0).abs() < 1e-14 && (energy - 1.0).abs() < 1e-13, "{cluster}: {found:?}");
    }
}

/// A frozen rack of 15 balls, numbered by rows, and a ball that touches the first and moves onto it.
fn break_shot(speed: f64, order: &[usize]) -> Value {
    let mut balls: Vec<Value> = rack(RADIUS, [20.0, 20.0], 5)
        .iter()
        .enumerate()
        .map(|(k, ball)| still(&(k + 1).to_string(), ball.position))
        .collect();
    balls.push(stun("cue", [20.0, 20.0 - 2.0 * RADIUS], [0.0, speed]));
    wide(&json!({}), &order.iter().map(|&k| balls[k].clone()).collect::<Vec<_>>())
}

fn in_order() -> Vec<usize> {
    (0..16).collect()
}

#[test]
fn a_centred_break_is_that_of_hertz() {
    let run = run_until(&break_shot(10.0, &in_order()), Some(Kind::BallBall));
    let states = at(&run, run.end_time);
    let velocity = |number: usize| states[number - 1].twist.velocity.plan();
    // Degrees from the way back to the shooter.
    let degrees = |v: Vec2<f64>| libm::atan2(v.x.abs(), -v.y).to_degrees();
    for (number, speed, angle) in [(16, 1.79, 0.0), (11, 5.60, 150.0), (15, 5.60, 150.0), (13, 2.63, 180.0)] {
        let v = velocity(number);
        assert!((v.norm() - speed).abs() < 0.01, "ball {number}: {v:?}");
        assert!((degrees(v) - angle).abs() < 0.2, "ball {number} at {} degrees", degrees(v));
    }
}

/// The place of each ball's mirror image in the rack.
fn mirror(k: usize) -> usize {
    let row = (0..5).find(|row| k < (row + 1) * (row + 2) / 2).unwrap_or(5);
    if row == 5 { k } else { row * (row + 1) / 2 + (row * (row + 3) / 2 - k) }
}

/// The largest difference between a rack and its mirror image.
fn asymmetry(states: &[SphereState<f64>]) -> f64 {
    let differences = (0..16).map(|k| {
        let [a, b] = [states[k], states[mirror(k)]];
        let [x, y] = [a.position.x + b.position.x - 40.0, a.position.y - b.position.y];
        let (v, w) = (a.twist.velocity, b.twist.velocity);
        x.abs().max(y.abs()).max((v.x + w.x).abs()).max((v.y - w.y).abs())
    });
    differences.fold(0.0, f64::max)
}

#[test]
fn a_centred_break_is_mirror_symmetric() {
    for speed in [1.0, 5.0, 10.0] {
        let mut scenario = checked(&break_shot(speed, &in_order()));
        scenario.duration = Some(0.5);
        let run: ClothRun = simulate_until(&scenario, None, &mut || false).unwrap();
        assert!(run.diagnostics.clusters >= 1);
        let first = asymmetry(&at(&run, 0.0));
        assert!(first < 1e-9, "{first:e} in the instant after the blow");
        let late = asymmetry(&run.final_state());
        assert!(late < 1e-9, "{late:e} half a second later, at speed {speed}");
        assert!(deepest_overlap(&run, 3) <= run.system.tolerance.of(2.0 * RADIUS));
    }
}

#[test]
fn a_break_does_not_depend_on_how_the_balls_are_numbered() {
    let mut random = Random::new(6);
    let whole = |order: &[usize]| -> ClothRun {
        let mut value = break_shot(9.0, order);
        // Off the centre, so that nothing is symmetric.
        let cue = order.iter().position(|&k| k == 15).unwrap();
        value["balls"][cue]["velocity"] = json!([0.37, 9.0]);
        simulate_until::<OnCloth>(&checked(&value), None, &mut || false).unwrap()
    };
    let plain = whole(&in_order());
    let expected = bits_of(&plain.final_state());
    for _ in 0..6 {
        let order = random.permutation(16);
        let other = whole(&order);
        let found = bits_of(&other.final_state());
        for (place, &ball) in order.iter().enumerate() {
            assert_eq!(found[place], expected[ball], "ball {ball} as number {place}");
        }
        assert_eq!(other.diagnostics.total_events(), plain.diagnostics.total_events());
    }
}
