//! Vertices that borders lack, inserted into the rings.

use super::rebuild::Rings;
use super::report::AddedVertex;
use super::restored::key;
use rustc_hash::FxHashMap;
use twinedge_coverage::{CoverageError, mismatches};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{PlanarMap, UnmatchedVertex};

type Key = (u64, u64);

pub(super) struct Missing {
    /// The vertices missing on a border between two features (C7).
    pub(super) added: Vec<AddedVertex>,
    /// For each feature and segment, by its ends with the smaller one first: all points on it, in order.
    on_segments: FxHashMap<(usize, Key, Key), Vec<Point>>,
}

impl Missing {
    /// Collects them from the unmatched vertices of the input and its map. O(n log n).
    pub(super) fn new(map: &PlanarMap, unmatched: &[UnmatchedVertex]) -> Result<Self, CoverageError> {
        let mut added = Vec::new();
        for finding in mismatches(map, unmatched)? {
            added.extend(finding.missing.iter().map(|missing| {
                let other = finding.features.iter().find(|feature| **feature != missing.feature);
                let [to, of] = [missing.feature, *other.unwrap_or(&missing.feature)].map(|feature| feature.index());
                AddedVertex { at: missing.at, to, of }
            }));
        }
        let mut on_segments: FxHashMap<(usize, Key, Key), Vec<Point>> = FxHashMap::default();
        for one in unmatched {
            let [low, high] = one.segment.map(|end| key(end.x, end.y));
            on_segments.entry((one.lacked_by.index(), low, high)).or_default().push(one.at);
        }
        for points in on_segments.values_mut() {
            points.sort_by(|a, b| compare_lexicographic(*a, *b));
            points.dedup();
        }
        Ok(Self { added, on_segments })
    }

    /// Returns the rings of a feature with all missing points inserted; `None` if none are missing.
    pub(super) fn inserted(&self, feature: usize, polygons: &[Rings]) -> Option<Vec<Rings>> {
        let mut any = false;
        let mut with = |ring: &Vec<Point>| {
            let mut points: Vec<Point> = ring.first().copied().into_iter().collect();
            for pair in ring.windows(2) {
                let is_forth = compare_lexicographic(pair[0], pair[1]).is_lt();
                let (low, high) = if is_forth { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
                if let Some(missing) = self.on_segments.get(&(feature, key(low.x, low.y), key(high.x, high.y))) {
                    any = true;
                    points.extend(missing);
                    if !is_forth {
                        let start = points.len() - missing.len();
                        points[start..].reverse();
                    }
                }
                points.push(pair[1]);
            }
            points
        };
        let all = polygons.iter().map(|rings| rings.iter().map(&mut with).collect()).collect();
        any.then_some(all)
    }
}
