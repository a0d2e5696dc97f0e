//! The Voronoi cell of a disc: all that is nearer to its centre than to any other.
//!
//! The cell begins as the box, seen from the centre (as far as its whole size along periodic axes), and is cut by the
//! line half way to each neighbour, nearest first, until all that follow are too far to reach it.

use super::grid::Grid;
use super::snapshot::{Gas, Snapshot};

/// The first guess of how far away the neighbours of a cell can be, in units of the mean distance √(A/N).
const REACH: f64 = 2.5;

/// A neighbour of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Neighbour {
    /// From the centre to the neighbour's centre.
    pub way: [f64; 2],
    /// The length of the edge between the two cells.
    pub edge: f64,
}

/// Makes the cells of a snapshot, one after the other, in memory that is used again.
pub(super) struct Voronoi<'a> {
    gas: &'a Gas,
    grid: Grid,
    spacing: f64,
    /// Squared distance, number and way of those who may be neighbours.
    near: Vec<(f64, u32, [f64; 2])>,
    corners: Vec<Corner>,
    cut: Vec<Corner>,
}

/// A corner of a cell, and on whose line the edge from it to the next corner lies.
#[derive(Clone, Copy)]
struct Corner {
    place: [f64; 2],
    /// The way to the neighbour; `None` for a side of the box.
    neighbour: Option<[f64; 2]>,
}

impl<'a> Voronoi<'a> {
    pub fn new(snapshot: &Snapshot, gas: &'a Gas) -> Self {
        let spacing = (gas.area() / gas.count).sqrt();
        let grid = Grid::new(snapshot, spacing);
        Self { gas, grid, spacing, near: Vec::new(), corners: Vec::new(), cut: Vec::new() }
    }

    /// Calls `visit` with the neighbours of each disc.
    pub fn for_each(&mut self, mut visit: impl FnMut(&[Neighbour])) {
        let mut neighbours = Vec::new();
        for disc in 0..self.gas.count as usize {
            let centre = [0, 1].map(|axis| self.grid.places()[axis][disc]);
            self.make(centre);
            neighbours.clear();
            neighbours.extend(self.neighbours());
            visit(&neighbours);
        }
    }

    fn make(&mut self, centre: [f64; 2]) {
        let mut reach = REACH * self.spacing;
        loop {
            self.begin(centre);
            self.gather(centre, reach);
            if self.cut_by_all(reach) || reach > 4.0 * (self.gas.size[0] + self.gas.size[1]) {
                return;
            }
            reach *= 2.0;
        }
    }

    /// The box, seen from the centre, counter-clockwise.
    fn begin(&mut self, centre: [f64; 2]) {
        let side = |axis: usize, end: f64| {
            let size = self.gas.size[axis];
            if self.gas.periods[axis] { (2.0 * end - 1.0) * size } else { end * size - centre[axis] }
        };
        let places = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let corner = |[x, y]: [f64; 2]| Corner { place: [side(0, x), side(1, y)], neighbour: None };
        self.corners.clear();
        self.corners.extend(places.map(corner));
    }

    /// Those within reach, nearest first; of equally near ones those of lower number, and the rest in order of
    /// direction.
    fn gather(&mut self, centre: [f64; 2], reach: f64) {
        let Self { near, grid, .. } = self;
        near.clear();
        grid.near(centre, reach, |other, way| {
            let square = way[0] * way[0] + way[1] * way[1];
            // Its own images count, itself does not; nor does one at the very same place.
            if square > 0.0 && square <= reach * reach {
                near.push((square, other, way));
            }
        });
        near.sort_unstable_by(|a, b| {
            a.0.total_cmp(&b.0)
                .then(a.1.cmp(&b.1))
                .then(a.2[0].total_cmp(&b.2[0]))
                .then(a.2[1].total_cmp(&b.2[1]))
        });
    }

    /// Whether nobody beyond the reach can cut the cell.
    fn cut_by_all(&mut self, reach: f64) -> bool {
        let mut farthest = self.farthest();
        for place in 0..self.near.len() {
            let (square, _, way) = self.near[place];
            // A line half way to the neighbour that no corner reaches.
            if square > 4.0 * farthest {
                return true;
            }
            if self.cut_by(way, 0.5 * square) {
                farthest = self.farthest();
            }
        }
        reach * reach >= 4.0 * farthest
    }

    /// The squared distance of the farthest corner.
    fn farthest(&self) -> f64 {
        let square = |corner: &Corner| corner.place[0] * corner.place[0] + corner.place[1] * corner.place[1];
        self.corners.iter().map(square).fold(0.0, |most, this| if this > most { this } else { most })
    }

    /// Cuts off what lies beyond the line of all places with place · way = half; says whether there was anything.
    fn cut_by(&mut self, way: [f64; 2], half: f64) -> bool {
        let beyond = |corner: &Corner| corner.place[0] * way[0] + corner.place[1] * way[1] - half;
        if self.corners.iter().all(|corner| beyond(corner) <= 0.0) {
            return false;
        }
        self.cut.clear();
        for (place, corner) in self.corners.iter().enumerate() {
            let next = &self.corners[(place + 1) % self.corners.len()];
            let (here, there) = (beyond(corner), beyond(next));
            if here <= 0.0 {
                self.cut.push(*corner);
            }
            if (here <= 0.0) != (there <= 0.0) {
                let part = here / (here - there);
                let across =
                    |axis: usize| corner.place[axis] + part * (next.place[axis] - corner.place[axis]);
                // Where the outline leaves the cell the new edge begins; where it comes back the old one goes on.
                let neighbour = if here <= 0.0 { Some(way) } else { corner.neighbour };
                self.cut.push(Corner { place: [across(0), across(1)], neighbour });
            }
        }
        core::mem::swap(&mut self.corners, &mut self.cut);
        true
    }

    fn neighbours(&self) -> impl Iterator<Item = Neighbour> {
        self.corners.iter().enumerate().filter_map(|(place, corner)| {
            let next = self.corners[(place + 1) % self.corners.len()].place;
            let [x, y] = [next[0] - corner.place[0], next[1] - corner.place[1]];
            corner.neighbour.map(|way| Neighbour { way, edge: (x * x + y * y).sqrt() })
        })
    }
}
