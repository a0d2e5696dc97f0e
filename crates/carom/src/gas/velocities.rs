//! Maxwell's velocities.
//!
//! Each component is a normal number with variance kT/m. Where the box is periodic nothing ever changes the total momentum
//! along that axis, which is made zero: the gas does not drift, and that degree of freedom holds no heat. Then all
//! velocities are scaled so that the kinetic energy is exactly that of the degrees of freedom left, kT/2 for each: (N − 1)
//! kT in a periodic box, N kT between walls, (N − 1/2) kT with one axis of each kind. So kT = E/(N − 1), which is what a
//! run at constant energy and momentum measures as its temperature. A single disc in a periodic box is at rest.

use super::normal::normal_pair;
use super::sum::sum;
use crate::geometry::Vec2;
use crate::random::Random;

/// Velocities of discs with these masses.
pub(super) fn maxwell(masses: &[f64], temperature: f64, periodic: [bool; 2], seed: u64) -> Vec<Vec2<f64>> {
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
    let mass = sum(masses.iter().copied());
    let drift = |is_periodic: bool, component: fn(&Vec2<f64>) -> f64| {
        let momentum = |(velocity, mass): (&Vec2<f64>, &f64)| component(velocity) * mass;
        if is_periodic { sum(velocities.iter().zip(masses).map(momentum)) / mass } else { 0.0 }
    };
    let drift = Vec2::new(drift(periodic[0], |v| v.x), drift(periodic[1], |v| v.y));
    velocities.iter_mut().for_each(|velocity| *velocity = *velocity - drift);
}

/// Scales velocities to a temperature.
fn heat(velocities: &mut [Vec2<f64>], masses: &[f64], temperature: f64, periodic: [bool; 2]) {
    let held = periodic.into_iter().filter(|is_periodic| *is_periodic).count();
    let freedom = (2 * velocities.len() - held) as f64;
    let twice_energy = sum(velocities.iter().zip(masses).map(|(v, mass)| v.norm_squared() * mass));
    let factor = if freedom > 0.0 { (freedom * temperature / twice_energy).sqrt() } else { 0.0 };
    velocities.iter_mut().for_each(|velocity| *velocity = *velocity * factor);
}
