//! A gas turned into a table and balls.

use super::schema::{Axis, Ball, Gas, Masses, Mixture, Sizes, Species, Start, Table, Velocities};
use crate::gas::{self, Amount, Arrangement, Distribution, Recipe};
use std::sync::{Arc, Mutex, OnceLock, PoisonError, Weak};

/// How far from their mean diameters are cut off that do not say it, in standard deviations.
const TRUNCATION: f64 = 3.0;

/// What was made of a recipe, or why it could not be.
type Outcome = (Recipe, Result<gas::Start, gas::Error>);

/// The gas that was made last, as long as any scenario has it: a changed or copied scenario often has the same one.
static LATEST: Mutex<Weak<Outcome>> = Mutex::new(Weak::new());

/// What was made of a gas. It follows from the gas, so it takes no part in comparisons.
#[derive(Clone, Debug, Default)]
pub(super) struct Made(OnceLock<Arc<Outcome>>);

impl PartialEq for Made {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Gas {
    /// The table and the balls, or why there are none.
    pub(super) fn table_and_balls(&self) -> Result<(Table, Vec<Ball>), gas::Error> {
        let made = self.made();
        let start = made.1.as_ref().map_err(Clone::clone)?;
        let table =
            Table::plain_box(start.size, [Axis::X, Axis::Y].map(|axis| self.periodic().contains(&axis)));
        Ok((table, (0..start.positions.len()).map(|disc| ball(start, disc)).collect()))
    }

    /// The problem with this gas, if it cannot be made.
    pub(super) fn problem(&self) -> Option<gas::Error> {
        self.made().1.as_ref().err().cloned()
    }

    /// The axes along which the box repeats itself.
    pub(super) fn periodic(&self) -> &[Axis] {
        self.periodic.as_deref().unwrap_or(&[Axis::X, Axis::Y])
    }

    /// Takes seconds for many dense discs; so it is done once.
    fn made(&self) -> Arc<Outcome> {
        let recipe = self.recipe();
        let made = self.made.0.get_or_init(|| made_of(recipe.clone()));
        // The keys of a scenario may have been changed since.
        if made.0 == recipe { made.clone() } else { made_of(recipe) }
    }

    fn recipe(&self) -> Recipe {
        Recipe {
            count: self.n,
            packing_fraction: self.packing_fraction,
            aspect: self.aspect,
            periodic: [Axis::X, Axis::Y].map(|axis| self.periodic().contains(&axis)),
            sizes: self.sizes.as_ref().map_or(gas::Sizes::Equal, Sizes::recipe),
            start: self.start.recipe(),
            velocities: self.velocities.recipe(),
            temperature: self.temperature.unwrap_or(1.0),
            seed: self.seed,
        }
    }
}

fn made_of(recipe: Recipe) -> Arc<Outcome> {
    let latest = || LATEST.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(made) = latest().upgrade().filter(|made| made.0 == recipe) {
        return made;
    }
    let start = gas::make(&recipe);
    let made = Arc::new((recipe, start));
    *latest() = Arc::downgrade(&made);
    made
}

fn ball(start: &gas::Start, disc: usize) -> Ball {
    let (position, velocity) = (start.positions[disc], start.velocities[disc]);
    let (position, velocity) = ([position.x, position.y], [velocity.x, velocity.y]);
    Ball::disc(disc.to_string(), start.radii[disc], start.masses[disc], position, velocity)
}

impl Table {
    /// A box of walls and periodic sides, and nothing in it.
    pub(super) fn plain_box([width, length]: [f64; 2], periodic: [bool; 2]) -> Self {
        let axes = [Axis::X, Axis::Y].into_iter().zip(periodic);
        Self::Rectangle {
            width,
            length,
            periodic: axes.filter_map(|(axis, is_periodic)| is_periodic.then_some(axis)).collect(),
            obstacles: Vec::new(),
            nose_height: None,
            nose_contact: None,
            pockets: Vec::new(),
        }
    }
}

impl Ball {
    /// A disc of which everything is known.
    pub(super) fn disc(id: String, radius: f64, mass: f64, position: [f64; 2], velocity: [f64; 2]) -> Self {
        Self {
            id,
            radius: Some(radius),
            mass: Some(mass),
            sliding_friction: None,
            rolling_friction: None,
            spin_decay: None,
            position: Some(position.into()),
            velocity: Some(velocity.into()),
            spin: None,
            speed: None,
            direction_deg: None,
            color: None,
        }
    }
}

impl Sizes {
    fn recipe(&self) -> gas::Sizes {
        let cut = |truncation: &Option<f64>| truncation.unwrap_or(TRUNCATION);
        let (diameters, masses) = match self {
            Self::Species(Mixture { species }) => {
                return gas::Sizes::Species(species.iter().map(Species::recipe).collect());
            }
            Self::Uniform { half_width, masses } => {
                (Distribution::Uniform { half_width: *half_width }, masses)
            }
            Self::Normal { polydispersity, truncation, masses } => {
                let (polydispersity, truncation) = (*polydispersity, cut(truncation));
                (Distribution::Normal { polydispersity, truncation }, masses)
            }
            Self::LogNormal { polydispersity, truncation, masses } => {
                let (polydispersity, truncation) = (*polydispersity, cut(truncation));
                (Distribution::LogNormal { polydispersity, truncation }, masses)
            }
        };
        let masses = match masses {
            Masses::Equal => gas::Masses::Equal,
            Masses::Area => gas::Masses::Area,
        };
        gas::Sizes::Distribution { diameters, masses }
    }
}

impl Species {
    /// A check refuses a species that says how many it are in no way, or in two.
    fn recipe(&self) -> gas::Species {
        let fraction = Amount::Fraction(self.fraction.unwrap_or(0.0));
        let amount = self.number.map_or(fraction, Amount::Number);
        gas::Species { amount, diameter: self.diameter, mass: self.mass.unwrap_or(1.0) }
    }
}

impl Start {
    fn recipe(self) -> Arrangement {
        match self {
            Self::Automatic => Arrangement::Automatic,
            Self::Square => Arrangement::Square,
            Self::Hexagonal => Arrangement::Hexagonal,
            Self::Random => Arrangement::Random,
            Self::Compressed => Arrangement::Compressed,
        }
    }
}

impl Velocities {
    fn recipe(self) -> gas::Velocities {
        match self {
            Self::Maxwell => gas::Velocities::Maxwell,
            Self::EqualSpeed => gas::Velocities::EqualSpeed,
        }
    }
}
