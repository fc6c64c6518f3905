//! A grid over the drawing, so that a search need not begin at the beginning.

use super::graph::{Graph, Stage};
use crate::geometry::Point;
use alloc::vec;
use alloc::vec::Vec;

/// How many questions one cell may take while the grid is built, and all of them on average. An empty cell of a real map
/// takes a few hundred if its quarter of the world is not empty.
const PATIENCE: [usize; 2] = [4096, 128];

/// A grid of as many columns as rows, with a cell or so for each segment. Each cell knows a stage of the search graph that
/// all points in the cell come through: often already a face, else a few questions before the end. The grid only saves
/// time; what it leaves out has the same answers in each of its cells.
pub(super) struct Cells {
    columns: Axis,
    rows: Axis,
    /// Row by row.
    stages: Vec<Stage>,
}

/// How a range of numbers is cut in pieces.
struct Axis {
    first: f64,
    last: f64,
    /// Pieces per unit of length; 0 if the range is a single number.
    scale: f64,
    pieces: usize,
}

impl Axis {
    fn new(first: f64, last: f64, pieces: usize) -> Self {
        let scale = if first < last { pieces as f64 / (last - first) } else { 0.0 };
        Self { first, last, scale, pieces }
    }

    /// The piece of a number of the range. It never falls as the number grows, since rounding preserves order.
    #[inline]
    fn piece(&self, c: f64) -> usize {
        #[expect(clippy::cast_sign_loss, reason = "numbers of the range are at least the first")]
        let piece = ((c - self.first) * self.scale) as usize;
        piece.min(self.pieces - 1)
    }

    /// For each piece, the smallest and the largest number that could be in it.
    fn bounds(&self) -> Vec<[f64; 2]> {
        let mut bounds = vec![[self.first, self.last]; self.pieces];
        for i in 1..self.pieces {
            // Between two numbers, of which one is in a piece before this, the other is not.
            let (mut before, mut after) = (self.first, self.last);
            if self.piece(after) < i {
                continue;
            }
            for _ in 0..64 {
                let middle = f64::midpoint(before, after);
                *(if self.piece(middle) < i { &mut before } else { &mut after }) = middle;
            }
            bounds[i - 1][1] = after;
            bounds[i][0] = before;
        }
        bounds
    }
}

impl Cells {
    /// Makes the grid for the drawing within this box. O(n).
    pub(super) fn new(graph: &Graph, [min, max]: [Point; 2], segments: usize) -> Self {
        // From one cell to four to sixteen: what a cell comes through, its quarters come through.
        let levels = segments.max(1).ilog2().div_ceil(2);
        let side = 1 << levels;
        let (columns, rows) = (Axis::new(min.x, max.x, side), Axis::new(min.y, max.y, side));
        let (across, up) = (columns.bounds(), rows.bounds());
        let mut patience = PATIENCE[1] * side * side;
        let mut stages = vec![graph.root()];
        let mut open = Vec::new();
        for level in 0..=levels {
            let (side, cell) = (1_usize << level, 1_usize << (levels - level));
            let coarser = stages;
            stages = Vec::with_capacity(side * side);
            for row in 0..side {
                for column in 0..side {
                    let (left, low) = (column * cell, row * cell);
                    let min = Point::new(across[left][0], up[low][0]);
                    let max = Point::new(across[left + cell - 1][1], up[low + cell - 1][1]);
                    let from = coarser[(row / 2) * side.div_ceil(2) + column / 2];
                    let most = patience.min(PATIENCE[0]);
                    let mut left = most;
                    stages.push(graph.settle(from, [min, max], &mut left, &mut open));
                    patience -= most - left;
                }
            }
        }

        Self { columns, rows, stages }
    }

    /// Where to begin the search for a point; nothing, if it lies outside.
    #[inline]
    pub(super) fn stage(&self, p: Point) -> Option<Stage> {
        let inside = (self.columns.first..=self.columns.last).contains(&p.x)
            && (self.rows.first..=self.rows.last).contains(&p.y);
        inside.then(|| self.stages[self.rows.piece(p.y) * self.columns.pieces + self.columns.piece(p.x)])
    }
}
