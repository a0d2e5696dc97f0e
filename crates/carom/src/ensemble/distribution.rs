//! How a varied number is distributed.

use super::normal::normal_quantile;
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
            Self::Normal { mean, standard_deviation } => {
                check_size("mean", mean)?;
                check_size("standard_deviation", standard_deviation)?;
                if standard_deviation > 0.0 {
                    Ok(())
                } else {
                    refuse("standard_deviation", "above 0".to_owned(), standard_deviation)
                }
            }
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
        }
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
