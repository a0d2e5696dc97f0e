//! Which of many balls' events comes first: a calendar of bins, each a short piece of time.
//!
//! What a ball is about to do is written down for it, and a line with its time goes to the end of its bin. Only the bin of
//! the present is in order. A line is never taken back: when a ball has something else to do, its old line has an old
//! stamp, and is passed over when its time comes. Bins are so few that their ends stay in fast memory, and so long that
//! many lines are sorted at once.

use super::bins::Bins;
use super::grid::Side;
use super::queue::{Aim, Pending};
use crate::memory::{fetch, room_for};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// Lines in a bin are one to so many balls, where the calendar is laid out: many for many, whose bins would have too many ends.
const BALLS_PER_LINE: f64 = 400.0;

/// Lines in a bin, fewest and most.
const LINES: [f64; 2] = [12.0, 1024.0];

/// The calendar reaches over so many times the time in which a quarter of the balls has an event.
const REACH: f64 = 16.0;

/// No time is in a later bin.
const MOST_BINS: f64 = (1_u64 << 50) as f64;

/// Lines that are put in order by counting.
const FEW_LINES: usize = 32;

/// A round of the calendar whose bins held so many times too few or too many lines lays it out anew.
const TOLERANCE: f64 = 1.5;

/// What a ball meets next, whether that comes before it leaves its cell or after. In `f64` two fill a line of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Awaited<S>(Pending<S>);

/// Tells the line of what is awaited from those of before, and the side through which the ball leaves its cell if that comes
/// first: this one in the last three bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mark(u32);

/// A line of the calendar.
#[derive(Clone, Copy, Debug)]
struct Line<S> {
    time: S,
    ball: u32,
    mark: Mark,
}

/// What all balls are about to do, and the order of it.
#[derive(Clone, Debug)]
pub struct Calendar<S> {
    awaited: Vec<Awaited<S>>,
    /// The mark of each ball's line that holds, by themselves: there are many more looks at them than at what is awaited.
    marks: Vec<Mark>,
    /// Bins of the time to come, going round; the number of them is a power of two.
    bins: Bins<Line<S>>,
    /// When bin 0 began.
    origin: f64,
    /// One over the length of a bin.
    rate: f64,
    /// The bin of the present.
    bin: u64,
    /// Its lines, in order from `next` on.
    present: Vec<Line<S>>,
    next: usize,
    /// Room to sort in.
    spare: Vec<Line<S>>,
    /// Lines beyond the last bin.
    later: Vec<Line<S>>,
    /// Lines that came to be present since the last look at the length of bins.
    lines: u64,
    /// The lines that a bin should have.
    lines_per_bin: f64,
}

impl Mark {
    /// The next one.
    #[inline(always)]
    fn next(self, leaves: Option<Side>) -> Self {
        let side = leaves.map_or(0, |side| side as u32 + 1);
        Self((self.0 | 7).wrapping_add(1) | side)
    }

    #[inline(always)]
    fn side(self) -> Option<Side> {
        match self.0 & 7 {
            0 => None,
            1 => Some(Side::Left),
            2 => Some(Side::Right),
            3 => Some(Side::Below),
            _ => Some(Side::Above),
        }
    }
}

impl<S: Scalar> Calendar<S> {
    /// A calendar of `balls` balls, none of which has anything to do.
    pub fn new(balls: usize) -> Self {
        let (mut awaited, mut marks) = (room_for(balls), room_for(balls));
        awaited.resize(balls, Awaited(Pending::NEVER));
        marks.resize(balls, Mark(0));
        Self {
            awaited,
            marks,
            bins: Bins::new(2 * balls),
            origin: 0.0,
            rate: 0.0,
            bin: 0,
            present: Vec::new(),
            next: 0,
            spare: Vec::new(),
            later: Vec::new(),
            lines: 0,
            lines_per_bin: (balls as f64 / BALLS_PER_LINE).clamp(LINES[0], LINES[1]),
        }
    }

    /// Strikes everything out: no ball has anything to do.
    pub fn clear(&mut self) {
        self.awaited.fill(Awaited(Pending::NEVER));
        self.marks.fill(Mark(0));
        self.bins.lay_out(0);
        self.present.clear();
        self.later.clear();
        (self.origin, self.rate, self.bin, self.next, self.lines) = (0.0, 0.0, 0, 0, 0);
    }

    /// What a ball meets next, whether that comes before it leaves its cell or after.
    #[inline(always)]
    pub fn awaited(&self, ball: usize) -> &Pending<S> {
        &self.awaited[ball].0
    }

    /// The side through which a ball leaves its cell if that comes before what it meets; at one time it does.
    #[inline(always)]
    pub fn leaves(&self, ball: usize) -> Option<Side> {
        self.marks[ball].side()
    }

