//! Certified closing crossings of gaps.
//!
//! An event is not any root of a gap but a *closing crossing*: the gap has been positive and goes through zero with a
//! negative slope. Roots are bracketed on the roots of derivatives and refined inside monotone pieces; a sign counts
//! only beyond its rounding bound; no complex number, no transcendental function and no absolute tolerance occurs.
//!
//! | here | what |
//! |---|---|
//! | [`Polynomial`] | a gap of degree at most four: value, slope, rounding bound, Bernstein coefficients |
//! | [`Quadratic`] | a gap of degree at most two, solved in closed form |
//! | [`first_contact`] | the first contact from a start in front, in contact, or behind |
//! | [`first_turn`] | when a gap first begins to close |
//! | [`closing_crossings`] | all closing crossings in order, found as they are asked for |
//! | [`Gap`], [`first_closing_crossing`] | the same for any smooth function with enclosures |
//!
//! In every scalar the answer ends with an operation that carries derivatives, so dual numbers get the exact derivative
//! of the event's time, and their real part is that of `f64` bit for bit.

mod closing;
mod contact;
mod gap;
mod newton;
mod polynomial;
mod quadratic;
mod scale;
mod sweep;

pub use closing::{ClosingCrossings, closing_crossings};
pub use contact::{first_contact, first_turn};
pub use gap::{Enclosure, Gap, Interval, first_closing_crossing};
pub use polynomial::Polynomial;
pub use quadratic::Quadratic;
