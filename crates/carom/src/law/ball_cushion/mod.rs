//! Laws of the contact between a ball and a cushion.

mod restitution;

pub use restitution::{Rebound, Restitution};