    /// Fetches what a ball is about to do.
    #[inline(always)]
    pub fn fetch(&self, ball: usize) {
        fetch(&self.awaited, ball);
        fetch(&self.marks, ball);
    }

    /// Writes down what a ball is about to meet, and when and where it leaves its cell.
    #[inline(always)]
    pub fn set(&mut self, ball: usize, next: Pending<S>, way_out: f64, side: Side) {
        let leaves = way_out <= next.time.to_f64();
        let mark = self.marks[ball].next(leaves.then_some(side));
        (self.awaited[ball], self.marks[ball]) = (Awaited(next), mark);
        let time = if leaves { S::from_f64(way_out) } else { next.time };
        self.write(Line { time, ball: ball as u32, mark });
    }

    #[inline(always)]
    fn write(&mut self, line: Line<S>) {
        // What comes before the bin of the present belongs to it, infinite times beyond all bins.
        let ahead = self.bin_of(line.time.to_f64()).wrapping_sub(self.bin) as i64;
        if ahead > 0 && (ahead as usize) < self.bins.len() {
            let last = self.bins.len() - 1;
            self.bins.push(self.bin.wrapping_add(ahead as u64) as usize & last, line);
        } else if ahead <= 0 && self.bins.len() > 0 {
            self.insert(line);
        } else if line.time < S::INFINITY {
            self.later.push(line);
        }
    }

    /// The bin of a time, by the last bits of a number that is too large for others.
    #[inline(always)]
    fn bin_of(&self, time: f64) -> u64 {
        const WHOLE: f64 = (1_u64 << 52) as f64;
        let bins = (time - self.origin) * self.rate;
        let bins = if bins < MOST_BINS { bins } else { MOST_BINS };
        (bins + WHOLE).to_bits().wrapping_sub(WHOLE.to_bits())
    }

    /// Puts a line into the bin of the present.
    #[inline(always)]
    fn insert(&mut self, line: Line<S>) {
        let mut place = self.present.len();
        self.present.push(line);
        while place > self.next && self.present[place - 1].time > line.time {
            self.present[place] = self.present[place - 1];
            place -= 1;
        }
        self.present[place] = line;
    }

    /// The ball that has something to do first, and when: that it leaves its cell counts.
    #[inline(always)]
    pub fn first(&mut self) -> Option<(usize, S)> {
        loop {
            if self.next >= self.present.len() {
                if !self.turn() {
                    return None;
                }
                continue;
            }
            let line = self.present[self.next];
            if self.marks[line.ball as usize] != line.mark {
                self.next += 1;
                continue;
            }
            let is_alone = self.present.get(self.next + 1).is_none_or(|other| other.time > line.time);
            let ball = if is_alone { line.ball as usize } else { self.first_of_several(line) };
            return Some((ball, line.time));
        }
    }

    /// The first of those at one time.
    #[cold]
    fn first_of_several(&self, line: Line<S>) -> usize {
        let all = self.present[self.next..].iter().take_while(|other| other.time == line.time);
        let all = all.filter(|other| self.marks[other.ball as usize] == other.mark);
        // Whoever leaves a cell comes before all that meet anything.
        let rank = |ball: usize| match self.leaves(ball) {
            Some(_) => (false, (0, ball)),
            None => (true, self.awaited(ball).target.rank(ball)),
        };
        all.map(|other| other.ball as usize)
            .reduce(|first, ball| if rank(ball) < rank(first) { ball } else { first })
            .unwrap_or(line.ball as usize)
    }

    /// The ball of the line that is `ahead` lines from here, which may hold no more.
    #[inline(always)]
    pub fn coming(&self, ahead: usize) -> Option<usize> {
        self.present.get(self.next + ahead).map(|line| line.ball as usize)
    }

    /// Turns to the next bin; `false` when there is nothing any more.
    #[inline(never)]
    fn turn(&mut self) -> bool {
        self.present.clear();
        self.next = 0;
        let last = self.bins.len().wrapping_sub(1) as u64;
        if self.bins.len() == 0 || (self.bin & last == last && !self.is_well_laid_out()) {
            return self.lay_out();
        }
        self.bin += 1;
        self.bins.take((self.bin & last) as usize, &mut self.present);
        self.drop_stale();
        self.lines += self.present.len() as u64;
        self.sort();
        if self.bin & last == 0 {
            let later = core::mem::take(&mut self.later);
            later.into_iter().for_each(|line| self.write(line));
        }
        true
    }

