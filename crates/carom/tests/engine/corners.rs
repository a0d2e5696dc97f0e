//! Corners: each cushion acts in turn, so an elastic ball comes out of the narrowest with all its speed, and one that can
//! never leave rests there.

use crate::kit::scenes::{Ball, ball, polygon, rectangle, scenario};
use crate::kit::start_endless;
use carom::flight::State;
use carom::run::{Nothing, Run, Status};
use carom::simulate::simulate;
use serde_json::{Value, json};

/// The run of some balls up to a time.
fn run(table: &Value, physics: &Value, balls: &[Ball], duration: f64) -> Run<f64> {
    let mut scenario = scenario(table, physics, balls);
    scenario.duration = Some(duration);
    simulate(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

fn velocities(run: &Run<f64>) -> Vec<[f64; 2]> {
    run.final_state().iter().map(|state| state.velocity.to_f64()).collect()
}

fn assert_close(given: [f64; 2], expected: [f64; 2], tolerance: f64, what: &str) {
    let apart = libm::hypot(given[0] - expected[0], given[1] - expected[1]);
    assert!(apart <= tolerance, "{what}: {given:?} for {expected:?}, {apart:e} apart");
}

fn kinetic(states: &[State<f64>], balls: &[Ball]) -> f64 {
    states.iter().zip(balls).map(|(s, b)| 0.5 * b.mass * s.velocity.norm_squared()).sum()
}

/// Roundings of energies grow with the square of the impulse, which in a narrow corner is 1/sin(half the angle) times that
/// of the blow; a dozen passes, each with some 1e-16.
fn rounding(half: f64) -> f64 {
    1e-14 / (libm::sin(half) * libm::sin(half))
}

fn assert_no_energy_gained(run: &Run<f64>, half: f64, what: &str) {
    let said = &run.diagnostics;
    let tolerance = rounding(half) * said.initial_energy;
    assert!(said.energy_gain <= tolerance, "{what}: gain {:e}", said.energy_gain);
    assert!(said.energy_drift <= tolerance, "{what}: drift {:e}", said.energy_drift);
    assert!(said.cluster_passes < 40 * said.clusters, "{what}: {said:?}");
    assert!(said.deepest_overlap < 1e-11, "{what}: overlap {:e}", said.deepest_overlap);
    assert!(matches!(run.status, Status::TimeLimit | Status::AtRest), "{what}: {:?}", run.status);
}

/// A corner of the given angle at the origin, its first side along the x axis.
fn corner(degrees: f64) -> Value {
    let angle = degrees.to_radians();
    polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0 * libm::cos(angle), 10.0 * libm::sin(angle)]])
}

#[test]
fn shot_into_the_corner_of_a_square_returns_on_its_own_line() {
    // Validation case D5, for a disc and a point.
    for radius in [0.1, 0.0] {
        let run = run(&rectangle(2.0, 2.0), &json!({}), &[ball(radius, [0.6, 0.6], [-1.0, -1.0])], 1.0);
        assert_eq!(run.diagnostics.events[..4], [0, 2, 0, 0]);
        let State { position: place, velocity } = run.final_state()[0];
        // In at radius, out again: what is left of the second is the way back.
        let back = radius + (1.0 - (0.6 - radius));
        assert_close([place.x, place.y], [back, back], 1e-15, "place");
        assert_close([velocity.x, velocity.y], [1.0, 1.0], 0.0, "velocity");
    }
}

#[test]
fn narrow_corner_gives_an_elastic_ball_back_with_all_its_speed() {
    for degrees in [90.0, 60.0, 45.0, 30.0, 20.0, 10.0, 3.0, 1.0] {
        let half = (degrees / 2.0_f64).to_radians();
        for radius in [0.0, 0.01] {
            // Along the bisector, exactly into the corner, and turned by parts of the corner's angle.
            for turn in [0.0, 0.1, 0.37, -0.2, -0.45] {
                let direction = half * (1.0 + 2.0 * turn);
                let aim = [-libm::cos(direction), -libm::sin(direction)];
                let place = [5.0 * libm::cos(half), 5.0 * libm::sin(half)];
                let run = run(&corner(degrees), &json!({}), &[ball(radius, place, aim)], 8.0);
                let what = format!("{degrees}°, r = {radius}, turn {turn}");
                // Unfolding: at most 180°/angle contacts and one more.
                assert!(run.diagnostics.events[1] <= (180.0 / degrees) as u64 + 3, "{what}");
                let [x, y] = velocities(&run)[0];
                assert!((libm::hypot(x, y) - 1.0).abs() < 1e-13, "{what}: speed {}", libm::hypot(x, y));
                assert_eq!(run.diagnostics.forced_clusters, 0, "{what}");
            }
        }
    }
}

