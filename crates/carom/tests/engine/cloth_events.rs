//! Two balls on a cloth, and balls at jaws, in whole runs: when they meet, and how they part.

use crate::kit::cloth::{
    ClothRun, GRAVITY, MASS, RADIUS, at, between, events, first, on_table, rolling, run, run_until, still,
    stun, wide,
};
use crate::kit::random::Random;
use crate::kit::scenes::{polygon, rectangle};
use carom::flight::Motion;
use carom::geometry::Vec2;
use carom::run::{Event, Kind};
use serde_json::{Value, json};

const ELASTIC: &str = "elastic";
const MILE_PER_HOUR: f64 = 0.447_04;

fn law(name: &str, normal: f64) -> Value {
    if name == ELASTIC {
        json!({ "ball_ball": { "law": "elastic" } })
    } else {
        json!({ "ball_ball": { "law": name, "normal": normal } })
    }
}

/// A ball that touches an object ball already, which lies at a cut angle to the right, and moves along +y.
fn frozen_cut(physics: &Value, angle_deg: f64, cue: [f64; 2]) -> ClothRun {
    let angle = angle_deg.to_radians();
    let object = [20.0 + 2.0 * RADIUS * libm::sin(angle), 20.0 + 2.0 * RADIUS * libm::cos(angle)];
    run_until(&wide(physics, &[stun("cue", [20.0; 2], cue), still("1", object)]), Some(Kind::BallBall))
}

/// A ball that rolls along +y onto an object ball and cuts it to the right.
fn rolling_cut(physics: &Value, angle_deg: f64, speed: f64) -> ClothRun {
    let aside = 2.0 * RADIUS * libm::sin(angle_deg.to_radians());
    run(&wide(physics, &[rolling("cue", [20.0, 10.0], [0.0, speed]), still("1", [20.0 + aside, 10.5])]))
}

fn velocities(run: &ClothRun, time: f64) -> [Vec2<f64>; 2] {
    let states = at(run, time);
    [0, 1].map(|k| states[k].twist.velocity.plan())
}

#[test]
fn stunned_balls_part_at_a_right_angle_and_at_less_with_restitution() {
    for angle in [10.0, 15.0, 30.0, 45.0, 60.0, 80.0] {
        let run = frozen_cut(&law(ELASTIC, 1.0), angle, [0.0, 2.0]);
        let [cue, object] = velocities(&run, 0.0);
        // Places near 20 leave the normal uncertain by 4e-15/2R.
        assert!((between(object, cue) - 90.0).abs() < 1e-10, "{angle}");
    }
    for (angle, expected) in [(15.0, 84.670), (30.0, 87.521), (45.0, 88.568), (60.0, 89.173)] {
        let run = frozen_cut(&law("restitution", 0.95), angle, [0.0, 1.0]);
        let [cue, object] = velocities(&run, 0.0);
        assert!((between(object, cue) - expected).abs() < 1e-3, "{angle}: {}", between(object, cue));
    }
    let [cue, object] = velocities(&frozen_cut(&law("restitution", 0.95), 30.0, [0.0, 1.0]), 0.0);
    assert!((between(object, cue) - 87.5206).abs() < 1e-4);
    assert!((cue.norm() - 0.50047).abs() < 1e-4 / 2.0 && (object.norm() - 0.84437).abs() < 1e-4 / 2.0);
}

