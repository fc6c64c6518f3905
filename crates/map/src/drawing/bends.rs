//! The bends of all edges as one column, each edge once.

use super::reserved::reserved;
use crate::Embedding;
use crate::numbers::NIL;
use core::ops::Range;
use twinedge::validate::Unchecked;
use twinedge_geometry::Point;

/// The bends of the edges, in the direction of the half-edge with the smaller index.
#[derive(Default)]
pub(crate) struct Bends {
    /// For each half-edge, the index of its first bend, followed by the total number of bends. Empty if no edge has bends.
    first: Vec<u32>,
    pub(crate) points: Vec<Point>,
}

impl Bends {
    /// Reads the bends of these half-edges, given in order, from the embedding. At most `most` bends are read.
    pub(super) fn read<E: Embedding + ?Sized>(
        embedding: &E,
        slots: usize,
        half_edges: impl Iterator<Item = usize>,
        most: usize,
    ) -> Result<Self, Unchecked> {
        let mut bends = Self::default();
        for h in half_edges {
            let count = embedding.bends(h);
            if count == 0 {
                continue;
            }
            if count > most - bends.points.len() {
                return Err(Unchecked::TooLarge);
            }
            if bends.first.is_empty() {
                bends.first = reserved(slots + 1).ok_or(Unchecked::OutOfMemory)?;
            }
            bends.points.try_reserve(count).map_err(|_| Unchecked::OutOfMemory)?;
            bends.first.resize(h + 1, bends.points.len() as u32);
            bends.points.extend((0..count).map(|i| embedding.bend(h, i)));
        }
        if !bends.first.is_empty() {
            bends.first.resize(slots + 1, bends.points.len() as u32);
        }
        Ok(bends)
    }

    /// Returns the index range of the bends of an edge, given its half-edge with the smaller index.
    pub(crate) fn range(&self, h: usize) -> Range<usize> {
        match self.first.get(h..=h + 1) {
            Some(&[from, to]) => from as usize..to as usize,
            _ => 0..0,
        }
    }

    /// Returns the half-edge with the bend at this index, and the number of the bend on it.
    pub(crate) fn owner(&self, place: usize) -> (usize, usize) {
        let h = self.first.partition_point(|first| *first as usize <= place) - 1;
        (h, place - self.range(h).start)
    }
}

/// Returns the half-edge of an edge that represents it in calls for bends.
pub(super) fn asked(h: usize, twin: u32) -> usize {
    // `NIL` is larger than any half-edge.
    debug_assert!(h < NIL as usize);
    h.min(twin as usize)
}
