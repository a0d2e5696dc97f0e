//! Why a gas cannot be made.

use thiserror::Error;

/// What is wrong with a recipe: where, and what is allowed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Error {
    /// A number outside its range.
    #[error("{key}: must be {allowed}, got {got}")]
    Number {
        /// The key, as a recipe spells it.
        key: String,
        /// What it may be.
        allowed: &'static str,
        /// What it is.
        got: f64,
    },
    /// A list of species without one.
    #[error("sizes.species: must have one species at least")]
    NoSpecies,
    /// Species that say how many they are in two ways.
    #[error("sizes.species: all must give a fraction, or all a number")]
    MixedAmounts,
    /// Fractions that leave some discs out.
    #[error("sizes.species: the fractions must sum to 1, these sum to {sum}")]
    Fractions {
        /// Their sum.
        sum: f64,
    },
    /// Numbers that are not those of all discs.
    #[error("sizes.species: the numbers must sum to n = {count}, these sum to {sum}")]
    Numbers {
        /// Their sum.
        sum: usize,
        /// The number of all discs.
        count: usize,
    },
    /// More than close packing.
    #[error("packing_fraction: equal discs fill at most π/(2√3) = 0.9069 of the plane, got {got}")]
    BeyondClosePacking {
        /// The packing fraction asked for.
        got: f64,
    },
    /// A box with no room for the largest disc between its walls.
    #[error(
        "packing_fraction: the {side} of the box is {diameters:.4} diameters of the largest disc, less than one; take a \
         lower packing_fraction, more discs or another aspect"
    )]
    DiscTooLarge {
        /// `width` or `length`.
        side: &'static str,
        /// Its size, in diameters of the largest disc.
        diameters: f64,
    },
    /// A periodic box in which a disc would meet its own images.
    #[error(
        "periodic: the {side} of the box is {diameters:.4} diameters of the largest disc, and a periodic one must be more \
         than 3; take more discs, a lower packing_fraction, another aspect or walls"
    )]
    PeriodicTooNarrow {
        /// `width` or `length`.
        side: &'static str,
        /// Its size, in diameters of the largest disc.
        diameters: f64,
    },
    /// A lattice in a box of given aspect whose neighbours would overlap.
    #[error(
        "packing_fraction: {count} discs on a {lattice} lattice in a box of this aspect would be {spacing:.6} apart, less \
         than the largest diameter, {diameter}; take a lower packing_fraction, another n, or no aspect, which then \
         follows the lattice"
    )]
    LatticeTooDense {
        /// The lattice's name.
        lattice: &'static str,
        /// How many discs.
        count: usize,
        /// How far neighbours would be apart.
        spacing: f64,
        /// The largest diameter.
        diameter: f64,
    },
    /// A lattice that fills less, at its tightest, than what is asked for.
    #[error(
        "packing_fraction: {count} discs on a {lattice} lattice of {columns} columns and {rows} rows fill {most:.6} at \
         most, got {got}"
    )]
    BeyondLattice {
        /// The lattice's name.
        lattice: &'static str,
        /// How many discs.
        count: usize,
        /// Columns of the lattice.
        columns: usize,
        /// Its rows.
        rows: usize,
        /// What it fills when neighbours touch.
        most: f64,
        /// The packing fraction asked for.
        got: f64,
    },
    /// More than random sequential placement reaches.
    #[error(
        "packing_fraction: start = \"random\" reaches 0.5 (placed one by one, equal discs jam at 0.547), got {got}; start = \
         \"compressed\" goes further"
    )]
    BeyondRandom {
        /// The packing fraction asked for.
        got: f64,
    },
    /// Discs of which one has more momentum than all the others can balance at the same speed.
    #[error(
        "velocities: equal_speed needs momenta that can sum to zero: two discs or more, none of them heavier than all \
         the others together"
    )]
    NoBalance,
    /// Random sequential placement that found no place for some discs.
    #[error(
        "packing_fraction: start = \"random\" placed {placed} of {count} discs at most, then found no more room; take a \
         lower packing_fraction, or start = \"compressed\""
    )]
    NoRoom {
        /// How many found a place, in the best of several trials.
        placed: usize,
        /// How many there are.
        count: usize,
    },
    /// Discs that jammed before they had grown up.
    #[error("packing_fraction: start = \"compressed\" jammed at {reached:.4}, before the {asked} asked for")]
    Jammed {
        /// The packing fraction that was reached.
        reached: f64,
        /// The packing fraction asked for.
        asked: f64,
    },
}
