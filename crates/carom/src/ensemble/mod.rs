//! Many runs of one scenario with some of its numbers varied.
//!
//! What a row draws is a function of the seed, of the varied path's name and of the row's number alone, so that any
//! rows can be drawn by themselves, on any machine, with the same bits.
//!
//! ```
//! use carom::ensemble::{Design, Distribution, Draws};
//!
//! let speed = Distribution::Normal { mean: 2.0, standard_deviation: 0.1 };
//! speed.check()?;
//! let draws = Draws::new(Design::Independent, 7, 1000, &["balls.red.speed"])?;
//! let value = speed.at(draws.unit(999, 0));
//! assert!((value - 2.0).abs() < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod design;
mod distribution;
mod latin_hypercube;
mod normal;
mod permutation;
mod sobol;

pub use design::{Design, DesignError, Draws, MOST_ROWS};
pub use distribution::{Distribution, DistributionError};
pub use sobol::MOST_DIMENSIONS;
