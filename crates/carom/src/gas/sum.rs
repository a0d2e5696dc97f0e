//! Sums of many numbers, in their order and in double-double: right to the last bit or so, however many there are.

use crate::scalar::{DoubleDouble, Scalar};

/// The sum of some numbers.
pub(super) fn sum(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(DoubleDouble::ZERO, |sum, number| sum + DoubleDouble::from_f64(number)).to_f64()
}
