//! The first meeting in wide registers: eight lanes with AVX-512, four with AVX2. The arithmetic is written once, in a
//! macro, over the few operations that each width names.

use super::{Ball, Candidates, Nearest, Question, ROOM, Touch};
use crate::geometry::Vec2;
use core::arch::x86_64::*;
use core::mem::MaybeUninit;

/// When each candidate is met: the time, and the offset, which means nothing where the time is infinite.
#[repr(align(64))]
struct Answers {
    times: MaybeUninit<[f64; ROOM]>,
    offsets: MaybeUninit<[f64; ROOM]>,
}

/// Answers a question; `false`, and nothing is known, where a candidate may be in touch, or there are no wide registers.
#[inline(always)]
pub fn first_meeting(question: &mut Question<f64>) -> bool {
    question.candidates.close();
    // SAFETY: the processor has what each asks for; every number of the candidates is that of a ball.
    unsafe {
        if question.candidates.count > 4 && has_eight() {
            eight::first_meeting(question)
        } else {
            has_four() && four::first_meeting(question)
        }
    }
}

/// Answers two questions; `false` where that holds of one of them.
#[inline(always)]
pub fn first_meetings(a: &mut Question<f64>, b: &mut Question<f64>) -> bool {
    a.candidates.close();
    b.candidates.close();
    // SAFETY: the processor has what each asks for; every number of the candidates is that of a ball.
    unsafe {
        if has_eight() { eight::first_meetings(a, b) } else { has_four() && four::first_meetings(a, b) }
    }
}

/// The same with so many lanes, if there are registers of so many.
#[cfg(test)]
pub fn first_meeting_in(lanes: usize, question: &mut Question<f64>) -> bool {
    question.candidates.close();
    // SAFETY: as of first_meeting.
    unsafe {
        match lanes {
            4 => has_four() && four::first_meeting(question),
            _ => has_eight() && eight::first_meeting(question),
        }
    }
}

#[inline(always)]
fn has_eight() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx512dq")
}

#[inline(always)]
fn has_four() -> bool {
    is_x86_feature_detected!("avx2")
}

impl Answers {
    #[inline(always)]
    fn none() -> Self {
        Self { times: MaybeUninit::uninit(), offsets: MaybeUninit::uninit() }
    }

    /// Takes the candidate at `place` if it is met before `nearest`; of two at one time that with the lower number.
    ///
    /// # Safety
    ///
    /// So many candidates have answered.
    #[inline(always)]
    unsafe fn take(&self, place: usize, candidates: &Candidates, nearest: &mut Nearest<f64>) {
        // SAFETY: as of this function.
        let (time, offset, other) = unsafe {
            let at = |numbers: &MaybeUninit<[f64; ROOM]>| *numbers.as_ptr().cast::<f64>().add(place);
            (
                at(&self.times),
                at(&self.offsets),
                i64::from(*candidates.numbers.as_ptr().cast::<u32>().add(place)),
            )
        };
        if time < nearest.time || (time == nearest.time && other < nearest.other) {
            *nearest = Nearest { time, offset, other };
        }
    }
}