#[test]
fn a_rolling_ball_ends_thirty_degrees_off_whatever_its_speed() {
    for speed in [1.0, 5.0] {
        for (angle, expected) in [(30.0, 33.6705), (48.5904, 27.2669), (14.4775, 27.6265), (28.1255, 33.7490)]
        {
            let run = rolling_cut(&law(ELASTIC, 1.0), angle, speed);
            let time = first(&run, Kind::SlideToRoll, 0).time;
            let [cue, _] = velocities(&run, time);
            let deflected = between(Vec2::new(0.0, 1.0), cue);
            // The fractions of the ball are given to 1e-4 of a degree.
            assert!((deflected - expected).abs() < 2e-4, "{angle} at {speed}: {deflected}");
            let radians = angle.to_radians();
            let (sin, cos) = (libm::sin(radians), libm::cos(radians));
            let exact = libm::atan2(sin * cos, sin * sin + 0.4).to_degrees();
            assert!((deflected - exact).abs() < 1e-9, "{angle} at {speed}: {deflected} for {exact}");
        }
        let run = rolling_cut(&law("restitution", 0.95), 30.0, speed);
        let [cue, _] = velocities(&run, first(&run, Kind::SlideToRoll, 0).time);
        assert!((between(Vec2::new(0.0, 1.0), cue) - 32.265).abs() < 1e-3);
    }
}

#[test]
fn a_straight_rolling_shot_leaves_two_sevenths_and_gives_five() {
    for (normal, cue_part, object_part) in [(1.0, 2.0 / 7.0, 5.0 / 7.0), (0.95, 0.303_571_4, 0.696_428_6)] {
        let run = rolling_cut(&law("restitution", normal), 0.0, 3.0);
        let speed = first(&run, Kind::BallBall, 0).closing_speed;
        for (ball, part) in [(0, cue_part), (1, object_part)] {
            let time = first(&run, Kind::SlideToRoll, ball).time;
            let found = velocities(&run, time)[ball as usize].y / speed;
            let tolerance = if normal == 1.0 { 1e-13 } else { 1e-7 };
            assert!((found - part).abs() < tolerance, "ball {ball}: {found} for {part}");
        }
    }
}

#[test]
fn the_largest_throw_of_a_slow_stun_shot_is_that_of_a_cut_of_33_degrees() {
    let physics = json!({ "ball_ball": { "law": "frictional", "normal": 1.0 } });
    let throw = |angle: f64| {
        let run = frozen_cut(&physics, angle, [0.0, MILE_PER_HOUR]);
        let [_, object] = velocities(&run, 0.0);
        between(object, run.log.events[0].normal).abs()
    };
    let angles = (0..400).map(|k| 31.0 + 0.01 * f64::from(k));
    let (at, most) = angles.map(|a| (a, throw(a))).fold((0.0, 0.0), |b, n| if n.1 > b.1 { n } else { b });
    assert!((most - 5.302).abs() < 1e-3, "{most}");
    assert!((at - 33.01).abs() < 0.011, "{at}");
    assert!((most - 4.76).abs() < 1.0, "about an inch in a foot");
}

#[test]
fn a_rolling_ball_meets_another_at_the_root_of_the_quartic() {
    // Around the origin, so that places are rounded no more than the textbook's.
    let table = polygon(&[[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]]);
    let balls = [rolling("cue", [0.0, 0.0], [1.0, 0.0]), still("1", [0.5, RADIUS])];
    let run = run_until(&on_table(&table, &json!({}), &balls), Some(Kind::BallBall));
    assert!((run.end_time - 0.460_927_525_905_665).abs() < 1e-12, "{}", run.end_time);
    let t = run.end_time;
    let quartic = [0.247_550_408_125, -1.0, 1.04905, -0.0981, 0.002_405_902_5];
    let value = quartic.iter().rev().fold(0.0, |sum, c| sum * t + c);
    assert!(value.abs() < 1e-15, "{value}");
}

