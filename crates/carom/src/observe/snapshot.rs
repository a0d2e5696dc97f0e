//! The gas at a moment, and what all observables want to know of it.

use super::error::ObserveError;
use super::state_equation;
use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

/// The gas at a moment, in a rectangle from the origin to `size`.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// When.
    pub time: f64,
    /// Width and length of the rectangle.
    pub size: [f64; 2],
    /// Which axes are periodic; the others end at smooth walls.
    pub periods: [bool; 2],
    /// The centres, unwrapped: they go on beyond a periodic side.
    pub positions: &'a [Vec2<f64>],
    /// The velocities.
    pub velocities: &'a [Vec2<f64>],
    /// The radii.
    pub radii: &'a [f64],
    /// The masses.
    pub masses: &'a [f64],
}

/// What stays the same all along.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Gas {
    /// The number of discs.
    pub count: f64,
    /// Width and length of the rectangle.
    pub size: [f64; 2],
    /// Which axes are periodic.
    pub periods: [bool; 2],
    /// The diameter, or the mean of the diameters.
    pub diameter: f64,
    /// Whether all discs have the same diameter.
    pub has_one_diameter: bool,
    /// Whether all discs have the same mass.
    pub has_one_mass: bool,
    /// The mean of the masses.
    pub mass: f64,
    /// The part of the area that the discs cover.
    pub packing_fraction: f64,
    /// Degrees of freedom: two for each disc, less one for each periodic axis, along which the momentum cannot change.
    pub freedom: f64,
}

/// What the velocities of a snapshot say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Heat {
    /// The velocity of the centre of mass along the periodic axes, which is no heat; zero along others.
    pub drift: Vec2<f64>,
    /// kT: twice the kinetic energy about the drift for each degree of freedom.
    pub temperature: f64,
}

/// Between two samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    /// How long it was.
    pub duration: f64,
    /// The mean of kT at its ends.
    pub temperature: f64,
    /// Collisions of discs with each other.
    pub collisions: f64,
    /// Sum over them of impulse × distance of the centres.
    pub virial: f64,
    /// Sum of the impulses at walls.
    pub wall_impulse: f64,
}

/// What an observable is shown at a sample.
pub(super) struct Moment<'a> {
    pub snapshot: &'a Snapshot<'a>,
    pub gas: &'a Gas,
    pub heat: Heat,
    /// What happened since the last sample; `None` at the first.
    pub interval: Option<Interval>,
}

impl Snapshot<'_> {
    /// Refuses a snapshot that contradicts itself.
    pub(super) fn check(&self) -> Result<(), ObserveError> {
        let count = self.positions.len();
        let lengths = [self.velocities.len(), self.radii.len(), self.masses.len()];
        let is_number = |vectors: &[Vec2<f64>]| vectors.iter().all(|vector| vector.is_finite());
        let is_positive = |value: &f64| *value > 0.0 && value.is_finite();
        let problem = if count == 0 {
            "it has no discs"
        } else if lengths != [count; 3] {
            "it has not as many velocities, radii and masses as positions"
        } else if !self.size.iter().all(is_positive) {
            "its width and length must be positive"
        } else if !self.masses.iter().all(is_positive) {
            "masses must be positive"
        } else if !(self.time.is_finite() && is_number(self.positions) && is_number(self.velocities)) {
            "it has a number that is not finite"
        } else {
            return Ok(());
        };
        Err(ObserveError::BadSnapshot { time: self.time, problem: problem.to_owned() })
    }

    /// Velocities about the drift, scaled to those that a disc of the gas's mean mass would have at the same energy.
    pub(super) fn thermal_velocities(&self, gas: &Gas, heat: &Heat) -> impl Iterator<Item = Vec2<f64>> {
        let (mass, has_one_mass, drift) = (gas.mass, gas.has_one_mass, heat.drift);
        self.velocities.iter().zip(self.masses).map(move |(velocity, own)| {
            let scale = if has_one_mass { 1.0 } else { (own / mass).sqrt() };
            (*velocity - drift) * scale
        })
    }
}

