//! How many discs are in the rings about others: pairs, counted by their distance.
//!
//! Nearly all the time goes into distances. They are taken in single precision, as seen from the middle of a cell, which is
//! quick and nearly always tells the bin. Where one is so close to the edge of its bin that rounding might decide, all of
//! its piece are taken again in double precision; so the counts are those of double precision, to the last pair.

use super::bins::Bins;
use super::grid::{Crowd, Grid};
use super::snapshot::Snapshot;
use core::ops::Range;

/// The side of the cells in ranges: a hair more than half, so that all in range are two cells away at most.
const CELL: f64 = 0.501;
/// So many distances are taken at once: they fill wide registers. The last group is filled up.
const GROUP: usize = 8;
/// After so many it is asked whether single precision was enough.
const PIECE: usize = 16 * GROUP;
/// 3 · 2²²: added to a number from zero to 2²², it leaves the nearest whole number in the last bits.
const ROUND: f32 = 12_582_912.0;

/// A rectangle: the middles of rings are in it. Along a periodic axis it has no ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Middles {
    pub from: [f64; 2],
    pub to: [f64; 2],
}

/// The number of middles, and for each bin that of the discs in it about them.
pub(super) fn pair_counts(snapshot: &Snapshot, bins: &Bins, middles: &Middles) -> (usize, Vec<u64>) {
    let grid = Grid::new(snapshot, CELL * bins.end());
    let [x, y] = grid.places();
    let count = x.iter().zip(y).filter(|(x, y)| middles.have([**x, **y])).count();
    let mut counter = Counter::new(&grid, bins, middles);
    grid.crowds(bins.end(), |crowd| counter.take(crowd));
    (count, counter.counts[1..=bins.count].to_vec())
}

impl Middles {
    fn have(&self, place: [f64; 2]) -> bool {
        (0..2).all(|axis| place[axis] >= self.from[axis] && place[axis] <= self.to[axis])
    }

    /// Whether every disc is one.
    fn are_everywhere(&self) -> bool {
        self.from == [f64::NEG_INFINITY; 2] && self.to == [f64::INFINITY; 2]
    }
}

/// Counts the pairs of one crowd after the other, in memory that is used again.
struct Counter<'a> {
    grid: &'a Grid,
    bins: &'a Bins,
    middles: &'a Middles,
    quick: Quick,
    /// A place beyond the range of all discs of a cell, as seen from its middle.
    far: [f32; 2],
    /// One for each bin, one before them for what is nearer, and behind them those that a crowd may reach: so there is no
    /// branch to mispredict.
    counts: Vec<u64>,
    /// The crowd as seen from the middle of its cell, and a group of far places behind it.
    near: [Vec<f32>; 2],
    /// The crowd where it is; empty until that is asked for.
    exact: [Vec<f64>; 2],
    /// For each of the crowd one if it is a middle; empty where all are.
    is_middle: Vec<u64>,
    found: [u32; PIECE],
}

impl<'a> Counter<'a> {
    fn new(grid: &'a Grid, bins: &'a Bins, middles: &'a Middles) -> Self {
        let [width, height] = grid.sides();
        let farthest = bins.end() + 2.0 * (width * width + height * height).sqrt();
        Self {
            grid,
            bins,
            middles,
            quick: Quick::new(bins, if width > height { width } else { height }),
            far: [(bins.end() + width) as f32, 0.0],
            counts: vec![0; ((farthest - bins.start) / bins.width) as usize + 2],
            near: Default::default(),
            exact: Default::default(),
            is_middle: Vec::new(),
            found: [0; PIECE],
        }
    }

    fn take(&mut self, crowd: &Crowd) {
        let count = self.look_at(crowd);
        self.exact.iter_mut().for_each(Vec::clear);
        if !self.middles.are_everywhere() {
            self.look_closely_at(crowd);
            let [x, y] = &self.exact;
            let is_middle = x.iter().zip(y).map(|(x, y)| u64::from(self.middles.have([*x, *y])));
            self.is_middle.clear();
            self.is_middle.extend(is_middle.chain([0; GROUP]));
        }
        for own in 0..crowd.own {
            let end = own + 1 + (count - own - 1).next_multiple_of(GROUP);
            let mut from = own + 1;
            while from < end {
                let to = end.min(from + PIECE);
                self.count(crowd, own, from..to);
                from = to;
            }
        }
    }

