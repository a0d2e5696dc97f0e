//! Who is near: the centres sorted into cells, so that neighbours of all discs cost O(N).

use super::snapshot::Snapshot;
use core::ops::Range;

/// There are no more cells than so many times the discs: fine cells in an empty box help nobody.
const CELLS_PER_DISC: f64 = 4.0;

/// Centres by cells.
pub(super) struct Grid {
    size: [f64; 2],
    periods: [bool; 2],
    /// Cells along each axis.
    cells: [usize; 2],
    /// Where the discs of each cell begin in `discs`, row by row; one more than there are cells.
    starts: Vec<u32>,
    /// The discs, cell by cell: number and centre, which is wrapped along periodic axes.
    discs: Vec<(u32, [f64; 2])>,
}

impl Grid {
    /// The centres of a snapshot in cells that are `side` long or somewhat longer.
    pub fn new(snapshot: &Snapshot, side: f64) -> Self {
        let [width, length] = snapshot.size;
        let most = CELLS_PER_DISC * snapshot.positions.len() as f64;
        let finest = (width * length / most).sqrt();
        let side = if side > finest { side } else { finest };
        let along = |size: f64| ((size / side) as usize).max(1);
        let cells = [along(width), along(length)];
        let mut grid = Self {
            size: snapshot.size,
            periods: snapshot.periods,
            cells,
            starts: Vec::new(),
            discs: Vec::new(),
        };
        grid.sort(snapshot);
        grid
    }

    /// Sorts by counting: discs of a cell stay in the order of their numbers.
    fn sort(&mut self, snapshot: &Snapshot) {
        let places: Vec<[f64; 2]> =
            snapshot.positions.iter().map(|position| self.wrapped(position.to_f64())).collect();
        let cells: Vec<usize> = places.iter().map(|place| self.cell(*place)).collect();
        let mut next = vec![0u32; self.cells[0] * self.cells[1] + 1];
        for cell in &cells {
            next[cell + 1] += 1;
        }
        for cell in 1..next.len() {
            next[cell] += next[cell - 1];
        }
        self.starts = next.clone();
        self.discs = vec![(0, [0.0; 2]); places.len()];
        for (disc, (cell, place)) in cells.into_iter().zip(places).enumerate() {
            self.discs[next[cell] as usize] = (disc as u32, place);
            next[cell] += 1;
        }
    }

    fn wrapped(&self, position: [f64; 2]) -> [f64; 2] {
        let wrap = |axis: usize| {
            let turns = if self.periods[axis] { (position[axis] / self.size[axis]).floor() } else { 0.0 };
            position[axis] - turns * self.size[axis]
        };
        [wrap(0), wrap(1)]
    }

    fn cell(&self, place: [f64; 2]) -> usize {
        // A negative number becomes zero, as a place a hair outside the box may have one.
        let along = |axis: usize| {
            let cell = (place[axis] / self.size[axis] * self.cells[axis] as f64) as usize;
            cell.min(self.cells[axis] - 1)
        };
        along(1) * self.cells[0] + along(0)
    }

    /// The discs, cell by cell: number and centre, wrapped.
    pub fn discs(&self) -> &[(u32, [f64; 2])] {
        &self.discs
    }

    /// Visits all discs that may be within reach of a place, and some beyond, each periodic image on its own: the
    /// number, and the way from the place to the centre. A disc at the place itself is visited too.
    #[inline]
    pub fn near(&self, place: [f64; 2], reach: f64, mut visit: impl FnMut(u32, [f64; 2])) {
        let [columns, rows] = [0, 1].map(|axis| self.cells_within(axis, place[axis], reach));
        for row in rows.0..=rows.1 {
            let (row, up) = self.image(1, row);
            for column in columns.0..=columns.1 {
                let (column, across) = self.image(0, column);
                let cell = row * self.cells[0] + column;
                for (disc, other) in &self.discs[self.starts[cell] as usize..self.starts[cell + 1] as usize] {
                    visit(*disc, [other[0] + across - place[0], other[1] + up - place[1]]);
                }
            }
        }
    }

    /// Visits each pair of discs within reach of each other once, and some that are further apart, each periodic image on
    /// its own: one of two, with a stretch of others by their places in [`Grid::discs`], and where it is as they see it.
    #[inline]
    pub fn pairs(&self, reach: f64, mut visit: impl FnMut(usize, Range<usize>, [f64; 2])) {
        let height = self.size[1] / self.cells[1] as f64;
        let end = self.cells[0] as i64 - 1;
        for first in 0..self.discs.len() {
            let place = self.discs[first].1;
            let row = (self.cell(place) / self.cells[0]) as i64;
            let mut meet = |others: Range<usize>, [across, up]: [f64; 2]| {
                visit(first, others, [place[0] - across, place[1] - up]);
            };
            // Of two in a row it is the turn of the one that comes first, and of those beyond the side of the last.
            let last = self.cells_within(0, place[0], reach).1;
            meet(first + 1..self.range(row, (0, last.min(end))).end, [0.0; 2]);
            self.along(row, (end + 1, last), &mut meet);
            // Of two rows it is the turn of the lower one, for what is within the circle.
            for row in row + 1..=self.cells_within(1, place[1], reach).1 {
                let up = row as f64 * height - place[1];
                let square = reach * reach - up * up;
                if square > 0.0 {
                    self.along(row, self.cells_within(0, place[0], square.sqrt()), &mut meet);
                }
            }
        }
    }

    /// The discs in some cells of a row, in pieces that each have a shift, as the cells may go on beyond a periodic side.
    #[inline]
    fn along(&self, row: i64, (mut first, last): (i64, i64), meet: &mut impl FnMut(Range<usize>, [f64; 2])) {
        let (row, up) = self.image(1, row);
        while first <= last {
            let (column, across) = self.image(0, first);
            let count = (last - first).min(self.cells[0] as i64 - 1 - column as i64);
            meet(self.range(row as i64, (column as i64, column as i64 + count)), [across, up]);
            first += count + 1;
        }
    }

    /// The discs in some cells of a row in the box.
    fn range(&self, row: i64, (first, last): (i64, i64)) -> Range<usize> {
        let start = row as usize * self.cells[0];
        self.starts[start + first as usize] as usize..self.starts[start + last as usize + 1] as usize
    }

    /// The first and the last cell along an axis within reach of a place; beyond a periodic side they go on.
    fn cells_within(&self, axis: usize, place: f64, reach: f64) -> (i64, i64) {
        let per_length = self.cells[axis] as f64 / self.size[axis];
        let cell = |place: f64| floor(place * per_length);
        let (first, last) = (cell(place - reach), cell(place + reach));
        let end = self.cells[axis] as i64 - 1;
        if self.periods[axis] { (first, last) } else { (first.clamp(0, end), last.clamp(0, end)) }
    }

    /// The cell in the box of which this is an image, and how far it is shifted.
    fn image(&self, axis: usize, cell: i64) -> (usize, f64) {
        let cells = self.cells[axis] as i64;
        (cell.rem_euclid(cells) as usize, cell.div_euclid(cells) as f64 * self.size[axis])
    }
}

/// The largest whole number that is no larger, quicker than by a call of the platform's function.
#[inline]
fn floor(number: f64) -> i64 {
    let whole = number as i64;
    whole - i64::from(whole as f64 > number)
}
