//! How a varied number is distributed.

use super::normal::{normal_quantile, normal_share};
use thiserror::Error;

/// The largest size of a number here: sums and differences of a few such numbers are finite.
const LARGEST: f64 = 1e300;

/// What values a varied number takes, and how often.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Every value of a range equally likely.
    Uniform {
        /// The least value.
        low: f64,
        /// The largest value.
        high: f64,
    },
    /// A normal distribution.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation.
        standard_deviation: f64,
    },
    /// A normal distribution without what lies outside a range.
    TruncatedNormal {
        /// Mean of the whole distribution.
        mean: f64,
        /// Standard deviation of the whole distribution.
        standard_deviation: f64,
        /// No value is less; minus infinity: there is no such bound.
        low: f64,
        /// No value is larger; infinity: there is no such bound.
        high: f64,
    },
}

/// A number of a distribution outside its range.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{key}: must be {allowed}, got {got}")]
pub struct DistributionError {
    /// Which number: a field of [`Distribution`].
    pub key: &'static str,
    /// What it may be.
    pub allowed: String,
    /// What it is.
    pub got: f64,
}

impl Distribution {
    /// Whether its numbers make sense.
    ///
    /// # Errors
    ///
    /// For a number that is not from −1e300 to 1e300, a range without width, a standard deviation that is not positive.
    pub fn check(&self) -> Result<(), DistributionError> {
        match *self {
            Self::Uniform { low, high } => {
                check_size("low", low)?;
                check_size("high", high)?;
                if high > low { Ok(()) } else { refuse("high", format!("above low, {low}"), high) }
            }
            Self::Normal { mean, standard_deviation } => check_normal(mean, standard_deviation),
            Self::TruncatedNormal { mean, standard_deviation, low, high } => {
                check_normal(mean, standard_deviation)?;
                let [below, above] = self.outside();
                if low < high && below + above < 1.0 {
                    Ok(())
                } else {
                    refuse("high", format!("above low, {low}, and the range near the mean"), high)
                }
            }
        }
    }

    /// The shares of a normal distribution below its range and above it.
    fn outside(&self) -> [f64; 2] {
        match *self {
            Self::TruncatedNormal { mean, standard_deviation, low, high } => [
                normal_share((low - mean) / standard_deviation),
                normal_share((mean - high) / standard_deviation),
            ],
            _ => [0.0; 2],
        }
    }

    /// The value below which a share `unit` of all values lies: the quantile of a number strictly between 0 and 1.
    ///
    /// Values of a range are within it. Of a distribution that [`Distribution::check`] refuses, or of a number that is not
    /// between 0 and 1, the value means nothing.
    pub fn at(&self, unit: f64) -> f64 {
        match *self {
            // Rounding makes the width too large by half a last digit at most, and a number below 1 takes off as much.
            Self::Uniform { low, high } => low + (high - low) * unit,
            Self::Normal { mean, standard_deviation } => mean + standard_deviation * normal_quantile(unit),
            Self::TruncatedNormal { mean, standard_deviation, low, high } => {
                let [below, above] = self.outside();
                let inside = 1.0 - below - above;
                // Counted from the side on which less is left out, where small shares have all their digits.
                let quantile = if below >= above {
                    -normal_quantile(above + inside * (1.0 - unit))
                } else {
                    normal_quantile(below + inside * unit)
                };
                (mean + standard_deviation * quantile).clamp(low, high)
            }
        }
    }
}

fn check_normal(mean: f64, standard_deviation: f64) -> Result<(), DistributionError> {
    check_size("mean", mean)?;
    check_size("standard_deviation", standard_deviation)?;
    if standard_deviation > 0.0 {
        Ok(())
    } else {
        refuse("standard_deviation", "above 0".to_owned(), standard_deviation)
    }
}

fn check_size(key: &'static str, got: f64) -> Result<(), DistributionError> {
    if got.abs() <= LARGEST {
        return Ok(());
    }
    refuse(key, format!("from -{LARGEST:e} to {LARGEST:e}"), got)
}

fn refuse(key: &'static str, allowed: String, got: f64) -> Result<(), DistributionError> {
    Err(DistributionError { key, allowed, got })
}
