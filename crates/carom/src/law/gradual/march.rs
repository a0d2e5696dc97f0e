//! The steps through a contact.

use super::response::{Impulse, Response, Touching};
use super::rubbing::{Rubbing, Surfaces};
use crate::geometry::Vec2;
use crate::scalar::Scalar;
use core::array::from_fn;

/// Steps of the compression where no slip is about to stop.
const STEPS: f64 = 8.0;

/// Part of a slip as fast as the closing speed that a step may take or turn; of slower ones, more by the fourth root, so
/// that all such steps have errors of like size.
const TURN: f64 = 0.15;

/// The largest such part.
const LARGEST_TURN: f64 = 0.8;

/// First step of a place that starts to slip, over the longest step.
const FIRST_STEP: f64 = 0.1;

/// Slip that counts as none, over the closing speed.
const STILL: f64 = 1e-7;

/// Slip that counts as none, over the other slips: their round-off.
const ROUND_OFF: f64 = 1e-14;

/// Times that the last step of a phase is made again, with a better length.
const LAST_STEPS: usize = 3;

/// Steps after which a phase ends in any case. Slips that start against a friction that nearly holds take hundreds.
const MOST_STEPS: usize = 2000;

/// A contact on its way.
struct March<S, const N: usize> {
    surfaces: Surfaces<S, N>,
    closing: S,
    slips: [Vec2<S>; N],
    done: Impulse<S, N>,
    longest: S,
}

/// A step.
struct Step<S, const N: usize> {
    normal: S,
    mean: Mean<S, N>,
}

/// What friction does in a step, per normal impulse.
#[derive(Clone, Copy)]
struct Mean<S, const N: usize> {
    /// Its mean.
    rubs: [Vec2<S>; N],
    /// The mean of its first three stages: what counts in the work of the normal impulse, where the early counts more.
    early: [Vec2<S>; N],
}

/// The motion after a contact with this restitution, and its normal impulse.
pub(in crate::law) fn follow<S: Scalar, T: Touching<S, N>, const N: usize>(
    bodies: &T,
    motion: T::Motion,
    restitution: S,
) -> (T::Motion, S) {
    let mut march = March::new(bodies, &motion);
    if march.closing > S::ZERO {
        let work = march.compress();
        march.expand(restitution.squared() * work);
    }
    (bodies.pushed(motion, &march.done), march.done.normal)
}

impl<S: Scalar, const N: usize> March<S, N> {
    fn new<T: Touching<S, N>>(bodies: &T, motion: &T::Motion) -> Self {
        let (closing, slips) = (bodies.closing_speed(motion), bodies.slips(motion));
        let response = Response::of(bodies);
        let speeds = slips.iter().fold(S::ZERO, |sum, slip| sum + slip.norm());
        let still = closing * S::from_f64(STILL) + speeds * S::from_f64(ROUND_OFF);
        let (frictions, loads) = (bodies.frictions(), bodies.loads());
        let longest = closing / (response.stopped * S::from_f64(STEPS));
        let surfaces = Surfaces { response, frictions, loads, still };
        Self { surfaces, closing, slips, done: Impulse::NONE, longest }
    }

    /// Steps until nothing closes any more; the work done (4).
    fn compress(&mut self) -> S {
        let mut work = S::ZERO;
        for _ in 0..MOST_STEPS {
            let first = self.first_rubbing();
            let closing = self.closing_now();
            let end = |mean: &Mean<S, N>| {
                let lost = self.closing_lost(&mean.rubs);
                if lost > S::ZERO { closing / lost } else { S::INFINITY }
            };
            let (step, is_last) = self.step(&first, end);
            work += step.normal
                * (closing - self.closing_lost(&step.mean.early) * step.normal * S::from_f64(0.5));
            self.done = self.done.with(step.normal, &step.mean.rubs);
            if is_last {
                break;
            }
        }
        work
    }

    /// Steps until as much work is given back (4).
    fn expand(&mut self, work: S) {
        let mut left = work;
        for _ in 0..MOST_STEPS {
            if left <= S::ZERO {
                break;
            }
            let first = self.first_rubbing();
            let opening = -self.closing_now();
            let end = |mean: &Mean<S, N>| end_of_work(left, opening, self.closing_lost(&mean.early));
            let (step, is_last) = self.step(&first, end);
            left -= step.normal
                * (opening + self.closing_lost(&step.mean.early) * step.normal * S::from_f64(0.5));
            self.done = self.done.with(step.normal, &step.mean.rubs);
            if is_last {
                break;
            }
        }
    }

