//! What a contact does: one law per file.
//!
//! A law is a pure function of the contact; it knows neither how the contact was found nor who else is on the table. Its
//! file says where it comes from, as data that a run can tell.

pub mod ball_ball;
pub mod ball_cushion;
pub mod cloth;
pub mod cluster;
pub mod coefficient;
pub mod collapse;
pub mod cue_ball;
mod gradual;
mod reference;
mod sphere_plane;

pub use reference::Reference;
