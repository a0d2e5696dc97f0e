//! Laws of the contact between two balls.

mod restitution;

pub use restitution::{Pair, Restitution};
