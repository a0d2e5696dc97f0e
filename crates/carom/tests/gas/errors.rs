//! What is wrong with a recipe, where, and what is allowed.

use super::kit::recipe;
use carom::gas::Arrangement::{Automatic, Compressed, Hexagonal, Random, Square};
use carom::gas::{Amount, Distribution, Masses, Recipe, Sizes, Species, make};

/// Asserts that a recipe is refused with a text that holds each of some parts.
fn refused(recipe: Recipe, parts: &[&str]) {
    let error = make(&recipe).map(|_| ()).expect_err(&format!("{recipe:?} was made")).to_string();
    assert!(!error.contains("  "), "{error}");
    for part in parts {
        assert!(error.contains(part), "{error:?} has no {part:?}");
    }
}

fn gas() -> Recipe {
    recipe(100, 0.3, Automatic)
}

#[test]
fn numbers_outside_their_range() {
    refused(Recipe { count: 0, ..gas() }, &["n: must be from 1 to 100000000, got 0"]);
    refused(Recipe { count: usize::MAX, ..gas() }, &["n: must be"]);
    for packing_fraction in [0.0, -0.1, 1.0, f64::NAN, f64::INFINITY] {
        refused(
            Recipe { packing_fraction, ..gas() },
            &["packing_fraction: must be above 0 and below 1, got", &packing_fraction.to_string()],
        );
    }
    for aspect in [0.0, -1.0, 1e4, f64::NAN, f64::INFINITY] {
        refused(Recipe { aspect: Some(aspect), ..gas() }, &["aspect: must be from 0.001 to 1000, got"]);
    }
    for temperature in [-1.0, f64::NAN, f64::INFINITY] {
        refused(Recipe { temperature, ..gas() }, &["temperature: must be zero or positive and finite, got"]);
    }
}

#[test]
fn more_than_close_packing() {
    for start in [Square, Hexagonal, Random, Compressed, Automatic] {
        refused(
            recipe(100, 0.91, start),
            &["packing_fraction: equal discs fill at most", "0.9069", "got 0.91"],
        );
    }
}

#[test]
fn species_that_do_not_add_up() {
    let sizes = |species: &[(Amount, f64, f64)]| {
        let one = |(amount, diameter, mass): &(Amount, f64, f64)| Species {
            amount: *amount,
            diameter: *diameter,
            mass: *mass,
        };
        Recipe { sizes: Sizes::Species(species.iter().map(one).collect()), ..gas() }
    };
    let half = Amount::Fraction(0.5);
    refused(sizes(&[]), &["sizes.species: must have one species at least"]);
    refused(sizes(&[(half, 1.0, 1.0)]), &["sizes.species: the fractions must sum to 1, these sum to 0.5"]);
    refused(
        sizes(&[(half, 1.0, 1.0), (Amount::Number(50), 1.0, 1.0)]),
        &["sizes.species: all must give a fraction, or all a number"],
    );
    refused(
        sizes(&[(Amount::Number(50), 1.0, 1.0), (Amount::Number(51), 1.0, 1.0)]),
        &["sizes.species: the numbers must sum to n = 100, these sum to 101"],
    );
    refused(
        sizes(&[(Amount::Number(usize::MAX), 1.0, 1.0), (Amount::Number(2), 1.0, 1.0)]),
        &["must sum to n = 100"],
    );
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(sizes(&[(half, 1.0, 1.0), (half, wrong, 1.0)]), &["sizes.species[1].diameter: must be"]);
        refused(sizes(&[(half, 1.0, wrong), (half, 1.0, 1.0)]), &["sizes.species[0].mass: must be"]);
    }
    for wrong in [-0.5, 1.5, f64::NAN] {
        let fraction = Amount::Fraction(wrong);
        refused(sizes(&[(fraction, 1.0, 1.0), (half, 1.0, 1.0)]), &["sizes.species[0].fraction: must be"]);
    }
}

#[test]
fn distributions_with_negative_diameters_or_none() {
    let of = |diameters| Recipe { sizes: Sizes::Distribution { diameters, masses: Masses::Equal }, ..gas() };
    for half_width in [-0.1, 1.0, f64::NAN] {
        refused(
            of(Distribution::Uniform { half_width }),
            &["sizes.half_width: must be zero or more and below 1"],
        );
    }
    for polydispersity in [-0.1, 0.34, f64::NAN] {
        let text = "sizes.polydispersity: must be zero or more and below 1/truncation";
        refused(of(Distribution::Normal { polydispersity, truncation: 3.0 }), &[text]);
    }
    for polydispersity in [-0.1, 1.1, f64::NAN] {
        let text = "sizes.polydispersity: must be from 0 to 1";
        refused(of(Distribution::LogNormal { polydispersity, truncation: 3.0 }), &[text]);
    }
    for truncation in [0.0, 11.0, f64::NAN] {
        let text = "sizes.truncation: must be from 0.5 to 10";
        refused(of(Distribution::Normal { polydispersity: 0.1, truncation }), &[text]);
        refused(of(Distribution::LogNormal { polydispersity: 0.1, truncation }), &[text]);
    }
}

#[test]
fn boxes_that_are_too_small() {
    for start in [Square, Hexagonal, Random, Compressed, Automatic] {
        refused(recipe(1, 0.4, start), &["periodic: the", "diameters of the largest disc", "more than 3"]);
    }
    for start in [Square, Hexagonal, Random, Compressed] {
        let walls = Recipe { periodic: [false, false], aspect: Some(50.0), ..recipe(10, 0.4, start) };
        refused(walls, &["packing_fraction: the width of the box is", "less than one"]);
    }
}

#[test]
fn lattices_that_are_too_dense() {
    refused(
        recipe(100, 0.8, Square),
        &[
            "packing_fraction: 100 discs on a square lattice of 10 columns and 10 rows fill 0.785398 at most, got 0.8",
        ],
    );
    let square_box = Recipe { aspect: Some(1.0), ..recipe(100, 0.9, Hexagonal) };
    refused(
        square_box,
        &["packing_fraction: 100 discs on a hexagonal lattice", "apart, less than the largest"],
    );
}

#[test]
fn densities_that_a_start_does_not_reach() {
    refused(recipe(100, 0.51, Random), &["start = \"random\" reaches 0.5", "got 0.51", "\"compressed\""]);
    // A lane 1.5 diameters wide, in which one disc after another would need luck.
    let lane = Recipe { periodic: [false, false], aspect: Some(42.0), ..recipe(60, 0.5, Random) };
    refused(lane, &["start = \"random\" placed", "of 60 discs at most", "\"compressed\""]);
    let jammed = Recipe { periodic: [false, false], ..recipe(5, 0.8, Compressed) };
    refused(jammed, &["start = \"compressed\" jammed at 0.6", "before the 0.8 asked for"]);
}
