//! Extreme scales, and leading coefficients that are zero or nearly.

use carom::roots::{Polynomial, Quadratic, closing_crossings, first_contact};
use proptest::prelude::*;

fn first(coefficients: [f64; 5]) -> Option<f64> {
    closing_crossings(&Polynomial::new(coefficients), 0.0).next()
}

/// The same gap with lengths and times in other units; none when a coefficient leaves the normal numbers.
fn rescaled(coefficients: [f64; 5], length: f64, time: f64) -> Option<[f64; 5]> {
    let mut unit = length;
    let scaled = coefficients.map(|a| {
        let scaled = if a == 0.0 { 0.0 } else { a * unit };
        unit /= time;
        scaled
    });
    let is_kept = |a: &f64, b: &f64| *a == 0.0 || (b.is_normal() && b.abs() > 1e-290 && b.abs() < 1e300);
    coefficients.iter().zip(&scaled).all(|(a, b)| is_kept(a, b)).then_some(scaled)
}

fn gap() -> impl Strategy<Value = [f64; 5]> {
    (prop::array::uniform5(-4.0..4.0f64), 0.0..4.0f64, 1..5usize).prop_map(|(a, start, degree)| {
        core::array::from_fn(|i| {
            if i == 0 {
                start
            } else if i <= degree {
                a[i]
            } else {
                0.0
            }
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn powers_of_two_scale_the_result_bit_for_bit(a in gap(), length in -900..900i32, time in -200..200i32) {
        let (length, time) = (2f64.powi(length), 2f64.powi(time));
        if let Some(scaled) = rescaled(a, length, time) {
            prop_assert_eq!(first(scaled), first(a).map(|s| s * time));
        }
    }

    #[test]
    fn extreme_units_only_scale_the_result(a in gap(), length in -150..150i32, time in -150..150i32) {
        let (length, time) = (10f64.powi(length), 10f64.powi(time));
        let (Some(scaled), Some(before)) = (rescaled(a, length, time), first(a)) else { return Ok(()) };
        // Rounding of the scaled coefficients moves a crossing by Σ |aᵢ| sⁱ ε / |g′|.
        let gap = Polynomial::new(a);
        let tolerance = (gap.rounding_bound(before) / gap.slope(before).abs()).max(1e-14 * before);
        if let Some(after) = first(scaled) {
            prop_assert!((after / time - before).abs() <= tolerance);
        } else {
            prop_assert!(tolerance > 1e-9 * before, "lost {before} of {a:?}");
        }
    }

    #[test]
    fn rounding_in_leading_coefficients_neither_loses_nor_invents(
        a in prop::array::uniform3(-4.0..4.0f64), cubic in -1.0..1.0f64, exponent in 30..280i32
    ) {
        let small = 10f64.powi(-exponent);
        let plain = Quadratic::new(a).closing_crossing();
        let noisy = [a[0], a[1], a[2], small * cubic, small * small];
        let found = first(noisy).filter(|s| *s < 1e12);
        match (plain, found) {
            (Some(s), Some(t)) => {
                let gap = Polynomial::new(noisy);
                prop_assert!((s - t).abs() <= gap.rounding_bound(s) / gap.slope(s).abs() + 1e-14 * s);
            }
            // A graze may be decided either way.
            (one, other) if one != other => {
                let turn = -a[1] / (2.0 * a[2]);
                let gap = Polynomial::new(noisy);
                prop_assert!(gap.value(turn).abs() <= 2.0 * gap.rounding_bound(turn) || plain.is_some_and(|s| s > 1e12));
            }
            _ => {}
        }
    }
}

#[test]
fn tiny_leading_coefficients_keep_near_crossings_and_add_far_ones_only() {
    assert_eq!(first([1.0, -1.0, 0.0, 0.0, 1e-300]), Some(1.0));
    assert_eq!(first([1.0, -1.0, 0.0, 1e-300, 0.0]), Some(1.0));
    assert_eq!(first([1.0, -1.0, 0.0, 1e-320, 5e-324]), Some(1.0));
    // g = 1 + s − 1e-80 s⁴ falls through zero at 10^(80/3).
    let far = first([1.0, 1.0, 0.0, 0.0, -1e-80]).unwrap();
    assert!((far / 10f64.powf(80.0 / 3.0) - 1.0).abs() < 1e-13);
    // The crossing lies beyond all numbers.
    assert_eq!(first([1e300, -1e-300, 0.0, 0.0, 0.0]), None);
    let subnormal = first([1.0, 0.0, 0.0, 0.0, -1e-320]).unwrap();
    assert!((subnormal / 1e80 - 1.0).abs() < 1e-3); // 1e-320 has three digits
}

#[test]
fn huge_and_tiny_quadratics_do_not_overflow() {
    for scale in [1e-300, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e300] {
        for a in [[2.0, -3.0, 1.0], [1.0, 0.0, -1.0], [-3.0, 4.0, -1.0], [1.0, -1.0, 0.0], [0.0, 3.0, -1.0]] {
            let expected = Quadratic::new(a).closing_crossing().unwrap();
            let found = Quadratic::new(a.map(|c| c * scale)).closing_crossing().unwrap();
            assert!((found - expected).abs() <= 4e-16 * expected, "{a:?} at {scale}");
        }
        assert_eq!(Quadratic::new([1.0, -2.0, 1.0].map(|c| c * scale)).closing_crossing(), None);
        assert_eq!(Quadratic::new([scale, -scale, 1e3 * scale]).closing_crossing(), None);
    }
    // Terms of very different size: a₀ / |a₁|, −a₁ / a₂, √(a₀ / −a₂).
    let close = |a: [f64; 3], expected: f64| {
        let found = Quadratic::new(a).closing_crossing().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-15, "{a:?}: {found}, expected {expected}");
    };
    close([1e-100, -1e200, 1e-200], 1e-300);
    close([1e-300, 1e-10, -1e250], 1e-260);
    close([1e200, -1e-200, -1e-180], 1e190);
    close([1e-290, -1e-160, 0.0], 1e-130);
}

#[test]
fn contact_rule_holds_at_extreme_lengths() {
    for length in [1e-280, 1e-150, 1e150, 1e280] {
        let gap = |a: [f64; 5]| Polynomial::new(a.map(|c| c * length));
        let delta = 1e-10 * length;
        let contact = |a| first_contact(&gap(a), delta, |_| true);
        assert_eq!(contact([0.0, -1.0, 0.0, 1.0, 0.0]), Some(0.0));
        let back = contact([0.0, 2.0, -3.0, 1.0, 0.0]).unwrap();
        assert!((back - 1.0).abs() < 1e-15);
    }
}
