//! Two spheres that meet: the numbers that books and papers print.

use crate::kit::spheres::{Ball, Meeting, Motion, POOL, degrees, rolling_velocity};
use carom::geometry::Vec2;
use carom::law::ball_ball::{Frictional, Mathavan2014, Restitution, SphereImpact, SphereLaw};
use carom::law::coefficient::SlipFriction;

const MPH: f64 = 0.447_04;

/// The ball of Mathavan, Jackson and Parkin.
const SNOOKER: Ball = Ball { radius: 0.026_25, mass: 0.1406, sliding: 0.21 };

fn restitution(normal: f64) -> SphereLaw<f64> {
    SphereLaw::Restitution(Restitution { normal })
}

fn alciatore(cling: f64) -> SphereLaw<f64> {
    SphereLaw::Frictional(Frictional { normal: 1.0, friction: SlipFriction::alciatore(), cling })
}

fn mathavan() -> SphereLaw<f64> {
    SphereLaw::Mathavan2014(Mathavan2014 { normal: 0.89, friction: SlipFriction::Constant(0.05) })
}

fn meet(law: &SphereLaw<f64>, meeting: &Meeting) -> SphereImpact<f64> {
    let pair = meeting.pair();
    law.impact(&pair, law.restitution(pair.closing_speed()))
}

/// The angle by which the object ball leaves beside the line between the centres, positive along `n × ẑ`.
fn throw_deg(law: &SphereLaw<f64>, speed: f64, rolled: [f64; 3], cut_deg: f64) -> f64 {
    let motion = Motion { velocity: [speed, 0.0, 0.0], rolled };
    let v = meet(law, &Meeting::cut(POOL, motion, cut_deg)).twists[1].velocity;
    cut_deg - degrees(v.x, v.y)
}

fn stun_throw_deg(law: &SphereLaw<f64>, speed: f64, cut_deg: f64) -> f64 {
    throw_deg(law, speed, [0.0; 3], cut_deg)
}

/// The angle and size of a largest value.
fn maximum(of: impl Fn(f64) -> f64) -> (f64, f64) {
    let angles = (1..=80_000).map(|k| 1e-3 * f64::from(k));
    angles
        .map(|angle| (angle, of(angle)))
        .fold((0.0, 0.0), |best, found| if found.1 > best.1 { found } else { best })
}

/// The final deflection of a rolling ball.
fn deflection_deg(law: &SphereLaw<f64>, speed: f64, cut_deg: f64) -> f64 {
    let meeting = Meeting::cut(POOL, Motion::rolling([speed, 0.0], 0.0), cut_deg);
    let Vec2 { x, y } = rolling_velocity(POOL, &meet(law, &meeting).twists[0]);
    -degrees(x, y)
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} instead of {expected}");
}

#[test]
fn b1_a_stun_shot_parts_at_ninety_degrees() {
    let part = |law: &SphereLaw<f64>, cut_deg: f64| {
        let [cue, object] = meet(law, &Meeting::cut(POOL, Motion::stun([1.0, 0.0]), cut_deg)).twists;
        let angle = degrees(object.velocity.x, object.velocity.y) - degrees(cue.velocity.x, cue.velocity.y);
        (angle, cue.velocity.norm(), object.velocity.norm())
    };
    for cut_deg in [10.0, 30.0, 45.0, 80.0] {
        assert_near(part(&restitution(1.0), cut_deg).0, 90.0, 1e-10, "elastic");
    }
    for (cut_deg, expected) in [(15.0, 84.670), (30.0, 87.521), (45.0, 88.568), (60.0, 89.173)] {
        assert_near(part(&restitution(0.95), cut_deg).0, expected, 6e-4, "e = 0.95");
    }
    let (angle, cue, object) = part(&restitution(0.95), 30.0);
    assert_near(angle, 87.5206, 1e-4, "angle");
    assert_near(cue, 0.50047, 1e-5, "cue ball");
    assert_near(object, 0.84437, 1e-5, "object ball");
}

#[test]
fn b2_a_rolling_ball_deflects_by_thirty_degrees_or_so() {
    let law = restitution(1.0);
    let quarter = libm::asin(0.75).to_degrees();
    let three_quarters = libm::asin(0.25).to_degrees();
    for speed in [1.0, 5.0] {
        assert_near(deflection_deg(&law, speed, 30.0), 33.6705, 1e-4, "half ball");
        assert_near(deflection_deg(&law, speed, quarter), 27.2669, 1e-4, "quarter ball");
        assert_near(deflection_deg(&law, speed, three_quarters), 27.6265, 1e-4, "three-quarter ball");
        let (at, largest) = maximum(|cut_deg| deflection_deg(&law, speed, cut_deg));
        assert_near(largest, 33.7490, 1e-4, "largest");
        assert_near(at, 28.1255, 1e-3, "where it is largest");
    }
    assert_near(deflection_deg(&restitution(0.95), 1.0, 30.0), 32.265, 1e-3, "e = 0.95");
}

#[test]
fn b3_a_straight_rolling_shot_gives_five_sevenths() {
    let speeds = |law: &SphereLaw<f64>| {
        let meeting = Meeting::cut(POOL, Motion::rolling([1.0, 0.0], 0.0), 0.0);
        meet(law, &meeting).twists.map(|twist| rolling_velocity(POOL, &twist).x)
    };
    let [cue, object] = speeds(&restitution(1.0));
    assert_near(cue, 2.0 / 7.0, 1e-15, "cue ball");
    assert_near(object, 5.0 / 7.0, 1e-15, "object ball");
    let [cue, object] = speeds(&restitution(0.95));
    assert_near(cue, 0.303_571, 1e-6, "cue ball, e = 0.95");
    assert_near(object, 0.696_429, 1e-6, "object ball, e = 0.95");
}

