//! The first meeting of one ball with several: eight or four at a time where the processor can.
//!
//! It needs `unsafe` to load lines of [`Ball`] into wide registers, and to write down candidates before it is known how many
//! they are; but for the advice about memory in `memory.rs` nothing else does. [`first_meeting`] has a plain twin in any
//! scalar, which gives the same bits, is the only way elsewhere than on x86-64 with AVX2, and has the last word on contacts.

#![allow(unsafe_code)]
// Elsewhere there is the twin alone.
#![cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]

use super::ball::Ball;
use super::four::Four;
use crate::detect::{Relative, squared_tolerance};
use crate::geometry::Vec2;
use crate::model::ContactTolerance;
use crate::scalar::Scalar;
#[cfg(target_arch = "x86_64")]
use core::any::TypeId;
use core::mem::MaybeUninit;

/// Balls that are asked at once.
const MOST: usize = 52;

/// Lanes of the widest registers.
const MOST_LANES: usize = 8;

/// Room for them, and for what is written over before it is known how many there are.
const ROOM: usize = MOST + 28;

/// Balls that may be met, by their numbers. What is not written at first comes last: before the count, the compiler would
/// clear it along with that.
#[repr(C, align(64))]
pub struct Candidates {
    count: usize,
    /// The ball that asks.
    asker: u32,
    is_round: bool,
    /// Only the first `count` are known, and after [`Candidates::close`] some more.
    numbers: MaybeUninit<[u32; ROOM]>,
    /// Where `is_round`: how often one has gone round the table to see each; otherwise nobody has.
    rounds: MaybeUninit<[[i16; 2]; ROOM]>,
}

/// The first meeting found so far.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<S> {
    /// When.
    pub time: S,
    /// The same as offset from the later start of the two flights.
    pub offset: S,
    /// With which ball; below zero: none of those that were asked.
    pub other: i64,
}

/// With what a ball may be in touch without more having to be asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// With the ball that it has just been in contact with.
    Struck(u32),
    /// With any from which it parts, as nothing has just happened.
    Parting,
}

impl Candidates {
    /// Nobody yet whom a ball may meet.
    #[inline(always)]
    pub fn none(asker: u32) -> Self {
        let (numbers, rounds) = (MaybeUninit::uninit(), MaybeUninit::uninit());
        Self { count: 0, asker, is_round: false, numbers, rounds }
    }

    /// Nobody again; whether one goes round to see any.
    #[inline(always)]
    pub fn clear(&mut self, is_round: bool) {
        (self.count, self.is_round) = (0, is_round);
    }

    /// Whether so many more have room.
    #[inline(always)]
    pub fn has_room_for(&self, count: usize) -> bool {
        self.count + count <= MOST
    }

    /// Takes the balls of some cells that lie together, where one does not go round to see any: so many columns of so many
    /// rows from `first` on. Of all cells, which are `columns` to a row, each has `width` fours. `false`, and they are not all
    /// taken, where a cell has more than four, there is no room, or one goes round.
    #[inline(always)]
    pub fn add_cells<const COLUMNS: usize, const ROWS: usize>(
        &mut self,
        (fours, width): (&[Four], usize),
        first: usize,
        columns: usize,
    ) -> bool {
        let last = first + (ROWS - 1) * columns + COLUMNS;
        if self.is_round || width == 0 || last * width > fours.len() || !self.has_room_for(4 * COLUMNS * ROWS)
        {
            return false;
        }
        // SAFETY: no cell is after the last, each has `width` fours, which is one at least, and there is room.
        unsafe {
            if width == 1 {
                self.add_cells_of::<COLUMNS, ROWS, true>((fours, 1), first, columns)
            } else {
                self.add_cells_of::<COLUMNS, ROWS, false>((fours, width), first, columns)
            }
        }
    }

