//! A safeguarded Newton iteration inside a bracket.

use super::sweep::{Sign, sign};
use crate::scalar::Scalar;

/// The root between `lo`, where the function is positive, and `hi > lo ≥ 0`, where it is not.
///
/// `evaluate` gives value and slope, `rounding` a bound of the value's rounding error. Newton steps are taken while
/// they stay in the bracket and halve each time, bisections otherwise; it ends when the bracket has no interior
/// scalar, or when within the rounding Newton makes no more progress. All branches look at values alone.
///
/// The last operation is one plain Newton step from a detached point, which gives dual numbers their exact derivative
/// −∂g/g′ and leaves the real part what it is in `f64`.
pub(super) fn falling_root<S: Scalar>(
    lo: S,
    hi: S,
    evaluate: impl Fn(S) -> (S, S),
    rounding: impl Fn(S) -> f64,
) -> S {
    let root = standing_point(lo, hi, &evaluate, &rounding);
    let (value, slope) = evaluate(root);
    let polished = root - value / slope;
    let is_in_bracket = polished >= lo && polished <= hi;
    if is_in_bracket && sign(evaluate(polished.detached()).0, rounding(polished)) == Sign::Unclear {
        return polished;
    }
    // The slope is lost in rounding and the step leads astray: keep the point. Its derivative is whatever the slope
    // makes of it, infinite where that is zero.
    let change = value - value.detached();
    let kept = if slope == S::ZERO { root - change.sqrt() } else { root - change / slope };
    if kept == root { kept } else { root }
}

fn standing_point<S: Scalar>(
    mut lo: S,
    mut hi: S,
    evaluate: impl Fn(S) -> (S, S),
    rounding: impl Fn(S) -> f64,
) -> S {
    let mut x = lo;
    let mut last_step = hi - lo;
    loop {
        let (value, slope) = evaluate(x);
        if value == S::ZERO {
            return x;
        }
        if value > S::ZERO {
            lo = x
        } else {
            hi = x
        }
        let newton = (x - value / slope).detached();
        let step = (newton - x).abs();
        let is_safe = newton > lo && newton < hi && step + step <= last_step;
        if !is_safe && sign(value, rounding(x)) == Sign::Unclear {
            return x;
        }
        let next = if is_safe { newton } else { midpoint(lo, hi) };
        if !(next > lo && next < hi) {
            return x;
        }
        last_step = if is_safe { step } else { hi - lo };
        x = next;
    }
}

/// A point well inside the bracket: halfway, or a few powers of two down while the ends differ by many.
fn midpoint<S: Scalar>(lo: S, hi: S) -> S {
    let is_wide = hi > S::from_f64(64.0) * lo;
    let middle = if is_wide { hi * S::from_f64(0.0625) } else { lo + (hi - lo) * S::from_f64(0.5) };
    middle.detached()
}
