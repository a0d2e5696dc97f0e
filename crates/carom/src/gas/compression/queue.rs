//! Which disc's event comes first: a tournament over the times of the discs' next events.

/// A player, and when its event comes.
type Player = (f64, u32);

/// The times of the discs' next events, and the matches among them.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    /// Match k is between nodes 2k and 2k + 1; the last level's nodes are the discs.
    nodes: Vec<Player>,
    leaves: usize,
}

impl Queue {
    /// A queue in which no disc has an event.
    pub fn new(discs: usize) -> Self {
        let leaves = discs.next_power_of_two();
        Self { nodes: vec![(f64::INFINITY, 0); 2 * leaves], leaves }
    }

    /// Sets the time of a disc's next event.
    #[inline(always)]
    pub fn set(&mut self, disc: usize, time: f64) {
        let mut node = self.leaves + disc;
        self.nodes[node] = (time, disc as u32);
        while node > 1 {
            node /= 2;
            let (left, right) = (self.nodes[2 * node], self.nodes[2 * node + 1]);
            let winner = if right.0 < left.0 { right } else { left };
            if self.nodes[node] == winner {
                return;
            }
            self.nodes[node] = winner;
        }
    }

    /// The first of all events: its time, and whose it is.
    pub fn first(&self) -> (f64, usize) {
        let (time, disc) = self.nodes[1];
        (time, disc as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;
    use crate::random::Random;

    #[test]
    fn first_is_the_earliest_after_any_changes() {
        let mut random = Random::new(1, "test");
        for discs in [1, 2, 3, 5, 8, 13] {
            let mut queue = Queue::new(discs);
            let mut times = vec![f64::INFINITY; discs];
            for _ in 0..1000 {
                let (disc, time) = (random.below(discs), random.unit());
                times[disc] = time;
                queue.set(disc, time);
                let (earliest, first) = queue.first();
                assert_eq!(earliest, times.iter().copied().fold(f64::INFINITY, f64::min));
                assert_eq!(times[first], earliest);
            }
        }
    }
}
