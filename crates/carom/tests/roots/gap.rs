//! The search for any smooth gap, against the polynomial one and closed forms.

use carom::roots::{Enclosure, Gap, Interval, Polynomial, closing_crossings, first_closing_crossing};
use carom::scalar::Dual;
use core::f64::consts::PI;
use proptest::prelude::*;

/// `level + cos t`, with the crudest enclosures: the slope is at most 1.
struct Cosine {
    level: f64,
}

impl Gap<f64> for Cosine {
    fn value(&self, t: f64) -> f64 {
        self.level + libm::cos(t)
    }

    fn slope(&self, t: f64) -> f64 {
        -libm::sin(t)
    }

    fn enclosure(&self, from: f64, to: f64) -> Enclosure<f64> {
        let (middle, half) = (from + 0.5 * (to - from), 0.5 * (to - from));
        let reach = half + 4.0 * f64::EPSILON * (1.0 + to.abs());
        Enclosure {
            value: Interval::around(self.value(middle), reach),
            slope: Interval::around(self.slope(middle), reach),
        }
    }
}

#[test]
fn circular_motion_crosses_where_the_cosine_says() {
    for level in [-0.9, -0.5, 0.0, 0.3, 0.999, 0.999_999] {
        let expected = libm::acos(-level);
        let found = first_closing_crossing(&Cosine { level }, 0.0, 20.0).unwrap();
        assert!((found - expected).abs() < 4e-16 * (1.0 + 1.0 / libm::sin(expected)), "{level}");
        let next = first_closing_crossing(&Cosine { level }, found, 20.0).unwrap();
        assert!((next - expected - 2.0 * PI).abs() < 4e-15 * (1.0 + 1.0 / libm::sin(expected)));
        assert_eq!(first_closing_crossing(&Cosine { level }, 0.0, 0.9 * expected), None);
    }
}

#[test]
fn circular_motion_that_grazes_or_stays_on_one_side_never_crosses() {
    for level in [1.0, 1.0 + 1e-15, 1.0 + 1e-9, 2.0, -1.0, -2.0] {
        assert_eq!(first_closing_crossing(&Cosine { level }, 0.0, 30.0), None, "{level}");
    }
}

#[test]
fn start_behind_must_come_out_first() {
    let found = first_closing_crossing(&Cosine { level: 0.0 }, PI, 10.0).unwrap();
    assert!((found - 2.5 * PI).abs() < 1e-14);
}

#[test]
fn dual_gap_has_the_derivative_of_its_crossing() {
    let gap = Polynomial::new([2.0, -3.0, 1.0, 0.0, 0.0].map(Dual::<1>::constant));
    let mut moved = gap;
    moved.coefficients[0] = Dual::variable(2.0, 0);
    let s = first_closing_crossing(&moved, Dual::constant(0.0), Dual::constant(5.0)).unwrap();
    assert!((s.value - 1.0).abs() < 1e-15 && (s.derivatives[0] - 1.0).abs() < 1e-14);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn general_search_agrees_with_the_polynomial_one(
        a in prop::array::uniform5(-4.0..4.0f64), degree in 1..5usize, horizon in 0.1..10.0f64
    ) {
        let coefficients = core::array::from_fn(|i| if i <= degree { a[i] } else { 0.0 });
        let gap = Polynomial::new(coefficients);
        let general = first_closing_crossing(&gap, 0.0, horizon);
        let special = closing_crossings(&gap, 0.0).next().filter(|s| *s < horizon);
        match (general, special) {
            (Some(s), Some(t)) => {
                let tolerance = gap.rounding_bound(s) / gap.slope(s).abs();
                prop_assert!((s - t).abs() <= tolerance.max(1e-14 * t));
            }
            (None, Some(t)) => prop_assert!(gap.value(horizon).abs() < 2.0 * gap.rounding_bound(horizon), "lost {t}"),
            (Some(s), None) => prop_assert!(false, "invented {s}"),
            (None, None) => {}
        }
    }

    #[test]
    fn enclosures_contain_values_and_slopes(
        a in prop::array::uniform5(-4.0..4.0f64), from in 0.0..5.0f64, width in 0.0..3.0f64, place in 0.0..1.0f64
    ) {
        let gap = Polynomial::new(a);
        let Enclosure { value, slope } = gap.enclosure(from, from + width);
        let t = from + place * width;
        let (v, d) = gap.value_and_slope(t);
        prop_assert!(value.lower <= v && v <= value.upper && slope.lower <= d && d <= slope.upper);
    }
}
