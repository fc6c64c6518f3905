//! Areas that features claim together, by which duplicates are found (C5).

#[cfg(feature = "serde")]
use super::grid::Grid;
use super::grid::Tile;
use rustc_hash::FxHashMap;

/// A feature, as far as its tiles were seen.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Claimed {
    pub(super) feature: u32,
    /// The features that cover every face that it covers, itself included; none if no face was seen.
    pub(super) with: Option<Vec<u32>>,
    /// The first and the last tile that the box around it meets.
    pub(super) between: [Tile; 2],
    /// The number of tiles that were given the feature with this box.
    pub(super) seen: u64,
}

impl Claimed {
    /// Tiles that were given something else by the same number have an entry of their own.
    pub(super) const fn key(&self) -> (u32, [Tile; 2]) {
        (self.feature, self.between)
    }

    /// The number of tiles that the box meets.
    pub(super) fn of(&self) -> u64 {
        let [first, last] = self.between;
        (u64::from(last.column - first.column) + 1) * (u64::from(last.row - first.row) + 1)
    }

    /// Returns true if the grid has its tiles, and not fewer than were seen.
    #[cfg(feature = "serde")]
    pub(super) fn is_in(&self, grid: &Grid) -> bool {
        let [first, last] = self.between;
        first.column <= last.column && first.row <= last.row && grid.has(last) && self.seen <= self.of()
    }

    /// Takes the features of one more face that it covers.
    pub(super) fn meet(&mut self, features: &[u32]) {
        match &mut self.with {
            None => self.with = Some(features.to_vec()),
            Some(with) => with.retain(|feature| features.binary_search(feature).is_ok()),
        }
    }
}

/// Adds up the entries of each feature with the same box. Those that were seen to the end and are like no other are dropped: as all tiles
/// of the box were given the feature so, one of another box that meets any of them is never seen to the end, and so it is found in any
/// order of merging. Features of the same number whose boxes have no tile in common are not told apart from different ones: that would
/// take an entry for each feature. O(n log n).
pub(super) fn add_up(claimed: &mut Vec<Claimed>) {
    claimed.sort_by_key(Claimed::key);
    claimed.dedup_by(|one, first| {
        let is_same = one.key() == first.key();
        if is_same {
            first.seen = first.seen.saturating_add(one.seen);
            if let Some(with) = &one.with {
                first.meet(with);
            }
        }
        is_same
    });
    claimed.retain(|one| one.seen != one.of() || one.with.as_ref().is_some_and(|with| with.len() > 1));
}

/// For each feature that claims the same faces as another, the first of those that do.
pub(super) fn first_like(claimed: &[Claimed]) -> FxHashMap<u32, u32> {
    let with = |feature: u32| {
        let place = claimed.binary_search_by_key(&feature, |one| one.feature).ok()?;
        claimed[place].with.as_deref()
    };
    let mut first = FxHashMap::default();
    for one in claimed {
        let mut like = one
            .with
            .iter()
            .flatten()
            .filter(|other| with(**other).is_some_and(|theirs| theirs.binary_search(&one.feature).is_ok()));
        let least = like.next().copied();
        let is_alone = least == Some(one.feature) && like.next().is_none();
        first.extend(least.filter(|_| !is_alone).map(|least| (one.feature, least)));
    }
    first
}
