//! Bins of items, in blocks of memory that all of them share: what one bin gives back another soon takes, while it is still
//! in fast memory.

use crate::memory::room_for;

/// Items in a block: with `f64` times it fills four lines of the cache.
const PER_BLOCK: usize = 15;

/// No block.
const NONE: u32 = u32::MAX;

/// The last block of a bin, and how many items are in it; those before are full.
#[derive(Clone, Copy, Debug)]
struct End {
    block: u32,
    filled: u32,
}

/// Some items of a bin, and the block before.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Block<T> {
    items: [T; PER_BLOCK],
    before: u32,
}

/// Bins of items.
#[derive(Clone, Debug)]
pub struct Bins<T> {
    ends: Vec<End>,
    blocks: Vec<Block<T>>,
    /// The first of the blocks that are free, each of which has the next one before it.
    free: u32,
}

impl End {
    const NOTHING: Self = Self { block: NONE, filled: PER_BLOCK as u32 };
}

impl<T: Copy> Bins<T> {
    /// No bins, with room for so many items.
    pub fn new(items: usize) -> Self {
        Self { ends: Vec::new(), blocks: room_for(items.div_ceil(PER_BLOCK)), free: NONE }
    }

    /// The number of bins.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// So many bins, all of them empty.
    pub fn lay_out(&mut self, count: usize) {
        self.ends.clear();
        self.ends.resize(count, End::NOTHING);
        self.blocks.clear();
        self.free = NONE;
    }

    /// Puts an item into a bin.
    #[inline(always)]
    pub fn push(&mut self, bin: usize, item: T) {
        let End { block, filled } = self.ends[bin];
        if filled as usize == PER_BLOCK {
            self.begin_block(bin, item);
        } else {
            self.blocks[block as usize].items[filled as usize] = item;
            self.ends[bin].filled = filled + 1;
        }
    }

    /// Begins another block of a bin with an item.
    #[inline(never)]
    fn begin_block(&mut self, bin: usize, item: T) {
        let before = self.ends[bin].block;
        let block = self.free;
        if block == NONE {
            self.ends[bin].block = self.blocks.len() as u32;
            if self.blocks.len() == self.blocks.capacity() {
                // By a quarter: twice what a great many balls need would be the most of their memory.
                self.blocks.reserve_exact(self.blocks.len() / 4 + 8);
            }
            self.blocks.push(Block { items: [item; PER_BLOCK], before });
        } else {
            let there = &mut self.blocks[block as usize];
            self.free = there.before;
            (there.items[0], there.before) = (item, before);
            self.ends[bin].block = block;
        }
        self.ends[bin].filled = 1;
    }

    /// Moves the items of a bin to the end of a list.
    pub fn take(&mut self, bin: usize, list: &mut Vec<T>) {
        let End { mut block, filled } = core::mem::replace(&mut self.ends[bin], End::NOTHING);
        let mut filled = filled as usize;
        while block != NONE {
            let there = &mut self.blocks[block as usize];
            list.extend_from_slice(&there.items[..filled]);
            let before = core::mem::replace(&mut there.before, self.free);
            self.free = block;
            (block, filled) = (before, PER_BLOCK);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Bins;

    #[test]
    fn what_is_put_into_a_bin_is_taken_out_of_it_once() {
        let mut bins = Bins::new(3);
        bins.lay_out(4);
        let (mut put, mut all) = (vec![Vec::new(); 4], 0_u32);
        for round in 0..50 {
            for step in 0..7 * round {
                let bin = (step * step + round) % 4;
                bins.push(bin, all);
                put[bin].push(all);
                all += 1;
            }
            let mut taken = Vec::new();
            bins.take(round % 4, &mut taken);
            taken.sort_unstable();
            assert_eq!(taken, put[round % 4]);
            put[round % 4].clear();
        }
        assert!(bins.blocks.len() < 600, "{} blocks for at most some 7000 items", bins.blocks.len());
    }
}
