//! The end of a collapse: contacts that follow each other too fast lose nothing.
//!
//! Source: the TC model of Luding and McNamara (1998): less than a time t_c after a ball's last contact, e = 1. *Departs
//! from source*: in a field a ball parts with a hop of about t_c at least.

use super::Reference;
use crate::scalar::Scalar;

/// The sources of the model.
pub const REFERENCES: &[Reference] = &[Reference {
    law: "collapse.tc",
    text: "S. Luding, S. McNamara, How to handle the inelastic collapse of a dissipative hard-sphere gas with the TC model, Granular Matter 1 (1998) 113–128",
    doi: Some("10.1007/s100350050017"),
}];

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
