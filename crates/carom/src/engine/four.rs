//! Up to four balls of a cell, and how many they are, in sixteen bytes: who asks for the one need not fetch the other.

/// The bits of a number that is one of a ball.
const BITS: u32 = 29;

/// Balls whose numbers fit beside that of free places.
pub const MOST_BALLS: usize = 1 << BITS;

/// The numbers of up to four balls. The last place, where it is free, says how many are: so all are clean where none is.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct Four([u32; 4]);

impl Four {
    /// None.
    pub const NOBODY: Self = Self([0, 0, 0, 4 << BITS]);

    /// How many they are.
    #[inline(always)]
    pub fn count(&self) -> usize {
        4 - (self.0[3] >> BITS) as usize
    }

    /// The balls.
    #[inline(always)]
    pub fn numbers(&self) -> &[u32] {
        &self.0[..self.count()]
    }

    /// The ball in one of the four places, or that was there before, or whatever number.
    #[inline(always)]
    pub fn guess(&self, place: usize) -> u32 {
        self.0[place]
    }

    /// Takes a ball; `false` if there is no room.
    #[inline(always)]
    pub fn push(&mut self, number: u32) -> bool {
        let count = self.count();
        if count == 4 {
            return false;
        }
        self.0[3] = self.0[3].wrapping_sub(1 << BITS);
        self.0[count] = number;
        true
    }

    /// Gives back the last ball.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<u32> {
        let count = self.count();
        let last = *self.0[..count].last()?;
        self.0[3] = (5 - count as u32) << BITS;
        Some(last)
    }

    /// Puts another ball where one was; `false` if that one was not there.
    #[inline(always)]
    pub fn replace(&mut self, number: u32, other: u32) -> bool {
        let place = self.numbers().iter().position(|&there| there == number);
        if let Some(place) = place {
            self.0[place] = other;
        }
        place.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::{Four, MOST_BALLS};

    #[test]
    fn four_come_and_go() {
        let mut four = Four::NOBODY;
        let numbers = [0, 7, MOST_BALLS as u32 - 1, 3];
        for (count, number) in numbers.into_iter().enumerate() {
            assert_eq!(four.numbers(), &numbers[..count]);
            assert!(four.push(number));
        }
        assert!(!four.push(9));
        assert_eq!((four.count(), four.numbers()), (4, &numbers[..]));
        assert!(four.replace(7, 8));
        assert!(!four.replace(7, 8));
        assert_eq!(
            core::array::from_fn(|_| four.pop()),
            [Some(3), Some(MOST_BALLS as u32 - 1), Some(8), Some(0), None]
        );
    }
}
