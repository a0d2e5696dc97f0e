//! Starts on a lattice: columns and rows of places, spread over the whole box.
//!
//! Square and hexagonal lattices differ in two numbers: how far every other row is shifted, and how far rows are apart. A
//! count that does not fill the lattice leaves vacancies at random places. Without a given aspect the lattice is perfect
//! and the box follows it: of the lattices whose aspect is between 1/2 and 2 that with the fewest vacancies, then the
//! squarest. With a given aspect the lattice is stretched to the box: that with the largest distance between neighbours.
//! Between walls the gap to them is like that between neighbours, so that a tight lattice touches them. Discs of several
//! sizes need a lattice with room for the largest everywhere.

use super::error::Error;
use super::recipe::{Arrangement, Recipe};
use super::space::Space;
use crate::geometry::Vec2;
use crate::random::Random;

/// Overlaps up to this part of a diameter are rounding.
const ROUNDING: f64 = 1e-12;

/// The height of an equilateral triangle with sides of one.
const TRIANGLE: f64 = 0.866_025_403_784_438_6;

/// The aspects between which the lattice with the fewest vacancies is taken.
const ASPECTS: [f64; 2] = [0.5, 2.0];

/// A kind of lattice.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Square,
    Hexagonal,
}

/// A lattice of so many columns and rows of discs with this diameter.
#[derive(Clone, Copy, Debug)]
struct Lattice {
    kind: Kind,
    columns: usize,
    rows: usize,
    diameter: f64,
    periodic: [bool; 2],
}

/// Where places along an axis are: the first, and the distance to the next.
#[derive(Clone, Copy, Debug)]
struct Spread {
    first: f64,
    spacing: f64,
}

/// The box and the places of a recipe's discs, which cover this area and of which the largest has this diameter.
pub(super) fn places(
    recipe: &Recipe,
    kind: Kind,
    covered: f64,
    diameter: f64,
) -> Result<(Space, Vec<Vec2<f64>>), Error> {
    let area = covered / recipe.packing_fraction;
    let (space, lattice) = match recipe.aspect {
        Some(aspect) => {
            let space = Space::of_area(area, aspect, recipe.periodic);
            space.check_room_for(diameter)?;
            (space, stretched(kind, recipe.count, &space, diameter))
        }
        None => {
            let lattice = perfect(kind, recipe, diameter);
            let space = lattice.space(area).ok_or_else(|| lattice.beyond(recipe, covered))?;
            space.check_room_for(diameter)?;
            (space, lattice)
        }
    };
    let spacing = lattice.closest(&space);
    if spacing < diameter * (1.0 - ROUNDING) {
        let (lattice, count) = (kind.name(), recipe.count);
        return Err(Error::LatticeTooDense { lattice, count, spacing, diameter });
    }
    Ok((space, lattice.occupied(&space, recipe)))
}

/// The lattice with the fewest vacancies, then the squarest, in a box that follows it.
fn perfect(kind: Kind, recipe: &Recipe, diameter: f64) -> Lattice {
    let merit = |lattice: &Lattice| {
        let aspect = lattice.rows as f64 * kind.row_spacing() / lattice.columns as f64;
        let skew = if aspect > 1.0 { aspect } else { 1.0 / aspect };
        let is_long = !(ASPECTS[0]..=ASPECTS[1]).contains(&aspect);
        let vacancies = (lattice.columns * lattice.rows - recipe.count) as f64;
        if is_long { [1.0, skew, vacancies] } else { [0.0, vacancies, skew] }
    };
    best(kind, recipe.count, diameter, recipe.periodic, merit)
}

/// The lattice whose neighbours are furthest apart in a given box.
fn stretched(kind: Kind, count: usize, space: &Space, diameter: f64) -> Lattice {
    best(kind, count, diameter, space.periodic, |lattice| [-lattice.closest(space), 0.0, 0.0])
}

/// Of the lattices with places enough the first with the least of something.
fn best(
    kind: Kind,
    count: usize,
    diameter: f64,
    periodic: [bool; 2],
    least: impl Fn(&Lattice) -> [f64; 3],
) -> Lattice {
    let step = kind.rows_of_a_period(periodic);
    let with = |rows: usize| Lattice { kind, columns: count.div_ceil(rows), rows, diameter, periodic };
    let mut best = with(step);
    let mut best_merit = least(&best);
    for lattice in (2 * step..=count).step_by(step).map(with) {
        let merit = least(&lattice);
        if merit < best_merit {
            (best, best_merit) = (lattice, merit);
        }
    }
    best
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Square => Arrangement::Square.name(),
            Self::Hexagonal => Arrangement::Hexagonal.name(),
        }
    }

    /// Distance of rows over that of columns in the perfect lattice.
    fn row_spacing(self) -> f64 {
        match self {
            Self::Square => 1.0,
            Self::Hexagonal => TRIANGLE,
        }
    }

    /// How far every other row is shifted, in spacings.
    fn shift(self) -> f64 {
        match self {
            Self::Square => 0.0,
            Self::Hexagonal => 0.5,
        }
    }

    /// What the number of rows must be a multiple of.
    fn rows_of_a_period(self, periodic: [bool; 2]) -> usize {
        match self {
            Self::Hexagonal if periodic[1] => 2,
            _ => 1,
        }
    }
}

