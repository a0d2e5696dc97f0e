//! Double-double arithmetic: an unevaluated sum of two `f64`, some 31 decimal digits.
//!
//! A twin run in this scalar, from the same `f64` inputs, tells how far the `f64` answer can be trusted.
//!
//! Symbols: `u = 2⁻⁵³`, the unit round-off of `f64`. A value `hi + lo` has `|lo| ≤ u |hi|`. Errors are relative to the
//! exact result while no partial product underflows, that is while results stay above about 10⁻²⁷⁰.
//!
//! # References
//!
//! - T. J. Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18 (1971).
//! - M. Joldes, J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for basic building blocks of double-word
//!   arithmetic*, ACM Trans. Math. Softw. 44 (2017): sum 3u², product 5u² (as corrected in 2022).

use super::Scalar;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// An unevaluated sum of two `f64` that do not overlap.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// `a + b` exactly, as the rounded sum and its error (Knuth).
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// A number as the sum of two that have at most 26 significant bits each (Veltkamp).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2²⁷ + 1
    const LARGE: f64 = f64::from_bits((1023 + 990) << 52); // 2⁹⁹⁰, beyond which FACTOR · a may overflow
    const DOWN: f64 = f64::from_bits((1023 - 28) << 52);
    const UP: f64 = f64::from_bits((1023 + 28) << 52);
    let (a, back) = if a.abs() > LARGE { (a * DOWN, UP) } else { (a, 1.0) };
    let scaled = FACTOR * a;
    let high = scaled - (scaled - a);
    (high * back, (a - high) * back)
}

/// `a · b` exactly, as the rounded product and its error (Dekker; no fused operation, so the same bits everywhere).
#[inline(always)]
fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

impl DoubleDouble {
    /// The sum of two `f64`, exactly.
    #[inline(always)]
    pub fn from_sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self::renormalised(hi, lo)
    }

    /// The nearest `f64`.
    #[inline(always)]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// What the nearest `f64` leaves over.
    #[inline(always)]
    pub const fn lo(self) -> f64 {
        self.lo
    }

    /// The sum of a number and a correction of at most its size.
    ///
    /// A correction that is not finite is dropped: it comes from an infinite or overflowing leading part, which alone
    /// then is the answer. So infinities compare and add as those of `f64` do.
    #[inline(always)]
    fn renormalised(leading: f64, correction: f64) -> Self {
        let hi = leading + correction;
        if hi.is_finite() {
            Self { hi, lo: correction - (hi - leading) }
        } else {
            Self { hi: leading, lo: 0.0 }
        }
    }

    /// The product with a power of two, which is exact.
    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> Self {
        Self { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    #[inline(always)]
    fn times_f64(self, factor: f64) -> Self {
        let (product, error) = two_prod(self.hi, factor);
        Self::renormalised(product, error + self.lo * factor)
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.hi, other.hi);
        let (low, low_error) = two_sum(self.lo, other.lo);
        let sum = Self::renormalised(high, high_error + low);
        Self::renormalised(sum.hi, sum.lo + low_error)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_prod(self.hi, other.hi);
        Self::renormalised(product, error + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Long division with three `f64` digits.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other.times_f64(first);
        let second = rest.hi / other.hi;
        let rest = rest - other.times_f64(second);
        let third = rest.hi / other.hi;
        let quotient = Self::renormalised(first, second);
        Self::renormalised(quotient.hi, quotient.lo + third)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl AddAssign for DoubleDouble {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Scalar for DoubleDouble {
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    const INFINITY: Self = Self { hi: f64::INFINITY, lo: 0.0 };
    /// 8u²: above the error of every operation here.
    const EPSILON: f64 = f64::from_bits((1023 - 103) << 52);

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.hi
    }

    /// One Newton step from the root of the leading part; very large and very small values are scaled first, so that
    /// its square is exact.
    fn sqrt(self) -> Self {
        const UP: f64 = f64::from_bits((1023 + 300) << 52);
        const DOWN: f64 = f64::from_bits((1023 - 300) << 52);
        const HALF_UP: f64 = f64::from_bits((1023 + 150) << 52);
        const HALF_DOWN: f64 = f64::from_bits((1023 - 150) << 52);
        if self.hi > 0.0 && self.hi < DOWN {
            return self.scaled(UP).sqrt().scaled(HALF_DOWN);
        }
        if self.hi > UP && self.hi.is_finite() {
            return self.scaled(DOWN).sqrt().scaled(HALF_UP);
        }
        let root = self.hi.sqrt();
        let (square, error) = two_prod(root, root);
        let rest = self - Self { hi: square, lo: error };
        Self::renormalised(root, rest.hi / (root + root))
    }

    fn cos_sin(self) -> (Self, Self) {
        let (cos, sin) = self.hi.cos_sin();
        (Self::from_f64(cos), Self::from_f64(sin))
    }

    fn exp(self) -> Self {
        Self::from_f64(Scalar::exp(self.hi))
    }

    fn angle(x: Self, y: Self) -> Self {
        Self::from_f64(Scalar::angle(x.hi, y.hi))
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.hi.is_finite()
    }
}
