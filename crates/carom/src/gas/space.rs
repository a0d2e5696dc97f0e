//! The box of a gas: its size, and which of its sides are periodic.

use super::error::Error;
use crate::geometry::Vec2;

/// The engine asks for this many diameters of the largest disc across a periodic side: three, each in a cell that is
/// larger by a hair.
pub const PERIODIC_DIAMETERS: f64 = 3.0 * (1.0 + 2e-6);

/// Names of the sides.
const SIDES: [&str; 2] = ["width", "length"];

/// A box with a corner in the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Space {
    /// Width and length.
    pub size: [f64; 2],
    /// Whether it repeats itself along each axis; where not, it has walls.
    pub periodic: [bool; 2],
}

impl Space {
    /// The box of an area and an aspect, length over width.
    pub fn of_area(area: f64, aspect: f64, periodic: [bool; 2]) -> Self {
        let width = (area / aspect).sqrt();
        Self { size: [width, area / width], periodic }
    }

    /// Checks that a disc of this diameter has room.
    pub fn check_room_for(&self, diameter: f64) -> Result<(), Error> {
        for axis in [0, 1] {
            let (side, diameters) = (SIDES[axis], self.size[axis] / diameter);
            if diameters < 1.0 {
                return Err(Error::DiscTooLarge { side, diameters });
            }
            if self.periodic[axis] && diameters < PERIODIC_DIAMETERS {
                return Err(Error::PeriodicTooNarrow { side, diameters });
            }
        }
        Ok(())
    }

    /// The shortest way between two places of the box, over periodic sides too.
    #[inline(always)]
    pub fn separation(&self, from: Vec2<f64>, to: Vec2<f64>) -> Vec2<f64> {
        let way = to - from;
        Vec2::new(self.shortest(0, way.x), self.shortest(1, way.y))
    }

    #[inline(always)]
    fn shortest(&self, axis: usize, way: f64) -> f64 {
        let size = self.size[axis];
        if !self.periodic[axis] || way.abs() <= 0.5 * size {
            way
        } else if way > 0.0 {
            way - size
        } else {
            way + size
        }
    }

    /// A place that left the box over a periodic side by less than its size, put back.
    pub fn wrapped(&self, place: Vec2<f64>) -> Vec2<f64> {
        let along = |axis: usize, place: f64| {
            let size = self.size[axis];
            let inside = match self.periodic[axis] {
                true if place < 0.0 => place + size,
                true if place >= size => place - size,
                _ => return place,
            };
            // A hair below zero may round to the size.
            if inside < size { inside } else { 0.0 }
        };
        Vec2::new(along(0, place.x), along(1, place.y))
    }
}
