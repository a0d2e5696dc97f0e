//! Diameters and masses.

use super::kit::{bidisperse, made, recipe};
use carom::gas::{Amount, Arrangement, Distribution, Masses, Recipe, Sizes, Species, Start};

const COUNT: usize = 10_000;

fn drawn(diameters: Distribution, masses: Masses) -> Start {
    let sizes = Sizes::Distribution { diameters, masses };
    made(&Recipe { sizes, ..recipe(COUNT, 0.2, Arrangement::Random) })
}

/// The mean of the diameters, and their standard deviation over it.
fn moments(start: &Start) -> [f64; 2] {
    let count = start.radii.len() as f64;
    let mean = start.radii.iter().map(|radius| 2.0 * radius).sum::<f64>() / count;
    let variance =
        start.radii.iter().map(|radius| (2.0 * radius - mean) * (2.0 * radius - mean)).sum::<f64>();
    [mean, (variance / count).sqrt() / mean]
}

#[test]
fn equal_discs_have_diameter_and_mass_one() {
    let start = made(&recipe(100, 0.3, Arrangement::Automatic));
    assert!(start.radii.iter().all(|radius| *radius == 0.5) && start.masses.iter().all(|mass| *mass == 1.0));
}

#[test]
fn distributions_have_mean_one_and_the_polydispersity_asked_for() {
    let third = 1.0 / 3.0f64.sqrt();
    // The standard deviation of a standard deviation of 10 000 is 0.7 per cent; a cut at five standard deviations takes
    // nothing that could be seen.
    for (distribution, expected) in [
        (Distribution::Uniform { half_width: 0.3 }, 0.3 * third),
        (Distribution::Normal { polydispersity: 0.1, truncation: 5.0 }, 0.1),
        (Distribution::LogNormal { polydispersity: 0.2, truncation: 5.0 }, 0.2),
    ] {
        let [mean, polydispersity] = moments(&drawn(distribution, Masses::Equal));
        assert!((mean - 1.0).abs() < 1e-13, "{distribution:?}: {mean}");
        assert!((polydispersity / expected - 1.0).abs() < 0.035, "{distribution:?}: {polydispersity}");
    }
}

#[test]
fn distributions_end_where_they_are_cut() {
    let extremes = |start: &Start| {
        let diameters = || start.radii.iter().map(|radius| 2.0 * radius);
        [diameters().fold(f64::INFINITY, f64::min), diameters().fold(0.0, f64::max)]
    };
    // The division by the mean moves the ends by the error of a mean of 10 000, below 1 per cent of the deviation, and for
    // the log-normal one by its mean, exp(s²/2).
    let [least, most] =
        extremes(&drawn(Distribution::Normal { polydispersity: 0.1, truncation: 2.0 }, Masses::Equal));
    assert!((least - 0.8).abs() < 0.005 && (most - 1.2).abs() < 0.005, "{least} {most}");
    let [least, most] = extremes(&drawn(Distribution::Uniform { half_width: 0.5 }, Masses::Equal));
    assert!((least - 0.5).abs() < 0.02 && (most - 1.5).abs() < 0.02, "{least} {most}");
    let [least, most] =
        extremes(&drawn(Distribution::LogNormal { polydispersity: 0.2, truncation: 2.0 }, Masses::Equal));
    let ratio = libm::exp(4.0 * libm::sqrt(libm::log(1.04)));
    assert!(most / least <= ratio && most / least > 0.98 * ratio, "{most} {least}");
}

#[test]
fn masses_are_equal_or_in_proportion_to_the_area() {
    let distribution = Distribution::Uniform { half_width: 0.3 };
    assert!(drawn(distribution, Masses::Equal).masses.iter().all(|mass| *mass == 1.0));
    let start = drawn(distribution, Masses::Area);
    for (radius, mass) in start.radii.iter().zip(&start.masses) {
        assert!((mass - 4.0 * radius * radius).abs() < 1e-15 * 8.0);
    }
}

#[test]
fn species_have_their_shares_and_are_mixed_in_memory() {
    for start in [Arrangement::Hexagonal, Arrangement::Random, Arrangement::Compressed] {
        let start = made(&Recipe { sizes: bidisperse(), ..recipe(2000, 0.4, start) });
        assert_eq!(start.radii.iter().filter(|radius| **radius == 0.5).count(), 1000);
        assert!(
            start
                .radii
                .iter()
                .zip(&start.masses)
                .all(|(r, m)| (*r, *m) == (0.5, 1.0) || (*r, *m) == (0.7, 2.0))
        );
        // 1000 ± 22 pairs of neighbours differ where the order is random: four standard deviations, and more for places that
        // depend on sizes.
        let changes = start.radii.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!((850..1150).contains(&changes), "{:?}: {changes}", start.arrangement);
    }
}

#[test]
fn shares_are_rounded_so_that_no_disc_is_left_out() {
    let species = |amounts: &[Amount]| {
        let one = |(number, amount): (usize, &Amount)| Species {
            amount: *amount,
            diameter: 1.0 + number as f64,
            mass: 1.0,
        };
        Sizes::Species(amounts.iter().enumerate().map(one).collect())
    };
    let numbers = |count: usize, amounts: &[Amount]| -> Vec<usize> {
        let start = made(&Recipe { sizes: species(amounts), ..recipe(count, 0.02, Arrangement::Random) });
        let of = |number: usize| start.radii.iter().filter(|r| **r == (1.0 + number as f64) / 2.0).count();
        (0..amounts.len()).map(of).collect()
    };
    let third = Amount::Fraction(1.0 / 3.0);
    assert_eq!(numbers(100, &[third; 3]).iter().sum::<usize>(), 100);
    assert!(numbers(100, &[third; 3]).iter().all(|number| (33..=34).contains(number)));
    assert_eq!(numbers(1, &[Amount::Fraction(0.2), Amount::Fraction(0.8)]), [0, 1]);
    assert_eq!(numbers(12, &[Amount::Number(3), Amount::Number(9)]), [3, 9]);
}
