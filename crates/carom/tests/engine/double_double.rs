//! Double-double arithmetic against exact rational arithmetic.

use carom::scalar::{DoubleDouble, Scalar};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

const U_SQUARED: f64 = 1.232_595_164_407_831e-32; // 2⁻¹⁰⁶

fn exact(x: DoubleDouble) -> BigRational {
    BigRational::from_float(x.hi()).unwrap() + BigRational::from_float(x.lo()).unwrap()
}

fn is_within(result: DoubleDouble, expected: &BigRational, relative: f64) -> bool {
    (exact(result) - expected).abs() <= BigRational::from_float(relative).unwrap() * expected.abs()
}

/// A double-double of random digits, sign and size.
fn number() -> impl Strategy<Value = DoubleDouble> {
    (1.0..2.0f64, -1.0..1.0f64, -60..60i32, any::<bool>()).prop_map(|(lead, rest, exponent, negative)| {
        let scale = 2f64.powi(exponent) * if negative { -1.0 } else { 1.0 };
        DoubleDouble::from_sum(lead * scale, rest * scale * 2f64.powi(-53))
    })
}

fn decimal(digits: &str, places: usize) -> BigRational {
    format!("{digits}/1{}", "0".repeat(places)).parse().unwrap()
}

fn dd(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn sum_errs_by_at_most_3_u_squared(a in number(), b in number()) {
        prop_assert!(is_within(a + b, &(exact(a) + exact(b)), 3.001 * U_SQUARED));
        prop_assert!(is_within(a - b, &(exact(a) - exact(b)), 3.001 * U_SQUARED));
    }

    #[test]
    fn product_errs_by_at_most_5_u_squared(a in number(), b in number()) {
        prop_assert!(is_within(a * b, &(exact(a) * exact(b)), 5.0 * U_SQUARED));
    }

    #[test]
    fn quotient_and_root_err_by_less_than_epsilon(a in number(), b in number()) {
        prop_assert!(is_within(a / b, &(exact(a) / exact(b)), DoubleDouble::EPSILON));
        let root = exact(a.abs().sqrt());
        let square = exact(a.abs());
        // (1 + δ)² − 1 ≤ 2 δ (1 + δ)
        let bound = BigRational::from_float(2.001 * DoubleDouble::EPSILON).unwrap() * &square;
        prop_assert!((&root * &root - &square).abs() <= bound);
    }

    #[test]
    fn sums_of_two_f64_are_exact(a in -1e30..1e30f64, b in -1e10..1e10f64) {
        let sum = dd(a) + dd(b);
        prop_assert_eq!(exact(sum), BigRational::from_float(a).unwrap() + BigRational::from_float(b).unwrap());
        prop_assert_eq!(sum - dd(b), dd(a));
    }

    #[test]
    fn products_of_two_f64_are_exact(a in -1e30..1e30f64, b in -1e10..1e10f64) {
        let product = dd(a) * dd(b);
        let expected = BigRational::from_float(a).unwrap() * BigRational::from_float(b).unwrap();
        prop_assert_eq!(exact(product), expected);
    }

    #[test]
    fn sum_and_product_commute_bit_for_bit(a in number(), b in number()) {
        prop_assert_eq!(a + b, b + a);
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!(-(a - b), b - a);
    }

    #[test]
    fn order_is_that_of_the_exact_values(a in number(), rest in -1.0..1.0f64) {
        let b = a + dd(a.hi() * rest * U_SQUARED.sqrt());
        prop_assert_eq!(a.partial_cmp(&b), exact(a).partial_cmp(&exact(b)));
    }
}

#[test]
fn known_constants_hold_to_31_digits() {
    let root_two = decimal("14142135623730950488016887242096980785696718753769", 49);
    let pi = DoubleDouble::from_sum(core::f64::consts::PI, 1.224_646_799_147_353_2e-16);
    let pi_squared = decimal("98696044010893586188344909998761511353136994072408", 49);
    let root_pi = decimal("17724538509055160272981674833411451827975494561224", 49);
    let third = BigRational::new(1.into(), 3.into());
    let epsilon = DoubleDouble::EPSILON;
    assert!(is_within(dd(2.0).sqrt(), &root_two, epsilon));
    assert!(is_within(DoubleDouble::ONE / dd(3.0), &third, epsilon));
    assert!(is_within(pi * pi, &pi_squared, 2.0 * epsilon));
    assert!(is_within(pi.sqrt(), &root_pi, epsilon));
    assert!(is_within(pi / dd(2.0).sqrt() * dd(2.0).sqrt(), &exact(pi), 3.0 * epsilon));
}

#[test]
fn infinity_compares_and_adds_as_in_f64() {
    let infinity = DoubleDouble::INFINITY;
    assert!(dd(1e300) < infinity && -infinity < dd(-1e300));
    assert_eq!(infinity + dd(1.0), infinity);
    assert_eq!(dd(1.0) - infinity, -infinity);
    assert_eq!(infinity + infinity, infinity);
    assert_eq!(infinity * dd(-2.0), -infinity);
    assert_eq!(dd(1.0) / infinity, DoubleDouble::ZERO);
    assert_eq!(dd(1.0) / DoubleDouble::ZERO, infinity);
    assert_eq!(infinity / dd(2.0), infinity);
    assert_eq!(infinity.sqrt(), infinity);
    assert_eq!(dd(1e308) * dd(1e308), infinity);
    assert_eq!(dd(f64::MAX) + dd(f64::MAX), infinity);
    assert!(!infinity.is_finite() && dd(f64::MAX).is_finite());
    assert!((infinity - infinity).partial_cmp(&infinity).is_none());
}

#[test]
fn extremes_of_the_range_keep_their_digits() {
    for scale in [-1000, -900, -340, 340, 500, 900, 1000] {
        let x = dd(3.0) * dd(2f64.powi(scale));
        let root = x.sqrt() / dd(2f64.powi(scale / 2));
        assert!((root - dd(3.0).sqrt()).abs() < dd(1e-31), "2^{scale}");
        assert_eq!(x * dd(2f64.powi(-scale)), dd(3.0));
    }
    assert_eq!(dd(f64::MAX) * dd(1.0), dd(f64::MAX));
    assert_eq!(dd(0.0).sqrt(), dd(0.0));
    assert!(dd(-1.0).sqrt().to_f64().is_nan());
    assert_eq!(dd(-0.0).abs(), DoubleDouble::ZERO);
}

#[test]
fn exact_result_zero_is_zero() {
    let third = DoubleDouble::ONE / dd(3.0);
    assert!(exact(third - third).is_zero());
}
