//! How speeds are distributed, beside Maxwell's distribution at the temperature that is measured.
//!
//! In two dimensions f(v) = (m v/kT) exp(−m v²/2kT), so that ⟨v⟩ = √(πkT/2m), ⟨v²⟩ = 2kT/m, and ⟨v⁴⟩/⟨v²⟩² = 2; at a
//! fixed energy of 2M degrees of freedom the last is 2M/(M + 1). Speeds are taken about the drift along periodic axes;
//! those of discs of unequal masses are scaled to the mean mass at the same energy, v √(m/m̄).

use super::blocks::Blocks;
use super::error::{ObserveError, unfit};
use super::events::EventSums;
use super::observable::Measure;
use super::pressure::TEMPERATURE;
use super::request::Options;
use super::results::{Column, Curve, Quantity, Results};
use super::snapshot::{Gas, Heat, Moment, Snapshot};
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// The histogram ends at so many times √(kT/m) of the first sample, if nothing else is asked for.
const FASTEST: f64 = 6.0;

/// Options of the distribution of speeds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct SpeedsOptions {
    /// Bins of the histogram.
    bins: usize,
    /// Where the histogram ends; 6 √(kT/m) of the first sample if it is not given.
    largest: Option<f64>,
}

impl Default for SpeedsOptions {
    fn default() -> Self {
        Self { bins: 120, largest: None }
    }
}

impl Options for SpeedsOptions {
    fn check(&self) -> Result<(), String> {
        if self.bins == 0 || self.bins > 100_000 {
            return Err("bins must be 1 at least and 100000 at most".to_owned());
        }
        if self.largest.is_some_and(|largest| !(largest > 0.0 && largest.is_finite())) {
            return Err("largest must be a positive speed".to_owned());
        }
        Ok(())
    }
}

/// The distribution of speeds and its moments.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Speeds {
    options: SpeedsOptions,
    /// The width of a bin.
    width: f64,
    /// Each bin's share of the discs.
    shares: Vec<Blocks>,
    /// The share of those beyond the histogram.
    beyond: Blocks,
    temperature: Blocks,
    mean: Blocks,
    square: Blocks,
    fourth: Blocks,
}

impl Speeds {
    pub fn new(options: SpeedsOptions) -> Self {
        let shares = vec![Blocks::default(); options.bins];
        let [beyond, temperature, mean, square, fourth] = Default::default();
        Self { options, width: 0.0, shares, beyond, temperature, mean, square, fourth }
    }

    /// A bin's share by Maxwell's distribution, over its width.
    fn maxwell(&self, bin: usize, temperature: f64, mass: f64) -> f64 {
        let slower = |speed: f64| <f64 as Scalar>::exp(-0.5 * mass * speed * speed / temperature);
        let start = bin as f64 * self.width;
        (slower(start) - slower(start + self.width)) / self.width
    }

    fn curve(&self, gas: &Gas) -> Curve {
        let bins = 0..self.shares.len();
        let middle = bins.clone().map(|bin| (bin as f64 + 0.5) * self.width).collect();
        let temperature = self.temperature.value().unwrap_or(f64::NAN);
        let maxwell = bins.map(|bin| self.maxwell(bin, temperature, gas.mass)).collect();
        let [mut density, mut error] = Column::measured(
            ["density", "time/length", "share of the discs, by the bin's width"],
            "density_error",
            &self.shares,
        );
        for value in density.values.iter_mut().chain(&mut error.values) {
            *value /= self.width;
        }
        let speed = Column::new(["speed", "length/time", "the middle of the bin"], middle);
        let expected =
            ["maxwell", "time/length", "Maxwell's distribution at the measured temperature, mean of the bin"];
        Curve { name: "speeds", columns: vec![speed, density, error, Column::new(expected, maxwell)] }
    }
}

impl Measure for Speeds {
    fn begin(&mut self, snapshot: &Snapshot, gas: &Gas) -> Result<(), ObserveError> {
        let thermal = FASTEST * (Heat::new(snapshot, gas).temperature / gas.mass).sqrt();
        let largest = self.options.largest.unwrap_or(thermal);
        self.width = largest / self.options.bins as f64;
        let problem = "nothing moves, so the largest speed of the histogram must be given, as largest";
        if self.width > 0.0 { Ok(()) } else { Err(unfit("speeds", problem)) }
    }

    fn sample(&mut self, Moment { snapshot, gas, heat, .. }: &Moment) {
        let mut counts = vec![0u32; self.shares.len() + 1];
        let [mut first, mut second, mut fourth] = [0.0; 3];
        for velocity in snapshot.thermal_velocities(gas, heat) {
            let square = velocity.norm_squared();
            let speed = square.sqrt();
            (first, second, fourth) = (first + speed, second + square, fourth + square * square);
            counts[((speed / self.width) as usize).min(self.shares.len())] += 1;
        }
        for (blocks, count) in self.shares.iter_mut().chain([&mut self.beyond]).zip(counts) {
            blocks.push(f64::from(count) / gas.count);
        }
        self.temperature.push(heat.temperature);
        self.mean.push(first / gas.count);
        self.square.push(second / gas.count);
        self.fourth.push_ratio(fourth * gas.count, second * second);
    }

    fn results(&self, gas: &Gas, _: &EventSums) -> Results {
        let square = self.temperature.value().map(|temperature| 2.0 * temperature / gas.mass);
        let mean = square.map(|square| 0.5 * (core::f64::consts::PI * square).sqrt());
        let pairs = 0.5 * gas.freedom;
        let quantities = vec![
            Quantity::measured(TEMPERATURE, &self.temperature, None),
            Quantity::measured(MEAN, &self.mean, mean),
            Quantity::measured(SQUARE, &self.square, square.map(|square| square / gas.finite_size())),
            Quantity::measured(FOURTH, &self.fourth, Some(2.0 * pairs / (pairs + 1.0))),
            Quantity::measured(BEYOND, &self.beyond, None),
        ];
        Results { name: "speeds", quantities, curves: vec![self.curve(gas)] }
    }
}

const MEAN: [&str; 3] = ["mean_speed", "length/time", "expected √(πkT/2m), of many discs"];
const SQUARE: [&str; 3] =
    ["mean_square_speed", "length^2/time^2", "expected 2kT/m, times the degrees of freedom of a disc over 2"];
const FOURTH: [&str; 3] = [
    "fourth_moment_ratio",
    "1",
    "⟨v⁴⟩/⟨v²⟩²; expected 2M/(M + 1) at a fixed energy of 2M degrees of freedom",
];
const BEYOND: [&str; 3] = ["beyond", "1", "share of the discs that are faster than the histogram goes"];
