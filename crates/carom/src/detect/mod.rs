//! When gaps close.
//!
//! Every function here is a pure function of the flights it is given, so an event's time does not depend on when it was
//! asked for. Times come as offsets from the later start of the flights involved, unrounded by the absolute time.

mod ball_ball;
mod ball_cushion;
mod sphere;

pub use ball_ball::{Relative, detect_ball_ball, detect_ball_in_the_clear, squared_tolerance};
pub use ball_cushion::{
    cushion_gap, detect_ball_cushion, detect_cushion_in_the_clear, detect_from_behind, detect_release,
};
pub use sphere::{
    Crossing, detect_nose, detect_nose_in_the_air, detect_pocket, detect_pocket_from_above, detect_spheres,
};

use crate::scalar::Scalar;

/// What a prediction saw on its way: things in touch with the ball, and the deepest overlap.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<S> {
    /// Whether something else than what it has just been in contact with was within the contact tolerance.
    pub touching: bool,
    /// Whether an overlap was deeper than the contact tolerance: an invariant of the run is broken.
    pub broken: bool,
    /// The deepest overlap, zero or positive.
    pub overlap: S,
}

impl<S: Scalar> Surroundings<S> {
    /// Nothing seen yet.
    pub const CLEAR: Self = Self { touching: false, broken: false, overlap: S::ZERO };
}
