//! The radial distribution g(r), and its value at contact.
//!
//! g(r) is the mean number of centres in a ring about a disc, over the ring's area and the density. Along a periodic
//! axis the ring goes on beyond the side, and may be no wider than half of it (so each pair counts once, by its minimum
//! image). With a wall only those discs count as middles whose rings stay where centres can be: at least the range and
//! a mean radius from it. Everybody counts as their neighbour. The density is N over the area in a periodic box (so
//! that N points without any forces give 1 − 1/N), and with walls the density of the middles.
//!
//! The bins are laid so that one of their edges is the diameter. The value at contact is that of the cubic that fits
//! the bins of the first tenth of a diameter beyond it (or the first eight bins) best. In equilibrium Z = 1 + 2η g(σ).

use super::bins::Bins;
use super::blocks::Blocks;
use super::error::{ObserveError, unfit};
use super::events::EventSums;
use super::observable::Measure;
use super::pair_counts::{Middles, pair_counts};
use super::request::Options;
use super::results::{Column, Curve, Quantity, Results};
use super::snapshot::{Gas, Moment, Snapshot};
use serde::{Deserialize, Serialize};

/// How far the value at contact looks, in diameters.
const CONTACT_RANGE: f64 = 0.1;
/// The fewest bins it looks at.
const CONTACT_BINS: usize = 8;
/// The number of coefficients of a cubic.
const COEFFICIENTS: usize = 4;
/// Bins are counted up to so many.
const MOST_BINS: f64 = 1e6;

/// Options of the radial distribution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct RadialOptions {
    /// How far it goes, in (mean) diameters.
    range: f64,
    /// The width of a bin, in (mean) diameters.
    bin_width: f64,
}

impl Default for RadialOptions {
    fn default() -> Self {
        Self { range: 5.0, bin_width: 0.01 }
    }
}

impl Options for RadialOptions {
    fn check(&self) -> Result<(), String> {
        if !(self.bin_width > 0.0 && self.bin_width <= 1.0) {
            return Err("bin_width must be positive, and one diameter at most".to_owned());
        }
        if !(self.range > 1.0 + self.bin_width && self.range / self.bin_width <= MOST_BINS) {
            return Err(
                "range must be more than a diameter and a bin, and no more than a million bins".to_owned()
            );
        }
        Ok(())
    }
}

/// The radial distribution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct RadialDistribution {
    options: RadialOptions,
    bins: Bins,
    /// For each bin, the centres in the rings over the area of the rings.
    near: Vec<Blocks>,
    /// The same at contact.
    near_contact: Blocks,
    /// What the density of each bin beyond the diameter counts for at contact.
    weights: Vec<f64>,
    /// Middles of rings per area.
    density: Blocks,
}

impl RadialDistribution {
    pub fn new(options: RadialOptions) -> Self {
        let [near_contact, density] = Default::default();
        Self { options, bins: Bins::default(), near: Vec::new(), near_contact, weights: Vec::new(), density }
    }

    /// How far from a side a disc must be to be the middle of rings.
    fn margin(&self, gas: &Gas, axis: usize) -> f64 {
        if gas.periods[axis] { 0.0 } else { self.bins.end() + 0.5 * gas.diameter }
    }

    /// Where discs are middles of rings.
    fn middles(&self, gas: &Gas) -> Middles {
        let from =
            [0, 1].map(|axis| if gas.periods[axis] { f64::NEG_INFINITY } else { self.margin(gas, axis) });
        Middles { from, to: [0, 1].map(|axis| gas.size[axis] - from[axis]) }
    }

    /// The sides of the rectangle in which the middles of rings are.
    fn inner_size(&self, gas: &Gas) -> [f64; 2] {
        [0, 1].map(|axis| gas.size[axis] - 2.0 * self.margin(gas, axis))
    }

    fn curve(&self, gas: &Gas, density: f64) -> Curve {
        let middle = |bin| 0.5 * (self.bins.edge(bin) + self.bins.edge(bin + 1)) / gas.diameter;
        let r = Column::new(
            ["r", "diameter", "the middle of the bin, in (mean) diameters"],
            (0..self.bins.count).map(middle).collect(),
        );
        let g = ["g", "1", "centres at this distance, over those of as many points without any order"];
        let [mut g, mut error] = Column::measured(g, "g_error", &self.near);
        for value in g.values.iter_mut().chain(&mut error.values) {
            *value /= density;
        }
        Curve { name: "radial_distribution", columns: vec![r, g, error] }
    }
}