#[test]
fn b4_throw_is_that_of_the_table() {
    let table = [
        (10.0, [1.443, 1.443, 1.443], [0.760, 0.349, 0.135]),
        (30.0, [4.715, 3.549, 1.697], [2.186, 1.004, 0.388]),
        (50.0, [4.822, 2.592, 1.026], [3.347, 1.538, 0.594]),
    ];
    let law = alciatore(1.0);
    for (cut_deg, stun, roll) in table {
        for (k, speed) in [1.0, 3.0, 7.0].map(|mph| mph * MPH).into_iter().enumerate() {
            assert_near(stun_throw_deg(&law, speed, cut_deg), stun[k], 1e-3, "stun");
            assert_near(throw_deg(&law, speed, [0.0, speed, 0.0], cut_deg), roll[k], 1e-3, "roll");
        }
    }
}

#[test]
fn b5_the_largest_throw_of_a_slow_stun_shot_is_about_an_inch_per_foot() {
    let law = alciatore(1.0);
    for (mph, angle, throw) in [(1.0, 33.01, 5.302), (3.0, 25.37, 3.876), (7.0, 18.26, 2.698)] {
        let (at, largest) = maximum(|cut_deg| stun_throw_deg(&law, mph * MPH, cut_deg));
        assert_near(largest, throw, 1e-3, "largest");
        assert_near(at, angle, 1e-2, "where it is largest");
    }
    let (_, largest) = maximum(|cut_deg| stun_throw_deg(&law, MPH, cut_deg));
    assert_near(largest, libm::atan(1.0 / 12.0).to_degrees(), 1.0, "inch per foot");
}

#[test]
fn b6_outside_english_that_gears_throws_nothing() {
    for law in [alciatore(1.0), mathavan()] {
        for cut_deg in (1..90).map(f64::from) {
            let side = libm::sin(cut_deg.to_radians());
            let motion = Motion { velocity: [1.0, 0.0, 0.0], rolled: [0.0, 0.0, side] };
            let [cue, object] = meet(&law, &Meeting::cut(POOL, motion, cut_deg)).twists;
            let thrown = degrees(object.velocity.x, object.velocity.y) - cut_deg;
            assert_near(thrown, 0.0, 1e-11, "throw");
            assert_near(object.spin.norm() * POOL.radius, 0.0, 1e-12, "spin of the object ball");
            assert_near(cue.spin.z * POOL.radius, side, 1e-12, "spin of the cue ball");
        }
    }
}

#[test]
fn b6_inside_english_throws_like_a_cut_the_other_way() {
    let law = alciatore(1.0);
    assert_near(throw_deg(&law, MPH, [0.0, 0.0, -MPH], 30.0), 3.549, 1e-3, "inside");
    assert_near(throw_deg(&law, MPH, [0.0, 0.0, MPH], 30.0), -4.715, 1e-3, "outside");
}

#[test]
fn b7_balls_that_cling_throw_more_where_they_slip_to_the_end() {
    let law = alciatore(2.5);
    for (cut_deg, expected) in [(30.0, 4.715), (50.0, 9.662), (55.0, 11.531)] {
        assert_near(stun_throw_deg(&law, MPH, cut_deg), expected, 1e-3, "cling");
    }
}

#[test]
fn b8_mathavan_2014_gives_the_shots_of_the_paper() {
    let shots = [
        (1.539, 58.63, 33.83, [0.914, 0.831], [31.93, 32.20]),
        (1.032, 39.31, 26.36, [0.520, 0.599], [32.45, 25.07]),
    ];
    for (speed, topspin, cut_deg, speeds, angles) in shots {
        let rolled = [0.0, topspin * SNOOKER.radius, 0.0];
        let motion = Motion { velocity: [speed, 0.0, 0.0], rolled };
        let twists = meet(&mathavan(), &Meeting::cut(SNOOKER, motion, cut_deg)).twists;
        for (k, sign) in [(0, -1.0), (1, 1.0)] {
            let v = rolling_velocity(SNOOKER, &twists[k]);
            assert_near(v.norm() / speeds[k], 1.0, 2e-3, "speed");
            assert_near(sign * degrees(v.x, v.y), angles[k], 0.05, "angle");
        }
    }
}

#[test]
fn b9_the_cloth_takes_momentum_from_a_draw_shot() {
    let motion = Motion { velocity: [1.0, 0.0, 0.0], rolled: [0.0, -1.0, 0.0] };
    let [cue, object] = meet(&mathavan(), &Meeting::cut(SNOOKER, motion, 0.0)).twists;
    let momentum = cue.velocity.x + object.velocity.x;
    assert!(momentum < 1.0 - 1e-4, "{momentum}");
    // Without friction on the cloth it would be one.
    let slippery = Ball { sliding: 0.0, ..SNOOKER };
    let [cue, object] = meet(&mathavan(), &Meeting::cut(slippery, motion, 0.0)).twists;
    assert_near(cue.velocity.x + object.velocity.x, 1.0, 1e-14, "momentum");
}
