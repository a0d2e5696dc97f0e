//! Which ball's event comes first: a tournament over the balls' next event times.
//!
//! Each ball has one pending event. A match of two subtrees is won by the earlier time; a ball's change replays the
//! matches on its way to the root only.

use crate::scalar::Scalar;

/// The tournament of the balls' next event times.
#[derive(Clone, Debug)]
pub struct Queue<S> {
    /// Next event time of each ball, padded with infinity to a power of two.
    times: Vec<S>,
    /// Winner of each match; the children of match k are 2k and 2k + 1, the last level's are the balls.
    winners: Vec<u32>,
}

impl<S: Scalar> Queue<S> {
    /// A queue of `balls` balls, none of which has an event.
    pub fn new(balls: usize) -> Self {
        let leaves = balls.next_power_of_two().max(2);
        let mut queue = Self { times: vec![S::INFINITY; leaves], winners: vec![0; leaves] };
        for k in (1..leaves).rev() {
            queue.winners[k] = queue.child(2 * k);
        }
        queue
    }

    /// Sets the time of a ball's next event.
    #[inline(always)]
    pub fn set(&mut self, ball: usize, time: S) {
        self.times[ball] = time;
        let mut k = (ball + self.times.len()) / 2;
        while k >= 1 {
            let (left, right) = (self.child(2 * k), self.child(2 * k + 1));
            let left_wins = !(self.times[right as usize] < self.times[left as usize]);
            self.winners[k] = if left_wins { left } else { right };
            k /= 2;
        }
    }

    /// The ball whose event comes first, and its time.
    #[inline(always)]
    pub fn first(&self) -> (usize, S) {
        let ball = self.winners[1] as usize;
        (ball, self.times[ball])
    }

    #[inline(always)]
    fn child(&self, node: usize) -> u32 {
        let leaves = self.times.len();
        if node >= leaves { (node - leaves) as u32 } else { self.winners[node] }
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

    #[test]
    fn first_is_the_earliest_after_any_changes() {
        let mut queue = Queue::<f64>::new(5);
        let mut times = [f64::INFINITY; 5];
        let mut state = 1_u64;
        for _ in 0..1000 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let (ball, time) = ((state >> 33) as usize % 5, (state >> 40) as f64);
            times[ball] = time;
            queue.set(ball, time);
            let (first, earliest) = queue.first();
            assert_eq!(earliest, times.iter().copied().fold(f64::INFINITY, f64::min));
            assert_eq!(times[first], earliest);
        }
    }
}
