//! What every law of contact keeps: one table of laws, and the invariants that all of them are held to.
//!
//! A new law joins by one line in the table.

use crate::kit::images::{assert_renumbering_changes_nothing, distance, mirrored, reflect_state};
use crate::kit::random::Random;
use crate::kit::scenes::{ball, grid_balls, random_balls, rectangle, scenario, tables};
use carom::flight::State;
use carom::geometry::Vec2;
use carom::law::ball_ball::{self, Pair};
use carom::law::ball_cushion;
use carom::model::Disc;
use carom::scalar::{DoubleDouble, Dual, Scalar};
use carom::scenario::{Scenario, System, json_schema};
use carom::simulate::simulate;
use serde_json::{Value, json};

/// Laws between balls, as a scenario writes them.
const BALL_BALL: &[&str] = &[
    r#"{ "law": "elastic" }"#,
    r#"{ "law": "restitution", "normal": 0.7 }"#,
    r#"{ "law": "restitution", "normal": 0.0 }"#,
];

/// Laws of cushions.
const BALL_CUSHION: &[&str] = &[
    r#"{ "law": "elastic" }"#,
    r#"{ "law": "restitution", "normal": 0.8 }"#,
    r#"{ "law": "restitution", "normal": 0.4, "tangential": 0.9 }"#,
    r#"{ "law": "restitution", "normal": 1.0, "tangential": 0.0 }"#,
    r#"{ "law": "damping", "factor": 0.8 }"#,
    r#"{ "law": "damping", "factor": 0.0 }"#,
];

/// Laws of balls with spin, which discs do not have: a check refuses them here.
const WITH_SPIN: &[&str] = &["frictional", "mathavan_2014", "han_2005", "mathavan_2010", "stronge_compliant"];

/// Contacts tried of each law.
const CONTACTS: u64 = 300;

/// A dozen roundings.
const ROUND_OFF: f64 = 12.0 * f64::EPSILON;

/// Every law between balls with every law of cushions.
fn pairs() -> impl Iterator<Item = [&'static str; 2]> {
    BALL_BALL.iter().flat_map(|a| BALL_CUSHION.iter().map(move |b| [*a, *b]))
}

/// The laws of a table, and each with one of its parameters at either end of the range that the schema gives it.
fn with_edges(definition: &str, table: &[&str]) -> Vec<String> {
    let schema = json_schema();
    let choices = schema["$defs"][definition]["oneOf"].as_array().unwrap();
    let mut laws: Vec<String> = table.iter().map(ToString::to_string).collect();
    for law in table.iter().map(|text| serde_json::from_str::<Value>(text).unwrap()) {
        let choice =
            choices.iter().find(|choice| choice["properties"]["law"]["const"] == law["law"]).unwrap();
        for (key, property) in choice["properties"].as_object().unwrap() {
            for end in ["minimum", "maximum"].into_iter().filter_map(|end| property[end].as_f64()) {
                let mut edge = law.clone();
                edge[key] = json!(end);
                laws.push(edge.to_string());
            }
        }
    }
    assert!(laws.len() > table.len(), "{definition}: no parameter has a range");
    laws
}

fn physics([ball_ball, ball_cushion]: [&str; 2]) -> Value {
    let law = |text: &str| -> Value { serde_json::from_str(text).unwrap() };
    json!({ "ball_ball": law(ball_ball), "ball_cushion": law(ball_cushion) })
}

/// The two laws in any scalar.
fn laws<S: Scalar>(physics: &Value) -> (ball_ball::Law<S>, ball_cushion::Law<S>) {
    let scenario = scenario(&rectangle(2.0, 2.0), physics, &[ball(0.1, [1.0, 1.0], [0.0, 0.0])]);
    let system = System::new(&scenario);
    (system.ball_ball, system.cushion_laws[0])
}

/// A ball at a cushion.
#[derive(Clone, Copy)]
struct AtCushion {
    normal: [f64; 2],
    velocity: [f64; 2],
}

/// Two balls in touch.
#[derive(Clone, Copy)]
struct InTouch {
    masses: [f64; 2],
    separation: [f64; 2],
    velocities: [[f64; 2]; 2],
}

