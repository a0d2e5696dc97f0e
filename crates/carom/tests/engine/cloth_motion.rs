//! Single balls on the cloth and in the air, in whole runs: against the closed forms of the motion.

use crate::kit::cloth::{RADIUS, ball, energy, no_higher, only, run, scene};
use crate::kit::random::Random;
use carom::flight::{Motion, SphereFlight, SphereState};
use carom::geometry::{Vec2, Vec3};
use carom::run::{Kind, OnCloth, Run};
use serde_json::json;

/// A run of one ball on a table so large that it meets no cushion.
fn one(ball: serde_json::Value) -> Run<f64, OnCloth> {
    run(&scene(&json!([ball])))
}

fn close(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * (1.0 + b.abs()), "{what}: {a}, expected {b}");
}

#[test]
fn a_ball_without_spin_slides_then_rolls_five_sevenths_as_fast_then_rests() {
    // Lengths and times of closed forms, here as formulae; 1e-14 is some ten roundings.
    for speed in [1.0, 2.0] {
        let run = one(ball("a", [-9.0, 0.0], &json!({ "velocity": [speed, 0] })));
        let kinds: Vec<Kind> = run.log.events.iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [Kind::SlideToRoll, Kind::RollToRest]);
        let [slide, rest] = [0, 1].map(|k| run.log.events[k].time);
        close(slide, 2.0 * speed / (7.0 * 0.2 * 9.81), 1e-14, "slide ends");
        let rolling = run.state(slide).unwrap()[0];
        close(rolling.position.x + 9.0, 12.0 * speed * speed / (49.0 * 0.2 * 9.81), 1e-14, "slide");
        close(rolling.twist.velocity.x, 5.0 * speed / 7.0, 1e-15, "rolls at");
        close(rest - slide, 5.0 * speed / 7.0 / (0.01 * 9.81), 1e-14, "roll lasts");
        let rolled = run.final_state()[0].position.x - rolling.position.x;
        close(rolled, (5.0 * speed / 7.0).powi(2) / (2.0 * 0.01 * 9.81), 1e-14, "roll");
        // The printed digits of PHYSICS.md, M1.
        let printed = [0.145_624, 0.124_821, 7.281_200, 2.600_429];
        let found = [slide, rolling.position.x + 9.0, rest - slide, rolled];
        let power = [1.0, 2.0, 1.0, 2.0];
        for k in 0..4 {
            close(found[k], printed[k] * f64::powf(speed, power[k]), 2e-6, "printed");
        }
        assert_eq!(run.status.name(), "at_rest");
        assert_eq!(run.final_state()[0].motion, Motion::Resting);
    }
}

#[test]
fn draw_rolls_at_three_sevenths_or_stops_dead_and_natural_roll_does_not_slide() {
    let spin = |part: f64| [0.0, part / RADIUS, 0.0];
    let run = one(ball("a", [0.0, 0.0], &json!({ "velocity": [1, 0], "spin": spin(-1.0) })));
    close(run.state(run.log.events[0].time).unwrap()[0].twist.velocity.x, 3.0 / 7.0, 1e-15, "draw");
    let run = one(ball("a", [0.0, 0.0], &json!({ "velocity": [1, 0], "spin": spin(-2.5) })));
    assert_eq!(only(&run), [Kind::SlideToRest], "5/7 v − 2/7 · 2.5 v = 0");
    let run = one(ball("a", [0.0, 0.0], &json!({ "velocity": [1, 0], "spin": spin(1.0) })));
    assert_eq!(only(&run), [Kind::RollToRest]);
}

#[test]
fn a_slide_with_side_roll_is_a_parabola_and_ends_at_the_mean_of_velocity_and_roll() {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let mut number = |most: f64| random.between(-most, most);
        let (velocity, spin) = ([number(3.0), number(3.0)], [number(100.0), number(100.0), number(100.0)]);
        let run = one(ball("a", [0.0, 0.0], &json!({ "velocity": velocity, "spin": spin })));
        let (_, flight) = run.log.flights[0];
        let slip = |state: &SphereState<f64>| state.twist.slip(RADIUS);
        let direction = slip(&flight.state_after(0.0)).unit();
        for k in 0..20 {
            let elapsed = flight.length * f64::from(k) / 20.0;
            let state = flight.state_after(elapsed);
            // The slip shrinks to a twentieth, so its direction keeps all but a twentieth of its digits.
            assert!((slip(&state).unit() - direction).norm() < 1e-13);
            let at = Vec2::from_f64(velocity) * elapsed - direction * (0.1 * 9.81 * elapsed * elapsed);
            assert!((state.position.plan() - at).norm() < 1e-14 * (1.0 + at.norm()));
        }
        let rolls = run.state(run.log.events[0].time).unwrap()[0];
        let expected =
            Vec2::from_f64(velocity) * (5.0 / 7.0) + Vec2::new(spin[1], -spin[0]) * (2.0 / 7.0 * RADIUS);
        assert!((rolls.twist.velocity.plan() - expected).norm() < 1e-14 * 6.0, "{rolls:?}");
        assert!(slip(&rolls).norm().to_bits() >> 52 < 1023 - 45, "no slip is left: {rolls:?}");
    }
}

