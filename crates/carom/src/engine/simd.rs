//! The first meeting of one ball with several, four at a time where the processor can.
//!
//! This is the one module that may use `unsafe`: it loads lines of [`Ball`] into wide registers, and fetches memory before
//! it is needed. [`first_meeting`] has a plain twin in any scalar, which gives the same bits and is the only way elsewhere
//! than on x86-64 with AVX2.

#![allow(unsafe_code)]

use super::ball::Ball;
use crate::detect::{Relative, squared_tolerance};
use crate::geometry::Vec2;
use crate::model::ContactTolerance;
use crate::scalar::Scalar;
use core::any::Any;
use core::mem::MaybeUninit;

/// Room for so many numbers of balls that are asked at once.
pub const ROOM: usize = 64;

/// Balls that are asked at once; room for four more after each may be written over.
const MOST: usize = ROOM - 12;

/// Balls that may be met, by their numbers.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Candidates {
    /// Only the first `count` are known, and in [`Candidates::close`] some more.
    numbers: [MaybeUninit<u32>; ROOM],
    count: usize,
}

/// By how much each candidate is seen elsewhere than its flight says.
#[derive(Clone, Copy)]
pub struct Shifts<S> {
    x: [S; ROOM],
    y: [S; ROOM],
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

/// What asking some balls came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The first meeting is known.
    Known,
    /// One of them is so near that more has to be asked.
    TooNear,
    /// One of them has gone round the table: they have to be asked with where they are seen.
    GoneRound,
}

impl Candidates {
    /// Nobody yet.
    #[inline(always)]
    pub fn none() -> Self {
        Self { numbers: [MaybeUninit::uninit(); ROOM], count: 0 }
    }

    /// How many there are.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether so many more have room.
    #[inline(always)]
    pub fn has_room_for(&self, count: usize) -> bool {
        self.count + count <= MOST
    }

    /// Takes the first `count` of four places, where there is room for four.
    #[inline(always)]
    pub fn add_of_four(&mut self, places: &[u32; 4], count: usize) {
        if self.count <= ROOM - 4 {
            // All four are copied, so that nothing depends on how many; what is too much is written over.
            // SAFETY: there is room for four.
            unsafe {
                let room = self.numbers.as_mut_ptr().add(self.count).cast::<u32>();
                core::ptr::copy_nonoverlapping(places.as_ptr(), room, 4);
            }
            self.count += count.min(4);
        }
    }

    /// Takes the first `count` of a cell's places, of which there are four or a multiple of it; says whether there was room.
    #[inline(always)]
    pub fn add_cell(&mut self, places: &[u32], count: usize) -> bool {
        let (fours, _) = places.as_chunks::<4>();
        let Some((first, others)) = fours.split_first() else { return true };
        let has_room = self.has_room_for(4);
        self.add_of_four(first, count);
        if count <= 4 { has_room } else { has_room && self.add_others(others, count - 4) }
    }

    #[cold]
    fn add_others(&mut self, fours: &[[u32; 4]], count: usize) -> bool {
        let has_room = self.has_room_for(count + 4);
        for (four, from) in fours.iter().zip((0..count).step_by(4)) {
            self.add_of_four(four, count - from);
        }
        has_room
    }

    /// The balls.
    #[inline(always)]
    pub fn numbers(&self) -> &[u32] {
        let known = &self.numbers[..self.count];
        // SAFETY: the first `count` have been written.
        unsafe { &*(core::ptr::from_ref(known) as *const [u32]) }
    }

    /// Fills what wide registers would see after the last with the ball that asks, which never meets itself.
    #[inline(always)]
    fn close(&mut self, ball: u32) {
        for room in &mut self.numbers[self.count..self.count + 12] {
            room.write(ball);
        }
    }
}

impl<S: Scalar> Shifts<S> {
    /// None yet.
    #[inline(always)]
    pub fn none() -> Self {
        Self { x: [S::ZERO; ROOM], y: [S::ZERO; ROOM] }
    }