/// Random contacts that close, at speeds of many sizes.
fn at_cushion(seed: u64) -> AtCushion {
    let mut random = Random::new(seed);
    let normal = random.direction();
    let [closing, along] = [0, 1].map(|_| random.magnitude(1e-3, 1e3));
    let along = if random.flips() { along } else { -along };
    let velocity = [-closing * normal[0] - along * normal[1], -closing * normal[1] + along * normal[0]];
    AtCushion { normal, velocity }
}

fn in_touch(seed: u64) -> InTouch {
    let mut random = Random::new(seed);
    let masses = [0, 1].map(|_| random.magnitude(0.1, 10.0));
    let AtCushion { normal, velocity } = at_cushion(seed);
    let common = random.direction();
    let length = random.magnitude(0.1, 10.0);
    let separation = normal.map(|c| -c * length);
    let first = [velocity[0] + common[0], velocity[1] + common[1]];
    InTouch { masses, separation, velocities: [first, common] }
}

/// What is left of a velocity after a contact with a cushion: by itself, and in a cluster.
fn rebound<S: Scalar>(law: &ball_cushion::Law<S>, contact: AtCushion) -> [Vec2<S>; 2] {
    let (normal, velocity) = (Vec2::from_f64(contact.normal), Vec2::from_f64(contact.velocity));
    let scale = S::ONE / normal.norm_squared();
    let restitution = law.restitution(-velocity.dot(normal));
    let alone = law.rebound(velocity, (normal, scale), restitution).velocity;
    [alone, law.slide(velocity, (normal, scale)).unwrap_or(velocity)]
}

/// The velocities of two balls after their contact.
fn collide<S: Scalar>(law: &ball_ball::Law<S>, contact: InTouch) -> [Vec2<S>; 2] {
    let discs = contact.masses.map(|mass| Disc::new(S::ONE, S::from_f64(mass)));
    let velocities = contact.velocities.map(Vec2::from_f64);
    let pair = Pair::new([&discs[0], &discs[1]], Vec2::from_f64(contact.separation), velocities);
    let impulse = law.impact(&pair, law.restitution(pair.closing_speed)).impulse;
    let change = |k: usize| pair.normal * (impulse * discs[k].inverse_mass);
    [velocities[0] - change(0), velocities[1] + change(1)]
}

