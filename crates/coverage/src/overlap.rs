//! C1 overlap: no face is claimed by two features.
//!
//! Connected faces claimed by the same features are one overlap. Features that claim the same faces count as one here, but all
//! are named: they are duplicates (C5).

use super::finding::{CoverageRule, Finding};
use super::region::{connected, finding};
use rustc_hash::FxHashMap;
use twinedge::dcel::Face;
use twinedge_algorithm::claims::features_of;
use twinedge_map::{FeatureId, PlanarMap};

/// Returns the overlaps. `first_like` has, for each feature, the first one that claims the same faces. Expected O(n + o log o)
/// for o half-edges of overlaps.
pub(super) fn overlaps(map: &PlanarMap, first_like: &[FeatureId]) -> Vec<Finding> {
    let mut claims: FxHashMap<usize, Vec<FeatureId>> = FxHashMap::default();
    let mut claimed = Vec::new();
    for face in map.dcel().faces() {
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
