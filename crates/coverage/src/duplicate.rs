//! C5 duplicate: no two features claim the same faces.

use super::finding::{CoverageRule, Finding};
use super::region::finding;
use rustc_hash::FxHashMap;
use twinedge::dcel::FaceKey;
use twinedge_map::{FeatureId, PlanarMap};

/// Returns, for each feature, the first one that claims the same faces: itself if it is the first or claims none. `faces`
/// contains the faces of each feature, in order of their indices. O(their number), expected.
pub(super) fn first_like<'f>(map: &PlanarMap, faces: &'f [Vec<FaceKey>]) -> Vec<FeatureId> {
    let mut first: FxHashMap<&'f [FaceKey], FeatureId> = FxHashMap::default();
    let mut like = |feature, own: &'f [FaceKey]| match own {
        [] => feature,
        own => *first.entry(own).or_insert(feature),
    };
    map.features().zip(faces).map(|(feature, own)| like(feature, own)).collect()
}

pub(super) fn duplicates(map: &PlanarMap, faces: &[Vec<FaceKey>], first_like: &[FeatureId]) -> Vec<Finding> {
    let mut like: FxHashMap<FeatureId, Vec<FeatureId>> = FxHashMap::default();
    for (feature, first) in map.features().zip(first_like) {
        if feature != *first {
            like.entry(*first).or_insert_with(|| vec![*first]).push(feature);
        }
    }
    let mut sets: Vec<Vec<FeatureId>> = like.into_values().collect();
    sets.sort_unstable();
    let of = |features: Vec<FeatureId>| {
        let own: Vec<_> = faces[features[0].index()].iter().filter_map(|f| map.dcel().face(*f).ok()).collect();
        finding(map, CoverageRule::Duplicate, features, &own)
    };
    sets.into_iter().map(of).collect()
}
