//! What must hold of a gas at any moment, found from the flights alone: the engine is not asked about itself.

use carom::engine::Simulation;
use carom::geometry::Vec2;
use carom::run::{Event, Observer, Plane};
use carom::scenario::System;
use std::sync::Arc;

/// Remembers a gas as it began, to hold what comes of it against that.
pub struct Audit {
    system: Arc<System<f64>>,
    energy: f64,
    momentum: Vec2<f64>,
    /// Σ m |v|: what the momentum would be if all went one way.
    all_one_way: f64,
}

/// What was found of a gas at a moment.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The deepest overlap of two discs, or of a disc and a wall, in radii of the smaller disc; below zero where nothing
    /// overlaps.
    pub overlap: f64,
    /// The change of the energy since the beginning, as a part of it.
    pub energy: f64,
    /// The largest change of the momentum along a periodic axis, over Σ m |v|.
    pub momentum: f64,
    /// Discs outside the table, or with a number that is none.
    pub lost: usize,
}

/// Watches that time never goes back.
#[derive(Default)]
pub struct Clock {
    last: f64,
    /// How often it did.
    pub backwards: u64,
}

/// Places in a box, along some of whose axes they go on at the other side.
pub struct Places<'a> {
    pub size: [f64; 2],
    pub periods: [bool; 2],
    pub places: &'a [Vec2<f64>],
    pub radii: &'a [f64],
}

impl Audit {
    /// Of a gas at its beginning.
    pub fn new(simulation: &Simulation<f64>) -> Self {
        let system = simulation.system().clone();
        let (_, velocities, _) = look(simulation);
        let (energy, momentum, all_one_way) = sums(&system, &velocities);
        Self { system, energy, momentum, all_one_way }
    }

    /// Looks at all of the gas, at its present time.
    pub fn check(&self, simulation: &Simulation<f64>) -> Found {
        let (places, velocities, lost) = look(simulation);
        let (energy, momentum, _) = sums(&self.system, &velocities);
        let change = momentum - self.momentum;
        let along = |axis: usize, change: f64| if self.system.periodic[axis] { change.abs() } else { 0.0 };
        let radii: Vec<f64> = self.system.discs.iter().map(|disc| disc.radius).collect();
        let size = (self.system.bounds.max - self.system.bounds.min).to_f64();
        let box_of = Places { size, periods: self.system.periodic, places: &places, radii: &radii };
        Found {
            overlap: if lost == 0 { box_of.deepest_overlap() } else { f64::NAN },
            energy: (energy - self.energy) / self.energy,
            momentum: along(0, change.x).max(along(1, change.y)) / self.all_one_way,
            lost,
        }
    }
}

/// Places, from the corner of the table on and wrapped into it, velocities, and how many discs are lost.
fn look(simulation: &Simulation<f64>) -> (Vec<Vec2<f64>>, Vec<Vec2<f64>>, usize) {
    let (system, time) = (simulation.system().clone(), simulation.time());
    let size = (system.bounds.max - system.bounds.min).to_f64();
    let (mut places, mut velocities, mut lost) = (Vec::new(), Vec::new(), 0);
    simulation.each_ball(|flight, _| {
        let state = flight.state_after(time - flight.start);
        let place = (state.position - system.bounds.min).to_f64();
        let wrapped = [0, 1]
            .map(|axis| if system.periodic[axis] { place[axis].rem_euclid(size[axis]) } else { place[axis] });
        // What is no number is in no box.
        let is_inside = (0..2).all(|axis| (0.0..=size[axis]).contains(&wrapped[axis]));
        lost += usize::from(!(is_inside && state.velocity.is_finite()));
        places.push(Vec2::new(wrapped[0], wrapped[1]));
        velocities.push(state.velocity);
    });
    lost += system.discs.len().abs_diff(places.len());
    (places, velocities, lost)
}

/// Energy, momentum and Σ m |v|.
fn sums(system: &System<f64>, velocities: &[Vec2<f64>]) -> (f64, Vec2<f64>, f64) {
    let both = || system.discs.iter().map(|disc| disc.mass).zip(velocities);
    let energy = sum(both().map(|(mass, velocity)| 0.5 * mass * velocity.norm_squared()));
    let [x, y] = [sum(both().map(|(mass, v)| mass * v.x)), sum(both().map(|(mass, v)| mass * v.y))];
    (energy, Vec2::new(x, y), sum(both().map(|(mass, velocity)| mass * velocity.norm_squared().sqrt())))
}

