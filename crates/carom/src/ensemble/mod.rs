//! Many runs of one scenario, with some of its numbers varied: on all cores, in a fixed order, with the bits of single runs.
//!
//! A row is a run. Its numbers depend on nothing but the row, so any part of an ensemble can be computed alone, by any number
//! of threads, and the parts together are the whole.
//!
//! ```
//! use carom::ensemble::{Design, Ensemble, Inputs, Outcome, Source};
//! # use carom::scenario::Scenario;
//! # let text = include_str!("../../../../scenarios/midterm.toml");
//!
//! let scenario = Scenario::from_toml(text)?;
//! let speeds = ("balls.red.speed".to_owned(), Source::Given(vec![4.0, 5.0, 6.0]));
//! let inputs = Inputs::new(vec![speeds], None, Design::Independent, 0)?;
//! let ensemble = Ensemble::new(&scenario, inputs, &[Outcome::FinalPosition])?;
//! let table = ensemble.run(0..3, None, &mut |_| false)?;
//! assert_eq!(ensemble.columns()[0].name, "red.x");
//! assert_eq!(table.columns[0].len(), 3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod design;
mod distribution;
mod inputs;
mod latin_hypercube;
mod normal;
mod outcome;
mod permutation;
mod run;
mod runner;
mod sobol;
mod ways;

pub use design::{Design, DesignError, Draws, MOST_ROWS};
pub use distribution::{Distribution, DistributionError};
pub use inputs::{Inputs, Source};
pub use outcome::{Column, Meaning, Outcome};
pub use run::{Ending, Ensemble, EnsembleError, Table};
pub use sobol::MOST_DIMENSIONS;
