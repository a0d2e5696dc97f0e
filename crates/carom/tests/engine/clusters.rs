//! Several contacts at one instant: what a cluster gives is exact where a closed form is known, symmetric, independent of
//! the order of the balls, and never gains energy.

use crate::kit::scenes::{Ball, ball, rectangle, scenario};
use crate::kit::{bits, bundled, start};
use carom::flight::State;
use carom::run::{Nothing, Run, Status};
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde_json::{Value, json};

fn run_for(mut scenario: Scenario, duration: f64) -> Run<f64> {
    scenario.duration = Some(duration);
    simulate(&scenario).unwrap()
}

fn velocity(run: &Run<f64>, id: &str) -> [f64; 2] {
    let place = run.system.ball_ids.iter().position(|name| name == id).unwrap();
    run.final_state()[place].velocity.to_f64()
}

fn assert_close(found: [f64; 2], expected: [f64; 2], tolerance: f64, what: &str) {
    let far = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
    assert!(far <= tolerance, "{what}: {found:?}, expected {expected:?}, {far:e} off");
}

/// The symmetric answer: −1/5, and 2 √3/5 at 30 degrees to either side.
fn symmetric() -> [(&'static str, [f64; 2]); 3] {
    let side = 0.12_f64.sqrt();
    [("cue", [-0.2, 0.0]), ("upper", [0.6, side]), ("lower", [0.6, -side])]
}

#[test]
fn one_ball_into_a_touching_pair_gives_the_symmetric_answer_in_every_order() {
    let original = bundled("one_into_two");
    let mut known: Option<Vec<[u64; 4]>> = None;
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let mut scenario = original.clone();
        scenario.balls = order.iter().map(|&k| original.balls[k].clone()).collect();
        let run = run_for(scenario, 2.0);
        for (id, expected) in symmetric() {
            // A handful of operations on numbers of order one: 1e-12 is thousands of round-offs.
            assert_close(velocity(&run, id), expected, 1e-12, id);
        }
        let states = run.final_state();
        let by_file: Vec<State<f64>> =
            (0..3).map(|k| states[order.iter().position(|&o| o == k).unwrap()]).collect();
        let found = bits(&by_file);
        assert_eq!(*known.get_or_insert(found.clone()), found, "order {order:?}");
    }
}

#[test]
fn an_aim_off_by_a_hair_changes_the_answer_by_no_more_than_a_hair() {
    for hair in (7..=15).map(|k| libm::pow(10.0, -f64::from(k))) {
        let cases = [([1.5 + hair, 0.0], "above"), ([1.5 - hair, 0.0], "below")];
        let turned = [([1.5, hair], "turned up"), ([1.5, -hair], "turned down")];
        for ([y, upward], what) in cases.into_iter().chain(turned) {
            let scenario = bundled("one_into_two")
                .with_values(&[("balls.cue.position[1]", json!(y)), ("balls.cue.velocity[1]", json!(upward))])
                .unwrap();
            let run = run_for(scenario, 2.0);
            for (id, expected) in symmetric() {
                // An offset d turns the normals by d/2r = 5 d for r = 0.1, and the velocities by twice that at most.
                let tolerance = 10.0 * hair + 1e-12;
                assert_close(velocity(&run, id), expected, tolerance, &format!("{what} by {hair:e}, {id}"));
            }
        }
    }
}

/// Three balls in a row, numbered in some order; both ends come at the middle one at the same time. Seen in a mirror if
/// so asked. The velocities afterwards, from the left to the right.
fn three_in_a_row(order: [usize; 3], e: f64, mirrored: bool) -> [f64; 3] {
    let row = [([0.8, 0.5], 1.0), ([1.5, 0.5], 0.0), ([2.05, 0.5], -0.7)];
    let flip = |x: f64, v: f64| if mirrored { (3.0 - x, -v) } else { (x, v) };
    let balls: Vec<Ball> = order
        .iter()
        .map(|&k| {
            let ([x, y], v) = row[k];
            let (x, v) = flip(x, v);
            ball(0.1, [x, y], [v, 0.0])
        })
        .collect();
    let physics = json!({ "ball_ball": { "law": "restitution", "normal": e } });
    let run = run_for(scenario(&rectangle(3.0, 1.0), &physics, &balls), 0.6);
    assert!(run.log.events[0].cluster.is_some(), "e = {e}: {:?}", run.log.events[0]);
    let states = run.final_state();
    [0, 1, 2].map(|k| {
        let v = states[order.iter().position(|&o| o == k).unwrap()].velocity;
        assert_eq!(v.y, 0.0);
        flip(0.0, v.x).1
    })
}