/// What does not depend on the width but by the names of the operations.
macro_rules! first_meetings {
    ($features:literal) => {
        use super::*;

        /// The ball that asks, each of its numbers in all lanes.
        struct Own {
            start: Reals,
            position: [Reals; 2],
            velocity: [Reals; 2],
            radius: Reals,
            number: Whole,
            struck: Whole,
            rounds: Pairs,
            /// How large a periodic table is.
            period: [Reals; 2],
            /// A squared gap that is larger is no contact of any two.
            near: Reals,
            /// Two that part and have at least this squared gap are passed over.
            parted: Reals,
        }

        /// # Safety
        ///
        /// The processor has the features, and every number of the candidates, those after the last included, is that of a
        /// ball.
        #[target_feature(enable = $features)]
        pub unsafe fn first_meeting(question: &mut Question<f64>) -> bool {
            let mut answers = Answers::none();
            // SAFETY: as of this function; then these are the answers.
            unsafe {
                let (time, is_near) = ask_all(question, &mut answers);
                if !is_near {
                    choose_first(lowest(time), &answers, question);
                }
                !is_near
            }
        }

        /// Both are asked before any answer is looked at, so that neither waits for the roots of the other.
        ///
        /// # Safety
        ///
        /// As of [`first_meeting`].
        #[target_feature(enable = $features)]
        pub unsafe fn first_meetings(a: &mut Question<f64>, b: &mut Question<f64>) -> bool {
            let (mut answers_a, mut answers_b) = (Answers::none(), Answers::none());
            // SAFETY: as of this function; then these are the answers.
            unsafe {
                let (time_a, is_near_a) = ask_all(a, &mut answers_a);
                let (time_b, is_near_b) = ask_all(b, &mut answers_b);
                let is_near = is_near_a | is_near_b;
                if !is_near {
                    choose_first(lowest(time_a), &answers_a, a);
                    choose_first(lowest(time_b), &answers_b, b);
                }
                !is_near
            }
        }

        /// Takes the first of the answers, which is at `time`, if it comes before `nearest`.
        ///
        /// # Safety
        ///
        /// The processor has the features, and all candidates have answered.
        #[target_feature(enable = $features)]
        #[inline]
        unsafe fn choose_first(
            time: f64,
            answers: &Answers,
            Question { candidates, nearest, .. }: &mut Question<f64>,
        ) {
            if time > nearest.time || time == f64::INFINITY {
                return;
            }
            let mut first = 0_u64;
            let mut from = 0;
            while from < candidates.count {
                // SAFETY: as of this function.
                let times = unsafe { answers.times.as_ptr().cast::<f64>().add(from) };
                first |= bits(same_real(unsafe { load(times) }, all(time))) << from;
                from += LANES;
            }
            // Hardly ever are there several.
            while first != 0 {
                // SAFETY: as of this function.
                unsafe { answers.take(first.trailing_zeros() as usize, candidates, nearest) };
                first &= first - 1;
            }
        }

        /// Asks all candidates of a ball: the first time, in one of the lanes, and whether one of them may be in touch.
        ///
        /// # Safety
        ///
        /// The processor has the features, and every number of the candidates, those after the last included, is that of a
        /// ball.
        #[target_feature(enable = $features)]
        #[inline]
        unsafe fn ask_all(
            &Question { balls, own, touch, near, ref candidates, .. }: &Question<f64>,
            answers: &mut Answers,
        ) -> (Reals, bool) {
            let struck = if let Touch::Struck(other) = touch { other } else { own.number };
            let parted = if touch == Touch::Parting { -near.least } else { f64::INFINITY };
            let period = near.period.unwrap_or(Vec2::ZERO);
            let asker = Own {
                start: all(own.start),
                position: [all(own.position.x), all(own.position.y)],
                velocity: [all(own.velocity.x), all(own.velocity.y)],
                radius: all(own.radius),
                number: whole(i64::from(own.number)),
                struck: whole(i64::from(struck)),
                rounds: pairs(own.rounds),
                period: [all(period.x), all(period.y)],
                near: all(near.most),
                parted: all(parted),
            };
            let (mut first, mut is_near) = (all(f64::INFINITY), NONE);
            let mut from = 0;
            while from < candidates.count {
                // SAFETY: as of this function; as many numbers as lanes follow the last candidate, and as many rounds where
                // there are any, and there is room for as many answers.
                unsafe {
                    let numbers = candidates.numbers.as_ptr().cast::<u32>().add(from);
                    let rounds =
                        candidates.is_round.then(|| candidates.rounds.as_ptr().cast::<[i16; 2]>().add(from));
                    let (time, offset, near) = ask(balls.as_ptr(), numbers, &asker, rounds);
                    store(answers.times.as_mut_ptr().cast::<f64>().add(from), time);
                    store(answers.offsets.as_mut_ptr().cast::<f64>().add(from), offset);
                    first = lower(first, time);
                    is_near = or(is_near, near);
                }
                from += LANES;
            }
            (first, bits(is_near) != 0)
        }

        /// Asks a group of candidates: when each is met, after what offset, and whether it may be in touch. The order of every
        /// operation is that of [`crate::detect::Relative`].
        ///
        /// # Safety
        ///
        /// The processor has the features, and there are as many numbers as lanes, those of balls, and as many rounds, if any.
        #[target_feature(enable = $features)]
        #[inline]
        unsafe fn ask(
            balls: *const Ball<f64>,
            numbers: *const u32,
            own: &Own,
            rounds: Option<*const [i16; 2]>,
        ) -> (Reals, Reals, Mask) {
            // SAFETY: as of this function.
            let ([start, x, y, their_vx, their_vy, radius], last) = unsafe { columns(balls, numbers) };
            let number = low_halves(last);
            let is_left_out = or(same(number, own.number), same(number, own.struck));
            let later = larger(own.start, start);
            let (after_own, after) = (sub(later, own.start), sub(later, start));
            let (own_x, own_y) = (mul(own.velocity[0], after_own), mul(own.velocity[1], after_own));
            let (own_x, own_y) = (add(own.position[0], own_x), add(own.position[1], own_y));
            let mut x = sub(add(x, mul(their_vx, after)), own_x);
            let mut y = sub(add(y, mul(their_vy, after)), own_y);
            // Most have gone round as often as the one that asks.
            if rounds.is_some() || differ(high_halves(last), own.rounds) {
                // SAFETY: as of this function.
                let rounds = rounds.map_or(pairs([0; 2]), |rounds| unsafe { these_pairs(rounds) });
                let [between_x, between_y] = between(rounds, own.rounds, high_halves(last));
                x = add(x, mul(own.period[0], between_x));
                y = add(y, mul(own.period[1], between_y));
            }
            let (vx, vy) = (sub(their_vx, own.velocity[0]), sub(their_vy, own.velocity[1]));
            let radii = add(own.radius, radius);
            let square = mul(radii, radii);
            let gap = sub(add(mul(x, x), mul(y, y)), square);
            let slope = add(mul(x, vx), mul(y, vy));
            let miss = sub(mul(x, vy), mul(y, vx));
            let speed_squared = add(mul(vx, vx), mul(vy, vy));
            let discriminant = sub(mul(speed_squared, square), mul(miss, miss));
            let closes = and(less(slope, all(0.0)), less(all(0.0), discriminant));
            let offset = div(gap, sub(root(discriminant), slope));
            let time = choose(and_not(closes, is_left_out), add(later, offset), all(f64::INFINITY));
            let parts = and(no_more(all(0.0), slope), no_more(own.parted, gap));
            (time, offset, and_not(no_more(gap, own.near), or(is_left_out, parts)))
        }
    };
}

