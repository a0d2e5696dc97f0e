//! Latin hypercubes: each of as many equal cells as there are rows is hit once, in every dimension.
//!
//! # References
//!
//! M. D. McKay, R. J. Beckman, W. J. Conover, *A comparison of three methods for selecting values of input variables in
//! the analysis of output from a computer code*, Technometrics 21 (1979) 239–245.

use super::permutation::Permutation;
use crate::random::Random;

/// One dimension.
#[derive(Clone, Debug)]
pub(super) struct LatinHypercube {
    cells: Permutation,
    places: Random,
    /// Bits of a place within its cell: with those of the cell they fill a double's mantissa.
    place_bits: u32,
    /// How many places all cells have together.
    size: f64,
}

impl LatinHypercube {
    /// The dimension of that name, of a design of from 1 to 2⁵² rows.
    pub(super) fn new(seed: u64, rows: u64, name: &str) -> Self {
        let cell_bits = u64::BITS - (rows - 1).leading_zeros();
        let place_bits = f64::MANTISSA_DIGITS - cell_bits;
        Self {
            cells: Permutation::new(Random::new(seed, &format!("latin_hypercube.{name}")), rows),
            places: Random::new(seed, &format!("ensemble.{name}")),
            place_bits,
            size: (rows << place_bits) as f64,
        }
    }

    /// A number strictly inside the cell of a row.
    pub(super) fn unit(&self, row: u64) -> f64 {
        let cell = self.cells.at(row) << self.place_bits;
        // An odd place is not on the edge; the quotient is rounded by half a place at most, so it is not there either.
        let place = (self.places.bits_at(row) >> (u64::BITS - self.place_bits)) | 1;
        (cell | place) as f64 / self.size
    }
}
