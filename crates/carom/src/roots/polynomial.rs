//! Polynomials of degree at most four, as gaps between two flights.

use super::scale::{exponent, power_of_two};
use crate::scalar::Scalar;

/// A polynomial `a₀ + a₁ s + a₂ s² + a₃ s³ + a₄ s⁴`; leading coefficients may be zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial<S> {
    /// The coefficients in order of ascending power.
    pub coefficients: [S; 5],
}

impl<S: Scalar> Polynomial<S> {
    /// The polynomial with the given coefficients, in order of ascending power.
    #[inline(always)]
    pub const fn new(coefficients: [S; 5]) -> Self {
        Self { coefficients }
    }

    /// The value at `s` (Horner).
    #[inline(always)]
    pub fn value(&self, s: S) -> S {
        let [a0, a1, a2, a3, a4] = self.coefficients;
        (((a4 * s + a3) * s + a2) * s + a1) * s + a0
    }

    /// The derivative at `s`.
    #[inline(always)]
    pub fn slope(&self, s: S) -> S {
        self.value_and_slope(s).1
    }

    /// The value and the derivative at `s`, in one pass.
    #[inline(always)]
    pub fn value_and_slope(&self, s: S) -> (S, S) {
        let [a0, a1, a2, a3, a4] = self.coefficients;
        let (mut value, mut slope) = (a4, S::ZERO);
        for a in [a3, a2, a1, a0] {
            slope = slope * s + value;
            value = value * s + a;
        }
        (value, slope)
    }

    /// The derivative.
    #[inline]
    #[must_use]
    pub fn derivative(&self) -> Self {
        let [_, a1, a2, a3, a4] = self.coefficients;
        let times = |factor: f64, a: S| S::from_f64(factor) * a;
        Self::new([a1, times(2.0, a2), times(3.0, a3), times(4.0, a4), S::ZERO])
    }

    /// The same polynomial in powers of `s − center`.
    #[must_use]
    pub(super) fn taylor(&self, center: S) -> Self {
        let mut c = self.coefficients;
        for done in 0..4 {
            for i in (done..4).rev() {
                let above = c[i + 1];
                c[i] += above * center;
            }
        }
        Self::new(c)
    }

    /// What rounding may add to or take from the value at `s`: `16 ε Σ |aᵢ sⁱ|`.
    ///
    /// Horner's rule alone errs by at most half of this. A sign counts only beyond it.
    pub fn rounding_bound(&self, s: S) -> f64 {
        let s = s.to_f64().abs();
        let sum = self.coefficients.iter().rev().fold(0.0, |sum, a| sum * s + a.to_f64().abs());
        16.0 * S::EPSILON * sum
    }

    /// The coefficients in the Bernstein basis of degree 4 on `[0, horizon]`, between whose least and greatest the
    /// polynomial stays there: `b_j = Σ_{i≤j} C(j,i)/C(4,i) aᵢ Tⁱ`.
    pub fn bernstein(&self, horizon: S) -> [S; 5] {
        let [a0, a1, a2, a3, a4] = self.coefficients;
        let squared = horizon * horizon;
        let mut b = [
            a0,
            a1 * horizon * S::from_f64(0.25),
            a2 * squared / S::from_f64(6.0),
            a3 * (squared * horizon) * S::from_f64(0.25),
            a4 * (squared * squared),
        ];
        for first in 1..5 {
            for j in (first..5).rev() {
                let before = b[j - 1];
                b[j] += before;
            }
        }
        b
    }

    /// Whether the Bernstein coefficients prove that the polynomial is positive on all of `[0, horizon]`: a cheap
    /// rejection. `false` proves nothing.
    #[inline]
    pub fn is_positive_until(&self, horizon: S) -> bool {
        let bound = self.rounding_bound(horizon);
        self.bernstein(horizon).iter().all(|b| b.to_f64() > bound)
    }

    /// Whether no coefficient beyond the constant is negative, so that the slope never is (for `s ≥ 0`).
    #[inline(always)]
    pub(super) fn never_closes(&self) -> bool {
        self.coefficients[1..].iter().all(|a| *a >= S::ZERO)
    }

    /// Whether the value falls just after 0: the first derivative there that is not zero is negative.
    #[inline]
    pub(super) fn closes_at_start(&self) -> bool {
        self.coefficients[1..].iter().find(|a| **a != S::ZERO).is_some_and(|a| *a < S::ZERO)
    }

    /// A power of two beyond every root, and so beyond every root of every derivative, at which the leading term
    /// outweighs all others together (Fujiwara's bound from the binary exponents, doubled).
    pub(super) fn root_bound(&self) -> S {
        let Some(degree) = self.coefficients.iter().rposition(|a| *a != S::ZERO) else {
            return S::ZERO;
        };
        let leading = exponent(self.coefficients[degree]);
        let lower = self.coefficients[..degree].iter().enumerate().filter(|(_, a)| **a != S::ZERO);
        let exponents = lower.map(|(i, a)| {
            let steps = (degree - i) as i32;
            (exponent(*a) + 1 - leading + steps - 1).div_euclid(steps)
        });
        exponents.max().map_or(S::ZERO, |largest| power_of_two(largest + 2))
    }
}
