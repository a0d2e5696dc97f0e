//! The cluster law `hertz`: what it keeps, what must not matter to it, and how the engine uses it.

use crate::kit::random::Random;
use crate::kit::scenes::{ball, rectangle, scenario};
use crate::kit::touching::{Body, Touch, farthest, one_into_two, rack, random_scene, row};
use crate::kit::{bits, bundled};
use carom::geometry::{Vec2, Vec3};
use carom::law::ball_ball::{self, Restitution};
use carom::law::cluster::{self, DiscLaw, TouchLaw, resolve_hertz};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::schema::{Cluster, Record};
use carom::simulate::simulate;
use serde_json::json;

#[test]
fn energy_never_rises_momentum_stays_and_nothing_closes_any_more() {
    let mut random = Random::new(5);
    let mut forced = 0;
    for number in 0..600 {
        let scene = if number % 10 == 0 { rack() } else { random_scene(&mut random) };
        let e = if number % 3 == 0 { 1.0 } else { random.unit() };
        let what = format!("seed 5, number {number}, e = {e}");
        let (mut bodies, mut touches) = scene.cluster::<f64>(e);
        let passes = resolve_hertz(&mut bodies, &mut touches);
        forced += u32::from(passes.forced);
        let found: Vec<Vec2<f64>> = bodies.iter().map(|body| body.velocity).collect();
        let (before, after) = (scene.energy(&scene.velocities()), scene.energy(&found));
        // Thirty impulses at most, and sums over sixteen balls.
        assert!(after <= before * (1.0 + 1e-13), "{what}: energy from {before} to {after}");
        assert!(
            e < 1.0 || passes.forced || (after - before).abs() <= 1e-13 * before,
            "{what}: {before}, {after}"
        );
        if scene.walls.is_empty() {
            let change = scene.momentum(&found) - scene.momentum(&scene.velocities());
            assert!(change.norm() < 1e-13 * (1.0 + before), "{what}: momentum {change:?}");
        }
        for touch in &touches {
            let other = touch.b.map_or(Vec2::ZERO, |b| found[b]);
            assert!(
                (other - found[touch.a]).dot(touch.normal) > -1e-13 * (1.0 + before),
                "{what}: {touch:?}"
            );
            assert!(touch.impulse >= 0.0 && (touch.impulse > 0.0) == (touch.closing_speed > 0.0), "{what}");
        }
    }
    assert!(forced <= 6, "{forced} of 600 did not come to an end by themselves");
}

#[test]
fn balls_that_lose_everything_part_no_more_and_end() {
    let (found, _) = row(3).resolved(0.0);
    // Nothing bounces in the end, and the steps' error is of the first order where contacts close anew at each.
    assert!(farthest(&found, &[Vec2::new(1.0 / 3.0, 0.0); 3]) < 0.01, "{found:?}");
    let (found, passes) = rack().resolved(0.0);
    assert!(passes.forced, "{passes:?}");
    assert!(rack().energy(&found) < 0.2 * 50.0, "{found:?}");
}

#[test]
fn the_order_of_bodies_and_the_side_a_contact_is_seen_from_change_no_bit() {
    let mut random = Random::new(7);
    for number in 0..40 {
        let scene = if number % 4 == 0 { rack() } else { random_scene(&mut random) };
        let e = if number % 2 == 0 { 1.0 } else { random.unit() };
        let known = scene.resolved(e).0;
        let (bodies, touches) = scene.cluster::<f64>(e);
        let order = random.permutation(bodies.len());
        let new = |k: usize| order.iter().position(|&old| old == k).unwrap();
        let mut moved: Vec<Body<f64>> = order.iter().map(|&old| bodies[old]).collect();
        let mut renamed: Vec<Touch<f64>> = touches
            .iter()
            .map(|touch| match touch.b {
                Some(b) if random.flips() => {
                    Touch { a: new(b), b: Some(new(touch.a)), normal: -touch.normal, ..*touch }
                }
                b => Touch { a: new(touch.a), b: b.map(new), ..*touch },
            })
            .collect();
        resolve_hertz(&mut moved, &mut renamed);
        for (k, v) in known.iter().enumerate() {
            assert_eq!(moved[new(k)].velocity.to_f64(), v.to_f64(), "seed 7, number {number}, ball {k}");
        }
    }
}

