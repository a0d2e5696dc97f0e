//! Balls that touch each other and walls, as a law of clusters sees them.

use super::random::Random;
use carom::geometry::Vec2;
use carom::law::ball_ball::{self, Restitution};
use carom::law::cluster::{self, DiscLaw, Passes, effective_radius, resolve_hertz};
use carom::scalar::Scalar;

pub type Body<S> = cluster::Body<S>;
pub type Touch<S> = cluster::Touch<S>;

/// A ball of a scene: radius, mass, position, velocity.
#[derive(Clone, Copy)]
pub struct Sphere {
    pub radius: f64,
    pub mass: f64,
    pub position: Vec2<f64>,
    pub velocity: Vec2<f64>,
}

pub fn unit_ball(position: [f64; 2], velocity: [f64; 2]) -> Sphere {
    Sphere { radius: 1.0, mass: 1.0, position: Vec2::from_f64(position), velocity: Vec2::from_f64(velocity) }
}

/// The bodies' numbers, the point and the normal.
pub type Contact = (usize, Option<usize>, Vec2<f64>, Vec2<f64>);

/// Balls, and walls as a point on each with the direction into it.
#[derive(Clone, Default)]
pub struct Scene {
    pub balls: Vec<Sphere>,
    pub walls: Vec<(Vec2<f64>, Vec2<f64>)>,
}

impl Scene {
    /// What touches what, in order of place.
    pub fn contacts(&self) -> Vec<Contact> {
        let mut contacts = Vec::new();
        for (a, one) in self.balls.iter().enumerate() {
            for (b, two) in self.balls.iter().enumerate().skip(a + 1) {
                let apart = two.position - one.position;
                if apart.norm() < (one.radius + two.radius) * (1.0 + 1e-9) {
                    contacts.push((a, Some(b), one.position + apart.unit() * one.radius, apart.unit()));
                }
            }
            for &(point, normal) in &self.walls {
                let distance = (point - one.position).dot(normal);
                if distance < one.radius * (1.0 + 1e-9) {
                    contacts.push((a, None, one.position + normal * one.radius, normal));
                }
            }
        }
        contacts.sort_by(|l, r| (l.2.x, l.2.y).partial_cmp(&(r.2.x, r.2.y)).unwrap());
        contacts
    }

    pub fn effective_radius(&self, a: usize, b: Option<usize>) -> f64 {
        effective_radius(self.balls[a].radius, b.map(|b| self.balls[b].radius))
    }

    pub fn cluster<S: Scalar>(&self, e: f64) -> (Vec<Body<S>>, Vec<Touch<S>>) {
        let number = S::from_f64;
        let vector = |v: Vec2<f64>| Vec2::new(number(v.x), number(v.y));
        let law = DiscLaw::Balls(ball_ball::Law::Restitution(Restitution { normal: number(e) }));
        let bodies = self.balls.iter().map(|b| Body::new(vector(b.velocity), S::ONE / number(b.mass)));
        let touches = self.contacts().into_iter().map(|(a, b, _, normal)| {
            let effective_radius = number(self.effective_radius(a, b));
            Touch { effective_radius, ..Touch::new(a, b, vector(normal), law) }
        });
        (bodies.collect(), touches.collect())
    }

    pub fn resolved(&self, e: f64) -> (Vec<Vec2<f64>>, Passes) {
        let (mut bodies, mut touches) = self.cluster(e);
        let passes = resolve_hertz(&mut bodies, &mut touches);
        (bodies.iter().map(|body| body.velocity).collect(), passes)
    }

    pub fn energy(&self, velocities: &[Vec2<f64>]) -> f64 {
        self.balls.iter().zip(velocities).map(|(ball, v)| 0.5 * ball.mass * v.norm_squared()).sum()
    }

    pub fn momentum(&self, velocities: &[Vec2<f64>]) -> Vec2<f64> {
        self.balls.iter().zip(velocities).fold(Vec2::ZERO, |sum, (ball, v)| sum + *v * ball.mass)
    }

    pub fn velocities(&self) -> Vec<Vec2<f64>> {
        self.balls.iter().map(|ball| ball.velocity).collect()
    }
}

/// Balls in a row, the first of which runs into the others.
pub fn row(count: usize) -> Scene {
    let balls = (0..count).map(|k| unit_ball([2.0 * k as f64, 0.0], [f64::from(u8::from(k == 0)), 0.0]));
    Scene { balls: balls.collect(), walls: Vec::new() }
}

pub fn one_into_two() -> Scene {
    let side = |sign: f64| unit_ball([3.0_f64.sqrt(), sign], [0.0, 0.0]);
    let balls = vec![unit_ball([0.0, 0.0], [1.0, 0.0]), side(1.0), side(-1.0)];
    Scene { balls, walls: Vec::new() }
}

/// A ball that runs down into the apex of fifteen, at speed 10.
pub fn rack() -> Scene {
    let mut balls = vec![unit_ball([0.0, 2.0], [0.0, -10.0])];
    for row in 0..5 {
        for k in 0..=row {
            let place = [f64::from(2 * k - row), -3.0_f64.sqrt() * f64::from(row)];
            balls.push(unit_ball(place, [0.0, 0.0]));
        }
    }
    Scene { balls, walls: Vec::new() }
}

/// A row bent at random, of balls of many sizes, some of them moving, and perhaps a wall at its end.
pub fn random_scene(random: &mut Random) -> Scene {
    let mut scene = Scene::default();
    let mut place = Vec2::ZERO;
    let mut last = 0.0;
    for _ in 0..2 + random.below(4) {
        let radius = random.between(0.5, 2.0);
        let turn = random.between(-0.7, 0.7);
        place = place + Vec2::new(turn.cos(), turn.sin()) * (last + radius);
        let velocity = if random.flips() { random.direction() } else { [0.0, 0.0] };
        let mass = random.between(0.3, 3.0);
        scene.balls.push(Sphere { radius, mass, position: place, velocity: Vec2::from_f64(velocity) });
        last = radius;
    }
    if random.flips() {
        let turn = random.between(-0.7, 0.7);
        let normal = Vec2::new(turn.cos(), turn.sin());
        scene.walls.push((place + normal * last, normal));
    }
    scene
}

pub fn farthest(found: &[Vec2<f64>], expected: &[Vec2<f64>]) -> f64 {
    found.iter().zip(expected).map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max)
}
