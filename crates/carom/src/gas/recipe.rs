//! What a gas is made of, as people ask for it.

/// A gas of hard discs in a box.
///
/// Lengths are in units of σ, the mean diameter of the discs, masses in units of m, energies in units of kT. A list of
/// species is taken as it is written: σ is then the unit in which its diameters are given.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// How many discs.
    pub count: usize,
    /// The part of the box that discs cover: Σ π r² over width times length. Walls stand where the discs' edges bounce.
    pub packing_fraction: f64,
    /// Length over width of the box. `None`: 1, and for a lattice what suits it best.
    pub aspect: Option<f64>,
    /// Whether the box repeats itself across its width and along its length; where not, it has walls.
    pub periodic: [bool; 2],
    /// Diameters and masses.
    pub sizes: Sizes,
    /// Where the discs start.
    pub start: Arrangement,
    /// How velocities are drawn.
    pub velocities: Velocities,
    /// The temperature kT, from zero on.
    pub temperature: f64,
    /// Everything random comes from this.
    pub seed: u64,
}

/// Diameters and masses of the discs.
#[derive(Clone, Debug, PartialEq)]
pub enum Sizes {
    /// Diameter 1 and mass 1.
    Equal,
    /// Several kinds of discs, mixed at random.
    Species(Vec<Species>),
    /// Diameters drawn from a distribution, then divided by their mean, which so is 1.
    Distribution {
        /// Of the diameters.
        diameters: Distribution,
        /// What masses such discs have.
        masses: Masses,
    },
}

/// One kind of discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Species {
    /// How many.
    pub amount: Amount,
    /// Diameter of each.
    pub diameter: f64,
    /// Mass of each.
    pub mass: f64,
}

/// How many discs of a species there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// A fraction of all discs, rounded to whole discs.
    Fraction(f64),
    /// A number of discs.
    Number(usize),
}

/// A distribution of diameters with mean 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Equally likely from 1 − `half_width` to 1 + `half_width`.
    Uniform {
        /// Zero or more, below 1.
        half_width: f64,
    },
    /// A normal distribution, cut off on both sides.
    Normal {
        /// Standard deviation over mean, before the cut.
        polydispersity: f64,
        /// Where it is cut off, in standard deviations from the mean.
        truncation: f64,
    },
    /// The logarithm of the diameter has a normal distribution, cut off on both sides.
    LogNormal {
        /// Standard deviation over mean of the diameter, before the cut.
        polydispersity: f64,
        /// Where the logarithm is cut off, in its standard deviations from its mean.
        truncation: f64,
    },
}

/// The masses of discs whose diameters come from a distribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Masses {
    /// All have mass 1.
    Equal,
    /// In proportion to the area: d², so that a disc of diameter 1 has mass 1.
    Area,
}

/// Where the discs of a gas start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// On a square lattice.
    Square,
    /// On a hexagonal lattice.
    Hexagonal,
    /// One after another wherever there is room: random sequential placement.
    Random,
    /// Placed at random as small discs that move, collide and grow.
    Compressed,
    /// What suits the density: random, then compressed, and for equal discs beyond freezing the hexagonal lattice.
    Automatic,
}

/// How the velocities of a gas are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Velocities {
    /// As in equilibrium.
    Maxwell,
    /// All discs equally fast, in random directions without total momentum.
    EqualSpeed,
}

impl Recipe {
    /// A gas of equal discs in a periodic square box.
    pub fn new(count: usize, packing_fraction: f64) -> Self {
        Self {
            count,
            packing_fraction,
            aspect: None,
            periodic: [true, true],
            sizes: Sizes::Equal,
            start: Arrangement::Automatic,
            velocities: Velocities::Maxwell,
            temperature: 1.0,
            seed: 0,
        }
    }
}

impl Arrangement {
    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::Square => "square",
            Self::Hexagonal => "hexagonal",
            Self::Random => "random",
            Self::Compressed => "compressed",
            Self::Automatic => "automatic",
        }
    }
}
