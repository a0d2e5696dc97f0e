//! Sobol's sequence: points that fill a cube evenly, of which the first 2ᵏ hit each of 2ᵏ equal cells of every
//! dimension once.
//!
//! All points are shifted digit by digit: the bits of a coordinate are turned over where a random number of the seed
//! has a one. This keeps how evenly the points lie, makes every coordinate of every point equally likely to be anywhere,
//! and gives every seed points of its own, so that the spread over some seeds tells the error. It is the random
//! *digital shift*, not Owen's scrambling, which goes further.
//!
//! # References
//!
//! - I. M. Sobol', USSR Comput. Math. Math. Phys. 7 (1967) 86–112: the sequence.
//! - I. A. Antonov, V. M. Saleev, USSR Comput. Math. Math. Phys. 19 (1980) 252–256: its order by the Gray code.
//! - S. Joe, F. Y. Kuo, *Constructing Sobol sequences with better two-dimensional projections*, SIAM J. Sci. Comput. 30
//!   (2008) 2635–2654: the direction numbers, new-joe-kuo-6.
//! - P. L'Ecuyer, C. Lemieux, *Recent advances in randomized quasi-Monte Carlo methods*, in *Modeling Uncertainty*
//!   (2002): digital shifts.

use super::design::BITS;
use crate::random::Random;

/// Dimensions for which there are direction numbers.
pub const MOST_DIMENSIONS: usize = 32;

/// For each dimension the inner coefficients of its primitive polynomial, as bits, and its first direction numbers, of
/// which there are as many as the polynomial's degree.
///
/// These are the first lines of Joe and Kuo's table, read from scipy 1.17.1, which ships it. All numbers of the first
/// dimension are one: it has no polynomial.
const TABLE: [(u64, &[u64]); MOST_DIMENSIONS] = [
    (0, &[1; BITS as usize]),
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
    (19, &[1, 1, 1, 15, 7, 5]),
    (22, &[1, 3, 1, 15, 13, 25]),
    (25, &[1, 1, 5, 5, 19, 61]),
    (1, &[1, 3, 7, 11, 23, 15, 103]),
    (4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, &[1, 1, 3, 13, 7, 35, 63]),
    (8, &[1, 3, 5, 9, 1, 25, 53]),
    (14, &[1, 3, 1, 13, 9, 35, 107]),
    (19, &[1, 3, 1, 5, 27, 61, 31]),
    (21, &[1, 1, 5, 11, 19, 41, 61]),
    (28, &[1, 3, 5, 3, 3, 13, 69]),
    (31, &[1, 1, 7, 13, 1, 19, 1]),
    (32, &[1, 3, 7, 5, 13, 19, 59]),
    (37, &[1, 1, 3, 9, 25, 29, 41]),
    (41, &[1, 3, 5, 13, 23, 1, 55]),
    (42, &[1, 3, 7, 3, 13, 59, 17]),
];

/// One dimension, as binary fractions of [`BITS`] bits.
#[derive(Clone, Debug)]
pub(super) struct Sobol {
    directions: [u64; BITS as usize],
    shift: u64,
}

impl Sobol {
    /// The dimensions of those names, in their order; no more than there are direction numbers for.
    pub(super) fn all(seed: u64, names: &[&str]) -> Vec<Self> {
        let dimension = |((coefficients, first), name): (&(u64, &[u64]), &&str)| Self {
            directions: directions(*coefficients, first),
            shift: Random::new(seed, &format!("sobol.{name}")).bits() >> (u64::BITS - BITS),
        };
        TABLE.iter().zip(names).map(dimension).collect()
    }

    /// The coordinate of point `row`, below 2⁵²: the directions of the ones of its Gray code, added without carry.
    pub(super) fn bits(&self, row: u64) -> u64 {
        let mut gray = row ^ (row >> 1);
        let mut sum = self.shift;
        while gray != 0 {
            sum ^= self.directions[gray.trailing_zeros() as usize];
            gray &= gray - 1;
        }
        sum
    }
}

/// Sobol's recurrence: each direction from as many before it as the polynomial has degrees.
fn directions(coefficients: u64, first: &[u64]) -> [u64; BITS as usize] {
    let degree = first.len();
    let mut directions = [0; BITS as usize];
    for index in 0..directions.len() {
        directions[index] = if index < degree {
            first[index] << (BITS as usize - 1 - index)
        } else {
            let oldest = directions[index - degree];
            let term =
                |power: usize| ((coefficients >> (degree - 1 - power)) & 1) * directions[index - power];
            (1..degree).map(term).fold(oldest ^ (oldest >> degree), |sum, term| sum ^ term)
        };
    }
    directions
}
