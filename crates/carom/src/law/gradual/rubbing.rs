//! Friction at each place: along the slip, or what holds a place that does not slip.

use super::response::{Impulse, Response};
use crate::geometry::Vec2;
use crate::scalar::Scalar;
use core::array::from_fn;

/// Newton steps to the friction of a place that starts to slip.
const NEWTON_STEPS: usize = 5;

/// Times that frictions which hold each other up are settled again.
const MOST_ROUNDS: usize = 20;

/// Change of friction, over the normal impulse, up to which it counts as settled.
const UNSETTLED: f64 = 1e-3;

/// Friction per normal impulse.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rubbing<S, const N: usize> {
    /// At each place.
    pub rubs: [Vec2<S>; N],
    /// The largest that there can be.
    pub limits: [S; N],
    /// Which places friction holds.
    pub is_held: [bool; N],
}

/// What friction depends on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surfaces<S, const N: usize> {
    pub response: Response<S, N>,
    pub frictions: [S; N],
    pub loads: [[S; 2]; N],
    /// Slip below which a place counts as not slipping.
    pub still: S,
}

impl<S: Scalar, const N: usize> Surfaces<S, N> {
    /// The friction at these slips. Places of `held` count as not slipping.
    #[inline(always)]
    pub(super) fn rubbing(&self, slips: &[Vec2<S>; N], held: [bool; N]) -> Rubbing<S, N> {
        let speeds = slips.map(Vec2::norm);
        let holds = from_fn(|k| held[k] || speeds[k] <= self.still);
        let along = from_fn(|k| if holds[k] { Vec2::ZERO } else { slips[k] * (S::ONE / speeds[k]) });
        let found = Rubbing { rubs: [Vec2::ZERO; N], limits: [S::ZERO; N], is_held: [false; N] };
        if holds[0] { self.settled(found, &along, holds) } else { self.round(found, &along, holds) }
    }

    /// Where the bodies meet, what holds depends on the friction on the cloth, whose load depends on what holds.
    ///
    /// The dependence is linear, but for a place that starts to slip, so two rounds and Steffensen's step settle it; where
    /// one does, or the load goes, they are made again.
    fn settled(&self, found: Rubbing<S, N>, along: &[Vec2<S>; N], holds: [bool; N]) -> Rubbing<S, N> {
        let mut settled = self.nearly_settled(found, along, holds);
        for _ in 0..MOST_ROUNDS {
            let next = self.round(settled, along, holds);
            let change = (0..N).fold(S::ZERO, |sum, k| sum + (next.rubs[k] - settled.rubs[k]).norm_squared());
            if change <= S::from_f64(UNSETTLED * UNSETTLED) {
                break;
            }
            settled = self.nearly_settled(next, along, holds);
        }
        settled
    }

    fn nearly_settled(&self, found: Rubbing<S, N>, along: &[Vec2<S>; N], holds: [bool; N]) -> Rubbing<S, N> {
        let first = self.round(found, along, holds);
        let mut second = self.round(first, along, holds);
        let change = first.rubs[0].y - found.rubs[0].y;
        let bend = second.rubs[0].y - first.rubs[0].y - change;
        if bend != S::ZERO {
            second.rubs[0].y = found.rubs[0].y - change.squared() / bend;
        }
        self.round(second, along, holds)
    }

    /// The friction on the cloth with the loads of `last`, then where the bodies meet: what holds there holds exactly.
    #[inline(always)]
    fn round(&self, last: Rubbing<S, N>, along: &[Vec2<S>; N], holds: [bool; N]) -> Rubbing<S, N> {
        let mut found = last;
        let first_rub = if holds[0] { last.rubs[0] } else { along[0] * self.frictions[0] };
        found.rubs[0] = first_rub;
        for k in (0..N).rev() {
            found.limits[k] = self.limit(k, first_rub);
            if holds[k] {
                (found.rubs[k], found.is_held[k]) = self.holding(k, &found);
            } else {
                found.rubs[k] = along[k] * found.limits[k]; // (1)
            }
        }
        found
    }

    #[inline(always)]
    fn limit(&self, place: usize, first_rub: Vec2<S>) -> S {
        let [alone, by_rub] = self.loads[place];
        let load = alone + by_rub * first_rub.y;
        if load > S::ZERO { self.frictions[place] * load } else { S::ZERO }
    }

    /// The friction that holds a place against the rest (2), and whether it does.
    fn holding(&self, place: usize, found: &Rubbing<S, N>) -> (Vec2<S>, bool) {
        let limit = found.limits[place];
        if limit == S::ZERO {
            return (Vec2::ZERO, false);
        }
        let mut others = Impulse { normal: S::ONE, rubs: found.rubs };
        others.rubs[place] = Vec2::ZERO;
        let drive = self.response.slip_gained(place, &others);
        let needed = self.response.stopping(place, drive);
        if needed.norm_squared() <= limit.squared() {
            return (needed, true);
        }
        (self.starting(place, drive, limit), false)
    }

    /// The friction of a place that starts to slip: as large as it can be, and along the slip that starts.
    ///
    /// With J = L q, where L is the limit and |q| = 1, that slip is `drive − G J = λ q`, so `q = drive/(L G + λ)` in both
    /// directions. Newton's method on `1/|q|`, which is nearly linear in λ, finds λ > 0 from below.
    fn starting(&self, place: usize, drive: Vec2<S>, limit: S) -> Vec2<S> {
        let response = &self.response;
        let [across, ahead] =
            [response.sideways[place][place] * limit, response.forwards[place][place] * limit];
        let below = drive.norm() - if across > ahead { across } else { ahead };
        let mut lambda = if below > S::ZERO { below } else { S::ZERO };
        let direction = |lambda: S| Vec2::new(drive.x / (across + lambda), drive.y / (ahead + lambda));
        for _ in 0..NEWTON_STEPS {
            let q = direction(lambda);
            let squared = q.norm_squared();
            let falling = q.x.squared() / (across + lambda) + q.y.squared() / (ahead + lambda);
            lambda += squared / falling * (squared.sqrt() - S::ONE);
        }
        let q = direction(lambda);
        q * (limit / q.norm())
    }
}
