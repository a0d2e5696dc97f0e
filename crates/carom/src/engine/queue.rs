//! Which ball's event comes first: a tournament over the balls' next event times.
//!
//! Each ball has one pending event. A match of two subtrees is won by the earlier time; a ball's change replays the
//! matches on its way to the root only. A few balls need no tournament: they are looked at one by one.
//!
//! An event of two balls may be pending for either of them, which depends on the past. So events at one time come in the
//! order of their ranks, which depend on the events alone.

use crate::scalar::Scalar;

/// Up to this many balls, the first is found by looking at all.
const FEW: usize = 4;

/// The tournament of the balls' next event times.
#[derive(Clone, Debug)]
pub struct Queue<S> {
    /// Next event time of each ball, padded with infinity to a power of two.
    times: Vec<S>,
    /// Rank of each ball's next event among those at the same time.
    ranks: Vec<u32>,
    /// Winner of each match; the children of match k are 2k and 2k + 1, the last level's are the balls.
    winners: Vec<u32>,
}

impl<S: Scalar> Queue<S> {
    /// A queue of `balls` balls, none of which has an event.
    pub fn new(balls: usize) -> Self {
        let leaves = balls.next_power_of_two();
        let matches = if leaves > FEW { leaves } else { 0 };
        let (times, ranks) = (vec![S::INFINITY; leaves], vec![u32::MAX; leaves]);
        let mut queue = Self { times, ranks, winners: vec![0; matches] };
        for k in (1..matches).rev() {
            queue.winners[k] = queue.winner_of(2 * k, 2 * k + 1);
        }
        queue
    }

    /// Sets the time of a ball's next event, and its rank among events at that time.
    #[inline(always)]
    pub fn set(&mut self, ball: usize, time: S, rank: u32) {
        self.times[ball] = time;
        self.ranks[ball] = rank;
        let mut k = if self.winners.is_empty() { 0 } else { (ball + self.times.len()) / 2 };
        while k >= 1 {
            self.winners[k] = self.winner_of(2 * k, 2 * k + 1);
            k /= 2;
        }
    }

    /// The ball whose event comes first, and its time.
    #[inline(always)]
    pub fn first(&self) -> (usize, S) {
        if !self.winners.is_empty() {
            let ball = self.winners[1] as usize;
            return (ball, self.times[ball]);
        }
        let mut first = 0;
        for ball in 1..self.times.len() {
            if self.is_earlier(ball, first) {
                first = ball;
            }
        }
        (first, self.times[first])
    }

    #[inline(always)]
    fn is_earlier(&self, a: usize, b: usize) -> bool {
        let (time_a, time_b) = (self.times[a], self.times[b]);
        time_a < time_b || (time_a == time_b && self.ranks[a] < self.ranks[b])
    }

    fn winner_of(&self, left: usize, right: usize) -> u32 {
        let (left, right) = (self.player(left), self.player(right));
        if self.is_earlier(right as usize, left as usize) { right } else { left }
    }

    fn player(&self, node: usize) -> u32 {
        let leaves = self.times.len();
        if node >= leaves { (node - leaves) as u32 } else { self.winners[node] }
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

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
                queue.set(ball, time, ball as u32);
                let (first, earliest) = queue.first();
                assert_eq!(earliest, times.iter().copied().fold(f64::INFINITY, f64::min));
                assert_eq!(times[first], earliest);
            }
        }
    }
}
