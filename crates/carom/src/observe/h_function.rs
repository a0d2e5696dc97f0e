//! Boltzmann's H = ∫ f ln f d²v over time.
//!
//! Velocities are counted in rings of equal area in the plane of velocities, so it is assumed that no direction is
//! preferred. The area is that at which exp(−m v²/2kT) falls by a factor exp(−δ) from ring to ring, at the temperature
//! of the moment. With the share p of each ring H = Σ p ln p − ln(area); counting N discs in K rings makes this too
//! large by (K − 1)/2N on average, which is taken off (G. A. Miller, *Note on the bias of information estimates*,
//! 1955). Maxwell's distribution has ln(m/2πkT) − 1; rings of a finite area see a value that is lower by about δ²/24,
//! which the column `maxwell` allows for. Rings are to hold many discs each: fewer than a thousand want wider ones. At
//! equal speeds the energy is kT, which no ring of the default area begins with. H is per disc; discs of unequal masses
//! count with v √(m/m̄).

use super::events::EventSums;
use super::observable::Measure;
use super::request::Options;
use super::results::Results;
use super::series::{Point, Series};
use super::snapshot::{Gas, Moment};
use crate::scalar::{Scalar, ln};
use serde::{Deserialize, Serialize};

/// The last ring takes in all that is faster.
const MOST_RINGS: usize = 1 << 16;

/// Options of H.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct HOptions {
    /// δ: the area of a ring, as the part of kT by which the energies at its edges differ.
    ring: f64,
    /// Points of the curve at most.
    points: usize,
}

impl Default for HOptions {
    fn default() -> Self {
        Self { ring: 0.12, points: 1024 }
    }
}

impl Options for HOptions {
    fn check(&self) -> Result<(), String> {
        if !(self.ring >= 0.001 && self.ring <= 1.0) {
            return Err("ring must be from 0.001 to 1".to_owned());
        }
        Series::check(self.points)
    }
}

/// H over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct HFunction {
    options: HOptions,
    series: Series,
}

impl HFunction {
    pub fn new(options: HOptions) -> Self {
        let series = Series::new(options.points);
        Self { options, series }
    }

    /// How many discs are in each ring.
    fn rings(&self, Moment { snapshot, gas, heat, .. }: &Moment) -> Vec<u32> {
        let per_square = 0.5 * gas.mass / (heat.temperature * self.options.ring);
        let mut counts = Vec::new();
        for velocity in snapshot.thermal_velocities(gas, heat) {
            let ring = ((per_square * velocity.norm_squared()) as usize).min(MOST_RINGS - 1);
            if ring >= counts.len() {
                counts.resize(ring + 1, 0u32);
            }
            counts[ring] += 1;
        }
        counts
    }
}

impl Measure for HFunction {
    fn sample(&mut self, moment: &Moment) {
        let (gas, temperature) = (moment.gas, moment.heat.temperature);
        // A gas at rest has no H.
        if temperature <= 0.0 {
            return;
        }
        let scale = 2.0 * core::f64::consts::PI * temperature / gas.mass;
        let area = scale * self.options.ring;
        let [mean, variance, rings] = logarithms(&self.rings(moment), gas.count);
        self.series.push(Point {
            time: moment.snapshot.time,
            value: mean - ln(area) - 0.5 * (rings - 1.0) / gas.count,
            error: (variance / gas.count).sqrt(),
            expected: maxwell(self.options.ring) - ln(area),
        });
    }

    fn results(&self, _: &Gas, _: &EventSums) -> Results {
        let value = ["h", "1", "∫ f ln f d²v of a disc"];
        let error = ["h_error", "1", "standard error of as many independent discs"];
        let expected = ["maxwell", "1", "that of Maxwell's distribution at the temperature of the moment"];
        let curve = self.series.curve(value, error, Some(expected));
        Results { name: "h_function", quantities: Vec::new(), curves: vec![curve] }
    }
}

/// Mean and variance over the discs of ln p of a disc's ring, and the number of rings that are not empty.
fn logarithms(counts: &[u32], discs: f64) -> [f64; 3] {
    let [mut mean, mut square, mut rings] = [0.0; 3];
    for count in counts.iter().filter(|count| **count > 0) {
        let share = f64::from(*count) / discs;
        let logarithm = ln(share);
        mean += share * logarithm;
        square += share * logarithm * logarithm;
        rings += 1.0;
    }
    let variance = square - mean * mean;
    [mean, if variance > 0.0 { variance } else { 0.0 }, rings]
}

/// Σ p ln p of rings whose shares are those of Maxwell's distribution: p = (1 − q) qᵏ with q = exp(−δ).
fn maxwell(ring: f64) -> f64 {
    let q = <f64 as Scalar>::exp(-ring);
    ln(1.0 - q) - ring * q / (1.0 - q)
}
