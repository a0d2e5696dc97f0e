//! The cluster law `hertz`: its reference values, an integration of stiff balls with all their places, and two balls.

use crate::kit::random::Random;
use crate::kit::touching::{Scene, farthest, one_into_two, rack, random_scene, row};
use carom::geometry::Vec2;
use carom::law::cluster::Passes;

#[test]
fn three_in_a_row_part_as_stiff_balls_do() {
    let (found, _) = row(3).resolved(1.0);
    // The last of them is within the reference value's last digit.
    let expected = [-0.0710, 0.0764, 0.9945].map(|speed| Vec2::new(speed, 0.0));
    assert!(farthest(&found, &expected) < 1e-4, "{found:?}");
}

#[test]
fn the_last_of_a_long_row_takes_what_a_solitary_wave_carries() {
    // Hinch and Saint-Jean (1999), the fragmentation of a line of balls by an impact: 0.986 of the speed, and the first
    // ball comes back with 0.071 of it.
    let (found, passes) = row(20).resolved(1.0);
    assert!((found[19].x - 0.986).abs() < 1e-3 && (found[0].x + 0.071).abs() < 1e-3, "{found:?}");
    assert!(!passes.forced);
}

#[test]
fn one_ball_into_a_touching_pair_gives_the_symmetric_answer() {
    let (found, _) = one_into_two().resolved(1.0);
    let side = 0.12_f64.sqrt();
    let expected = [[-0.2, 0.0], [0.6, side], [0.6, -side]].map(Vec2::from_f64);
    // Symmetry leaves energy and momentum to decide, and both are exact: a hundred steps of round-off.
    assert!(farthest(&found, &expected) < 1e-14, "{found:?}");
}

#[test]
fn the_perfect_break_is_that_of_the_published_integration() {
    // J. Belk, Mathematics Stack Exchange, "Perfectly centered break of a perfectly aligned pool ball rack": speeds, and
    // angles from the direction back to the shooter, of balls numbered by rows from the apex.
    let table = [
        (0, 1.79, 0.0),
        (1, 1.20, 0.0),
        (3, 1.57, 40.1),
        (6, 1.42, 43.9),
        (5, 0.12, 0.0),
        (10, 1.31, 82.1),
        (9, 0.25, 161.8),
        (15, 5.60, 150.0),
        (14, 2.57, 178.2),
        (13, 2.63, 180.0),
    ];
    let (found, passes) = rack().resolved(1.0);
    for (number, speed, degrees) in table {
        let v = found[number];
        let angle = f64::atan2(v.x, v.y).to_degrees().abs();
        assert!((v.norm() - speed).abs() < 0.01, "ball {number}: {v:?}");
        // Rounded to 0.1, and the steps' error of 1e-4 of the speed.
        assert!((angle - degrees).abs() < 0.2, "ball {number}: {v:?} at {angle}");
    }
    assert_eq!(passes, Passes { count: 1, forced: false });
}

#[test]
fn the_perfect_break_comes_out_as_its_own_mirror_image() {
    let pairs = [(2, 3), (4, 6), (7, 10), (8, 9), (11, 15), (12, 14)];
    for e in [1.0, 0.95, 0.5, 0.1] {
        let (found, _) = rack().resolved(e);
        for (left, right) in pairs {
            let far = (found[left] - Vec2::new(-found[right].x, found[right].y)).norm();
            // Sums of two to six impulses, in the order of place and so mirrored in the other order: a few round-offs of
            // 10 in each of some 200 steps, which do not add up to a tenth of this.
            assert!(far < 1e-12, "e = {e}: {left} and {right} are {far:e} apart");
        }
    }
}

