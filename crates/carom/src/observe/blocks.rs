//! The mean of a correlated series and its standard error, in memory that grows with the logarithm of its length.
//!
//! The series is averaged in blocks of 1, 2, 4, ... values; at each length the scatter of the blocks gives an error of
//! the mean, which grows with the length until the blocks are independent (H. Flyvbjerg, H. G. Petersen, *Error
//! estimates on averages of correlated data*, J. Chem. Phys. 91, 461, 1989). The length B that is taken is the shortest
//! with B³ > 2 n (s_B/s_1)⁴, where n is the number of values and s_B the error from blocks of B: there the systematic
//! part of the error and the noise of its estimate balance (R. M. Lee et al., Phys. Rev. E 83, 066706, 2011). Where no
//! length does, the series is too short to show its correlations, and the largest of the errors is taken.
//!
//! What is averaged is a ratio Σa/Σb, whose error follows from the scatter of a − (Σa/Σb) b; a plain mean has b = 1.

use serde::{Deserialize, Serialize};

/// The fewest blocks whose scatter is looked at, except that of single values.
const FEWEST_BLOCKS: u64 = 4;

/// A mean, or a ratio of means, with its standard error.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Blocks {
    /// Level k looks at blocks of 2^k values.
    levels: Vec<Level>,
}

/// The blocks of one length.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Level {
    count: u64,
    /// Of a and of b.
    mean: [f64; 2],
    /// Sums over the blocks of (a − ā)², (a − ā)(b − b̄), (b − b̄)².
    spread: [f64; 3],
    /// A block that waits for its neighbour, to make a block of the next length with it.
    pending: Option<[f64; 2]>,
}

impl Blocks {
    /// Takes in the next value.
    pub fn push(&mut self, value: f64) {
        self.push_ratio(value, 1.0);
    }

    /// Takes in the next pair of a ratio of sums.
    pub fn push_ratio(&mut self, numerator: f64, denominator: f64) {
        let mut block = [numerator, denominator];
        let mut place = 0;
        loop {
            if place == self.levels.len() {
                self.levels.push(Level::default());
            }
            let level = &mut self.levels[place];
            level.add(block);
            let Some(earlier) = level.pending.take() else {
                level.pending = Some(block);
                return;
            };
            block = [0.5 * (earlier[0] + block[0]), 0.5 * (earlier[1] + block[1])];
            place += 1;
        }
    }

    /// How many values came in.
    pub fn count(&self) -> u64 {
        self.levels.first().map_or(0, |level| level.count)
    }

    /// The mean, or the ratio of the sums; `None` without values, or where the denominator is zero.
    pub fn value(&self) -> Option<f64> {
        let [numerator, denominator] = self.levels.first()?.mean;
        (denominator != 0.0).then(|| numerator / denominator)
    }

    /// The standard error of the value; `None` for fewer than two values.
    pub fn error(&self) -> Option<f64> {
        let ratio = self.value()?;
        let first = self.levels.first()?.squared_error(ratio)?;
        let scale = self.levels.first()?.mean[1].abs();
        if first == 0.0 {
            return Some(0.0);
        }
        let (mut largest, mut cubed_length) = (first, 1.0);
        for level in self.levels.iter().take_while(|level| level.count >= FEWEST_BLOCKS) {
            let squared = level.squared_error(ratio)?;
            let growth = squared / first;
            if cubed_length > 2.0 * self.count() as f64 * growth * growth {
                return Some(squared.sqrt() / scale);
            }
            largest = if squared > largest { squared } else { largest };
            cubed_length *= 8.0;
        }
        Some(largest.sqrt() / scale)
    }
}

impl Level {
    /// One more block (B. P. Welford's sums, which do not cancel).
    fn add(&mut self, block: [f64; 2]) {
        self.count += 1;
        let count = self.count as f64;
        let before = [block[0] - self.mean[0], block[1] - self.mean[1]];
        self.mean = [self.mean[0] + before[0] / count, self.mean[1] + before[1] / count];
        let after = [block[0] - self.mean[0], block[1] - self.mean[1]];
        self.spread[0] += before[0] * after[0];
        self.spread[1] += before[0] * after[1];
        self.spread[2] += before[1] * after[1];
    }

    /// The square of the standard error of the mean of a − ratio × b; `None` for a single block.
    fn squared_error(&self, ratio: f64) -> Option<f64> {
        if self.count < 2 {
            return None;
        }
        let [aa, ab, bb] = self.spread;
        let spread = aa - 2.0 * ratio * ab + ratio * ratio * bb;
        let count = self.count as f64;
        // Round-off may leave a trace below zero.
        Some(if spread > 0.0 { spread / (count * (count - 1.0)) } else { 0.0 })
    }
}