#[test]
fn speed_mass_and_stiffness_have_no_scale() {
    for e in [1.0, 0.8] {
        let known = rack().resolved(e).0;
        let mut scene = rack();
        for ball in &mut scene.balls {
            ball.velocity = ball.velocity * 4.0;
            ball.mass *= 8.0;
        }
        let (mut bodies, mut touches) = scene.cluster::<f64>(e);
        for touch in &mut touches {
            touch.effective_radius *= 16.0;
        }
        resolve_hertz(&mut bodies, &mut touches);
        for (body, v) in bodies.iter().zip(&known) {
            assert_eq!(body.velocity.to_f64(), (*v * 4.0).to_f64());
        }
        // With a factor that is no power of two, as far as round-off allows.
        let mut scene = rack();
        scene.balls[0].velocity = scene.balls[0].velocity * 0.3;
        let found: Vec<Vec2<f64>> = scene.resolved(e).0.iter().map(|v| *v * (1.0 / 0.3)).collect();
        assert!(farthest(&found, &known) < 1e-12);
    }
}

#[test]
fn a_scene_in_the_mirror_gives_the_image() {
    let mut random = Random::new(13);
    for number in 0..60 {
        let scene = random_scene(&mut random);
        let e = random.between(0.3, 1.0);
        let flip = |v: Vec2<f64>| Vec2::new(-v.x, v.y);
        let mut image = scene.clone();
        for ball in &mut image.balls {
            (ball.position, ball.velocity) = (flip(ball.position), flip(ball.velocity));
        }
        for (point, normal) in &mut image.walls {
            (*point, *normal) = (flip(*point), flip(*normal));
        }
        let found: Vec<Vec2<f64>> = image.resolved(e).0.into_iter().map(flip).collect();
        assert!(farthest(&found, &scene.resolved(e).0) < 1e-12, "seed 13, number {number}, e = {e}");
    }
}

#[test]
fn bodies_in_space_give_the_planar_answer_bit_for_bit() {
    for e in [1.0, 0.9, 0.0] {
        for scene in [rack(), one_into_two(), row(5)] {
            let (mut bodies, mut touches) = scene.cluster::<f64>(e);
            let above = |v: Vec2<f64>| Vec3::above(v, 0.0);
            let mut solid: Vec<cluster::Body<f64, Vec3<f64>>> =
                bodies.iter().map(|b| cluster::Body::new(above(b.velocity), b.inverse_mass)).collect();
            let mut solid_touches: Vec<cluster::Touch<f64, Vec3<f64>>> =
                touches.iter().map(|t| cluster::Touch::new(t.a, t.b, above(t.normal), t.law)).collect();
            let planar = resolve_hertz(&mut bodies, &mut touches);
            assert_eq!(planar, resolve_hertz(&mut solid, &mut solid_touches));
            for (flat, body) in bodies.iter().zip(&solid) {
                assert_eq!(body.velocity, above(flat.velocity), "e = {e}");
            }
        }
    }
}

