//! Starts of gases of hard discs.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]

mod bits;
mod errors;
mod kit;
mod large;
mod lattices;
mod places;
mod sizes;
mod velocities;