#[test]
fn vertical_spin_goes_down_at_its_own_rate_in_any_motion() {
    let end = 50.0 / 10.9;
    let run = one(ball("a", [0.0, 0.0], &json!({ "spin": [0, 0, 50] })));
    assert_eq!(only(&run), [Kind::SpinToRest]);
    close(run.end_time, end, 1e-15, "spin");
    close(run.end_time, 4.587_156, 2e-7, "printed");
    for (velocity, spin) in [([3.0, 0.0], [0.0, 0.0, 50.0]), ([3.0, 0.0], [0.0, 3.0 / RADIUS, -50.0])] {
        let run = one(ball("a", [-9.0, 0.0], &json!({ "velocity": velocity, "spin": spin })));
        assert!(run.end_time > end, "it still rolls when its spin ends");
        for k in 0..20 {
            let time = end * f64::from(k) / 20.0;
            let left = run.state(time).unwrap()[0].twist.spin.z;
            // Flights are cut where the slide ends: one rounding of 50 each.
            close(left, spin[2] - spin[2].signum() * 10.9 * time, 2e-14, "while it moves");
        }
        assert_eq!(run.state(end + 1e-9).unwrap()[0].twist.spin.z, 0.0);
    }
}

#[test]
fn bounces_are_a_geometric_series_until_they_are_too_low_to_see() {
    let lone = one(ball("a", [0.0, 0.0], &json!({ "velocity": [0, 0, 1] })));
    assert_eq!(lone.log.flights[0].1.motion, Motion::Airborne);
    close(lone.state(1.0 / 9.81).unwrap()[0].position.z - RADIUS, 0.050_968, 1e-6, "apex");
    let landings: Vec<f64> = (lone.log.events.iter())
        .filter(|event| event.kind == Kind::BallCloth)
        .map(|event| event.time)
        .collect();
    // Heights v_z²/2g are 51 mm, 12.7 mm and 3.2 mm: the third hop is lower than 5 mm.
    let expected = [2.0 / 9.81, 3.0 / 9.81];
    assert_eq!(landings.len(), 2, "{landings:?}");
    for (time, expected) in landings.iter().zip(expected) {
        close(*time, expected, 1e-15, "landing");
    }
    // Without a least hop all bounces are over by 2 v/(g (1 − e)).
    let mut value = scene(&json!([ball("a", [0.0, 0.0], &json!({ "velocity": [0, 0, 1] }))]));
    value["physics"]["flight"]["min_hop"] = json!(1e-14);
    let all = run(&value);
    let last = all.log.events.iter().map(|event| event.time).fold(0.0, f64::max);
    // Hops of 1e-14 m take √(8 · 1e-14/g) = 9e-8 s: as much at most is left of the series.
    close(last, 4.0 / 9.81, 2e-7, "all bounces");
    close(last, 0.407_747, 1e-6, "printed");
}

#[test]
fn a_landing_rubs_the_ball_and_leaves_its_vertical_spin() {
    // Fallen from where it has v_z = −1 at the cloth, with a forward speed that the rubbing stops or does not stop: C7.
    for (forward, velocity_x, spin_y) in [(0.5, 0.357_143, 12.4984), (2.0, 1.7, 26.2467)] {
        let height = RADIUS + 1.0 / (2.0 * 9.81);
        let entry =
            json!({ "velocity": [forward, 0, 0], "spin": [0, 0, 50], "position": [0.0, 0.0, height] });
        let run = one(ball("a", [0.0, 0.0], &entry));
        let landing = &run.log.events[0];
        assert_eq!(landing.kind, Kind::BallCloth);
        close(landing.time, 1.0 / 9.81, 1e-15, "the fall");
        let after = run.state(landing.time).unwrap()[0].twist;
        close(after.velocity.x, velocity_x, 1e-6, "v_x");
        close(after.velocity.z, 0.5, 1e-14, "v_z");
        close(after.spin.y, spin_y, 1e-4, "ω_y");
        assert_eq!(after.spin.z, 50.0);
    }
}

#[test]
fn without_air_balls_stay_on_the_cloth() {
    let mut value =
        scene(&json!(
            [ball("a", [0.0, 0.0], &json!({})), ball("b", [0.3, 0.0], &json!({ "radius": 0.03 })),]
        ));
    value["physics"]["flight"]["air"] = json!(false);
    value["shot"] = json!({ "cue_ball": "a", "V0": 4, "phi_deg": 0, "theta_deg": 40 });
    let run = run(&value);
    assert!(run.log.flights.iter().all(|(_, flight)| flight.motion != Motion::Airborne));
    assert!(run.diagnostics.collisions() > 0);
    no_higher(&run, RADIUS, 0.03);
}