fn speed([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}

fn vector(components: [f64; 2]) -> Vec2<f64> {
    Vec2::from_f64(components)
}

fn apart(a: Vec2<f64>, b: Vec2<f64>) -> f64 {
    (a - b).norm()
}

/// Rotations and mirrors of the plane, as the images of both axes.
fn images() -> Vec<[[f64; 2]; 2]> {
    let turn = |angle: f64| [[libm::cos(angle), libm::sin(angle)], [-libm::sin(angle), libm::cos(angle)]];
    let [x, y] = turn(1.0);
    vec![[[-1.0, 0.0], [0.0, 1.0]], [[1.0, 0.0], [0.0, -1.0]], [x, y], [x, y.map(|c| -c)], turn(2.5)]
}

fn image_of([x, y]: [f64; 2], image: &[[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|axis| x * image[0][axis] + y * image[1][axis])
}

#[test]
fn every_law_that_a_scenario_of_discs_can_name_is_in_the_table() {
    for (definition, table) in [("BallBall", BALL_BALL), ("BallCushion", BALL_CUSHION)] {
        let choices = json_schema()["$defs"][definition]["oneOf"].as_array().unwrap();
        for choice in choices {
            let name = choice["properties"]["law"]["const"].as_str().unwrap();
            let has = |text: &&str| text.contains(&format!("\"law\": \"{name}\""));
            let is_here = table.iter().any(has);
            assert!(
                is_here != WITH_SPIN.contains(&name),
                "{definition} {name:?} is not in the table of invariants"
            );
        }
        assert!(choices.len() > 1);
    }
}

#[test]
fn a_ball_leaves_a_cushion_and_gains_no_energy() {
    for text in &with_edges("BallCushion", BALL_CUSHION) {
        let (_, law) = laws::<f64>(&physics([BALL_BALL[0], text]));
        for contact in (0..CONTACTS).map(at_cushion) {
            let (normal, before) = (vector(contact.normal), vector(contact.velocity));
            let closing = -before.dot(normal);
            let restitution = law.restitution(closing);
            assert!((0.0..=1.0).contains(&restitution), "{text}: e = {restitution}");
            let found = law.rebound(before, (normal, 1.0 / normal.norm_squared()), restitution);
            let tolerance = ROUND_OFF * before.norm();
            let opening = found.velocity.dot(normal);
            assert!((opening - restitution * closing).abs() <= tolerance, "{text}: leaves at {opening}");
            let energy = |v: Vec2<f64>| 0.5 * v.norm_squared();
            let lost = energy(before) - energy(found.velocity);
            let tolerance = ROUND_OFF * energy(before);
            assert!(lost >= -tolerance, "{text}: gains {:e}", -lost);
            assert!(
                (lost - found.energy_loss).abs() <= tolerance,
                "{text}: loses {lost}, and says {}",
                found.energy_loss
            );
            assert!(lost.abs() <= tolerance || !law.is_lossless(), "{text}: loses {lost:e}");
            assert!(
                found.velocity == Vec2::ZERO || !law.is_dead(),
                "{text}: is not dead, {:?}",
                found.velocity
            );
        }
    }
}

#[test]
fn along_a_cushion_a_ball_in_a_cluster_gains_no_energy_and_keeps_its_normal_velocity() {
    for text in &with_edges("BallCushion", BALL_CUSHION) {
        let (_, law) = laws::<f64>(&physics([BALL_BALL[0], text]));
        for contact in (0..CONTACTS).map(at_cushion) {
            let (normal, before) = (vector(contact.normal), vector(contact.velocity));
            let [_, after] = rebound(&law, contact);
            let tolerance = ROUND_OFF * before.norm();
            assert!((after - before).dot(normal).abs() <= tolerance, "{text}: {after:?}");
            assert!(after.norm() <= before.norm() + tolerance, "{text}: gains");
            assert!(after == before || !law.is_lossless(), "{text}: {after:?}");
        }
    }
}

#[test]
fn two_balls_part_and_gain_no_energy() {
    for text in &with_edges("BallBall", BALL_BALL) {
        let (law, _) = laws::<f64>(&physics([text, BALL_CUSHION[0]]));
        for contact in (0..CONTACTS).map(in_touch) {
            let discs = contact.masses.map(|mass| Disc::new(1.0, mass));
            let before = contact.velocities.map(vector);
            let pair = Pair::new([&discs[0], &discs[1]], vector(contact.separation), before);
            let restitution = law.restitution(pair.closing_speed);
            assert!((0.0..=1.0).contains(&restitution), "{text}: e = {restitution}");
            let found = law.impact(&pair, restitution);
            assert!(found.impulse > 0.0, "{text}: pulls");
            let after = collide(&law, contact);
            let size = before[0].norm() + before[1].norm() + after[0].norm() + after[1].norm();
            let opening = (after[1] - after[0]).dot(pair.normal);
            let error = opening - restitution * pair.closing_speed;
            assert!(error.abs() <= ROUND_OFF * size, "{text}: parts at {opening}");
            let energy = |v: &[Vec2<f64>; 2]| -> f64 {
                (0..2).map(|k| 0.5 * contact.masses[k] * v[k].norm_squared()).sum()
            };
            let lost = energy(&before) - energy(&after);
            let tolerance = ROUND_OFF * (contact.masses[0] + contact.masses[1]) * size * size;
            assert!(lost >= -tolerance, "{text}: gains {:e}", -lost);
            assert!(
                (lost - found.energy_loss).abs() <= tolerance,
                "{text}: loses {lost}, and says {}",
                found.energy_loss
            );
            assert!(lost.abs() <= tolerance || !law.is_lossless(), "{text}: loses {lost:e}");
        }
    }
}

#[test]
fn two_balls_may_change_places() {
    for text in BALL_BALL {
        let (law, _) = laws::<f64>(&physics([text, BALL_CUSHION[0]]));
        for contact in (0..CONTACTS).map(in_touch) {
            let InTouch { masses: [m, n], separation, velocities: [v, w] } = contact;
            let swapped = InTouch { masses: [n, m], separation: separation.map(|c| -c), velocities: [w, v] };
            let ([a, b], [c, d]) = (collide(&law, contact), collide(&law, swapped));
            assert_eq!((a, b), (d, c), "{text}");
        }
    }
}

#[test]
fn mirrored_and_rotated_contacts_have_mirrored_and_rotated_outcomes() {
    for [ball_ball, ball_cushion] in pairs() {
        let (between_balls, at_cushions) = laws::<f64>(&physics([ball_ball, ball_cushion]));
        for (seed, image) in (0..CONTACTS).flat_map(|seed| images().into_iter().map(move |i| (seed, i))) {
            let contact = at_cushion(seed);
            let seen = AtCushion {
                normal: image_of(contact.normal, &image),
                velocity: image_of(contact.velocity, &image),
            };
            for (a, b) in rebound(&at_cushions, contact).into_iter().zip(rebound(&at_cushions, seen)) {
                let error = apart(vector(image_of(a.to_f64(), &image)), b);
                assert!(error <= ROUND_OFF * speed(contact.velocity), "{ball_cushion}: {error:e}");
            }
            let contact = in_touch(seed);
            let seen = InTouch {
                separation: image_of(contact.separation, &image),
                velocities: contact.velocities.map(|v| image_of(v, &image)),
                ..contact
            };
            // A light ball may leave at twice the speed of a heavy one.
            let size = 2.0 * contact.velocities.map(speed).iter().sum::<f64>();
            for (a, b) in collide(&between_balls, contact).into_iter().zip(collide(&between_balls, seen)) {
                let error = apart(vector(image_of(a.to_f64(), &image)), b);
                assert!(error <= ROUND_OFF * size, "{ball_ball}: {error:e}");
            }
        }
    }
}

#[test]
fn all_number_types_agree() {
    for laws_of_pair in pairs() {
        let physics = physics(laws_of_pair);
        let (balls, cushions) = laws::<f64>(&physics);
        let (dual_balls, dual_cushions) = laws::<Dual<1>>(&physics);
        let (fine_balls, fine_cushions) = laws::<DoubleDouble>(&physics);
        for seed in 0..CONTACTS {
            let (at, touch) = (at_cushion(seed), in_touch(seed));
            let plain = [rebound(&cushions, at), collide(&balls, touch)].concat();
            let dual = [rebound(&dual_cushions, at), collide(&dual_balls, touch)].concat();
            let fine = [rebound(&fine_cushions, at), collide(&fine_balls, touch)].concat();
            let size = speed(at.velocity) + 2.0 * touch.velocities.map(speed).iter().sum::<f64>();
            for ((plain, dual), fine) in plain.into_iter().zip(dual).zip(fine) {
                assert_eq!((plain.x, plain.y), (dual.x.value, dual.y.value), "{laws_of_pair:?}");
                let error = apart(plain, vector(fine.to_f64()));
                assert!(error <= ROUND_OFF * size, "{laws_of_pair:?}: {error:e}");
            }
        }
    }
}

/// A law with each of its parameters smaller by a billionth.
fn nearby(text: &str) -> String {
    let mut law: Value = serde_json::from_str(text).unwrap();
    for (_, parameter) in law.as_object_mut().unwrap().iter_mut().filter(|(_, value)| value.is_number()) {
        *parameter = json!(parameter.as_f64().unwrap() * (1.0 - 1e-9));
    }
    law.to_string()
}

#[test]
fn a_little_more_speed_or_another_parameter_changes_little() {
    for [ball_ball, ball_cushion] in pairs() {
        let (balls, cushions) = laws::<f64>(&physics([ball_ball, ball_cushion]));
        let (near_balls, near_cushions) = laws::<f64>(&physics([&nearby(ball_ball), &nearby(ball_cushion)]));
        for seed in 0..CONTACTS {
            let (at, touch) = (at_cushion(seed), in_touch(seed));
            let faster = |v: [f64; 2]| v.map(|c| c * (1.0 + 1e-9));
            let at_more = AtCushion { velocity: faster(at.velocity), ..at };
            let touch_more = InTouch { velocities: touch.velocities.map(faster), ..touch };
            let here = [rebound(&cushions, at), collide(&balls, touch)].concat();
            let nearby = [rebound(&near_cushions, at_more), collide(&near_balls, touch_more)].concat();
            let size = speed(at.velocity) + 2.0 * touch.velocities.map(speed).iter().sum::<f64>();
            for (a, b) in here.into_iter().zip(nearby) {
                // A hundred times the change: what a law may make of it.
                assert!(apart(a, b) <= 1e-7 * size, "{ball_ball}, {ball_cushion}: {:e}", apart(a, b));
            }
        }
    }
}

/// A random scene under two laws, short enough for round-off to stay small.
fn scene(laws: [&str; 2], seed: u64) -> Scenario {
    let mut random = Random::new(seed);
    let tables = tables();
    let table = &tables[seed as usize % tables.len()].1;
    let balls = random_balls(&mut random, table, 6, [0.01, 0.06], [0.5, 2.0]);
    let mut scenario = scenario(table, &physics(laws), &balls);
    (scenario.duration, scenario.max_events) = (Some(4.0), Some(40));
    scenario
}

#[test]
fn runs_keep_momentum_and_never_gain_energy() {
    for (k, laws) in pairs().enumerate() {
        for seed in 0..12 {
            let what = format!("seed {seed}, {laws:?}");
            let run = simulate(&scene(laws, 100 * k as u64 + seed)).unwrap();
            let (said, tolerance) = (&run.diagnostics, 1e-14 * run.diagnostics.initial_energy);
            assert!(said.energy_error <= tolerance && said.energy_gain <= tolerance, "{what}: {said:?}");
            assert!(said.momentum_error <= 1e-14 * (1.0 + said.initial_energy), "{what}: {said:?}");
            assert!(said.final_energy <= said.initial_energy + 10.0 * tolerance, "{what}: {said:?}");
            assert!(said.energy_loss <= tolerance || !run.system.is_lossless, "{what}: {said:?}");
        }
    }
}

#[test]
fn renumbering_changes_no_bit_under_any_laws() {
    for (k, laws) in pairs().enumerate() {
        let mut clusters = 0;
        for seed in 0..20 {
            let mut random = Random::new(1000 * k as u64 + seed);
            let balls = grid_balls(&mut random);
            let mut scenario = scenario(&rectangle(2.0, 2.0), &physics(laws), &balls);
            (scenario.duration, scenario.max_events) = (Some(3.0), Some(1000));
            let what = format!("seed {seed}, {laws:?}");
            clusters += assert_renumbering_changes_nothing(&scenario, &mut random, &what);
            let said = simulate(&scenario).unwrap().diagnostics;
            assert!(said.energy_gain <= 1e-14 * said.initial_energy, "{what}: {said:?}");
        }
        assert!(clusters > 5, "{laws:?}: {clusters} clusters");
    }
}

#[test]
fn a_mirrored_scene_runs_mirrored() {
    for (k, laws) in pairs().enumerate() {
        for seed in 0..4 {
            let mut scenario = scene(laws, 7000 + 100 * k as u64 + seed);
            scenario.collisions = Some(10);
            let what = format!("seed {seed}, {laws:?}");
            let run = simulate(&scenario).unwrap();
            let image = simulate(&mirrored(&scenario, seed as usize % 2)).unwrap();
            assert_eq!(run.diagnostics.events, image.diagnostics.events, "{what}");
            let back: Vec<State<f64>> = image
                .final_state()
                .into_iter()
                .map(|state| reflect_state(state, seed as usize % 2))
                .collect();
            // As in `symmetry`: a round-off of 1e-15 in each contact, and its growth.
            let apart = distance(&run.final_state(), &back, 1.0);
            assert!(apart < 1e-8, "{what}: {apart:e} apart");
        }
    }
}
