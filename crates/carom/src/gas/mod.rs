//! The start of a gas of hard discs: a box, places without overlap, velocities.
//!
//! ```
//! use carom::gas::{Arrangement, Recipe, make};
//!
//! let start = make(&Recipe { seed: 7, ..Recipe::new(1000, 0.3) })?;
//! assert_eq!(start.positions.len(), 1000);
//! assert_eq!(start.arrangement, Arrangement::Random);
//! # Ok::<(), carom::gas::Error>(())
//! ```

mod cells;
mod check;
mod compression;
mod error;
mod lattice;
mod normal;
mod order;
mod random_placement;
mod recipe;
mod sizes;
mod space;
mod sum;
mod velocities;

pub use error::Error;
pub use recipe::{Amount, Arrangement, Distribution, Masses, Recipe, Sizes, Species, Velocities};
pub use velocities::maxwell;

use crate::geometry::Vec2;
use crate::random::Random;
pub use space::PERIODIC_DIAMETERS;
use space::Space;

/// Up to this packing fraction an automatic start is random: there it takes a few trials for each disc.
const AUTOMATIC_RANDOM: f64 = 0.4;

/// Beyond this packing fraction equal discs are solid, and an automatic start is their crystal.
const SOLID: f64 = 0.72;

/// The start of a gas. Discs come row by row, so that those which meet lie near each other in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// Width and length of the box, which has a corner in the origin.
    pub size: [f64; 2],
    /// Centres. No two discs overlap by more than 1e-12 diameters.
    pub positions: Vec<Vec2<f64>>,
    /// Velocities, with the temperature that was asked for.
    pub velocities: Vec<Vec2<f64>>,
    /// Radii.
    pub radii: Vec<f64>,
    /// Masses.
    pub masses: Vec<f64>,
    /// How the discs were placed: what an automatic start took.
    pub arrangement: Arrangement,
}

/// Where the discs are.
struct Arranged {
    space: Space,
    places: Vec<Vec2<f64>>,
    arrangement: Arrangement,
}

/// What arranging needs to know about the discs of a recipe.
struct Request<'a> {
    recipe: &'a Recipe,
    radii: &'a [f64],
    /// The area that they cover.
    covered: f64,
    /// The largest diameter.
    diameter: f64,
}

/// Makes the start of a gas.
///
/// Equal recipes give equal bits on every platform.
///
/// # Errors
///
/// [`Error`] for what makes no sense, and for a packing fraction that the start asked for does not reach.
pub fn make(recipe: &Recipe) -> Result<Start, Error> {
    check::check(recipe)?;
    let discs = sizes::discs(recipe);
    let radii: Vec<f64> = discs.iter().map(|disc| disc.radius).collect();
    let request = Request::new(recipe, &radii);
    let Arranged { space, places, arrangement } = request.arrange(recipe.start)?;
    let order = order::row_by_row(space, request.diameter, &places);
    let masses: Vec<f64> = order.iter().map(|disc| discs[*disc].mass).collect();
    Ok(Start {
        size: space.size,
        positions: order.iter().map(|disc| places[*disc]).collect(),
        velocities: velocities::drawn(&masses, recipe)?,
        radii: order.iter().map(|disc| radii[*disc]).collect(),
        masses,
        arrangement,
    })
}

impl<'a> Request<'a> {
    fn new(recipe: &'a Recipe, radii: &'a [f64]) -> Self {
        let squares = sum::sum(radii.iter().map(|radius| radius * radius));
        let largest = radii.iter().copied().fold(0.0, f64::max);
        Self { recipe, radii, covered: core::f64::consts::PI * squares, diameter: 2.0 * largest }
    }

    fn arrange(&self, arrangement: Arrangement) -> Result<Arranged, Error> {
        let (space, places) = match arrangement {
            Arrangement::Square => self.on_lattice(lattice::Kind::Square)?,
            Arrangement::Hexagonal => self.on_lattice(lattice::Kind::Hexagonal)?,
            Arrangement::Random => self.at_random()?,
            Arrangement::Compressed => self.compressed()?,
            Arrangement::Automatic => return self.automatic(),
        };
        Ok(Arranged { space, places, arrangement })
    }

    /// What suits the density, and where that does not fit into this box, the compressed start.
    fn automatic(&self) -> Result<Arranged, Error> {
        let (fraction, is_equal) = (self.recipe.packing_fraction, self.recipe.sizes == Sizes::Equal);
        let first = match fraction {
            _ if fraction <= AUTOMATIC_RANDOM => Arrangement::Random,
            _ if fraction > SOLID && is_equal => Arrangement::Hexagonal,
            _ => return self.arrange(Arrangement::Compressed),
        };
        self.arrange(first).or_else(|_| self.arrange(Arrangement::Compressed))
    }

    /// The box of the recipe, its aspect 1 where it gives none.
    fn space(&self) -> Result<Space, Error> {
        let area = self.covered / self.recipe.packing_fraction;
        let space = Space::of_area(area, self.recipe.aspect.unwrap_or(1.0), self.recipe.periodic);
        space.check_room_for(self.diameter)?;
        Ok(space)
    }

    fn on_lattice(&self, kind: lattice::Kind) -> Result<(Space, Vec<Vec2<f64>>), Error> {
        lattice::places(self.recipe, kind, self.covered, self.diameter)
    }

    fn at_random(&self) -> Result<(Space, Vec<Vec2<f64>>), Error> {
        let Recipe { count, packing_fraction: got, seed, .. } = *self.recipe;
        if got > random_placement::MOST {
            return Err(Error::BeyondRandom { got });
        }
        let space = self.space()?;
        let mut random = Random::new(seed, "gas.places");
        let places = random_placement::places(space, self.radii, &mut random);
        Ok((space, places.map_err(|placed| Error::NoRoom { placed, count })?))
    }

    fn compressed(&self) -> Result<(Space, Vec<Vec2<f64>>), Error> {
        let Recipe { packing_fraction: asked, seed, .. } = *self.recipe;
        let space = self.space()?;
        let jammed = |scale: f64| Error::Jammed { reached: asked * scale * scale, asked };
        let places = compression::places(space, self.radii, asked, seed).map_err(jammed)?;
        Ok((space, places))
    }
}
