//! Random polynomials of the hard kinds, against the exact oracle (PHYSICS E4).

use super::exact::{Crossing, Exact};
use carom::roots::{Polynomial, closing_crossings};
use proptest::prelude::*;

/// How surely a stretch between two crossings can be told from zero in rounded arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Clarity {
    /// Somewhere beyond twice the rounding bound: must be seen.
    Clear,
    /// Seen or not, both are right.
    Either,
    /// Nowhere beyond half of the rounding bound: must not be seen.
    Hidden,
}

/// Points of a stretch, denser towards its start; past the last crossing up to where the leading term rules.
fn samples(from: f64, to: f64) -> Vec<f64> {
    (1..60).map(|i| f64::from(i) / 60.0).map(|u| from + (to - from) * u * u).collect()
}

fn clarity(exact: &Exact, gap: &Polynomial<f64>, from: f64, to: f64) -> Clarity {
    let ratio = |s: &f64| exact.value_at(*s).abs() / gap.rounding_bound(*s);
    let largest = samples(from, to).iter().map(ratio).fold(0.0, f64::max);
    if largest > 2.0 {
        Clarity::Clear
    } else if largest < 0.5 {
        Clarity::Hidden
    } else {
        Clarity::Either
    }
}

/// Whether `found` is the crossing `at`: to 1e-9, or to what rounding of the coefficients' sum leaves knowable.
fn is_same(exact: &Exact, gap: &Polynomial<f64>, found: f64, at: f64) -> bool {
    let within_rounding = |u: f64| {
        let s = at + (found - at) * u;
        exact.value_at(s).abs() <= gap.rounding_bound(s)
    };
    (found - at).abs() <= 1e-9 * at || [0.25, 0.5, 0.75, 1.0].into_iter().all(within_rounding)
}

/// The falling crossings that may come first, and whether the last of them must if no other did.
fn candidates(exact: &Exact, gap: &Polynomial<f64>) -> (Vec<f64>, bool) {
    let crossings = exact.crossings();
    let end = |i: usize| crossings.get(i).map(|c: &Crossing| c.at.to_f64());
    let starts_in_front = crossings.first().is_some_and(|c| c.is_falling);
    let mut front = if starts_in_front { clarity(exact, gap, 0.0, end(0).unwrap()) } else { Clarity::Hidden };
    let mut possible = Vec::new();
    for (i, crossing) in crossings.iter().enumerate() {
        let from = crossing.at.to_f64();
        let after = clarity(exact, gap, from, end(i + 1).unwrap_or(4.0 * from));
        if !crossing.is_falling {
            front = if front == Clarity::Hidden { after } else { front };
        } else if front != Clarity::Hidden && after != Clarity::Hidden {
            possible.push(from);
            if front == Clarity::Clear && after == Clarity::Clear {
                return (possible, true);
            }
        }
    }
    (possible, false)
}

fn check(coefficients: [f64; 5]) -> Result<(), TestCaseError> {
    let (gap, exact) = (Polynomial::new(coefficients), Exact::new(&coefficients));
    let (possible, is_certain) = candidates(&exact, &gap);
    match closing_crossings(&gap, 0.0).next() {
        None => prop_assert!(!is_certain, "missed {:?} of {coefficients:?}", possible.last()),
        Some(found) => prop_assert!(
            possible.iter().any(|at| is_same(&exact, &gap, found, *at)),
            "{found} is none of {possible:?} of {coefficients:?}"
        ),
    }
    Ok(())
}

/// The product of a quadratic `s² − p s + q` with another, times a factor, rounded as it comes.
fn product([p, q]: [f64; 2], [u, v]: [f64; 2], factor: f64) -> [f64; 5] {
    [q * v, -(q * u + p * v), q + v + p * u, -(p + u), 1.0].map(|a| a * factor)
}

fn of_roots([a, b, c, d]: [f64; 4], factor: f64) -> [f64; 5] {
    product([a + b, a * b], [c + d, c * d], factor)
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0), 1e-6..1e6f64]
}

fn root() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 0.01..10.0f64, 1 => -10.0..-0.01f64]
}

/// A distance of 10⁻¹ to 10⁻¹⁶.
fn hair() -> impl Strategy<Value = f64> {
    (1..16i32, 1.0..10.0f64).prop_map(|(k, digit)| digit * 10f64.powi(-k))
}

