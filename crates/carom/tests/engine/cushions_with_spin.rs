//! A sphere at a cushion and on the cloth: the numbers of the papers, and springs and friction followed in time.

use crate::kit::random::Random;
use crate::kit::spheres::{AtNose, Ball, Motion, POOL, degrees};
use carom::geometry::Vec3;
use carom::law::ball_cushion::{Frictional, Han2005, Mathavan2010, SphereLaw, StrongeCompliant};
use carom::law::cloth;
use carom::law::coefficient::{IncidenceFriction, NormalRestitution};
use carom::model::Twist;

/// The ball of Mathavan, Jackson and Parkin.
const SNOOKER: Ball = Ball { radius: 0.026_25, mass: 0.1406, sliding: 0.212 };

fn constant(normal: f64, friction: f64) -> (NormalRestitution<f64>, IncidenceFriction<f64>) {
    (NormalRestitution::Constant(normal), IncidenceFriction::Constant(friction))
}

fn han() -> SphereLaw<f64> {
    let (normal, friction) = constant(0.85, 0.2);
    SphereLaw::Han2005(Han2005 { normal, friction })
}

fn mathavan(normal: f64, friction: f64) -> SphereLaw<f64> {
    let (normal, friction) = constant(normal, friction);
    SphereLaw::Mathavan2010(Mathavan2010 { normal, friction })
}

fn stronge(normal: f64, friction: f64, frequency_ratio: f64) -> SphereLaw<f64> {
    let (normal, friction) = constant(normal, friction);
    SphereLaw::StrongeCompliant(StrongeCompliant { normal, friction, frequency_ratio })
}

/// A ball that runs into a cushion on the far side, whose normal is −y.
fn into_cushion(ball: Ball, sin: f64, motion: Motion) -> AtNose {
    AtNose { ball, normal: [0.0, -1.0], sin, motion, is_airborne: false }
}

fn rebound(law: &SphereLaw<f64>, at: &AtNose) -> Twist<f64> {
    let hit = at.hit();
    law.rebound(&hit, law.restitution(hit.closing_speed()))
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} instead of {expected}");
}

/// The motion of Mathavan's start: at an angle to the cushion, with topspin and side spin over the speed.
fn started(speed: f64, angle_deg: f64, topspin: f64, side: f64) -> Motion {
    let (sin, cos) = (libm::sin(angle_deg.to_radians()), libm::cos(angle_deg.to_radians()));
    Motion { velocity: [cos, sin, 0.0], rolled: [-topspin * sin, topspin * cos, side] }.times(speed)
}

#[test]
fn c1_han_gives_the_rebounds_of_a_rolling_ball() {
    let rebounds =
        [(30.0, 26.808, 0.7676, [-0.685_105, 0.346_194]), (60.0, 62.085, 0.8060, [-0.377_344, 0.712_219])];
    for (incidence, angle, speed, [away, along]) in rebounds {
        let (sin, cos) = (libm::sin(f64::to_radians(incidence)), libm::cos(f64::to_radians(incidence)));
        let at = into_cushion(POOL, 0.28, Motion::rolling([-sin, cos], 0.0));
        let Twist { velocity, spin } = rebound(&han(), &at);
        assert_near(velocity.y, away, 1e-6, "away from the cushion");
        assert_near(-velocity.x, along, 1e-6, "along the cushion");
        assert_near(velocity.z, 0.0, 0.0, "on the cloth");
        assert_near(degrees(-velocity.y, -velocity.x), angle, 1e-3, "angle");
        assert_near(velocity.norm(), speed, 1e-4, "speed");
        assert!(spin.is_finite());
    }
}

#[test]
fn c1_the_spin_of_han_is_that_of_his_equations() {
    let at = into_cushion(POOL, 0.28, Motion { velocity: [-0.4, 0.9, 0.0], rolled: [0.3, -0.7, 0.5] });
    let (before, after) = (at.hit::<f64>().twist, rebound(&han(), &at));
    let (radius, mass, sin) = (POOL.radius, POOL.mass, 0.28);
    let cos = libm::sqrt(1.0 - sin * sin);
    // With x into the cushion and y along it: the table's y and −x.
    let (vx, vy) = (before.velocity.y, -before.velocity.x);
    let (wx, wy, wz) = (before.spin.y, -before.spin.x, before.spin.z);
    let s = [vx * sin + radius * wy, -vy - radius * wz * cos + radius * wx * sin];
    let size = libm::hypot(s[0], s[1]);
    let normal = 1.85 * mass * vx * cos;
    let friction = f64::min(0.2 * normal, 2.0 / 7.0 * mass * size) / size;
    let [px, py] = s.map(|c| c * friction);
    let (x, z) = (-px * sin - normal * cos, px * cos - normal * sin);
    let gain = 2.5 / (mass * radius);
    let spin = [wx - gain * py * sin, wy + gain * (x * sin - z * cos), wz + gain * py * cos];
    assert!((after.spin - Vec3::new(-spin[1], spin[0], spin[2])).norm() < 1e-12, "{after:?}, {spin:?}");
    assert_near(after.velocity.y, vx + x / mass, 1e-14, "into the cushion");
    assert_near(-after.velocity.x, vy + py / mass, 1e-14, "along the cushion");
}

