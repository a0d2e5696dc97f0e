//! The velocities of a gas.
//!
//! Maxwell's: each component is a normal number with variance kT/m. Where the box is periodic nothing ever changes the total momentum
//! along that axis, which is made zero: the gas does not drift, and that degree of freedom holds no heat. Then all
//! velocities are scaled so that the kinetic energy is exactly that of the degrees of freedom left, kT/2 for each: (N − 1)
//! kT in a periodic box, N kT between walls, (N − 1/2) kT with one axis of each kind. So kT = E/(N − 1), which is what a
//! run at constant energy and momentum measures as its temperature. A single disc in a periodic box is at rest.
//!
//! Equal speeds: random directions, turned until their momenta sum to zero, and then scaled to the same energy.

use super::error::Error;
use super::normal::normal_pair;
use super::recipe::{Recipe, Velocities};
use super::sum::sum;
use crate::geometry::Vec2;
use crate::random::Random;

/// The drift of directions counts as none below this part of their length: a few roundings.
const NO_DRIFT: f64 = 1e-15;

/// Each time directions are turned the drift is halved or so.
const MOST_TURNS: usize = 1000;

/// The velocities that a recipe asks for.
pub(super) fn drawn(masses: &[f64], recipe: &Recipe) -> Result<Vec<Vec2<f64>>, Error> {
    let Recipe { temperature, periodic, seed, .. } = *recipe;
    match recipe.velocities {
        Velocities::Maxwell => Ok(maxwell(masses, temperature, periodic, seed)),
        Velocities::EqualSpeed => equal_speed(masses, temperature, periodic, seed),
    }
}

/// Velocities of one speed whose momenta sum to zero, along walls and periodic sides alike.
fn equal_speed(
    masses: &[f64],
    temperature: f64,
    periodic: [bool; 2],
    seed: u64,
) -> Result<Vec<Vec2<f64>>, Error> {
    let heaviest = masses.iter().copied().fold(0.0, f64::max);
    if 2.0 * heaviest > sum(masses.iter().copied()) {
        return Err(Error::NoBalance);
    }
    let mut random = Random::new(seed, "gas.velocities");
    let mut velocities: Vec<_> =
        masses.iter().map(|_| unit(Vec2::from_f64(normal_pair(&mut random)))).collect();
    for _ in 0..MOST_TURNS {
        let drift = drift(&velocities, masses, [true, true]);
        if drift.norm_squared() <= NO_DRIFT * NO_DRIFT {
            heat(&mut velocities, masses, temperature, periodic);
            return Ok(velocities);
        }
        velocities.iter_mut().for_each(|velocity| *velocity = unit(*velocity - drift));
    }
    Err(Error::NoBalance)
}

/// The direction of a vector.
fn unit(vector: Vec2<f64>) -> Vec2<f64> {
    vector * (1.0 / vector.norm_squared().sqrt())
}

/// Maxwell's velocities of discs with these masses, without drift along periodic axes.
pub fn maxwell(masses: &[f64], temperature: f64, periodic: [bool; 2], seed: u64) -> Vec<Vec2<f64>> {
    let mut random = Random::new(seed, "gas.velocities");
    let velocity = |mass: &f64| Vec2::from_f64(normal_pair(&mut random)) * (1.0 / mass).sqrt();
    let mut velocities: Vec<Vec2<f64>> = masses.iter().map(velocity).collect();
    // The second time takes away what rounding left.
    for _ in 0..2 {
        stop_drift(&mut velocities, masses, periodic);
    }
    heat(&mut velocities, masses, temperature, periodic);
    velocities
}

/// Takes the velocity of the centre of mass away, along periodic axes.
fn stop_drift(velocities: &mut [Vec2<f64>], masses: &[f64], periodic: [bool; 2]) {
    let drift = drift(velocities, masses, periodic);
    velocities.iter_mut().for_each(|velocity| *velocity = *velocity - drift);
}

/// The velocity of the centre of mass along some of the axes.
fn drift(velocities: &[Vec2<f64>], masses: &[f64], axes: [bool; 2]) -> Vec2<f64> {
    let mass = sum(masses.iter().copied());
    let along = |is_sought: bool, component: fn(&Vec2<f64>) -> f64| {
        let momentum = |(velocity, mass): (&Vec2<f64>, &f64)| component(velocity) * mass;
        if is_sought { sum(velocities.iter().zip(masses).map(momentum)) / mass } else { 0.0 }
    };
    Vec2::new(along(axes[0], |v| v.x), along(axes[1], |v| v.y))
}

/// Scales velocities to a temperature.
fn heat(velocities: &mut [Vec2<f64>], masses: &[f64], temperature: f64, periodic: [bool; 2]) {
    let held = periodic.into_iter().filter(|is_periodic| *is_periodic).count();
    let freedom = (2 * velocities.len() - held) as f64;
    let twice_energy = sum(velocities.iter().zip(masses).map(|(v, mass)| v.norm_squared() * mass));
    let factor = if freedom > 0.0 { (freedom * temperature / twice_energy).sqrt() } else { 0.0 };
    velocities.iter_mut().for_each(|velocity| *velocity = *velocity * factor);
}
