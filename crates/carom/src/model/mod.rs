//! What exists: the table and its cushions.

mod table;

pub use table::{Corner, Cushion, JOINT_TOLERANCE, Outline, OutlineKind, Table, circle, rectangle};
