//! How the rows of an ensemble are laid out over the cube of what they vary.

use super::latin_hypercube::LatinHypercube;
use super::sobol::{MOST_DIMENSIONS, Sobol};
use crate::random::Random;
use thiserror::Error;

/// Bits of a drawn number: of 2⁵² equal cells between 0 and 1 the middles are doubles.
pub(super) const BITS: u32 = f64::MANTISSA_DIGITS - 1;

/// The largest number of rows.
pub const MOST_ROWS: u64 = 1 << BITS;

/// How rows are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Design {
    /// Every number is drawn by itself.
    ///
    /// More rows keep those that were there, and another varied path keeps the numbers of the others.
    Independent,
    /// Of as many equal cells as there are rows each is hit once, in every dimension.
    ///
    /// Another varied path keeps the numbers of the others; another number of rows is another design.
    LatinHypercube,
    /// Sobol's sequence, shifted digit by digit by the seed. Numbers of rows that are powers of two are best.
    ///
    /// More rows keep those that were there, and a varied path added after the others keeps their numbers.
    Sobol,
}

impl Design {
    /// Every design.
    pub const ALL: [Self; 3] = [Self::Independent, Self::LatinHypercube, Self::Sobol];

    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::Independent => "independent",
            Self::LatinHypercube => "latin_hypercube",
            Self::Sobol => "sobol",
        }
    }

    /// The design of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|design| design.name() == name)
    }
}

/// Why rows cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DesignError {
    /// A number of rows outside its range.
    #[error("rows: must be from 1 to {MOST_ROWS}, got {got}")]
    Rows {
        /// What it is.
        got: u64,
    },
    /// More varied paths than Sobol's sequence has dimensions here.
    #[error(
        "sobol: must vary {MOST_DIMENSIONS} paths at most, got {got}; \"latin_hypercube\" and \"independent\" have no limit"
    )]
    Dimensions {
        /// How many.
        got: usize,
    },
    /// A path that is named twice: its numbers would be the same in both places.
    #[error("{name}: is varied twice")]
    Repeated {
        /// Its name.
        name: String,
    },
}

/// The numbers that rows draw: for each row and each varied path one strictly between 0 and 1.
///
/// Each is a function of design, seed, number of rows, name of the path and row alone, in Sobol's sequence also of the
/// path's place among the names. No number depends on which were drawn before.
#[derive(Clone, Debug)]
pub struct Draws {
    rows: u64,
    dimensions: Dimensions,
}

#[derive(Clone, Debug)]
enum Dimensions {
    Independent(Vec<Random>),
    LatinHypercube(Vec<LatinHypercube>),
    Sobol(Vec<Sobol>),
}

impl Draws {
    /// The numbers of so many rows that vary the paths of those names.
    ///
    /// # Errors
    ///
    /// For no row or more than [`MOST_ROWS`], for a name that occurs twice, and for more names than Sobol's sequence has
    /// dimensions.
    pub fn new(design: Design, seed: u64, rows: u64, names: &[&str]) -> Result<Self, DesignError> {
        check(design, rows, names)?;
        let dimensions = match design {
            Design::Independent => Dimensions::Independent(
                names.iter().map(|name| Random::new(seed, &format!("ensemble.{name}"))).collect(),
            ),
            Design::LatinHypercube => Dimensions::LatinHypercube(
                names.iter().map(|name| LatinHypercube::new(seed, rows, name)).collect(),
            ),
            Design::Sobol => Dimensions::Sobol(Sobol::all(seed, names)),
        };
        Ok(Self { rows, dimensions })
    }

    /// The number of a row, from 0, for the varied path at place `dimension` of the names, from 0: strictly between 0 and
    /// 1. Not a number for a row or a dimension that there is not.
    pub fn unit(&self, row: u64, dimension: usize) -> f64 {
        if row >= self.rows {
            return f64::NAN;
        }
        let unit = match &self.dimensions {
            Dimensions::Independent(streams) => {
                streams.get(dimension).map(|stream| middle(stream.bits_at(row) >> (u64::BITS - BITS)))
            }
            Dimensions::LatinHypercube(cubes) => cubes.get(dimension).map(|cube| cube.unit(row)),
            Dimensions::Sobol(sequences) => {
                sequences.get(dimension).map(|sequence| middle(sequence.bits(row)))
            }
        };
        unit.unwrap_or(f64::NAN)
    }
}

/// The middle of one of 2⁵² equal cells between 0 and 1, exactly.
fn middle(cell: u64) -> f64 {
    (2 * cell + 1) as f64 / (2 * MOST_ROWS) as f64
}

fn check(design: Design, rows: u64, names: &[&str]) -> Result<(), DesignError> {
    if !(1..=MOST_ROWS).contains(&rows) {
        return Err(DesignError::Rows { got: rows });
    }
    if design == Design::Sobol && names.len() > MOST_DIMENSIONS {
        return Err(DesignError::Dimensions { got: names.len() });
    }
    let mut sorted = names.to_vec();
    sorted.sort_unstable();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(DesignError::Repeated { name: pair[0].to_owned() }),
        None => Ok(()),
    }
}
