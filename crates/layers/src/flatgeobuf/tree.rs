//! The shape of the index of `FlatGeobuf`.

use super::super::error::Cause;
use ::flatgeobuf::Header as HeaderTable;
use std::ops::Range;

pub(super) const NODE: u64 = 40;

/// The shape of a tree: each node has the number of children stated in the header, and the leaves are features.
pub(super) struct Tree {
    size: u64,
    /// The number of nodes per level, the lowest level first. The highest level comes first in the file.
    levels: Vec<u64>,
}

impl Tree {
    /// Returns `None` if the file has no index.
    pub(super) fn of_header(header: &HeaderTable<'_>) -> Result<Option<Self>, Cause> {
        let (count, size) = (header.features_count(), u64::from(header.index_node_size()));
        if size == 0 || count == 0 {
            return Ok(None);
        }
        if size == 1 {
            return Err(Cause::Invalid("nodes of the index have one entry each".to_owned()));
        }
        // The tree has fewer nodes than three per feature.
        if count.checked_mul(3 * NODE).is_none() {
            return Err(Cause::TooMany { what: "features", count });
        }
        Ok(Some(Self::new(count, size)))
    }

    /// Creates the tree of `count` features, at least one, with `size` children per node, at least two.
    pub(super) fn new(count: u64, size: u64) -> Self {
        let mut levels = vec![count];
        while levels.len() == 1 || levels.last().is_some_and(|level| *level > 1) {
            levels.extend(levels.last().map(|level| level.div_ceil(size)));
        }
        Self { size, levels }
    }

    pub(super) const fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// Returns the number of nodes of the lowest level.
    pub(super) fn count(&self) -> u64 {
        self.levels[0]
    }

    pub(super) fn bytes(&self) -> u64 {
        self.levels.iter().sum::<u64>() * NODE
    }

    /// Returns the index of the first node of a level.
    pub(super) fn start(&self, level: usize) -> u64 {
        self.levels[level + 1..].iter().sum()
    }

    /// Returns the children of a node, by their positions in the level below.
    pub(super) fn below(&self, level: usize, node: u64) -> Range<u64> {
        let first = node * self.size;
        first..(first + self.size).min(self.levels[level - 1])
    }
}