/// AVX2.
mod four {
    first_meetings!("avx2");

    const LANES: usize = 4;
    type Reals = __m256d;
    type Whole = __m256i;
    type Pairs = __m128i;
    type Mask = __m256d;
    // SAFETY: all bits zero are four zeros.
    const NONE: Mask = unsafe { core::mem::zeroed() };

    /// Plain operations of so many lanes.
    macro_rules! operations {
        ($($name:ident($($argument:ident: $type:ty),+) -> $result:ty = $value:expr;)+) => {
            $(#[target_feature(enable = "avx2")] #[inline] fn $name($($argument: $type),+) -> $result { $value })+
        };
    }

    operations! {
        all(x: f64) -> Reals = _mm256_set1_pd(x);
        whole(x: i64) -> Whole = _mm256_set1_epi64x(x);
        pairs(x: [i16; 2]) -> Pairs = _mm_set1_epi32(i32::from(x[0]) & 0xffff | i32::from(x[1]) << 16);
        add(a: Reals, b: Reals) -> Reals = _mm256_add_pd(a, b);
        sub(a: Reals, b: Reals) -> Reals = _mm256_sub_pd(a, b);
        mul(a: Reals, b: Reals) -> Reals = _mm256_mul_pd(a, b);
        div(a: Reals, b: Reals) -> Reals = _mm256_div_pd(a, b);
        root(a: Reals) -> Reals = _mm256_sqrt_pd(a);
        larger(a: Reals, b: Reals) -> Reals = _mm256_max_pd(a, b);
        lower(a: Reals, b: Reals) -> Reals = _mm256_min_pd(a, b);
        less(a: Reals, b: Reals) -> Mask = _mm256_cmp_pd::<_CMP_LT_OQ>(a, b);
        no_more(a: Reals, b: Reals) -> Mask = _mm256_cmp_pd::<_CMP_LE_OQ>(a, b);
        same_real(a: Reals, b: Reals) -> Mask = _mm256_cmp_pd::<_CMP_EQ_OQ>(a, b);
        same(a: Whole, b: Whole) -> Mask = _mm256_castsi256_pd(_mm256_cmpeq_epi64(a, b));
        and(a: Mask, b: Mask) -> Mask = _mm256_and_pd(a, b);
        or(a: Mask, b: Mask) -> Mask = _mm256_or_pd(a, b);
        and_not(a: Mask, b: Mask) -> Mask = _mm256_andnot_pd(b, a);
        bits(a: Mask) -> u64 = _mm256_movemask_pd(a) as u64;
        choose(is: Mask, a: Reals, b: Reals) -> Reals = _mm256_blendv_pd(b, a, is);
        low_halves(a: Whole) -> Whole = _mm256_and_si256(a, whole(0xffff_ffff));
    }

    /// # Safety
    ///
    /// The processor has AVX2, and there are four.
    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn these_pairs(four: *const [i16; 2]) -> Pairs {
        // SAFETY: as of this function.
        unsafe { _mm_loadu_si128(four.cast()) }
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn load(four: *const f64) -> Reals {
        // SAFETY: as of these_pairs; they are aligned.
        unsafe { _mm256_load_pd(four) }
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn store(four: *mut f64, numbers: Reals) {
        // SAFETY: as of these_pairs; they are aligned.
        unsafe { _mm256_store_pd(four, numbers) }
    }

    /// Of each whole number the high half.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn high_halves(numbers: Whole) -> Pairs {
        let high = _mm256_permutevar8x32_epi32(numbers, _mm256_setr_epi32(1, 3, 5, 7, 1, 3, 5, 7));
        _mm256_castsi256_si128(high)
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn differ(a: Pairs, b: Pairs) -> bool {
        let different = _mm_xor_si128(a, b);
        _mm_testz_si128(different, different) == 0
    }

    /// How often one goes round to see each ball.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn between(rounds: Pairs, own: Pairs, their: Pairs) -> [Reals; 2] {
        let between = _mm_sub_epi16(_mm_add_epi16(rounds, own), their);
        [
            _mm256_cvtepi32_pd(_mm_srai_epi32::<16>(_mm_slli_epi32::<16>(between))),
            _mm256_cvtepi32_pd(_mm_srai_epi32::<16>(between)),
        ]
    }

    /// The least of all lanes.
    #[target_feature(enable = "avx2")]
    #[inline]
    pub fn lowest(numbers: Reals) -> f64 {
        let two = _mm_min_pd(_mm256_castpd256_pd128(numbers), _mm256_extractf128_pd::<1>(numbers));
        _mm_cvtsd_f64(_mm_min_sd(two, _mm_unpackhi_pd(two, two)))
    }

    /// The lines of four balls, number by number, without the seventh: six in `f64` and the last.
    ///
    /// # Safety
    ///
    /// The processor has AVX2, and there are four numbers, those of balls.
    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn columns(balls: *const Ball<f64>, numbers: *const u32) -> ([Reals; 6], Whole) {
        // SAFETY: a ball in f64 is eight numbers of eight bytes, aligned to a line.
        let half = |k: usize, from: usize| unsafe {
            _mm256_load_pd(balls.add(*numbers.add(k) as usize).cast::<f64>().add(from))
        };
        let [start, x, y, vx] = transposed([half(0, 0), half(1, 0), half(2, 0), half(3, 0)]);
        let [vy, radius, _, last] = transposed([half(0, 4), half(1, 4), half(2, 4), half(3, 4)]);
        ([start, x, y, vx, vy, radius], _mm256_castpd_si256(last))
    }

    /// Four rows of four as four columns.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn transposed([a, b, c, d]: [Reals; 4]) -> [Reals; 4] {
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

/// AVX-512.
mod eight {
    first_meetings!("avx512f,avx512vl,avx512dq");

    const LANES: usize = 8;
    type Reals = __m512d;
    type Whole = __m512i;
    type Pairs = __m256i;
    type Mask = __mmask8;
    const NONE: Mask = 0;

    /// Plain operations of so many lanes.
    macro_rules! operations {
        ($($name:ident($($argument:ident: $type:ty),+) -> $result:ty = $value:expr;)+) => {
            $(
                #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
                #[inline]
                fn $name($($argument: $type),+) -> $result { $value }
            )+
        };
    }

    operations! {
        all(x: f64) -> Reals = _mm512_set1_pd(x);
        whole(x: i64) -> Whole = _mm512_set1_epi64(x);
        pairs(x: [i16; 2]) -> Pairs = _mm256_set1_epi32(i32::from(x[0]) & 0xffff | i32::from(x[1]) << 16);
        add(a: Reals, b: Reals) -> Reals = _mm512_add_pd(a, b);
        sub(a: Reals, b: Reals) -> Reals = _mm512_sub_pd(a, b);
        mul(a: Reals, b: Reals) -> Reals = _mm512_mul_pd(a, b);
        div(a: Reals, b: Reals) -> Reals = _mm512_div_pd(a, b);
        root(a: Reals) -> Reals = _mm512_sqrt_pd(a);
        larger(a: Reals, b: Reals) -> Reals = _mm512_max_pd(a, b);
        lower(a: Reals, b: Reals) -> Reals = _mm512_min_pd(a, b);
        less(a: Reals, b: Reals) -> Mask = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b);
        no_more(a: Reals, b: Reals) -> Mask = _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b);
        same_real(a: Reals, b: Reals) -> Mask = _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b);
        same(a: Whole, b: Whole) -> Mask = _mm512_cmpeq_epi64_mask(a, b);
        and(a: Mask, b: Mask) -> Mask = a & b;
        or(a: Mask, b: Mask) -> Mask = a | b;
        and_not(a: Mask, b: Mask) -> Mask = a & !b;
        bits(a: Mask) -> u64 = u64::from(a);
        choose(is: Mask, a: Reals, b: Reals) -> Reals = _mm512_mask_blend_pd(is, b, a);
        low_halves(a: Whole) -> Whole = _mm512_and_si512(a, whole(0xffff_ffff));
    }

