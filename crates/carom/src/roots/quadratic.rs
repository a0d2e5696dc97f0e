//! Quadratic gaps in closed form: the hot path of discs in free flight and of straight cushions.
//!
//! With `g(s) = a₀ + a₁ s + a₂ s²`, `h = a₁/2` and `r = √(h² − a₂ a₀)`, the slope at the two roots is ±2 r, so that
//! exactly one of them is a closing crossing: `a₀ / (r − h)`, which equals `−(h + r) / a₂`. Whichever of the two adds
//! numbers of one sign is used. The same forms serve falling and rising parabolas and straight lines.

use super::contact::{Approach, first_contact_of};
use super::scale::{exponent, power_of_two};
use super::sweep::Side;
use crate::scalar::Scalar;

/// A gap of degree at most two: `a₀ + a₁ s + a₂ s²`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic<S> {
    /// The coefficients in order of ascending power.
    pub coefficients: [S; 3],
}

impl<S: Scalar> Quadratic<S> {
    /// The quadratic with the given coefficients, in order of ascending power.
    #[inline(always)]
    pub const fn new(coefficients: [S; 3]) -> Self {
        Self { coefficients }
    }

    /// The closing crossing at `s > 0`: where the quadratic goes from positive to negative.
    ///
    /// None for a graze, that is when the discriminant does not exceed its own rounding.
    #[inline]
    pub fn closing_crossing(&self) -> Option<S> {
        let [a0, a1, a2] = self.coefficients;
        if a1 >= S::ZERO && a2 >= S::ZERO {
            return None;
        }
        let half = a1 * S::from_f64(0.5);
        let root = root_of_discriminant(a0, half, a2)?;
        let s = if half <= S::ZERO { a0 / (root - half) } else { -(half + root) / a2 };
        (s > S::ZERO && s < S::INFINITY).then_some(s)
    }

    /// The first contact under the rule of [`first_contact`](super::first_contact).
    #[inline]
    pub fn first_contact(&self, delta: S, accept: impl FnMut(S) -> bool) -> Option<S> {
        first_contact_of(self, delta, accept)
    }

    /// The positive roots in ascending order, or the vertex where rounding cannot tell two roots from none; what is
    /// absent is infinite.
    pub(super) fn positive_roots_or_vertex(&self) -> [S; 2] {
        let [a0, a1, a2] = self.coefficients;
        let half = a1 * S::from_f64(0.5);
        let candidates = match root_of_discriminant(a0, half, a2) {
            Some(root) => {
                let sum = if half > S::ZERO { -(half + root) } else { root - half };
                [sum / a2, a0 / sum]
            }
            None => [-half / a2, S::INFINITY],
        };
        let [a, b] = candidates.map(|s| if s > S::ZERO { s.detached() } else { S::INFINITY });
        if b < a { [b, a] } else { [a, b] }
    }
}

impl<S: Scalar> Approach<S> for Quadratic<S> {
    #[inline(always)]
    fn start(&self) -> S {
        self.coefficients[0]
    }

    #[inline(always)]
    fn closes_at_start(&self) -> bool {
        let [_, a1, a2] = self.coefficients;
        a1 < S::ZERO || (a1 == S::ZERO && a2 < S::ZERO)
    }

    #[inline]
    fn turn(&self) -> Option<S> {
        let [_, a1, a2] = self.coefficients;
        (a2 < S::ZERO && a1 >= S::ZERO).then(|| -(a1 * S::from_f64(0.5)) / a2)
    }

    #[inline]
    fn is_in_front(&self, _turn: S) -> bool {
        self.closing_crossing().is_some()
    }

    /// At most one, whatever the side: a root with falling slope has a positive gap before it.
    #[inline]
    fn crossings(&self, from: S, _side: Side) -> impl Iterator<Item = S> {
        self.closing_crossing().filter(|s| *s > from).into_iter()
    }
}

/// `√(h² − a₂ a₀)`, or none when the radicand is not positive beyond its rounding.
#[inline(always)]
fn root_of_discriminant<S: Scalar>(a0: S, half: S, a2: S) -> Option<S> {
    let squared = half * half;
    let discriminant = squared - a2 * a0;
    if squared.to_f64() > 1e-260 && discriminant.to_f64() < 1e300 {
        exceeds_rounding(discriminant, squared).then(|| discriminant.sqrt())
    } else {
        root_of_extreme_discriminant(a0, half, a2)
    }
}

/// Near a double root both terms of `h² − a₂ a₀` are about `h²`, and the two products err by little more than `2 ε h²`.
#[inline(always)]
fn exceeds_rounding<S: Scalar>(discriminant: S, squared: S) -> bool {
    discriminant.to_f64() > 3.0 * S::EPSILON * squared.to_f64()
}

/// The same where a square would leave the range of `f64`, with every factor scaled by a power of two.
#[cold]
fn root_of_extreme_discriminant<S: Scalar>(a0: S, half: S, a2: S) -> Option<S> {
    const NEGLIGIBLE: i32 = 240; // bits: beyond the precision of every scalar
    // Powers of two up to 2^±1022 and their reciprocals are normal numbers.
    let [e0, e1, e2] = [a0, half, a2].map(|a| exponent(a).clamp(-1022, 1022));
    let excess = e0 + e2 - 2 * e1; // |a₀ a₂| is about 2^excess h²
    let product_is_zero = a0 == S::ZERO || a2 == S::ZERO;
    if half != S::ZERO && (product_is_zero || excess < -NEGLIGIBLE) {
        let size = half.abs();
        return Some(size - S::from_f64(0.5) * (a2 / size) * a0);
    }
    if half == S::ZERO || excess > NEGLIGIBLE {
        let is_real = !product_is_zero && (a0 < S::ZERO) != (a2 < S::ZERO);
        return is_real.then(|| a0.abs().sqrt() * a2.abs().sqrt());
    }
    let squared = (half * power_of_two(-e1)).squared();
    let discriminant = squared - (a2 * power_of_two(-e2)) * (a0 * power_of_two(-e0)) * power_of_two(excess);
    exceeds_rounding(discriminant, squared).then(|| discriminant.sqrt() * power_of_two(e1))
}
