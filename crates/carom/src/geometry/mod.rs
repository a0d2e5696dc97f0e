//! Vectors, line segments and circular arcs in the plane; vectors in space.

mod bounds;
mod clearance;
mod distance;
mod joint;
mod meeting;
mod outline;
mod piece;
mod vec3;
mod vector;

pub use bounds::Bounds;
pub use clearance::clearance;
pub use distance::{Foot, FootAt};
pub use joint::turn;
pub use meeting::{Meeting, MeetingKind, meetings};
pub use outline::{signed_area, signed_distance};
pub use piece::{Arc, Piece, Segment};
pub use vec3::Vec3;
pub use vector::{Vec2, Vector};
