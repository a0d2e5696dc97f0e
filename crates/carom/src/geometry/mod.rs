//! Vectors, line segments and circular arcs in the plane.

mod bounds;
mod joint;
mod piece;
mod vector;

pub use bounds::Bounds;
pub use joint::turn;
pub use piece::{Arc, Piece, Segment};
pub use vector::Vec2;
