//! Balls come to rest, lie on cushions, slide, roll off edges, start in contact and lean on each other: whatever they do,
//! the run ends, with a status that says why.

use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, polygon, random_balls, rectangle, scenario, sides, tables};
use carom::flight::State;
use carom::run::{Kind, Run, Status};
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde_json::{Value, json};

/// The run of some balls, up to a duration if any.
fn run(table: &Value, physics: &Value, balls: &[Ball], duration: Option<f64>) -> Run<f64> {
    let mut scenario = scenario(table, physics, balls);
    scenario.duration = duration;
    simulate(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

/// A field, and the restitution of cushions (normal, tangential) and of balls.
fn physics(acceleration: [f64; 2], normal: f64, tangential: f64, balls: f64) -> Value {
    json!({
        "flight": { "law": "field", "acceleration": acceleration },
        "ball_cushion": { "law": "restitution", "normal": normal, "tangential": tangential },
        "ball_ball": { "law": "restitution", "normal": balls },
    })
}

fn count(run: &Run<f64>, kind: Kind) -> u64 {
    run.diagnostics.events[kind as usize]
}

fn assert_at_rest(run: &Run<f64>, place: [f64; 2], tolerance: f64, what: &str) {
    assert_eq!(run.status, Status::AtRest, "{what}");
    let State { position: x, velocity: v } = run.final_state()[0];
    assert!(v.x == 0.0 && v.y == 0.0, "{what}: {v:?}");
    assert!(libm::hypot(x.x - place[0], x.y - place[1]) < tolerance, "{what}: {x:?}");
    // "After at_rest positions stay."
    assert_eq!(run.state(run.end_time + 1e6).unwrap()[0].position, x, "{what}");
}

#[test]
fn ball_dropped_on_a_cushion_rests_after_the_sum_of_the_series() {
    // Falls for 1 from a height of 1 at a = 2; each of its bounces takes e times the last: 1 + 2 e/(1 − e) in all.
    for e in [0.0, 0.3, 0.8, 0.95] {
        let run = run(
            &rectangle(1.0, 2.0),
            &physics([0.0, -2.0], e, 1.0, 1.0),
            &[ball(0.1, [0.5, 1.1], [0.0, 0.0])],
            None,
        );
        assert_at_rest(&run, [0.5, 0.1], 1e-15, &format!("e = {e}"));
        assert_eq!(count(&run, Kind::Hold), 1);
        // The last bounce would have lasted under t_c = 1e-3 √(2r/a), so all that are left out under t_c/(1 − e).
        let left_out = 1.0 + 2.0 * e / (1.0 - e) - run.end_time;
        assert!((-1e-12..1e-3 * 0.1_f64.sqrt() / (1.0 - e)).contains(&left_out), "e = {e}: {left_out}");
    }
}

#[test]
fn ball_is_held_slides_and_comes_to_rest_in_the_corner() {
    let run = run(
        &rectangle(1.0, 1.5),
        &physics([-0.4, -1.2], 0.6, 0.95, 1.0),
        &[ball(0.08, [0.4, 1.2], [0.7, 0.5])],
        None,
    );
    assert_at_rest(&run, [0.08, 0.08], 1e-14, "tilted");
    assert_eq!((count(&run, Kind::Hold), count(&run, Kind::Release)), (2, 0));
    assert!(run.diagnostics.energy_drift < 1e-14, "{:?}", run.diagnostics);
}

#[test]
fn ball_rests_on_a_floor_at_any_slant_that_the_field_is_square_to() {
    for k in 0..40 {
        let (s, c) = libm::sincos(0.157 * f64::from(k));
        let turn = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        let table = polygon(&[turn(0.0, 0.0), turn(1.0, 0.0), turn(1.0, 2.0), turn(0.0, 2.0)]);
        for e in [0.0, 0.5, 0.8] {
            let balls = [ball(0.1, turn(0.5, 1.0), [0.0, 0.0])];
            let run = run(&table, &physics([s, -c], e, 0.9, 1.0), &balls, None);
            // Round-off across the slant moves it by less than 1e-13 until it lies.
            assert_at_rest(&run, turn(0.5, 0.1), 1e-12, &format!("turned by {k}, e = {e}"));
        }
    }
}

#[test]
fn valley_of_any_opening_catches_a_ball() {
    for slope in [0.2, 0.7, 2.0, 10.0] {
        let table = polygon(&[[0.0, 0.0], [1.0, slope], [1.0, 14.0], [-1.0, 14.0], [-1.0, slope]]);
        let deep = 0.1 * libm::hypot(1.0, slope);
        let balls = [ball(0.1, [0.3, 12.0], [0.1, 0.0])];
        let run = run(&table, &physics([0.0, -1.0], 0.5, 0.9, 1.0), &balls, None);
        // It is stopped for good where its next bounce would be shorter than t_c.
        assert_at_rest(&run, [0.0, deep], 1e-6, &format!("slope {slope}"));
        assert!(run.diagnostics.energy_drift < 1e-13, "{:?}", run.diagnostics);
    }
}

#[test]
fn ball_sliding_between_lossy_cushions_comes_to_rest_in_a_finite_number_of_events() {
    // It slides for ever; when its speed is within the round-off of a fall across the table, that is rest.
    let balls = [ball(0.1, [0.5, 1.0], [0.3, 0.0])];
    let run = run(&rectangle(1.0, 2.0), &physics([0.0, -2.0], 0.8, 1.0, 1.0), &balls, None);
    assert_eq!(run.status, Status::AtRest);
    assert!(run.diagnostics.total_events() < 300, "{:?}", run.diagnostics);
}

#[test]
fn speed_too_small_for_the_range_of_times_is_rest() {
    let mut scenario = scenario(
        &rectangle(1.0, 2.0),
        &json!({ "ball_cushion": { "law": "damping", "factor": 0.5 } }),
        &[ball(0.1, [0.5, 1.0], [0.3, 0.4])],
    );
    (scenario.duration, scenario.collisions) = (None, Some(1_000_000));
    let run = simulate(&scenario).unwrap();
    assert_eq!(run.status, Status::AtRest);
    // Nothing happens after 1e77 = 2^256: a speed of 0.4 is halved some 255 times.
    assert!((250..520).contains(&run.diagnostics.total_events()), "{:?}", run.diagnostics);
}

#[test]
fn ball_pressed_into_a_corner_from_the_start_rests_at_once() {
    let table = rectangle(1.0, 2.0);
    for field in [[-1.0, -2.0], [-3.0, -0.01], [0.0, -1.0], [-1.0, 0.0]] {
        let balls = [ball(0.1, [0.1, 0.1], [0.0, 0.0])];
        let run = run(&table, &physics(field, 0.5, 1.0, 1.0), &balls, None);
        assert_at_rest(&run, [0.1, 0.1], 1e-16, &format!("{field:?}"));
        let holds = u64::from(field[0] < 0.0) + u64::from(field[1] < 0.0);
        assert_eq!((run.end_time, run.diagnostics.events), (0.0, [0, 0, holds, 0]));
    }
}

/// A shelf from the left wall to x = 1 at y = 1, and a floor at 0 to the right of it.
fn shelf() -> Value {
    let corners = [[1.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0], [0.0, 1.0], [1.0, 1.0]];
    json!({ "shape": "path", "pieces": sides(&corners) })
}

#[test]
fn fast_ball_rolling_off_an_edge_flies_a_parabola() {
    // v² > a r: it parts from the corner at once. The point has no corner to part from.
    for (radius, v) in [(0.1, 0.5), (0.0, 0.2), (0.02, 1.0)] {
        let balls = [ball(radius, [0.5, 1.0 + radius], [v, 0.0])];
        let run = run(&shelf(), &physics([0.0, -1.0], 0.5, 0.9, 1.0), &balls, Some(20.0));
        let events = &run.log.events;
        assert_eq!((events[0].kind, events[0].time), (Kind::Hold, 0.0));
        assert_eq!(events[1].kind, Kind::Release);
        assert!((events[1].time - 0.5 / v).abs() < 1e-10 / v, "at the edge: {}", events[1].time);
        assert_eq!(events[2].kind, Kind::BallCushion);
        let fall = events[2].time - events[1].time;
        assert!((fall - 2.0_f64.sqrt()).abs() < 1e-9, "falls for {fall}");
        assert_eq!(run.status, Status::TimeLimit);
    }
}

#[test]
fn slow_ball_on_an_edge_that_it_would_roll_around_ends_the_run() {
    // v² < a r: it stays in touch with the corner, which no sequence of contacts can follow.
    let balls = [ball(0.1, [0.5, 1.1], [0.2, 0.0])];
    let run = run(&shelf(), &physics([0.0, -1.0], 0.5, 1.0, 1.0), &balls, Some(20.0));
    assert_eq!(run.status, Status::Collapsed);
    assert!((run.end_time - 2.5).abs() < 1e-6);
    // Contacts that do not close take nothing.
    assert!((run.final_state()[0].velocity.x - 0.2).abs() < 1e-15, "{:?}", run.final_state());
}

#[test]
fn ball_slides_down_a_slope_off_its_edge_and_rests_in_the_far_corner() {
    let balls = [ball(0.1, [0.2, 1.1], [0.0, 0.0])];
    let run = run(&shelf(), &physics([0.4, -1.0], 0.5, 0.9, 1.0), &balls, None);
    assert_eq!(count(&run, Kind::Release), 1);
    assert_at_rest(&run, [3.9, 0.1], 1e-13, "slope");
}

/// Balls in a row, all on one line.
fn three_in_a_row() -> Vec<Ball> {
    vec![
        ball(0.1, [1.0, 0.5], [1.0, 0.0]),
        ball(0.1, [1.5, 0.5], [0.0, 0.0]),
        ball(0.1, [2.0, 0.5], [-0.7, 0.0]),
    ]
}

#[test]
fn three_in_a_row_stick_together_below_seven_minus_four_root_three() {
    // Validation case E8. Below e = 0.0718 the middle ball would be hit without end in a finite time; as soon as the gaps
    // are within the contact tolerance, the three are one cluster, and part no more; with tc as well as without.
    for (e, collapse, sticks) in [
        (0.05, "stop", true),
        (0.07, "stop", true),
        (0.05, "tc", true),
        (0.08, "stop", false),
        (0.1, "stop", false),
        (0.1, "tc", false),
    ] {
        let physics = json!({ "ball_ball": { "law": "restitution", "normal": e }, "collapse": collapse });
        let run = run(&rectangle(4.0, 1.0), &physics, &three_in_a_row(), Some(3.0));
        let what = format!("e = {e}, {collapse}: {:?}", run.diagnostics);
        assert_eq!(run.status, Status::TimeLimit, "{what}");
        assert!(run.diagnostics.total_events() < 200, "{what}");
        let speeds: Vec<f64> = run.final_state().iter().map(|s| s.velocity.x).collect();
        assert!((speeds.iter().sum::<f64>() - 0.3).abs() < 1e-14, "{what}");
        let spread = (speeds[2] - speeds[0]).abs();
        assert_eq!(spread < 1e-9, sticks, "{what}, velocities {speeds:?}");
    }
}

#[test]
fn inelastic_gas_without_a_field_runs_to_its_duration_with_tc() {
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let table = rectangle(1.0, 1.0);
        let balls = random_balls(&mut random, &table, 30, [0.04, 0.06], [0.5, 2.0]);
        for e in [0.0, 0.1, 0.5] {
            for collapse in ["stop", "tc"] {
                let physics = json!({
                    "ball_ball": { "law": "restitution", "normal": e },
                    "ball_cushion": { "law": "restitution", "normal": 0.5 },
                    "collapse": collapse,
                });
                let run = run(&table, &physics, &balls, Some(30.0));
                let what = format!("seed {seed}, e = {e}, {collapse}: {:?}", run.diagnostics);
                match collapse {
                    "tc" => assert!(matches!(run.status, Status::TimeLimit | Status::AtRest), "{what}"),
                    _ => assert!(run.status != Status::EventLimit, "{what}"),
                }
                assert!(run.diagnostics.energy_gain < 1e-14 * run.diagnostics.initial_energy, "{what}");
            }
        }
    }
}

#[test]
fn heaps_in_a_field_end_with_a_status() {
    // Balls that come to lie on each other are beyond sequences of contacts: such a run says that it collapsed; with tc they
    // hop on.
    let mut seen = std::collections::BTreeSet::new();
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let table = rectangle(1.0, 1.5);
        let count = 1 + random.below(8);
        let balls = random_balls(&mut random, &table, count, [0.05, 0.12], [0.5, 2.0]);
        for collapse in ["stop", "tc"] {
            let field = [random.between(-0.5, 0.5), -1.0];
            let mut physics = physics(field, random.unit() * 0.9, random.unit(), random.unit());
            physics["collapse"] = collapse.into();
            let mut scenario = scenario(&table, &physics, &balls);
            (scenario.duration, scenario.max_events) = (Some(100.0), Some(100_000));
            let run = simulate(&scenario).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
            let said = &run.diagnostics;
            let scale = said.initial_energy.abs() + balls.iter().map(|b| 2.0 * b.mass).sum::<f64>();
            assert!(said.energy_gain < 1e-14 * scale, "seed {seed}: {said:?}");
            // The sum of the losses is rounded at each event, always the same way where the same hop returns.
            let rounding = 1e-12 + f64::EPSILON * said.total_events() as f64;
            assert!(said.energy_drift < rounding * scale, "seed {seed}: {said:?}");
            let unexpected = if collapse == "tc" { Status::Collapsed } else { Status::EventLimit };
            assert!(run.status != unexpected, "seed {seed}: {said:?}");
            seen.insert(run.status.name());
        }
    }
    assert!(seen.contains("at_rest") && seen.contains("collapsed"), "{seen:?}");
}

