//! What takes snapshots, and the memory they need.

use crate::geometry::Vec2;
use crate::observe::Snapshot;
use crate::run::Plane;
use crate::scenario::System;
use crate::simulate::SimulationOf;

pub(super) struct Camera {
    size: [f64; 2],
    periods: [bool; 2],
    /// The corner of the table that is the origin of a snapshot.
    corner: Vec2<f64>,
    positions: Vec<Vec2<f64>>,
    velocities: Vec<Vec2<f64>>,
    radii: Vec<f64>,
    masses: Vec<f64>,
}

impl Camera {
    pub(super) fn new(system: &System<f64>) -> Self {
        let (corner, extent) = (system.bounds.min, system.bounds.max - system.bounds.min);
        let count = system.discs.len();
        Self {
            size: [extent.x, extent.y],
            periods: system.periodic,
            corner,
            positions: Vec::with_capacity(count),
            velocities: Vec::with_capacity(count),
            radii: system.discs.iter().map(|disc| disc.radius).collect(),
            masses: system.discs.iter().map(|disc| disc.mass).collect(),
        }
    }

    /// The number of discs.
    pub(super) fn count(&self) -> usize {
        self.radii.len()
    }

    /// The discs at a time up to which everything has happened.
    pub(super) fn look(&mut self, simulation: &SimulationOf<Plane>, time: f64) -> Snapshot<'_> {
        let system = simulation.system();
        self.positions.clear();
        self.velocities.clear();
        simulation.each_ball(|flight, track| {
            let state = system.unwrapped(&flight, track.image).state_after(time - flight.start);
            self.positions.push(state.position - self.corner);
            self.velocities.push(state.velocity);
        });
        Snapshot {
            time,
            size: self.size,
            periods: self.periods,
            positions: &self.positions,
            velocities: &self.velocities,
            radii: &self.radii,
            masses: &self.masses,
        }
    }
}