#[test]
fn three_in_a_row_struck_from_both_ends_part_with_their_momentum() {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    for e in [0.0, 0.05, 0.1, 0.5, 1.0] {
        let found = three_in_a_row([0, 1, 2], e, false);
        let bits = found.map(f64::to_bits);
        for order in orders {
            assert_eq!(three_in_a_row(order, e, false).map(f64::to_bits), bits, "e = {e}, {order:?}");
            let image = three_in_a_row(order, e, true);
            for (a, b) in found.into_iter().zip(image) {
                // Places differ by a rounding of 3, which the passes carry on.
                assert!((a - b).abs() < 1e-13, "e = {e}, {order:?}: {found:?} and in the mirror {image:?}");
            }
        }
        let [left, middle, right] = found;
        // A few dozen impulses, each rounded by 1e-16.
        assert!((left + middle + right - 0.3).abs() < 1e-14, "e = {e}: {found:?}");
        let energy = left * left + middle * middle + right * right;
        assert!(energy <= 1.49 + 1e-14, "e = {e}: {found:?}");
        assert!(e < 1.0 || (energy - 1.49).abs() < 1e-14, "e = {e}: {found:?}");
        assert!(left <= middle + 1e-14 && middle <= right + 1e-14, "e = {e}: {found:?}");
        assert!(e > 0.0 || found.iter().all(|v| (v - 0.1).abs() < 1e-14), "{found:?}");
    }
}

#[test]
fn one_pair_of_a_pairwise_cluster_after_the_other_is_lopsided() {
    let scenario = bundled("one_into_two").with_values(&[("physics.cluster", json!("pairwise"))]).unwrap();
    let run = run_for(scenario, 2.0);
    let speed = |id: &str| {
        let [x, y] = velocity(&run, id);
        (x * x + y * y).sqrt()
    };
    let [mut slow, mut fast] = [speed("upper"), speed("lower")];
    if slow > fast {
        (slow, fast) = (fast, slow);
    }
    // The first takes cos 30° of the speed, the second half of that, and a quarter is left for the cue ball.
    let half = 0.75_f64.sqrt();
    assert!((fast - half).abs() < 1e-12 && (slow - half / 2.0).abs() < 1e-12, "{fast} and {slow}");
    assert!((speed("cue") - 0.25).abs() < 1e-12, "{}", speed("cue"));
}

/// `incoming` balls that touch each other run at speed 1 into a row of `count`.
fn cradle(count: usize, incoming: usize, radius: f64, physics: &Value) -> Scenario {
    let gap = 0.5;
    let balls: Vec<Ball> = (0..incoming + count)
        .map(|k| {
            let is_incoming = k < incoming;
            let x = 0.5 + 2.0 * radius * k as f64 + if is_incoming { 0.0 } else { gap };
            ball(radius, [x, 0.5], [f64::from(u8::from(is_incoming)), 0.0])
        })
        .collect();
    scenario(&rectangle(2.0 * radius * (incoming + count) as f64 + 3.0, 1.0), physics, &balls)
}

#[test]
fn as_many_balls_leave_the_ideal_cradle_as_came_in() {
    // Places that are exact in binary (r = 1/8), and others.
    for radius in [0.125, 0.1] {
        for count in 2..=20 {
            for incoming in 1..=3 {
                let run = run_for(cradle(count, incoming, radius, &json!({})), 1.0);
                for (k, found) in run.final_state().iter().enumerate() {
                    let expected = if k >= count { 1.0 } else { 0.0 };
                    let what = format!("{incoming} into {count} of radius {radius}: ball {k}");
                    // Round-off of each pass, at most three times 23 contacts of 1e-16 each.
                    assert_close(found.velocity.to_f64(), [expected, 0.0], 1e-12, &what);
                }
            }
        }
    }
}

/// A cue ball and fifteen in a triangle whose last row is at `back`.
fn rack(back: f64, physics: &Value) -> Scenario {
    let radius = 0.028_575;
    let mut balls = vec![ball(radius, [0.635, 0.635], [0.0, 5.0])];
    for row in 0..5 {
        let y = back - 3.0_f64.sqrt() * radius * f64::from(4 - row);
        for k in 0..=row {
            let x = 0.635 + radius * f64::from(2 * k - row);
            balls.push(ball(radius, [x, y], [0.0, 0.0]));
        }
    }
    scenario(&rectangle(1.27, 2.54), physics, &balls)
}

fn energy(states: &[State<f64>]) -> f64 {
    states.iter().map(|state| 0.5 * state.velocity.norm_squared()).sum()
}

/// Runs to the time limit, and looks at the energy after every step.
fn assert_energy_never_rises(mut scenario: Scenario, duration: f64, what: &str) {
    scenario.duration = Some(duration);
    let balls = scenario.balls.len() as u64;
    let mut simulation = start(&scenario);
    let initial = energy(&simulation.state());
    let (mut last, mut passes) = (initial, 0);
    // The sum over at most 23 balls is rounded 70 times: 1e-14 of it; and so is each event.
    let tolerance = 1e-13 * initial;
    while simulation.step(&mut Nothing).unwrap_or_else(|error| panic!("{what}: {error}")) {
        let now = energy(&simulation.state());
        assert!(now <= last + tolerance, "{what}: energy from {last} to {now}");
        last = now;
        let made = simulation.diagnostics().cluster_passes;
        assert!(made - passes <= 8 * balls + 1, "{what}: {} passes in one cluster", made - passes);
        passes = made;
    }
    let run = simulate(&scenario).unwrap();
    let found = &run.diagnostics;
    assert_eq!(run.status, Status::TimeLimit, "{what}");
    assert!(found.energy_gain <= 1e-12, "{what}: a cluster gained {:e}", found.energy_gain);
    assert!(found.clusters > 0, "{what}: no cluster");
}