    /// Sets that of four candidates from a place on.
    #[inline(always)]
    pub fn set_four(&mut self, place: usize, shifts: [Vec2<S>; 4]) {
        if let (Some(x), Some(y)) = (self.x.get_mut(place..place + 4), self.y.get_mut(place..place + 4)) {
            x.copy_from_slice(&shifts.map(|shift| shift.x));
            y.copy_from_slice(&shifts.map(|shift| shift.y));
        }
    }

    fn at(&self, place: usize) -> Vec2<S> {
        Vec2::new(self.x[place], self.y[place])
    }
}

impl Answer {
    /// What two answers come to.
    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::GoneRound, _) | (_, Self::GoneRound) => Self::GoneRound,
            (Self::TooNear, _) | (_, Self::TooNear) => Self::TooNear,
            (Self::Known, Self::Known) => Self::Known,
        }
    }
}

/// The first of the candidates that `own`, in straight flight as they all are, meets before `nearest`; of two at one time
/// that with the lower number. Not counted are itself and the one that it has just been in contact with.
///
/// `shifts` say by how much each candidate is seen elsewhere than its flight says; without them nobody has gone round.
#[allow(clippy::ptr_arg)] // A slice cannot be asked whether it is one in f64.
#[inline(always)]
pub fn first_meeting<S: Scalar>(
    balls: &Vec<Ball<S>>,
    own: &Ball<S>,
    touch: Touch,
    candidates: &mut Candidates,
    shifts: Option<&Shifts<S>>,
    tolerance: &ContactTolerance<S>,
    nearest: &mut Nearest<S>,
) -> Answer {
    #[cfg(target_arch = "x86_64")]
    if let Some(balls) = (balls as &dyn Any).downcast_ref::<Vec<Ball<f64>>>()
        && let Some(own) = (own as &dyn Any).downcast_ref::<Ball<f64>>()
        && let Some(tolerance) = (tolerance as &dyn Any).downcast_ref::<ContactTolerance<f64>>()
        && let Some(nearest) = (nearest as &mut dyn Any).downcast_mut::<Nearest<f64>>()
        && is_wide()
    {
        candidates.close(own.number);
        let shifts = shifts.and_then(|shifts| (shifts as &dyn Any).downcast_ref::<Shifts<f64>>());
        // SAFETY: the processor has AVX2; every number is that of a ball.
        return unsafe {
            match shifts {
                None => avx2::first_meeting::<false>(balls, own, touch, candidates, None, tolerance, nearest),
                shifts => {
                    avx2::first_meeting::<true>(balls, own, touch, candidates, shifts, tolerance, nearest)
                }
            }
        };
    }
    first_meeting_plain(balls, own, touch, candidates, shifts, tolerance, nearest)
}

/// The plain twin.
pub fn first_meeting_plain<S: Scalar>(
    balls: &[Ball<S>],
    own: &Ball<S>,
    touch: Touch,
    candidates: &Candidates,
    shifts: Option<&Shifts<S>>,
    tolerance: &ContactTolerance<S>,
    nearest: &mut Nearest<S>,
) -> Answer {
    let mut answer = Answer::Known;
    for (place, &number) in candidates.numbers().iter().enumerate() {
        let other = &balls[number as usize];
        let radii = own.radius + other.radius;
        if number == own.number || touch == Touch::Struck(number) {
            continue;
        }
        if shifts.is_none() && other.rounds != [0; 2] {
            return Answer::GoneRound;
        }
        if radii == S::ZERO {
            continue;
        }
        let shift = shifts.map(|shifts| shifts.at(place));
        let relative = Relative::straight(&own.straight_flight(), &other.straight_flight(), shift);
        let gap = relative.squared_gap(radii);
        let near = squared_tolerance(tolerance, radii);
        if gap <= near {
            let parts = touch == Touch::Parting && gap >= -near && !relative.closes();
            answer = if parts { answer } else { Answer::TooNear };
            continue;
        }
        let offset = relative.meeting(gap, radii);
        let time = relative.start + offset;
        let is_first = time == nearest.time && i64::from(number) < nearest.other;
        if time < nearest.time || is_first {
            *nearest = Nearest { time, offset, other: i64::from(number) };
        }
    }
    answer
}

/// Whether wide registers can be used.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn is_wide() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
}

