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

/// Balls that are asked at once.
const MOST: usize = 52;

/// Room for them, and for what is written over before it is known how many there are.
const ROOM: usize = MOST + 28;

/// Balls that may be met, by their numbers.
#[repr(align(64))]
pub struct Candidates {
    /// Only the first `count` are known, and in [`Candidates::close`] some more.
    numbers: [MaybeUninit<u32>; ROOM],
    /// Where `is_round`: how often one has gone round the table to see each; otherwise nobody has.
    rounds: [MaybeUninit<[i16; 2]>; ROOM],
    count: usize,
    is_round: bool,
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
    /// Nobody yet; whether one goes round to see any.
    #[inline(always)]
    pub fn none(is_round: bool) -> Self {
        let (numbers, rounds) = ([MaybeUninit::uninit(); ROOM], [MaybeUninit::uninit(); ROOM]);
        Self { numbers, rounds, count: 0, is_round }
    }

    /// Whether so many more have room.
    #[inline(always)]
    pub fn has_room_for(&self, count: usize) -> bool {
        self.count + count <= MOST
    }

    /// Takes the balls of some cells that lie together, where one does not go round to see any: so many columns of so many
    /// rows from `first` on. Of all cells, which are `columns` to a row, are given the places, `width` for each, and how many
    /// are filled. `false`, and they are not all taken, where a cell has more than four, there is no room, or one goes round.
    #[inline(always)]
    pub fn add_cells<const COLUMNS: usize, const ROWS: usize>(
        &mut self,
        (places, width): (&[u32], usize),
        filled: &[u32],
        first: usize,
        columns: usize,
    ) -> bool {
        let last = first + (ROWS - 1) * columns + COLUMNS;
        if self.is_round
            || width < 4
            || last > filled.len()
            || last * width > places.len()
            || !self.has_room_for(4 * COLUMNS * ROWS)
        {
            return false;
        }
        let mut most = 0;
        for row in 0..ROWS {
            for cell in first + row * columns..first + row * columns + COLUMNS {
                // All four are copied, so that nothing depends on how many; what is too much is written over.
                // SAFETY: the cell is none after the last, each has `width` places, which are four at least, and there is
                // room for four of each.
                unsafe {
                    let count = *filled.get_unchecked(cell);
                    let from = places.as_ptr().add(cell * width);
                    core::ptr::copy_nonoverlapping(from, self.numbers.as_mut_ptr().add(self.count).cast(), 4);
                    most = if count > most { count } else { most };
                    // Of a cell with more than four, no more than seven: the answer is no anyway.
                    self.count += (count & 7) as usize;
                }
            }
        }
        most <= 4
    }

    /// Takes the balls of a cell: its places, how many are filled, and how often one goes round to see them. `false`, and they
    /// are not all taken, where there are more than four, or there is no room.
    #[inline(always)]
    pub fn add_cell(&mut self, places: &[u32], filled: u32, round: [i16; 2]) -> bool {
        if places.len() < 4 || !self.has_room_for(4) {
            return false;
        }
        // SAFETY: there are four places, and room for four.
        unsafe {
            let (numbers, rounds) = (self.numbers.as_mut_ptr(), self.rounds.as_mut_ptr());
            core::ptr::copy_nonoverlapping(places.as_ptr(), numbers.add(self.count).cast(), 4);
            rounds.add(self.count).cast::<[[i16; 2]; 4]>().write_unaligned([round; 4]);
        }
        self.count += filled.min(4) as usize;
        filled <= 4
    }

    /// The balls.
    #[inline(always)]
    fn numbers(&self) -> &[u32] {
        let known = &self.numbers[..self.count];
        // SAFETY: the first `count` have been written.
        unsafe { &*(core::ptr::from_ref(known) as *const [u32]) }
    }

    /// How often one has gone round to see one of the balls.
    fn round(&self, place: usize) -> [i16; 2] {
        // SAFETY: where it is said that they are round, the first `count` have been written.
        if self.is_round && place < self.count { unsafe { self.rounds[place].assume_init() } } else { [0; 2] }
    }

    /// Fills what wide registers would see after the last with the ball that asks, which never meets itself.
    #[inline(always)]
    fn close(&mut self, ball: u32) {
        let (from, to) = (self.count, self.count + 4);
        self.numbers[from..to].fill(MaybeUninit::new(ball));
        if self.is_round {
            self.rounds[from..to].fill(MaybeUninit::new([0; 2]));
        }
    }
}

