//! What a contact does: one law per file.
//!
//! A law is a pure function of the contact; it knows neither how the contact was found nor who else is on the table.

pub mod ball_ball;
pub mod ball_cushion;
pub mod cluster;

use crate::scalar::Scalar;

/// The restitution of a contact that closes at `speed` and is to part with `kept` at least, or with as much as it closes
/// with; none less than its own.
#[inline(always)]
pub fn restitution_keeping<S: Scalar>(restitution: S, kept: S, speed: S) -> S {
    if kept == S::ZERO || restitution * speed >= kept {
        restitution
    } else if speed > kept {
        kept / speed
    } else {
        S::ONE
    }
}
