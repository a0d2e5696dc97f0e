//! What the engine computes: one binary for all of it, since each binary compiles the generic engine anew.

#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout
)]

mod ball_ball_with_spin;
mod closed_forms;
mod cloth_air;
mod cloth_clusters;
mod cloth_continuation;
mod cloth_events;
mod cloth_hollow;
mod cloth_invariants;
mod cloth_motion;
mod cloth_overlaps;
mod cloth_pressed;
mod cloth_rest;
mod cloth_shots;
mod clusters;
mod conservation;
mod continuation;
mod corners;
mod cue_strike;
mod cushions_with_spin;
mod double_double;
mod dual;
mod extremes;
mod fast_path;
mod film;
mod final_scenario;
mod grid;
mod heaps;
mod hertz;
mod hertz_invariants;
mod kit;
mod laws;
mod laws_with_spin;
mod leaks;
mod midterm;
mod periodic;
mod pockets;
mod references;
mod resting;
mod run_files;
mod soak;
mod stepped;
mod symmetry;
mod tampered_runs;
mod termination;
mod through_the_air;
mod without_friction;