impl Measure for RadialDistribution {
    fn begin(&mut self, _: &Snapshot, gas: &Gas) -> Result<(), ObserveError> {
        if gas.diameter <= 0.0 {
            return Err(unfit("radial_distribution", "its range is in diameters, and the discs are points"));
        }
        self.bins = Bins::new(self.options.range, self.options.bin_width, gas.diameter);
        let room = [0, 1].map(|axis| {
            let radius = if gas.periods[axis] { 0.0 } else { 0.5 * gas.diameter };
            (0.5 * gas.size[axis] - radius) / gas.diameter
        });
        let most = if room[0] < room[1] { room[0] } else { room[1] };
        let has_room = self.options.range <= most && self.inner_size(gas).iter().all(|side| *side > 0.0);
        if !has_room {
            let problem = format!("in this box its range must be less than {most} diameters");
            return Err(unfit("radial_distribution", problem));
        }
        self.near = vec![Blocks::default(); self.bins.count];
        self.weights = if gas.has_one_diameter { contact_weights(&self.bins) } else { Vec::new() };
        Ok(())
    }

    fn sample(&mut self, moment: &Moment) {
        let (middles, counts) = pair_counts(moment.snapshot, &self.bins, &self.middles(moment.gas));
        let middles = middles as f64;
        for (bin, count) in counts.iter().enumerate() {
            self.near[bin].push_ratio(*count as f64, middles * self.bins.ring(bin));
        }
        let beyond = (self.bins.contact..).zip(&counts[self.bins.contact..]);
        let densities = beyond.map(|(bin, count)| *count as f64 / self.bins.ring(bin));
        let at_contact: f64 =
            self.weights.iter().zip(densities).map(|(weight, density)| weight * density).sum();
        self.near_contact.push_ratio(at_contact, middles);
        let [width, length] = self.inner_size(moment.gas);
        self.density.push(middles / (width * length));
    }

    fn results(&self, gas: &Gas, _: &EventSums) -> Results {
        let density = self.density.value().unwrap_or(f64::NAN);
        let mut quantities = Vec::new();
        if !self.weights.is_empty() {
            let z = gas.expected_compressibility();
            let expected = z.map(|z| (z - 1.0) / (2.0 * gas.packing_fraction));
            let contact = Quantity::measured(CONTACT, &self.near_contact, expected);
            quantities.push(contact.times(1.0 / density));
        }
        quantities.push(Quantity::measured(DENSITY, &self.density, None));
        Results { name: "radial_distribution", quantities, curves: vec![self.curve(gas, density)] }
    }
}

/// What the bins beyond the diameter count for in the value at contact of the cubic that fits them best: with rows
/// (1, t, t², t³) of a matrix X, the first row of (XᵀX)⁻¹ Xᵀ. None where there are too few bins for a cubic.
fn contact_weights(bins: &Bins) -> Vec<f64> {
    let wanted = (CONTACT_RANGE / (bins.width / bins.diameter) * (1.0 + 1e-12)) as usize;
    let count = wanted.max(CONTACT_BINS).min(bins.count - bins.contact);
    if count < COEFFICIENTS {
        return Vec::new();
    }
    let rows: Vec<[f64; COEFFICIENTS]> =
        (0..count).map(|bin| powers((bin as f64 + 0.5) / count as f64)).collect();
    let mut squares = [[0.0; COEFFICIENTS]; COEFFICIENTS];
    for row in &rows {
        for (i, j) in (0..COEFFICIENTS).flat_map(|i| (0..COEFFICIENTS).map(move |j| (i, j))) {
            squares[i][j] += row[i] * row[j];
        }
    }
    let first = solve(squares, [1.0, 0.0, 0.0, 0.0]);
    rows.iter().map(|row| row.iter().zip(first).map(|(power, weight)| power * weight).sum()).collect()
}

fn powers(t: f64) -> [f64; COEFFICIENTS] {
    [1.0, t, t * t, t * t * t]
}

/// Gauss's elimination, of a matrix so positive that pivots need not be looked for.
fn solve(
    mut matrix: [[f64; COEFFICIENTS]; COEFFICIENTS],
    mut right: [f64; COEFFICIENTS],
) -> [f64; COEFFICIENTS] {
    for pivot in 0..COEFFICIENTS {
        for row in (0..COEFFICIENTS).filter(|row| *row != pivot) {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            let taken = matrix[pivot];
            matrix[row].iter_mut().zip(taken).for_each(|(value, taken)| *value -= factor * taken);
            right[row] -= factor * right[pivot];
        }
    }
    core::array::from_fn(|row| right[row] / matrix[row][row])
}

const CONTACT: [&str; 3] =
    ["contact_value", "1", "g at the diameter, extrapolated; expected (Z − 1)/2η by the equation of state"];
const DENSITY: [&str; 3] =
    ["density", "1/length^2", "centres per area, away from walls: what g is relative to"];
