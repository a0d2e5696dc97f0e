//! Coefficients of the laws of spheres: constant, or depending on how a contact is met.

use crate::scalar::Scalar;

/// A coefficient of restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NormalRestitution<S> {
    /// The same at every speed, from 0 to 1.
    Constant(S),
    /// The polynomial `c0 + c1 u + c2 u²` of the closing speed u; beyond `up_to`, its value there.
    BySpeed {
        /// c0, c1, c2.
        coefficients: [S; 3],
        /// The largest speed at which the polynomial holds.
        up_to: S,
    },
}

/// A coefficient of friction between balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlipFriction<S> {
    /// The same at every speed.
    Constant(S),
    /// `a + b exp(−c s)` of the slip speed s.
    BySlip {
        /// What is left at high speed.
        a: S,
        /// What a slow slip has more.
        b: S,
        /// How fast that fades, one over a speed.
        c: S,
    },
}

/// A coefficient of friction between a ball and a cushion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IncidenceFriction<S> {
    /// The same at every angle.
    Constant(S),
    /// `c0 + c1 θ` of the angle θ, in radians, between the velocity and the normal; none below zero.
    ByIncidence {
        /// c0, c1.
        coefficients: [S; 2],
    },
}

impl<S: Scalar> NormalRestitution<S> {
    /// The coefficient of a ball that closes at this speed.
    #[inline(always)]
    pub fn at(&self, closing_speed: S) -> S {
        match *self {
            Self::Constant(value) => value,
            Self::BySpeed { coefficients: [c0, c1, c2], up_to } => {
                let speed = if closing_speed < up_to { closing_speed } else { up_to };
                c0 + speed * (c1 + speed * c2)
            }
        }
    }

    /// Whether it is one at every speed.
    pub fn is_one(&self) -> bool {
        matches!(*self, Self::Constant(value) if value == S::ONE)
    }
}

impl<S: Scalar> SlipFriction<S> {
    /// Alciatore's fit to Marlow's measurements, speeds in m/s.
    pub fn alciatore() -> Self {
        Self::BySlip { a: S::from_f64(9.951e-3), b: S::from_f64(0.108), c: S::from_f64(1.088) }
    }

    /// The coefficient of contacts that slip at this speed.
    #[inline(always)]
    pub fn at(&self, slip_speed: S) -> S {
        match *self {
            Self::Constant(value) => value,
            Self::BySlip { a, b, c } => a + b * (-(c * slip_speed)).exp(),
        }
    }

    /// Whether there is none at any speed.
    pub fn is_zero(&self) -> bool {
        match *self {
            Self::Constant(value) => value == S::ZERO,
            Self::BySlip { a, b, .. } => a == S::ZERO && b == S::ZERO,
        }
    }
}

impl<S: Scalar> IncidenceFriction<S> {
    /// The coefficient of a ball with this speed towards the cushion and this speed along it, neither below zero.
    #[inline(always)]
    pub fn at(&self, closing_speed: S, speed_along: S) -> S {
        match *self {
            Self::Constant(value) => value,
            Self::ByIncidence { coefficients: [c0, c1] } => {
                let value = c0 + c1 * S::angle(closing_speed, speed_along);
                if value < S::ZERO { S::ZERO } else { value }
            }
        }
    }

    /// Whether there is none at any angle.
    pub fn is_zero(&self) -> bool {
        match *self {
            Self::Constant(value) => value == S::ZERO,
            Self::ByIncidence { coefficients: [c0, c1] } => c0 == S::ZERO && c1 == S::ZERO,
        }
    }
}
