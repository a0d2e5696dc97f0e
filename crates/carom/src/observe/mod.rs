//! What is measured of a gas of discs while it runs: sums only, never the run.
//!
//! [`Observables`] are made from names and options, told of the run's events, and shown a [`Snapshot`] at equal
//! intervals. What they find are numbers and curves with errors ([`Results`]). Formulas are those of equal masses and
//! diameters, kT in the run's own units of energy; where discs differ, each observable says what it does.
//!
//! | name | what it is | options |
//! |---|---|---|
//! | `pressure` | kT, Z and pressure from collisions, and from walls | |
//! | `collision_rate` | collisions per time, and the Z that goes with it | |
//! | `free_path` | mean free time and path, distribution of free times | |
//! | `speeds` | distribution and moments of speeds, beside Maxwell's | `bins`, `largest` |
//! | `h_function` | Boltzmann's H over time | `ring`, `points` |
//! | `temperature_profile` | kT and density along an axis | `axis`, `bins` |
//! | `radial_distribution` | g(r), and its value at contact | `range`, `bin_width` |
//! | `diffusion` | mean square displacement, velocity autocorrelation, D | `longest`, `lags`, `origins` |
//! | `psi6` | order of directions to neighbours | |
//! | `kinetic_energy` | energy over time, beside Haff's law | `points`, `restitution` |
//!
//! Another observable is a file that implements `Measure`, a variant and a name in `observable.rs`, and a line here.
//! What is summed at events is in `events.rs` alone, and is handed on at samples.

mod bins;
mod blocks;
mod collision_rate;
mod diffusion;
mod error;
mod events;
mod free_path;
mod grid;
mod h_function;
mod kinetic_energy;
mod observable;
mod pair_counts;
mod pressure;
mod psi6;
mod radial_distribution;
mod request;
mod results;
mod series;
mod set;
mod snapshot;
mod speeds;
mod state_equation;
mod temperature_profile;
mod voronoi;

pub use blocks::Blocks;
pub use error::ObserveError;
pub use observable::NAMES;
pub use request::Request;
pub use results::{Column, Curve, Quantity, Results};
pub use set::Observables;
pub use snapshot::Snapshot;
pub use state_equation::compressibility;
