//! Areas that features claim together, by which duplicates are found (C5).

use rustc_hash::FxHashMap;

/// A feature, as far as its tiles were seen.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Claimed {
    pub(super) feature: u32,
    /// The features that cover every face that it covers, itself included; none if no face was seen.
    pub(super) with: Option<Vec<u32>>,
    /// The number of tiles that were given the feature, and of those that the box around it meets.
    pub(super) seen: u64,
    pub(super) of: u64,
}

impl Claimed {
    /// Takes the features of one more face that it covers.
    pub(super) fn meet(&mut self, features: &[u32]) {
        match &mut self.with {
            None => self.with = Some(features.to_vec()),
            Some(with) => with.retain(|feature| features.binary_search(feature).is_ok()),
        }
    }
}

/// Adds up the entries of each feature. Those that were seen to the end and are like no other are dropped.
pub(super) fn add_up(claimed: &mut Vec<Claimed>) {
    claimed.sort_by_key(|one| one.feature);
    claimed.dedup_by(|one, first| {
        let is_same = one.feature == first.feature;
        if is_same {
            first.seen = first.seen.saturating_add(one.seen);
            if let Some(with) = &one.with {
                first.meet(with);
            }
        }
        is_same
    });
    claimed.retain(|one| one.seen != one.of || one.with.as_ref().is_some_and(|with| with.len() > 1));
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
