//! Normal random numbers, by the polar method of Marsaglia: a point of the unit disc, and one logarithm.

use crate::random::Random;
use crate::scalar::ln;

/// Two independent numbers with mean 0 and variance 1.
pub(super) fn normal_pair(random: &mut Random) -> [f64; 2] {
    loop {
        let [x, y] = random.in_disc();
        let squared = x * x + y * y;
        if squared > 0.0 {
            let factor = (-2.0 * ln(squared) / squared).sqrt();
            return [x * factor, y * factor];
        }
    }
}

/// A normal number no further from 0 than `truncation`.
pub(super) fn truncated_normal(random: &mut Random, truncation: f64) -> f64 {
    loop {
        let [number, _] = normal_pair(random);
        if number.abs() <= truncation {
            return number;
        }
    }
}
