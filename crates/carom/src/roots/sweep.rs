//! Signs beyond rounding, and the walk that finds certain sign changes.

use crate::scalar::Scalar;

/// Where a value stands to zero, as far as rounding lets us tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Negative,
    Unclear,
    Positive,
}

/// The sign of a value whose error is at most `bound`.
#[inline]
pub(super) fn sign<S: Scalar>(value: S, bound: f64) -> Sign {
    let value = value.to_f64();
    if value > bound || value == f64::INFINITY {
        Sign::Positive
    } else if value < -bound || value == f64::NEG_INFINITY {
        Sign::Negative
    } else {
        Sign::Unclear
    }
}

/// Where a gap is known to be at the start of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Positive: the next zero is a closing crossing.
    Front,
    /// Not positive: it has to become so before it can close.
    Behind,
}

/// A walk along increasing points between which a function is monotone, in search of certain falling sign changes.
#[derive(Clone, Debug)]
pub(super) struct Sweep<S> {
    /// Whether the function has been positive since the start or the last crossing.
    is_armed: bool,
    /// The last point with a positive value.
    lo: S,
    /// The first point after it with a value that is not.
    hi: Option<S>,
}

impl<S: Scalar> Sweep<S> {
    pub(super) fn new(from: S, side: Side) -> Self {
        Self { is_armed: side == Side::Front, lo: from, hi: None }
    }

    /// Takes the next point; gives a bracket when it completes a crossing.
    pub(super) fn visit(&mut self, point: S, value: S, sign: Sign) -> Option<(S, S)> {
        match sign {
            Sign::Positive => *self = Self { is_armed: true, lo: point, hi: None },
            Sign::Unclear if self.hi.is_none() => {
                if value > S::ZERO {
                    self.lo = point;
                } else {
                    self.hi = Some(point);
                }
            }
            Sign::Unclear => {}
            Sign::Negative => {
                let hi = self.hi.take().unwrap_or(point);
                if core::mem::take(&mut self.is_armed) {
                    return Some((self.lo, hi));
                }
            }
        }
        None
    }
}
