//! Motions and collisions whose answers can be written down.

use crate::kit::scenes::{Ball, ball, l_shape, rectangle, scenario};
use carom::flight::State;
use carom::geometry::Vec2;
use carom::run::{Event, Kind, Run};
use carom::simulate::simulate;
use serde_json::{Value, json};

/// A run of that duration.
fn run(table: &Value, physics: &Value, balls: &[Ball], duration: f64) -> Run<f64> {
    let scenario = scenario(table, physics, balls);
    simulate(&scenario.with_values(&[("duration", json!(duration))]).unwrap()).unwrap()
}

fn hits(run: &Run<f64>, kind: Kind) -> Vec<Event<f64>> {
    run.log.events.iter().filter(|event| event.kind == kind).copied().collect()
}

/// Two discs of radius 1 at a distance of 10, passing at `p`, with relative speed 1; their first hit, if any.
fn encounter(p: f64, closing: f64) -> Option<Event<f64>> {
    let ahead = (100.0 - p * p).sqrt();
    let half = 0.5 * closing;
    let balls = [ball(1.0, [40.0, 50.0], [half, 0.0]), ball(1.0, [40.0 + ahead, 50.0 + p], [-half, 0.0])];
    let run = run(&rectangle(100.0, 100.0), &json!({}), &balls, 20.0);
    hits(&run, Kind::BallBall).first().copied()
}

#[test]
fn two_discs_meet_when_the_quadratic_formula_says() {
    let printed = [
        (0.0, 8.0),
        (0.5, 8.051_001),
        (1.0, 8.217_824),
        (1.5, 8.563_984),
        (1.9, 9.193_341),
        (1.99, 9.600_245),
    ];
    for (p, expected) in printed {
        let hit = encounter(p, 1.0).unwrap_or_else(|| panic!("no hit at offset {p}"));
        let formula = (100.0f64 - p * p).sqrt() - (4.0f64 - p * p).sqrt();
        // The places carry round-off of 7e-15, which the grazing angle multiplies by p / √(4 − p²) < 10.
        assert!((hit.time - formula).abs() < 1e-12, "offset {p}: {} for {formula}", hit.time);
        // Six digits are printed.
        assert!((hit.time - expected).abs() < 1e-6, "offset {p}: {} for {expected}", hit.time);
    }
    assert!(encounter(2.0001, 1.0).is_none(), "they pass each other");
    assert!(encounter(0.5, -1.0).is_none(), "they part");
}

#[test]
fn a_graze_is_a_hit_on_one_side_of_touching_and_none_on_the_other() {
    let mut last = f64::INFINITY;
    for k in 3..=12 {
        let margin = 10f64.powi(-k);
        let hit = encounter(2.0 * (1.0 - margin), 1.0).unwrap_or_else(|| panic!("no hit at 1 - 1e-{k}"));
        // cos of the angle of incidence is √(1 − p²/4) = √(2 margin − margin²); p is known to 7e-15, hence margin too.
        let expected = (2.0 * margin - margin * margin).sqrt();
        let round_off = 1e-14 / expected + 1e-14;
        let closing = hit.closing_speed;
        assert!((closing - expected).abs() < round_off, "1e-{k}: closing at {closing}, not {expected}");
        assert!(hit.impulse > 0.0 && hit.impulse < last, "1e-{k}: the impulse goes to zero");
        last = hit.impulse;
        assert!(encounter(2.0 * (1.0 + margin), 1.0).is_none(), "a hit at 1 + 1e-{k}");
    }
}

#[test]
fn a_disc_alone_in_a_box_is_where_unfolding_puts_it() {
    let run = run(&rectangle(1.0, 2.0), &json!({}), &[ball(0.05, [0.3, 0.4], [0.7, 0.45])], 100.0);
    let State { position: place, velocity } = run.final_state()[0];
    // A hundred hits with round-off of 1e-16 each, times the 100 units of time that follow.
    assert!((place.x - 0.1).abs() < 1e-10 && (place.y - 0.3).abs() < 1e-10, "at {place:?}");
    // Even numbers of hits keep a velocity's sign, odd ones turn it.
    assert_eq!([velocity.x, velocity.y], [0.7, -0.45]);
    let on = |names: [&str; 2]| {
        let is_on = |event: &&Event<f64>| {
            names.contains(&run.system.cushion_ids[event.cushion.unwrap() as usize].as_str())
        };
        run.log.events.iter().filter(is_on).count()
    };
    assert_eq!([on(["left", "right"]), on(["bottom", "top"])], [78, 23]);
}