/// Numbers with few bits, so that products of them are exact in `f64`.
fn short() -> impl Strategy<Value = f64> {
    (-400..400i32).prop_map(|n| f64::from(n) / 64.0)
}

#[test]
fn last_newton_step_never_leaves_a_cluster() {
    // Near the cluster both value and slope are rounding, and their quotient may be anything.
    for coefficients in [
        [-3852.239839896145, 1957.4126830380733, -372.77863608187755, 31.536662520960483, -1.0],
        [57932300.96555239, -65494789.88823188, 26638308.275642466, -4508335.11078602, 253482.5301184396],
    ] {
        check(coefficients).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn four_separate_real_roots(roots in [root(), root(), root(), root()], factor in factor()) {
        check(of_roots(roots, factor))?;
    }

    #[test]
    fn two_real_roots_and_a_complex_pair(a in root(), b in root(), re in root(), im in hair(), factor in factor()) {
        check(product([a + b, a * b], [2.0 * re, re * re + im * im], factor))?;
    }

    #[test]
    fn no_real_root_but_nearly(re in [root(), root()], im in [hair(), hair()], factor in factor()) {
        let pair = |i: usize| [2.0 * re[i], re[i] * re[i] + im[i] * im[i]];
        check(product(pair(0), pair(1), factor))?;
    }

    #[test]
    fn clusters_of_two(a in root(), b in root(), apart in [hair(), hair()], factor in factor()) {
        check(of_roots([a, a + apart[0], b, b + apart[1]], factor))?;
    }

    #[test]
    fn clusters_of_three(a in root(), b in root(), apart in [hair(), hair()], factor in factor()) {
        check(of_roots([a, a + apart[0], a - apart[1], b], factor))?;
    }

    #[test]
    fn clusters_of_four(a in root(), apart in [hair(), hair(), hair()], factor in factor()) {
        check(of_roots([a, a + apart[0], a - apart[1], a + apart[2]], factor))?;
    }

    #[test]
    fn exact_double_roots(a in short(), b in short(), c in short(), sign in prop_oneof![Just(1.0), Just(-1.0)]) {
        check(of_roots([a, a, b, c], sign))?;
        check(of_roots([a, a, b, b], sign))?;
    }

    #[test]
    fn exact_triple_and_quadruple_roots(a in short(), b in short(), sign in prop_oneof![Just(1.0), Just(-1.0)]) {
        check(of_roots([a, a, a, b], sign))?;
        check(of_roots([a, a, a, a], sign))?;
    }

    #[test]
    fn roots_of_very_different_size(k in [-8..8i32, -8..8, -8..8, -8..8], digits in [root(), root(), root(), root()]) {
        let at = |i: usize| digits[i] * 10f64.powi(k[i]);
        check(of_roots([at(0), at(1), at(2), at(3)], 1.0))?;
    }

    #[test]
    fn any_coefficients(a in prop::array::uniform5(-10.0..10.0f64), k in prop::array::uniform5(-12..3i32)) {
        check([0, 1, 2, 3, 4].map(|i: usize| a[i] * 10f64.powi(k[i])))?;
    }

    #[test]
    fn lower_degrees(a in prop::array::uniform4(-10.0..10.0f64), degree in 0..4usize) {
        let coefficient = |i: usize| if i <= degree { a[i] } else { 0.0 };
        check([coefficient(0), coefficient(1), coefficient(2), coefficient(3), 0.0])?;
    }

    #[test]
    fn cubics_with_clusters(a in root(), b in root(), apart in hair(), factor in factor()) {
        let (p, q) = (a + (a + apart), a * (a + apart));
        check([-q * b, q + p * b, -(p + b), 1.0, 0.0].map(|c| c * factor))?;
    }

    #[test]
    fn crossings_alternate_and_increase(roots in [root(), root(), root(), root()], factor in factor()) {
        let gap = Polynomial::new(of_roots(roots, factor));
        let found: Vec<f64> = closing_crossings(&gap, 0.0).collect();
        prop_assert!(found.len() <= 2 && found.windows(2).all(|pair| pair[0] < pair[1]));
        // Asked again from a crossing, the search goes on with the next.
        for pair in found.windows(2) {
            let next = closing_crossings(&gap, pair[0]).next();
            prop_assert!(next.is_some_and(|next| (next - pair[1]).abs() <= 1e-9 * pair[1]));
        }
    }
}
