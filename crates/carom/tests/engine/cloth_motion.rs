//! How a single ball moves on the cloth and through the air, in whole runs, against closed forms.

use crate::kit::cloth::{
    ClothRun, GRAVITY, MASS, RADIUS, at, energy, events, first, kinds_of, random_shot, rolling, run,
    sampled_times, spun, stun, wide,
};
use crate::kit::random::Random;
use carom::flight::Motion;
use carom::geometry::{Vec2, Vec3};
use carom::run::{Kind, Status};
use serde_json::json;

const SLIDING: f64 = 0.2;
const ROLLING: f64 = 0.01;
const DECAY: f64 = 10.9;

/// The run of one ball in the middle of a large table.
fn alone(velocity: [f64; 2], rolled: [f64; 3]) -> ClothRun {
    run(&wide(&json!({}), &[spun("a", [20.0, 20.0], velocity, rolled)]))
}

#[test]
fn a_stunned_ball_slides_two_sevenths_of_its_speed_away_and_rolls_to_rest() {
    // Places near 20 are rounded to 4e-15, and a square root of no more enters.
    const TOLERANCE: f64 = 1e-13;
    for (speed, printed) in [
        (1.0, [0.145_624, 0.124_821, 0.714_286, 7.281_200, 2.600_429]),
        (2.0, [0.291_248, 0.499_282, 1.428_571, 14.5624, 10.401_714]),
    ] {
        let run = alone([speed, 0.0], [0.0; 3]);
        assert_eq!(kinds_of(&run, 0), [Kind::SlideToRoll, Kind::RollToRest]);
        let [roll, rest] = [0, 1].map(|k| run.log.events[k].time);
        let state = at(&run, roll)[0];
        let slide = state.position.x - 20.0;
        let way = run.final_state()[0].position.x - state.position.x;
        let found = [roll, slide, state.twist.velocity.x, rest - roll, way];
        let after = 5.0 / 7.0 * speed;
        let exact = [
            2.0 * speed / (7.0 * SLIDING * GRAVITY),
            12.0 * speed * speed / (49.0 * SLIDING * GRAVITY),
            after,
            after / (ROLLING * GRAVITY),
            after * after / (2.0 * ROLLING * GRAVITY),
        ];
        for ((found, exact), printed) in found.into_iter().zip(exact).zip(printed) {
            assert!((found - exact).abs() <= TOLERANCE * (1.0 + exact), "{found} for {exact}");
            assert!((found - printed).abs() <= 1e-6, "{found} for {printed}");
        }
        assert_eq!((run.status, state.motion), (Status::AtRest, Motion::Rolling));
        assert_eq!(run.final_state()[0].twist.velocity, Vec3::ZERO);
    }
}