#[test]
fn times_between_two_lossy_walls_are_a_geometric_series() {
    let physics = json!({ "ball_cushion": { "law": "restitution", "normal": 0.8 } });
    let run = run(&rectangle(1.0, 2.0), &physics, &[ball(0.05, [0.05, 1.0], [1.0, 0.0])], 1000.0);
    let times: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
    assert!((times[0] - 0.9).abs() < 1e-12 && (times[1] - 2.025).abs() < 1e-12);
    let mut expected = 0.0;
    for (k, time) in times.iter().enumerate() {
        // The k-th crossing takes 0.9 / 0.8^k.
        expected += 0.9 / 0.8f64.powi(k as i32);
        assert!((time / expected - 1.0).abs() < 1e-12, "hit {k} at {time}, not {expected}");
    }
    // The sum 3.6 (1.25^n − 1) stays below 1000 up to n = 25.
    assert_eq!(times.len(), 25);
}

#[test]
fn a_ball_thrown_up_in_a_field_returns_after_twice_its_speed_over_the_field() {
    for (speed, across, field) in [(1.0, 0.0, 9.81), (3.0, 0.7, 9.81), (0.01, 0.2, 0.3), (2.0, -0.4, 3.7)] {
        let physics = json!({ "flight": { "law": "field", "acceleration": [0.0, -field] } });
        let balls = [ball(0.1, [5.0, 0.1], [across, speed])];
        let run = run(&rectangle(10.0, 10.0), &physics, &balls, 5.0);
        let hit = run.log.events[0];
        let expected = 2.0 * speed / field;
        // The start lies on the cushion to within 1e-17, or 1e-17 / speed in time.
        assert!((hit.time / expected - 1.0).abs() < 1e-13, "{} for {expected}", hit.time);
        assert!((hit.closing_speed / speed - 1.0).abs() < 1e-13);
        assert!((hit.point.x - (5.0 + across * expected)).abs() < 1e-13 && hit.point.y.abs() < 1e-15);
    }
}

/// A disc of radius 0.1 from (0.4, 0.6) that meets the corner at (1, 1) of the L: its velocities before and after, and
/// the normal there by formula.
fn corner_shot(slope: f64, physics: &Value) -> (Vec2<f64>, Vec2<f64>, Vec2<f64>) {
    let before = Vec2::new(1.0, slope);
    let run = run(&l_shape(), physics, &[ball(0.1, [0.4, 0.6], [1.0, slope])], 0.7);
    assert_eq!(run.log.events.len(), 1, "slope {slope}");
    let hit = run.log.events[0];
    assert_eq!(run.system.cushion_ids[hit.cushion.unwrap() as usize], "2/3");
    let to_corner = Vec2::new(1.0 - 0.4, 1.0 - 0.6);
    let (along, squared) = (to_corner.dot(before), before.norm_squared());
    let root = (along * along - squared * (to_corner.norm_squared() - 0.01)).sqrt();
    let time = (along - root) / squared;
    assert!((hit.time - time).abs() < 1e-14, "{} for {time}", hit.time);
    let normal = (before * time - to_corner) * 10.0;
    assert!(normal.x < 0.0 && normal.y < 0.0, "the corner itself is met, not a side");
    assert!((hit.point - Vec2::new(1.0, 1.0)).norm() < 1e-14 && (hit.normal - normal).norm() < 1e-13);
    (before, run.final_state()[0].velocity, normal)
}

#[test]
fn a_reflex_corner_reflects_about_the_line_to_the_centre() {
    for slope in [0.56, 0.6, 2.0 / 3.0, 0.7, 0.75] {
        let (before, after, normal) = corner_shot(slope, &json!({}));
        let expected = before - normal * (2.0 * normal.dot(before));
        // The normal carries the round-off of a place, divided by the radius.
        assert!((after - expected).norm() < 1e-13, "slope {slope}: {after:?}, not {expected:?}");
    }
}

#[test]
fn a_corner_may_have_a_law_of_its_own() {
    let law = |normal: f64| json!({ "law": "restitution", "normal": normal, "tangential": 0.5 });
    let own = json!({ "cushions": { "2/3": law(0.25) } });
    // Without one it has the law of the first of its two cushions.
    let first = json!({ "cushions": { "2": law(0.25), "3": law(0.75) } });
    for physics in [own, first] {
        let (before, after, normal) = corner_shot(0.6, &physics);
        let closing = normal * normal.dot(before);
        let expected = closing * -0.25 + (before - closing) * 0.5;
        assert!((after - expected).norm() < 1e-13, "{after:?}, not {expected:?}");
    }
}