#[test]
fn grazes_are_decided_by_the_side_on_which_a_ball_passes() {
    let table = polygon(&[[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]]);
    let pass = |start: f64, aside: f64| {
        let balls = [rolling("cue", [start, 0.0], [1.0, 0.0]), still("1", [0.0, aside])];
        run_until(&on_table(&table, &json!({}), &balls), Some(Kind::BallBall))
    };
    // The gap's square is the difference of squares as large as that of the start's distance, and 16 roundings of those of
    // 1 m are 1e-12 of (2R)².
    for (start, finest) in [(-1.0, 11), (-0.1, 13), (-0.03, 15)] {
        let mut last = f64::INFINITY;
        for k in 3..=finest {
            let part = 10.0_f64.powi(-k);
            let [hit, miss] = [-part, part].map(|change| pass(start, 2.0 * RADIUS * (1.0 + change)));
            assert!(events(&miss, Kind::BallBall).is_empty(), "k = {k} from {start}: a miss is none");
            let event = first(&hit, Kind::BallBall, 0);
            assert!(event.impulse >= 0.0 && event.impulse < last, "k = {k} from {start}: {event:?}");
            assert!((event.impulse - MASS * event.closing_speed).abs() < 1e-12, "k = {k}: {event:?}");
            assert!(event.closing_speed < 2.0 * part.sqrt(), "k = {k} from {start}: {event:?}");
            assert!(event.time.is_finite() && hit.digest().is_some());
            last = event.impulse;
        }
    }
}

#[test]
fn balls_that_roll_side_by_side_do_not_meet() {
    let mut balls: Vec<Value> = (0..6)
        .map(|k| rolling(&k.to_string(), [10.0 + 2.0 * RADIUS * f64::from(k), 10.0], [0.0, 1.0]))
        .collect();
    // One behind the other too, in touch; and some with a gap.
    balls.push(rolling("behind", [10.0, 10.0 - 2.0 * RADIUS], [0.0, 1.0]));
    balls.push(rolling("far behind", [10.0, 9.0], [0.0, 1.0]));
    let run = run(&wide(&json!({}), &balls));
    assert!(events(&run, Kind::BallBall).is_empty(), "{:?}", run.log.events);
    assert_eq!(run.log.events.len(), balls.len());
    assert!(run.log.events.iter().all(|event| event.kind == Kind::RollToRest));
    let time = 1.0 / (0.01 * GRAVITY);
    assert!(run.log.events.iter().all(|event| (event.time - time).abs() < 1e-12));
}

#[test]
fn a_chaser_with_the_same_braking_meets_by_a_quadratic() {
    let pair = [rolling("slow", [10.0, 10.0], [0.0, 1.0]), rolling("fast", [10.0, 9.0], [0.0, 1.5])];
    let run = run_until(&wide(&json!({}), &pair), Some(Kind::BallBall));
    let expected = (1.0 - 2.0 * RADIUS) / 0.5;
    assert!((run.end_time - expected).abs() < 1e-13, "{}", run.end_time);
}

/// A table with a round post of that radius in its middle, and cushions that do not rub.
fn with_post(radius: f64) -> Value {
    let mut table = rectangle(4.0, 4.0);
    table["obstacles"] = json!([{ "id": "post", "circle": { "center": [2.0, 2.0], "radius": radius } }]);
    table
}

#[test]
fn a_round_jaw_reflects_what_comes_head_on() {
    let physics = json!({ "ball_cushion": { "law": "elastic" } });
    let mut random = Random::new(4);
    for radius in [1e-9, 0.01, 0.3] {
        for _ in 0..20 {
            let [x, y] = random.direction();
            let start = [2.0 - x, 2.0 - y];
            let run = run_until(
                &on_table(&with_post(radius), &physics, &[stun("a", start, [2.0 * x, 2.0 * y])]),
                Some(Kind::BallCushion),
            );
            let after = at(&run, run.end_time)[0].twist.velocity.plan();
            let event = run.log.events.last().unwrap();
            let direction = Vec2::new(x, y);
            assert!((event.normal + direction).norm() < 1e-9, "{event:?}");
            assert!(after.cross(direction).abs() < 1e-9 && after.dot(direction) < 0.0);
            assert!((after.norm() - event.closing_speed).abs() < 1e-12);
            let distance = (at(&run, run.end_time)[0].position.plan() - Vec2::new(2.0, 2.0)).norm();
            assert!((distance - radius - RADIUS).abs() < 1e-13, "{distance}");
        }
    }
}

