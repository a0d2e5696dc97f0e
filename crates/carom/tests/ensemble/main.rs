//! Ensembles: what the rows draw, and what they are.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod again;
mod bits;
mod distributions;
mod errors;
mod independent;
mod kit;
mod latin_hypercube;
mod rejected;
mod runs;
mod sobol;
