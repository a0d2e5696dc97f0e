//! The closing crossings of a polynomial gap, in order.
//!
//! The critical points of the gap cut the half line into monotone pieces. They come from the derivative, which is cut
//! in the same way in its turn, down to a quadratic in closed form; no complex number occurs. Walking along the cuts,
//! a crossing is certain once the gap has been positive beyond its rounding and then is negative beyond it. A minimum
//! that rounding cannot tell from zero is a graze, not a crossing.
//!
//! More cuts than there are critical points do no harm, and a pair of critical points missed because the derivative
//! does not leave its rounding between them leaves the gap monotone within its rounding. That is why this search is
//! safe near multiple roots, and when leading coefficients vanish or are only rounding themselves.

use super::newton::falling_root;
use super::sweep::{Side, Sign, Sweep, sign};
use super::{Polynomial, Quadratic};
use crate::scalar::Scalar;

/// The closing crossings of `gap` at `s > from`, in increasing order, found one at a time as they are asked for.
///
/// A crossing counts only after the gap has been positive since `from`. There is no horizon: the answer depends on
/// the coefficients alone.
///
/// ```
/// use carom::roots::{Polynomial, closing_crossings};
///
/// let gap = Polynomial::new([24.0, -50.0, 35.0, -10.0, 1.0]); // (s − 1)(s − 2)(s − 3)(s − 4)
/// let crossings: Vec<f64> = closing_crossings(&gap, 0.0).collect();
/// assert_eq!(crossings.len(), 2);
/// assert!((crossings[0] - 1.0).abs() < 1e-13 && (crossings[1] - 3.0).abs() < 1e-13);
/// ```
pub fn closing_crossings<S: Scalar>(gap: &Polynomial<S>, from: S) -> ClosingCrossings<S> {
    let is_in_front = sign(gap.value(from), gap.rounding_bound(from)) == Sign::Positive;
    ClosingCrossings::new(gap, from, if is_in_front { Side::Front } else { Side::Behind })
}

/// The iterator behind [`closing_crossings`].
#[derive(Clone, Debug)]
pub struct ClosingCrossings<S> {
    gap: Polynomial<S>,
    search: Search<S>,
}

#[derive(Clone, Debug)]
enum Search<S> {
    /// Degree two or less: the only crossing there is.
    Closed(Option<S>),
    /// Degree three or four.
    Open { cuts: Cuts<S>, sweep: Sweep<S> },
}

impl<S: Scalar> ClosingCrossings<S> {
    pub(super) fn new(gap: &Polynomial<S>, from: S, side: Side) -> Self {
        let from = from.detached();
        let [a0, a1, a2, a3, a4] = gap.coefficients;
        let search = if gap.never_closes() {
            Search::Closed(None)
        } else if a3 == S::ZERO && a4 == S::ZERO {
            let crossing = Quadratic::new([a0, a1, a2]).closing_crossing();
            Search::Closed(crossing.filter(|s| *s > from).map(|s| with_tail(gap, s)))
        } else {
            Search::Open { cuts: Cuts::new(gap, from), sweep: Sweep::new(from, side) }
        };
        Self { gap: *gap, search }
    }
}

impl<S: Scalar> Iterator for ClosingCrossings<S> {
    type Item = S;

    fn next(&mut self) -> Option<S> {
        let gap = &self.gap;
        match &mut self.search {
            Search::Closed(crossing) => crossing.take(),
            Search::Open { cuts, sweep } => loop {
                let cut = cuts.next(gap)?;
                let value = gap.value(cut);
                if let Some((lo, hi)) = sweep.visit(cut, value, sign(value, gap.rounding_bound(cut))) {
                    return Some(root_between(gap, lo, hi));
                }
            },
        }
    }
}

/// The root of a quadratic whose cubic and quartic coefficients are zero but may have derivatives.
fn with_tail<S: Scalar>(gap: &Polynomial<S>, root: S) -> S {
    let [_, _, _, a3, a4] = gap.coefficients;
    let s = root.detached();
    let slope = gap.slope(s);
    if slope == S::ZERO { root } else { root - (a3 + a4 * s) * s * s * s / slope }
}

fn root_between<S: Scalar>(falling: &Polynomial<S>, lo: S, hi: S) -> S {
    falling_root(lo, hi, |s| falling.value_and_slope(s), |s| falling.rounding_bound(s))
}

/// The points that cut `s > from` into pieces on which a cubic or quartic is monotone, and last a point beyond all
/// roots.
#[derive(Clone, Debug)]
struct Cuts<S> {
    /// The slope, whose roots are sought between the stations; none for a cubic, whose stations are its own.
    slope: Option<Polynomial<S>>,
    /// Roots of the second derivative of a quartic, of the first of a cubic; then the end.
    stations: [Option<S>; 3],
    here: S,
    slope_here: S,
    pending: Option<S>,
}

impl<S: Scalar> Cuts<S> {
    fn new(gap: &Polynomial<S>, from: S) -> Self {
        let derivative = gap.derivative();
        let is_quartic = gap.coefficients[4] != S::ZERO;
        let [c0, c1, c2, ..] = if is_quartic { derivative.derivative() } else { derivative }.coefficients;
        let [first, second] = Quadratic::new([c0, c1, c2]).positive_roots_or_vertex();
        Self {
            slope: is_quartic.then_some(derivative),
            stations: [Some(first), Some(second), Some(S::INFINITY)],
            here: from,
            slope_here: derivative.value(from),
            pending: None,
        }
    }

    fn next(&mut self, gap: &Polynomial<S>) -> Option<S> {
        if let Some(station) = self.pending.take() {
            return Some(station);
        }
        let (start, station) = (self.here, self.next_station(gap)?);
        self.here = station;
        let Some(slope) = self.slope else {
            return Some(station);
        };
        let slope_before = core::mem::replace(&mut self.slope_here, slope.value(station));
        let root = if slope_before > S::ZERO && self.slope_here < S::ZERO {
            root_between(&slope, start, station)
        } else if slope_before < S::ZERO && self.slope_here > S::ZERO {
            root_between(&Polynomial::new(slope.coefficients.map(|a| -a)), start, station)
        } else {
            return Some(station);
        };
        self.pending = Some(station);
        Some(root.detached())
    }

    /// The next station beyond where we are; the bound of all roots stands for infinity.
    fn next_station(&mut self, gap: &Polynomial<S>) -> Option<S> {
        let here = self.here;
        let station = self.stations.iter_mut().find_map(|station| station.take().filter(|s| *s > here))?;
        if station < S::INFINITY {
            return Some(station);
        }
        self.stations = [None; 3];
        Some(gap.root_bound()).filter(|bound| *bound > here)
    }
}
