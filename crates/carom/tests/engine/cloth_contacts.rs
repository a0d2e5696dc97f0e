//! Meetings of balls on the cloth in whole runs: of two, of three, and of a rack.

use crate::kit::cloth::{RADIUS, ball, bits, checked, play, run, scene};
use crate::kit::random::Random;
use carom::geometry::Vec2;
use carom::run::{Kind, OnCloth, Run};
use serde_json::{Value, json};

/// The velocities just after the first meeting, in plan.
fn after(run: &Run<f64, OnCloth>) -> (Vec<Vec2<f64>>, Vec<Vec2<f64>>) {
    let hit = run.log.events.iter().find(|event| event.kind == Kind::BallBall).unwrap().time;
    let plan =
        |time: f64| run.state(time).unwrap().iter().map(|s| s.twist.velocity.plan()).collect::<Vec<_>>();
    // Before the hit balls still roll as on the flight that ends with it.
    let before = (0..run.balls.len()).map(|ball| {
        let mut of_ball =
            run.log.flights.iter().filter(|(b, flight)| *b as usize == ball && flight.start() < hit);
        let flight = of_ball.next_back().map_or(run.log.flights[ball].1, |(_, flight)| *flight);
        flight.velocity_after(hit - flight.start()).plan()
    });
    (before.collect(), plan(hit))
}

fn angle_deg(a: Vec2<f64>, b: Vec2<f64>) -> f64 {
    a.cross(b).atan2(a.dot(b)).to_degrees()
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found}, expected {expected}");
}

/// A cue ball that meets another at a cut angle, with this spin times the radius over its speed, after 1e-9 of a radius.
fn cut(cut_deg: f64, speed: f64, roll: f64, law: &Value) -> Value {
    let (sin, cos) = cut_deg.to_radians().sin_cos();
    let gap = 2.0 * RADIUS * (1.0 + 1e-9);
    let mut value = scene(&json!([
        ball("cue", [0.0, 0.0], &json!({ "velocity": [speed, 0], "spin": [0, roll * speed / RADIUS, 0] })),
        ball("b", [gap * cos, gap * sin], &json!({})),
    ]));
    value["physics"]["ball_ball"] = law.clone();
    value
}

#[test]
fn a_stun_shot_parts_at_ninety_degrees_and_less_with_losses() {
    for cut_deg in [10.0, 30.0, 50.0, 70.0] {
        let (_, velocities) = after(&play(&cut(cut_deg, 1.0, 0.0, &json!({ "law": "elastic" }))));
        near(angle_deg(velocities[0], velocities[1]).abs(), 90.0, 1e-6, "B1");
    }
    let law = json!({ "law": "restitution", "normal": 0.95 });
    let (before, velocities) = after(&play(&cut(30.0, 1.0, 0.0, &law)));
    let speed = before[0].norm();
    near(angle_deg(velocities[0], velocities[1]).abs(), 87.5206, 1e-4, "B1");
    near(velocities[0].norm() / speed, 0.50047, 1e-5, "cue ball");
    near(velocities[1].norm() / speed, 0.84437, 1e-5, "object ball");
}

#[test]
fn a_rolling_cue_ball_ends_up_some_thirty_degrees_off() {
    for speed in [1.0, 5.0] {
        for (fullness, expected) in [(0.5, 33.6705), (0.25, 27.2669), (0.75, 27.6265)] {
            let cut_deg = f64::asin(1.0 - fullness).to_degrees();
            let run = play(&cut(cut_deg, speed, 1.0, &json!({ "law": "elastic" })));
            let rolls = run.log.events.iter().find(|e| e.kind == Kind::SlideToRoll && e.ball_a == 0).unwrap();
            let velocity = run.state(rolls.time).unwrap()[0].twist.velocity.plan();
            // A gap of 1e-9 of a radius moves the contact by as much.
            near(angle_deg(velocity, Vec2::new(1.0, 0.0)).abs(), expected, 1e-4, "B2");
        }
    }
}

#[test]
fn a_straight_rolling_shot_leaves_two_and_five_sevenths() {
    for (law, [cue, object]) in [
        (json!({ "law": "elastic" }), [2.0 / 7.0, 5.0 / 7.0]),
        (json!({ "law": "restitution", "normal": 0.95 }), [0.303_571, 0.696_429]),
    ] {
        let run = play(&cut(0.0, 1.0, 1.0, &law));
        let (before, _) = after(&run);
        for (ball, expected) in [(0, cue), (1, object)] {
            let rolls =
                run.log.events.iter().find(|e| e.kind == Kind::SlideToRoll && e.ball_a == ball).unwrap();
            let velocity = run.state(rolls.time).unwrap()[ball as usize].twist.velocity;
            near(velocity.x / before[0].x, expected, 1e-6, "B3");
        }
    }
}

/// Balls at rest and a cue ball at unit speed towards them, with a law for several contacts.
fn several(balls: &[[f64; 2]], cluster: &str) -> Vec<Vec2<f64>> {
    let mut entries = vec![ball("cue", [0.0, 0.0], &json!({ "velocity": [1, 0] }))];
    for (k, place) in balls.iter().enumerate() {
        entries.push(ball(&k.to_string(), *place, &json!({})));
    }
    let mut value = scene(&json!(entries));
    value["physics"]["ball_ball"] = json!({ "law": "elastic" });
    value["physics"]["cluster"] = json!(cluster);
    value["duration"] = json!(1e-4);
    let run = play(&value);
    // The last contact of all, as pairs meet one after the other.
    let last = run.log.events.iter().rfind(|event| event.kind == Kind::BallBall).unwrap();
    run.state(last.time).unwrap().iter().map(|state| state.twist.velocity.plan()).collect()
}

