//! Random numbers that mean the same everywhere: SplitMix64 read by its counter.
//!
//! Number n of a stream is a hash of the stream's key and of n alone, so that nothing depends on what was drawn before,
//! on the platform or on a library's version. The key is made of a seed and of the name of what is drawn, so that two
//! things drawn from one seed do not follow each other. The hash is the output function of SplitMix64 (G. Steele, D. Lea,
//! C. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014), whose state is a counter times a constant.

/// The odd constant by which SplitMix64's state grows: 2⁶⁴ over the golden ratio.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Random {
    key: u64,
    counter: u64,
}

impl Random {
    /// The stream of a seed for one purpose, such as "rack.order".
    pub fn new(seed: u64, purpose: &str) -> Self {
        // FNV-1a of the name, 64 bits.
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let name = purpose.bytes().fold(0xcbf2_9ce4_8422_2325, hash);
        Self { key: number(seed, 0) ^ name, counter: 0 }
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        let bits = self.bits_at(self.counter);
        self.counter += 1;
        bits
    }

    /// The 64 random bits of number `counter`, from 0: what [`Random::bits`] gives when it has been called that often.
    pub fn bits_at(&self, counter: u64) -> u64 {
        number(self.key, counter)
    }

    /// A number from 0 up to but not including 1: a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A whole number below `count`, each equally likely; 0 where there is none.
    pub fn below(&mut self, count: usize) -> usize {
        let count = count as u64;
        if count == 0 {
            return 0;
        }
        // The bits beyond the largest multiple of the count would favour small numbers.
        let most = u64::MAX - u64::MAX % count;
        loop {
            let bits = self.bits();
            if bits < most {
                return (bits % count) as usize;
            }
        }
    }

    /// A point of the unit disc, each equally likely.
    pub fn in_disc(&mut self) -> [f64; 2] {
        loop {
            let [x, y] = [self.unit(), self.unit()].map(|number| 2.0 * number - 1.0);
            if x * x + y * y <= 1.0 {
                return [x, y];
            }
        }
    }

    /// Puts a list in an order of which each is equally likely (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

/// Number `counter`, from 0, of SplitMix64 started with `key`.
fn number(key: u64, counter: u64) -> u64 {
    let mut bits = key.wrapping_add(counter.wrapping_add(1).wrapping_mul(GAMMA));
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::{Random, number};

    #[test]
    fn numbers_are_those_of_splitmix64() {
        // The first outputs for the seed 1234567, as Rosetta Code lists them.
        let expected = [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431];
        for (counter, expected) in (0..).zip(expected) {
            assert_eq!(number(1234567, counter), expected);
        }
    }

    #[test]
    fn a_number_read_directly_is_the_one_that_is_drawn_in_turn() {
        let mut random = Random::new(11, "test");
        let direct = random.clone();
        for counter in 0..100 {
            assert_eq!(direct.bits_at(counter), random.bits());
        }
        assert_eq!(random.bits_at(3), direct.bits_at(3), "numbers count from the start, whatever was drawn");
    }

    #[test]
    fn purposes_and_seeds_give_streams_of_their_own() {
        let first = |seed, purpose| Random::new(seed, purpose).bits();
        assert_eq!(first(7, "a"), first(7, "a"));
        assert_ne!(first(7, "a"), first(7, "b"));
        assert_ne!(first(7, "a"), first(8, "a"));
    }

    #[test]
    fn all_small_numbers_come_up_equally_often() {
        let mut random = Random::new(1, "test");
        let mut counts = [0u32; 6];
        (0..6000).for_each(|_| counts[random.below(6)] += 1);
        // 1000 each, with a standard deviation of 29: six of them.
        assert!(counts.iter().all(|count| (826..1174).contains(count)), "{counts:?}");
        assert_eq!(random.below(0), 0);
        assert!((0..100).all(|_| (0.0..1.0).contains(&random.unit())));
        assert!((0..100).map(|_| random.in_disc()).all(|[x, y]| x * x + y * y <= 1.0));
    }

    #[test]
    fn a_shuffle_keeps_what_it_shuffles() {
        let mut items: Vec<u32> = (0..20).collect();
        Random::new(3, "test").shuffle(&mut items);
        assert_ne!(items, (0..20).collect::<Vec<_>>());
        items.sort_unstable();
        assert_eq!(items, (0..20).collect::<Vec<_>>());
    }
}
