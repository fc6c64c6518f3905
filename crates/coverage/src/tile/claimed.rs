//! Areas that features claim together, used to find duplicates (C5).

use super::NIL;
#[cfg(feature = "serde")]
use super::grid::Grid;
use super::grid::Tile;
use rustc_hash::FxHashMap;

/// A feature, as far as its tiles were seen.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Claimed {
    pub(super) feature: u32,
    /// The index in the list of the first feature that covers the same faces, perhaps itself; `None` if no face was seen.
    pub(super) like: Option<u32>,
    /// The first and the last tile that its box meets.
    pub(super) between: [Tile; 2],
    /// The number of tiles that were given the feature with this box.
    pub(super) seen: u64,
}

impl Claimed {
    /// Returns the key: features with the same number but different boxes have separate entries.
    pub(super) const fn key(&self) -> (u32, [Tile; 2]) {
        (self.feature, self.between)
    }

    pub(super) fn of(&self) -> u64 {
        let [first, last] = self.between;
        (u64::from(last.column - first.column) + 1) * (u64::from(last.row - first.row) + 1)
    }

    /// Returns true if the tiles are in the grid, and no more were seen than there are.
    #[cfg(feature = "serde")]
    pub(super) fn is_in(&self, grid: &Grid) -> bool {
        let [first, last] = self.between;
        first.column <= last.column && first.row <= last.row && grid.has(last) && self.seen <= self.of()
    }
}

/// Finds features that are alike. `faces` contains the faces of each. Expected O(faces), counted for each feature.
pub(super) fn compare(claimed: &mut [Claimed], faces: Vec<Vec<u32>>) {
    let mut first = FxHashMap::default();
    for ((place, one), faces) in (0..).zip(claimed).zip(faces) {
        one.like = (!faces.is_empty()).then(|| *first.entry(faces).or_insert(place));
    }
}

/// Adds up the entries of two concatenated lists, for each feature with the same box. Features remain alike if they were alike in
/// both. Entries of completely seen features that are like no other are dropped. This is safe in any order of merging: all tiles
/// of the box had the feature with this box, so an entry with another box that meets one of them is never completely seen, and is
/// reported. Features of the same number whose boxes share no tile are not detected. O(n log n), expected.
pub(super) fn add_up(claimed: &mut Vec<Claimed>) {
    claimed.sort_by_key(Claimed::key);
    // With the feature that it is like in each of the two lists.
    let mut all: Vec<(Claimed, [u32; 2])> = Vec::new();
    for one in claimed.drain(..) {
        let like = one.like.unwrap_or(NIL);
        match all.last_mut().filter(|(first, _)| first.key() == one.key()) {
            Some((first, likes)) => {
                first.seen = first.seen.saturating_add(one.seen);
                *likes = if likes[0] == NIL { [like, NIL] } else { [likes[0], like] };
            }
            None => all.push((one, [like, NIL])),
        }
    }
    let mut counts: FxHashMap<[u32; 2], u32> = FxHashMap::default();
    for (_, likes) in all.iter().filter(|(_, likes)| likes[0] != NIL) {
        *counts.entry(*likes).or_default() += 1;
    }
    all.retain(|(one, likes)| one.seen != one.of() || counts.get(likes).is_some_and(|count| *count > 1));
    let mut first = FxHashMap::default();
    claimed.extend((0..).zip(all).map(|(place, (one, likes))| {
        let like = (likes[0] != NIL).then(|| *first.entry(likes).or_insert(place));
        Claimed { like, ..one }
    }));
}

/// Returns, for each feature, the first feature that covers the same faces.
pub(super) fn first_like(claimed: &[Claimed]) -> FxHashMap<u32, u32> {
    claimed.iter().filter_map(|one| Some((one.feature, claimed[one.like? as usize].feature))).collect()
}
