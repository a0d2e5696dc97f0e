//! How balls move on a table: exact, fast, and the same everywhere.

pub mod geometry;
pub mod roots;
pub mod scalar;
