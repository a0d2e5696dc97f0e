//! Laws of the strike of a cue at a ball: one in each file.

mod point_contact;

pub use point_contact::{CueImpact, PointContact, REFERENCES, Strike};
