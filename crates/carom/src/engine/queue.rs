//! Which ball's event comes first: a tournament over the balls' next events.
//!
//! Each ball has one pending event. A match of two subtrees is won by the earlier one; a ball's change replays the
//! matches on its way to the root only. A few balls need no tournament: they are looked at one by one.
//!
//! An event of two balls may be pending for either of them, which depends on the past. So events at one time come in the
//! order of their ranks, which depend on the events alone.

use crate::scalar::Scalar;

/// Up to this many balls, the first is found by looking at all.
const FEW: usize = 4;

/// Something that a pending event is with.
pub trait Aim: Copy {
    /// Nothing.
    const NOTHING: Self;

    /// The rank of the event that is pending for `ball` among those at the same time.
    fn rank(&self, ball: usize) -> (u8, usize);
}

/// What a disc's next event is with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// No event.
    Nothing,
    /// Another ball, with the number of changes of course it had when this was predicted.
    Ball(u32, u32),
    /// A cushion.
    Cushion(u32),
    /// The end of the cushion that holds the ball.
    Release(u32),
}

/// A ball's next event.
#[derive(Clone, Copy, Debug)]
pub struct Pending<S, A = Target> {
    /// When; infinite for never.
    pub time: S,
    /// The same, as offset from the later start of the flights involved, unrounded.
    pub offset: S,
    /// With what.
    pub target: A,
}

/// The balls' next events, and the tournament among them.
#[derive(Clone, Debug)]
pub struct Queue<S, A = Target> {
    /// Next event of each ball.
    pending: Vec<Pending<S, A>>,
    /// Winner of each match; the children of match k are 2k and 2k + 1, the last level's are the balls.
    winners: Vec<u32>,
}

impl Aim for Target {
    const NOTHING: Self = Self::Nothing;

    /// The lower number of the event's balls.
    #[inline(always)]
    fn rank(&self, ball: usize) -> (u8, usize) {
        match self {
            Self::Ball(other, _) => (0, ball.min(*other as usize)),
            _ => (0, ball),
        }
    }
}

impl<S: Scalar, A: Aim> Pending<S, A> {
    /// No event.
    pub const NEVER: Self = Self { time: S::INFINITY, offset: S::INFINITY, target: A::NOTHING };

    /// Another event, `offset` after `start`, if that comes before this.
    #[inline(always)]
    pub fn earlier(self, start: S, offset: Option<S>, target: A) -> Self {
        match offset {
            Some(offset) if start + offset < self.time => Self { time: start + offset, offset, target },
            _ => self,
        }
    }
}

impl<S: Scalar> Pending<S> {
    /// The meeting with another ball `offset` after `start`, if that comes before this; of two balls at one time that with
    /// the lower number, in whatever order they are asked.
    #[inline(always)]
    pub fn earlier_meeting(self, start: S, offset: S, other: usize, changes: u32) -> Self {
        let (time, target) = (start + offset, Target::Ball(other as u32, changes));
        let is_first =
            matches!(self.target, Target::Ball(known, _) if time == self.time && other < known as usize);
        if time < self.time || is_first { Self { time, offset, target } } else { self }
    }
}

impl<S: Scalar, A: Aim> Queue<S, A> {
    /// A queue of `balls` balls, none of which has an event.
    pub fn new(balls: usize) -> Self {
        let leaves = if balls > FEW { balls.next_power_of_two() } else { balls };
        let mut winners = vec![0; if balls > FEW { leaves } else { 0 }];
        for k in (1..winners.len()).rev() {
            winners[k] = if 2 * k >= leaves { (2 * k - leaves) as u32 } else { winners[2 * k] };
        }
        Self { pending: vec![Pending::NEVER; leaves], winners }
    }

    /// Sets a ball's next event.
    #[inline(always)]
    pub fn set(&mut self, ball: usize, next: Pending<S, A>) {
        self.pending[ball] = next;
        if !self.winners.is_empty() {
            self.replay(ball);
        }
    }

    /// A ball's next event.
    pub fn pending(&self, ball: usize) -> &Pending<S, A> {
        &self.pending[ball]
    }

    /// The ball whose event comes first, and the event.
    #[inline(always)]
    pub fn first(&self) -> (usize, Pending<S, A>) {
        if !self.winners.is_empty() {
            let ball = self.winners[1] as usize;
            return (ball, self.pending[ball]);
        }
        let mut first = (0, &Pending::NEVER);
        for (ball, pending) in self.pending.iter().enumerate() {
            if is_earlier((ball, pending), first) {
                first = (ball, pending);
            }
        }
        (first.0, *first.1)
    }

    fn replay(&mut self, ball: usize) {
        let mut k = (ball + self.pending.len()) / 2;
        while k >= 1 {
            let (left, right) = (self.player(2 * k), self.player(2 * k + 1));
            let [first, second] = [left, right].map(|ball| (ball, &self.pending[ball]));
            self.winners[k] = if is_earlier(second, first) { right } else { left } as u32;
            k /= 2;
        }
    }

    fn player(&self, node: usize) -> usize {
        let leaves = self.pending.len();
        if node >= leaves { node - leaves } else { self.winners[node] as usize }
    }
}

/// Whether the event pending for the first ball comes before that for the second.
#[inline(always)]
fn is_earlier<S: Scalar, A: Aim>(
    (a, first): (usize, &Pending<S, A>),
    (b, second): (usize, &Pending<S, A>),
) -> bool {
    first.time < second.time || (first.time == second.time && first.target.rank(a) < second.target.rank(b))
}

#[cfg(test)]
mod tests {
    use super::{Pending, Queue};

    #[test]
    fn first_is_the_earliest_after_any_changes() {
        let mut state = 1_u64;
        for balls in [1, 2, 3, 5, 8, 13] {
            let mut queue = Queue::<f64>::new(balls);
            let mut times = vec![f64::INFINITY; balls];
            for _ in 0..1000 {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                let (ball, time) = ((state >> 33) as usize % balls, (state >> 40) as f64);
                times[ball] = time;
                queue.set(ball, Pending { time, ..Pending::NEVER });
                let (first, Pending { time: earliest, .. }) = queue.first();
                assert_eq!(earliest, times.iter().copied().fold(f64::INFINITY, f64::min));
                assert_eq!(times[first], earliest);
            }
        }
    }
}
