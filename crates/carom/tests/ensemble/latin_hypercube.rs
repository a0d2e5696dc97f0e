//! Latin hypercubes.

use super::kit::{NAMES, cell, chi_squared, draws, is_order};
use carom::ensemble::{Design, Draws};
use std::collections::BTreeMap;

fn cells(draws: &Draws, rows: u64, dimension: usize) -> Vec<u64> {
    (0..rows).map(|row| cell(draws.unit(row, dimension), rows)).collect()
}

#[test]
fn every_cell_is_hit_once_in_every_dimension() {
    for rows in (1..=300).chain([1023, 1024, 1025, 65_537, 100_003]) {
        let draws = draws(Design::LatinHypercube, rows, rows);
        for dimension in 0..NAMES.len() {
            assert!(is_order(cells(&draws, rows, dimension), rows), "{rows} rows");
        }
    }
}

/// In how many of some seeds the first two rows lie in each pair of cells.
fn counts_of_pairs(rows: u64, of: impl Fn(&Draws) -> [u64; 2]) -> BTreeMap<[u64; 2], u64> {
    let mut counts = BTreeMap::new();
    for seed in 0..20_000 {
        *counts.entry(of(&draws(Design::LatinHypercube, seed, rows))).or_default() += 1;
    }
    counts
}

#[test]
fn few_rows_come_in_every_order_equally_often() {
    for (rows, orders) in [(2, 2), (3, 6), (4, 24), (5, 120)] {
        let mut counts: BTreeMap<Vec<u64>, u64> = BTreeMap::new();
        for seed in 0..24_000 {
            *counts.entry(cells(&draws(Design::LatinHypercube, seed, rows), rows, 0)).or_default() += 1;
        }
        assert_eq!(counts.len(), orders);
        let counts: Vec<u64> = counts.into_values().collect();
        assert!(chi_squared(&counts).abs() < 5.0, "{rows} rows: {counts:?}");
    }
}

#[test]
fn two_rows_lie_in_any_two_cells_equally_often() {
    for rows in [7, 8, 9, 16, 17, 20] {
        let of = |draws: &Draws| [0, 1].map(|row| cell(draws.unit(row, 0), rows));
        let counts: Vec<u64> = counts_of_pairs(rows, of).into_values().collect();
        assert_eq!(counts.len() as u64, rows * (rows - 1));
        assert!(chi_squared(&counts).abs() < 5.0, "{rows} rows: {counts:?}");
    }
}

#[test]
fn dimensions_do_not_follow_each_other() {
    for rows in [2, 5, 9, 20] {
        let of = |draws: &Draws| [0, 1].map(|dimension| cell(draws.unit(0, dimension), rows));
        let counts: Vec<u64> = counts_of_pairs(rows, of).into_values().collect();
        assert_eq!(counts.len() as u64, rows * rows);
        assert!(chi_squared(&counts).abs() < 5.0, "{rows} rows: {counts:?}");
    }
}

#[test]
fn places_within_cells_are_anywhere() {
    let rows = 100_000;
    let draws = draws(Design::LatinHypercube, 2, rows);
    let mut counts = [0; 10];
    for row in 0..rows {
        counts[(cell(draws.unit(row, 0), 10 * rows) % 10) as usize] += 1;
    }
    assert!(chi_squared(&counts).abs() < 5.0, "{counts:?}");
}

#[test]
fn a_mean_is_better_known_than_of_independent_rows() {
    // The mean of x² over n cells is off by some n^(-3/2), of independent rows by n^(-1/2).
    let rows = 1000;
    let error = |design, seed| {
        let draws = draws(design, seed, rows);
        let sum: f64 = (0..rows).map(|row| draws.unit(row, 0)).map(|unit| unit * unit).sum();
        (sum / rows as f64 - 1.0 / 3.0).abs()
    };
    let mean_error = |design| (0..20).map(|seed| error(design, seed)).sum::<f64>();
    assert!(mean_error(Design::LatinHypercube) < 0.01 * mean_error(Design::Independent));
}