    /// # Safety
    ///
    /// The processor has the features, and there are eight.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    unsafe fn these_pairs(eight: *const [i16; 2]) -> Pairs {
        // SAFETY: as of this function.
        unsafe { _mm256_loadu_si256(eight.cast()) }
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    unsafe fn load(eight: *const f64) -> Reals {
        // SAFETY: as of these_pairs; they are aligned.
        unsafe { _mm512_load_pd(eight) }
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    unsafe fn store(eight: *mut f64, numbers: Reals) {
        // SAFETY: as of these_pairs; they are aligned.
        unsafe { _mm512_store_pd(eight, numbers) }
    }

    /// Of each whole number the high half.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn high_halves(numbers: Whole) -> Pairs {
        _mm512_cvtepi64_epi32(_mm512_srli_epi64::<32>(numbers))
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn differ(a: Pairs, b: Pairs) -> bool {
        _mm256_cmpneq_epi32_mask(a, b) != 0
    }

    /// How often one goes round to see each ball.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn between(rounds: Pairs, own: Pairs, their: Pairs) -> [Reals; 2] {
        let between = _mm256_sub_epi16(_mm256_add_epi16(rounds, own), their);
        [
            _mm512_cvtepi32_pd(_mm256_srai_epi32::<16>(_mm256_slli_epi32::<16>(between))),
            _mm512_cvtepi32_pd(_mm256_srai_epi32::<16>(between)),
        ]
    }