#[test]
fn a_jaw_that_is_grazed_does_the_less_the_less_it_is_touched() {
    let laws = [
        json!({ "law": "elastic" }),
        json!({ "law": "frictional", "normal": 0.85, "friction": 0.2 }),
        json!({ "law": "han_2005", "normal": 0.85, "friction": 0.2 }),
        json!({ "law": "mathavan_2010", "normal": 0.85, "friction": 0.2 }),
        json!({ "law": "stronge_compliant", "normal": 0.85, "friction": 0.2 }),
    ];
    for law in laws {
        let physics = json!({ "ball_cushion": law });
        for k in 2..=12 {
            let part = 10.0_f64.powi(-k);
            let aside = (0.3 + RADIUS) * (1.0 - part);
            let balls = [rolling("a", [2.0 - aside, 1.0], [0.0, 2.0])];
            let run = run_until(&on_table(&with_post(0.3), &physics, &balls), Some(Kind::BallCushion));
            let Event { closing_speed, time, .. } = *run.log.events.last().unwrap();
            let before = run.log.flights[run.log.flights.len() - 2].1;
            let change = at(&run, time)[0].twist.velocity - before.velocity_after(time - before.start());
            assert!(closing_speed > 0.0 && closing_speed < 3.0 * part.sqrt(), "{law}, k = {k}");
            // Restitution up to 1 and friction up to 0.2, of the cushion and of the cloth.
            assert!(change.norm() <= 2.5 * closing_speed, "{law}, k = {k}: {change:?}");
        }
    }
}

#[test]
fn unlike_balls_meet_where_spheres_on_a_cloth_do_and_keep_their_own_friction() {
    let (small, large) = (0.02, 0.05);
    let mut balls = [rolling("small", [10.0, 10.0], [1.0, 0.0]), still("large", [11.0, 10.0])];
    balls[0]["radius"] = json!(small);
    balls[0]["spin"] = json!([0.0, 1.0 / small, 0.0]);
    balls[0]["rolling_friction"] = json!(0.02);
    balls[1]["radius"] = json!(large);
    balls[1]["mass"] = json!(0.5);
    balls[1]["sliding_friction"] = json!(0.4);
    let run = run(&wide(&json!({ "flight": { "law": "cloth", "air": false } }), &balls));
    let event = first(&run, Kind::BallBall, 0);
    let states = at(&run, event.time);
    let apart = (states[1].position - states[0].position).norm();
    assert!((apart - small - large).abs() < 1e-13, "{apart}");
    let way = 1.0 - 2.0 * (small * large).sqrt();
    let braking = 0.02 * GRAVITY;
    let expected = (1.0 - (1.0 - 2.0 * braking * way).sqrt()) / braking;
    assert!((event.time - expected).abs() < 1e-12, "{} for {expected}", event.time);
    // The normal rises by (R₂ − R₁)/(R₁ + R₂) from the small ball to the large one.
    let level = 2.0 * (small * large).sqrt() / (small + large);
    let speed = 1.0 - braking * event.time;
    assert!((event.closing_speed - speed * level).abs() < 1e-12);
    let (m1, m2) = (MASS, 0.5);
    let impulse = 2.0 * event.closing_speed / (1.0 / m1 + 1.0 / m2);
    assert!((event.impulse - impulse).abs() < 1e-12);
    let object = states[1].twist.velocity.plan().x;
    assert!((object - impulse * level / m2).abs() < 1e-12, "{object}");
    let end = first(&run, Kind::SlideToRoll, 1).time - event.time;
    assert!((end - 2.0 * object / (7.0 * 0.4 * GRAVITY)).abs() < 1e-12);
    assert!(run.final_state().iter().all(|state| state.motion == Motion::Resting));
}
