//! The number a computation is carried out in.
//!
//! Flights, gaps and laws are generic over [`Scalar`], so that one copy of the physics runs in `f64` for speed, in
//! [`DoubleDouble`] to tell how far the `f64` answer can be trusted, and in [`Dual`] for exact derivatives through
//! events. Only `+ − × ÷ sqrt` are used during a run; all of them are correctly rounded in IEEE arithmetic, so the
//! bits are the same on every platform. A few laws of spheres were published with more, which goes through the one door of
//! `trigonometry.rs` and has the same bits everywhere too.

mod double_double;
mod dual;
mod trigonometry;

pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use trigonometry::{angle_deg, arccos, complementary_error_function, direction, ln, other_leg};

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number with the operations the engine uses.
///
/// Comparisons look at the value alone (for a dual number its real part), so that every scalar takes the branches
/// that its value implies. `f64` literals enter through [`Scalar::from_f64`] and are exact.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Positive infinity: the time of an event that never comes.
    const INFINITY: Self;
    /// Unit round-off: the largest relative error of one rounding (2⁻⁵³ for `f64`).
    const EPSILON: f64;

    /// The scalar that equals `value` exactly, with zero derivative.
    fn from_f64(value: f64) -> Self;

    /// The nearest `f64` to the value (for a dual number, its real part).
    fn to_f64(self) -> f64;

    /// The square root; not a number for a negative value.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Cosine and sine of an angle in radians.
    ///
    /// Used while a scenario is made ready, and by one law of cushions. In double-double the result is the `f64` one, since
    /// there the inputs of a computation are its `f64` values.
    fn cos_sin(self) -> (Self, Self);

    /// The exponential function, of a friction that was fitted with it. In double-double the result is the `f64` one.
    #[must_use]
    fn exp(self) -> Self;

    /// The angle in radians, from −π to π, of the direction with these components; zero where both vanish. In
    /// double-double the result is the `f64` one.
    #[must_use]
    fn angle(x: Self, y: Self) -> Self;

    /// Whether the value, and every derivative it carries, is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The same value without its derivatives, for the iterates of a search, whose history must leave no trace.
    #[inline(always)]
    #[must_use]
    fn detached(self) -> Self {
        self
    }

    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    /// The square.
    #[must_use]
    fn squared(self) -> Self {
        self * self
    }
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const INFINITY: Self = f64::INFINITY;
    const EPSILON: f64 = f64::EPSILON / 2.0;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    fn cos_sin(self) -> (Self, Self) {
        trigonometry::cos_sin(self)
    }

    fn exp(self) -> Self {
        trigonometry::exp(self)
    }

    fn angle(x: Self, y: Self) -> Self {
        trigonometry::angle(x, y)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
}
