//! The strike of a cue: the numbers of the literature, and the signs and frames of a measured peer.

use crate::kit::random::Random;
use crate::kit::spheres::{POOL, degrees, rolling_velocity};
use carom::geometry::{Vec2, Vec3};
use carom::law::cue_ball::{CueImpact, PointContact, Strike};
use carom::model::Twist;
use carom::scalar::{DoubleDouble, Dual, Scalar, direction};

/// A pool cue whose end is a thirtieth of the ball's mass.
const CUE: PointContact<f64> =
    PointContact { mass: 0.567, end_mass: POOL.mass / 30.0, restitution: 1.0, miscue_offset: 0.55 };

/// A strike at 2 m/s.
fn strike<S: Scalar>([phi, theta]: [f64; 2], [left, top]: [f64; 2]) -> Strike<S> {
    let (x, y) = direction(S::from_f64(phi));
    Strike {
        speed: S::from_f64(2.0),
        direction: Vec2::new(x, y),
        elevation: direction(S::from_f64(theta)),
        left: S::from_f64(left),
        top: S::from_f64(top),
    }
}

fn struck(cue: &PointContact<f64>, angles: [f64; 2], offset: [f64; 2]) -> CueImpact<f64> {
    cue.strike(&POOL.sphere(), &strike(angles, offset))
}

fn without_squirt() -> PointContact<f64> {
    PointContact { end_mass: 0.0, ..CUE }
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} instead of {expected}");
}

#[test]
fn q1_speeds_after_a_level_strike() {
    let speeds = [([0.0, 0.0], 3.07694), ([0.0, 0.4], 2.35295), ([0.5, 0.0], 2.07793), ([0.3, 0.3], 2.28572)];
    for (offset, expected) in speeds {
        let found = struck(&CUE, [0.0, 0.0], offset).twist.velocity.norm();
        assert_near(found, expected, 1e-5, &format!("{offset:?}"));
    }
}

#[test]
fn q1_two_fifths_above_the_centre_rolls_at_once() {
    let Twist { velocity, spin } = struck(&CUE, [0.0, 0.0], [0.0, 0.4]).twist;
    assert_near(spin.y * POOL.radius, velocity.x, 1e-14, "rolls");
}

#[test]
fn q1_half_a_radius_aside_is_all_the_english_there_is() {
    let Twist { velocity, spin } = struck(&CUE, [0.0, 0.0], [0.5, 0.0]).twist;
    assert_near(-spin.z * POOL.radius / velocity.norm(), 1.25, 1e-14, "percent English");
}

#[test]
fn q2_squirt() {
    for (ratio, offset, expected) in
        [(20.0, 0.2, 1.199_358), (20.0, 0.5, 2.7094), (30.0, 0.5, 1.8860), (100.0, 0.5, 0.603)]
    {
        let cue = PointContact { end_mass: POOL.mass / ratio, ..CUE };
        for (left, sign) in [(offset, -1.0), (-offset, 1.0)] {
            let v = struck(&cue, [0.0, 0.0], [left, 0.3]).twist.velocity;
            let tolerance = if ratio == 100.0 { 5e-4 } else { 1e-4 };
            assert_near(degrees(v.x, v.y), sign * expected, tolerance, "squirt");
        }
    }
}

#[test]
fn q3_the_tip_holds_up_to_its_offset() {
    let needed = |offset: f64| offset / libm::sqrt(1.0 - offset * offset);
    assert_near(needed(0.5), 0.57735, 1e-4, "friction at half the radius");
    assert_near(needed(0.55), 0.6586, 1e-4, "friction at 0.55 of the radius");
    assert_near(needed(0.5145), 0.6, 1e-4, "offset of a friction of 0.6");
    for (offset, slips) in
        [([0.54, 0.0], false), ([0.0, -0.56], true), ([0.4, 0.4], true), ([0.3, -0.4], false)]
    {
        assert_eq!(CUE.is_miscue(&strike([0.0, 0.0], offset)), slips, "{offset:?}");
        assert_eq!(CUE.is_miscue(&strike([30.0, 40.0], offset)), slips, "{offset:?}, elevated");
    }
}

#[test]
fn q4_a_masse_shot_ends_on_the_line_to_where_the_cue_points_on_the_cloth() {
    let mut random = Random::new(4);
    let cue = without_squirt();
    for _ in 0..1000 {
        let [left, top] = random.direction().map(|c| c * random.clone().between(0.0, 0.55));
        let angles = [random.between(0.0, 360.0), random.between(1.0, 89.0)];
        let CueImpact { twist, impulse, point } = struck(&cue, angles, [left, top]);
        let (radius, along) = (POOL.radius, twist.velocity * (1.0 / twist.velocity.norm()));
        let push = along * impulse;
        // Where the axis of the cue meets the cloth, from the ball's resting point on it.
        let arm = point * radius;
        let aim = arm.plan() - push.plan() * ((radius + arm.z) / push.z);
        let expected = aim * (5.0 * push.z.abs() / (7.0 * POOL.mass * radius));
        let found = rolling_velocity(POOL, &twist);
        assert!((found - expected).norm() <= 1e-12 * twist.velocity.norm(), "{found:?}, {expected:?}");
    }
}

