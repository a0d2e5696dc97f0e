//! A permutation of which one place can be computed without the others.

use crate::random::Random;

/// Rounds of the network: four make it as good as random for many numbers (M. Luby, C. Rackoff, SIAM J. Comput. 17
/// (1988) 373), and twice as many for some dozens.
const ROUNDS: u64 = 8;

/// Halves of a bit or two hide little from each other: it takes so many rounds until every order is equally likely.
const ROUNDS_OF_FEW: u64 = 32;

/// Up to so many bits the numbers are few.
const FEW_BITS: u32 = 4;

/// An order of the whole numbers below some count: a Feistel network keyed by a stream.
///
/// A number's bits are cut in two halves. Each round changes one half by random bits that depend on the other one, which
/// can be undone, so that no two numbers become the same. Results that are not below the count go through the network
/// again, until one is (J. Black, P. Rogaway, *Ciphers with arbitrary finite domains*, CT-RSA 2002); less than twice
/// on average, as a half may have a bit more than the other.
#[derive(Clone, Debug)]
pub(super) struct Permutation {
    random: Random,
    count: u64,
    low_bits: u32,
    high_bits: u32,
    rounds: u64,
}

impl Permutation {
    /// The permutation of the numbers below `count`, which is from 1 to 2⁵², by the numbers of a stream.
    pub(super) fn new(random: Random, count: u64) -> Self {
        let bits = u64::BITS - count.saturating_sub(1).leading_zeros();
        let high_bits = bits / 2;
        let rounds = if bits <= FEW_BITS { ROUNDS_OF_FEW } else { ROUNDS };
        Self { random, count, low_bits: bits - high_bits, high_bits, rounds }
    }

    /// Where an index below the count is put. Any other might be walked about for ever.
    pub(super) fn at(&self, index: u64) -> u64 {
        debug_assert!(index < self.count);
        let mut index = self.network(index);
        while index >= self.count {
            index = self.network(index);
        }
        index
    }

    fn network(&self, index: u64) -> u64 {
        let mut low = index & mask(self.low_bits);
        let mut high = index >> self.low_bits;
        for round in (0..self.rounds).step_by(2) {
            high ^= self.bits(round, low) & mask(self.high_bits);
            low ^= self.bits(round + 1, high) & mask(self.low_bits);
        }
        (high << self.low_bits) | low
    }

    /// A number of the stream for each round and each value of a half, which has 26 bits at most.
    fn bits(&self, round: u64, half: u64) -> u64 {
        self.random.bits_at((round << 32) | half)
    }
}

fn mask(bits: u32) -> u64 {
    (1 << bits) - 1
}