/// The first of the candidates that `own`, in straight flight as they all are, meets before `nearest`; of two at one time
/// that with the lower number. Not counted are itself and the one that it has just been in contact with. `false` where one
/// of them is so near that more has to be asked.
///
/// `period` is how large a periodic table is; on any other nobody goes round.
#[allow(clippy::ptr_arg)] // A slice cannot be asked whether it is one in f64.
#[inline(always)]
pub fn first_meeting<S: Scalar>(
    balls: &Vec<Ball<S>>,
    own: &Ball<S>,
    touch: Touch,
    candidates: &mut Candidates,
    period: Option<Vec2<S>>,
    tolerance: &ContactTolerance<S>,
    nearest: &mut Nearest<S>,
) -> bool {
    #[cfg(target_arch = "x86_64")]
    if let Some(balls) = (balls as &dyn Any).downcast_ref::<Vec<Ball<f64>>>()
        && let Some(own) = (own as &dyn Any).downcast_ref::<Ball<f64>>()
        && let Some(tolerance) = (tolerance as &dyn Any).downcast_ref::<ContactTolerance<f64>>()
        && let Some(nearest) = (nearest as &mut dyn Any).downcast_mut::<Nearest<f64>>()
        && let Some(period) = (&period as &dyn Any).downcast_ref::<Option<Vec2<f64>>>()
        && is_wide()
    {
        candidates.close(own.number);
        // SAFETY: the processor has AVX2; every number is that of a ball.
        return unsafe {
            match period {
                None => avx2::first_meeting::<false>(
                    balls,
                    own,
                    touch,
                    candidates,
                    Vec2::ZERO,
                    tolerance,
                    nearest,
                ),
                Some(period) => {
                    avx2::first_meeting::<true>(balls, own, touch, candidates, *period, tolerance, nearest)
                }
            }
        };
    }
    first_meeting_plain(balls, own, touch, candidates, period, tolerance, nearest)
}

