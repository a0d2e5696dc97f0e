//! Mean square displacement and velocity autocorrelation, and the diffusion coefficient from both.
//!
//! Positions and velocities of a few samples are kept as origins, which are compared with the samples after them up to
//! the longest lag; then each makes room for a new one. So the memory is bounded: 32 bytes for each disc and origin.
//! Origins follow each other at equal intervals, the longest lag over their number.
//!
//! D = [⟨r²(t₂)⟩ − ⟨r²(t₁)⟩]/4(t₂ − t₁) with the longest lag t₂ and about half of it as t₁, which leaves out how the
//! motion began; and D = ½ ∫ ⟨v(0)·v(t)⟩ dt up to the longest lag, by trapezia between the lags. The second needs lags
//! shorter than the mean free time. Positions are unwrapped; a drift of the whole gas counts as motion. In two
//! dimensions D grows with the size of the gas and, logarithmically, with the lag (long-time tails).

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::request::Options;
use super::results::{Column, Curve, Quantity, Results};
use super::snapshot::{Gas, Moment, Snapshot};
use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

/// How lags follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Lags {
    /// 1, 2, 3, 4, 6, 8, 12, 16, ... samples.
    Logarithmic,
    /// Every number of samples.
    Linear,
}

/// Options of diffusion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct DiffusionOptions {
    /// The longest lag, in samples.
    longest: u64,
    /// How lags follow each other.
    lags: Lags,
    /// How many origins are kept at a time.
    origins: u64,
}

impl Default for DiffusionOptions {
    fn default() -> Self {
        Self { longest: 256, lags: Lags::Logarithmic, origins: 4 }
    }
}

impl Options for DiffusionOptions {
    fn check(&self) -> Result<(), String> {
        if !(2..=1_000_000).contains(&self.longest) {
            return Err("longest must be 2 samples at least and 1000000 at most".to_owned());
        }
        if !(1..=self.longest).contains(&self.origins) {
            return Err("origins must be 1 at least, and longest at most".to_owned());
        }
        Ok(())
    }
}

impl DiffusionOptions {
    /// The lags in samples, from zero to the longest.
    fn lags(&self) -> Vec<u64> {
        let is_short = |lag: &u64| *lag < self.longest;
        let mut lags: Vec<u64> = match self.lags {
            Lags::Linear => (0..self.longest).collect(),
            Lags::Logarithmic => {
                let doubling = (0..).map(|k| 1u64 << k).take_while(is_short);
                [0].into_iter()
                    .chain(doubling.flat_map(|lag| [lag, lag + lag / 2]))
                    .filter(is_short)
                    .collect()
            }
        };
        lags.push(self.longest);
        lags.dedup();
        lags
    }
}

/// Mean square displacement and velocity autocorrelation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Diffusion {
    options: DiffusionOptions,
    /// In samples, from zero on.
    lags: Vec<u64>,
    /// The lag from which on the displacement counts for D: the first of half the longest at least.
    half: u64,
    samples: u64,
    origins: Vec<Origin>,
    times: Vec<Blocks>,
    displacement: Vec<Blocks>,
    correlation: Vec<Blocks>,
    from_displacement: Blocks,
    from_correlation: Blocks,
}

/// A sample with which later ones are compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Origin {
    /// Which sample it is.
    sample: u64,
    time: f64,
    positions: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    /// Lag and mean square displacement at half the longest lag.
    half: [f64; 2],
    /// Lag and correlation at the last of the lags.
    last: [f64; 2],
    /// The integral of the correlation so far.
    integral: f64,
}

impl Origin {
    fn new(sample: u64, snapshot: &Snapshot) -> Self {
        let numbers = |vectors: &[Vec2<f64>]| vectors.iter().map(|vector| vector.to_f64()).collect();
        Self {
            sample,
            time: snapshot.time,
            positions: numbers(snapshot.positions),
            velocities: numbers(snapshot.velocities),
            half: [0.0; 2],
            last: [0.0; 2],
            integral: 0.0,
        }
    }

