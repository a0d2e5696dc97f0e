//! Balls that leave the cloth: over others, onto noses and jaws, off the table, over pockets and into them.

use crate::kit::cloth::{
    GRAVITY, RADIUS, at, events, first, kinds_of, on_table, run, run_until, still, wide,
};
use crate::kit::random::Random;
use crate::kit::scenes::rectangle;
use carom::flight::Motion;
use carom::run::{Kind, Status};
use serde_json::{Value, json};

const NOSE: f64 = 0.036;

/// A ball in the air.
fn thrown(id: &str, position: [f64; 3], velocity: [f64; 3]) -> Value {
    json!({ "id": id, "position": position, "velocity": velocity })
}

/// A ball thrown up from the cloth.
fn jumping(id: &str, [x, y]: [f64; 2], velocity: [f64; 3]) -> Value {
    thrown(id, [x, y, RADIUS], velocity)
}

fn noses(mut table: Value) -> Value {
    table["nose_height"] = json!(NOSE);
    table
}

/// The place of a thrown ball, by the textbook.
fn fall(position: [f64; 3], velocity: [f64; 3], time: f64) -> [f64; 3] {
    let mut place = [0, 1, 2].map(|axis| position[axis] + velocity[axis] * time);
    place[2] -= 0.5 * GRAVITY * time * time;
    place
}

/// The first time at which a gap is no longer positive, by small steps and bisection; `None` up to `end`.
fn first_zero(gap: impl Fn(f64) -> f64, end: f64) -> Option<f64> {
    const STEPS: u32 = 20_000;
    let at = |k: u32| end * f64::from(k) / f64::from(STEPS);
    let (mut before, mut after) = (1..=STEPS).map(|k| (at(k - 1), at(k))).find(|(_, t)| gap(*t) <= 0.0)?;
    for _ in 0..200 {
        let middle = 0.5 * (before + after);
        if gap(middle) > 0.0 { before = middle } else { after = middle }
    }
    Some(after)
}

/// What a thrown ball does first, and when: it touches a nose, its centre passes over one, or it lands.
fn by_brute_force(position: [f64; 3], velocity: [f64; 3], across: impl Fn([f64; 3]) -> f64) -> (Kind, f64) {
    let place = |time: f64| fall(position, velocity, time);
    let landing = first_zero(|t| if t == 0.0 { 1.0 } else { place(t)[2] - RADIUS }, 3.0).unwrap();
    let height = |p: [f64; 3]| p[2] - NOSE;
    let touch = first_zero(|t| libm::hypot(across(place(t)), height(place(t))) - RADIUS, landing);
    let over = first_zero(|t| across(place(t)), landing);
    let mut all = vec![(Kind::BallCloth, landing)];
    all.extend(touch.map(|time| (Kind::BallCushion, time)));
    all.extend(over.map(|time| (Kind::OffTable, time)));
    all.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
}

/// Compares the first events of random flights towards a nose, strewn so widely, with a search by small steps.
fn compare(table: &Value, spread: f64, across: impl Fn([f64; 3]) -> f64 + Copy) -> [u32; 3] {
    let mut random = Random::new(5);
    let mut seen = [0; 3];
    for case in 0..300 {
        let position =
            [1.0, 2.0 + 0.5 * spread * random.between(-1.0, 1.0), RADIUS + random.between(0.0, 0.1)];
        let speed = random.between(1.0, 4.0);
        let velocity = [speed, spread * random.between(-1.0, 1.0), random.between(0.3, 2.5)];
        let run = run_until(&on_table(table, &json!({}), &[thrown("a", position, velocity)]), None);
        let (kind, time) = by_brute_force(position, velocity, across);
        let event = run.log.events[0];
        assert_eq!(event.kind, kind, "case {case}: {position:?} {velocity:?}");
        // Near a graze the gap is flat, and its round-off of 1e-16 moves the root by its square root at most.
        let tolerance = 1e-16 / (event.closing_speed.max(1e-8));
        assert!((event.time - time).abs() < 1e-13 + 10.0 * tolerance, "case {case}: {event:?} for {time}");
        if kind == Kind::BallCushion {
            assert!(event.closing_speed > 0.0);
            let place = fall(position, velocity, event.time);
            assert!((libm::hypot(across(place), place[2] - NOSE) - RADIUS).abs() < 1e-12);
        }
        seen[[Kind::BallCloth, Kind::BallCushion, Kind::OffTable]
            .iter()
            .position(|k| *k == kind)
            .unwrap()] += 1;
    }
    seen
}