#[test]
fn c2_mathavan_2010_gives_the_tables_of_rebounds() {
    let topspins = [
        (30.0, [(0.8081, 35.78), (0.7876, 36.17), (0.8614, 34.00), (0.9239, 31.49)]),
        (45.0, [(0.8005, 54.91), (0.7564, 56.22), (0.8476, 52.68), (0.9157, 48.43)]),
    ];
    let law = mathavan(0.98, 0.14);
    let check = |motion: Motion, (speed, angle): (f64, f64)| {
        let v = rebound(&law, &into_cushion(SNOOKER, 0.4, motion)).velocity;
        assert_near(v.norm(), speed, 1e-4, "speed");
        assert_near(degrees(v.x, -v.y), angle, 0.01, "angle");
    };
    for (angle, expected) in topspins {
        for (topspin, expected) in [-1.0, 0.0, 1.0, 2.0].into_iter().zip(expected) {
            check(started(1.0, angle, topspin, 0.0), expected);
        }
    }
    let sides = [(0.8379, 54.90), (0.8396, 54.35), (0.8476, 52.68), (0.9411, 43.19), (1.1156, 36.97)];
    for (side, expected) in [-2.0, -1.0, 0.0, 1.0, 2.0].into_iter().zip(sides) {
        check(started(1.0, 45.0, 1.0, side), expected);
    }
    let Twist { velocity, spin } = rebound(&law, &into_cushion(SNOOKER, 0.4, started(1.0, 45.0, 1.0, 0.0)));
    assert!((velocity - Vec3::new(0.5139, -0.6741, 0.0)).norm() < 1e-4, "{velocity:?}");
    assert!((spin - Vec3::new(-6.953, 19.577, 16.864)).norm() < 2e-3, "{spin:?}");
}

#[test]
fn c3_mathavan_2010_has_no_scale_and_a_mirror() {
    let law = mathavan(0.98, 0.14);
    for (angle, side) in [(20.0, 0.5), (45.0, -1.0), (70.0, 0.0), (85.0, 2.0)] {
        let one = rebound(&law, &into_cushion(SNOOKER, 0.4, started(1.0, angle, 1.0, side)));
        for speed in [0.5, 2.0, 7.0] {
            let found = rebound(&law, &into_cushion(SNOOKER, 0.4, started(speed, angle, 1.0, side)));
            assert!((found.velocity * (1.0 / speed) - one.velocity).norm() < 1e-12, "{speed}");
            assert!((found.spin * (1.0 / speed) - one.spin).norm() < 1e-10, "{speed}");
        }
        let seen = rebound(&law, &into_cushion(SNOOKER, 0.4, started(1.0, 180.0 - angle, 1.0, -side)));
        let Vec3 { x, y, z } = seen.velocity;
        assert!((Vec3::new(-x, y, z) - one.velocity).norm() < 1e-12, "{angle}");
        let Vec3 { x, y, z } = seen.spin;
        assert!((Vec3::new(x, -y, -z) - one.spin).norm() < 1e-10, "{angle}");
    }
}

/// A ball between nose and cloth, as Mathavan's equations have it: y into the cushion, the spin times the radius.
#[derive(Clone, Copy)]
struct Published {
    velocity: [f64; 2],
    rolled: [f64; 3],
    sin: f64,
    friction: f64,
    sliding: f64,
}

impl Published {
    fn cos(&self) -> f64 {
        libm::sqrt(1.0 - self.sin * self.sin)
    }

    /// One step of Euler's method: a slip that stops flickers about zero.
    fn stepped(self, push: f64) -> Self {
        let direction = |x: f64, y: f64| {
            let size = libm::hypot(x, y);
            if size == 0.0 { [0.0, 0.0] } else { [x / size, y / size] }
        };
        let ([vx, vy], [wx, wy, wz], sin, cos) = (self.velocity, self.rolled, self.sin, self.cos());
        let nose = direction(vx + wy * sin - wz * cos, -vy * sin + wx).map(|c| c * self.friction);
        let load = sin + nose[1] * cos;
        let cloth = direction(vx - wy, vy + wx).map(|c| c * self.sliding * load);
        let turn = 2.5 * push;
        Self {
            velocity: [vx - push * (nose[0] + cloth[0]), vy - push * (cos - sin * nose[1] + cloth[1])],
            rolled: [
                wx - turn * (nose[1] + cloth[1]),
                wy - turn * (nose[0] * sin - cloth[0]),
                wz + turn * nose[0] * cos,
            ],
            ..self
        }
    }

