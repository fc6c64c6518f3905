//! Dividing a block into parts of whole pixels.

use crate::noding::pixel::{Block, Pixel};

/// A block is cut into at most 2^TILES tiles along each axis; into fewer in tests of this crate, which have small blocks.
const TILES: u32 = if cfg!(test) { 1 } else { 6 };

/// The intended number of segments per tile, if the number of tiles permits.
const FULL: usize = 2;

fn longer(block: &Block) -> usize {
    usize::from(block.high[1] - block.low[1] > block.high[0] - block.low[0])
}

/// Halves a block across its longer side. Returns the halves and the axis.
pub(super) fn halves(block: &Block) -> ([Block; 2], usize) {
    let axis = longer(block);
    let mut halves = [*block; 2];
    let middle = block.low[axis] + (block.high[axis] - block.low[axis]) / 2;
    halves[0].high[axis] = middle;
    halves[1].low[axis] = middle + 1;
    (halves, axis)
}

/// A block, cut into tiles whose sides are powers of two, except at the upper and the right border.
pub(super) struct Tiles {
    block: Block,
    sides: [u32; 2],
    /// The logarithm of the number of tiles along each axis.
    count: u32,
}

impl Tiles {
    pub(super) fn new(block: &Block, segments: usize) -> Self {
        let count = (segments / FULL).checked_ilog2().map_or(1, |tiles| (tiles / 2).clamp(1, TILES));
        let side = |axis: usize| {
            let last = (block.high[axis] - block.low[axis]).unsigned_abs();
            (64 - last.leading_zeros()).saturating_sub(count)
        };
        Self { block: *block, sides: [side(0), side(1)], count }
    }

    fn tile(&self, pixel: Pixel, axis: usize) -> usize {
        let within = pixel[axis].clamp(self.block.low[axis], self.block.high[axis]) - self.block.low[axis];
        (within >> self.sides[axis]).unsigned_abs() as usize
    }

    pub(super) fn len(&self) -> usize {
        1 << (2 * self.count)
    }

    /// Returns a tile by its number, counted row by row.
    pub(super) fn block(&self, tile: usize) -> Block {
        let Block { low, high } = self.block;
        let at = [tile & ((1 << self.count) - 1), tile >> self.count].map(usize::cast_signed).map(|place| place as i64);
        Block {
            low: [0, 1].map(|axis| low[axis] + (at[axis] << self.sides[axis])),
            high: [0, 1].map(|axis| high[axis].min(low[axis] + ((at[axis] + 1) << self.sides[axis]) - 1)),
        }
    }

    pub(super) fn at(&self, pixel: Pixel) -> usize {
        self.tile(pixel, 1) << self.count | self.tile(pixel, 0)
    }

    /// Returns the tiles that overlap another block, which must overlap this one.
    pub(super) fn of(&self, other: &Block) -> TileRange {
        let [columns, rows] = [0, 1].map(|axis| [self.tile(other.low, axis), self.tile(other.high, axis)]);
        TileRange { columns, rows, count: self.count }
    }
}

/// A range of columns and rows of tiles, by the first and the last.
pub(super) struct TileRange {
    columns: [usize; 2],
    rows: [usize; 2],
    count: u32,
}

impl TileRange {
    pub(super) fn len(&self) -> usize {
        (self.columns[1] + 1 - self.columns[0]) * (self.rows[1] + 1 - self.rows[0])
    }

    pub(super) fn only(&self) -> Option<usize> {
        (self.columns[0] == self.columns[1] && self.rows[0] == self.rows[1])
            .then_some(self.rows[0] << self.count | self.columns[0])
    }

    pub(super) fn tiles(&self) -> impl Iterator<Item = usize> {
        let Self { columns, rows, count } = *self;
        (rows[0]..=rows[1]).flat_map(move |row| (columns[0]..=columns[1]).map(move |column| row << count | column))
    }
}

/// Returns a block without one of its pixels, in up to four parts.
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
    // A pixel on the border leaves nothing on one side.
    parts.retain(|part| part.low[0] <= part.high[0] && part.low[1] <= part.high[1]);
    parts
}
