//! What the tests share.

use carom::ensemble::{Design, Draws};

/// Paths as scenarios spell them, in an order that is not that of their letters.
pub const NAMES: [&str; 4] =
    ["balls.red.velocity[0]", "balls.red.velocity[1]", "physics.friction", "balls.blue.position[0]"];

pub fn draws(design: Design, seed: u64, rows: u64) -> Draws {
    Draws::new(design, seed, rows, &NAMES).unwrap()
}

/// The cell of a number among `count` equal ones.
///
/// A product of two whole numbers, which is exact. Those of a Latin hypercube may have more than the 53 bits that are
/// looked at here, but lie further than the last of them from the edges of their cells.
pub fn cell(unit: f64, count: u64) -> u64 {
    let places = (unit * (1u64 << 53) as f64) as u128;
    ((places * u128::from(count)) >> 53) as u64
}

/// Whether all numbers below `count` occur, each once.
pub fn is_order(numbers: impl IntoIterator<Item = u64>, count: u64) -> bool {
    let mut numbers: Vec<u64> = numbers.into_iter().collect();
    numbers.sort_unstable();
    numbers.into_iter().eq(0..count)
}

/// By how many standard deviations χ² of some counts differs from its mean, if each is as likely as the others.
pub fn chi_squared(counts: &[u64]) -> f64 {
    let expected = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    let sum: f64 = counts
        .iter()
        .map(|count| {
            let off = *count as f64 - expected;
            off * off / expected
        })
        .sum();
    let freedom = (counts.len() - 1) as f64;
    (sum - freedom) / (2.0 * freedom).sqrt()
}