#[test]
fn a_ball_on_three_others_in_space_is_as_symmetric_as_they_are() {
    // Three touch each other on the table, the fourth comes down between them.
    let height = (8.0_f64 / 3.0).sqrt();
    let places: Vec<Vec3<f64>> = (0..3)
        .map(|k| {
            let turn = f64::from(k) * core::f64::consts::TAU / 3.0;
            Vec3::new(turn.cos(), turn.sin(), 0.0) * (2.0 / 3.0_f64.sqrt())
        })
        .collect();
    let law = DiscLaw::Balls(ball_ball::Law::ELASTIC);
    let mut bodies = vec![cluster::Body::new(Vec3::new(0.0, 0.0, -1.0), 1.0)];
    bodies.extend(places.iter().map(|_| cluster::Body::new(Vec3::ZERO, 1.0)));
    let top = Vec3::new(0.0, 0.0, height);
    let mut touches: Vec<cluster::Touch<f64, Vec3<f64>>> = (0..3)
        .map(|k| cluster::Touch::new(0, Some(k + 1), (places[k] - top).unit(), law))
        .chain((0..3).map(|k| cluster::Touch::new(k + 1, None, -Vec3::UP, law)))
        .collect();
    resolve_hertz(&mut bodies, &mut touches);
    let speed = |k: usize| bodies[k].velocity;
    for k in 2..4 {
        assert!((speed(k).norm() - speed(1).norm()).abs() < 1e-14 && (speed(k).z - speed(1).z).abs() < 1e-14);
    }
    assert!(speed(1).z >= 0.0 && speed(0).z > 0.0);
    let energy: f64 = bodies.iter().map(|body| body.velocity.norm_squared()).sum();
    assert!((energy - 1.0).abs() < 1e-14, "{energy}");
}

/// A law whose restitution falls with the speed.
#[derive(Clone, Copy)]
struct Softening;

impl TouchLaw<f64> for Softening {
    fn restitution(&self, closing_speed: f64) -> f64 {
        1.0 / (1.0 + closing_speed)
    }
}

#[test]
fn restitution_is_asked_for_at_the_closing_speed_and_kept_speed_is_honoured() {
    for (closing, kept, expected) in [(1.0, 0.0, 0.5), (3.0, 0.0, 0.75), (1.0, 0.8, 0.8), (1.0, 2.0, 1.0)] {
        let mut bodies = vec![Body::new(Vec2::new(closing, 0.0), 1.0), Body::new(Vec2::ZERO, 0.5)];
        let touch = cluster::Touch::new(0, Some(1), Vec2::new(1.0, 0.0), Softening);
        let mut touches = vec![cluster::Touch { kept_speed: kept, ..touch }];
        resolve_hertz(&mut bodies, &mut touches);
        let opening = bodies[1].velocity.x - bodies[0].velocity.x;
        assert!((opening - expected).abs() < 1e-13, "{closing}, {kept}: {opening}");
        assert_eq!(touches[0].closing_speed, closing);
    }
}

#[test]
fn a_contact_pushed_shut_from_rest_is_told_the_speed_that_its_work_is_worth() {
    let (mut bodies, mut touches) = row(3).cluster::<f64>(1.0);
    resolve_hertz(&mut bodies, &mut touches);
    assert_eq!(touches[0].closing_speed, 1.0);
    // Between the 1 of balls that are apart and the 0.986 that a long row passes on.
    assert!(touches[1].closing_speed > 0.8 && touches[1].closing_speed < 1.0, "{:?}", touches[1]);
}

#[test]
fn a_point_counts_as_large_as_the_largest_contact() {
    let (mut bodies, mut touches) = one_into_two().cluster::<f64>(1.0);
    for touch in &mut touches {
        touch.effective_radius = 0.0;
    }
    resolve_hertz(&mut bodies, &mut touches);
    let found: Vec<Vec2<f64>> = bodies.iter().map(|body| body.velocity).collect();
    assert_eq!(found, one_into_two().resolved(1.0).0);
}