    /// The whole contact in steps of an equal push. The last step of each phase is as long as it takes.
    fn rebound(self, restitution: f64, steps: f64) -> Self {
        let push = self.velocity[1] / steps;
        let (mut now, mut work) = (self, 0.0);
        loop {
            let (before, next) = (now.velocity[1], now.stepped(push));
            let part = f64::min(1.0, before / (before - next.velocity[1]));
            now = now.stepped(part * push);
            work += 0.5 * part * push * self.cos() * (before + now.velocity[1]);
            if part < 1.0 {
                break;
            }
        }
        work *= restitution * restitution;
        loop {
            let (opening, next) = (-now.velocity[1], now.stepped(push));
            let gained = -next.velocity[1] - opening;
            let done = 0.5 * push * self.cos() * (2.0 * opening + gained);
            if done >= work {
                let root = libm::sqrt(opening * opening + 2.0 * gained * work / (push * self.cos()));
                return now.stepped(2.0 * work / ((opening + root) * self.cos()));
            }
            (now, work) = (next, work - done);
        }
    }
}

#[test]
fn c3_few_steps_of_high_order_agree_with_many_of_the_published_scheme() {
    let mut random = Random::new(3);
    let mut errors = Vec::new();
    for _ in 0..60 {
        let (restitution, friction) = (random.between(0.6, 0.99), random.between(0.05, 0.3));
        let motion =
            started(1.0, random.between(10.0, 170.0), random.between(-1.0, 2.0), random.between(-2.0, 2.0));
        let [vx, vy, _] = motion.velocity;
        let (rolled, sin, sliding) = (motion.rolled, 0.28, SNOOKER.sliding);
        let start = Published { velocity: [vx, vy], rolled, sin, friction, sliding };
        let found = rebound(&mathavan(restitution, friction), &into_cushion(SNOOKER, sin, motion));
        let [coarse, fine] = [20_000.0, 40_000.0].map(|steps| start.rebound(restitution, steps));
        // First order, so the difference of two step lengths is left over in the finer.
        let limit = |k: usize| 2.0 * fine.velocity[k] - coarse.velocity[k];
        errors.push(libm::hypot(found.velocity.x - limit(0), found.velocity.y - limit(1)));
    }
    errors.sort_by(f64::total_cmp);
    // Where a slip stops the published scheme flickers by a step's worth, 1/20000, and has no order.
    assert!(errors[59] < 5e-5, "{errors:?}");
    assert!(errors[50] < 1e-6, "{errors:?}");
}

/// What is left of a slip after the contact of a compliant cushion.
fn slip_left(at: &AtNose, law: &SphereLaw<f64>) -> f64 {
    let twist = rebound(law, at);
    let hit = at.hit::<f64>();
    twist.surface_velocity(at.ball.radius, -hit.contact_normal()).dot(Vec3::new(1.0, 0.0, 0.0))
}

#[test]
fn c4_a_compliant_cushion_gives_the_printed_slips() {
    let law = stronge(0.7, 0.2, 1.7);
    for (slip, expected) in [(0.5, -0.329_114_283_276_3), (3.0, 1.81)] {
        let at = into_cushion(POOL, 0.0, Motion::stun([slip, 1.0]));
        assert_near(slip_left(&at, &law), expected, 1e-12, "slip");
        let twist = rebound(&law, &at);
        assert_near(twist.velocity.y, -0.7, 1e-15, "normal");
    }
}

/// Springs and slider followed in time, for a slip of `slip` and a closing speed of one. Exact while nothing changes, so
/// its only error is when it finds out: within a step.
fn slip_in_time(restitution: f64, friction: f64, ratio: f64, slip: f64, steps: u32) -> f64 {
    let quarter = core::f64::consts::FRAC_PI_2;
    let compliance = 3.5 / (ratio * ratio);
    let end = (1.0 + restitution) * quarter;
    let step = end / f64::from(steps);
    let force = |time: f64| {
        if time < quarter { libm::sin(time) } else { libm::cos((time - quarter) / restitution) }
    };
    // The spring follows dF/dt = −v/η² while it sticks, and F = ± μ F_n while it slips.
    let (mut pull, mut speed) = (0.0_f64, slip);
    for k in 0..steps {
        let after = f64::from(k + 1) * step;
        let (cos, sin) = (libm::cos(ratio * step), libm::sin(ratio * step));
        let deflection = pull * compliance;
        let stuck_deflection = deflection * cos + speed / ratio * sin;
        let stuck_speed = speed * cos - deflection * ratio * sin;
        let limit = friction * force(after).max(0.0);
        let stuck_pull = stuck_deflection / compliance;
        if stuck_pull.abs() <= limit {
            (pull, speed) = (stuck_pull, stuck_speed);
        } else {
            let next = limit.copysign(stuck_pull);
            speed -= 3.5 * step * 0.5 * (pull + next);
            pull = next;
        }
    }
    speed
}

