//! The event loop: predict, schedule, advance, resolve, repeat.

mod audit;
mod ball;
mod bins;
mod calendar;
mod cluster;
mod discs;
mod four;
mod grid;
mod hold;
mod interface;
mod many;
mod predict;
mod queue;
mod simd;
mod simulation;
mod spheres;
mod strike;
mod throw;

pub use discs::Discs;
pub use interface::{Engine, Fault};
pub use queue::{Pending, Target};
pub use simulation::{Coming, Limits, Simulation};
pub use spheres::Spheres;