#[test]
fn a_ball_in_the_air_meets_a_round_jaw_when_a_search_by_small_steps_says_so() {
    for (radius, spread) in [(0.3, 1.0), (0.05, 0.2)] {
        let mut table = noses(rectangle(4.0, 4.0));
        table["obstacles"] = json!([{ "circle": { "center": [2.0, 2.0], "radius": radius } }]);
        let across = |p: [f64; 3]| libm::hypot(p[0] - 2.0, p[1] - 2.0) - radius;
        // The other cushions are two metres away, which no flight here is long.
        let seen = compare(&table, spread, |p| if p[0] > 3.5 { 1.0 } else { across(p) });
        assert!(seen[0] > 10 && seen[1] > 10, "{seen:?}");
        assert!(radius < 0.1 || seen[2] > 10, "{seen:?}");
    }
}

#[test]
fn a_ball_in_the_air_meets_a_straight_nose_when_a_search_by_small_steps_says_so() {
    let seen = compare(&noses(rectangle(1.5, 4.0)), 1.0, |p| 1.5 - p[0]);
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
}

#[test]
fn balls_meet_in_the_air_when_a_search_by_small_steps_says_so() {
    let mut random = Random::new(11);
    let mut met = 0;
    for case in 0..300 {
        let a = [10.0, 10.0, RADIUS + random.between(0.0, 0.2)];
        let b = [
            10.4,
            10.0 + random.between(-0.05, 0.05),
            RADIUS + random.between(0.0, 0.2) * f64::from(case % 2),
        ];
        let va = [random.between(1.0, 3.0), 0.0, random.between(0.3, 2.0)];
        let vb =
            if case % 2 == 1 { [random.between(-2.0, 0.5), 0.0, random.between(0.3, 2.0)] } else { [0.0; 3] };
        let mut other = thrown("b", b, vb);
        if case % 2 == 0 {
            other = still("b", [b[0], b[1]]);
        }
        let value = wide(&json!({}), &[thrown("a", a, va), other]);
        let run = run(&value);
        let end = |p: [f64; 3], v: [f64; 3]| {
            (v[2] + (v[2] * v[2] + 2.0 * GRAVITY * (p[2] - RADIUS)).sqrt()) / GRAVITY
        };
        let first_landing = if case % 2 == 1 { end(a, va).min(end(b, vb)) } else { end(a, va) };
        let place_b = |t: f64| if case % 2 == 1 { fall(b, vb, t) } else { b };
        let gap = |t: f64| {
            let (p, q) = (fall(a, va, t), place_b(t));
            libm::hypot(libm::hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) - 2.0 * RADIUS
        };
        let expected = first_zero(gap, first_landing);
        let event = run.log.events[0];
        match expected {
            Some(time) => {
                met += 1;
                assert_eq!(event.kind, Kind::BallBall, "case {case}: {value}");
                let tolerance = 1e-13 + 1e-15 / event.closing_speed.max(1e-8);
                assert!((event.time - time).abs() < tolerance, "case {case}: {event:?} for {time}");
            }
            None => assert_eq!(event.kind, Kind::BallCloth, "case {case}: {value}"),
        }
        assert_eq!(run.status, Status::AtRest);
    }
    assert!(met > 50, "{met}");
}

#[test]
fn a_ball_jumps_over_another_only_if_it_is_high_enough_there() {
    let jump = |rise: f64| {
        let balls = [jumping("a", [10.0, 10.0], [2.0, 0.0, rise]), still("b", [10.3, 10.0])];
        run(&wide(&json!({ "flight": { "law": "cloth", "restitution": 0.0 } }), &balls))
    };
    // 0.15 s after the start the ball is over the other, and must be a diameter higher than it.
    let enough = 2.0 * RADIUS / 0.15 + 0.5 * GRAVITY * 0.15;
    let over = jump(enough + 0.05);
    assert!(events(&over, Kind::BallBall).is_empty());
    assert!(over.final_state()[0].position.x > 10.4);
    let into = jump(enough - 0.05);
    assert_eq!(kinds_of(&into, 0)[0], Kind::BallBall);
    assert!(first(&into, Kind::BallBall, 0).time < 0.16);
}