    /// Drops the lines of the present that hold no more, without a branch for each.
    fn drop_stale(&mut self) {
        let mut kept = 0;
        for place in 0..self.present.len() {
            let line = self.present[place];
            self.present[kept] = line;
            kept += usize::from(self.marks[line.ball as usize] == line.mark);
        }
        self.present.truncate(kept);
    }

    /// Puts the lines of the present in order.
    fn sort(&mut self) {
        if self.present.len() <= FEW_LINES {
            return self.sort_by_counting();
        }
        let in_order = |a: &Line<S>, b: &Line<S>| a.time.partial_cmp(&b.time);
        self.present.sort_unstable_by(|a, b| in_order(a, b).unwrap_or(Ordering::Equal));
    }

    /// The same for a few: each goes where the number of those no later says, less those at its time that are there. That takes
    /// no branch.
    fn sort_by_counting(&mut self) {
        let mut times = [S::INFINITY; FEW_LINES];
        for (time, line) in times.iter_mut().zip(&self.present) {
            *time = line.time;
        }
        self.spare.clear();
        self.spare.extend_from_slice(&self.present);
        let eights = &times.as_chunks::<8>().0[..self.present.len().div_ceil(8)];
        let mut taken = [0_u8; FEW_LINES + 1];
        for line in &self.spare {
            let mut no_later = 0;
            for eight in eights {
                no_later += eight.iter().map(|&time| u64::from(time <= line.time)).sum::<u64>();
            }
            let taken = &mut taken[no_later as usize];
            *taken += 1;
            self.present[no_later as usize - usize::from(*taken)] = *line;
        }
    }

    /// Whether the bins of the last round held about as many lines as they should.
    fn is_well_laid_out(&mut self) -> bool {
        let lines = core::mem::take(&mut self.lines) as f64 / self.bins.len() as f64;
        lines * TOLERANCE > self.lines_per_bin && lines < self.lines_per_bin * TOLERANCE
    }

    /// Lays the calendar out anew, from all lines that hold; `false` when there is none.
    fn lay_out(&mut self) -> bool {
        let mut lines: Vec<Line<S>> = core::mem::take(&mut self.later);
        (0..self.bins.len()).for_each(|bin| self.bins.take(bin, &mut lines));
        lines.retain(|line| self.marks[line.ball as usize] == line.mark);
        let quarter = lines.len() / 4;
        if lines.is_empty() {
            return false;
        }
        let in_order = |a: &f64, b: &f64| a.total_cmp(b);
        let mut times: Vec<f64> = lines.iter().map(|line| line.time.to_f64()).collect();
        let latest_of_quarter = *times.select_nth_unstable_by(quarter, in_order).1;
        let first = times.iter().copied().fold(f64::INFINITY, f64::min);
        let span = latest_of_quarter - first;
        let bins_of_quarter = (quarter as f64 / self.lines_per_bin).max(1.0);
        // Where all come at once, any length will do that does not hide the differences of times.
        let length = if span > 0.0 { span / bins_of_quarter } else { first.abs().max(f64::MIN_POSITIVE) };
        let count = ((bins_of_quarter * REACH) as usize).next_power_of_two();
        self.bins.lay_out(count);
        (self.origin, self.rate, self.bin, self.lines) = (first, 1.0 / length, 0, 0);
        lines.into_iter().for_each(|line| self.write(line));
        self.lines += self.present.len() as u64;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::{Calendar, Side};
    use crate::engine::queue::Pending;

    /// A thousand balls, each of which has its next event some random time later; now and then all grow slower, or one is
    /// at rest, or several have one time.
    #[test]
    fn events_come_in_order_whatever_their_times() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut calendar = Calendar::<f64>::new(1000);
        let mut times: Vec<f64> = (0..1000).map(|_| random()).collect();
        let set = |calendar: &mut Calendar<f64>, ball: usize, time: f64| {
            calendar.set(ball, Pending { time, ..Pending::NEVER }, f64::INFINITY, Side::Left);
        };
        for (ball, time) in times.iter().enumerate() {
            set(&mut calendar, ball, *time);
        }
        for step in 0..100_000 {
            let (first, _) = calendar.first().unwrap_or_default();
            let now = times[first];
            if step % 100 == 0 {
                assert_eq!(now, times.iter().copied().fold(f64::INFINITY, f64::min));
            }
            let pace = if step > 50_000 { 1e4 } else { 1.0 };
            let round = |time: f64| if step % 3 == 0 { time } else { (time * 64.0).ceil() / 64.0 };
            for ball in [first, step % 1000] {
                times[ball] = if step % 97 == 0 && ball != first {
                    f64::INFINITY
                } else {
                    round(now + random() * pace)
                };
                set(&mut calendar, ball, times[ball]);
            }
        }
    }
}
