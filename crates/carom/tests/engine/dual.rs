//! Dual numbers against analytic derivatives, and their real part against `f64`.

use carom::scalar::{Dual, Scalar};
use proptest::prelude::*;

type Pair = Dual<2>;

/// The first variable, whose derivative is then the first.
fn x(value: f64) -> Pair {
    Pair::variable(value, 0)
}

fn y(value: f64) -> Pair {
    Pair::variable(value, 1)
}

fn is_close(a: f64, b: f64) -> bool {
    // A handful of roundings on each side.
    (a - b).abs() <= 1e-14 * (a.abs() + b.abs() + 1e-300)
}

/// A program of operations on a stack of three numbers, the same for every scalar.
fn run_program<S: Scalar>(inputs: [f64; 3], program: &[(u8, u8, u8)], make: impl Fn(f64, usize) -> S) -> S {
    let mut stack = [make(inputs[0], 0), make(inputs[1], 1), make(inputs[2], 2)];
    for &(operation, from, to) in program {
        let (a, b) = (stack[from as usize % 3], stack[to as usize % 3]);
        stack[to as usize % 3] = match operation % 10 {
            0 => a + b,
            1 => a - b,
            2 => a * b,
            3 => a / b,
            4 => a.sqrt(),
            5 => -a,
            6 => a.abs(),
            7 => a.squared() + S::from_f64(0.3),
            8 => {
                let mut sum = b;
                sum += a;
                sum
            }
            _ => {
                let mut difference = b;
                difference -= a;
                if difference < a { difference } else { a }
            }
        };
    }
    stack[0] + stack[1] * stack[2]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn real_part_equals_f64_bit_for_bit(
        inputs in [-10.0..10.0f64, -10.0..10.0f64, -1e-3..1e-3f64],
        program in prop::collection::vec((any::<u8>(), any::<u8>(), any::<u8>()), 1..40),
    ) {
        let plain: f64 = run_program(inputs, &program, |value, _| value);
        let dual: Dual<3> = run_program(inputs, &program, Dual::variable);
        prop_assert!(plain.to_bits() == dual.value.to_bits() || (plain.is_nan() && dual.value.is_nan()));
    }

    #[test]
    fn each_operation_has_its_analytic_derivative(a in 0.1..10.0f64, b in 0.1..10.0f64) {
        let (p, q) = (x(a), y(b));
        prop_assert_eq!((p + q).derivatives, [1.0, 1.0]);
        prop_assert_eq!((p - q).derivatives, [1.0, -1.0]);
        prop_assert_eq!((p * q).derivatives, [b, a]);
        prop_assert_eq!((-p).derivatives, [-1.0, 0.0]);
        prop_assert_eq!((-p).abs().derivatives, [1.0, 0.0]);
        let quotient = (p / q).derivatives;
        prop_assert!(is_close(quotient[0], 1.0 / b) && is_close(quotient[1], -a / (b * b)));
        prop_assert!(is_close(p.sqrt().derivatives[0], 0.5 / a.sqrt()));
        let (cos, sin) = p.cos_sin();
        prop_assert_eq!((cos.derivatives[0], sin.derivatives[0]), (-sin.value, cos.value));
    }

    #[test]
    fn chains_follow_the_chain_rule(a in 0.1..10.0f64, b in 0.1..10.0f64) {
        // f = (x² + y²)^½ / (1 + x y)
        let one = Pair::constant(1.0);
        let f = (x(a).squared() + y(b).squared()).sqrt() / (one + x(a) * y(b));
        let (r, d) = ((a * a + b * b).sqrt(), 1.0 + a * b);
        // Terms of both signs: compare with the larger of them.
        let by_x = a / (r * d) - r * b / (d * d);
        prop_assert!((f.derivatives[0] - by_x).abs() <= 1e-14 * (a / (r * d) + r * b / (d * d)));
    }
}

#[test]
fn comparisons_look_at_the_value_alone() {
    assert_eq!(x(1.0), y(1.0));
    assert!(x(1.0) < y(2.0) && x(1.0) < Pair::INFINITY);
    assert!(x(f64::NAN).partial_cmp(&y(1.0)).is_none());
    assert_eq!(Pair::constant(-0.0).abs().value.to_bits(), 0);
}

#[test]
fn root_at_zero_is_finite_only_where_nothing_moves() {
    assert!(Pair::constant(0.0).sqrt().is_finite());
    let root = x(0.0).sqrt();
    assert_eq!(root.derivatives, [f64::INFINITY, 0.0]);
    assert!(!root.is_finite());
}

#[test]
fn infinity_stays_a_number_under_sums() {
    let sum = Pair::INFINITY + x(1.0);
    assert_eq!((sum.value, sum.derivatives), (f64::INFINITY, [1.0, 0.0]));
}