/// Fetches a line of memory that will be needed soon.
#[inline(always)]
pub fn fetch<T>(items: &[T], place: usize) {
    #[cfg(target_arch = "x86_64")]
    if let Some(item) = items.get(place) {
        // SAFETY: a prefetch of any address is harmless, and this one is in the slice.
        unsafe {
            core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(
                core::ptr::from_ref(item).cast(),
            );
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (items, place);
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Answer, Ball, Candidates, ContactTolerance, Nearest, Shifts, Touch};
    use core::arch::x86_64::*;
    use core::mem::MaybeUninit;

    /// The ball that asks, each of its numbers in all four lanes.
    struct Own {
        start: __m256d,
        position: [__m256d; 2],
        velocity: [__m256d; 2],
        radius: __m256d,
        number: __m256i,
        struck: __m256i,
        /// All ones where touching balls may part.
        parting: __m256d,
        /// 1e-10, and the part of the contact tolerance that is the table's.
        tolerance: [__m256d; 2],
    }

    /// The first meeting in each lane.
    struct First {
        time: __m256d,
        offset: __m256d,
        other: __m256i,
    }

    /// What was seen on the way, in any lane.
    struct Seen {
        /// The high halves are the rounds of those that were asked.
        rounds: __m256i,
        near: __m256d,
    }

    /// # Safety
    ///
    /// The processor has AVX2, and every number of the candidates, those after the last included, is that of a ball.
    #[target_feature(enable = "avx2")]
    pub unsafe fn first_meeting<const SHIFTED: bool>(
        balls: &[Ball<f64>],
        own: &Ball<f64>,
        touch: Touch,
        candidates: &Candidates,
        shifts: Option<&Shifts<f64>>,
        tolerance: &ContactTolerance<f64>,
        nearest: &mut Nearest<f64>,
    ) -> Answer {
        let all = |value| _mm256_set1_pd(value);
        let asker = Own {
            start: all(own.start),
            position: [all(own.position.x), all(own.position.y)],
            velocity: [all(own.velocity.x), all(own.velocity.y)],
            radius: all(own.radius),
            number: _mm256_set1_epi64x(i64::from(own.number)),
            struck: _mm256_set1_epi64x(if let Touch::Struck(other) = touch { i64::from(other) } else { -1 }),
            parting: _mm256_castsi256_pd(_mm256_set1_epi64x(if touch == Touch::Parting { -1 } else { 0 })),
            tolerance: [all(1e-10), all(tolerance.of(0.0))],
        };
        let mut first = First {
            time: all(nearest.time),
            offset: all(nearest.offset),
            other: _mm256_set1_epi64x(nearest.other),
        };
        let mut seen = Seen { rounds: _mm256_setzero_si256(), near: _mm256_setzero_pd() };
        let mut from = 0;
        // Three groups hold what nine cells usually do; so the number of them is no surprise to the processor.
        let groups = if candidates.count <= 4 { 1 } else { candidates.count.div_ceil(4).max(3) };
        for _ in 0..groups {
            // SAFETY: as of this function; there are twelve more numbers than candidates, and as many shifts as numbers.
            unsafe {
                let shift = match shifts {
                    Some(shifts) if SHIFTED => {
                        [&shifts.x, &shifts.y].map(|along| _mm256_loadu_pd(along.as_ptr().add(from)))
                    }
                    _ => [_mm256_setzero_pd(); 2],
                };
                let numbers = candidates.numbers.get_unchecked(from..from + 4);
                ask_four::<SHIFTED>(balls.as_ptr(), numbers, &asker, shift, &mut first, &mut seen);
            }
            from += 4;
        }
        let high = _mm256_srli_epi64::<32>(seen.rounds);
        if !SHIFTED && _mm256_testz_si256(high, high) == 0 {
            return Answer::GoneRound;
        }
        if _mm256_movemask_pd(seen.near) != 0 {
            return Answer::TooNear;
        }
        *nearest = first.of_all();
        Answer::Known
    }

    impl First {
        /// The first of the four lanes.
        #[target_feature(enable = "avx2")]
        #[inline]
        fn of_all(self) -> Nearest<f64> {
            let other = _mm256_castsi256_pd(self.other);
            let halves = self.earlier(First {
                time: _mm256_permute2f128_pd::<1>(self.time, self.time),
                offset: _mm256_permute2f128_pd::<1>(self.offset, self.offset),
                other: _mm256_castpd_si256(_mm256_permute2f128_pd::<1>(other, other)),
            });
            let other = _mm256_castsi256_pd(halves.other);
            let one = halves.earlier(First {
                time: _mm256_permute_pd::<5>(halves.time),
                offset: _mm256_permute_pd::<5>(halves.offset),
                other: _mm256_castpd_si256(_mm256_permute_pd::<5>(other)),
            });
            Nearest {
                time: _mm256_cvtsd_f64(one.time),
                offset: _mm256_cvtsd_f64(one.offset),
                other: _mm_cvtsi128_si64(_mm256_castsi256_si128(one.other)),
            }
        }

        /// Lane by lane the earlier of two, and of two at one time the lower number.
        #[target_feature(enable = "avx2")]
        #[inline]
        fn earlier(&self, that: Self) -> Self {
            let is_before = _mm256_cmp_pd::<_CMP_LT_OQ>(that.time, self.time);
            let is_even = _mm256_cmp_pd::<_CMP_EQ_OQ>(that.time, self.time);
            let is_lower = _mm256_castsi256_pd(_mm256_cmpgt_epi64(self.other, that.other));
            let chosen = _mm256_or_pd(is_before, _mm256_and_pd(is_even, is_lower));
            let other = [self.other, that.other].map(|other| _mm256_castsi256_pd(other));
            Self {
                time: _mm256_blendv_pd(self.time, that.time, chosen),
                offset: _mm256_blendv_pd(self.offset, that.offset, chosen),
                other: _mm256_castpd_si256(_mm256_blendv_pd(other[0], other[1], chosen)),
            }
        }
    }

    /// Asks four candidates. The order of every operation is that of [`super::first_meeting_plain`].
    ///
    /// # Safety
    ///
    /// The processor has AVX2, and there are four numbers, those of balls.
    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn ask_four<const SHIFTED: bool>(
        balls: *const Ball<f64>,
        numbers: &[MaybeUninit<u32>],
        own: &Own,
        shift: [__m256d; 2],
        first: &mut First,
        seen: &mut Seen,
    ) {
        // SAFETY: a ball in f64 is eight numbers of eight bytes, aligned to a line.
        let [low, high] = unsafe {
            let line = |k: usize| balls.add(numbers.get_unchecked(k).assume_init() as usize).cast::<f64>();
            let lines = [line(0), line(1), line(2), line(3)];
            [lines.map(|line| _mm256_load_pd(line)), lines.map(|line| _mm256_load_pd(line.add(4)))]
        };
        let [start, x, y, vx] = transposed(low);
        let [vy, radius, _, last] = transposed(high);
        let last = _mm256_castpd_si256(last);
        let number = _mm256_and_si256(last, _mm256_set1_epi64x(0xffff_ffff));
        let is_other = |who| _mm256_castsi256_pd(_mm256_cmpeq_epi64(number, who));
        let is_left_out = _mm256_or_pd(is_other(own.number), is_other(own.struck));
        seen.rounds =
            _mm256_or_si256(seen.rounds, _mm256_andnot_si256(_mm256_castpd_si256(is_left_out), last));

        let (add, sub, mul) =
            (|a, b| _mm256_add_pd(a, b), |a, b| _mm256_sub_pd(a, b), |a, b| _mm256_mul_pd(a, b));
        let later = _mm256_max_pd(own.start, start);
        let (after_own, after) = (sub(later, own.start), sub(later, start));
        let place = |position, velocity, elapsed| add(position, mul(velocity, elapsed));
        let mut dx = sub(place(x, vx, after), place(own.position[0], own.velocity[0], after_own));
        let mut dy = sub(place(y, vy, after), place(own.position[1], own.velocity[1], after_own));
        if SHIFTED {
            (dx, dy) = (add(dx, shift[0]), add(dy, shift[1]));
        }
        let (wx, wy) = (sub(vx, own.velocity[0]), sub(vy, own.velocity[1]));
        let radii = add(own.radius, radius);
        let radii_squared = mul(radii, radii);
        let gap = sub(add(mul(dx, dx), mul(dy, dy)), radii_squared);

        let of_contact = add(mul(radii, own.tolerance[0]), own.tolerance[1]);
        let tolerance = mul(add(radii, radii), of_contact);
        let slope = add(mul(dx, wx), mul(dy, wy));
        let zero = _mm256_setzero_pd();
        let is_near = _mm256_cmp_pd::<_CMP_LE_OQ>(gap, tolerance);
        let parts = _mm256_and_pd(
            _mm256_and_pd(own.parting, _mm256_cmp_pd::<_CMP_GE_OQ>(slope, zero)),
            _mm256_cmp_pd::<_CMP_GE_OQ>(gap, sub(zero, tolerance)),
        );
        let is_passed_over = _mm256_or_pd(is_left_out, parts);
        seen.near = _mm256_or_pd(seen.near, _mm256_andnot_pd(is_passed_over, is_near));

        let miss = sub(mul(dx, wy), mul(dy, wx));
        let speed_squared = add(mul(wx, wx), mul(wy, wy));
        let discriminant = sub(mul(speed_squared, radii_squared), mul(miss, miss));
        let closes = _mm256_and_pd(
            _mm256_cmp_pd::<_CMP_LT_OQ>(slope, zero),
            _mm256_cmp_pd::<_CMP_GT_OQ>(discriminant, zero),
        );
        let meets = _mm256_andnot_pd(is_left_out, closes);
        let offset = _mm256_div_pd(gap, sub(_mm256_sqrt_pd(discriminant), slope));
        let time = add(later, offset);
        let time = _mm256_blendv_pd(_mm256_set1_pd(f64::INFINITY), time, meets);
        *first = first.earlier(First { time, offset, other: number });
    }

    /// Four rows of four as four columns.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
        let (even_ab, odd_ab) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
        let (even_cd, odd_cd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
        [
            _mm256_permute2f128_pd::<0x20>(even_ab, even_cd),
            _mm256_permute2f128_pd::<0x20>(odd_ab, odd_cd),
            _mm256_permute2f128_pd::<0x31>(even_ab, even_cd),
            _mm256_permute2f128_pd::<0x31>(odd_ab, odd_cd),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{Answer, Ball, Candidates, Nearest, Shifts, Touch, first_meeting, first_meeting_plain};
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
        let mut answers = [0; 3];
        for _ in 0..4000 {
            let balls = balls(&mut random);
            let own = balls[random.below(balls.len())];
            // Two points at one place are no more than asked about again.
            if own.radius == 0.0 {
                continue;
            }
            let touch =
                if random.below(2) == 0 { Touch::Parting } else { Touch::Struck(random.below(40) as u32) };
            let (mut candidates, mut shifts) = (Candidates::none(), Shifts::none());
            for _ in 0..random.below(10) {
                let four = [0; 4].map(|_| random.below(40) as u32);
                let seen = [0; 4].map(|_| Vec2::new(6.0 * random.below(2) as f64, 0.0));
                shifts.set_four(candidates.count(), seen);
                candidates.add_of_four(&four, random.below(5));
            }
            let time = if random.below(2) == 0 { f64::INFINITY } else { 2.0 * random.unit() };
            let other = if time < f64::INFINITY { random.below(41) as i64 - 1 } else { -1 };
            let before = Nearest { time, offset: time, other };
            for shifts in [None, Some(&shifts)] {
                let (mut wide, mut plain) = (before, before);
                let found =
                    first_meeting(&balls, &own, touch, &mut candidates, shifts, &tolerance, &mut wide);
                let twin =
                    first_meeting_plain(&balls, &own, touch, &candidates, shifts, &tolerance, &mut plain);
                answers[twin as usize] += 1;
                if found == Answer::Known || twin == Answer::Known {
                    assert_eq!(found, twin);
                    assert_eq!(wide.time.to_bits(), plain.time.to_bits());
                    assert_eq!(wide.offset.to_bits(), plain.offset.to_bits());
                    assert_eq!(wide.other, plain.other);
                }
            }
        }
        assert!(answers.iter().all(|&count| count > 100), "{answers:?}");
    }
}