#[test]
fn narrow_corner_stops_a_ball_that_can_never_leave_it() {
    // At e = 0 the ball slides into any corner below 90° and stays; at e = 0.5 into one below some 12°.
    for (degrees, e) in [(60.0, 0.0), (30.0, 0.0), (1.0, 0.0), (10.0, 0.5), (3.0, 0.5), (1.0, 0.5)] {
        let physics = json!({ "ball_cushion": { "law": "restitution", "normal": e } });
        let half = (degrees / 2.0_f64).to_radians();
        for radius in [0.0, 0.01] {
            let place = [5.0 * libm::cos(half), 5.0 * libm::sin(half)];
            let aim = [-libm::cos(half), -libm::sin(half)];
            let run = run(&corner(degrees), &physics, &[ball(radius, place, aim)], 8.0);
            let what = format!("{degrees}°, e = {e}, r = {radius}");
            assert_eq!(run.status, Status::AtRest, "{what}");
            assert!(run.diagnostics.events[1] < 100, "{what}: {:?}", run.diagnostics.events);
            let deep = radius / libm::sin(half);
            let place = run.final_state()[0].position;
            assert_close([place.x, place.y], [deep * libm::cos(half), radius], 1e-9, &what);
            assert_eq!(run.diagnostics.forced_clusters, 0, "{what}");
        }
    }
}

#[test]
fn ball_wedged_in_a_corner_gives_another_back() {
    for degrees in [90.0, 60.0, 30.0, 20.0, 10.0, 3.0, 1.0_f64] {
        let half = (degrees / 2.0).to_radians();
        let deep = 0.01 / libm::sin(half);
        let wedged = [deep * libm::cos(half), 0.01];
        for turn in [0.0, 0.1, 0.5, -0.5] {
            let direction = half * (1.0 + turn);
            let (c, s) = (libm::cos(direction), libm::sin(direction));
            let balls = [
                ball(0.01, wedged, [0.0, 0.0]),
                ball(0.01, [wedged[0] + 0.3 * c, wedged[1] + 0.3 * s], [-c, -s]),
            ];
            for (e, cushion) in [(1.0, 1.0), (1.0, 0.5), (0.5, 1.0), (0.5, 0.5)] {
                let physics = json!({
                    "ball_ball": { "law": "restitution", "normal": e },
                    "ball_cushion": { "law": "restitution", "normal": cushion },
                });
                let run = run(&corner(degrees), &physics, &balls, 0.5);
                let what = format!("{degrees}°, turn {turn}, {e}, {cushion}");
                assert_no_energy_gained(&run, half, &what);
                if e * cushion == 1.0 {
                    let energy = kinetic(&run.final_state(), &balls);
                    assert!((energy - 0.5).abs() < rounding(half), "{what}: {energy}");
                    assert_eq!(run.diagnostics.forced_clusters, 0, "{what}");
                }
            }
        }
    }
}

#[test]
fn ball_as_wide_as_a_channel_runs_along_it() {
    for radius in [0.5, 0.1] {
        let balls = [ball(radius, [radius, 1.0], [0.0, 1.0]), ball(radius, [radius, 3.0], [0.0, -0.3])];
        let mut simulation = start_endless(&scenario(&rectangle(2.0 * radius, 4.0), &json!({}), &balls));
        for _ in 0..1000 {
            simulation.step(&mut Nothing).unwrap();
        }
        let states = simulation.state();
        assert!((kinetic(&states, &balls) - 0.545).abs() < 1e-13);
        assert!(states.iter().all(|s| s.position.x == radius && s.velocity.x == 0.0), "{states:?}");
    }
    // It has no room to move across, and what would move it so is lost.
    let run = run(&rectangle(0.2, 4.0), &json!({}), &[ball(0.1, [0.1, 1.0], [0.3, 1.0])], 2.0);
    assert_close(velocities(&run)[0], [0.0, 1.0], 0.0, "along the channel");
}
