//! What exists on a table: discs, cushions, and the ready-made shapes of tables.

mod cushion;
mod disc;
mod tolerance;

pub use cushion::{Cushion, Line, Round};
pub use disc::Disc;
pub use tolerance::{ContactTolerance, closing_threshold};
