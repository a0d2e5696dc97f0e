//! `[gas]`: many discs in a box of their own.

use super::{Axis, is_default};
use crate::scenario::gas::Made;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A gas: so many hard discs in a box. Lengths are in units of σ, the mean diameter, masses in units of m, energies in units
/// of kT.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// How many discs.
    #[schemars(range(min = 1, max = 100_000_000))]
    pub n: usize,
    /// The part of the box that discs cover, above 0 and below 1.
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 1.0))]
    pub packing_fraction: f64,
    /// Length over width of the box, from 0.001 to 1000; absent: 1, and for a lattice what suits it best.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub aspect: Option<f64>,
    /// Axes along which the box repeats itself, instead of having walls; absent: both.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("uniqueItems" = true))]
    pub periodic: Option<Vec<Axis>>,
    /// Where the discs start; absent: automatic.
    #[serde(default, skip_serializing_if = "is_default")]
    pub start: Start,
    /// Diameters and masses of the discs; absent: all of diameter 1 and mass 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sizes: Option<Sizes>,
    /// How velocities are drawn; absent: maxwell.
    #[serde(default, skip_serializing_if = "is_default")]
    pub velocities: Velocities,
    /// The temperature kT of the velocities; zero or positive; absent: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub temperature: Option<f64>,
    /// What all that is random is drawn from; absent: 0.
    #[serde(default, skip_serializing_if = "is_default")]
    #[schemars(range(max = 9_223_372_036_854_775_807_u64))]
    pub seed: u64,
    /// Where the discs are, once that has been asked for.
    #[serde(skip)]
    pub(in crate::scenario) made: Made,
}

/// Where the discs of a gas start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// What suits the density: random, then compressed, and for equal discs beyond freezing hexagonal.
    #[default]
    Automatic,
    /// On a square lattice.
    Square,
    /// On a hexagonal lattice.
    Hexagonal,
    /// One after another wherever there is room.
    Random,
    /// Placed at random as small discs that move, collide and grow.
    Compressed,
}

/// How the velocities of a gas are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Velocities {
    /// As in equilibrium: each component has a normal distribution.
    #[default]
    Maxwell,
    /// All discs equally fast, in random directions whose momenta sum to zero.
    EqualSpeed,
}

/// Diameters and masses of the discs of a gas: a list of species, or a distribution of diameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "distribution", rename_all = "snake_case", deny_unknown_fields)]
pub enum Sizes {
    /// Diameters equally likely from 1 − `half_width` to 1 + `half_width`.
    Uniform {
        /// Zero or more, below 1.
        #[schemars(range(min = 0.0))]
        half_width: f64,
        /// The masses that such discs have; absent: equal.
        #[serde(default, skip_serializing_if = "is_default")]
        masses: Masses,
    },
    /// A normal distribution of diameters, cut off on both sides.
    Normal {
        /// Standard deviation over mean, before the cut; zero or more, below 1/`truncation`.
        #[schemars(range(min = 0.0))]
        polydispersity: f64,
        /// Where it is cut off, in standard deviations from the mean, from 0.5 to 10; absent: 3.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(range(min = 0.5, max = 10.0))]
        truncation: Option<f64>,
        /// The masses that such discs have; absent: equal.
        #[serde(default, skip_serializing_if = "is_default")]
        masses: Masses,
    },
    /// The logarithm of the diameter has a normal distribution, cut off on both sides.
    LogNormal {
        /// Standard deviation over mean of the diameter, before the cut; from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        polydispersity: f64,
        /// Where the logarithm is cut off, in its standard deviations from its mean, from 0.5 to 10; absent: 3.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(range(min = 0.5, max = 10.0))]
        truncation: Option<f64>,
        /// The masses that such discs have; absent: equal.
        #[serde(default, skip_serializing_if = "is_default")]
        masses: Masses,
    },
    /// Several kinds of discs, mixed at random.
    #[serde(untagged)]
    Species(Mixture),
}

/// A gas of several kinds of discs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mixture {
    /// The kinds: each with a `fraction`, or each with a `number`.
    #[schemars(length(min = 1))]
    pub species: Vec<Species>,
}

/// One kind of discs of a gas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Species {
    /// The part of all discs that are of this kind, from 0 to 1, rounded to whole discs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub fraction: Option<f64>,
    /// How many discs are of this kind; or `fraction`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(max = 100_000_000))]
    pub number: Option<usize>,
    /// Diameter of each, from 1e-6 to 1e6; σ is the unit in which it is given.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub diameter: f64,
    /// Mass of each, from 1e-6 to 1e6; absent: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub mass: Option<f64>,
}

/// The masses of discs whose diameters come from a distribution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Masses {
    /// All have mass 1.
    #[default]
    Equal,
    /// In proportion to the area: d², so that a disc of diameter 1 has mass 1.
    Area,
}
