//! What a contact does: one law per file.
//!
//! A law is a pure function of the contact; it knows neither how the contact was found nor who else is on the table.

pub mod ball_ball;
pub mod ball_cushion;
pub mod cluster;
