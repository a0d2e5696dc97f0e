//! Whether a recipe makes sense, as far as can be said before anything is made.

use super::error::Error;
use super::recipe::{Amount, Distribution, Recipe, Sizes, Species};

/// More discs than these fit no memory.
const MOST_DISCS: usize = 100_000_000;

/// The densest packing of equal discs, π/(2√3), with room for rounding.
const CLOSE_PACKING: f64 = 0.906_899_682_117_108_9 * (1.0 + 1e-12);

/// How far a sum of fractions may be from 1: written fractions have some ten digits.
const FRACTION_TOLERANCE: f64 = 1e-9;

/// Checks a recipe; the first problem is what is returned.
pub(super) fn check(recipe: &Recipe) -> Result<(), Error> {
    let count = recipe.count as f64;
    number("n", count, "from 1 to 100000000", (1..=MOST_DISCS).contains(&recipe.count))?;
    let fraction = recipe.packing_fraction;
    number("packing_fraction", fraction, "above 0 and below 1", fraction > 0.0 && fraction < 1.0)?;
    if let Some(aspect) = recipe.aspect {
        number("aspect", aspect, "from 0.001 to 1000", (0.001..=1000.0).contains(&aspect))?;
    }
    let temperature = recipe.temperature;
    let is_allowed = temperature >= 0.0 && temperature.is_finite();
    number("temperature", temperature, "zero or positive and finite", is_allowed)?;
    match &recipe.sizes {
        Sizes::Equal if fraction > CLOSE_PACKING => Err(Error::BeyondClosePacking { got: fraction }),
        Sizes::Equal => Ok(()),
        Sizes::Species(species) => check_species(species, recipe.count),
        Sizes::Distribution { diameters, .. } => check_distribution(diameters),
    }
}

fn number(key: impl Into<String>, got: f64, allowed: &'static str, is_allowed: bool) -> Result<(), Error> {
    if is_allowed { Ok(()) } else { Err(Error::Number { key: key.into(), allowed, got }) }
}

fn check_species(species: &[Species], count: usize) -> Result<(), Error> {
    for (place, one) in species.iter().enumerate() {
        let key = |name: &str| format!("sizes.species[{place}].{name}");
        let allowed = |number: f64| (1e-6..=1e6).contains(&number);
        number(key("diameter"), one.diameter, "from 1e-6 to 1e6", allowed(one.diameter))?;
        number(key("mass"), one.mass, "from 1e-6 to 1e6", allowed(one.mass))?;
        if let Amount::Fraction(fraction) = one.amount {
            number(key("fraction"), fraction, "from 0 to 1", (0.0..=1.0).contains(&fraction))?;
        }
    }
    check_amounts(species, count)
}

fn check_amounts(species: &[Species], count: usize) -> Result<(), Error> {
    let (mut fractions, mut numbers) = (Vec::new(), Vec::new());
    for one in species {
        match one.amount {
            Amount::Fraction(fraction) => fractions.push(fraction),
            Amount::Number(number) => numbers.push(number),
        }
    }
    let (of_fractions, of_numbers) =
        (fractions.iter().sum::<f64>(), numbers.iter().fold(0, |sum: usize, n| sum.saturating_add(*n)));
    match (fractions.is_empty(), numbers.is_empty()) {
        (true, true) => Err(Error::NoSpecies),
        (false, false) => Err(Error::MixedAmounts),
        (false, true) if (of_fractions - 1.0).abs() > FRACTION_TOLERANCE => {
            Err(Error::Fractions { sum: of_fractions })
        }
        (true, false) if of_numbers != count => Err(Error::Numbers { sum: of_numbers, count }),
        _ => Ok(()),
    }
}

fn check_distribution(diameters: &Distribution) -> Result<(), Error> {
    match *diameters {
        Distribution::Uniform { half_width } => {
            let is_allowed = (0.0..1.0).contains(&half_width);
            number("sizes.half_width", half_width, "zero or more and below 1", is_allowed)
        }
        Distribution::Normal { polydispersity, truncation } => {
            check_truncation(truncation)?;
            let is_allowed = polydispersity >= 0.0 && polydispersity * truncation < 1.0;
            let allowed = "zero or more and below 1/truncation, so that no diameter is negative";
            number("sizes.polydispersity", polydispersity, allowed, is_allowed)
        }
        Distribution::LogNormal { polydispersity, truncation } => {
            check_truncation(truncation)?;
            let is_allowed = (0.0..=1.0).contains(&polydispersity);
            number("sizes.polydispersity", polydispersity, "from 0 to 1", is_allowed)
        }
    }
}

fn check_truncation(truncation: f64) -> Result<(), Error> {
    let allowed = "from 0.5 to 10 standard deviations";
    number("sizes.truncation", truncation, allowed, (0.5..=10.0).contains(&truncation))
}
