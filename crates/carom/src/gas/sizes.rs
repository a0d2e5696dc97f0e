//! Radii and masses of the discs, in random order.

use super::normal::truncated_normal;
use super::recipe::{Amount, Distribution, Masses, Recipe, Sizes, Species};
use super::sum::sum;
use crate::random::Random;
use crate::scalar::{Scalar, ln};

/// A disc that has no place yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    pub radius: f64,
    pub mass: f64,
}

/// The discs of a recipe that was checked.
pub(super) fn discs(recipe: &Recipe) -> Vec<Disc> {
    match &recipe.sizes {
        Sizes::Equal => vec![Disc { radius: 0.5, mass: 1.0 }; recipe.count],
        Sizes::Species(species) => mixed(species, recipe),
        Sizes::Distribution { diameters, masses } => drawn(diameters, *masses, recipe),
    }
}

/// Discs of several kinds, each order equally likely.
fn mixed(species: &[Species], recipe: &Recipe) -> Vec<Disc> {
    let numbers = numbers(species, recipe.count);
    let kinds = species.iter().map(|one| Disc { radius: one.diameter / 2.0, mass: one.mass });
    let mut discs: Vec<Disc> =
        kinds.zip(numbers).flat_map(|(disc, number)| core::iter::repeat_n(disc, number)).collect();
    Random::new(recipe.seed, "gas.sizes.order").shuffle(&mut discs);
    discs
}

/// How many of each kind: fractions are rounded where their running sum stands, so that no disc is left out.
fn numbers(species: &[Species], count: usize) -> Vec<usize> {
    let (mut running, mut given) = (0.0, 0);
    let last = species.len().saturating_sub(1);
    let number = |(place, one): (usize, &Species)| match one.amount {
        Amount::Number(number) => number,
        Amount::Fraction(fraction) => {
            running += fraction;
            let upto = if place == last { count } else { (running * count as f64).round() as usize };
            let number = upto.min(count).saturating_sub(given);
            given += number;
            number
        }
    };
    species.iter().enumerate().map(number).collect()
}

/// Discs with diameters from a distribution, divided by their mean.
fn drawn(distribution: &Distribution, masses: Masses, recipe: &Recipe) -> Vec<Disc> {
    let mut random = Random::new(recipe.seed, "gas.sizes.diameters");
    let diameters: Vec<f64> = (0..recipe.count).map(|_| diameter(distribution, &mut random)).collect();
    let mean = sum(diameters.iter().copied()) / recipe.count as f64;
    let disc = |drawn: f64| {
        let diameter = drawn / mean;
        let mass = match masses {
            Masses::Equal => 1.0,
            Masses::Area => diameter * diameter,
        };
        Disc { radius: diameter / 2.0, mass }
    };
    diameters.into_iter().map(disc).collect()
}

fn diameter(distribution: &Distribution, random: &mut Random) -> f64 {
    match *distribution {
        Distribution::Uniform { half_width } => 1.0 + half_width * (2.0 * random.unit() - 1.0),
        Distribution::Normal { polydispersity, truncation } => {
            1.0 + polydispersity * truncated_normal(random, truncation)
        }
        Distribution::LogNormal { polydispersity, truncation } => {
            // Standard deviation over mean is √(exp(s²) − 1), with s that of the logarithm.
            let deviation = ln(1.0 + polydispersity * polydispersity).sqrt();
            Scalar::exp(deviation * truncated_normal(random, truncation))
        }
    }
}
