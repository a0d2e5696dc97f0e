//! Gases that are made up, and how what is found of them is asked for.

use carom::geometry::Vec2;
use carom::observe::{Observables, Quantity, Request, Results, Snapshot};
use carom::random::Random;
use carom::run::{Event, Kind, Observer, Plane};
use core::f64::consts::PI;

/// A gas that stands still until the test moves it.
#[derive(Clone)]
pub struct Gas {
    pub size: [f64; 2],
    pub periods: [bool; 2],
    pub positions: Vec<Vec2<f64>>,
    pub velocities: Vec<Vec2<f64>>,
    pub radii: Vec<f64>,
    pub masses: Vec<f64>,
}

impl Gas {
    /// Discs of diameter and mass one at these places, all with the velocity (1, 0).
    pub fn new(size: [f64; 2], periods: [bool; 2], positions: Vec<Vec2<f64>>) -> Self {
        let count = positions.len();
        let velocities = vec![Vec2::new(1.0, 0.0); count];
        Self { size, periods, positions, velocities, radii: vec![0.5; count], masses: vec![1.0; count] }
    }

    /// Points anywhere in the box.
    pub fn random(count: usize, size: [f64; 2], periods: [bool; 2], random: &mut Random) -> Self {
        let place = |_| Vec2::new(size[0] * random.unit(), size[1] * random.unit());
        Self::new(size, periods, (0..count).map(place).collect())
    }

    /// A triangular lattice of `2 * rows` rows with `columns` sites each, all of the box, and shifted so that sites lie
    /// on its sides and beyond them.
    pub fn triangular(spacing: f64, columns: usize, rows: usize) -> Self {
        let height = 3.0_f64.sqrt() * spacing;
        let size = [spacing * columns as f64, height * rows as f64];
        let mut positions = Vec::new();
        for row in 0..2 * rows {
            for column in 0..columns {
                let x = spacing * (column as f64 + 0.5 * (row % 2) as f64);
                positions.push(Vec2::new(x - 0.25 * spacing, 0.5 * height * row as f64 - 3.0 * size[1]));
            }
        }
        Self::new(size, [true; 2], positions)
    }

    pub fn at(&self, time: f64) -> Snapshot<'_> {
        Snapshot {
            time,
            size: self.size,
            periods: self.periods,
            positions: &self.positions,
            velocities: &self.velocities,
            radii: &self.radii,
            masses: &self.masses,
        }
    }

    /// Draws all velocities anew from Maxwell's distribution.
    pub fn heat(&mut self, temperature: f64, random: &mut Random) {
        for (velocity, mass) in self.velocities.iter_mut().zip(&self.masses) {
            *velocity = gaussian(random) * (temperature / mass).sqrt();
        }
    }

    /// Moves everybody for a time, through everything.
    pub fn fly(&mut self, time: f64) {
        for (position, velocity) in self.positions.iter_mut().zip(&self.velocities) {
            *position = *position + *velocity * time;
        }
    }
}

/// Two independent normal numbers (Box and Muller).
pub fn gaussian(random: &mut Random) -> Vec2<f64> {
    let length = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    let angle = 2.0 * PI * random.unit();
    Vec2::new(length * angle.cos(), length * angle.sin())
}

pub fn observe(name: &str) -> Observables {
    Observables::new(&[Request::new(name)]).unwrap()
}

/// Tells of a collision.
pub fn collide(observables: &mut Observables, time: f64, balls: (u32, u32), impulse: f64) {
    tell(observables, Kind::BallBall, time, (balls.0, Some(balls.1)), impulse);
}

/// Tells of a bounce off a wall.
pub fn bounce(observables: &mut Observables, time: f64, ball: u32, impulse: f64) {
    tell(observables, Kind::BallCushion, time, (ball, None), impulse);
}

fn tell(
    observables: &mut Observables,
    kind: Kind,
    time: f64,
    (ball_a, ball_b): (u32, Option<u32>),
    impulse: f64,
) {
    let [point, normal] = [Vec2::ZERO, Vec2::new(1.0, 0.0)];
    let (closing_speed, cushion, cluster) = (1.0, None, None);
    let event = Event { time, kind, ball_a, ball_b, cushion, point, normal, closing_speed, impulse, cluster };
    Observer::<f64, Plane>::event(observables, &event);
}

pub fn only(observables: &Observables) -> Results {
    observables.results().remove(0)
}

pub fn quantity(observables: &Observables, name: &str) -> Quantity {
    only(observables).quantity(name).unwrap_or_else(|| panic!("no {name}")).clone()
}

pub fn value(observables: &Observables, name: &str) -> f64 {
    quantity(observables, name).value.unwrap()
}

pub fn column(observables: &Observables, curve: &str, column: &str) -> Vec<f64> {
    only(observables).column(curve, column).unwrap_or_else(|| panic!("no {column}")).to_vec()
}

/// Whether two numbers agree but for round-off.
pub fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// Holds a measured number against the true one: within five errors, and the error no larger than `most` of it.
pub fn assert_within_errors(quantity: &Quantity, truth: f64, most: f64) {
    let (value, error) = (quantity.value.unwrap(), quantity.error.unwrap());
    assert!((value - truth).abs() <= 5.0 * error, "{}: {value} ± {error} against {truth}", quantity.name);
    assert!(error <= most * truth.abs(), "{}: {value} ± {error} says little", quantity.name);
}
