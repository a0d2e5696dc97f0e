//! Temperature and density along an axis.
//!
//! The temperature of a strip is the mean thermal energy of the discs in it, times the gas's 2N degrees of freedom over
//! those it has without its fixed momentum. A flow within the gas, other than a drift of all of it, counts as heat.

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::request::Options;
use super::results::{Column, Curve, Results};
use super::snapshot::{Gas, Moment};
use serde::{Deserialize, Serialize};

/// The axis of a profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Axis {
    X,
    Y,
}

/// Options of a profile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct ProfileOptions {
    /// Along which axis.
    axis: Axis,
    /// Strips.
    bins: usize,
}

impl Default for ProfileOptions {
    fn default() -> Self {
        Self { axis: Axis::X, bins: 20 }
    }
}

impl Options for ProfileOptions {
    fn check(&self) -> Result<(), String> {
        let is_fit = (1..=100_000).contains(&self.bins);
        if is_fit { Ok(()) } else { Err("bins must be 1 at least and 100000 at most".to_owned()) }
    }
}

/// Temperature and density in strips across an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct TemperatureProfile {
    options: ProfileOptions,
    density: Vec<Blocks>,
    temperature: Vec<Blocks>,
}

impl TemperatureProfile {
    pub fn new(options: ProfileOptions) -> Self {
        let blocks = vec![Blocks::default(); options.bins];
        Self { options, density: blocks.clone(), temperature: blocks }
    }

    fn axis(&self) -> usize {
        match self.options.axis {
            Axis::X => 0,
            Axis::Y => 1,
        }
    }
}

impl Measure for TemperatureProfile {
    fn sample(&mut self, Moment { snapshot, gas, heat, .. }: &Moment) {
        let (axis, bins) = (self.axis(), self.options.bins);
        let mut strips = vec![(0.0, 0.0); bins];
        let velocities = snapshot.thermal_velocities(gas, heat);
        for (position, velocity) in snapshot.positions.iter().zip(velocities) {
            let part = position.to_f64()[axis] / gas.size[axis];
            let within = if gas.periods[axis] { part - part.floor() } else { part };
            let strip = &mut strips[((within * bins as f64) as usize).min(bins - 1)];
            *strip = (strip.0 + 1.0, strip.1 + 0.5 * gas.mass * velocity.norm_squared());
        }
        let area = gas.area() / bins as f64;
        for (bin, (count, energy)) in strips.into_iter().enumerate() {
            self.density[bin].push(count / area);
            self.temperature[bin].push_ratio(energy * gas.finite_size(), count);
        }
    }

    fn results(&self, gas: &Gas, _: &EventSums) -> Results {
        let (name, width) = (["x", "y"][self.axis()], gas.size[self.axis()] / self.options.bins as f64);
        let places = (0..self.options.bins).map(|bin| (bin as f64 + 0.5) * width).collect();
        let mut columns = vec![Column::new([name, "length", "the middle of the strip"], places)];
        let temperature = ["temperature", "energy", "kT of the discs in the strip"];
        let density = ["density", "1/length^2", "centres per area"];
        columns.extend(Column::measured(temperature, "temperature_error", &self.temperature));
        columns.extend(Column::measured(density, "density_error", &self.density));
        let curves = vec![Curve { name: "profile", columns }];
        Results { name: "temperature_profile", quantities: Vec::new(), curves }
    }
}