#[test]
fn c4_a_compliant_cushion_does_what_springs_and_friction_do_in_time() {
    let mut random = Random::new(14);
    for _ in 0..300 {
        let (restitution, friction) = (random.between(0.1, 1.0), random.between(0.02, 0.8));
        let (ratio, slip) = (random.between(1.05, 1.95), random.magnitude(1e-3, 10.0) * friction);
        let found = slip_left(
            &into_cushion(POOL, 0.0, Motion::stun([slip, 1.0])),
            &stronge(restitution, friction, ratio),
        );
        // Second order, so a quarter of the difference of two step lengths is left over a third of it.
        let [coarse, fine] =
            [20_000, 40_000].map(|steps| slip_in_time(restitution, friction, ratio, slip, steps));
        let expected = fine + (fine - coarse) / 3.0;
        let tolerance = 1e-9 + (fine - coarse).abs();
        let what = format!("e = {restitution}, μ = {friction}, ratio {ratio}, slip {slip}");
        assert_near(found, expected, tolerance, &what);
        assert!((fine - coarse).abs() < 1e-6, "{what}: {coarse} {fine}");
    }
}

#[test]
fn c5_a_straight_shot_without_side_leaves_along_the_normal() {
    let (normal, friction) = constant(0.85, 0.2);
    let frictional = SphereLaw::Frictional(Frictional { normal, friction });
    for law in [han(), mathavan(0.98, 0.14), mathavan(0.85, 0.2), stronge(0.85, 0.2, 1.8), frictional] {
        for topspin in [-1.0, 0.0, 0.4, 1.0] {
            let at = into_cushion(POOL, 0.28, started(1.0, 90.0, topspin, 0.0));
            let Twist { velocity, spin } = rebound(&law, &at);
            assert!(velocity.y < 0.0, "{law:?}: {velocity:?}");
            for (part, what) in [(velocity.x, "along"), (spin.y, "roll along"), (spin.z, "side")] {
                assert_near(part, 0.0, 1e-12, what);
            }
        }
    }
}

#[test]
fn c5_a_ball_between_nose_and_cloth_may_be_wedged() {
    let rough = Ball { sliding: 0.86, ..POOL };
    let motion = Motion { velocity: [-0.217, 0.976, 0.0], rolled: [-1.37, 0.257, 0.34] };
    let Twist { velocity, .. } = rebound(&mathavan(0.75, 0.84), &into_cushion(rough, 0.34, motion));
    assert_near(velocity.y, 0.0, 1e-6, "normal velocity");
}

#[test]
fn c7_a_ball_lands_and_keeps_its_side_spin() {
    let ball = POOL.sphere::<f64>();
    let land = |along: f64| {
        let twist = Twist { velocity: Vec3::new(along, 0.0, -1.0), spin: Vec3::new(0.0, 0.0, 50.0) };
        cloth::bounce(&ball, twist, 0.5, 0.2)
    };
    let Twist { velocity, spin } = land(0.5);
    assert!((velocity - Vec3::new(0.357_143, 0.0, 0.5)).norm() < 1e-6, "{velocity:?}");
    assert_near(spin.y, 12.4984, 1e-4, "roll");
    assert_near(spin.z, 50.0, 0.0, "side");
    let Twist { velocity, spin } = land(2.0);
    assert_near(velocity.x, 1.7, 1e-12, "where it slips");
    assert_near(spin.y, 26.2467, 1e-4, "where it slips");
    assert_near(spin.z, 50.0, 0.0, "side");
}

#[test]
fn coefficients_follow_speed_and_angle() {
    let restitution = NormalRestitution::BySpeed { coefficients: [0.39, 0.257, -0.044], up_to: 2.5 };
    assert_near(restitution.at(1.0), 0.603, 1e-15, "e at 1 m/s");
    assert_near(restitution.at(9.0), restitution.at(2.5), 0.0, "e beyond the range");
    let friction = IncidenceFriction::ByIncidence { coefficients: [0.471, -0.241] };
    assert_near(friction.at(1.0, 0.0), 0.471, 1e-15, "μ straight in");
    assert_near(friction.at(1.0, 1.0), 0.471 - 0.241 * core::f64::consts::FRAC_PI_4, 1e-15, "μ at 45°");
    let steep = IncidenceFriction::ByIncidence { coefficients: [0.1, -0.2] };
    assert_near(steep.at(0.0, 1.0), 0.0, 0.0, "no friction below zero");
}