#[test]
fn head_on_unequal_masses_part_as_the_two_conservation_laws_say() {
    for (m, n) in [(1.0, 1.0), (1.0, 3.0), (5.0, 0.5), (1.0, 1e6), (1e-6, 1.0)] {
        for (v, w) in [(1.0, 0.0), (2.0, -1.0), (0.5, 0.25), (0.0, -1.5)] {
            let mut balls = [ball(0.1, [4.0, 5.0], [v, 0.0]), ball(0.1, [6.0, 5.0], [w, 0.0])];
            balls[0].mass = m;
            balls[1].mass = n;
            let run = run(&rectangle(10.0, 10.0), &json!({}), &balls, 8.0);
            let hit = hits(&run, Kind::BallBall)[0];
            assert!((hit.time - 1.8 / (v - w)).abs() < 1e-13, "{}", hit.time);
            let after = run.state(hit.time).unwrap();
            let expected = [((m - n) * v + 2.0 * n * w) / (m + n), ((n - m) * w + 2.0 * m * v) / (m + n)];
            for (ball, expected) in expected.into_iter().enumerate() {
                let found = after[ball].velocity;
                assert!((found.x - expected).abs() < 1e-14 && found.y == 0.0, "{found:?} for {expected}");
            }
        }
    }
}

#[test]
fn restitution_between_balls_takes_the_energy_of_the_closing_motion() {
    for e in [0.0, 0.3, 0.5, 0.95, 1.0] {
        let physics = json!({ "ball_ball": { "law": "restitution", "normal": e } });
        let mut balls = [ball(0.2, [4.0, 5.0], [1.0, 0.1]), ball(0.3, [6.0, 5.3], [-0.5, 0.0])];
        balls[0].mass = 2.0;
        balls[1].mass = 0.7;
        let run = run(&rectangle(10.0, 10.0), &physics, &balls, 2.0);
        let hit = hits(&run, Kind::BallBall)[0];
        let reduced = 2.0 * 0.7 / 2.7;
        let loss = 0.5 * reduced * (1.0 - e * e) * hit.closing_speed * hit.closing_speed;
        let change = run.energy(0.0).unwrap() - run.energy(2.0).unwrap();
        assert!((change - loss).abs() < 1e-14, "e = {e}: {change} lost, not {loss}");
        assert!((hit.impulse - (1.0 + e) * reduced * hit.closing_speed).abs() < 1e-14);
        let [a, b] = [0, 1].map(|k| run.final_state()[k].velocity);
        assert!(((b - a).dot(hit.normal) - e * hit.closing_speed).abs() < 1e-14);
        // Without friction the parts along the line of contact stay.
        let along = |v: Vec2<f64>| v.dot(hit.normal.left());
        assert!((along(a) - along(Vec2::new(1.0, 0.1))).abs() < 1e-14);
        assert!((along(b) - along(Vec2::new(-0.5, 0.0))).abs() < 1e-14);
    }
}

#[test]
fn each_cushion_follows_its_own_law() {
    let physics = json!({
        "ball_cushion": { "law": "restitution", "normal": 0.5, "tangential": 0.75 },
        "cushions": {
            "left": { "law": "elastic" },
            "right": { "law": "damping", "factor": 0.875 },
            "top": { "law": "restitution", "normal": 0.25 },
        },
    });
    let factors = |id: &str| match id {
        "left" => [1.0, 1.0],
        "right" => [0.875, 0.875],
        "top" => [1.0, 0.25],
        _ => [0.75, 0.5],
    };
    // Starting from 4 and 3, each product is exact for many hits, the factors having few bits.
    let mut expected = [4.0, 3.0];
    let run = run(&rectangle(1.0, 1.0), &physics, &[ball(0.05, [0.3, 0.4], expected)], 5.0);
    let mut seen = Vec::new();
    for event in run.log.events.iter().take(12) {
        let id = run.system.cushion_ids[event.cushion.unwrap() as usize].as_str();
        let is_side = ["left", "right"].contains(&id);
        let [mut x, mut y] = factors(id);
        if is_side {
            x = -x
        } else {
            y = -y
        }
        expected = [expected[0] * x, expected[1] * y];
        let found = run.state(event.time).unwrap()[0].velocity;
        assert_eq!([found.x, found.y], expected, "after {id}");
        seen.push(id.to_owned());
    }
    for id in ["left", "right", "bottom", "top"] {
        assert!(seen.iter().any(|name| name == id), "{id} is hit: {seen:?}");
    }
}