    /// The next step, and whether it is the last of its phase. `end` says where the phase ends with such a friction.
    ///
    /// Bodies that friction holds everywhere are wedged: that ends a phase too.
    fn step(&self, first: &Rubbing<S, N>, end: impl Fn(&Mean<S, N>) -> S) -> (Step<S, N>, bool) {
        if first.is_held.iter().all(|is_held| *is_held) {
            return (Step { normal: S::ZERO, mean: Mean { rubs: first.rubs, early: first.rubs } }, true);
        }
        let bound = self.bound(first);
        let mut mean = Mean { rubs: first.rubs, early: first.rubs };
        let mut normal = end(&mean);
        if normal > bound {
            mean = self.mean(first, bound);
            normal = end(&mean);
            let is_last = normal < bound;
            return (Step { normal: if is_last { normal } else { bound }, mean }, is_last);
        }
        for _ in 0..LAST_STEPS {
            mean = self.mean(first, normal);
            let better = end(&mean);
            if better >= S::INFINITY {
                // The friction has turned meanwhile, and with it the phase does not end: the step is one like others.
                return (Step { normal, mean }, false);
            }
            normal = better;
        }
        (Step { normal, mean }, true)
    }

    /// The friction at the start of a step. A place that it holds is stopped for good first.
    fn first_rubbing(&mut self) -> Rubbing<S, N> {
        let first = self.surfaces.rubbing(&self.slips_at(&self.done), [false; N]);
        for k in 0..N {
            if first.is_held[k] {
                let slip = self.slips_at(&self.done)[k];
                self.done.rubs[k] = self.done.rubs[k] + self.surfaces.response.stopping(k, slip);
            }
        }
        first
    }

    /// The longest step that turns no slip by much.
    fn bound(&self, first: &Rubbing<S, N>) -> S {
        let slips = self.slips_at(&self.done);
        (0..N).filter(|&k| first.limits[k] > S::ZERO && !first.is_held[k]).fold(self.longest, |least, k| {
            let bound = self.bound_at(k, slips[k], first);
            if bound < least { bound } else { least }
        })
    }

    /// The longest step in which the slip of a place neither turns nor shrinks by more than a part.
    ///
    /// What friction alone could take counts half of itself, for the sake of stability: it turns a slip that starts into
    /// its own direction within an impulse of the slip's size, and longer steps would overshoot that.
    fn bound_at(&self, place: usize, slip: Vec2<S>, first: &Rubbing<S, N>) -> S {
        let speed = slip.norm();
        if speed <= self.surfaces.still {
            return self.longest * S::from_f64(FIRST_STEP);
        }
        let response = &self.surfaces.response;
        let rate = response.slip_gained(place, &Impulse { normal: S::ONE, rubs: first.rubs });
        let (growing, turning) = (rate.dot(slip) / speed, rate.cross(slip) / speed);
        let shrinking = if growing < S::ZERO { growing } else { S::ZERO };
        let [across, ahead] = [response.sideways[place][place], response.forwards[place][place]];
        let rubbed = first.limits[place] * if across > ahead { across } else { ahead };
        let changed = (shrinking.squared() + turning.squared()).sqrt() + rubbed * S::from_f64(0.5);
        speed * self.turn(speed) / changed
    }

    #[inline(always)]
    fn turn(&self, speed: S) -> S {
        let turn = (self.closing / speed).sqrt().sqrt() * S::from_f64(TURN);
        let largest = S::from_f64(LARGEST_TURN);
        if turn < largest { turn } else { largest }
    }

    /// The friction of a step, by the classical Runge–Kutta method.
    #[inline(always)]
    fn mean(&self, first: &Rubbing<S, N>, normal: S) -> Mean<S, N> {
        let half = normal * S::from_f64(0.5);
        let rubs = |length: S, rubs: &[Vec2<S>; N]| {
            self.surfaces.rubbing(&self.slips_at(&self.done.with(length, rubs)), first.is_held).rubs
        };
        let second = rubs(half, &first.rubs);
        let third = rubs(half, &second);
        let fourth = rubs(normal, &third);
        let [two, third_part, sixth] = [2.0, 1.0 / 3.0, 1.0 / 6.0].map(S::from_f64);
        Mean {
            rubs: from_fn(|k| (first.rubs[k] + (second[k] + third[k]) * two + fourth[k]) * sixth),
            early: from_fn(|k| (first.rubs[k] + second[k] + third[k]) * third_part),
        }
    }

    /// The closing speed lost per normal impulse.
    #[inline(always)]
    fn closing_lost(&self, rubs: &[Vec2<S>; N]) -> S {
        self.surfaces.response.closing_lost(&Impulse { normal: S::ONE, rubs: *rubs })
    }

    #[inline(always)]
    fn slips_at(&self, impulse: &Impulse<S, N>) -> [Vec2<S>; N] {
        from_fn(|k| self.slips[k] + self.surfaces.response.slip_gained(k, impulse))
    }

    #[inline(always)]
    fn closing_now(&self) -> S {
        self.closing - self.surfaces.response.closing_lost(&self.done)
    }
}

/// The normal impulse that does this work, from an opening speed that grows by `gained` per impulse.
#[inline(always)]
fn end_of_work<S: Scalar>(work: S, opening: S, gained: S) -> S {
    let squared = opening.squared() + S::from_f64(2.0) * gained * work;
    let reached = opening + squared.sqrt();
    if squared >= S::ZERO && reached > S::ZERO { work * S::from_f64(2.0) / reached } else { S::INFINITY }
}
