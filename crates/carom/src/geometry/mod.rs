//! Vectors, line segments and circular arcs in the plane.

mod piece;
mod vector;

pub use piece::{Arc, Piece, Segment};
pub use vector::Vec2;
