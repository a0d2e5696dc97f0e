//! Heaps of touching balls struck by another: momentum is kept, energy never gained, and nothing closes any more.

use crate::kit::random::Random;
use crate::kit::scenes::{Ball, ball, rack, random_balls, rectangle, scenario};
use crate::kit::{start, start_endless};
use carom::flight::State;
use carom::run::{Event, Log, Nothing, Run, Status};
use carom::simulate::simulate;
use serde_json::{Value, json};

/// The run of some balls up to a time.
fn run(table: &Value, physics: &Value, balls: &[Ball], duration: f64) -> Run<f64> {
    let mut scenario = scenario(table, physics, balls);
    scenario.duration = Some(duration);
    simulate(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

fn kinetic(states: &[State<f64>], balls: &[Ball]) -> f64 {
    states.iter().zip(balls).map(|(s, b)| 0.5 * b.mass * s.velocity.norm_squared()).sum()
}

/// Passes that the law needs at most for each ball, the last one without restitution included.
const PASSES_PER_BALL: u64 = 9;

/// Asserts that the clusters of a run ended soon, gave no energy and left nothing overlapping.
fn assert_sound(run: &Run<f64>, balls: &[Ball], what: &str) {
    let said = &run.diagnostics;
    let most = PASSES_PER_BALL * balls.len() as u64 * 2 * said.clusters.max(1);
    assert!(
        said.cluster_passes <= most,
        "{what}: {} passes in {} clusters",
        said.cluster_passes,
        said.clusters
    );
    // A dozen passes, each with a rounding of 1e-16 or so of the energy.
    assert!(said.energy_gain <= 1e-14 * said.initial_energy, "{what}: gain {:e}", said.energy_gain);
    assert!(said.energy_drift <= 1e-14 * said.initial_energy, "{what}: drift {:e}", said.energy_drift);
    assert!(said.deepest_overlap < 1e-11, "{what}: overlap {:e}", said.deepest_overlap);
    assert!(matches!(run.status, Status::TimeLimit | Status::AtRest), "{what}: {:?}", run.status);
    let (before, after) = (said.initial_energy, kinetic(&run.final_state(), balls));
    assert!(after <= before * (1.0 + 1e-14), "{what}: {before} → {after}");
}

/// 0, 0.05, ..., 1.
fn restitutions() -> impl Iterator<Item = f64> {
    (0..=20).map(|k| f64::from(k) / 20.0)
}

#[test]
fn rack_frozen_to_cushions_of_another_restitution_ends_as_soon() {
    for e in restitutions() {
        for cushion in [0.0, 0.3, 0.7, 1.0] {
            let physics = json!({
                "ball_ball": { "law": "restitution", "normal": e },
                "ball_cushion": { "law": "restitution", "normal": cushion, "tangential": 0.9 },
            });
            // The last row lies against the top cushion.
            let height = 0.1 * 3.0_f64.sqrt() * 4.0;
            let mut balls = rack(0.1, [2.0, 2.0], 5);
            balls.push(ball(0.1, [2.02, 0.5], [0.0, 1.0]));
            let table = rectangle(4.0, 2.0 + height + 0.1);
            assert_sound(&run(&table, &physics, &balls, 4.0), &balls, &format!("top, {e}, {cushion}"));
            // A square of four in the corner, struck along and across its diagonal.
            for velocity in [[-1.0, -1.0], [-1.0, -0.4]] {
                let mut balls: Vec<Ball> = (0..4)
                    .map(|k| {
                        ball(0.1, [0.1 + 0.2 * f64::from(k % 2), 0.1 + 0.2 * f64::from(k / 2)], [0.0; 2])
                    })
                    .collect();
                let [x, y] = velocity.map(|v: f64| 0.2 - 0.8 * v);
                balls.push(ball(0.1, [x, y], velocity));
                let run = run(&rectangle(2.0, 2.0), &physics, &balls, 4.0);
                assert_sound(&run, &balls, &format!("corner, {e}, {cushion}, {velocity:?}"));
            }
        }
    }
}

/// A heap grown ball by ball, each new one touching one of the others, of unequal radii and masses.
fn heap(random: &mut Random, count: usize) -> Vec<Ball> {
    let mut balls = vec![ball(0.1, [2.0, 2.0], [0.0, 0.0])];
    for _ in 0..100 * count {
        if balls.len() == count {
            break;
        }
        let (base, radius) = (random.choose(&balls).clone(), random.between(0.05, 0.15));
        let reach = base.radius + radius;
        let direction = random.direction();
        let position = [0, 1].map(|axis| base.position[axis] + direction[axis] * reach);
        // A touching ball may be off by round-off, which is contact, but no deeper.
        let gap = |b: &Ball| {
            libm::hypot(b.position[0] - position[0], b.position[1] - position[1]) - b.radius - radius
        };
        if balls.iter().all(|b| gap(b) > -1e-12) {
            balls.push(Ball { radius, mass: random.magnitude(0.1, 10.0), position, velocity: [0.0, 0.0] });
        }
    }
    balls
}

#[test]
fn heaps_keep_momentum_and_nothing_closes_after_a_blow() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let count = 3 + random.below(10);
        let mut balls = heap(&mut random, count);
        let direction = random.direction();
        let (angle, speed) = (random.between(-0.04, 0.04), random.magnitude(0.1, 10.0));
        let aim = [direction[0] + angle * direction[1], direction[1] - angle * direction[0]];
        balls.push(Ball {
            radius: 0.1,
            mass: random.magnitude(0.1, 10.0),
            position: [0, 1].map(|axis| 2.0 - 1.9 * direction[axis]),
            velocity: aim.map(|c| c * speed),
        });
        let e = if random.flips() { 1.0 } else { random.unit() };
        let physics = json!({ "ball_ball": { "law": "restitution", "normal": e } });
        let what = format!("seed {seed}, {} balls, e = {e}", balls.len());
        let mut simulation = start_endless(&scenario(&rectangle(4.0, 4.0), &physics, &balls));
        let mut log = Log::new(true, false);
        let before = simulation.state();
        // Up to the first cluster.
        while log.events.last().is_none_or(|event: &Event<f64>| event.cluster.is_none()) {
            let goes_on = simulation.step(&mut log).unwrap_or_else(|error| panic!("{what}: {error}"));
            if !goes_on || log.events.iter().any(|event| event.cushion.is_some()) {
                break;
            }
        }
        if log.events.iter().any(|event| event.cushion.is_some()) {
            continue;
        }
        let after = simulation.state();
        let scale: f64 = balls.iter().map(|b| b.mass * libm::hypot(b.velocity[0], b.velocity[1])).sum();
        let sums = |states: &[State<f64>]| {
            states.iter().zip(&balls).fold([0.0; 3], |sum, (State { position: x, velocity: v }, b)| {
                [sum[0] + b.mass * v.x, sum[1] + b.mass * v.y, sum[2] + b.mass * (x.x * v.y - x.y * v.x)]
            })
        };
        for (a, b) in sums(&before).into_iter().zip(sums(&after)) {
            // Some hundred impulses, each with a rounding of 1e-16 of the largest.
            assert!((a - b).abs() < 1e-13 * scale * (1.0 + simulation.time()), "{what}: {a} → {b}");
        }
        let (energy, left) = (kinetic(&before, &balls), kinetic(&after, &balls));
        assert!(left <= energy * (1.0 + 1e-14), "{what}: energy {energy} → {left}");
        if e == 1.0 && simulation.diagnostics().forced_clusters == 0 {
            assert!((left - energy).abs() < 1e-13 * energy, "{what}: energy {energy} → {left}");
        }
        assert_parting(&after, &balls, &what);
    }
}