    /// The same, where it is known whether a cell has just one four.
    ///
    /// # Safety
    ///
    /// All cells are there, have at least one, or two if not `ONE`, and there is room for four balls of each.
    #[inline(always)]
    unsafe fn add_cells_of<const COLUMNS: usize, const ROWS: usize, const ONE: bool>(
        &mut self,
        (fours, width): (&[Four], usize),
        first: usize,
        columns: usize,
    ) -> bool {
        let (mut count, mut is_all) = (self.count, true);
        for row in 0..ROWS {
            for column in 0..COLUMNS {
                let at = (first + row * columns + column) * width;
                // All four are copied, so that nothing depends on how many; what is too much is written over.
                // SAFETY: as of this function.
                unsafe {
                    let four = fours.get_unchecked(at);
                    self.numbers_from(count).cast::<Four>().write_unaligned(*four);
                    is_all &= ONE || fours.get_unchecked(at + 1).count() == 0;
                    count += four.count();
                }
            }
        }
        self.count = count;
        is_all
    }

    /// Takes the balls of a cell: its fours, and how often one goes round to see them. `false`, and they are not all taken,
    /// where there are more than four, or there is no room.
    #[inline(always)]
    pub fn add_cell(&mut self, fours: &[Four], round: [i16; 2]) -> bool {
        let Some(four) = fours.first().filter(|_| self.has_room_for(4)) else { return false };
        // SAFETY: there is room for four.
        unsafe {
            self.numbers_from(self.count).cast::<Four>().write_unaligned(*four);
            self.rounds_from(self.count).cast::<[[i16; 2]; 4]>().write_unaligned([round; 4]);
        }
        self.count += four.count();
        fours.get(1).is_none_or(|second| second.count() == 0)
    }

    /// From where on the numbers of balls go.
    ///
    /// # Safety
    ///
    /// No more have been taken than there is room for.
    #[inline(always)]
    unsafe fn numbers_from(&mut self, place: usize) -> *mut u32 {
        // SAFETY: as of this function.
        unsafe { self.numbers.as_mut_ptr().cast::<u32>().add(place) }
    }

    /// The same for how often one has gone round.
    ///
    /// # Safety
    ///
    /// No more have been taken than there is room for.
    #[inline(always)]
    unsafe fn rounds_from(&mut self, place: usize) -> *mut [i16; 2] {
        // SAFETY: as of this function.
        unsafe { self.rounds.as_mut_ptr().cast::<[i16; 2]>().add(place) }
    }

    /// The balls.
    fn numbers(&self) -> &[u32] {
        // SAFETY: the first `count` have been written.
        unsafe { core::slice::from_raw_parts(self.numbers.as_ptr().cast(), self.count) }
    }

    /// How often one has gone round to see one of the balls.
    fn round(&self, place: usize) -> [i16; 2] {
        if !self.is_round || place >= self.count {
            return [0; 2];
        }
        // SAFETY: where it is said that they are round, the first `count` have been written.
        unsafe { *self.rounds.as_ptr().cast::<[i16; 2]>().add(place) }
    }

    /// Fills what a group of lanes would see after the last with the ball that asks, which never meets itself.
    #[inline(always)]
    fn close(&mut self) {
        // SAFETY: there is room for so many more than the most that are counted.
        unsafe {
            let numbers = self.numbers_from(self.count);
            numbers.cast::<[u32; MOST_LANES]>().write_unaligned([self.asker; MOST_LANES]);
            if self.is_round {
                let rounds = self.rounds_from(self.count);
                rounds.cast::<[[i16; 2]; MOST_LANES]>().write_unaligned([[0; 2]; MOST_LANES]);
            }
        }
    }
}

/// What is near enough, of all balls of a table.
#[derive(Clone, Debug)]
pub struct Nearness<S> {
    /// How large a periodic table is; on any other nobody goes round.
    pub period: Option<Vec2<S>>,
    /// Of contacts.
    pub tolerance: ContactTolerance<S>,
    /// A squared gap that is larger is no contact of any two.
    pub most: S,
    /// A squared gap that is no larger is one of any two.
    pub least: S,
}

