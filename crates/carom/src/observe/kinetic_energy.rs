//! Kinetic energy over time, and Haff's law of inelastic gases.
//!
//! While the gas is homogeneous, kT = kT₀/[1 + (1 − e²) ν₀ t/4]² in two dimensions, from a loss of (1 − e²) kT in each
//! collision; ν₀ is the collision rate of a disc at the first sample, which the equation of state gives (P. K. Haff,
//! *Grain flow as a fluid-mechanical phenomenon*, J. Fluid Mech. 134, 401, 1983).

use super::error::{ObserveError, unfit};
use super::events::EventSums;
use super::observable::Measure;
use super::request::Options;
use super::results::Results;
use super::series::{Point, Series};
use super::snapshot::{Gas, Heat, Moment, Snapshot};
use serde::{Deserialize, Serialize};

/// Options of the kinetic energy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct KineticEnergyOptions {
    /// Points of the curve at most.
    points: usize,
    /// The restitution of discs among themselves, for Haff's law beside the curve.
    restitution: Option<f64>,
}

impl Default for KineticEnergyOptions {
    fn default() -> Self {
        Self { points: 1024, restitution: None }
    }
}

impl Options for KineticEnergyOptions {
    fn check(&self) -> Result<(), String> {
        if self.restitution.is_some_and(|restitution| !(0.0..=1.0).contains(&restitution)) {
            return Err("restitution must be from 0 to 1".to_owned());
        }
        Series::check(self.points)
    }
}

/// Kinetic energy over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct KineticEnergy {
    options: KineticEnergyOptions,
    series: Series,
    haff: Option<Haff>,
}

/// Haff's law.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Haff {
    start: f64,
    /// kT at the start, by which the discs' mean energy about the drift is the same but for the finite size.
    energy: f64,
    /// The energy of the drift, which no collision takes.
    drift: f64,
    /// (1 − e²) ν₀/4.
    rate: f64,
}

impl Haff {
    fn new(snapshot: &Snapshot, gas: &Gas, restitution: f64) -> Result<Self, ObserveError> {
        let problem = "Haff's law is one of equal discs that are not too dense: leave out restitution";
        let reduced = gas.expected_collision_rate().ok_or_else(|| unfit("kinetic_energy", problem))?;
        if gas.diameter <= 0.0 {
            return Err(unfit("kinetic_energy", "points do not collide: leave out restitution"));
        }
        let heat = Heat::new(snapshot, gas);
        let collision_rate = reduced * (heat.temperature / gas.mass).sqrt() / gas.diameter;
        Ok(Self {
            start: snapshot.time,
            energy: heat.temperature / gas.finite_size(),
            drift: 0.5 * gas.mass * heat.drift.norm_squared(),
            rate: 0.25 * (1.0 - restitution * restitution) * collision_rate,
        })
    }

    fn at(&self, time: f64) -> f64 {
        let slowing = 1.0 + self.rate * (time - self.start);
        self.drift + self.energy / (slowing * slowing)
    }
}

impl KineticEnergy {
    pub fn new(options: KineticEnergyOptions) -> Self {
        let series = Series::new(options.points);
        Self { options, series, haff: None }
    }
}

impl Measure for KineticEnergy {
    fn begin(&mut self, snapshot: &Snapshot, gas: &Gas) -> Result<(), ObserveError> {
        let haff = |restitution| Haff::new(snapshot, gas, restitution);
        self.haff = self.options.restitution.map(haff).transpose()?;
        Ok(())
    }

    fn sample(&mut self, Moment { snapshot, gas, .. }: &Moment) {
        let [mut sum, mut squares] = [0.0; 2];
        for (velocity, mass) in snapshot.velocities.iter().zip(snapshot.masses) {
            let energy = 0.5 * mass * velocity.norm_squared();
            (sum, squares) = (sum + energy, squares + energy * energy);
        }
        let mean = sum / gas.count;
        let variance = squares / gas.count - mean * mean;
        let error = if variance > 0.0 { (variance / gas.count).sqrt() } else { 0.0 };
        let expected = self.haff.as_ref().map_or(0.0, |haff| haff.at(snapshot.time));
        self.series.push(Point { time: snapshot.time, value: mean, error, expected });
    }

    fn results(&self, _: &Gas, _: &EventSums) -> Results {
        let value = ["kinetic_energy", "energy", "mean of a disc"];
        let error = [
            "kinetic_energy_error",
            "energy",
            "standard error of as many independent discs, as if no total were fixed",
        ];
        let expected = ["haff", "energy", "Haff's law from the first sample, of a homogeneous gas"];
        let curve = self.series.curve(value, error, self.haff.as_ref().map(|_| expected));
        Results { name: "kinetic_energy", quantities: Vec::new(), curves: vec![curve] }
    }
}