#[test]
fn dual_numbers_have_the_bits_of_f64_and_the_derivatives_of_the_law() {
    let scene = rack();
    let (mut bodies, mut touches) = scene.cluster::<Dual<1>>(0.9);
    bodies[0] = Body::new(Vec2::new(Dual::variable(0.0, 0), Dual::from_f64(-10.0)), Dual::ONE);
    resolve_hertz(&mut bodies, &mut touches);
    let known = scene.resolved(0.9).0;
    for (body, v) in bodies.iter().zip(&known) {
        assert_eq!(body.velocity.to_f64(), v.to_f64());
    }
    let side = |x: f64| {
        let mut scene = rack();
        scene.balls[0].velocity.x = x;
        scene.resolved(0.9).0
    };
    let h = 1e-5;
    for ((body, up), down) in bodies.iter().zip(side(h)).zip(side(-h)) {
        for (found, expected) in [
            (body.velocity.x.derivatives[0], (up.x - down.x) / (2.0 * h)),
            (body.velocity.y.derivatives[0], (up.y - down.y) / (2.0 * h)),
        ] {
            // Steps begin and end at other contacts' times, which a difference sees and a derivative does not.
            assert!((found - expected).abs() < 1e-3, "{found} and {expected}");
        }
    }
    // Two balls: the opening speed is e u, so its derivative by e is u and by u is e.
    let e = Dual::<2>::variable(0.7, 0);
    let law = DiscLaw::Balls(ball_ball::Law::Restitution(Restitution { normal: e }));
    let mut bodies = vec![
        Body::new(Vec2::new(Dual::variable(2.0, 1), Dual::ZERO), Dual::ONE),
        Body::new(Vec2::ZERO, Dual::ONE),
    ];
    resolve_hertz(&mut bodies, &mut [Touch::new(0, Some(1), Vec2::new(Dual::ONE, Dual::ZERO), law)]);
    let opening = bodies[1].velocity.x - bodies[0].velocity.x;
    assert!((opening.derivatives[0] - 2.0).abs() < 1e-12 && (opening.derivatives[1] - 0.7).abs() < 1e-12);
}

#[test]
fn double_double_runs_the_same_steps_with_less_round_off() {
    for e in [1.0, 0.9] {
        for scene in [rack(), row(3), one_into_two()] {
            let (mut bodies, mut touches) = scene.cluster::<DoubleDouble>(e);
            resolve_hertz(&mut bodies, &mut touches);
            let found: Vec<Vec2<f64>> =
                bodies.iter().map(|body| Vec2::from_f64(body.velocity.to_f64())).collect();
            assert!(farthest(&found, &scene.resolved(e).0) < 1e-12, "e = {e}");
        }
    }
}

#[test]
fn the_order_of_balls_in_a_file_changes_no_bit_of_a_break() {
    let mut original = bundled("triangle_break");
    (original.physics.cluster, original.duration) = (Some(Cluster::Hertz), Some(0.3));
    let known = simulate(&original).unwrap();
    assert!(known.diagnostics.clusters > 0 && known.diagnostics.forced_clusters == 0);
    let mut random = Random::new(17);
    for _ in 0..3 {
        let order = random.permutation(original.balls.len());
        let mut scenario = original.clone();
        scenario.balls = order.iter().map(|&k| original.balls[k].clone()).collect();
        let found = simulate(&scenario).unwrap().final_state();
        let expected: Vec<_> = order.iter().map(|&k| known.final_state()[k]).collect();
        assert_eq!(bits(&found), bits(&expected), "seed 17, {order:?}");
    }
}

#[test]
fn a_run_with_cushions_in_its_clusters_keeps_account_of_its_energy() {
    for e in [1.0, 0.8] {
        // Two in a row at the right cushion, and a third that runs into them.
        let row = [([0.3, 0.5], [1.0, 0.0]), ([0.7, 0.5], [0.0, 0.0]), ([0.9, 0.5], [0.0, 0.0])];
        let balls = row.map(|(position, velocity)| ball(0.1, position, velocity));
        let physics = json!({ "cluster": "hertz",
            "ball_ball": { "law": "restitution", "normal": e },
            "ball_cushion": { "law": "restitution", "normal": e, "tangential": 0.9 } });
        let mut scenario = scenario(&rectangle(1.0, 1.0), &physics, &balls);
        (scenario.duration, scenario.record) = (Some(2.0), Some(Record::All));
        let run = simulate(&scenario).unwrap();
        let found = &run.diagnostics;
        assert!(found.clusters > 0 && found.forced_clusters == 0, "{found:?}");
        assert!(found.energy_gain < 1e-14 && found.energy_drift < 1e-13, "{found:?}");
        let first = run.log.events.iter().filter(|event| event.time == run.log.events[0].time);
        assert_eq!(first.filter(|event| event.cushion.is_some()).count(), 1, "{:?}", run.log.events);
    }
}
