//! Which balls are near: the table in cells, each with the balls whose centres are in it.
//!
//! A cell is no smaller than two balls, so whatever a ball meets before it leaves its cell is in the nine cells around.
//! To leave a cell is nothing that happens to a ball: no flight and no counter changes, so a run has the same bits with
//! any grid as without one. On a periodic axis the last cells lie beside the first ones, and who goes through there has
//! gone round the table once more.

use super::ball::{Ball, Rest};
use super::four::{Four, MOST_BALLS};
use super::simd::Candidates;
use super::throw::Throw;
use crate::geometry::{Bounds, Vec2};
use crate::memory::{fetch, room_for};
use crate::scalar::Scalar;

/// A cell is this part as wide as the square that each ball has for itself, if that is enough for a ball: larger ones hold
/// more balls that are too far away, smaller ones are left too often.
const ROOM: f64 = 0.8;

/// Fewer cells than these are not worth having.
const FEWEST_CELLS: f64 = 25.0;

/// Fewer cells than these along a periodic axis would lie on both sides of a ball.
const FEWEST_ROUND: f64 = 3.0;

/// As many cells as one number of a ball's line can tell.
const MOST_CELLS: f64 = 65_535.0;

/// One ball of so many beyond the first four of a cell is a crowd: finer cells are worth it.
const CROWD: usize = 16;

/// Cells are not made so fine that there are more of them than this for a ball.
const MOST_CELLS_PER_BALL: usize = 32;

/// A cell is larger than two balls by this part of them, which no rounding of a place comes near.
const SLACK: f64 = 1e-6;

/// Beyond this many rounds a flight begins anew at the side of the table: they are counted in few bits, and so are the
/// differences of two.
pub const MOST_ROUNDS: i16 = 1 << 13;

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

/// The cells of a table, and who is in them. In whatever number a run is computed, these are in `f64`.
#[derive(Clone, Debug)]
pub struct Grid {
    lower: [f64; 2],
    /// Of the table; what an axis is long.
    extent: [f64; 2],
    /// Of a cell.
    size: [f64; 2],
    /// What it is at least.
    least: f64,
    /// Where cells end, from the lower end of each axis on; infinitely far where the table does and nobody goes round.
    edges: [Vec<f64>; 2],
    /// Columns and rows.
    count: [usize; 2],
    periodic: [bool; 2],
    /// Fours of balls in each cell.
    width: usize,
    /// The balls of each cell, row by row; those of a cell are in the first of its fours.
    balls: Vec<Four>,
    /// Balls beyond the first four of a cell.
    surplus: usize,
    /// So many of them make finer cells worth it.
    crowd: usize,
}

/// Cells that lie together, from the first column and row to the last; those beyond a side of the table are on its other
/// side, or missing.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    columns: [i32; 2],
    rows: [i32; 2],
}

impl Side {
    /// Whether it is across x, and whether it is towards larger numbers.
    fn axis(self) -> (usize, bool) {
        match self {
            Self::Left => (0, false),
            Self::Right => (0, true),
            Self::Below => (1, false),
            Self::Above => (1, true),
        }
    }
}

impl Grid {
    /// Cells for `balls` balls of up to a diameter inside some bounds; `None` where they would be too few.
    pub fn new<S: Scalar>(
        bounds: &Bounds<S>,
        diameter: S,
        balls: usize,
        periodic: [bool; 2],
    ) -> Option<Self> {
        let extent = bounds.max - bounds.min;
        let [width, height] = [extent.x.to_f64(), extent.y.to_f64()];
        let room_for_one = (width * height / balls.max(1) as f64).sqrt();
        let least = diameter.to_f64() * (1.0 + SLACK);
        let wanted = least.max(ROOM * room_for_one);
        let along = |length: f64, is_periodic: bool| {
            let count = (length / wanted).floor().clamp(1.0, MOST_CELLS);
            let fewest = (length / least).floor().min(FEWEST_ROUND);
            if is_periodic { count.max(fewest) } else { count }
        };
        let [columns, rows] = [along(width, periodic[0]), along(height, periodic[1])];
        let goes_round = periodic[0] || periodic[1];
        if wanted <= 0.0 || balls > MOST_BALLS || (columns * rows < FEWEST_CELLS && !goes_round) {
            return None;
        }
        let bare = Self {
            lower: [bounds.min.x.to_f64(), bounds.min.y.to_f64()],
            extent: [width, height],
            size: [0.0; 2],
            least,
            edges: [Vec::new(), Vec::new()],
            count: [0; 2],
            periodic,
            width: 1,
            balls: Vec::new(),
            surplus: 0,
            crowd: 0,
        };
        Some(bare.divided([columns as usize, rows as usize], balls))
    }

