//! The order of the discs: row by row of cells, so that those which meet lie near each other in memory.

use super::cells::Cells;
use super::space::Space;
use crate::geometry::Vec2;

/// The order in which to take discs of up to a diameter.
pub(super) fn row_by_row(space: Space, diameter: f64, places: &[Vec2<f64>]) -> Vec<usize> {
    let cells = Cells::new(space, diameter, places.len());
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by_cached_key(|disc| cells.number(cells.cell_of(places[*disc])));
    order
}