    /// The least of all lanes.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn lowest(numbers: Reals) -> f64 {
        let high = _mm512_extractf64x4_pd::<1>(numbers);
        four::lowest(_mm256_min_pd(_mm512_castpd512_pd256(numbers), high))
    }

    /// The lines of eight balls, number by number, without the seventh: six in `f64` and the last.
    ///
    /// # Safety
    ///
    /// The processor has the features, and there are eight numbers, those of balls.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    unsafe fn columns(balls: *const Ball<f64>, numbers: *const u32) -> ([Reals; 6], Whole) {
        // SAFETY: a ball in f64 is eight numbers of eight bytes, aligned to a line.
        let line = |k: usize| unsafe { _mm512_load_pd(balls.add(*numbers.add(k) as usize).cast()) };
        let [(even_ab, odd_ab), (even_cd, odd_cd)] = [parted(line(0), line(1)), parted(line(2), line(3))];
        let [(even_ef, odd_ef), (even_gh, odd_gh)] = [parted(line(4), line(5)), parted(line(6), line(7))];
        let [start, y, vy, _] = quartered([even_ab, even_cd, even_ef, even_gh]);
        let [x, vx, radius, last] = quartered([odd_ab, odd_cd, odd_ef, odd_gh]);
        ([start, x, y, vx, vy, radius], _mm512_castpd_si512(last))
    }

    /// The even numbers of two lines, in pairs, and the odd ones.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn parted(a: Reals, b: Reals) -> (Reals, Reals) {
        (_mm512_unpacklo_pd(a, b), _mm512_unpackhi_pd(a, b))
    }

    /// Four rows of four pairs as four columns of pairs.
    #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
    #[inline]
    fn quartered([a, b, c, d]: [Reals; 4]) -> [Reals; 4] {
        let (even_ab, odd_ab) = (_mm512_shuffle_f64x2::<0x88>(a, b), _mm512_shuffle_f64x2::<0xdd>(a, b));
        let (even_cd, odd_cd) = (_mm512_shuffle_f64x2::<0x88>(c, d), _mm512_shuffle_f64x2::<0xdd>(c, d));
        [
            _mm512_shuffle_f64x2::<0x88>(even_ab, even_cd),
            _mm512_shuffle_f64x2::<0x88>(odd_ab, odd_cd),
            _mm512_shuffle_f64x2::<0xdd>(even_ab, even_cd),
            _mm512_shuffle_f64x2::<0xdd>(odd_ab, odd_cd),
        ]
    }
}