    /// The same table in so many cells, without balls.
    fn divided(&self, count: [usize; 2], balls: usize) -> Self {
        let size = [0, 1].map(|axis| self.extent[axis] / count[axis] as f64);
        let along = |axis: usize| edges(size[axis], self.extent[axis], count[axis], self.periodic[axis]);
        let edges = [along(0), along(1)];
        let mut cells = room_for(count[0] * count[1]);
        cells.resize(count[0] * count[1], Four::NOBODY);
        let grid = Self { size, edges, count, width: 1, balls: cells, surplus: 0, crowd: 0, ..*self };
        let [columns, rows] = grid.finer_count();
        let is_possible = [columns, rows] != count && columns * rows <= MOST_CELLS_PER_BALL * balls;
        Self { crowd: if is_possible { balls / CROWD + 1 } else { usize::MAX }, ..grid }
    }

    fn finer_count(&self) -> [usize; 2] {
        let along = |axis: usize| (2 * self.count[axis]).min((self.extent[axis] / self.least) as usize);
        [0, 1].map(|axis| along(axis).clamp(self.count[axis], MOST_CELLS as usize))
    }

    /// The same table in finer cells, without balls, where so many crowd in few cells that it is worth it.
    #[inline(always)]
    pub fn finer(&self, balls: usize) -> Option<Self> {
        if self.surplus < self.crowd { None } else { Some(self.divided(self.finer_count(), balls)) }
    }

    /// Takes all balls out.
    pub fn clear(&mut self) {
        self.balls.fill(Four::NOBODY);
        self.surplus = 0;
    }

    /// Where a cell is in memory.
    #[inline(always)]
    pub fn cell(&self, [column, row]: [u16; 2]) -> usize {
        row as usize * self.count[0] + column as usize
    }

    /// Puts a ball, which has not gone round yet, into the cell of a place where its flight has brought it.
    ///
    /// By round-off that may be the cell beside: then it leaves it at once, or comes into it soon.
    pub fn place<S: Scalar>(&mut self, ball: &mut Ball<S>, there: Vec2<S>) {
        ball.rounds = [0; 2];
        for (axis, there) in [there.x.to_f64(), there.y.to_f64()].into_iter().enumerate() {
            let mut along = there - self.lower[axis];
            if self.periodic[axis] {
                let rounds = (along / self.extent[axis]).floor();
                ball.rounds[axis] = rounds as i16;
                along -= self.extent[axis] * rounds;
            }
            let last = self.count[axis] as f64 - 1.0;
            ball.cell[axis] = (along / self.size[axis]).clamp(0.0, last) as u16;
        }
        self.enter(ball);
    }

    /// Moves a ball's cell by one along an axis, if there is one.
    #[inline(always)]
    fn turn<S>(&self, ball: &mut Ball<S>, axis: usize, is_up: bool) {
        let last = (self.count[axis] - 1) as u16;
        let (edge, beyond, round) = if is_up { (last, 0, 1) } else { (0, last, -1) };
        let cell = &mut ball.cell[axis];
        if *cell != edge {
            *cell = if is_up { *cell + 1 } else { *cell - 1 };
        } else if self.periodic[axis] {
            *cell = beyond;
            ball.rounds[axis] += round;
        }
    }

    /// The balls of a cell.
    #[inline(always)]
    fn fours_of(&mut self, cell: [u16; 2]) -> &mut [Four] {
        let at = self.cell(cell) * self.width;
        &mut self.balls[at..at + self.width]
    }

    fn enter<S>(&mut self, ball: &Ball<S>) {
        if !self.fours_of(ball.cell)[0].push(ball.number) {
            self.enter_crowd(ball);
        }
    }

    /// The same where the first four are there.
    #[cold]
    fn enter_crowd<S>(&mut self, ball: &Ball<S>) {
        while !self.fours_of(ball.cell)[1..].iter_mut().any(|four| four.push(ball.number)) {
            self.grow();
        }
        self.surplus += 1;
    }

