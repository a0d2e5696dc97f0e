//! How often discs collide, and the pressure that goes with it.
//!
//! For smooth elastic equal discs w = (4/√π)(Z − 1) in units of √(kT/m)/σ, without a free parameter: collisions counted
//! against momentum exchanged. With C collisions of N discs in a time t each disc has w = 2 C/(N t).

use super::blocks::Blocks;
use super::events::EventSums;
use super::observable::Measure;
use super::results::{Quantity, Results};
use super::snapshot::{Gas, Moment};
use super::state_equation::rate_per_excess;
use serde::{Deserialize, Serialize};

/// Collisions of discs with each other.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct CollisionRate {
    per_time: Blocks,
    per_disc: Blocks,
    /// In units of √(kT/m)/σ.
    reduced: Blocks,
    /// Z − 1 of the virial, over the same intervals.
    excess: Blocks,
}

impl Measure for CollisionRate {
    fn sample(&mut self, Moment { gas, interval, .. }: &Moment) {
        let Some(interval) = interval else { return };
        let disc_time = gas.count * interval.duration;
        let speed = (interval.temperature / gas.mass).sqrt();
        self.per_time.push_ratio(interval.collisions, interval.duration);
        self.per_disc.push_ratio(2.0 * interval.collisions, disc_time);
        self.reduced.push_ratio(2.0 * interval.collisions * gas.diameter, disc_time * speed);
        self.excess.push_ratio(interval.virial, 2.0 * disc_time * interval.temperature);
    }

    fn results(&self, gas: &Gas, _: &EventSums) -> Results {
        let expected = gas.expected_collision_rate();
        let expected_z = gas.expected_compressibility();
        let mut quantities = vec![
            Quantity::measured(PER_TIME, &self.per_time, None),
            Quantity::measured(PER_DISC, &self.per_disc, None),
        ];
        // The others are relations of equal discs.
        if gas.is_uniform() {
            quantities.extend([
                Quantity::measured(REDUCED, &self.reduced, expected),
                Quantity::measured(FROM_PRESSURE, &self.excess, expected).times(rate_per_excess()),
                Quantity::measured(Z, &self.reduced, expected_z).times(1.0 / rate_per_excess()).plus(1.0),
            ]);
        }
        Results { name: "collision_rate", quantities, curves: Vec::new() }
    }
}

const PER_TIME: [&str; 3] = ["collisions_per_time", "1/time", "collisions of all discs with each other"];
const PER_DISC: [&str; 3] = ["collision_rate", "1/time", "collisions of a disc with others"];
const REDUCED: [&str; 3] = [
    "reduced_collision_rate",
    "1",
    "collision rate of a disc times σ/√(kT/m); expected by the equation of state",
];
const FROM_PRESSURE: [&str; 3] = [
    "reduced_rate_from_pressure",
    "1",
    "(4/√π)(Z − 1) with Z from the virial: what the reduced collision rate of equal elastic discs is",
];
const Z: [&str; 3] = [
    "compressibility_factor",
    "1",
    "1 + (√π/4) × reduced collision rate: Z from counting; expected by the equation of state",
];
