//! How balls move on a table: exact, fast, and the same everywhere.

pub mod aim;
pub mod detect;
pub mod engine;
pub mod ensemble;
pub mod flight;
pub mod gas;
pub mod geometry;
pub mod law;
mod memory;
pub mod model;
pub mod observe;
pub mod random;
pub mod roots;
pub mod run;
pub mod scalar;
pub mod scenario;
pub mod simulate;
pub mod stepped;