    #[cold]
    fn grow(&mut self) {
        let mut balls = room_for(self.balls.len() * 2);
        balls.resize(self.balls.len() * 2, Four::NOBODY);
        for (cell, old) in self.balls.chunks_exact(self.width).enumerate() {
            let at = cell * self.width * 2;
            balls[at..at + self.width].copy_from_slice(old);
        }
        (self.balls, self.width) = (balls, self.width * 2);
    }

    /// The last ball of a cell takes the place of the one that leaves.
    fn leave<S>(&mut self, ball: &Ball<S>) {
        let Some((first, others)) = self.fours_of(ball.cell).split_first_mut() else { return };
        let surplus = others.iter_mut().rev().find_map(Four::pop);
        let Some(last) = surplus.or_else(|| first.pop()) else { return };
        if last != ball.number && !first.replace(ball.number, last) {
            others.iter_mut().any(|four| four.replace(ball.number, last));
        }
        self.surplus -= usize::from(surplus.is_some());
    }

    /// Notes that a ball leaves its cell through the side to which it is pulled: on this flight it never goes back there.
    pub fn note_fall<S: Scalar>(rest: &mut Rest<S>, side: Side) {
        let (axis, is_up) = side.axis();
        let pull = if axis == 0 { rest.acceleration.x } else { rest.acceleration.y };
        rest.is_falling[axis] |= if is_up { pull > S::ZERO } else { pull < S::ZERO };
    }

    /// Moves a ball to the next cell.
    #[inline(always)]
    pub fn cross<S>(&mut self, ball: &mut Ball<S>, side: Side) {
        self.leave(ball);
        let (axis, is_up) = side.axis();
        self.turn(ball, axis, is_up);
        self.enter(ball);
    }

    /// When a ball in straight flight leaves its cell, from the start of the flight, and where.
    #[inline(always)]
    pub fn way_out<S: Scalar>(&self, ball: &Ball<S>) -> (f64, Side) {
        let (across, along) = (self.leaves(ball, 0), self.leaves(ball, 1));
        if across < along {
            (across, if ball.velocity.x > S::ZERO { Side::Right } else { Side::Left })
        } else {
            (along, if ball.velocity.y > S::ZERO { Side::Above } else { Side::Below })
        }
    }

    /// When a coordinate leaves its cell; never through the outer sides of an axis that is not periodic.
    #[inline(always)]
    fn leaves<S: Scalar>(&self, ball: &Ball<S>, axis: usize) -> f64 {
        let (place, velocity) = if axis == 0 {
            (ball.position.x.to_f64(), ball.velocity.x.to_f64())
        } else {
            (ball.position.y.to_f64(), ball.velocity.y.to_f64())
        };
        let edge = self.edges[axis][usize::from(ball.cell[axis]) + usize::from(velocity > 0.0)];
        let round = self.extent[axis] * f64::from(ball.rounds[axis]);
        let time = (edge + round - (place - self.lower[axis])) / velocity;
        if velocity == 0.0 { f64::INFINITY } else { time }
    }

    /// The same of a ball that may be pulled.
    #[inline(never)]
    pub fn way_out_in_field<S: Scalar>(&self, ball: &Ball<S>, rest: &Rest<S>) -> (f64, Side) {
        let (across, is_right) = self.leaves_in_field(ball, rest, 0);
        let (along, is_above) = self.leaves_in_field(ball, rest, 1);
        if across < along {
            (across, if is_right { Side::Right } else { Side::Left })
        } else {
            (along, if is_above { Side::Above } else { Side::Below })
        }
    }

    /// When a coordinate that may be pulled leaves its cell, and whether upwards.
    fn leaves_in_field<S: Scalar>(&self, ball: &Ball<S>, rest: &Rest<S>, axis: usize) -> (f64, bool) {
        let [position, velocity, pull] = [ball.position, ball.velocity, rest.acceleration]
            .map(|v| if axis == 0 { v.x.to_f64() } else { v.y.to_f64() });
        if pull == 0.0 {
            return (self.leaves(ball, axis), velocity > 0.0);
        }
        let round = self.extent[axis] * f64::from(ball.rounds[axis]);
        let place = position - self.lower[axis];
        let cell = usize::from(ball.cell[axis]);
        let [to_lower, to_upper] = [cell, cell + 1].map(|edge| self.edges[axis][edge] + round - place);
        let throw = Throw { velocity, pull, is_falling: rest.is_falling[axis] };
        throw.leaves(to_lower, to_upper)
    }