#[test]
fn strikes_are_those_that_pooltool_was_measured_to_make() {
    type Measured = ([f64; 4], [f64; 2], [f64; 3]);
    let measured: [Measured; 6] = [
        ([90.0, 0.0, 0.0, 0.0], [0.0, 3.076_936], [0.0, 0.0, 0.0]),
        ([90.0, 0.0, 0.0, 0.25], [0.0, 2.746_791], [-60.078_545, 0.0, 0.0]),
        ([90.0, 0.0, 0.5, 0.0], [0.068_386, 2.076_802], [0.0, 0.0, -90.897_979]),
        ([90.0, 0.0, -0.3, -0.3], [-0.049_135, 2.285_193], [59.992_682, 0.0, 59.992_682]),
        ([0.0, 20.0, 0.2, 0.3], [2.312_848, -0.033_924], [-14.731_382, 64.607_519, -40.474_139]),
        ([0.0, 60.0, 0.3, 0.0], [1.311_177, -0.028_192], [-59.620_733, 0.0, -34.422_046]),
    ];
    for ([phi, theta, left, top], velocity, spin) in measured {
        let found = struck(&CUE, [phi, theta], [left, top]).twist;
        let error = (found.velocity.plan() - Vec2::from_f64(velocity)).norm();
        assert!(error <= 2e-6, "{phi} {theta} {left} {top}: {:?}", found.velocity);
        let error = (found.spin - Vec3::from_f64(spin)).norm();
        assert!(error <= 2e-5, "{phi} {theta} {left} {top}: {:?}", found.spin);
    }
}

#[test]
fn the_tip_touches_where_the_offsets_say() {
    let level = struck(&CUE, [0.0, 0.0], [0.3, 0.4]).point;
    assert!((level - Vec3::new(-libm::sqrt(0.75), 0.3, 0.4)).norm() < 1e-15, "{level:?}");
    let steep = struck(&CUE, [0.0, 90.0], [0.3, 0.4]).point;
    assert!((steep - Vec3::new(0.4, 0.3, libm::sqrt(0.75))).norm() < 1e-15, "{steep:?}");
}

#[test]
fn tip_and_ball_part_with_the_restitution_at_every_offset() {
    for (restitution, offset) in
        [(0.75, [0.0, 0.0]), (0.75, [0.3, -0.4]), (0.0, [0.5, 0.0]), (1.0, [-0.2, 0.3])]
    {
        let cue = PointContact { restitution, ..without_squirt() };
        let angles = [70.0, 25.0];
        let CueImpact { twist, impulse, point } = struck(&cue, angles, offset);
        let (cos, sin) = direction(25.0);
        let axis = Vec3::above(strike::<f64>(angles, offset).direction * cos, -sin);
        let tip = 2.0 - impulse / cue.mass;
        let parting = twist.surface_velocity(POOL.radius, point).dot(axis) - tip;
        assert_near(parting, restitution * 2.0, 1e-14, "parting speed");
        let energy = POOL.sphere().kinetic_energy(&twist) + 0.5 * cue.mass * tip * tip;
        let before = 0.5 * cue.mass * 4.0;
        assert!(energy <= before * (1.0 + 1e-14), "{energy}");
        assert!(restitution < 1.0 || energy >= before * (1.0 - 1e-14), "{energy}");
    }
}

#[test]
fn all_number_types_strike_alike() {
    let cue = |from: fn(f64) -> DoubleDouble| PointContact {
        mass: from(CUE.mass),
        end_mass: from(CUE.end_mass),
        restitution: from(0.8),
        miscue_offset: from(0.55),
    };
    let plain = PointContact { restitution: 0.8, ..CUE };
    let found = struck(&plain, [33.0, 12.0], [0.2, -0.3]).twist;
    let fine = cue(DoubleDouble::from_f64).strike(&POOL.sphere(), &strike([33.0, 12.0], [0.2, -0.3])).twist;
    assert!((found.spin - Vec3::from_f64(fine.spin.to_f64())).norm() < 1e-13);
    assert!((found.velocity - Vec3::from_f64(fine.velocity.to_f64())).norm() < 1e-15);
    let number = Dual::<2>::constant;
    let dual_cue = PointContact {
        mass: number(CUE.mass),
        end_mass: number(CUE.end_mass),
        restitution: number(0.8),
        miscue_offset: number(0.55),
    };
    let aimed = |left: f64, top: f64| Strike { left, top, ..strike::<f64>([33.0, 12.0], [0.0, 0.0]) };
    let dual_strike = Strike {
        left: Dual::variable(0.2, 0),
        top: Dual::variable(-0.3, 1),
        ..strike::<Dual<2>>([33.0, 12.0], [0.0, 0.0])
    };
    let dual = dual_cue.strike(&POOL.sphere(), &dual_strike).twist;
    assert_eq!([dual.velocity.x.value, dual.spin.y.value], [found.velocity.x, found.spin.y]);
    let step = 1e-6;
    for (k, [left, top]) in [[step, 0.0], [0.0, step]].into_iter().enumerate() {
        let at = |sign: f64| plain.strike(&POOL.sphere(), &aimed(0.2 + sign * left, -0.3 + sign * top)).twist;
        let slope = (at(1.0).velocity - at(-1.0).velocity) * (0.5 / step);
        let exact = [dual.velocity.x, dual.velocity.y, dual.velocity.z].map(|v| v.derivatives[k]);
        assert!((slope - Vec3::from_f64(exact)).norm() < 1e-8, "{slope:?}, {exact:?}");
    }
}
