//! What the tests of gases share.

use carom::gas::{Amount, Arrangement, Error, Recipe, Sizes, Species, Start, make};

/// The largest overlap, in diameters of the smaller disc, that a start may have.
pub const ROUNDING: f64 = 1e-12;

/// The recipe of equal discs with a start.
pub fn recipe(count: usize, packing_fraction: f64, start: Arrangement) -> Recipe {
    Recipe { start, seed: 1, ..Recipe::new(count, packing_fraction) }
}

/// Half small discs and half large ones, 1.4 times as large: the usual mixture that does not crystallise.
pub fn bidisperse() -> Sizes {
    let half = |diameter, mass| Species { amount: Amount::Fraction(0.5), diameter, mass };
    Sizes::Species(vec![half(1.0, 1.0), half(1.4, 2.0)])
}

/// Makes a start, which must succeed, and checks what must hold of every start.
pub fn made(recipe: &Recipe) -> Start {
    let start = make(recipe).unwrap_or_else(|error| panic!("{recipe:?}: {error}"));
    check(recipe, &start);
    start
}

/// Checks what must hold of every start.
pub fn check(recipe: &Recipe, start: &Start) {
    let lengths = [start.positions.len(), start.velocities.len(), start.radii.len(), start.masses.len()];
    assert_eq!(lengths, [recipe.count; 4], "{recipe:?}");
    assert!(start.positions.iter().chain(&start.velocities).all(|v| v.is_finite()), "{recipe:?}");
    let covered: f64 = start.radii.iter().map(|r| core::f64::consts::PI * r * r).sum();
    let fraction = covered / (start.size[0] * start.size[1]);
    // The sum here is a plain one, with the rounding of so many terms.
    let rounding = 1e-14 * (1.0 + 0.02 * recipe.count as f64);
    assert!((fraction / recipe.packing_fraction - 1.0).abs() < rounding, "{recipe:?}: {fraction}");
    let overlap = deepest_overlap(recipe, start);
    assert!(overlap <= ROUNDING, "{recipe:?}: overlap {overlap:e}");
}

/// The deepest overlap of two discs, or of a disc and a wall, over the smaller disc's diameter, by a sweep across the box.
///
/// Independent of the code under test: discs are sorted by their left edges, images of those near the sides included.
pub fn deepest_overlap(recipe: &Recipe, start: &Start) -> f64 {
    let largest = start.radii.iter().copied().fold(0.0, f64::max);
    let mut discs: Vec<[f64; 3]> = Vec::new();
    let mut deepest = f64::NEG_INFINITY;
    for (place, radius) in start.positions.iter().zip(&start.radii) {
        let images = |axis: usize, along: f64| -> Vec<f64> {
            let size = start.size[axis];
            let near = |image: f64| image > -3.0 * largest && image < size + 3.0 * largest;
            let shifts: &[f64] = if recipe.periodic[axis] { &[-1.0, 0.0, 1.0] } else { &[0.0] };
            shifts.iter().map(|shift| along + shift * size).filter(|image| near(*image)).collect()
        };
        for x in images(0, place.x) {
            discs.extend(images(1, place.y).into_iter().map(|y| [x, y, *radius]));
        }
        for (axis, along) in [(0, place.x), (1, place.y)] {
            let size = start.size[axis];
            if recipe.periodic[axis] {
                assert!((0.0..size).contains(&along), "{recipe:?}: {along} is outside of 0 to {size}");
            } else {
                let into_walls = (radius - along).max(along + radius - size);
                deepest = deepest.max(into_walls / (2.0 * radius));
            }
        }
    }
    discs.sort_by(|a, b| (a[0] - a[2]).total_cmp(&(b[0] - b[2])));
    for (number, [x, y, radius]) in discs.iter().enumerate() {
        let reached = discs[number + 1..].iter().take_while(|other| other[0] - other[2] <= x + radius);
        for other in reached {
            let [across, along] = [other[0] - x, other[1] - y];
            let depth = radius + other[2] - (across * across + along * along).sqrt();
            deepest = deepest.max(depth / (2.0 * radius.min(other[2])));
        }
    }
    deepest
}

/// Whether an error says that this box is too small for what is asked, which no start could change.
pub fn is_of_the_box(error: &Error) -> bool {
    matches!(error, Error::PeriodicTooNarrow { .. } | Error::DiscTooLarge { .. })
}
