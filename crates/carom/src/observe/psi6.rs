//! Bond-orientational order: how well six neighbours surround each disc.
//!
//! ψ₆ of a disc is the mean of exp(6iθ) over its Voronoi neighbours, θ being the direction to each, weighted with the
//! length of the edge between the two cells. So it changes steadily when neighbours come and go, which a mean over
//! Delaunay bonds of equal weight does not, nor one over the nearest six (W. Mickel, S. C. Kapfer, G. E. Schröder-Turk,
//! K. Mecke, *Shortcomings of the bond orientational order parameters for the analysis of disordered particulate
//! matter*, J. Chem. Phys. 138, 044501, 2013). It is 1 in a triangular lattice and 0 in a square one. Cells end at
//! walls, which count as no neighbour.

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::results::{Quantity, Results};
use super::snapshot::{Gas, Moment};
use super::voronoi::{Neighbour, Voronoi};
use serde::{Deserialize, Serialize};

/// Global and local order.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Psi6 {
    global: Blocks,
    global_square: Blocks,
    local: Blocks,
}

impl Measure for Psi6 {
    fn sample(&mut self, Moment { snapshot, gas, .. }: &Moment) {
        let [mut real, mut imaginary, mut modulus] = [0.0; 3];
        Voronoi::new(snapshot, gas).for_each(|neighbours| {
            let own = psi6(neighbours);
            real += own[0];
            imaginary += own[1];
            modulus += (own[0] * own[0] + own[1] * own[1]).sqrt();
        });
        let square = (real * real + imaginary * imaginary) / (gas.count * gas.count);
        self.global.push(square.sqrt());
        self.global_square.push(square);
        self.local.push(modulus / gas.count);
    }

    fn results(&self, _: &Gas, _: &EventSums) -> Results {
        let quantities = vec![
            Quantity::measured(GLOBAL, &self.global, None),
            Quantity::measured(GLOBAL_SQUARE, &self.global_square, None),
            Quantity::measured(LOCAL, &self.local, None),
        ];
        Results { name: "psi6", quantities, curves: Vec::new() }
    }
}

/// Real and imaginary part of ψ₆ of a disc; zero without neighbours.
fn psi6(neighbours: &[Neighbour]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    let mut total = 0.0;
    for Neighbour { way, edge } in neighbours {
        let square = multiply(*way, *way);
        let [real, imaginary] = multiply(multiply(square, square), square);
        let norm = way[0] * way[0] + way[1] * way[1];
        let weight = edge / (norm * norm * norm);
        sum = [sum[0] + weight * real, sum[1] + weight * imaginary];
        total += edge;
    }
    if total > 0.0 { [sum[0] / total, sum[1] / total] } else { [0.0; 2] }
}

/// The product of complex numbers.
fn multiply(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

const GLOBAL: [&str; 3] = ["global", "1", "|mean of ψ₆ over the discs|: one orientation everywhere"];
const GLOBAL_SQUARE: [&str; 3] = ["global_square", "1", "|mean of ψ₆ over the discs|²"];
const LOCAL: [&str; 3] = ["local", "1", "mean of |ψ₆| over the discs: order about each"];