#[test]
fn limits_are_never_mixed_up() {
    let balls = [ball(0.1, [0.5, 0.5], [1.0, 0.7]), ball(0.1, [0.3, 1.5], [-0.4, 0.9])];
    let base = scenario(&rectangle(1.0, 2.0), &json!({}), &balls);
    let with = |duration: Option<f64>, collisions: Option<u64>, max_events: Option<u64>| {
        let mut scenario = base.clone();
        (scenario.duration, scenario.collisions, scenario.max_events) = (duration, collisions, max_events);
        let run = simulate(&scenario).unwrap();
        (run.status, run.diagnostics.total_events(), run.end_time)
    };
    let (status, events, end) = with(Some(20.0), None, None);
    assert_eq!((status, end), (Status::TimeLimit, 20.0));
    assert!(events > 40);
    let tenth = simulate(&base).is_ok_and(|_| true) && events > 10;
    assert!(tenth);
    let (status, count, end) = with(Some(20.0), Some(10), None);
    assert_eq!((status, count), (Status::CollisionLimit, 10));
    assert!(end < 20.0);
    assert_eq!(with(Some(20.0), None, Some(10)), (Status::EventLimit, 10, end));
    assert_eq!(with(None, Some(10), Some(11)), (Status::CollisionLimit, 10, end));
    assert_eq!(with(None, Some(10), Some(9)).0, Status::EventLimit);
    // The work asked for is done before the budget is blamed.
    assert_eq!(with(None, Some(10), Some(10)), (Status::CollisionLimit, 10, end));
    assert_eq!(with(Some(end), None, None), (Status::TimeLimit, 10, end), "an event at the duration happens");
    assert_eq!(with(Some(0.0), None, None), (Status::TimeLimit, 0, 0.0));
    assert_eq!(with(Some(0.0), Some(0), None), (Status::CollisionLimit, 0, 0.0));
}

