//! When two things count as in contact, and when a contact counts as closing.
//!
//! Neither is an absolute number: lengths scale with the balls and the table, speeds with the balls' own.

use super::table::Table;
use crate::geometry::Vec2;
use crate::scalar::Scalar;

/// The contact tolerance δ = 1e-10 (r_a + r_b) + 1e-13 × table size; for a table that lies further from the origin than it
/// is large, that distance counts in place of its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTolerance<S> {
    of_table: S,
    table_size: S,
}

impl<S: Scalar> ContactTolerance<S> {
    /// The tolerance on a table.
    pub fn new(table: &Table<S>) -> Self {
        Self { of_table: table.reach() * S::from_f64(1e-13), table_size: table.size() }
    }

    /// The longer side of the table.
    pub fn table_size(&self) -> S {
        self.table_size
    }

    /// The tolerance δ of a contact where the radii add up to `radii`.
    #[inline(always)]
    pub fn of(&self, radii: S) -> S {
        radii * S::from_f64(1e-10) + self.of_table
    }
}

/// The closing speed below which a contact is not told from standing still: sixteen round-offs of the velocities that
/// it is the difference of.
#[inline(always)]
pub fn closing_threshold<S: Scalar>(a: Vec2<S>, b: Vec2<S>) -> S {
    (a.x.abs() + a.y.abs() + b.x.abs() + b.y.abs()) * S::from_f64(16.0 * S::EPSILON)
}