/// Stiff balls moved by small steps of Runge and Kutta, with all their places: velocities after all have parted. None where some come
/// together again so slowly that they have moved on by then.
fn integrated(scene: &Scene) -> Option<Vec<Vec2<f64>>> {
    const STIFFNESS: f64 = 1e14;
    let contacts = scene.contacts();
    let count = scene.balls.len();
    let rates = |state: &[Vec2<f64>]| -> Vec<Vec2<f64>> {
        let (places, velocities) = state.split_at(count);
        let mut rates = velocities.to_vec();
        rates.resize(2 * count, Vec2::ZERO);
        for &(a, b, point, normal) in &contacts {
            let (overlap, normal) = match b {
                Some(b) => {
                    let apart = places[b] - places[a];
                    (scene.balls[a].radius + scene.balls[b].radius - apart.norm(), apart.unit())
                }
                None => (scene.balls[a].radius - (point - places[a]).dot(normal), normal),
            };
            let force = STIFFNESS * scene.effective_radius(a, b).sqrt() * overlap.max(0.0).powf(1.5);
            rates[count + a] = rates[count + a] - normal * (force / scene.balls[a].mass);
            if let Some(b) = b {
                rates[count + b] = rates[count + b] + normal * (force / scene.balls[b].mass);
            }
        }
        rates
    };
    let moved = |state: &[Vec2<f64>], rates: &[Vec2<f64>], time: f64| -> Vec<Vec2<f64>> {
        state.iter().zip(rates).map(|(x, v)| *x + *v * time).collect()
    };
    let mut state: Vec<Vec2<f64>> = scene.balls.iter().map(|ball| ball.position).collect();
    state.extend(scene.velocities());
    // A contact of unit balls at unit speed lasts 3.2 k^(-2/5) or so; slower and heavier ones a few times that.
    let unit = STIFFNESS.powf(-0.4);
    let step = unit / 200.0;
    // Until nothing presses and nothing comes together any more.
    let goes_on = |state: &[Vec2<f64>]| {
        contacts.iter().any(|&(a, b, point, normal)| {
            let velocity = |k: usize| state[count + k];
            let (gap, closing) = match b {
                Some(b) => {
                    let apart = state[b] - state[a];
                    let radii = scene.balls[a].radius + scene.balls[b].radius;
                    (apart.norm() - radii, (velocity(a) - velocity(b)).dot(apart.unit()))
                }
                None => ((point - state[a]).dot(normal) - scene.balls[a].radius, velocity(a).dot(normal)),
            };
            gap < 0.0 || closing > 1e-9
        })
    };
    let mut steps = 0;
    while steps < 100 || goes_on(&state) {
        steps += 1;
        if steps > 100_000 {
            return None;
        }
        let k1 = rates(&state);
        let k2 = rates(&moved(&state, &k1, step / 2.0));
        let k3 = rates(&moved(&state, &k2, step / 2.0));
        let k4 = rates(&moved(&state, &k3, step));
        for (k, x) in state.iter_mut().enumerate() {
            *x = *x + (k1[k] + (k2[k] + k3[k]) * 2.0 + k4[k]) * (step / 6.0);
        }
    }
    Some(state.split_off(count))
}

#[test]
fn stiff_balls_integrated_with_their_places_end_on_the_same_velocities() {
    let mut scenes = vec![row(3), one_into_two()];
    let mut random = Random::new(11);
    scenes.extend((0..14).map(|_| random_scene(&mut random)));
    let mut compared = 0;
    for (number, scene) in scenes.iter().enumerate() {
        let Some(expected) = integrated(scene) else { continue };
        let found = scene.resolved(1.0).0;
        compared += 1;
        // The oracle's overlaps are some 1e-5 of a radius, and turn its normals by as much; the law's own steps leave
        // some 3e-5 of each speed.
        let far = farthest(&found, &expected);
        assert!(far < 3e-4, "scene {number} of seed 11: {far:e} off: {found:?}, {expected:?}");
    }
    assert!(compared >= 12, "only {compared} scenes came to an end");
}