#[test]
fn without_friction_balls_keep_their_motion() {
    let mut value =
        scene(&json!([ball("a", [0.0, 0.0], &json!({ "velocity": [1, 0.5], "spin": [1, 2, 3] }))]));
    value["ball_defaults"] = json!({
        "radius": RADIUS, "mass": 0.17, "sliding_friction": 0, "rolling_friction": 0, "spin_decay": 0 });
    value["duration"] = json!(4);
    let run = run(&value);
    assert_eq!(run.log.events.len(), 0);
    let state = run.final_state()[0];
    assert_eq!(state.twist.velocity, Vec3::new(1.0, 0.5, 0.0));
    assert_eq!(state.twist.spin, Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(state.position, Vec3::new(4.0, 2.0, RADIUS));
}

#[test]
fn without_rolling_friction_a_ball_rolls_on() {
    let mut value =
        scene(&json!([ball("a", [-8.0, 0.0], &json!({ "velocity": [1, 0], "rolling_friction": 0 }))]));
    value["duration"] = json!(10);
    let run = run(&value);
    assert_eq!(only(&run), [Kind::SlideToRoll]);
    let state = run.final_state()[0];
    assert_eq!((state.motion, run.status.name()), (Motion::Rolling, "time_limit"));
    close(state.twist.velocity.x, 5.0 / 7.0, 1e-15, "rolls at");
}

#[test]
fn without_gravity_nothing_slows_and_nothing_falls() {
    for (velocity, end) in
        [([1.0, 0.0, 0.0], [3.0, 0.0, RADIUS]), ([1.0, 0.0, 2.0], [3.0, 0.0, RADIUS + 6.0])]
    {
        let mut value = scene(&json!([
            ball("a", [0.0, 0.0], &json!({ "velocity": velocity, "spin": [4, 5, 0] })),
            ball("b", [0.0, 1.0], &json!({ "velocity": [1.0, 0.0] })),
        ]));
        value["physics"]["flight"]["gravity"] = json!(0);
        value["duration"] = json!(3);
        let run = run(&value);
        let state = run.final_state()[0];
        assert_eq!(state.position, Vec3::new(end[0], end[1], end[2]));
        assert_eq!(state.twist.spin, Vec3::new(4.0, 5.0, 0.0));
        assert_eq!(energy(&run, 3.0), run.diagnostics.initial_energy);
    }
}

#[test]
fn balls_that_roll_side_by_side_or_one_after_the_other_do_not_meet() {
    let rolls =
        |id: &str, at: [f64; 2]| ball(id, at, &json!({ "velocity": [1, 0], "spin": [0, 1.0 / RADIUS, 0] }));
    for gap in [0.0, 1e-12, 0.3] {
        for at in [[2.0 * RADIUS + gap, 0.0], [0.0, 2.0 * RADIUS + gap]] {
            let run = run(&scene(&json!([rolls("a", [0.0, 0.0]), rolls("b", at)])));
            assert_eq!(only(&run), [Kind::RollToRest; 2], "gap {gap}");
        }
    }
}

#[test]
fn a_rolling_ball_meets_a_ball_at_rest_at_the_root_of_the_quartic() {
    let run = run(&scene(&json!([
        ball("a", [0.0, 0.0], &json!({ "velocity": [1, 0], "spin": [0, 1.0 / RADIUS, 0] })),
        ball("b", [0.5, RADIUS], &json!({})),
    ])));
    assert_eq!(run.log.events[0].kind, Kind::BallBall);
    close(run.log.events[0].time, 0.460_927_525_905_665, 1e-12, "E1");
}

/// The polynomial of a flight, differentiated: so that the flights are what the log says they are.
#[test]
fn flights_join_without_a_jump_in_place() {
    let mut random = Random::new(8);
    for _ in 0..100 {
        let mut number = |most: f64| random.between(-most, most);
        let entry = json!({ "velocity": [number(3.0), number(3.0), number(1.0).abs()],
            "spin": [number(100.0), number(100.0), number(100.0)] });
        let run = one(ball("a", [0.0, 0.0], &entry));
        let flights: Vec<SphereFlight<f64>> = run.log.flights.iter().map(|(_, flight)| *flight).collect();
        for pair in flights.windows(2) {
            let end = pair[0].position_after(pair[1].start() - pair[0].start());
            assert!((end - pair[1].position_after(0.0)).norm() < 1e-14 * 10.0);
        }
        assert!(run.diagnostics.energy_gain <= 1e-12 * run.diagnostics.initial_energy);
    }
}
