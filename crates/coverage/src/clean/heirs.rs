//! The features that get filled gaps.

use super::ownership::{Ownership, Region};
use rustc_hash::FxHashSet;
use twinedge_map::{FeatureId, PlanarMap};

/// The requested features; any neighbour if there are none.
pub(super) struct Heirs {
    asked: FxHashSet<FeatureId>,
    first: Option<FeatureId>,
}

impl Heirs {
    /// Looks up the features by number, ignoring unknown numbers.
    pub(super) fn new(map: &PlanarMap, numbers: &[usize]) -> Self {
        let asked = numbers.iter().filter_map(|number| map.feature(*number));
        let (asked, first) = (asked.clone().collect(), asked.min());
        Self { asked, first }
    }

    pub(super) fn has(&self, feature: FeatureId) -> bool {
        self.asked.contains(&feature)
    }

    pub(super) fn of_gap(&self, ownership: &Ownership<'_>, gap: &Region<'_>) -> Option<FeatureId> {
        ownership.neighbour(gap, |feature| self.asked.is_empty() || self.has(feature)).or(self.first)
    }
}