/// The plain twin.
pub fn first_meeting_plain<S: Scalar>(
    balls: &[Ball<S>],
    own: &Ball<S>,
    touch: Touch,
    candidates: &Candidates,
    period: Option<Vec2<S>>,
    tolerance: &ContactTolerance<S>,
    nearest: &mut Nearest<S>,
) -> bool {
    let mut is_clear = true;
    for (place, &number) in candidates.numbers().iter().enumerate() {
        let other = &balls[number as usize];
        let radii = own.radius + other.radius;
        if number == own.number || touch == Touch::Struck(number) || radii == S::ZERO {
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
            is_clear &= touch == Touch::Parting && gap >= -near && !relative.closes();
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
    use super::{Ball, Candidates, ContactTolerance, Nearest, Touch};
    use crate::geometry::Vec2;
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
        rounds: __m128i,
        /// How large a periodic table is.
        period: [__m256d; 2],
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

    /// # Safety
    ///
    /// The processor has AVX2, and every number of the candidates, those after the last included, is that of a ball.
    #[target_feature(enable = "avx2")]
    pub unsafe fn first_meeting<const PERIODIC: bool>(
        balls: &[Ball<f64>],
        own: &Ball<f64>,
        touch: Touch,
        candidates: &Candidates,
        period: Vec2<f64>,
        tolerance: &ContactTolerance<f64>,
        nearest: &mut Nearest<f64>,
    ) -> bool {
        let all = |value| _mm256_set1_pd(value);
        let pair = |[low, high]: [i16; 2]| _mm_set1_epi32(i32::from(low) & 0xffff | i32::from(high) << 16);
        let asker = Own {
            start: all(own.start),
            position: [all(own.position.x), all(own.position.y)],
            velocity: [all(own.velocity.x), all(own.velocity.y)],
            radius: all(own.radius),
            number: _mm256_set1_epi64x(i64::from(own.number)),
            struck: _mm256_set1_epi64x(if let Touch::Struck(other) = touch { i64::from(other) } else { -1 }),
            rounds: pair(own.rounds),
            period: [all(period.x), all(period.y)],
            parting: _mm256_castsi256_pd(_mm256_set1_epi64x(if touch == Touch::Parting { -1 } else { 0 })),
            tolerance: [all(1e-10), all(tolerance.of(0.0))],
        };
        let mut first = First {
            time: all(nearest.time),
            offset: all(nearest.offset),
            other: _mm256_set1_epi64x(nearest.other),
        };
        let mut near = _mm256_setzero_pd();
        let mut from = 0;
        for _ in 0..candidates.count.div_ceil(4) {
            // SAFETY: as of this function; there are four more numbers than candidates, and as many rounds where there are any.
            unsafe {
                let round = if PERIODIC && candidates.is_round {
                    _mm_loadu_si128(candidates.rounds.as_ptr().add(from).cast())
                } else {
                    _mm_setzero_si128()
                };
                let numbers = candidates.numbers.get_unchecked(from..from + 4);
                ask_four::<PERIODIC>(balls.as_ptr(), numbers, &asker, round, &mut first, &mut near);
            }
            from += 4;
        }
        if _mm256_movemask_pd(near) != 0 {
            return false;
        }
        *nearest = first.of_all();
        true
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
    unsafe fn ask_four<const PERIODIC: bool>(
        balls: *const Ball<f64>,
        numbers: &[MaybeUninit<u32>],
        own: &Own,
        round: __m128i,
        first: &mut First,
        near: &mut __m256d,
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

        let (add, sub, mul) =
            (|a, b| _mm256_add_pd(a, b), |a, b| _mm256_sub_pd(a, b), |a, b| _mm256_mul_pd(a, b));
        let later = _mm256_max_pd(own.start, start);
        let (after_own, after) = (sub(later, own.start), sub(later, start));
        let place = |position, velocity, elapsed| add(position, mul(velocity, elapsed));
        let mut dx = sub(place(x, vx, after), place(own.position[0], own.velocity[0], after_own));
        let mut dy = sub(place(y, vy, after), place(own.position[1], own.velocity[1], after_own));
        if PERIODIC {
            // The high half of each last number is the rounds of a ball, in pairs of sixteen bits.
            let high = _mm256_permutevar8x32_epi32(last, _mm256_setr_epi32(1, 3, 5, 7, 1, 3, 5, 7));
            let their = _mm256_castsi256_si128(high);
            let between = _mm_sub_epi16(_mm_add_epi16(round, own.rounds), their);
            let rounds_x = _mm256_cvtepi32_pd(_mm_srai_epi32::<16>(_mm_slli_epi32::<16>(between)));
            let rounds_y = _mm256_cvtepi32_pd(_mm_srai_epi32::<16>(between));
            dx = add(dx, mul(own.period[0], rounds_x));
            dy = add(dy, mul(own.period[1], rounds_y));
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
        *near = _mm256_or_pd(*near, _mm256_andnot_pd(is_passed_over, is_near));

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
    use super::{Ball, Candidates, Nearest, Touch, first_meeting, first_meeting_plain};
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
            let mut candidates = Candidates::none(is_round);
            for _ in 0..random.below(4) {
                let places = [0; 12].map(|_| random.below(40) as u32);
                let filled = [0; 3].map(|_| random.below(5) as u32);
                let round = [random.below(3) as i16 - 1, random.below(3) as i16 - 1];
                let has_room = if is_round {
                    candidates.add_cell(&places, filled[0], round)
                } else {
                    candidates.add_cells::<1, 3>((&places, 4), &filled, 0, 1)
                };
                assert!(has_room);
            }
            let time = if random.below(2) == 0 { f64::INFINITY } else { 2.0 * random.unit() };
            let other = if time < f64::INFINITY { random.below(41) as i64 - 1 } else { -1 };
            let before = Nearest { time, offset: time, other };
            for period in [None, Some(Vec2::new(6.0, 7.0))] {
                let (mut wide, mut plain) = (before, before);
                let found =
                    first_meeting(&balls, &own, touch, &mut candidates, period, &tolerance, &mut wide);
                let twin =
                    first_meeting_plain(&balls, &own, touch, &candidates, period, &tolerance, &mut plain);
                answers[usize::from(twin)] += 1;
                assert_eq!(found, twin);
                if twin {
                    assert_eq!(wide.time.to_bits(), plain.time.to_bits());
                    assert_eq!(wide.offset.to_bits(), plain.offset.to_bits());
                    assert_eq!(wide.other, plain.other);
                }
            }
        }
        assert!(answers.iter().all(|&count| count > 100), "{answers:?}");
    }
}
