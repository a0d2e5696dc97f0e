//! The event loop: predict, schedule, advance, resolve, repeat.

mod audit;
mod cluster;
mod discs;
mod hold;
mod queue;
mod simulation;

pub use discs::{Discs, Pending, Target};
pub use simulation::{Coming, Limits, Simulation};