    /// The nine cells around a ball's.
    #[inline(always)]
    pub fn around(&self, [column, row]: [u16; 2]) -> Window {
        let (column, row) = (i32::from(column), i32::from(row));
        Window { columns: [column - 1, column + 1], rows: [row - 1, row + 1] }
    }

    /// The three cells that have come near since a ball came into its cell on the opposite side.
    #[inline(always)]
    pub fn ahead(&self, cell: [u16; 2], side: Side) -> Window {
        let Window { columns: [left, right], rows: [below, above] } = self.around(cell);
        match side {
            Side::Left => Window { columns: [left; 2], rows: [below, above] },
            Side::Right => Window { columns: [right; 2], rows: [below, above] },
            Side::Below => Window { columns: [left, right], rows: [below; 2] },
            Side::Above => Window { columns: [left, right], rows: [above; 2] },
        }
    }

    /// Lists the balls of some cells; `false` where they are not all listed, as there are too many.
    #[inline(always)]
    pub fn list(&self, window: &Window, candidates: &mut Candidates) -> bool {
        let Window { columns: [left, right], rows: [below, above] } = *window;
        let is_inside = (left >= 0)
            & (below >= 0)
            & ((right as usize) < self.count[0])
            & ((above as usize) < self.count[1]);
        if !is_inside {
            return self.list_round(window, candidates);
        }
        let first = self.cell([left as u16, below as u16]);
        match (right - left, above - below) {
            (2, 2) => self.list_inside::<3, 3>(first, candidates),
            (2, _) => self.list_inside::<3, 1>(first, candidates),
            _ => self.list_inside::<1, 3>(first, candidates),
        }
    }

    #[inline(never)]
    fn list_round(&self, window: &Window, candidates: &mut Candidates) -> bool {
        candidates.clear(true);
        let mut has_room = true;
        self.each_cell(window, |cell, round| {
            let fours = &self.balls[cell * self.width..(cell + 1) * self.width];
            has_room &= candidates.add_cell(fours, round);
        });
        has_room
    }

    #[inline(always)]
    fn list_inside<const COLUMNS: usize, const ROWS: usize>(
        &self,
        first: usize,
        candidates: &mut Candidates,
    ) -> bool {
        candidates.add_cells::<COLUMNS, ROWS>((&self.balls, self.width), first, self.count[0])
    }

    /// Hands over the balls of some cells by fours, and how often one has gone round to be there.
    pub fn each_four(&self, window: &Window, mut meet: impl FnMut(&Four, [i16; 2])) {
        self.each_cell(window, |cell, round| {
            let fours = &self.balls[cell * self.width..(cell + 1) * self.width];
            fours.iter().take_while(|four| four.count() > 0).for_each(|four| meet(four, round));
        });
    }

    /// Hands over some cells, and how often one has gone round to be in each.
    #[inline(always)]
    fn each_cell(&self, window: &Window, mut meet: impl FnMut(usize, [i16; 2])) {
        for row in window.rows[0]..=window.rows[1] {
            let Some((row, round_y)) = self.seen(1, row) else { continue };
            for column in window.columns[0]..=window.columns[1] {
                if let Some((column, round_x)) = self.seen(0, column) {
                    meet(row * self.count[0] + column, [round_x, round_y]);
                }
            }
        }
    }

    /// Which column, or row, is at a place that may lie beyond a side of the table, and how often one has gone round to be there.
    #[inline(always)]
    fn seen(&self, axis: usize, index: i32) -> Option<(usize, i16)> {
        let count = self.count[axis] as i32;
        let round = i32::from(index >= count) - i32::from(index < 0);
        let is_there = round == 0 || self.periodic[axis];
        is_there.then_some(((index - round * count) as usize, round as i16))
    }

    /// Fetches what says who is in the cells around a cell.
    #[inline(always)]
    pub fn fetch_around(&self, cell: usize) {
        for row in self.rows_around(cell) {
            fetch(&self.balls, row.wrapping_sub(1).wrapping_mul(self.width));
            fetch(&self.balls, row.wrapping_add(1).wrapping_mul(self.width));
        }
    }