#[test]
fn draw_slows_a_ball_and_as_much_as_two_and_a_half_times_its_speed_stops_it() {
    let draw = alone([1.0, 0.0], [0.0, -1.0, 0.0]);
    let speed = at(&draw, draw.log.events[0].time)[0].twist.velocity.x;
    // 1 − 2/7 · 2 takes three roundings, and R (1/R) one more.
    assert!((speed - 3.0 / 7.0).abs() <= 4.0 * f64::EPSILON, "{speed}");
    let dead = alone([1.0, 0.0], [0.0, -2.5, 0.0]);
    assert_eq!(kinds_of(&dead, 0), [Kind::SlideToRest]);
    let follow = alone([1.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(kinds_of(&follow, 0), [Kind::RollToRest]);
    assert_eq!(at(&follow, 0.0)[0].motion, Motion::Rolling);
    let back = alone([1.0, 0.0], [0.0, -4.0, 0.0]);
    assert!(back.final_state()[0].position.x < 20.0, "more draw than that brings the ball back");
}

#[test]
fn a_sliding_ball_keeps_the_direction_of_its_slip_and_its_final_velocity_is_that_of_its_spin() {
    let mut random = Random::new(3);
    for case in 0..1000 {
        let velocity = [0, 1].map(|_| random.between(-3.0, 3.0));
        let rolled = [0, 1, 2].map(|_| random.between(-3.0, 3.0));
        let run = alone(velocity, rolled);
        let slip = |time: f64| at(&run, time)[0].twist.slip(RADIUS);
        let start = slip(0.0);
        let end = first(&run, Kind::SlideToRoll, 0).time;
        for part in [0.3, 0.6, 0.9] {
            let now = slip(part * end);
            // The slip is the difference of speeds up to 8, so it carries some 10 roundings of those.
            let sine = now.cross(start) / (now.norm() * start.norm());
            let tolerance = 1e-14 * (1.0 + 1.0 / now.norm());
            assert!(sine.abs() <= tolerance && now.dot(start) > 0.0, "case {case}: {sine}");
        }
        let spun = Vec2::new(rolled[1], -rolled[0]);
        let expected = Vec2::from_f64(velocity) * (5.0 / 7.0) + spun * (2.0 / 7.0);
        let found = at(&run, end)[0].twist.velocity.plan();
        assert!((found - expected).norm() < 1e-12, "case {case}: {found:?} for {expected:?}");
        let braked = at(&run, 0.5 * end)[0].twist.velocity.plan();
        let halfway = (Vec2::from_f64(velocity) + expected) * 0.5;
        assert!((braked - halfway).norm() < 1e-12, "case {case}: the path is a parabola");
    }
}

#[test]
fn side_spin_decays_by_itself_whatever_the_ball_does() {
    let rolled = 50.0 * RADIUS;
    let over = 50.0 / DECAY;
    assert!((over - 4.587_156_f64).abs() < 1e-6);
    let resting = alone([0.0; 2], [0.0, 0.0, rolled]);
    assert_eq!(kinds_of(&resting, 0), [Kind::SpinToRest]);
    assert!((resting.end_time - over).abs() < 1e-14);
    for (what, velocity, roll) in [("slides", 5.0, 0.0), ("rolls", 1.0, 1.0), ("rests", 0.0, 0.0)] {
        let run = alone([velocity, 0.0], [0.0, roll, -rolled]);
        let spin = |time: f64| at(&run, time)[0].twist.spin.z;
        for time in [0.1, 0.5, 2.0, 4.0, 4.58] {
            assert!((spin(time) - (DECAY * time - 50.0)).abs() < 1e-12, "it {what}");
        }
        assert!(run.end_time < over + 1e-14 || spin(over + 1e-9) == 0.0, "it {what}");
        assert_eq!(run.final_state()[0].twist.spin.z, 0.0);
    }
    // A ball that stops before its spin does spins in place.
    let late = alone([0.1, 0.0], [0.0, 0.1, rolled]);
    assert_eq!(kinds_of(&late, 0), [Kind::RollToSpin, Kind::SpinToRest]);
    assert!((late.end_time - over).abs() < 1e-12);
}

#[test]
fn a_ball_thrown_up_bounces_in_a_geometric_series() {
    let physics = json!({ "flight": { "law": "cloth", "restitution": 0.5, "min_hop": 0.0 } });
    let mut ball = stun("a", [20.0, 20.0], [0.0, 0.0]);
    ball["velocity"] = json!([0.0, 0.0, 1.0]);
    let series = run(&wide(&physics, &[ball.clone()]));
    let apex = at(&series, 1.0 / GRAVITY)[0].position.z - RADIUS;
    assert!((apex - 0.050_968).abs() < 1e-6 && (apex - 0.5 / GRAVITY).abs() < 1e-15);
    let landings = events(&series, Kind::BallCloth);
    let mut expected = 0.0;
    for (k, landing) in landings.iter().take(30).enumerate() {
        expected += 2.0 * 0.5_f64.powi(k as i32) / GRAVITY;
        assert!((landing.time - expected).abs() < 1e-15 * (k + 2) as f64, "landing {k} at {}", landing.time);
        assert!((landing.closing_speed - 0.5_f64.powi(k as i32)).abs() < 1e-14);
    }
    assert!((landings[0].time - 0.203_874).abs() < 1e-6);
    assert!((series.end_time - 0.407_747).abs() < 1e-6, "all bounces are over at {}", series.end_time);
    // Of hops that rise 5 mm at least there are two more: 1/8 m/s would rise 0.8 mm, 1/4 m/s 3.2 mm.
    let short = run(&wide(&json!({}), &[ball]));
    assert_eq!(kinds_of(&short, 0), [Kind::BallCloth, Kind::BallCloth]);
    assert_eq!(short.status, Status::AtRest);
}

#[test]
fn a_landing_turns_side_spin_into_none_and_slip_into_roll() {
    // v_z = −1 on the cloth in the next instant: the ball is dropped with it from a hair above.
    for (speed, expected) in [(0.5, [0.357_143, 12.4984]), (2.0, [1.7, 26.2467])] {
        let ball = json!({ "id": "a", "position": [20.0, 20.0, RADIUS + 1e-9], "velocity": [speed, 0.0, -1.0],
            "spin": [0.0, 0.0, 50.0] });
        let run = run(&wide(&json!({}), &[ball]));
        let landing = first(&run, Kind::BallCloth, 0);
        let twist = at(&run, landing.time)[0].twist;
        // Falling through 1e-9 adds g·1e-9 to the speed.
        assert!((twist.velocity.x - expected[0]).abs() < 1e-4 && (twist.velocity.z - 0.5).abs() < 1e-7);
        assert!((twist.spin.y - expected[1]).abs() < 1e-4, "{twist:?}");
        assert_eq!(twist.spin.z, 50.0);
        assert!((landing.impulse - 1.5 * MASS).abs() < 1e-7);
    }
}

#[test]
fn energy_never_rises_in_random_shots() {
    for seed in 0..150 {
        let value = random_shot(seed);
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

#[test]
fn a_rolling_ball_stays_on_its_line() {
    let mut random = Random::new(8);
    for _ in 0..200 {
        let [x, y] = random.direction();
        let run = run(&wide(&json!({}), &[rolling("a", [20.0, 20.0], [x, y])]));
        let way = run.final_state()[0].position.plan() - Vec2::new(20.0, 20.0);
        let direction = Vec2::new(x, y);
        // Places are rounded to 4e-15.
        assert!(way.cross(direction).abs() < 2e-14);
        assert!((way.dot(direction) - 0.5 / (ROLLING * GRAVITY)).abs() < 1e-13);
    }
}
