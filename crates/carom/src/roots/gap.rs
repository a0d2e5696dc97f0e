//! Closing crossings of any smooth gap, for flights that are no polynomials in time.

use super::Polynomial;
use super::newton::falling_root;
use super::sweep::{Side, Sign, Sweep, sign};
use crate::scalar::Scalar;

/// A closed interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<S> {
    /// The lower end.
    pub lower: S,
    /// The upper end.
    pub upper: S,
}

/// Bounds of a gap and of its slope over an interval of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure<S> {
    /// Contains every value, exact and computed.
    pub value: Interval<S>,
    /// Contains every slope.
    pub slope: Interval<S>,
}

/// A signed distance between two things as a smooth function of time.
pub trait Gap<S: Scalar> {
    /// The gap at time `t`.
    fn value(&self, t: S) -> S;

    /// Its derivative by time at `t`.
    fn slope(&self, t: S) -> S;

    /// Bounds over `from ≤ t ≤ to`.
    ///
    /// They hold for the computed values too, so that at a single instant (`from = to`) they tell how far rounding lets
    /// the value be known. A search ends sooner the narrower they are; they must narrow with the interval.
    fn enclosure(&self, from: S, to: S) -> Enclosure<S>;
}

impl<S: Scalar> Interval<S> {
    /// The interval of the numbers up to `radius` away from `center`.
    pub fn around(center: S, radius: S) -> Self {
        Self { lower: center - radius, upper: center + radius }
    }

    /// All products of a number of one and a number of the other.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let products = [
            self.lower * other.lower,
            self.lower * other.upper,
            self.upper * other.lower,
            self.upper * other.upper,
        ];
        let (mut lower, mut upper) = (products[0], products[0]);
        for product in products {
            lower = if product < lower { product } else { lower };
            upper = if product > upper { product } else { upper };
        }
        Self { lower, upper }
    }

    /// All sums of a number of one and a number of the other.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { lower: self.lower + other.lower, upper: self.upper + other.upper }
    }

    fn contains_zero(self) -> bool {
        !(self.lower > S::ZERO || self.upper < S::ZERO)
    }

    fn width(self) -> S {
        self.upper - self.lower
    }

    /// The largest absolute value.
    fn magnitude(self) -> S {
        let (lower, upper) = (self.lower.abs(), self.upper.abs());
        if lower > upper { lower } else { upper }
    }

    fn intersection(self, other: Self) -> Self {
        Self {
            lower: if other.lower > self.lower { other.lower } else { self.lower },
            upper: if other.upper < self.upper { other.upper } else { self.upper },
        }
    }
}

/// The first closing crossing of a gap with `from < t ≤ to` (`0 ≤ from`), after the gap has been positive.
///
/// The interval is halved until on each part the gap has one sign, or is monotone, or cannot be told from zero. As for
/// polynomials a crossing is certain once the gap is negative beyond its rounding, so a graze, and a crossing that the
/// interval ends on, are none. Searched for again from a crossing, the next one is found.
pub fn first_closing_crossing<S: Scalar, G: Gap<S>>(gap: &G, from: S, to: S) -> Option<S> {
    let sign_at = |t: S, value: S| sign(value, rounding(gap, t));
    let from = from.detached();
    let is_in_front = sign_at(from, gap.value(from)) == Sign::Positive;
    let mut sweep = Sweep::new(from, if is_in_front { Side::Front } else { Side::Behind });
    let mut here = from;
    let mut ends = vec![to.detached()];
    while let Some(end) = ends.last().copied() {
        let middle = here + (end - here) * S::from_f64(0.5);
        let is_divisible = middle > here && middle < end;
        if is_divisible && !is_settled(gap, here, middle, end) {
            ends.push(middle);
            continue;
        }
        ends.pop();
        here = end;
        let value = gap.value(end);
        if let Some((lo, hi)) = sweep.visit(end, value, sign_at(end, value)) {
            return Some(falling_root(lo, hi, |t| (gap.value(t), gap.slope(t)), |t| rounding(gap, t)));
        }
    }
    None
}

/// How far the computed value at `t` may be from the exact one.
fn rounding<S: Scalar, G: Gap<S>>(gap: &G, t: S) -> f64 {
    0.5 * gap.enclosure(t, t).value.width().to_f64()
}

/// Whether a part needs no further halving.
fn is_settled<S: Scalar, G: Gap<S>>(gap: &G, from: S, middle: S, to: S) -> bool {
    let part = gap.enclosure(from, to);
    if !part.value.contains_zero() || !part.slope.contains_zero() {
        return true;
    }
    // The mean value theorem narrows with the square of the width where the slope is about zero.
    let center = gap.enclosure(middle, middle).value;
    let round_up = S::ONE + S::from_f64(8.0 * S::EPSILON);
    let reach = part.slope.magnitude() * (to - from) * S::from_f64(0.5) * round_up;
    let mean_value = Interval { lower: center.lower - reach, upper: center.upper + reach };
    let value = part.value.intersection(mean_value);
    !value.contains_zero() || value.width() <= S::from_f64(4.0) * center.width()
}

impl<S: Scalar> Gap<S> for Polynomial<S> {
    fn value(&self, t: S) -> S {
        self.value(t)
    }

    fn slope(&self, t: S) -> S {
        self.slope(t)
    }

    /// From the Taylor coefficients about the middle.
    fn enclosure(&self, from: S, to: S) -> Enclosure<S> {
        let half = (to - from) * S::from_f64(0.5);
        let [c0, c1, c2, c3, c4] = self.taylor(from + half).coefficients;
        let magnitudes = Self::new([S::ZERO, c1.abs(), c2.abs(), c3.abs(), c4.abs()]);
        let (reach, steepest) = magnitudes.value_and_slope(half);
        let far = if to.abs() > from.abs() { to } else { from };
        let value_rounding = S::from_f64(self.rounding_bound(far));
        let slope_rounding = S::from_f64(self.derivative().rounding_bound(far));
        Enclosure {
            value: Interval::around(c0, reach + value_rounding),
            slope: Interval::around(c1, steepest - magnitudes.coefficients[1] + slope_rounding),
        }
    }
}