#[test]
fn one_ball_into_two_that_touch() {
    let gap = 2.0 * RADIUS * (1.0 + 1e-9);
    let half = RADIUS;
    let place = [gap * 0.75_f64.sqrt(), half];
    let two = [place, [place[0], -half]];
    for cluster in ["hertz", "reflections"] {
        let found = several(&two, cluster);
        near(found[0].x, -0.2, 1e-4, cluster);
        near(found[0].y, 0.0, 1e-9, cluster);
        for ball in [1, 2] {
            near(found[ball].norm(), 0.6928, 1e-4, cluster);
            near(angle_deg(found[ball], Vec2::new(1.0, 0.0)).abs(), 30.0, 1e-3, cluster);
        }
    }
    let mut speeds: Vec<f64> = several(&two, "pairwise").iter().map(|velocity| velocity.norm()).collect();
    speeds[1..].sort_by(f64::total_cmp);
    for (found, expected) in speeds.into_iter().zip([0.25, 0.4330, 0.8660]) {
        near(found, expected, 1e-4, "pairwise");
    }
}

#[test]
fn three_balls_in_line() {
    let line = [[2.0 * RADIUS * (1.0 + 1e-9), 0.0], [4.0 * RADIUS * (1.0 + 1e-9), 0.0]];
    for (cluster, expected) in [
        ("hertz", [-0.0710, 0.0764, 0.9945]),
        ("reflections", [0.0, 0.0, 1.0]),
        ("pairwise", [0.0, 0.0, 1.0]),
    ] {
        for (found, expected) in several(&line, cluster).into_iter().zip(expected) {
            near(found.x, expected, 1e-3, cluster);
            near(found.y, 0.0, 1e-12, cluster);
        }
    }
}

/// Fifteen frozen balls in rows from the apex at the origin towards +y, and a cue ball that comes straight up to it.
fn rack(speed: f64) -> Vec<Value> {
    let mut balls = vec![ball("cue", [0.0, -3.0 * RADIUS], &json!({ "velocity": [0, speed] }))];
    for row in 0..5 {
        for place in 0..=row {
            let at = [f64::from(2 * place - row) * RADIUS, f64::from(row) * 3.0_f64.sqrt() * RADIUS];
            balls.push(ball(&balls.len().to_string(), at, &json!({})));
        }
    }
    balls
}

fn broken(balls: &[Value], cluster: &str, frictional: bool) -> Value {
    let mut value = scene(&json!(balls));
    let elastic = json!({ "law": "elastic" });
    value["physics"]["ball_ball"] =
        if frictional { json!({ "law": "frictional", "normal": 0.95 }) } else { elastic };
    value["physics"]["cluster"] = json!(cluster);
    value
}

#[test]
fn the_perfect_break_sends_the_corners_off_at_half_the_speed() {
    let mut value = broken(&rack(10.0), "hertz", false);
    value["duration"] = json!(0.005);
    let run = play(&value);
    let (_, velocities) = after(&run);
    near(velocities[0].y, -1.79, 0.01, "cue ball");
    for (ball, side) in [(11, -1.0), (15, 1.0)] {
        near(velocities[ball].norm(), 5.60, 0.01, "corner");
        near(angle_deg(Vec2::new(0.0, -1.0), velocities[ball]), side * 150.0, 0.2, "corner");
    }
    near(velocities[13].y, 2.63, 0.01, "middle of the last row");
}

#[test]
fn a_centred_break_is_its_own_mirror_image() {
    for frictional in [false, true] {
        for cluster in ["hertz", "reflections"] {
            let mut value = broken(&rack(8.0), cluster, frictional);
            value["duration"] = json!(0.05);
            let states = play(&value).final_state();
            for row in 0..5_usize {
                let first = 1 + row * (row + 1) / 2;
                for place in 0..=row {
                    let [a, b] = [states[first + place], states[first + row - place]];
                    let (x, y) = (a.position, b.position);
                    assert!((x.x + y.x).abs() < 1e-9 && (x.y - y.y).abs() < 1e-9, "{cluster}: {a:?}, {b:?}");
                    let (x, y) = (a.twist.velocity, b.twist.velocity);
                    assert!((x.x + y.x).abs() < 1e-9 && (x.y - y.y).abs() < 1e-9, "{cluster}: {a:?}, {b:?}");
                }
            }
        }
    }
}

#[test]
fn balls_may_be_numbered_in_any_order() {
    let balls = rack(8.0);
    for (cluster, frictional) in
        [("hertz", true), ("hertz", false), ("reflections", true), ("pairwise", true)]
    {
        let whole = bits(&play(&broken(&balls, cluster, frictional)));
        for seed in 0..6 {
            let order = Random::new(seed).permutation(balls.len());
            let mixed: Vec<Value> = order.iter().map(|&ball| balls[ball].clone()).collect();
            let found = bits(&run(&checked(&broken(&mixed, cluster, frictional))));
            for (place, &ball) in order.iter().enumerate() {
                assert_eq!(found[place], whole[ball], "{cluster}, seed {seed}, ball {ball}");
            }
        }
    }
}
