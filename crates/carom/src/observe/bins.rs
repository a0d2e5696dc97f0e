//! Equal bins of distance, one edge of which is the diameter.

use serde::{Deserialize, Serialize};

/// Where the bins are, as lengths.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Bins {
    pub diameter: f64,
    pub start: f64,
    pub width: f64,
    /// The first bin beyond the diameter.
    pub contact: usize,
    pub count: usize,
}

impl Bins {
    /// Bins up to a range and of a width in diameters.
    pub fn new(range: f64, width: f64, diameter: f64) -> Self {
        // A width such as 0.1 goes into one as often as it looks, in spite of round-off.
        let contact = (1.0 / width * (1.0 + 1e-12)) as usize;
        let beyond = ((range - 1.0) / width * (1.0 + 1e-12)) as usize;
        let start = diameter * (1.0 - contact as f64 * width);
        // What is left of zero is round-off.
        let start = if start > 1e-9 * diameter { start } else { 0.0 };
        Self { diameter, start, width: width * diameter, contact, count: contact + beyond }
    }

    /// Where a bin begins.
    pub fn edge(&self, bin: usize) -> f64 {
        self.start + bin as f64 * self.width
    }

    /// Where the last bin ends.
    pub fn end(&self) -> f64 {
        self.edge(self.count)
    }

    /// The area of the ring of a bin.
    pub fn ring(&self, bin: usize) -> f64 {
        let (inner, outer) = (self.edge(bin), self.edge(bin + 1));
        core::f64::consts::PI * (outer - inner) * (outer + inner)
    }
}