/// A sum that is as good as if it had been made with twice the digits (A. Neumaier's).
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut rest) = (0.0_f64, 0.0);
    for term in terms {
        let next = sum + term;
        rest += if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
        sum = next;
    }
    sum + rest
}

impl Places<'_> {
    /// The deepest overlap of two discs, or of a disc and a wall, in radii of the smaller disc.
    pub fn deepest_overlap(&self) -> f64 {
        let largest = self.radii.iter().copied().fold(0.0, f64::max);
        let cells = self.size.map(|side| ((side / (2.0 * largest)) as usize).max(1));
        let sorted = self.by_cell(cells);
        let mut deepest = self.deepest_in_walls();
        for disc in 0..self.places.len() as u32 {
            let [column, row] = self.cell(disc, cells);
            for (across, up) in (0..9).map(|k| (k % 3, k / 3)) {
                // One cell back, the same, and one on; beyond a wall there is none.
                let [column, row] = [(0, column + across), (1, row + up)].map(|(axis, next)| {
                    let is_there = (1..=cells[axis]).contains(&next);
                    let beyond = self.periods[axis].then(|| (next + cells[axis] - 1) % cells[axis]);
                    if is_there { Some(next - 1) } else { beyond }
                });
                let (Some(column), Some(row)) = (column, row) else { continue };
                for &other in sorted.of(row * cells[0] + column) {
                    if other > disc {
                        deepest = deepest.max(self.overlap(disc as usize, other as usize));
                    }
                }
            }
        }
        deepest
    }

    fn overlap(&self, a: usize, b: usize) -> f64 {
        let away = (self.places[b] - self.places[a]).to_f64();
        let [x, y] = [0, 1].map(|axis| {
            let rounds = if self.periods[axis] { (away[axis] / self.size[axis]).round() } else { 0.0 };
            away[axis] - rounds * self.size[axis]
        });
        let depth = self.radii[a] + self.radii[b] - (x * x + y * y).sqrt();
        depth / self.radii[a].min(self.radii[b])
    }

    /// How deep a disc is in a wall, in its radii.
    fn deepest_in_walls(&self) -> f64 {
        let mut deepest = f64::NEG_INFINITY;
        for (place, radius) in self.places.iter().zip(self.radii) {
            for axis in (0..2).filter(|axis| !self.periods[*axis]) {
                let along = place.to_f64()[axis];
                deepest = deepest.max((radius - along).max(along + radius - self.size[axis]) / radius);
            }
        }
        deepest
    }

    fn cell(&self, disc: u32, cells: [usize; 2]) -> [usize; 2] {
        let place = self.places[disc as usize].to_f64();
        [0, 1].map(|axis| {
            let cell = (place[axis] / self.size[axis] * cells[axis] as f64) as usize;
            cell.min(cells[axis] - 1)
        })
    }

    fn by_cell(&self, cells: [usize; 2]) -> ByCell {
        let places: Vec<usize> = (0..self.places.len() as u32)
            .map(|disc| {
                let [column, row] = self.cell(disc, cells);
                row * cells[0] + column
            })
            .collect();
        let mut starts = vec![0u32; cells[0] * cells[1] + 1];
        places.iter().for_each(|cell| starts[cell + 1] += 1);
        (1..starts.len()).for_each(|cell| starts[cell] += starts[cell - 1]);
        let (mut next, mut discs) = (starts.clone(), vec![0; places.len()]);
        for (disc, cell) in places.into_iter().enumerate() {
            discs[next[cell] as usize] = disc as u32;
            next[cell] += 1;
        }
        ByCell { starts, discs }
    }
}

/// The discs, cell by cell.
struct ByCell {
    starts: Vec<u32>,
    discs: Vec<u32>,
}

impl ByCell {
    fn of(&self, cell: usize) -> &[u32] {
        &self.discs[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

impl Observer<f64, Plane> for Clock {
    fn event(&mut self, event: &Event<f64>) {
        // A time that is no number counts as well.
        self.backwards += u64::from(event.time < self.last || event.time.is_nan());
        self.last = event.time;
    }

    fn flight(&mut self, _: usize, _: &carom::flight::Flight<f64>) {}
}