/// A ball that asks for its first meeting.
pub struct Question<'a, S> {
    /// All balls.
    pub balls: &'a [Ball<S>],
    /// The one that asks, in straight flight as they all are.
    pub own: &'a Ball<S>,
    /// With what it may be in touch.
    pub touch: Touch,
    /// What holds of all.
    pub near: &'a Nearness<S>,
    /// Whom it asks.
    pub candidates: Candidates,
    /// What it meets first, as far as is known; then the first of that and the candidates, of two at one time that with the
    /// lower number. Not counted are the ball itself and the one that it has just been in contact with.
    pub nearest: Nearest<S>,
}

/// Answers a question; `false` where a candidate is so near that more has to be asked.
#[inline(always)]
pub fn first_meeting<S: Scalar>(question: &mut Question<S>) -> bool {
    #[cfg(target_arch = "x86_64")]
    if let Some(question) = in_f64(question)
        && x86::first_meeting(question)
    {
        return true;
    }
    first_meeting_plain(question)
}

/// Answers two questions; `false` where one of them needs more.
#[inline(always)]
pub fn first_meetings<S: Scalar>(a: &mut Question<S>, b: &mut Question<S>) -> bool {
    #[cfg(target_arch = "x86_64")]
    if let (Some(a), Some(b)) = (in_f64(a), in_f64(b))
        && x86::first_meetings(a, b)
    {
        return true;
    }
    first_meeting_plain(a) && first_meeting_plain(b)
}

/// A question, if it is one in `f64`.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn in_f64<'q, 'a, S: Scalar>(question: &'q mut Question<'a, S>) -> Option<&'q mut Question<'a, f64>> {
    let is_f64 = TypeId::of::<S>() == TypeId::of::<f64>();
    // SAFETY: it is of this very type.
    is_f64.then(|| unsafe { &mut *core::ptr::from_mut(question).cast() })
}

/// The plain twin, which also tells those in touch from those that are just near.
#[inline(never)]
fn first_meeting_plain<S: Scalar>(question: &mut Question<S>) -> bool {
    let Question { balls, own, touch, near, candidates, nearest } = question;
    let Nearness { period, tolerance, .. } = near;
    let mut is_clear = true;
    for (place, &number) in candidates.numbers().iter().enumerate() {
        let other = &balls[number as usize];
        let radii = own.radius + other.radius;
        if number == own.number || *touch == Touch::Struck(number) || radii == S::ZERO {
            continue;
        }
        let shift = period.map(|period| {
            let [x, y] = own.rounds_to(other, candidates.round(place)).map(|k| S::from_f64(f64::from(k)));
            Vec2::new(period.x * x, period.y * y)
        });
        let relative = Relative::straight(&own.straight_flight(), &other.straight_flight(), shift);
        let gap = relative.squared_gap(radii);
        let near = squared_tolerance(tolerance, radii);
        if gap <= near {
            is_clear &= *touch == Touch::Parting && gap >= -near && !relative.closes();
            continue;
        }
        let offset = relative.meeting(gap, radii);
        let time = relative.start + offset;
        let is_first = time == nearest.time && i64::from(number) < nearest.other;
        if time < nearest.time || is_first {
            *nearest = Nearest { time, offset, other: i64::from(number) };
        }
    }
    is_clear
}

#[cfg(target_arch = "x86_64")]
mod x86;

#[cfg(test)]
mod tests {
    use super::{
        Ball, Candidates, Four, Nearest, Nearness, Question, Touch, first_meeting, first_meeting_plain,
        first_meetings,
    };
    use crate::detect::squared_tolerance;
    use crate::flight::Flight;
    use crate::geometry::Vec2;
    use crate::model::{ContactTolerance, Table, rectangle};
    use crate::random::Random;

