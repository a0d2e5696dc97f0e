//! Dual numbers: a value together with its derivatives, for exact derivatives through events.
//!
//! The real part takes exactly the operations that `f64` takes, in the same order, and comparisons look at it alone.
//! So a run in dual numbers is the `f64` run, bit for bit, with derivatives beside it (forward-mode differentiation).

use super::Scalar;
use core::array::from_fn;
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivatives by `N` variables.
///
/// ```
/// use carom::scalar::{Dual, Scalar};
///
/// let x = Dual::<2>::variable(3.0, 0);
/// let y = Dual::<2>::variable(4.0, 1);
/// let length = (x * x + y * y).sqrt();
/// assert_eq!((length.value, length.derivatives), (5.0, [3.0 / 5.0, 4.0 / 5.0]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dual<const N: usize> {
    /// The real part.
    pub value: f64,
    /// The derivative by each variable.
    pub derivatives: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The variable with the given index (below `N`): its own derivative is one.
    pub fn variable(value: f64, index: usize) -> Self {
        Self { value, derivatives: from_fn(|i| if i == index { 1.0 } else { 0.0 }) }
    }

    /// A number that depends on no variable.
    #[inline(always)]
    pub const fn constant(value: f64) -> Self {
        Self { value, derivatives: [0.0; N] }
    }

    #[inline(always)]
    fn with(value: f64, derivative: impl FnMut(usize) -> f64) -> Self {
        Self { value, derivatives: from_fn(derivative) }
    }
}

impl<const N: usize> PartialEq for Dual<N> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const N: usize> PartialOrd for Dual<N> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::with(self.value + other.value, |i| self.derivatives[i] + other.derivatives[i])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::with(self.value - other.value, |i| self.derivatives[i] - other.derivatives[i])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;

    #[allow(clippy::suspicious_arithmetic_impl)] // the product rule adds
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::with(self.value * other.value, |i| {
            self.derivatives[i] * other.value + self.value * other.derivatives[i]
        })
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;

    #[allow(clippy::suspicious_arithmetic_impl)] // the quotient rule multiplies and subtracts
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Self::with(quotient, |i| (self.derivatives[i] - quotient * other.derivatives[i]) / other.value)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::with(-self.value, |i| -self.derivatives[i])
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const N: usize> Scalar for Dual<N> {
    const ZERO: Self = Self::constant(0.0);
    const ONE: Self = Self::constant(1.0);
    const INFINITY: Self = Self::constant(f64::INFINITY);
    const EPSILON: f64 = <f64 as Scalar>::EPSILON;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.value
    }

    /// The square root. At zero a vanishing derivative stays zero and any other becomes infinite, which
    /// [`Scalar::is_finite`] reports.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::with(root, |i| {
            let derivative = self.derivatives[i];
            if derivative == 0.0 { 0.0 } else { derivative / (root + root) }
        })
    }

    fn cos_sin(self) -> (Self, Self) {
        let (cos, sin) = self.value.cos_sin();
        (Self::with(cos, |i| -sin * self.derivatives[i]), Self::with(sin, |i| cos * self.derivatives[i]))
    }

    fn exp(self) -> Self {
        let value = Scalar::exp(self.value);
        Self::with(value, |i| value * self.derivatives[i])
    }

    /// The angle of a direction. Where both components vanish it has no derivative, and those it gets are not a number
    /// unless they vanish too.
    fn angle(x: Self, y: Self) -> Self {
        let squared = x.value * x.value + y.value * y.value;
        Self::with(Scalar::angle(x.value, y.value), |i| {
            let turned = x.value * y.derivatives[i] - y.value * x.derivatives[i];
            if turned == 0.0 { 0.0 } else { turned / squared }
        })
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.derivatives.iter().all(|derivative| derivative.is_finite())
    }

    #[inline(always)]
    fn detached(self) -> Self {
        Self::constant(self.value)
    }

    /// The absolute value; its derivative takes the sign of the value, plus at zero.
    #[inline(always)]
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { Self { value: self.value.abs(), ..self } }
    }
}
