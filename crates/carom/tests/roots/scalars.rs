//! The same search in every scalar: double-double agrees and is sharper, duals carry exact derivatives.

use super::exact::Exact;
use carom::roots::{Polynomial, closing_crossings, first_contact};
use carom::scalar::{DoubleDouble, Dual, Scalar};
use proptest::prelude::*;

const DELTA: f64 = 1e-10;

/// A number that depends on no variable, in any scalar.
fn constant<S: Scalar>(coefficients: [f64; 5]) -> Polynomial<S> {
    Polynomial::new(coefficients.map(S::from_f64))
}

/// A dual polynomial whose coefficients are the variables.
fn variables(coefficients: [f64; 5]) -> Polynomial<Dual<5>> {
    Polynomial::new(core::array::from_fn(|i| Dual::variable(coefficients[i], i)))
}

fn contact<S: Scalar>(gap: &Polynomial<S>) -> Option<S> {
    first_contact(gap, S::from_f64(DELTA), |_| true)
}

/// Coefficients of every degree and start: in front, in contact, behind.
fn gap() -> impl Strategy<Value = [f64; 5]> {
    let start = prop_oneof![4 => 0.1..4.0f64, 1 => -4.0..-0.1f64, 1 => -0.9e-10..0.9e-10, 1 => Just(0.0)];
    (prop::array::uniform5(-4.0..4.0f64), start, 1..5usize).prop_map(|(a, start, degree)| {
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
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn real_part_of_a_dual_is_the_f64_result_bit_for_bit(a in gap()) {
        let plain = contact(&constant::<f64>(a));
        let dual = contact(&variables(a));
        prop_assert_eq!(plain.map(f64::to_bits), dual.map(|s| s.value.to_bits()));
    }

    #[test]
    fn derivative_of_a_crossing_is_minus_partial_over_slope(a in gap()) {
        let gap = variables(a);
        for s in closing_crossings(&gap, Dual::ZERO) {
            let slope = constant::<f64>(a).slope(s.value);
            // Relative error of the slope; the quadratic's closed form differs by that of its discriminant.
            let uncertain = constant::<f64>(a).derivative().rounding_bound(s.value) / slope.abs();
            if uncertain < 1e-8 {
                for (i, derivative) in s.derivatives.iter().enumerate() {
                    let expected = -s.value.powi(i as i32) / slope;
                    let tolerance = (1e-6 * uncertain.sqrt() + 1e-12) * expected.abs().max(derivative.abs());
                    prop_assert!((derivative - expected).abs() <= tolerance, "{derivative} is not {expected}");
                }
            }
        }
    }

    #[test]
    fn derivative_of_a_turn_is_minus_partial_slope_over_curvature(
        rise in 1e-12..1e-11f64, fall in 1e-12..1e-11f64, quartic in -1e-16..1e-16f64
    ) {
        let a = [-5e-11, rise, -fall, 0.0, quartic];
        let turn = contact(&variables(a)).unwrap();
        let s = turn.value;
        let curvature = constant::<f64>(a).derivative().slope(s);
        for (i, derivative) in turn.derivatives.iter().enumerate() {
            let expected = if i == 0 { 0.0 } else { -(i as f64) * s.powi(i as i32 - 1) / curvature };
            prop_assert!((derivative - expected).abs() <= 1e-12 * expected.abs());
        }
    }

    #[test]
    fn double_double_agrees_with_f64(a in gap()) {
        let plain = constant::<f64>(a);
        let (one, twin) = (contact(&plain), contact(&constant::<DoubleDouble>(a)));
        if let (Some(s), Some(t)) = (one, twin) {
            let tolerance = plain.rounding_bound(s) / plain.slope(s).abs();
            prop_assert!((s - t.to_f64()).abs() <= tolerance.max(1e-14 * s));
        } else {
            // Only a graze may be seen in one and not in the other; random coefficients never come that close.
            prop_assert_eq!(one.is_some(), twin.is_some());
        }
    }

    #[test]
    fn double_double_is_exact_to_its_own_rounding(a in prop::array::uniform5(-4.0..4.0f64), start in 0.1..4.0f64) {
        let a = [start, a[1], a[2], a[3], a[4]];
        let gap = constant::<DoubleDouble>(a);
        let exact = Exact::new(&a).crossings().into_iter().find(|c| c.is_falling);
        let found = closing_crossings(&gap, DoubleDouble::ZERO).next();
        prop_assert_eq!(found.is_some(), exact.is_some());
        if let (Some(s), Some(crossing)) = (found, exact) {
            let tolerance = gap.rounding_bound(s) / gap.slope(s).abs().to_f64() + 1e-30 * s.to_f64();
            let error = (s - crossing.at.to_double_double()).abs().to_f64();
            prop_assert!(error <= tolerance, "off by {error}, allowed {tolerance}");
        }
    }
}

#[test]
fn vanishing_coefficients_keep_their_derivatives() {
    // g = 2 − 3 s + s² + p s³ + q s⁴ at p = q = 0: closes at 1 with slope −1.
    let s = contact(&variables([2.0, -3.0, 1.0, 0.0, 0.0])).unwrap();
    assert_eq!((s.value, s.derivatives), (1.0, [1.0; 5]));
    // Turn of −ε + 2 s − s² at 1, curvature −2: −i/−2.
    let turn = contact(&variables([-5e-11, 2e-11, -1e-11, 0.0, 0.0])).unwrap();
    let unit = 0.5e11;
    for (derivative, expected) in
        turn.derivatives.into_iter().zip([0.0, unit, 2.0 * unit, 3.0 * unit, 4.0 * unit])
    {
        assert!((derivative - expected).abs() <= 1e-12 * expected, "{:?}", turn.derivatives);
    }
}

#[test]
fn triple_root_has_an_honest_derivative() {
    let s = closing_crossings(&variables([1.0, -3.0, 3.0, -1.0, 0.0]), Dual::ZERO).next().unwrap();
    assert!((s.value - 1.0).abs() < 1e-5);
    // dependence on a₀ goes with the cube root
    assert!(s.derivatives[0].abs() > 1e9);
}
