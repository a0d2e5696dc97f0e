//! When a gap first makes contact: the rule that starts from where the two things are now.

use super::Polynomial;
use super::closing::{ClosingCrossings, closing_crossings};
use super::sweep::{Side, Sign, sign};
use crate::scalar::Scalar;

/// What the contact rule asks of a gap.
pub(super) trait Approach<S: Scalar> {
    /// The gap at 0.
    fn start(&self) -> S;

    /// Whether it falls just after 0.
    fn closes_at_start(&self) -> bool;

    /// The first `s ≥ 0` after which a gap that does not close at the start falls.
    fn turn(&self) -> Option<S>;

    /// Whether the gap at its turn is positive beyond its rounding.
    fn is_in_front(&self, turn: S) -> bool;

    /// The closing crossings at `s > from`, in order.
    fn crossings(&self, from: S, side: Side) -> impl Iterator<Item = S>;
}

/// The first contact of a polynomial gap at `s ≥ 0` that `accept` agrees to (its foot lies on the cushion, say).
///
/// `delta` is the tolerance of contact in the units of the gap, which for a squared gap are those of a length squared.
///
/// - `g(0) > delta`: the first closing crossing.
/// - `|g(0)| ≤ delta`, in contact. Closing: now, `s = 0`; if that is refused, the next crossing counts. Opening: not
///   until the slope turns negative again; at that turn if the gap is still not positive there, else at the next zero.
/// - `g(0) < −delta`, behind: ignored until the gap has been positive, then the next closing crossing.
///
/// *Closing* at the start means that the first derivative which is not zero is negative. Two things in contact that
/// do not move against each other have no event.
///
/// ```
/// use carom::roots::{Polynomial, first_contact};
///
/// let thrown_up = Polynomial::new([0.0, 2.0, -1.0, 0.0, 0.0]);
/// assert_eq!(first_contact(&thrown_up, 1e-12, |_| true), Some(2.0));
/// let pressed = Polynomial::new([0.0, 0.0, -1.0, 0.0, 0.0]);
/// assert_eq!(first_contact(&pressed, 1e-12, |_| true), Some(0.0));
/// ```
pub fn first_contact<S: Scalar>(gap: &Polynomial<S>, delta: S, accept: impl FnMut(S) -> bool) -> Option<S> {
    first_contact_of(gap, delta, accept)
}

/// The first `s ≥ 0` after which the slope of `gap` is negative: 0 if it closes at the start, else its first maximum.
pub fn first_turn<S: Scalar>(gap: &Polynomial<S>) -> Option<S> {
    if gap.closes_at_start() { Some(S::ZERO) } else { gap.turn() }
}

#[inline]
pub(super) fn first_contact_of<S: Scalar, G: Approach<S>>(
    gap: &G,
    delta: S,
    mut accept: impl FnMut(S) -> bool,
) -> Option<S> {
    let start = gap.start();
    if start > delta {
        return gap.crossings(S::ZERO, Side::Front).find(|s| accept(*s));
    }
    if start < -delta {
        return gap.crossings(S::ZERO, Side::Behind).find(|s| accept(*s));
    }
    let (contact, side) = if gap.closes_at_start() {
        (S::ZERO, if start > S::ZERO { Side::Front } else { Side::Behind })
    } else {
        let turn = gap.turn()?;
        if gap.is_in_front(turn) {
            return gap.crossings(turn, Side::Front).find(|s| accept(*s));
        }
        (turn, Side::Behind)
    };
    if accept(contact) { Some(contact) } else { gap.crossings(contact, side).find(|s| accept(*s)) }
}

impl<S: Scalar> Approach<S> for Polynomial<S> {
    #[inline]
    fn start(&self) -> S {
        self.coefficients[0]
    }

    #[inline]
    fn closes_at_start(&self) -> bool {
        Polynomial::closes_at_start(self)
    }

    fn turn(&self) -> Option<S> {
        if self.never_closes() {
            return None;
        }
        closing_crossings(&self.derivative(), S::ZERO).next()
    }

    fn is_in_front(&self, turn: S) -> bool {
        sign(self.value(turn), self.rounding_bound(turn)) == Sign::Positive
    }

    #[inline]
    fn crossings(&self, from: S, side: Side) -> impl Iterator<Item = S> {
        ClosingCrossings::new(self, from, side)
    }
}
