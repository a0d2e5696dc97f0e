//! Errors of means, of series whose exact errors are known.

use crate::kit::{gaussian, is_close};
use carom::observe::Blocks;
use carom::random::Random;

/// The mean over series of the error that the blocks give, over the exact one, for x' = a x + noise.
fn ratio_to_the_exact_error(memory: f64, length: u64, series: u64) -> f64 {
    let n = length as f64;
    let correlation = (1.0 + memory) / (1.0 - memory)
        - 2.0 * memory * (1.0 - memory.powf(n)) / (n * (1.0 - memory) * (1.0 - memory));
    let exact = (correlation / (n * (1.0 - memory * memory))).sqrt();
    let estimate = |seed| {
        let mut random = Random::new(seed, "autoregressive");
        let mut x = gaussian(&mut random).x / (1.0 - memory * memory).sqrt();
        let mut blocks = Blocks::default();
        for _ in 0..length {
            blocks.push(x);
            x = memory * x + gaussian(&mut random).x;
        }
        blocks.error().unwrap()
    };
    (0..series).map(estimate).sum::<f64>() / series as f64 / exact
}

#[test]
fn the_error_of_independent_values_is_that_of_their_scatter() {
    // Of 4096 values, the scatter's own error is 1 %; over 20 series 0.25 %.
    let ratio = ratio_to_the_exact_error(0.0, 4096, 20);
    assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
}

#[test]
fn the_error_of_a_correlated_series_is_the_exact_one() {
    // 38 times the variance that the scatter alone would tell. Blocks of some 512 among 2^16 values miss 2 % of the
    // error, and each series knows it to 6 %.
    let ratio = ratio_to_the_exact_error(0.95, 1 << 16, 40);
    assert!((ratio - 1.0).abs() < 0.06, "{ratio}");
}

#[test]
fn a_ratio_knows_what_numerator_and_denominator_have_in_common() {
    let mut random = Random::new(4, "ratio");
    let (mut fixed, mut free) = (Blocks::default(), Blocks::default());
    for _ in 0..4000 {
        let denominator = 1.0 + random.unit();
        fixed.push_ratio(3.0 * denominator, denominator);
        free.push_ratio(4.5 + gaussian(&mut random).x, denominator);
    }
    assert!(is_close(fixed.value().unwrap(), 3.0) && fixed.error().unwrap() < 1e-9);
    // Variance of (a − 3 b)/b̄: 1 + 9/12, over 1.5².
    let exact = (1.75_f64 / 2.25 / 4000.0).sqrt();
    let error = free.error().unwrap();
    assert!((error / exact - 1.0).abs() < 0.1 && (free.value().unwrap() - 3.0).abs() < 5.0 * error);
}

#[test]
fn too_few_values_have_no_error() {
    let mut blocks = Blocks::default();
    assert_eq!((blocks.value(), blocks.error()), (None, None));
    blocks.push(2.0);
    assert_eq!((blocks.value(), blocks.error()), (Some(2.0), None));
    blocks.push(2.0);
    assert_eq!((blocks.value(), blocks.error()), (Some(2.0), Some(0.0)));
    let mut empty = Blocks::default();
    empty.push_ratio(1.0, 0.0);
    assert_eq!(empty.value(), None);
}
