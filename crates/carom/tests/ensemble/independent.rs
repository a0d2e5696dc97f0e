//! Rows that are drawn by themselves.

use super::kit::{NAMES, cell, chi_squared, draws};
use carom::ensemble::{Design, Distribution};

#[test]
fn normal_values_have_the_moments_of_their_distribution() {
    let rows = 100_000;
    let draws = draws(Design::Independent, 12, rows);
    let normal = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
    let mean_of = |of: &dyn Fn(u64) -> f64| (0..rows).map(of).sum::<f64>() / rows as f64;
    // The variance of each mean times the number of rows, from the moments 1, 3, 15, 105 of a normal number: five
    // standard deviations of it are allowed.
    let allowed = |variance: f64| 5.0 * (variance / rows as f64).sqrt();
    for dimension in 0..NAMES.len() {
        let x = |row| normal.at(draws.unit(row, dimension));
        let y = |row| normal.at(draws.unit(row, (dimension + 1) % NAMES.len()));
        let next = |row| normal.at(draws.unit((row + 1) % rows, dimension));
        let moments: [(&str, f64, f64, f64); 6] = [
            ("mean", mean_of(&|row| x(row)), 0.0, 1.0),
            ("variance", mean_of(&|row| x(row) * x(row)), 1.0, 2.0),
            ("third", mean_of(&|row| x(row) * x(row) * x(row)), 0.0, 15.0),
            ("fourth", mean_of(&|row| x(row) * x(row) * x(row) * x(row)), 3.0, 96.0),
            ("with the next path", mean_of(&|row| x(row) * y(row)), 0.0, 1.0),
            ("with the next row", mean_of(&|row| x(row) * next(row)), 0.0, 1.0),
        ];
        for (moment, found, expected, variance) in moments {
            assert!((found - expected).abs() < allowed(variance), "{dimension}, {moment}: {found}");
        }
    }
}

#[test]
fn pairs_fill_the_square() {
    let draws = draws(Design::Independent, 4, 200_000);
    let mut counts = [0; 20 * 20];
    for row in 0..200_000 {
        let [x, y] = [0, 1].map(|dimension| cell(draws.unit(row, dimension), 20));
        counts[(20 * x + y) as usize] += 1;
    }
    assert!(chi_squared(&counts).abs() < 5.0, "{counts:?}");
}
