//! The box in cells, each with the discs whose centres are in it: who is near.

use super::space::Space;
use crate::geometry::Vec2;

/// Nobody: the end of a cell's list.
const NOBODY: u32 = u32::MAX;

/// A cell and its neighbours along an axis, itself first: most of what is near is there.
const STEPS: [i32; 3] = [0, -1, 1];

/// Column and row of a cell.
pub(super) type Cell = [u32; 2];

/// The cells, and who is in them.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    space: Space,
    /// Columns and rows.
    count: [u32; 2],
    /// Width and length of a cell.
    size: [f64; 2],
    /// The first disc of each cell, row by row.
    first: Vec<u32>,
    /// The next disc in each disc's cell.
    next: Vec<u32>,
}

impl Cells {
    /// Empty cells no smaller than `diameter`, about one for each of `discs` discs, and three at least on periodic axes.
    pub fn new(space: Space, diameter: f64, discs: usize) -> Self {
        let room_for_one = (space.size[0] * space.size[1] / discs as f64).sqrt();
        let count = space.size.map(|size| {
            let (most, wanted) = ((size / diameter).floor(), (size / room_for_one).floor().max(3.0));
            wanted.min(most).clamp(1.0, 1e6) as u32
        });
        Self {
            space,
            count,
            size: [0, 1].map(|axis| space.size[axis] / f64::from(count[axis])),
            first: vec![NOBODY; count[0] as usize * count[1] as usize],
            next: vec![NOBODY; discs],
        }
    }

    /// The cell of a place in the box.
    pub fn cell_of(&self, place: Vec2<f64>) -> Cell {
        let along = |axis: usize, place: f64| {
            (place / self.size[axis]).clamp(0.0, f64::from(self.count[axis]) - 1.0) as u32
        };
        [along(0, place.x), along(1, place.y)]
    }

    /// The number of a cell, row by row.
    pub fn number(&self, [column, row]: Cell) -> usize {
        row as usize * self.count[0] as usize + column as usize
    }

    /// The sides of a cell along an axis; `None` where a wall of the box is.
    pub fn sides(&self, cell: Cell, axis: usize) -> [Option<f64>; 2] {
        let index = cell[axis];
        let is_open = self.space.periodic[axis];
        let side = |number: u32| f64::from(number) * self.size[axis];
        [
            (is_open || index > 0).then(|| side(index)),
            (is_open || index + 1 < self.count[axis]).then(|| side(index + 1)),
        ]
    }

    /// The cell beside another, and how far the box is to be moved so that they lie side by side; `None` beyond a wall.
    #[inline(always)]
    pub fn beside(&self, index: u32, axis: usize, step: i32) -> Option<(u32, f64)> {
        let is_open = self.space.periodic[axis];
        match step {
            -1 if index == 0 => is_open.then(|| (self.count[axis] - 1, -self.space.size[axis])),
            1 if index + 1 == self.count[axis] => is_open.then(|| (0, self.space.size[axis])),
            _ => Some((index.wrapping_add_signed(step), 0.0)),
        }
    }

    /// Puts a disc into a cell.
    pub fn enter(&mut self, disc: usize, cell: Cell) {
        let number = self.number(cell);
        self.next[disc] = self.first[number];
        self.first[number] = disc as u32;
    }

    /// Takes a disc out of its cell.
    pub fn leave(&mut self, disc: usize, cell: Cell) {
        let number = self.number(cell);
        let mut before = self.first[number];
        if before == disc as u32 {
            self.first[number] = self.next[disc];
            return;
        }
        while self.next[before as usize] != disc as u32 {
            before = self.next[before as usize];
        }
        self.next[before as usize] = self.next[disc];
    }

    /// Whether the test holds for a disc of the nine cells around a place; it is told the disc, and by how much that is to
    /// be moved to be the image that is near.
    #[inline(always)]
    pub fn any_near(&self, [column, row]: Cell, mut test: impl FnMut(usize, Vec2<f64>) -> bool) -> bool {
        for down in STEPS {
            let Some((row, y)) = self.beside(row, 1, down) else { continue };
            for across in STEPS {
                let Some((column, x)) = self.beside(column, 0, across) else { continue };
                let mut disc = self.first[self.number([column, row])];
                while disc != NOBODY {
                    if test(disc as usize, Vec2::new(x, y)) {
                        return true;
                    }
                    disc = self.next[disc as usize];
                }
            }
        }
        false
    }
}
