//! Spheres and their contacts, in any scalar.

use super::random::Random;
use carom::geometry::{Vec2, Vec3};
use carom::law::ball_ball::SpherePair;
use carom::law::ball_cushion::CushionHit;
use carom::model::{Sphere, Twist};
use carom::scalar::Scalar;

/// A pool ball.
pub const POOL: Ball = Ball { radius: 0.028_575, mass: 0.170_097, sliding: 0.2 };

/// A ball as numbers.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub radius: f64,
    pub mass: f64,
    pub sliding: f64,
}

/// A motion as numbers: velocity, and spin times the radius.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub velocity: [f64; 3],
    pub rolled: [f64; 3],
}

/// Two balls that meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    pub balls: [Ball; 2],
    pub normal: [f64; 3],
    pub motions: [Motion; 2],
    pub on_cloth: [bool; 2],
}

/// A ball at a cushion.
#[derive(Clone, Copy, Debug)]
pub struct AtNose {
    pub ball: Ball,
    pub normal: [f64; 2],
    /// Sine of the contact angle.
    pub sin: f64,
    pub motion: Motion,
    pub is_airborne: bool,
}

impl Ball {
    pub fn sphere<S: Scalar>(self) -> Sphere<S> {
        let [radius, mass, sliding] = [self.radius, self.mass, self.sliding].map(S::from_f64);
        let [rolling, spin_decay] = [0.01, 10.9].map(S::from_f64);
        Sphere { radius, mass, inverse_mass: S::ONE / mass, sliding, rolling, spin_decay }
    }
}

impl Motion {
    pub const REST: Self = Self { velocity: [0.0; 3], rolled: [0.0; 3] };

    pub fn twist<S: Scalar>(self, ball: Ball) -> Twist<S> {
        let spin = self.rolled.map(|speed| speed / ball.radius);
        Twist { velocity: Vec3::from_f64(self.velocity), spin: Vec3::from_f64(spin) }
    }

    /// A ball on the cloth that rolls, with a side spin.
    pub fn rolling([x, y]: [f64; 2], side: f64) -> Self {
        Self { velocity: [x, y, 0.0], rolled: [-y, x, side] }
    }

    /// A ball that slides without spin.
    pub fn stun([x, y]: [f64; 2]) -> Self {
        Self { velocity: [x, y, 0.0], rolled: [0.0; 3] }
    }

    pub fn times(self, factor: f64) -> Self {
        Self { velocity: self.velocity.map(|c| c * factor), rolled: self.rolled.map(|c| c * factor) }
    }
}

impl Meeting {
    pub fn pair<S: Scalar>(&self) -> SpherePair<S> {
        let twists = [0, 1].map(|k| self.motions[k].twist(self.balls[k]));
        let normal = Vec3::from_f64(self.normal);
        SpherePair { spheres: self.balls.map(Ball::sphere), normal, twists, on_cloth: self.on_cloth }
    }

    /// A ball that meets an equal one at rest, with a cut angle: it deflects the first to the right, along x.
    pub fn cut(ball: Ball, motion: Motion, angle_deg: f64) -> Self {
        let angle = angle_deg.to_radians();
        let normal = [libm::cos(angle), libm::sin(angle), 0.0];
        Self { balls: [ball; 2], normal, motions: [motion, Motion::REST], on_cloth: [true; 2] }
    }

    /// A random contact that closes: balls that roll, slide or spin anyhow, some in the air, some not alike.
    pub fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let other = Ball { radius: 0.03, mass: 0.21, sliding: random.between(0.0, 0.5) };
        let balls = [POOL, if random.flips() { POOL } else { other }];
        let in_air = random.below(3) == 0;
        let [x, y] = random.direction();
        let rise = if in_air { random.between(-0.9, 0.9) } else { slope(balls) };
        let level = libm::sqrt(1.0 - rise * rise);
        let normal = [x * level, y * level, rise];
        let motions = [0, 1].map(|k| random_motion(&mut random, in_air && k == 0));
        let found = Self { balls, normal, motions, on_cloth: [!in_air, true] };
        if found.pair::<f64>().closing_speed() > 0.0 { found } else { found.reversed() }
    }

    fn reversed(self) -> Self {
        Self { motions: self.motions.map(|motion| motion.times(-1.0)), ..self }
    }
}

impl AtNose {
    pub fn hit<S: Scalar>(&self) -> CushionHit<S> {
        let sin = S::from_f64(self.sin);
        CushionHit {
            sphere: self.ball.sphere(),
            normal: Vec2::from_f64(self.normal),
            sin,
            cos: (S::ONE - sin.squared()).sqrt(),
            twist: self.motion.twist(self.ball),
            is_airborne: self.is_airborne,
        }
    }

    /// A random contact that closes.
    pub fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let is_airborne = random.below(4) == 0;
        let ball = Ball { sliding: random.between(0.0, 0.5), ..POOL };
        let sin = *random.choose(&[0.0, 0.203, 0.28, 0.4]);
        let normal = random.direction();
        let motion = random_motion(&mut random, is_airborne);
        let found = Self { ball, normal, sin, motion, is_airborne };
        if found.hit::<f64>().closing_speed() > 0.0 {
            found
        } else {
            Self { motion: motion.times(-1.0), ..found }
        }
    }
}

/// How much the line between the centres of two balls on the cloth rises.
fn slope([first, second]: [Ball; 2]) -> f64 {
    (second.radius - first.radius) / (second.radius + first.radius)
}

fn random_motion(random: &mut Random, in_air: bool) -> Motion {
    let speed = random.magnitude(0.01, 10.0);
    let [x, y] = random.direction().map(|c| c * speed);
    let mut any = || speed * random.between(-2.0, 2.0);
    let (side, spin) = (any(), [any(), any(), any()]);
    let mut motion = match spin[0].to_bits() % 4 {
        0 => Motion::rolling([x, y], 0.0),
        1 => Motion::stun([x, y]),
        2 => Motion::rolling([x, y], side),
        _ => Motion { velocity: [x, y, 0.0], rolled: spin },
    };
    if in_air {
        motion.velocity[2] = spin[1];
    }
    motion
}

/// The velocity with which a ball rolls in the end.
pub fn rolling_velocity(ball: Ball, twist: &Twist<f64>) -> Vec2<f64> {
    let spun = Vec2::new(twist.spin.y, -twist.spin.x) * ball.radius;
    twist.velocity.plan() * (5.0 / 7.0) + spun * (2.0 / 7.0)
}

pub fn degrees(x: f64, y: f64) -> f64 {
    libm::atan2(y, x).to_degrees()
}