    /// Balls of several sizes at random places, some in touch, some at one time with others.
    fn balls(random: &mut Random) -> Vec<Ball<f64>> {
        let mut balls: Vec<Ball<f64>> = Vec::new();
        for number in 0..40 {
            let coarse = |x: f64| (x * 32.0).floor() / 32.0;
            let position = Vec2::new(6.0 * random.unit(), 6.0 * coarse(random.unit()));
            let velocity = Vec2::new(random.unit() - 0.5, coarse(random.unit()) - 0.5);
            let flight = Flight { start: random.unit(), position, velocity, acceleration: Vec2::ZERO };
            let radius = if random.below(4) == 0 { 0.0 } else { 0.3 * random.unit() };
            let mut ball = Ball::new(number, radius, &flight, 0);
            if random.below(30) == 0 {
                ball.rounds = [1, -1];
            }
            // The mirror image of the one before, so that a ball on the axis meets both at one time.
            if let Some(last) = balls.last().filter(|_| random.below(3) == 0) {
                let mirrored = |v: Vec2<f64>| Vec2::new(v.x, -v.y);
                ball = Ball { number: number as u32, ..*last };
                (ball.position, ball.velocity) = (mirrored(last.position), mirrored(last.velocity));
            }
            balls.push(ball);
        }
        balls
    }

    #[test]
    fn wide_registers_give_the_bits_of_the_plain_twin() {
        let tolerance = ContactTolerance::new(&Table::new(rectangle(6.0, 6.0), Vec::new()));
        let mut random = Random::new(3, "simd.test");
        let mut answers = [0; 2];
        for _ in 0..4000 {
            let balls = balls(&mut random);
            let own = balls[random.below(balls.len())];
            // Two points at one place are no more than asked about again.
            if own.radius == 0.0 {
                continue;
            }
            let touch =
                if random.below(2) == 0 { Touch::Parting } else { Touch::Struck(random.below(40) as u32) };
            let is_round = random.below(2) == 0;
            let cells: Vec<_> = (0..random.below(4))
                .map(|_| {
                    let mut fours = [Four::NOBODY; 3];
                    for four in &mut fours {
                        (0..random.below(5)).for_each(|_| assert!(four.push(random.below(40) as u32)));
                    }
                    (fours, [random.below(3) as i16 - 1, random.below(3) as i16 - 1])
                })
                .collect();
            let time = if random.below(2) == 0 { f64::INFINITY } else { 2.0 * random.unit() };
            let other = if time < f64::INFINITY { random.below(41) as i64 - 1 } else { -1 };
            let nearest = Nearest { time, offset: time, other };
            for period in [None, Some(Vec2::new(6.0, 7.0))] {
                let [most, least] = [0.6, 0.0].map(|radii| squared_tolerance(&tolerance, radii));
                let near = &Nearness { period, tolerance, most, least };
                let (balls, own) = (&balls, &own);
                let mut asked = [(); 6].map(|()| {
                    let candidates = Candidates::none(own.number);
                    Question { balls, own, touch, near, candidates, nearest }
                });
                for question in &mut asked {
                    question.candidates.clear(is_round);
                    for (fours, round) in &cells {
                        let candidates = &mut question.candidates;
                        assert!(if is_round {
                            candidates.add_cell(&fours[..1], *round)
                        } else {
                            candidates.add_cells::<1, 3>((fours, 1), 0, 1)
                        });
                    }
                }
                let [plain, wide, first, second, four, eight] = &mut asked;
                let is_clear = first_meeting_plain(plain);
                answers[usize::from(is_clear)] += 1;
                assert_eq!(first_meeting(wide), is_clear);
                assert_eq!(first_meetings(first, second), is_clear);
                // Each width by itself; what it leaves open is for the plain twin.
                for (question, lanes) in [(four, 4), (eight, 8)] {
                    #[cfg(target_arch = "x86_64")]
                    if super::x86::first_meeting_in(lanes, question) {
                        assert!(is_clear);
                        continue;
                    }
                    let _ = lanes;
                    assert_eq!(first_meeting(question), is_clear);
                }
                for Question { nearest: found, .. } in asked[1..].iter().filter(|_| is_clear) {
                    assert_eq!(found.time.to_bits(), asked[0].nearest.time.to_bits());
                    assert_eq!(found.offset.to_bits(), asked[0].nearest.offset.to_bits());
                    assert_eq!(found.other, asked[0].nearest.other);
                }
            }
        }
        assert!(answers.iter().all(|&count| count > 100), "{answers:?}");
    }
}
