//! Which balls are near: the table in cells, each with the balls whose centres are in it.
//!
//! A cell is no smaller than two balls, so whatever a ball meets before it leaves its cell is in the nine cells around.
//! To leave a cell is nothing that happens to a ball: no flight and no counter changes, so a run has the same bits with
//! the grid as without it.

use crate::flight::Flight;
use crate::geometry::{Bounds, Vec2};
use crate::scalar::Scalar;

/// Nobody: the end of a cell's list.
const NOBODY: u32 = u32::MAX;

/// Fewer cells than these are not worth having.
const FEWEST_CELLS: f64 = 25.0;

/// A cell is larger than two balls by this part of them, which no rounding of a place comes near.
const SLACK: f64 = 1e-6;

/// A side of a cell, through which a ball leaves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Towards smaller x.
    Left,
    /// Towards larger x.
    Right,
    /// Towards smaller y.
    Below,
    /// Towards larger y.
    Above,
}

/// The cells of a table, and who is in them.
#[derive(Clone, Debug)]
pub struct Grid<S> {
    lower: Vec2<S>,
    size: Vec2<S>,
    /// Columns and rows.
    count: [usize; 2],
    /// The first ball of each cell, row by row.
    first: Vec<u32>,
    /// The next ball in each ball's cell.
    next: Vec<u32>,
    /// The column and the row of each ball's cell.
    cells: Vec<[u32; 2]>,
}

impl<S: Scalar> Grid<S> {
    /// Cells for balls of up to a diameter inside some bounds, about one for each ball; `None` where they would be too few.
    pub fn new(bounds: &Bounds<S>, diameter: S, places: &[Vec2<S>]) -> Option<Self> {
        let extent = bounds.max - bounds.min;
        let [width, height] = [extent.x.to_f64(), extent.y.to_f64()];
        let room_for_one = (width * height / places.len() as f64).sqrt();
        let least = (diameter.to_f64() * (1.0 + SLACK)).max(room_for_one);
        let [columns, rows] = [width, height].map(|length| (length / least).floor().max(1.0));
        if least <= 0.0 || columns * rows < FEWEST_CELLS {
            return None;
        }
        let size = Vec2::new(extent.x / S::from_f64(columns), extent.y / S::from_f64(rows));
        let mut grid = Self {
            lower: bounds.min,
            size,
            count: [columns as usize, rows as usize],
            first: Vec::new(),
            next: Vec::new(),
            cells: Vec::new(),
        };
        grid.fill(places);
        Some(grid)
    }

    /// Puts all balls where they are.
    pub fn fill(&mut self, places: &[Vec2<S>]) {
        let [columns, rows] = self.count;
        self.first.clear();
        self.first.resize(columns * rows, NOBODY);
        self.next.resize(places.len(), NOBODY);
        self.cells.clear();
        for (ball, place) in places.iter().enumerate() {
            let from = *place - self.lower;
            let index = |along: S, size: S, count: usize| {
                (along / size).to_f64().clamp(0.0, count as f64 - 1.0) as u32
            };
            self.cells.push([index(from.x, self.size.x, columns), index(from.y, self.size.y, rows)]);
            self.enter(ball);
        }
    }

    fn place(&self, [column, row]: [u32; 2]) -> usize {
        row as usize * self.count[0] + column as usize
    }

    fn enter(&mut self, ball: usize) {
        let cell = self.place(self.cells[ball]);
        self.next[ball] = self.first[cell];
        self.first[cell] = ball as u32;
    }

    fn leave(&mut self, ball: usize) {
        let cell = self.place(self.cells[ball]);
        let mut before = self.first[cell];
        if before == ball as u32 {
            self.first[cell] = self.next[ball];
            return;
        }
        while self.next[before as usize] != ball as u32 {
            before = self.next[before as usize];
        }
        self.next[before as usize] = self.next[ball];
    }

    /// Moves a ball to the next cell.
    pub fn cross(&mut self, ball: usize, side: Side) {
        self.leave(ball);
        let [column, row] = &mut self.cells[ball];
        match side {
            Side::Left => *column -= 1,
            Side::Right => *column += 1,
            Side::Below => *row -= 1,
            Side::Above => *row += 1,
        }
        self.enter(ball);
    }

    /// When a ball in straight flight leaves its cell, from the start of the flight, and where.
    #[inline(always)]
    pub fn way_out(&self, ball: usize, flight: &Flight<S>) -> (S, Side) {
        let ([column, row], place, velocity) =
            (self.cells[ball], flight.position - self.lower, flight.velocity);
        let across = way_along(place.x, velocity.x, self.size.x, column, self.count[0]);
        let along = way_along(place.y, velocity.y, self.size.y, row, self.count[1]);
        if across < along {
            (across, if velocity.x > S::ZERO { Side::Right } else { Side::Left })
        } else {
            (along, if velocity.y > S::ZERO { Side::Above } else { Side::Below })
        }
    }

    /// The balls in the nine cells around a ball, itself too.
    #[inline(always)]
    pub fn near(&self, ball: usize, meet: impl FnMut(usize)) {
        let [column, row] = self.cells[ball].map(|index| index as usize);
        let [columns, rows] = self.count;
        self.in_cells(
            column.saturating_sub(1)..(column + 2).min(columns),
            row.saturating_sub(1)..(row + 2).min(rows),
            meet,
        );
    }

    /// The balls in the three cells that have come near since a ball came into its cell on the opposite side.
    #[inline(always)]
    pub fn ahead(&self, ball: usize, side: Side, meet: impl FnMut(usize)) {
        let [column, row] = self.cells[ball].map(|index| index as usize);
        let [columns, rows] = self.count;
        let around = |index: usize, count: usize| index.saturating_sub(1)..(index + 2).min(count);
        let before = |index: usize| index.saturating_sub(1)..index;
        let behind = |index: usize, count: usize| index + 1..(index + 2).min(count);
        let (across, along) = match side {
            Side::Left => (before(column), around(row, rows)),
            Side::Right => (behind(column, columns), around(row, rows)),
            Side::Below => (around(column, columns), before(row)),
            Side::Above => (around(column, columns), behind(row, rows)),
        };
        self.in_cells(across, along, meet);
    }

    #[inline(always)]
    fn in_cells(
        &self,
        across: core::ops::Range<usize>,
        along: core::ops::Range<usize>,
        mut meet: impl FnMut(usize),
    ) {
        for row in along {
            for column in across.clone() {
                let mut ball = self.first[row * self.count[0] + column];
                while ball != NOBODY {
                    meet(ball as usize);
                    ball = self.next[ball as usize];
                }
            }
        }
    }
}

/// When a coordinate leaves its cell; never through the outer sides, where the cushions are.
#[inline(always)]
fn way_along<S: Scalar>(place: S, velocity: S, size: S, index: u32, count: usize) -> S {
    let edge = |index: u32| size * S::from_f64(f64::from(index));
    if velocity > S::ZERO && ((index + 1) as usize) < count {
        (edge(index + 1) - place) / velocity
    } else if velocity < S::ZERO && index > 0 {
        (edge(index) - place) / velocity
    } else {
        S::INFINITY
    }
}