fn restitutions() -> impl Iterator<Item = f64> {
    (0..=20).map(|k| f64::from(k) / 20.0)
}

fn bouncing(balls: f64, cushions: f64) -> Value {
    json!({ "ball_ball": { "law": "restitution", "normal": balls },
        "ball_cushion": { "law": "restitution", "normal": cushions } })
}

#[test]
fn a_run_accounts_for_energy_and_momentum_of_its_elastic_clusters() {
    let mut scenario = rack(2.0, &bouncing(1.0, 1.0));
    scenario.duration = Some(1.0);
    let found = simulate(&scenario).unwrap().diagnostics;
    assert!(found.clusters > 0 && found.energy_loss == 0.0, "{found:?}");
    // Sixteen balls, a dozen passes, each with a few roundings of the energy and of the momentum, which are about 2.
    let bound = 16.0 * 12.0 * 4.0 * f64::EPSILON;
    assert!(found.energy_error < bound && found.energy_drift < 2.0 * bound, "{found:?}");
    assert!(found.momentum_error > 0.0 && found.momentum_error < bound, "{found:?}");
}

#[test]
fn a_rack_ends_and_gains_no_energy_at_any_restitution() {
    for e in restitutions() {
        let at = format!("rack, e = {e}");
        assert_energy_never_rises(rack(2.0, &bouncing(e, 1.0)), 1.0, &at);
        assert_energy_never_rises(rack(2.0, &bouncing(e, e)), 1.0, &format!("{at} at cushions too"));
    }
}

#[test]
fn a_cradle_of_twenty_ends_and_gains_no_energy_at_any_restitution() {
    for e in restitutions() {
        for incoming in 1..=3 {
            let what = format!("{incoming} into 20, e = {e}");
            assert_energy_never_rises(cradle(20, incoming, 0.1, &bouncing(e, 1.0)), 4.0, &what);
        }
    }
}

#[test]
fn a_rack_frozen_against_a_cushion_of_another_restitution_gains_no_energy() {
    for [balls, cushions] in
        [[0.95, 0.5], [0.5, 0.95], [1.0, 0.3], [0.3, 1.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]
    {
        let physics = bouncing(balls, cushions);
        let what = format!("e = {balls} between balls and {cushions} at cushions");
        assert_energy_never_rises(rack(2.0, &physics), 1.0, &what);
        assert_energy_never_rises(rack(2.54 - 0.028_575, &physics), 1.0, &format!("{what}, at the cushion"));
    }
}

#[test]
fn a_shot_into_the_corner_returns_on_its_own_line() {
    for away in [0.2, 0.313, 0.377, 0.41] {
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            let place = |sign: f64| 0.5 - sign * (0.5 - away);
            let balls = [ball(0.1, [place(x), place(y)], [x, y])];
            let run = run_for(scenario(&rectangle(1.0, 1.0), &json!({}), &balls), 1.2);
            let State { position, velocity } = run.final_state()[0];
            let what = format!("from {:?}", balls[0].position);
            assert_close(velocity.to_f64(), [-x, -y], 1e-9, &what);
            // On the diagonal: (position − centre) along the line only.
            let off = (position.x - 0.5) * y - (position.y - 0.5) * x;
            assert!(off.abs() < 1e-9, "{what}: {off:e} off the line");
            assert_eq!(run.log.events.len(), 2, "{what}: one row for each cushion");
            assert!(run.log.events.iter().all(|event| event.cluster == Some(1)), "{what}");
        }
    }
}

#[test]
fn the_symmetric_break_stays_a_mirror_image_and_is_logged_as_a_cluster() {
    // The cue ball arrives at t = (1.27 − 2r)/5 = 0.2426.
    let run = run_for(bundled("triangle_break"), 0.25);
    let states = run.final_state();
    for State { position, velocity } in &states {
        let image = states.iter().map(|State { position: other, velocity: speed }| {
            let mirrored = [1.27 - other.x - position.x, other.y - position.y];
            let turned = [speed.x + velocity.x, speed.y - velocity.y];
            mirrored.into_iter().chain(turned).fold(0.0, |far: f64, part| far.max(part.abs()))
        });
        let nearest = image.fold(f64::INFINITY, f64::min);
        // Places are rounded by 1e-16 of 2.5 and divided by 2r = 0.057 in the normals; 1e-9 leaves a wide margin.
        assert!(nearest < 1e-9, "{position:?} has no image within {nearest:e}");
    }
    let events = &run.log.events;
    assert!(events.len() > 2, "{} events", events.len());
    assert!(events.iter().all(|event| event.cluster == Some(1) && event.time == events[0].time));
    let pair = run_for(bundled("one_into_two"), 2.0);
    assert_eq!(pair.log.events.iter().map(|event| event.cluster).collect::<Vec<_>>(), [Some(1); 2]);
}