impl Gas {
    /// The gas of a snapshot that was checked.
    pub fn new(snapshot: &Snapshot) -> Result<Self, ObserveError> {
        let count = snapshot.positions.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let is_one = |values: &[f64]| values.iter().all(|value| *value == values[0]);
        let covered: f64 = snapshot.radii.iter().map(|radius| core::f64::consts::PI * radius * radius).sum();
        let (has_one_diameter, has_one_mass) = (is_one(snapshot.radii), is_one(snapshot.masses));
        let periodic_axes = snapshot.periods.iter().filter(|is_periodic| **is_periodic).count();
        let freedom = 2.0 * count - periodic_axes as f64;
        if freedom <= 0.0 {
            let problem = "a single disc in a periodic box has no temperature".to_owned();
            return Err(ObserveError::BadSnapshot { time: snapshot.time, problem });
        }
        Ok(Self {
            count,
            size: snapshot.size,
            periods: snapshot.periods,
            // The value itself where all are one: a mean may round.
            diameter: 2.0 * if has_one_diameter { snapshot.radii[0] } else { mean(snapshot.radii) },
            mass: if has_one_mass { snapshot.masses[0] } else { mean(snapshot.masses) },
            has_one_diameter,
            has_one_mass,
            packing_fraction: covered / (snapshot.size[0] * snapshot.size[1]),
            freedom,
        })
    }

    /// Whether a snapshot is one of this gas.
    pub fn check(&self, snapshot: &Snapshot) -> Result<(), ObserveError> {
        let is_same = snapshot.positions.len() as f64 == self.count
            && snapshot.size == self.size
            && snapshot.periods == self.periods;
        let problem = "it has another number of discs, or another box, than those before it".to_owned();
        if is_same { Ok(()) } else { Err(ObserveError::BadSnapshot { time: snapshot.time, problem }) }
    }

    /// The area of the rectangle.
    pub fn area(&self) -> f64 {
        self.size[0] * self.size[1]
    }

    /// The length of the walls.
    pub fn wall_length(&self) -> f64 {
        let both = |axis: usize| if self.periods[axis] { 0.0 } else { 2.0 * self.size[1 - axis] };
        both(0) + both(1)
    }

    /// The factor from the mean thermal energy of a disc to kT: one but for the missing degrees of freedom.
    pub fn finite_size(&self) -> f64 {
        2.0 * self.count / self.freedom
    }

    /// Whether all discs are alike.
    pub fn is_uniform(&self) -> bool {
        self.has_one_diameter && self.has_one_mass
    }

    /// The compressibility factor of a large gas of this packing fraction, where it is known; masses do not matter.
    pub fn expected_compressibility(&self) -> Option<f64> {
        state_equation::compressibility(self.packing_fraction).filter(|_| self.has_one_diameter)
    }

    /// Collisions of a disc per time, in units of √(kT/m)/σ, in a large gas of this packing fraction: (4/√π)(Z − 1).
    pub fn expected_collision_rate(&self) -> Option<f64> {
        self.expected_compressibility()
            .filter(|_| self.has_one_mass)
            .map(|z| state_equation::rate_per_excess() * (z - 1.0))
    }
}

impl Heat {
    /// That of a snapshot.
    pub fn new(snapshot: &Snapshot, gas: &Gas) -> Self {
        let drift = drift(snapshot);
        let thermal = |(velocity, mass): (&Vec2<f64>, &f64)| mass * (*velocity - drift).norm_squared();
        let twice_energy: f64 = snapshot.velocities.iter().zip(snapshot.masses).map(thermal).sum();
        Self { drift, temperature: twice_energy / gas.freedom }
    }
}

fn drift(snapshot: &Snapshot) -> Vec2<f64> {
    let mut momentum = Vec2::ZERO;
    let mut mass = 0.0;
    for (velocity, own) in snapshot.velocities.iter().zip(snapshot.masses) {
        momentum = momentum + *velocity * *own;
        mass += own;
    }
    let along = |axis: usize, momentum: f64| if snapshot.periods[axis] { momentum / mass } else { 0.0 };
    Vec2::new(along(0, momentum.x), along(1, momentum.y))
}