impl Lattice {
    /// Places along an axis, in spacings from the first to the last.
    fn steps(&self, axis: usize) -> f64 {
        let shift = if self.rows > 1 { self.kind.shift() } else { 0.0 };
        [self.columns as f64 - 1.0 + shift, self.rows as f64 - 1.0][axis]
    }

    /// The spacing along an axis where neighbours touch.
    fn tight(&self, axis: usize) -> f64 {
        self.diameter * [1.0, self.kind.row_spacing()][axis]
    }

    /// The size of the box along an axis is the first of these, and as many times the second as neighbours of the perfect
    /// lattice have gaps between them, in diameters.
    fn size_and_growth(&self, axis: usize) -> [f64; 2] {
        let tight = self.tight(axis);
        if self.periodic[axis] {
            let size = [self.columns, self.rows][axis] as f64 * tight;
            [size, size]
        } else {
            let steps = self.steps(axis);
            [self.diameter + steps * tight, (steps + 2.0) * tight]
        }
    }

    /// The box of this area that the perfect lattice fits into; `None` where it would be too tight.
    fn space(&self, area: f64) -> Option<Space> {
        let [[width, wider], [length, longer]] = [0, 1].map(|axis| self.size_and_growth(axis));
        let rest = area - width * length;
        if rest < -ROUNDING * area {
            return None;
        }
        // (width + wider g)(length + longer g) = area, with the gap g ≥ 0 in diameters.
        let rest = rest.max(0.0);
        let linear = width * longer + wider * length;
        let gap = 2.0 * rest / (linear + (linear * linear + 4.0 * wider * longer * rest).sqrt());
        let width = width + wider * gap;
        Some(Space { size: [width, area / width], periodic: self.periodic })
    }

    fn beyond(&self, recipe: &Recipe, covered: f64) -> Error {
        let [[width, _], [length, _]] = [0, 1].map(|axis| self.size_and_growth(axis));
        Error::BeyondLattice {
            lattice: self.kind.name(),
            count: recipe.count,
            columns: self.columns,
            rows: self.rows,
            most: covered / (width * length),
            got: recipe.packing_fraction,
        }
    }

    /// How the places lie along an axis of a box.
    fn spread(&self, space: &Space, axis: usize) -> Spread {
        let (size, steps, tight) = (space.size[axis], self.steps(axis), self.tight(axis));
        if space.periodic[axis] {
            let spacing = size / [self.columns, self.rows][axis] as f64;
            // As far from the lower side as the last place, shifted, is from the upper one.
            let shift = [self.kind.shift(), 0.0][axis];
            return Spread { first: 0.5 * (1.0 - shift) * spacing, spacing };
        }
        let room = size - self.diameter;
        let spacing = (room + 2.0 * tight) / (steps + 2.0);
        if spacing >= tight || steps == 0.0 {
            Spread { first: 0.5 * self.diameter + (spacing - tight), spacing }
        } else {
            Spread { first: 0.5 * self.diameter, spacing: room / steps }
        }
    }

    /// The least distance between neighbours.
    fn closest(&self, space: &Space) -> f64 {
        let [x, y] = [0, 1].map(|axis| self.spread(space, axis).spacing);
        match self.kind {
            Kind::Square => x.min(y),
            Kind::Hexagonal => x.min((0.25 * x * x + y * y).sqrt()).min(2.0 * y),
        }
    }

    /// The places that are taken, row by row.
    fn occupied(&self, space: &Space, recipe: &Recipe) -> Vec<Vec2<f64>> {
        let mut is_taken = vec![true; self.columns * self.rows];
        let vacancies = is_taken.len() - recipe.count;
        is_taken[..vacancies].fill(false);
        if vacancies > 0 {
            Random::new(recipe.seed, "gas.lattice.vacancies").shuffle(&mut is_taken);
        }
        let [across, along] = [0, 1].map(|axis| self.spread(space, axis));
        let place = |site: usize| {
            let (row, column) = (site / self.columns, site % self.columns);
            let shift = if row % 2 == 1 { self.kind.shift() } else { 0.0 };
            let x = across.first + (column as f64 + shift) * across.spacing;
            Vec2::new(x, along.first + row as f64 * along.spacing)
        };
        (0..is_taken.len()).filter(|site| is_taken[*site]).map(place).collect()
    }
}
