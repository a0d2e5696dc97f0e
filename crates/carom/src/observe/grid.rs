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
    /// Where the discs of each cell begin, row by row; one more than there are cells.
    starts: Vec<u32>,
    /// The numbers of the discs, cell by cell.
    discs: Vec<u32>,
    /// Their centres, wrapped along periodic axes: x and y apart, so that several are taken at once.
    places: [Vec<f64>; 2],
}

/// The discs of a cell, and all others that may be within reach of them.
#[derive(Default)]
pub(super) struct Crowd {
    /// The middle of the cell.
    pub middle: [f64; 2],
    /// How many discs are of the cell.
    pub own: usize,
    /// First those, then the others: stretches of [`Grid::places`], and how far each is shifted, as the cells may be
    /// beyond a periodic side.
    pub stretches: Vec<(Range<usize>, [f64; 2])>,
}

impl Grid {
    /// The centres of a snapshot in cells that are `side` long or somewhat longer.
    pub fn new(snapshot: &Snapshot, side: f64) -> Self {
        let [width, length] = snapshot.size;
        let most = CELLS_PER_DISC * snapshot.positions.len() as f64;
        let finest = (width * length / most).sqrt();
        let side = if side > finest { side } else { finest };
        let along = |size: f64| ((size / side) as usize).max(1);
        let mut grid = Self {
            size: snapshot.size,
            periods: snapshot.periods,
            cells: [along(width), along(length)],
            starts: Vec::new(),
            discs: Vec::new(),
            places: [Vec::new(), Vec::new()],
        };
        grid.sort(snapshot);
        grid
    }

    /// Sorts by counting: discs of a cell stay in the order of their numbers.
    fn sort(&mut self, snapshot: &Snapshot) {
        let per_size = self.size.map(|size| 1.0 / size);
        let per_side = self.sides().map(|side| 1.0 / side);
        let wrapped = |position: [f64; 2], axis: usize| {
            let turns = if self.periods[axis] { floor(position[axis] * per_size[axis]) } else { 0 };
            position[axis] - turns as f64 * self.size[axis]
        };
        // A negative number becomes zero, as a place a hair outside the box may have one.
        let along = |place: f64, axis: usize| ((place * per_side[axis]) as usize).min(self.cells[axis] - 1);
        let mut next = vec![0u32; self.cells[0] * self.cells[1] + 1];
        let sorted = snapshot.positions.iter().map(|position| {
            let position = position.to_f64();
            let place = [wrapped(position, 0), wrapped(position, 1)];
            let cell = along(place[1], 1) * self.cells[0] + along(place[0], 0);
            next[cell + 1] += 1;
            (cell as u32, place)
        });
        let sorted: Vec<(u32, [f64; 2])> = sorted.collect();
        for cell in 1..next.len() {
            next[cell] += next[cell - 1];
        }
        self.starts = next.clone();
        self.discs = vec![0; sorted.len()];
        self.places = [0, 1].map(|_| vec![0.0; sorted.len()]);
        for (disc, (cell, [x, y])) in (0..).zip(sorted) {
            let next = &mut next[cell as usize];
            let at = *next as usize;
            (self.discs[at], self.places[0][at], self.places[1][at]) = (disc, x, y);
            *next += 1;
        }
    }

    /// The sides of a cell.
    pub fn sides(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] / self.cells[axis] as f64)
    }

    /// The centres, cell by cell, wrapped: x and y.
    pub fn places(&self) -> &[Vec<f64>; 2] {
        &self.places
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
                for disc in self.range(row, column..column + 1) {
                    let [x, y] = [0, 1].map(|axis| self.places[axis][disc]);
                    visit(self.discs[disc], [x + across - place[0], y + up - place[1]]);
                }
            }
        }
    }

    /// Visits each cell that has discs, with the others among whom their pairs are found: each pair within reach comes
    /// once, a disc of the cell and one behind it, beside pairs that are further apart. The reach is half a periodic side
    /// at most.
    pub fn crowds(&self, reach: f64, mut visit: impl FnMut(&Crowd)) {
        let (sides, columns_within) = (self.sides(), self.columns_within(reach));
        let mut crowd = Crowd::default();
        for row in 0..self.cells[1] {
            for column in 0..self.cells[0] {
                crowd.own = self.range(row, column..column + 1).len();
                if crowd.own == 0 {
                    continue;
                }
                crowd.middle = [(column as f64 + 0.5) * sides[0], (row as f64 + 0.5) * sides[1]];
                crowd.stretches.clear();
                // Of two cells in a row it is the turn of the left one, of two rows of the lower one.
                for (up, within) in columns_within.iter().enumerate() {
                    let before = if up == 0 { 0 } else { *within };
                    let columns = (column as i64 - before, column as i64 + within);
                    self.along(row + up, columns, &mut crowd.stretches);
                }
                visit(&crowd);
            }
        }
    }

    /// How many columns to each side have discs within reach of a cell's: in its own row, in that above, and so on.
    fn columns_within(&self, reach: f64) -> Vec<i64> {
        let [width, height] = self.sides();
        // A hair further, as a place at the side of a cell may be rounded into the next.
        let square = reach * reach * (1.0 + 1e-9);
        let gap = |row: usize| row.saturating_sub(1) as f64 * height;
        let chords = (0..).map(|row| square - gap(row) * gap(row)).take_while(|square| *square > 0.0);
        chords.map(|square| (square.sqrt() / width) as i64 + 1).collect()
    }

    /// The discs in some cells of a row, in stretches: in the box, and beyond its periodic sides.
    #[inline]
    fn along(
        &self,
        row: usize,
        (mut first, last): (i64, i64),
        stretches: &mut Vec<(Range<usize>, [f64; 2])>,
    ) {
        let [columns, rows] = self.cells;
        if row >= rows && !self.periods[1] {
            return;
        }
        let (row, up) = if row >= rows { (row - rows, self.size[1]) } else { (row, 0.0) };
        let end = columns as i64 - 1;
        while first <= last {
            let turn = i64::from(first > end) - i64::from(first < 0);
            let start = turn * columns as i64;
            let to = last.min(start + end);
            if turn == 0 || self.periods[0] {
                let discs = self.range(row, (first - start) as usize..(to - start + 1) as usize);
                stretches.push((discs, [turn as f64 * self.size[0], up]));
            }
            first = to + 1;
        }
    }

    /// The discs in some cells of a row in the box.
    #[inline]
    fn range(&self, row: usize, columns: Range<usize>) -> Range<usize> {
        let start = row * self.cells[0];
        self.starts[start + columns.start] as usize..self.starts[start + columns.end] as usize
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