    /// Hands over the balls of the cells around a cell, as a guess: two of each, and those of whichever cells lie beside it
    /// in memory.
    #[inline(always)]
    pub fn each_near_in_memory(&self, cell: usize, mut meet: impl FnMut(u32)) {
        for row in self.rows_around(cell) {
            let first = row.wrapping_sub(1).wrapping_mul(self.width);
            let [first, second, third] = [0, 1, 2].map(|column| first.wrapping_add(column * self.width));
            if third < self.balls.len() && first < third {
                for at in [first, second, third] {
                    meet(self.balls[at].guess(0));
                    meet(self.balls[at].guess(1));
                }
            }
        }
    }

    /// Where in memory the cell is that lies beyond a side of a cell, or that cell itself; at the sides of the table somewhere.
    #[inline(always)]
    pub fn beyond(&self, cell: [u16; 2], side: Option<Side>) -> usize {
        let columns = self.count[0] as isize;
        let step = match side {
            None => 0,
            Some(Side::Left) => -1,
            Some(Side::Right) => 1,
            Some(Side::Below) => -columns,
            Some(Side::Above) => columns,
        };
        self.cell(cell).wrapping_add_signed(step)
    }

    /// The cells below a cell, itself, and above.
    #[inline(always)]
    fn rows_around(&self, cell: usize) -> [usize; 3] {
        [cell.wrapping_sub(self.count[0]), cell, cell.wrapping_add(self.count[0])]
    }
}

/// Where the cells of an axis end, from its lower end on.
fn edges(size: f64, extent: f64, count: usize, is_periodic: bool) -> Vec<f64> {
    let mut edges: Vec<f64> = (0..=count).map(|edge| size * edge as f64).collect();
    // Where the table ends, its own length counts, so that this does not depend on the cells.
    edges[count] = if is_periodic { extent } else { f64::INFINITY };
    edges[0] = if is_periodic { 0.0 } else { f64::NEG_INFINITY };
    edges
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::{Ball, Bounds, Grid, Vec2};
    use crate::flight::Flight;

    #[test]
    fn a_cell_holds_more_points_than_sixteen_bits_count() {
        let bounds = Bounds { min: Vec2::ZERO, max: Vec2::new(5.0, 5.0) };
        let mut grid = Grid::new(&bounds, 1.0 - 1e-3, 25, [false; 2]).unwrap();
        let still = Flight {
            start: 0.0,
            position: Vec2::new(2.5, 2.5),
            velocity: Vec2::ZERO,
            acceleration: Vec2::ZERO,
        };
        let mut cell = [0; 2];
        for number in 0..70_000 {
            let mut ball = Ball::new(number, 0.0, &still, 0);
            grid.place(&mut ball, still.position);
            cell = ball.cell;
        }
        let mut found = 0;
        grid.each_four(&grid.around(cell), |four, _| found += four.count());
        assert_eq!(found, 70_000);
    }

    #[test]
    fn cells_become_finer_until_balls_do_not_crowd() {
        let bounds = Bounds { min: Vec2::ZERO, max: Vec2::new(10.0, 20.0) };
        let mut grid = Grid::new(&bounds, 0.1, 64, [false; 2]).unwrap();
        let mut found = Vec::new();
        loop {
            for number in 0..64 {
                let position = Vec2::new(0.15 * (number % 8) as f64, 0.15 * (number / 8) as f64);
                let still = Flight { start: 0.0, position, velocity: Vec2::ZERO, acceleration: Vec2::ZERO };
                grid.place(&mut Ball::new(number, 0.05, &still, 0), position);
            }
            found.push((grid.count, grid.surplus));
            let Some(finer) = grid.finer(64) else { break };
            grid = finer;
        }
        // All in one cell; then 25 in one, 15 in each of two, 9 in one; then nine, six or four in each. Once more would make
        // more than 32 cells for a ball.
        assert_eq!(found, [([7, 14], 60), ([14, 28], 48), ([28, 56], 28)]);
        assert!(Grid::new(&bounds, 2.0, 64, [false; 2]).unwrap().crowd == usize::MAX);
    }
}
