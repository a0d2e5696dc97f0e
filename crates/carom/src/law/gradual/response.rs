//! How closing speed and slips answer to impulses.

use crate::geometry::Vec2;
use crate::scalar::Scalar;
use core::array::from_fn;

/// Impulses at the places of a contact.
#[derive(Clone, Copy, Debug)]
pub(in crate::law) struct Impulse<S, const N: usize> {
    /// The normal impulse where the bodies meet.
    pub normal: S,
    /// Friction at each place, along the slip that it acts against: sideways and forwards.
    pub rubs: [Vec2<S>; N],
}

/// Bodies that touch at `N` places, the first of which is where they meet.
pub(in crate::law) trait Touching<S: Scalar, const N: usize> {
    /// How the bodies move.
    type Motion: Copy;

    /// The bodies at rest.
    const REST: Self::Motion;

    /// The speed at which they close.
    fn closing_speed(&self, motion: &Self::Motion) -> S;

    /// The slip at each place, sideways and forwards.
    fn slips(&self, motion: &Self::Motion) -> [Vec2<S>; N];

    /// The motion after impulses.
    fn pushed(&self, motion: Self::Motion, impulse: &Impulse<S, N>) -> Self::Motion;

    /// The coefficient of friction of each place.
    fn frictions(&self) -> [S; N];

    /// The load on each place, per normal impulse: by itself, and per friction forwards where the bodies meet.
    fn loads(&self) -> [[S; 2]; N];
}

/// The linear answer of bodies that touch to impulses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Response<S, const N: usize> {
    /// Closing speed lost per normal impulse.
    pub stopped: S,
    /// Closing speed gained per friction forwards.
    pub closed: [S; N],
    /// Slip forwards gained per normal impulse.
    pub driven: [S; N],
    /// Slip sideways lost per friction sideways.
    pub sideways: [[S; N]; N],
    /// Slip forwards lost per friction forwards.
    pub forwards: [[S; N]; N],
}

impl<S: Scalar, const N: usize> Impulse<S, N> {
    pub(super) const NONE: Self = Self { normal: S::ZERO, rubs: [Vec2::ZERO; N] };

    /// This, and as much again of another as belongs to a normal impulse.
    #[inline(always)]
    pub(super) fn with(&self, normal: S, rubs: &[Vec2<S>; N]) -> Self {
        Self { normal: self.normal + normal, rubs: from_fn(|k| self.rubs[k] + rubs[k] * normal) }
    }

    /// A friction of one in a direction at one place.
    fn rub(place: usize, direction: Vec2<S>) -> Self {
        Self { normal: S::ZERO, rubs: from_fn(|k| if k == place { direction } else { Vec2::ZERO }) }
    }
}

impl<S: Scalar, const N: usize> Response<S, N> {
    /// The answer of bodies to each impulse by itself.
    pub(super) fn of<T: Touching<S, N>>(bodies: &T) -> Self {
        let answer = |impulse: Impulse<S, N>| {
            let motion = bodies.pushed(T::REST, &impulse);
            (bodies.closing_speed(&motion), bodies.slips(&motion))
        };
        let (closing, slips) = answer(Impulse { normal: S::ONE, ..Impulse::NONE });
        let sideways: [_; N] = from_fn(|l| answer(Impulse::rub(l, Vec2::new(S::ONE, S::ZERO))).1);
        let forwards: [_; N] = from_fn(|l| answer(Impulse::rub(l, Vec2::new(S::ZERO, S::ONE))));
        Self {
            stopped: -closing,
            closed: from_fn(|l| forwards[l].0),
            driven: from_fn(|k| slips[k].y),
            sideways: from_fn(|k| from_fn(|l| -sideways[l][k].x)),
            forwards: from_fn(|k| from_fn(|l| -forwards[l].1[k].y)),
        }
    }

    /// The closing speed lost to impulses.
    #[inline(always)]
    pub(super) fn closing_lost(&self, impulse: &Impulse<S, N>) -> S {
        (0..N).fold(self.stopped * impulse.normal, |lost, l| lost - self.closed[l] * impulse.rubs[l].y)
    }

    /// The slip gained at a place by impulses.
    #[inline(always)]
    pub(super) fn slip_gained(&self, place: usize, impulse: &Impulse<S, N>) -> Vec2<S> {
        let driven = Vec2::new(S::ZERO, self.driven[place] * impulse.normal);
        (0..N).fold(driven, |slip, l| slip - self.slip_lost(place, l, impulse.rubs[l]))
    }

    /// The slip lost at a place by a friction at another, or at the same.
    #[inline(always)]
    pub(super) fn slip_lost(&self, place: usize, other: usize, rub: Vec2<S>) -> Vec2<S> {
        Vec2::new(self.sideways[place][other] * rub.x, self.forwards[place][other] * rub.y)
    }

    /// The friction that by itself takes this slip from a place.
    #[inline(always)]
    pub(super) fn stopping(&self, place: usize, slip: Vec2<S>) -> Vec2<S> {
        Vec2::new(slip.x / self.sideways[place][place], slip.y / self.forwards[place][place])
    }
}
