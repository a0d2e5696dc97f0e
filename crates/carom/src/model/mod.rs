//! What exists: discs, spheres, the table with its pockets, and the faces of its cushions.

mod disc;
mod face;
mod hole;
mod pocket;
mod pocket_table;
mod sphere;
mod table;
mod tolerance;

pub use disc::Disc;
pub use face::{Face, Faces, Line, Room, Round};
pub use hole::Hole;
pub use pocket::{Nose, NoseContact, Pocket};
pub use pocket_table::{Mouth, PocketTable};
pub use sphere::{Sphere, Twist};
pub use table::{Corner, Cushion, JOINT_TOLERANCE, Outline, OutlineKind, Table, circle, rectangle};
pub use tolerance::{ContactTolerance, closing_threshold};