    /// Fills in the crowd as seen from the middle of its cell; says how many there are.
    fn look_at(&mut self, crowd: &Crowd) -> usize {
        let [x, y] = self.grid.places();
        let count: usize = crowd.stretches.iter().map(|(discs, _)| discs.len()).sum();
        let room = self.near[0].len().max(count + GROUP);
        self.near.iter_mut().for_each(|near| near.resize(room, 0.0));
        let [near_x, near_y] = &mut self.near;
        let mut from = 0;
        for (discs, shift) in &crowd.stretches {
            let [across, up] = [shift[0] - crowd.middle[0], shift[1] - crowd.middle[1]];
            let to = from + discs.len();
            let near = near_x[from..to].iter_mut().zip(&mut near_y[from..to]);
            let places = x[discs.clone()].iter().zip(&y[discs.clone()]);
            for ((near_x, near_y), (x, y)) in near.zip(places) {
                (*near_x, *near_y) = ((x + across) as f32, (y + up) as f32);
            }
            from = to;
        }
        near_x[count..count + GROUP].fill(self.far[0]);
        near_y[count..count + GROUP].fill(self.far[1]);
        count
    }

    /// Fills in the crowd where it is.
    fn look_closely_at(&mut self, crowd: &Crowd) {
        for (axis, exact) in self.exact.iter_mut().enumerate() {
            for (discs, shift) in &crowd.stretches {
                let places = &self.grid.places()[axis][discs.clone()];
                exact.extend(places.iter().map(|place| place + shift[axis]));
            }
        }
    }

    /// Counts the pairs of one disc with a piece of those behind it.
    #[inline]
    fn count(&mut self, crowd: &Crowd, own: usize, piece: Range<usize>) {
        let [x, y] = &self.near;
        let found = &mut self.found[..piece.len()];
        if !self.quick.find([x[own], y[own]], [&x[piece.clone()], &y[piece.clone()]], found) {
            if self.exact[0].is_empty() {
                self.look_closely_at(crowd);
            }
            let [x, y] = &self.exact;
            let found = &mut self.found[..piece.len()];
            self.bins.find([x[own], y[own]], [&x[piece.start..], &y[piece.start..]], found);
        }
        let groups = self.found[..piece.len()].as_chunks().0;
        if self.is_middle.is_empty() {
            groups.iter().for_each(|group| tally(&mut self.counts, group, &[2; GROUP]));
        } else {
            // Each of two is in the ring of the other, if that is a middle.
            let others = self.is_middle[piece].as_chunks::<GROUP>().0;
            for (group, others) in groups.iter().zip(others) {
                tally(&mut self.counts, group, &others.map(|other| other + self.is_middle[own]));
            }
        }
    }
}

#[inline(always)]
fn tally(counts: &mut [u64], group: &[u32; GROUP], weights: &[u64; GROUP]) {
    for (bin, weight) in group.iter().zip(weights) {
        if let Some(count) = counts.get_mut(*bin as usize) {
            *count += weight;
        }
    }
}

impl Bins {
    /// The bins, counted from one, in which others are about a place; zero for what is nearer than the first.
    #[inline(never)]
    fn find(&self, from: [f64; 2], [x, y]: [&[f64]; 2], found: &mut [u32]) {
        let per_width = 1.0 / self.width;
        for ((x, y), bin) in x.iter().zip(y).zip(found) {
            let [x, y] = [x - from[0], y - from[1]];
            // A negative number becomes zero.
            *bin = (((x * x + y * y).sqrt() - self.start) * per_width + 1.0) as u32;
        }
    }
}

/// The same in single precision.
struct Quick {
    per_width: f32,
    offset: f32,
    /// How far a number of bins may be from the middle of one, to be surely in that.
    sure: f32,
}

impl Quick {
    /// Each operation rounds by half of ε at most, relative to its result. Of two discs in range one is in a cell seen from
    /// its middle, so coordinates are up to side/2 and range + side/2: a difference along an axis is off by
    /// (range + side/2) ε, a distance in two by √2 times that and by range × ε for squares, sum and root, and as a number of
    /// bins, in which there are three more roundings, by 3/2 range × ε: in all by (3.92 range + 0.71 side) ε.
    fn new(bins: &Bins, side: f64) -> Self {
        let rounding = (6.0 * bins.end() + side) * f64::from(f32::EPSILON);
        Self {
            per_width: (1.0 / bins.width) as f32,
            offset: (0.5 - bins.start / bins.width) as f32,
            sure: (0.5 - rounding / bins.width) as f32,
        }
    }

    /// As [`Bins::find`]; says whether all that are in range are surely right.
    #[inline(never)]
    fn find(&self, from: [f32; 2], [x, y]: [&[f32]; 2], found: &mut [u32]) -> bool {
        let mut signs = u32::MAX;
        for ((x, y), bin) in x.iter().zip(y).zip(found) {
            let [x, y] = [x - from[0], y - from[1]];
            let place = (x * x + y * y).sqrt() * self.per_width + self.offset;
            let rounded = place + ROUND;
            let from_middle = (place - (rounded - ROUND)).abs();
            // All signs stay set as long as each is that of a negative number.
            signs &= (from_middle - self.sure).to_bits();
            *bin = rounded.to_bits() - ROUND.to_bits();
        }
        signs >> 31 == 1
    }
}
