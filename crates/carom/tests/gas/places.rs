//! Random and compressed starts, and what is taken automatically.

use super::kit::{bidisperse, check, is_of_the_box, made, recipe};
use carom::gas::{Arrangement, Distribution, Error, Masses, Recipe, Sizes, Start, make};

const AUTOMATIC: Arrangement = Arrangement::Automatic;
const COMPRESSED: Arrangement = Arrangement::Compressed;
const RANDOM: Arrangement = Arrangement::Random;

/// Every kind of box: the aspect, and which axes are periodic.
const BOXES: [(f64, [bool; 2]); 5] = [
    (1.0, [true, true]),
    (1.0, [false, false]),
    (2.0, [true, true]),
    (0.5, [false, true]),
    (3.0, [false, false]),
];

fn try_every_box(start: Arrangement, densities: &[f64]) {
    for count in [1, 2, 3, 5, 10, 31, 100, 479, 2000] {
        for fraction in densities {
            for (aspect, periodic) in BOXES {
                let recipe = Recipe { periodic, aspect: Some(aspect), ..recipe(count, *fraction, start) };
                match make(&recipe) {
                    Ok(start) => check(&recipe, &start),
                    Err(error) => {
                        let is_full = matches!(error, Error::NoRoom { .. } | Error::Jammed { .. });
                        let may_be = is_of_the_box(&error) || (is_full && count <= 31);
                        assert!(may_be, "{recipe:?}: {error}");
                    }
                }
            }
        }
    }
}

#[test]
fn random_starts_of_every_density_fit_into_every_box() {
    try_every_box(RANDOM, &[0.05, 0.1, 0.2, 0.3, 0.4, 0.45]);
}

#[test]
fn compressed_starts_of_every_density_fit_into_every_box() {
    try_every_box(COMPRESSED, &[0.05, 0.2, 0.4, 0.5, 0.6, 0.65, 0.7, 0.72]);
}

#[test]
fn automatic_starts_of_every_density_fit_into_every_box() {
    try_every_box(AUTOMATIC, &[0.05, 0.3, 0.45, 0.6, 0.7]);
}

#[test]
fn automatic_takes_what_suits_the_density() {
    let taken = |fraction: f64| made(&recipe(480, fraction, AUTOMATIC)).arrangement;
    assert_eq!(taken(0.05), RANDOM);
    assert_eq!(taken(0.4), RANDOM);
    assert_eq!(taken(0.41), COMPRESSED);
    assert_eq!(taken(0.72), COMPRESSED);
    assert_eq!(taken(0.8), Arrangement::Hexagonal);
    let mixed = Recipe { sizes: bidisperse(), ..recipe(200, 0.75, AUTOMATIC) };
    assert_eq!(made(&mixed).arrangement, COMPRESSED);
}

#[test]
fn compressed_mixtures_reach_high_densities() {
    for periodic in [[true, true], [false, false]] {
        made(&Recipe { sizes: bidisperse(), periodic, ..recipe(400, 0.82, COMPRESSED) });
    }
    let diameters = Distribution::LogNormal { polydispersity: 0.3, truncation: 3.0 };
    let sizes = Sizes::Distribution { diameters, masses: Masses::Area };
    made(&Recipe { sizes, ..recipe(400, 0.84, COMPRESSED) });
}

#[test]
fn compressed_equal_discs_find_their_crystal() {
    let start = made(&recipe(500, 0.86, COMPRESSED));
    // Discs that six others are near to, as in a hexagonal lattice of this density, spacing 1.027.
    let count = |disc: usize| neighbours(&start, disc, 1.3);
    let sixes = (0..500).filter(|disc| count(*disc) == 6).count();
    assert!(sixes > 300, "{sixes}");
}

#[test]
fn two_discs_jam_on_the_diagonal_of_their_box() {
    let recipe = Recipe { periodic: [false, false], ..recipe(2, 0.6, COMPRESSED) };
    let Err(Error::Jammed { reached, asked }) = make(&recipe) else { panic!() };
    // The box is 1 + 1/√2 diameters wide.
    let width = 1.0 + 0.5f64.sqrt();
    let most = core::f64::consts::PI / (2.0 * width * width);
    assert!(asked == 0.6 && reached < most && reached > 0.97 * most, "{reached} of {most}");
}

#[test]
fn a_mixture_that_jams_says_how_far_it_came() {
    let recipe = Recipe { sizes: bidisperse(), ..recipe(60, 0.88, COMPRESSED) };
    let Err(Error::Jammed { reached, .. }) = make(&recipe) else { panic!() };
    assert!(reached > 0.78 && reached < 0.88, "{reached}");
}

#[test]
fn equal_seeds_give_equal_bits_and_others_do_not() {
    for (fraction, start) in [(0.3, RANDOM), (0.6, COMPRESSED)] {
        let with = |seed| made(&Recipe { seed, sizes: bidisperse(), ..recipe(300, fraction, start) });
        assert_eq!(with(1), with(1));
        assert_ne!(with(1).positions, with(2).positions);
        assert_ne!(with(1).velocities, with(2).velocities);
        assert_ne!(with(1).radii, with(2).radii);
    }
}

/// How many discs are nearer to a disc of a periodic box than `reach`.
fn neighbours(start: &Start, disc: usize, reach: f64) -> usize {
    let shortest = |way: f64, size: f64| way - size * (way / size).round();
    let from = start.positions[disc];
    let ways = start.positions.iter().map(|place| *place - from);
    let is_near = |[x, y]: &[f64; 2]| x * x + y * y < reach * reach;
    ways.map(|way| [shortest(way.x, start.size[0]), shortest(way.y, start.size[1])]).filter(is_near).count()
        - 1
}

#[test]
fn random_and_compressed_starts_show_no_lattice() {
    for (fraction, start) in [(0.3, RANDOM), (0.4, RANDOM), (0.5, COMPRESSED)] {
        let start = made(&recipe(2000, fraction, start));
        let density = 2000.0 / (start.size[0] * start.size[1]);
        let within = |reach: f64| (0..2000).map(|disc| neighbours(&start, disc, reach)).sum::<usize>() as f64;
        // The pair correlation, in rings a tenth of a diameter wide: here some 5000 pairs each, known to 2 per cent; twice
        // that for the correlations of a disc's own neighbours, and four standard deviations.
        let correlation = |from: f64| {
            let area = core::f64::consts::PI * (from + from + 0.1) * 0.1;
            (within(from + 0.1) - within(from)) / (2000.0 * density * area)
        };
        assert_eq!(within(1.0), 0.0);
        let contact = correlation(1.0);
        assert!(contact > 1.1 && contact < 3.5, "{fraction}: {contact}");
        for ring in 0..20 {
            let far = correlation(2.5 + 0.1 * f64::from(ring));
            assert!((far - 1.0).abs() < 0.16, "{fraction} at ring {ring}: {far}");
        }
    }
}

#[test]
fn discs_that_meet_lie_near_each_other_in_memory() {
    let start = made(&recipe(2000, 0.3, RANDOM));
    // Some 45 rows of cells, each 1.6 high: only where a row ends the next disc may be further up.
    let steps = start.positions.windows(2).filter(|pair| (pair[1].y - pair[0].y).abs() < 2.0).count();
    assert!(steps > 1950, "{steps}");
    assert!(start.positions[0].y < 2.0 && start.positions[1999].y > start.size[1] - 2.0);
}