#[test]
fn ball_that_starts_on_a_cushion_does_what_its_velocity_says() {
    let table = rectangle(1.0, 2.0);
    let run = |radius: f64, place: [f64; 2], velocity: [f64; 2], physics: &Value| {
        run(&table, physics, &[ball(radius, [place[0] + radius, place[1] + radius], velocity)], Some(0.5))
    };
    for radius in [0.1, 0.0] {
        for physics in [json!({}), json!({ "ball_cushion": { "law": "damping", "factor": 0.5 } })] {
            let kept = if physics == json!({}) { 1.0 } else { 0.5 };
            let end = |run: &Run<f64>| {
                let v = run.final_state()[0].velocity;
                (run.status, run.diagnostics.events[1], [v.x, v.y])
            };
            let (edge, corner) = ([0.0, 0.7], [0.0, 0.0]);
            for place in [edge, corner] {
                let rest = end(&run(radius, place, [0.0, 0.0], &physics));
                assert_eq!(rest, (Status::AtRest, 0, [0.0, 0.0]));
                let along = end(&run(radius, place, [0.0, 1.0], &physics));
                assert_eq!(along, (Status::TimeLimit, 0, [0.0, 1.0]));
                let off = end(&run(radius, place, [1.0, 0.25], &physics));
                assert_eq!(off, (Status::TimeLimit, 0, [1.0, 0.25]));
            }
            let into = end(&run(radius, edge, [-1.0, 0.25], &physics));
            assert_eq!(into, (Status::TimeLimit, 1, [kept, 0.25 * kept]));
            let into = end(&run(radius, corner, [-1.0, -0.25], &physics));
            assert_eq!(into, (Status::TimeLimit, 2, [kept * kept, 0.25 * kept * kept]));
            let one = end(&run(radius, corner, [-1.0, 0.25], &physics));
            assert_eq!(one, (Status::TimeLimit, 1, [kept, 0.25 * kept]));
        }
    }
}

