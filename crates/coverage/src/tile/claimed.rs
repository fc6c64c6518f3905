//! Areas that features claim together, used to find duplicates (C5).

use super::NIL;
use super::grid::Tile;
use rustc_hash::FxHashMap;

/// A feature, as far as its tiles were seen.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Claimed {
    pub(super) feature: u32,
    /// The index in the list of the first feature that covers the same faces, perhaps itself; `None` if no face was seen.
    pub(super) like: Option<u32>,
    /// The first tile that needs a piece of it, and the number of these tiles.
    pub(super) first: Tile,
    pub(super) of: u32,
    /// The number of tiles that were given one.
    pub(super) seen: u32,
}

impl Claimed {
    /// Returns the key: features with the same number whose pieces are for other tiles have separate entries.
    pub(super) const fn key(&self) -> (u32, Tile, u32) {
        (self.feature, self.first, self.of)
    }
}

/// Finds features that are alike. `faces` contains the faces of each. Expected O(faces), counted for each feature.
pub(super) fn compare(claimed: &mut [Claimed], faces: Vec<Vec<u32>>) {
    let mut first = FxHashMap::default();
    for ((place, one), faces) in (0..).zip(claimed).zip(faces) {
        one.like = (!faces.is_empty()).then(|| *first.entry(faces).or_insert(place));
    }
}

/// Adds up the entries of two concatenated lists, for each feature. Features remain alike if they were alike in both. Entries of
/// completely seen features that are like no other are dropped. This is safe in any order of merging: two features of the same
/// number that are both needed in the first tile of one are refused there, and others have separate entries. Features of the
/// same number that have no tile in common are not detected. O(n log n), expected.
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
    all.retain(|(one, likes)| one.seen != one.of || counts.get(likes).is_some_and(|count| *count > 1));
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
