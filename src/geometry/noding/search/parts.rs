//! Ways to cut a block in parts, each of whole pixels.

use crate::geometry::noding::pixel::{Block, Pixel};

/// A block is cut in at most 2^TILES tiles along each axis; in fewer in tests of this crate, which have small blocks.
const TILES: usize = if cfg!(test) { 1 } else { 3 };

/// The axis along which a block of more than one pixel is longer.
fn longer(block: &Block) -> usize {
    usize::from(block.high[1] - block.low[1] > block.high[0] - block.low[0])
}

/// A block, parted across its longer side.
pub(super) fn halves(block: &Block) -> [Block; 2] {
    let axis = longer(block);
    let mut halves = [*block; 2];
    let middle = block.low[axis] + (block.high[axis] - block.low[axis]) / 2;
    halves[0].high[axis] = middle;
    halves[1].low[axis] = middle + 1;
    halves
}

/// A block, cut into tiles whose sides are powers of two, those at the upper and the right border excepted.
pub(super) struct Tiles {
    block: Block,
    /// The logarithms of the sides.
    sides: [u32; 2],
}

impl Tiles {
    pub(super) fn new(block: &Block) -> Self {
        let side = |axis: usize| {
            let last = (block.high[axis] - block.low[axis]).unsigned_abs();
            (64 - last.leading_zeros()).saturating_sub(TILES as u32)
        };
        Self { block: *block, sides: [side(0), side(1)] }
    }

    fn tile(&self, pixel: Pixel, axis: usize) -> usize {
        let within = pixel[axis].clamp(self.block.low[axis], self.block.high[axis]) - self.block.low[axis];
        (within >> self.sides[axis]).unsigned_abs() as usize
    }

    /// Row by row.
    pub(super) fn blocks(&self) -> Vec<Block> {
        let Block { low, high } = self.block;
        let all = (0..1 << TILES).flat_map(|row| (0..1 << TILES).map(move |column| [column, row]));
        let block = |at: [i64; 2]| Block {
            low: [0, 1].map(|axis| low[axis] + (at[axis] << self.sides[axis])),
            high: [0, 1].map(|axis| high[axis].min(low[axis] + ((at[axis] + 1) << self.sides[axis]) - 1)),
        };
        all.map(block).collect()
    }

    /// The tiles that overlap another block, which overlaps this one.
    pub(super) fn of(&self, other: &Block) -> impl Iterator<Item = usize> + Clone {
        let [columns, rows] = [0, 1].map(|axis| self.tile(other.low, axis)..self.tile(other.high, axis) + 1);
        rows.flat_map(move |row| columns.clone().map(move |column| row << TILES | column))
    }
}

/// A block without a pixel of it, in up to four parts.
pub(super) fn around(block: &Block, pixel: Pixel) -> Vec<Block> {
    let axis = longer(block);
    let mut parts = vec![*block; 4];
    parts[0].high[axis] = pixel[axis] - 1;
    parts[1].low[axis] = pixel[axis] + 1;
    for part in &mut parts[2..] {
        part.low[axis] = pixel[axis];
        part.high[axis] = pixel[axis];
    }
    parts[2].high[1 - axis] = pixel[1 - axis] - 1;
    parts[3].low[1 - axis] = pixel[1 - axis] + 1;
    // A pixel on the border leaves nothing on the other side.
    parts.retain(|part| part.low[0] <= part.high[0] && part.low[1] <= part.high[1]);
    parts
}