#[test]
fn frozen_balls_stay_frozen_until_something_moves_them() {
    let row: Vec<Ball> = (0..5).map(|k| ball(0.1, [0.1 + 0.2 * f64::from(k), 0.1], [0.0, 0.0])).collect();
    let still = run(&rectangle(1.0, 2.0), &json!({}), &row, None);
    assert_eq!((still.status, still.end_time, still.diagnostics.total_events()), (Status::AtRest, 0.0, 0));
    // All together: touching and with the same velocity, they never meet.
    let together: Vec<Ball> = row.iter().map(|b| ball(0.1, b.position, [0.0, 0.3])).collect();
    let run = run(&rectangle(1.0, 2.0), &json!({}), &together, Some(100.0));
    assert_eq!(run.diagnostics.events[0], 0, "{:?}", run.diagnostics);
    assert_eq!(run.status, Status::TimeLimit);
    assert!(run.diagnostics.deepest_overlap < 1e-15);
}

#[test]
fn whatever_happens_a_run_ends_with_a_status() {
    // Random starts in contact, in corners and on each other, in fields or without, under all laws: no error, no endless
    // loop, and an end.
    let mut seen = std::collections::BTreeMap::new();
    for seed in 0..600 {
        let mut random = Random::new(seed);
        let tables = tables();
        let (name, table) = random.choose(&tables);
        let count = 1 + random.below(6);
        let mut balls = random_balls(&mut random, table, count, [0.02, 0.1], [0.1, 10.0]);
        for ball in &mut balls {
            if random.below(3) == 0 {
                ball.velocity = [0.0, 0.0];
            }
            if random.below(6) == 0 {
                ball.radius = 0.0;
            }
        }
        let (e, normal, tangential) = (level(&mut random), level(&mut random), level(&mut random));
        let field = if random.flips() { random.direction() } else { [0.0, -1.0] };
        let mut physics = physics(field, normal, tangential, e);
        if random.flips() {
            physics.as_object_mut().unwrap().remove("flight");
        }
        physics["collapse"] = (*random.choose(&["stop", "tc"])).into();
        physics["cluster"] = (*random.choose(&["reflections", "hertz", "pairwise"])).into();
        let mut scenario: Scenario = scenario(table, &physics, &balls);
        (scenario.duration, scenario.max_events) = (Some(20.0), Some(20_000));
        let run = simulate(&scenario).unwrap_or_else(|error| panic!("seed {seed}, {name}: {error}"));
        *seen.entry(run.status.name()).or_insert(0) += 1;
        let diagnostics = &run.diagnostics;
        let scale: f64 = balls.iter().map(|b| b.mass * 4.0).sum::<f64>() + diagnostics.initial_energy.abs();
        assert!(diagnostics.energy_drift < 1e-11 * scale, "seed {seed}, {name}: {diagnostics:?}");
        assert!(diagnostics.energy_gain < 1e-13 * scale, "seed {seed}, {name}: {diagnostics:?}");
    }
    println!("{seen:?}");
}

/// 0, 1, or between.
fn level(random: &mut Random) -> f64 {
    match random.below(3) {
        0 => 0.0,
        1 => 1.0,
        _ => random.unit(),
    }
}
