//! What is measured of a gas, against closed forms.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod block_errors;
mod checkpoints;
mod crystals;
mod fluids;
mod gases;
mod golden_checkpoint;
mod kit;
mod motion;
mod observed_runs;
mod pressures;
mod requests;
mod resumption;
mod same_bits;
mod structure;
mod transport;
mod velocities;
mod with_the_engine;
