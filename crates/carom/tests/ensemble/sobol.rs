//! Sobol's sequence; `reference/sobol` holds points that scipy computed.

use super::kit::{cell, is_order};
use carom::ensemble::{Design, Draws, MOST_DIMENSIONS};
use serde_json::Value;

fn draws(seed: u64) -> Draws {
    let names: Vec<String> = (0..MOST_DIMENSIONS).map(|place| format!("balls[{place}].radius")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    Draws::new(Design::Sobol, seed, 1 << 40, &names).unwrap()
}

/// The 52 bits of a coordinate.
fn bits(draws: &Draws, row: u64, dimension: usize) -> u64 {
    cell(draws.unit(row, dimension), 1 << 52)
}

#[test]
fn points_are_scipys_shifted_by_the_first_one() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../reference/sobol/points.json");
    let reference: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let points = reference["points"].as_array().unwrap();
    assert_eq!(points.len(), 67);
    for seed in [0, 1] {
        let draws = draws(seed);
        for point in points {
            let row = point["row"].as_u64().unwrap();
            let expected = point["point"].as_array().unwrap();
            assert_eq!(expected.len(), MOST_DIMENSIONS);
            for (dimension, expected) in expected.iter().enumerate() {
                // The first point of the sequence is zero, so that here it is the shift.
                let unshifted = bits(&draws, row, dimension) ^ bits(&draws, 0, dimension);
                let found = unshifted as f64 / (1u64 << 52) as f64;
                assert_eq!(found, expected.as_f64().unwrap(), "row {row}, dimension {dimension}");
            }
        }
    }
}

#[test]
fn the_first_points_fall_once_into_each_interval_of_every_dimension() {
    let draws = draws(5);
    for rows in (0..=12).map(|power| 1 << power) {
        for dimension in 0..MOST_DIMENSIONS {
            let cells = (0..rows).map(|row| cell(draws.unit(row, dimension), rows));
            assert!(is_order(cells, rows), "{rows} rows, dimension {dimension}");
        }
    }
}

#[test]
fn so_do_later_blocks_of_as_many() {
    let draws = draws(6);
    for start in [1024, 123 * 1024, (1 << 39) + 7 * 1024] {
        for dimension in 0..MOST_DIMENSIONS {
            let cells = (start..start + 1024).map(|row| cell(draws.unit(row, dimension), 1024));
            assert!(is_order(cells, 1024), "from {start}, dimension {dimension}");
        }
    }
}

#[test]
fn two_dimensions_fill_the_square_evenly() {
    // The first two dimensions are a net with t = 0: of 2¹⁰ points one falls into each rectangle of area 2⁻¹⁰.
    let draws = draws(7);
    for across in 0..=10 {
        let [columns, lines] = [1 << across, 1 << (10 - across)];
        let cells =
            (0..1024).map(|row| cell(draws.unit(row, 0), columns) * lines + cell(draws.unit(row, 1), lines));
        assert!(is_order(cells, 1024), "{columns} by {lines}");
    }
}

#[test]
fn seeds_tell_the_error_of_a_mean() {
    // The mean of a product over eight dimensions, each factor with the mean one.
    let rows = 4096;
    let mean = |seed| {
        let draws = draws(seed);
        let product = |row| (0..8).map(|dimension| 0.5 + draws.unit(row, dimension)).product::<f64>();
        (0..rows).map(product).sum::<f64>() / rows as f64
    };
    let means: Vec<f64> = (0..16).map(mean).collect();
    let count = means.len() as f64;
    let centre = means.iter().sum::<f64>() / count;
    let variance = means.iter().map(|mean| (mean - centre) * (mean - centre)).sum::<f64>() / (count - 1.0);
    let error = (variance / count).sqrt();
    assert!((centre - 1.0).abs() < 4.0 * error, "{centre} with an error of {error}");
    // One seed of independent rows would have an error of √((13/12)⁸ − 1) / √4096 = 0.0148.
    assert!(variance.sqrt() < 0.1 * 0.0148, "{variance}");
}
