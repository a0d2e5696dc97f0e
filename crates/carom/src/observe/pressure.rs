//! Temperature and pressure: from the collisions (the virial) and from the walls.
//!
//! Z = PA/(N kT) = 1 + Σ J (r_a + r_b)/(2 N kT t) over the collisions of a time t, with impulses J. Independently, the
//! walls feel ΣJ over their length and t. In a box with walls the two differ: centres keep a radius r from a wall, so
//! that in a square of side L the wall's Z is the virial's times L/(L − 2r), and both hold effects of the walls. The
//! walls are the sides of the rectangle; impulses at anything else that stands in it would be taken for theirs.

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::results::{Quantity, Results};
use super::snapshot::{Gas, Moment};
use serde::{Deserialize, Serialize};

/// Temperature and pressure.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Pressure {
    temperature: Blocks,
    /// Σ J (r_a + r_b) over 2 N kT t.
    excess: Blocks,
    virial: Blocks,
    wall: Blocks,
    wall_compressibility: Blocks,
}

impl Measure for Pressure {
    fn sample(&mut self, Moment { gas, heat, interval, .. }: &Moment) {
        self.temperature.push(heat.temperature);
        let Some(interval) = interval else { return };
        let thermal = gas.count * interval.temperature * interval.duration;
        self.excess.push_ratio(interval.virial, 2.0 * thermal);
        self.virial.push_ratio(thermal + 0.5 * interval.virial, gas.area() * interval.duration);
        let (area, wall) = (gas.area(), gas.wall_length());
        if wall > 0.0 {
            self.wall.push_ratio(interval.wall_impulse, wall * interval.duration);
            self.wall_compressibility.push_ratio(area * interval.wall_impulse, wall * thermal);
        }
    }

    fn results(&self, gas: &Gas, _: &EventSums) -> Results {
        let expected = gas.expected_compressibility();
        let density = gas.count / gas.area();
        let pressure =
            expected.zip(self.temperature.value()).map(|(z, temperature)| z * density * temperature);
        let mut quantities = vec![
            Quantity::measured(TEMPERATURE, &self.temperature, None),
            Quantity::measured(COMPRESSIBILITY, &self.excess, expected).plus(1.0),
            Quantity::measured(VIRIAL, &self.virial, pressure),
        ];
        if gas.wall_length() > 0.0 {
            quantities.push(Quantity::measured(WALL, &self.wall, pressure));
            quantities.push(Quantity::measured(WALL_COMPRESSIBILITY, &self.wall_compressibility, expected));
        }
        quantities.push(Quantity::known(FREEDOM, gas.freedom));
        quantities.push(Quantity::known(PACKING, gas.packing_fraction));
        Results { name: "pressure", quantities, curves: Vec::new() }
    }
}

pub(super) const TEMPERATURE: [&str; 3] = [
    "temperature",
    "energy",
    "kT: twice the kinetic energy per degree of freedom, about the drift along periodic axes",
];
const COMPRESSIBILITY: [&str; 3] = [
    "compressibility_factor",
    "1",
    "Z = PA/(N kT) from collisions; expected by the equation of state of Kolafa and Rottner",
];
const VIRIAL: [&str; 3] =
    ["virial_pressure", "energy/length^2", "from collisions; expected by the equation of state"];
const WALL: [&str; 3] = [
    "wall_pressure",
    "energy/length^2",
    "impulse at the walls per length and time; expected by the equation of state, without effects of walls",
];
const WALL_COMPRESSIBILITY: [&str; 3] = [
    "wall_compressibility_factor",
    "1",
    "PA/(N kT) of the wall pressure; expected by the equation of state, without effects of walls",
];
const FREEDOM: [&str; 3] = [
    "degrees_of_freedom",
    "1",
    "two for each disc, less one for each periodic axis: the finite-size correction of the temperature",
];
const PACKING: [&str; 3] = ["packing_fraction", "1", "covered part of the area"];