/// A row with losses, by many more and plainer steps: the rule of the law as it is told, in one dimension.
fn small_steps(masses: &[f64], velocities: &[f64], e: f64) -> Vec<f64> {
    let mut velocities = velocities.to_vec();
    let mut springs = vec![(0.0_f64, false, 0.0_f64); masses.len() - 1];
    let step = 1e-4;
    for _ in 0..400_000 {
        let forces: Vec<f64> = springs.iter().map(|(overlap, ..)| overlap.max(0.0).powf(1.5)).collect();
        for (k, force) in forces.iter().enumerate() {
            velocities[k] -= force / masses[k] * step;
            velocities[k + 1] += force / masses[k + 1] * step;
        }
        for (k, (overlap, closes, from)) in springs.iter_mut().enumerate() {
            let closing = velocities[k] - velocities[k + 1];
            if *closes && closing <= 0.0 {
                let work = overlap.powf(2.5) - *from;
                *overlap = (overlap.powf(2.5) - (1.0 - e * e) * work).max(0.0).powf(0.4);
            }
            if !*closes && closing > 0.0 {
                *from = overlap.max(0.0).powf(2.5);
            }
            *closes = closing > 0.0;
            *overlap += closing * step;
        }
    }
    velocities
}

#[test]
fn rows_with_losses_follow_the_rule_as_it_is_told() {
    for (masses, velocities) in [
        (vec![1.0, 1.0, 1.0], vec![1.0, 0.0, 0.0]),
        (vec![1.0, 2.0, 0.5, 1.0], vec![1.0, 0.0, 0.0, -0.4]),
        (vec![1.0; 5], vec![1.0, 0.0, 0.0, 0.0, 0.0]),
    ] {
        for e in [0.95, 0.8, 0.5] {
            let mut scene = row(masses.len());
            for ((ball, mass), v) in scene.balls.iter_mut().zip(&masses).zip(&velocities) {
                (ball.mass, ball.velocity) = (*mass, Vec2::new(*v, 0.0));
            }
            let found = scene.resolved(e).0;
            let expected = small_steps(&masses, &velocities, e);
            for (a, b) in found.iter().zip(&expected) {
                assert!((a.x - b).abs() < 5e-4, "e = {e}, {masses:?}: {found:?}, {expected:?}");
            }
        }
    }
}

#[test]
fn two_balls_part_with_their_restitution_whatever_it_is_and_whatever_their_masses() {
    let mut random = Random::new(3);
    for number in 0..300 {
        let e = match number % 3 {
            0 => random.unit(),
            1 => random.magnitude(1e-9, 1.0),
            _ => f64::from(number as u8 % 2),
        };
        let mut scene = row(2);
        let turn = random.direction();
        scene.balls[1].position = Vec2::from_f64(turn) * 2.0;
        for ball in &mut scene.balls {
            ball.mass = random.magnitude(1e-3, 1e3);
            ball.velocity = Vec2::from_f64(random.direction()) * random.magnitude(1e-3, 1e3);
        }
        let normal = scene.contacts()[0].3;
        let closing = (scene.balls[0].velocity - scene.balls[1].velocity).dot(normal);
        let (found, passes) = scene.resolved(e);
        let opening = (found[1] - found[0]).dot(normal);
        assert_eq!(passes.count, u32::from(closing > 0.0), "seed 3, number {number}");
        if closing > 0.0 {
            // The energy decides: its round-off counts as one over e, and where that is 1e-5 the steps' own error
            // remains, e times 1e-4. The velocities themselves are rounded.
            let speeds = scene.balls[0].velocity.norm() + scene.balls[1].velocity.norm();
            let tolerance = 1e-13 * speeds + 3e-9 * closing * f64::from(u8::from(e > 0.0 && e < 1e-4));
            let tolerance = tolerance + 1e-14 * closing / e.max(1e-5) * f64::from(u8::from(e > 0.0));
            let far = (opening - e * closing).abs();
            assert!(far < tolerance, "seed 3, number {number}, e = {e}: {opening} of {closing}, {far:e} off");
        }
    }
}