    /// Mean square displacement and velocity correlation up to a sample.
    fn compare(&self, snapshot: &Snapshot) -> [f64; 2] {
        let [mut square, mut correlation] = [0.0; 2];
        for (now, then) in snapshot.positions.iter().zip(&self.positions) {
            square += (*now - Vec2::new(then[0], then[1])).norm_squared();
        }
        for (now, then) in snapshot.velocities.iter().zip(&self.velocities) {
            correlation += now.dot(Vec2::new(then[0], then[1]));
        }
        let count = self.positions.len() as f64;
        [square / count, correlation / count]
    }

    /// Goes on with the integral to the correlation at a lag.
    fn integrate(&mut self, lag: f64, correlation: f64) {
        self.integral += 0.5 * (correlation + self.last[1]) * (lag - self.last[0]);
        self.last = [lag, correlation];
    }
}

impl Diffusion {
    pub fn new(options: DiffusionOptions) -> Self {
        let lags = options.lags();
        let half = lags.iter().copied().find(|lag| 2 * lag >= options.longest).unwrap_or(0);
        let blocks = vec![Blocks::default(); lags.len()];
        Self {
            options,
            lags,
            half,
            samples: 0,
            origins: Vec::new(),
            times: blocks.clone(),
            displacement: blocks.clone(),
            correlation: blocks,
            from_displacement: Blocks::default(),
            from_correlation: Blocks::default(),
        }
    }

    /// The number of samples from origin to origin.
    fn spacing(&self) -> u64 {
        self.options.longest.div_ceil(self.options.origins)
    }

    /// Compares a sample with an origin, if it is at one of the lags from it.
    fn compare(&mut self, origin: &mut Origin, snapshot: &Snapshot) {
        let lag = self.samples - origin.sample;
        let Ok(place) = self.lags.binary_search(&lag) else { return };
        let time = snapshot.time - origin.time;
        let [square, correlation] = origin.compare(snapshot);
        self.times[place].push(time);
        self.displacement[place].push(square);
        self.correlation[place].push(correlation);
        origin.integrate(time, correlation);
        if lag == self.half {
            origin.half = [time, square];
        } else if lag == self.options.longest {
            let [half_time, half_square] = origin.half;
            self.from_displacement.push(0.25 * (square - half_square) / (time - half_time));
            self.from_correlation.push(0.5 * origin.integral);
        }
    }
}

impl Measure for Diffusion {
    fn sample(&mut self, Moment { snapshot, .. }: &Moment) {
        if self.samples.is_multiple_of(self.spacing()) {
            self.origins.push(Origin::new(self.samples, snapshot));
        }
        let mut origins = core::mem::take(&mut self.origins);
        for origin in &mut origins {
            self.compare(origin, snapshot);
        }
        origins.retain(|origin| self.samples - origin.sample < self.options.longest);
        self.origins = origins;
        self.samples += 1;
    }

    fn results(&self, _: &Gas, _: &EventSums) -> Results {
        let times = self.times.iter().map(|time| time.value().unwrap_or(f64::NAN)).collect();
        let mut columns = vec![Column::new(["lag", "time", "from the origin on"], times)];
        columns.extend(Column::measured(DISPLACEMENT, "mean_square_displacement_error", &self.displacement));
        columns.extend(Column::measured(CORRELATION, "velocity_autocorrelation_error", &self.correlation));
        let quantities = vec![
            Quantity::measured(FROM_DISPLACEMENT, &self.from_displacement, None),
            Quantity::measured(FROM_CORRELATION, &self.from_correlation, None),
        ];
        Results { name: "diffusion", quantities, curves: vec![Curve { name: "diffusion", columns }] }
    }
}

const DISPLACEMENT: [&str; 3] = ["mean_square_displacement", "length^2", "mean over discs and origins"];
const CORRELATION: [&str; 3] =
    ["velocity_autocorrelation", "length^2/time^2", "⟨v(0)·v(t)⟩, mean over discs and origins"];
const FROM_DISPLACEMENT: [&str; 3] = [
    "diffusion_from_displacement",
    "length^2/time",
    "a quarter of the slope of the mean square displacement over the longer half of the lags",
];
const FROM_CORRELATION: [&str; 3] = [
    "diffusion_from_velocities",
    "length^2/time",
    "half the integral of the velocity autocorrelation, up to the longest lag",
];