/// No two balls in contact approach each other.
fn assert_parting(states: &[State<f64>], balls: &[Ball], what: &str) {
    let fastest = states.iter().map(|s| libm::hypot(s.velocity.x, s.velocity.y)).fold(0.0, f64::max);
    for (a, one) in states.iter().enumerate() {
        for (b, other) in states.iter().enumerate().skip(a + 1) {
            let separation = other.position - one.position;
            let (reach, radii) = (libm::hypot(separation.x, separation.y), balls[a].radius + balls[b].radius);
            if reach - radii < 1e-11 {
                let closing = (one.velocity - other.velocity).dot(separation) / reach;
                assert!(closing < 1e-12 * fastest, "{what}: {a} and {b} close at {closing:e} of {fastest}");
            }
        }
    }
}

/// Two rows of three balls above the floor of a tilted table.
fn falling_rows() -> Vec<Ball> {
    let place = |k: u32| {
        let (column, row) = (f64::from(k % 3), f64::from(k / 3));
        [0.3 + 0.17 * column + 0.05 * row, 0.4 + 0.3 * row]
    };
    (0..6).map(|k| ball(0.08, place(k), [0.1 - 0.03 * f64::from(k), 0.0])).collect()
}

/// A large ball in the corner, and a small one that slides under it and would lift it.
fn wedge() -> Vec<Ball> {
    vec![
        ball(0.055, [0.4, 1.1], [-0.26, -1.7]),
        Ball { mass: 0.5, ..ball(0.1, [0.11, 0.105], [-0.23, 0.18]) },
    ]
}

