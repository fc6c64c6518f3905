//! C1 overlap: no face is claimed by two features. C5 duplicate: no two features claim the same faces.
//!
//! Connected faces claimed by the same features are one overlap. Features that claim the same faces count as one here, but all
//! are named: they are duplicates (C5).

use super::finding::{CoverageRule, Finding};
use super::region::{connected, finding};
use rustc_hash::FxHashMap;
use twinedge::dcel::{Face, FaceKey};
use twinedge_algorithm::claims::features_of;
use twinedge_map::{FeatureId, PlanarMap};

/// Returns the overlaps. `first_like` has, for each feature, the first one that claims the same faces. Expected O(n + o log o)
/// for o half-edges of overlaps.
pub(super) fn overlaps(map: &PlanarMap, first_like: &[FeatureId]) -> Vec<Finding> {
    let mut claims: FxHashMap<usize, Vec<FeatureId>> = FxHashMap::default();
    let mut claimed = Vec::new();
    for face in map.dcel().faces().filter(|face| features_of(map, *face).nth(1).is_some()) {
        let mut of: Vec<FeatureId> = features_of(map, face).map(|f| first_like[f.index()]).collect();
        of.dedup();
        of.sort_unstable();
        of.dedup();
        if of.len() > 1 {
            claims.insert(face.index(), of);
            claimed.push(face);
        }
    }
    let regions = connected(claimed, |face: Face<'_>| claims.get(&face.index()));
    // Includes duplicates of the first features: they claim the same faces.
    let features = |region: &[Face<'_>]| features_of(map, region[0]).collect();
    regions.iter().map(|region| finding(map, CoverageRule::Overlap, features(region), region)).collect()
}

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
