//! Mean free time and path, between a disc's collisions with other discs, and how the free times are distributed.
//!
//! The mean free time is N t/(2 C) for C collisions of N discs in a time t, the mean free path the mean speed times
//! that; a bounce off a wall ends neither. Each free time from one collision of a disc to its next is counted in bins, of
//! which each octave has eight equally wide ones, so that no scale has to be guessed; the errors of the bins are those of
//! independent counts.

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::results::{Column, Curve, Quantity, Results};
use super::snapshot::{Gas, Moment};
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// Bits of the mantissa that tell bins apart: 2³ bins to an octave.
const MANTISSA_BITS: u32 = 3;
/// The bits of a time that do not matter for its bin.
const DROPPED_BITS: u32 = 52 - MANTISSA_BITS;
/// The first bin begins at 2⁻⁵⁰; it takes in all that is shorter.
const FIRST: u64 = (1023 - 50) << MANTISSA_BITS;
/// The bins end at 2³⁰; the last takes in all that is longer.
const BINS: usize = 80 << MANTISSA_BITS;
/// No collision yet.
const NEVER: f64 = f64::MIN;

/// The times between the collisions of each disc.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct FreeTimes {
    /// When each disc collided last.
    last: Vec<f64>,
    counts: Vec<u64>,
}

impl FreeTimes {
    pub fn new(discs: usize) -> Self {
        Self { last: vec![NEVER; discs], counts: vec![0; BINS] }
    }

    #[inline(always)]
    pub fn collision(&mut self, time: f64, ball_a: u32, ball_b: u32) {
        for ball in [ball_a, ball_b] {
            let last = core::mem::replace(&mut self.last[ball as usize], time);
            if last != NEVER {
                self.counts[bin(time - last)] += 1;
            }
        }
    }

    /// The bins from the first to the last that is not empty.
    fn bins(&self) -> Vec<Bin> {
        let is_hit = |count: &u64| *count > 0;
        let first = self.counts.iter().position(is_hit).unwrap_or(0);
        let end = self.counts.iter().rposition(is_hit).map_or(0, |last| last + 1);
        let bin =
            |place| Bin { start: start(place), end: start(place + 1), count: self.counts[place] as f64 };
        (first..end).map(bin).collect()
    }
}

/// A bin of free times.
struct Bin {
    start: f64,
    end: f64,
    count: f64,
}

/// The bin of a time: its exponent and the first bits of its mantissa.
#[inline(always)]
fn bin(time: f64) -> usize {
    // No time is negative, but zero may have a sign.
    let bits = (time.to_bits() & !(1 << 63)) >> DROPPED_BITS;
    (bits.saturating_sub(FIRST) as usize).min(BINS - 1)
}

/// Where a bin begins.
fn start(place: usize) -> f64 {
    f64::from_bits((FIRST + place as u64) << DROPPED_BITS)
}

/// Mean free time and path.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct FreePath {
    /// Mean speed at the last sample.
    speed: f64,
    time: Blocks,
    path: Blocks,
    /// For the free time that is expected.
    temperature: Blocks,
}

impl Measure for FreePath {
    fn sample(&mut self, moment: &Moment) {
        let speeds = moment.snapshot.velocities.iter().map(|velocity| (*velocity - moment.heat.drift).norm());
        let speed = speeds.sum::<f64>() / moment.gas.count;
        if let Some(interval) = &moment.interval {
            let free_time = moment.gas.count * interval.duration;
            let mean_speed = 0.5 * (self.speed + speed);
            self.time.push_ratio(free_time, 2.0 * interval.collisions);
            self.path.push_ratio(free_time * mean_speed, 2.0 * interval.collisions);
            self.temperature.push(interval.temperature);
        }
        self.speed = speed;
    }

    fn results(&self, gas: &Gas, events: &EventSums) -> Results {
        let rate = gas.expected_collision_rate().filter(|rate| *rate > 0.0);
        let speed = self.temperature.value().map(|temperature| (temperature / gas.mass).sqrt());
        let path = rate.map(|rate| gas.diameter * core::f64::consts::FRAC_PI_2.sqrt() / rate);
        let time =
            rate.zip(speed.filter(|speed| *speed > 0.0)).map(|(rate, speed)| gas.diameter / (rate * speed));
        let quantities = vec![
            Quantity::measured(
                [
                    "mean_free_time",
                    "time",
                    "between collisions of a disc with others; expected by the equation of state",
                ],
                &self.time,
                time,
            ),
            Quantity::measured(
                [
                    "mean_free_path",
                    "length",
                    "mean speed times mean free time; expected by the equation of state",
                ],
                &self.path,
                path,
            ),
        ];
        let bins = events.free_times.as_ref().map_or_else(Vec::new, FreeTimes::bins);
        Results { name: "free_path", quantities, curves: vec![distribution(&bins)] }
    }
}

fn distribution(bins: &[Bin]) -> Curve {
    let total: f64 = bins.iter().map(|bin| bin.count).sum();
    let mean = bins.iter().map(|bin| bin.count * 0.5 * (bin.start + bin.end)).sum::<f64>() / total;
    let longer = |time: f64| <f64 as Scalar>::exp(-time / mean);
    let column = |names, of: &dyn Fn(&Bin) -> f64| Column::new(names, bins.iter().map(of).collect());
    Curve {
        name: "free_times",
        columns: vec![
            column(["start", "time", "where the bin begins"], &|bin| bin.start),
            column(["end", "time", "where the bin ends"], &|bin| bin.end),
            column(["density", "1/time", "share of the free times in the bin, by its width"], &|bin| {
                bin.count / (total * (bin.end - bin.start))
            }),
            column(["density_error", "1/time", "standard error of as many independent counts"], &|bin| {
                bin.count.sqrt() / (total * (bin.end - bin.start))
            }),
            column(
                ["poisson", "1/time", "collisions by chance alone: the exponential with the bins' mean"],
                &|bin| (longer(bin.start) - longer(bin.end)) / (bin.end - bin.start),
            ),
        ],
    }
}