/// Runs a heap on a tilted table with `collapse = "tc"`; asserts that time goes on and the energy does not rise.
fn assert_goes_on(balls: &[Ball], e: [f64; 3], duration: f64) {
    let field = [-0.4, -1.2];
    let physics = json!({
        "flight": { "law": "field", "acceleration": field },
        "ball_ball": { "law": "restitution", "normal": e[0] },
        "ball_cushion": { "law": "restitution", "normal": e[1], "tangential": e[2] },
        "collapse": "tc",
    });
    let mut scenario = scenario(&rectangle(1.0, 1.5), &physics, balls);
    (scenario.duration, scenario.max_events) = (Some(duration), Some(1_000_000));
    let mut simulation = start(&scenario);
    let energy = |states: &[State<f64>]| {
        let of = |(State { position: x, velocity: v }, b): (&State<f64>, &Ball)| {
            b.mass * (0.5 * (v.x * v.x + v.y * v.y) - field[0] * x.x - field[1] * x.y)
        };
        states.iter().zip(balls).map(of).sum::<f64>()
    };
    let initial = energy(&simulation.state());
    let mut last = initial;
    while simulation.step(&mut Nothing).unwrap_or_else(|error| panic!("{e:?}: {error}")) {
        let now = energy(&simulation.state());
        // Sums of a dozen terms of the size of the whole, whose rounding in places grows with the number of flights.
        assert!(now <= last + 1e-14 * initial, "e = {e:?}, t = {}: {last} → {now}", simulation.time());
        last = now;
    }
    let said = simulation.diagnostics();
    assert_eq!(simulation.status(), Some(Status::TimeLimit), "{e:?} at {}: {said:?}", simulation.time());
    assert!(said.energy_gain <= 1e-15 * initial, "{e:?}: {said:?}");
    let shortest = simulation.system().collapse_times.iter().copied().fold(f64::INFINITY, f64::min);
    let per_collapse_time = said.total_events() as f64 * shortest / duration;
    // A handful for each ball.
    assert!(per_collapse_time < 10.0 * balls.len() as f64, "{e:?}: {per_collapse_time} events per t_c");
}

#[test]
fn heaps_that_lose_energy_go_on_hopping_with_tc() {
    for e in [0.0, 0.05, 0.2, 0.5, 0.8] {
        assert_goes_on(&falling_rows(), [e, e, 1.0], 5.0);
        assert_goes_on(&wedge(), [e, 0.2, 0.4], 5.0);
    }
    assert_goes_on(&falling_rows(), [0.2, 0.5, 0.9], 5.0);
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let count = 1 + random.below(8);
        let balls = random_balls(&mut random, &rectangle(1.0, 1.5), count, [0.05, 0.12], [0.5, 2.0]);
        assert_goes_on(&balls, [random.unit(), 0.9 * random.unit(), random.unit()], 6.0);
    }
}

#[test]
fn dropped_ball_goes_on_hopping_with_tc() {
    let dropped = [ball(0.08, [0.5, 0.5], [0.0, 0.0])];
    for e in [0.0, 0.5] {
        assert_goes_on(&dropped, [1.0, e, 1.0], 20.0);
    }
}

#[test]
fn ball_that_grazes_a_cushion_is_held_with_tc_too() {
    // Its hops would last 2e-9; those that are followed last t_c/100 = 4e-6 at least.
    let physics = json!({
        "flight": { "law": "field", "acceleration": [0.0, -1.0] },
        "collapse": "tc",
    });
    let balls = [ball(0.08, [0.2, 0.08], [0.1, 1e-9])];
    let run = run(&rectangle(1.0, 1.5), &physics, &balls, 2.0);
    assert_eq!(run.status, Status::TimeLimit, "{:?}", run.diagnostics);
    assert!(run.diagnostics.total_events() < 4, "{:?}", run.diagnostics);
}

#[test]
fn the_same_heaps_without_tc_say_that_they_collapsed() {
    for e in [0.0, 0.2, 0.5] {
        let physics = json!({
            "flight": { "law": "field", "acceleration": [-0.4, -1.2] },
            "ball_ball": { "law": "restitution", "normal": e },
            "ball_cushion": { "law": "restitution", "normal": e },
        });
        let balls = falling_rows();
        let run = run(&rectangle(1.0, 1.5), &physics, &balls, 20.0);
        let said = &run.diagnostics;
        assert_eq!(run.status, Status::Collapsed, "e = {e}: {said:?}");
        assert!(said.energy_drift < 1e-13 * said.initial_energy, "e = {e}: {said:?}");
    }
}