#[test]
fn a_ball_struck_from_above_flies_to_the_other_side_of_one_in_its_way() {
    let balls = [still("cue", [10.0, 10.0]), still("b", [10.0, 10.2])];
    let mut value = wide(&json!({ "flight": { "law": "cloth", "restitution": 0.6 } }), &balls);
    value["shot"] = json!({ "V0": 4.0, "phi_deg": 90.0, "theta_deg": 45.0 });
    let run = run(&value);
    assert!(events(&run, Kind::BallBall).is_empty(), "{:?}", run.log.events);
    assert_eq!(at(&run, 0.01)[0].motion, Motion::Airborne);
    assert!(run.final_state()[0].position.y > 10.3);
}

#[test]
fn a_ball_that_flies_over_a_rail_has_left_the_table() {
    let run =
        run(&on_table(&noses(rectangle(2.0, 2.0)), &json!({}), &[jumping("a", [1.5, 1.0], [3.0, 0.0, 1.5])]));
    assert_eq!(kinds_of(&run, 0), [Kind::OffTable]);
    let event = run.log.events[0];
    assert_eq!(run.system.cushion_ids[event.cushion.unwrap() as usize], "right");
    assert!((event.time - 0.5 / 3.0).abs() < 1e-14 && (event.point.x - 2.0).abs() < 1e-14);
    assert_eq!(run.final_state()[0].motion, Motion::OffTable);
    assert_eq!((run.status, run.end_time), (Status::AtRest, event.time));
}

/// What becomes of a ball that jumps towards a pocket with its near rim 0.2 ahead and its far one 0.4.
fn over_a_pocket(rise: f64, speed: f64) -> (Vec<Kind>, f64) {
    let mut table = noses(rectangle(6.0, 2.0));
    table["pockets"] = json!([{ "id": "hole", "center": [1.3, 1.0], "radius": 0.1 }]);
    let run = run(&on_table(&table, &json!({}), &[jumping("a", [1.0, 1.0], [speed, 0.0, rise])]));
    (kinds_of(&run, 0), run.log.events[0].time)
}

#[test]
fn a_ball_flies_over_a_pocket_or_lands_in_it_or_is_caught_by_its_back() {
    // Flies 0.51 m, past the pocket, at whose far rim it is 0.11 m high.
    let (over, _) = over_a_pocket(1.0, 2.5);
    assert_eq!(over[0], Kind::BallCloth);
    // Lands 0.3 m ahead, in the middle.
    let flight = 2.0 / GRAVITY;
    let (into, time) = over_a_pocket(1.0, 0.3 / flight);
    assert_eq!(into, [Kind::BallPocket]);
    assert!((time - flight).abs() < 1e-14);
    // Lands 0.405 m ahead, 5 mm past the far rim, over which it is lower than 7R/5.
    let (caught, time) = over_a_pocket(1.0, 0.405 / flight);
    assert_eq!(caught, [Kind::BallPocket]);
    assert!((time - 0.4 / 0.405 * flight).abs() < 1e-13);
    // Lands before it, and rolls in.
    let (before, _) = over_a_pocket(0.5, 1.5);
    assert_eq!((before[0], *before.last().unwrap()), (Kind::BallCloth, Kind::BallPocket));
}

#[test]
fn without_air_nothing_leaves_the_cloth() {
    let balls = [still("cue", [10.0, 10.0]), still("b", [10.0, 10.2])];
    let mut value = wide(&json!({ "flight": { "law": "cloth", "air": false } }), &balls);
    value["shot"] = json!({ "V0": 4.0, "phi_deg": 90.0, "theta_deg": 45.0 });
    let run = run(&value);
    assert_eq!(kinds_of(&run, 0)[1], Kind::BallBall);
    assert!(run.log.flights.iter().all(|(_, flight)| flight.motion != Motion::Airborne));
}

#[test]
fn a_thrown_ball_that_touches_a_nose_from_above_bounces_back_up() {
    // Its centre comes down 1 mm in front of the nose line.
    let value = on_table(
        &noses(rectangle(2.0, 2.0)),
        &json!({}),
        &[thrown("a", [1.999, 1.0, 0.2], [0.0, 0.0, -0.1])],
    );
    let run = run(&value);
    assert_eq!(kinds_of(&run, 0)[0], Kind::BallCushion);
    let after = at(&run, run.log.events[0].time)[0].twist.velocity;
    assert!(after.z > 0.0 && after.x < 0.0, "{after:?}");
    assert!(run.diagnostics.energy_gain <= 1e-15);
}
