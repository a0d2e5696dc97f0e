//! Square and hexagonal lattices.

use super::kit::{bidisperse, check, is_of_the_box, made, recipe};
use carom::gas::{Arrangement, Error, Recipe, Start, make};

const HEXAGONAL: Arrangement = Arrangement::Hexagonal;
const SQUARE: Arrangement = Arrangement::Square;

/// π/(2√3).
const CLOSE_PACKING: f64 = 0.906_899_682_117_108_9;

/// The distances of a disc of a periodic box to the others, the nearest first.
fn distances(start: &Start, disc: usize) -> Vec<f64> {
    let shortest = |way: f64, size: f64| way - size * (way / size).round();
    let from = start.positions[disc];
    let others = (0..start.positions.len()).filter(|other| *other != disc);
    let mut distances: Vec<f64> = others
        .map(|other| start.positions[other] - from)
        .map(|way| [shortest(way.x, start.size[0]), shortest(way.y, start.size[1])])
        .map(|[x, y]| (x * x + y * y).sqrt())
        .collect();
    distances.sort_by(f64::total_cmp);
    distances
}

#[test]
fn lattices_of_every_density_fit_into_every_box_or_say_why_not() {
    let mut made = 0;
    for kind in [SQUARE, HEXAGONAL] {
        for count in [1, 2, 3, 5, 10, 31, 100, 480, 1009, 2000] {
            for fraction in [0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.72] {
                for periodic in [[true, true], [false, false], [true, false], [false, true]] {
                    for aspect in [None, Some(1.0), Some(0.4), Some(2.5)] {
                        let recipe = Recipe { periodic, aspect, ..recipe(count, fraction, kind) };
                        match make(&recipe) {
                            Ok(start) => check(&recipe, &start),
                            Err(error) => {
                                let is_lattice_full = matches!(
                                    error,
                                    Error::LatticeTooDense { .. } | Error::BeyondLattice { .. }
                                );
                                let is_tight =
                                    count <= 31 || (fraction >= 0.7 && aspect.is_some() || kind == SQUARE);
                                let may_be = is_of_the_box(&error) || (is_lattice_full && is_tight);
                                assert!(may_be, "{recipe:?}: {error}");
                                continue;
                            }
                        }
                        made += 1;
                    }
                }
            }
        }
    }
    assert!(made > 2100, "only {made} were made");
}

#[test]
fn lattices_reach_their_closest_packing() {
    let densest = [(SQUARE, core::f64::consts::PI / 4.0), (HEXAGONAL, CLOSE_PACKING)];
    for (kind, fraction) in densest {
        for count in [16, 100, 2000, 10_000] {
            let start = made(&recipe(count, fraction, kind));
            assert!((distances(&start, count / 2)[0] - 1.0).abs() < 1e-12);
        }
        let beyond = make(&recipe(100, fraction + 1e-6, kind));
        assert!(beyond.is_err(), "{beyond:?}");
    }
}

#[test]
fn without_an_aspect_the_hexagonal_lattice_is_perfect() {
    for count in [48, 100, 1000, 2000] {
        let start = made(&recipe(count, 0.5, HEXAGONAL));
        let distances = distances(&start, count / 3);
        // Six neighbours at one distance, that of so many discs per area, and the next √3 times as far.
        let spacing = (CLOSE_PACKING / 0.5f64).sqrt();
        assert!(distances[..6].iter().all(|distance| (distance - spacing).abs() < 1e-12 * spacing * 10.0));
        assert!((distances[6] / spacing - 3.0f64.sqrt()).abs() < 1e-12);
        let aspect = start.size[1] / start.size[0];
        assert!((0.5..=2.0).contains(&aspect), "{aspect}");
    }
}

#[test]
fn a_given_aspect_is_kept() {
    for (kind, aspect) in [(HEXAGONAL, 1.0), (SQUARE, 1.0), (HEXAGONAL, 2.0), (SQUARE, 0.3)] {
        let recipe = Recipe { aspect: Some(aspect), ..recipe(1000, 0.6, kind) };
        let start = made(&recipe);
        assert!((start.size[1] / start.size[0] / aspect - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_count_that_does_not_fill_the_lattice_leaves_vacancies_at_places_of_the_seed() {
    // 1009 is a prime: no rows of equal length hold it but one.
    for kind in [SQUARE, HEXAGONAL] {
        let [first, again, other] = [1, 1, 2].map(|seed| made(&Recipe { seed, ..recipe(1009, 0.4, kind) }));
        assert_eq!(first.positions, again.positions);
        assert_eq!(first.size, other.size);
        assert_ne!(first.positions, other.positions);
    }
    let [first, other] = [1, 2].map(|seed| made(&Recipe { seed, ..recipe(100, 0.4, SQUARE) }));
    assert_eq!(first.positions, other.positions);
}

#[test]
fn between_walls_the_tightest_lattice_touches_all_of_them() {
    for kind in [SQUARE, HEXAGONAL] {
        let asked = Recipe { periodic: [false, false], ..recipe(90, 0.9, kind) };
        let Err(Error::BeyondLattice { most, .. }) = make(&asked) else { panic!("{kind:?}") };
        let recipe = Recipe { packing_fraction: most, ..asked };
        let start = made(&recipe);
        for axis in [0, 1] {
            let along = || start.positions.iter().map(|place| place.to_f64()[axis]);
            let [least, most] = [along().fold(f64::INFINITY, f64::min), along().fold(0.0, f64::max)];
            assert!((least - 0.5).abs() < 1e-11, "{kind:?} {axis} {least}");
            assert!((start.size[axis] - most - 0.5).abs() < 1e-11, "{kind:?} {axis} {most}");
        }
    }
}

#[test]
fn discs_of_two_sizes_stand_where_the_largest_have_room() {
    let recipe = Recipe { sizes: bidisperse(), ..recipe(400, 0.6, HEXAGONAL) };
    made(&recipe);
    let error = make(&Recipe { packing_fraction: 0.8, ..recipe }).unwrap_err();
    assert!(matches!(error, Error::BeyondLattice { most, .. } if most > 0.6 && most < 0.7), "{error}");
}
