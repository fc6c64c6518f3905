//! The owner of each face while faces change hands, and the regions of faces with one owner.

use crate::region::{border, connected, length};
use std::collections::BTreeMap;
use twinedge::dcel::Face;
use twinedge_algorithm::area::{Sum, face_area};
use twinedge_geometry::Point;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// The feature that owns each face, by index of face.
pub(super) struct Ownership<'m> {
    pub(super) map: &'m PlanarMap,
    owners: Vec<Option<FeatureId>>,
    areas: Vec<f64>,
    window: Option<[Point; 2]>,
}

/// A connected set of faces owned by one feature, or by none.
pub(super) struct Region<'m> {
    pub(super) owner: Option<FeatureId>,
    pub(super) faces: Vec<Face<'m>>,
    pub(super) area: f64,
    pub(super) length: f64,
    /// True if it includes the unbounded face or reaches out of the window.
    pub(super) is_outside: bool,
}

impl Region<'_> {
    pub(super) fn is_gap(&self) -> bool {
        self.owner.is_none() && !self.is_outside
    }
}

impl<'m> Ownership<'m> {
    /// Starts without any owners. O(half-edges).
    pub(super) fn new(map: &'m PlanarMap, window: Option<[Point; 2]>) -> Self {
        let faces = map.dcel().faces().map(|face| face.index() + 1).max().unwrap_or_default();
        let mut areas = vec![0.0; faces];
        for face in map.dcel().faces().filter(|face| !face.is_unbounded()) {
            areas[face.index()] = face_area(map, face.key()).unwrap_or_default();
        }
        Self { map, owners: vec![None; faces], areas, window }
    }

    pub(super) fn owner(&self, face: Face<'_>) -> Option<FeatureId> {
        self.owners[face.index()]
    }

    pub(super) fn give(&mut self, faces: &[Face<'_>], to: Option<FeatureId>) {
        for face in faces {
            self.owners[face.index()] = to;
        }
    }

    pub(super) fn area(&self, faces: &[Face<'_>]) -> f64 {
        let sum: Sum = faces.iter().map(|face| self.areas[face.index()]).collect();
        sum.value()
    }

    /// Returns all regions, in order of their first face. O(half-edges), expected.
    pub(super) fn regions(&self) -> Vec<Region<'m>> {
        let all = connected(self.map.dcel().faces(), |face| Some(self.owner(face)));
        all.into_iter().map(|faces| self.region(faces)).collect()
    }

    /// Makes the region of a connected set of faces of one owner.
    pub(super) fn region(&self, faces: Vec<Face<'m>>) -> Region<'m> {
        let border = border(&faces);
        let around: Sum = border.iter().map(|h| length(self.map, *h)).collect();
        let is_out = |[low, high]: [Point; 2]| {
            let mut points = border.iter().map(|h| self.map.point(h.origin().index()));
            points.any(|p| p.x < low.x || p.y < low.y || high.x < p.x || high.y < p.y)
        };
        Region {
            owner: faces.first().and_then(|face| self.owner(*face)),
            area: self.area(&faces),
            length: around.value(),
            is_outside: faces.iter().any(|face| face.is_unbounded()) || self.window.is_some_and(is_out),
            faces,
        }
    }

    /// Returns the accepted neighbour with the longest common border, or the first, if any. O(half-edges of the region · log).
    pub(super) fn neighbour(&self, region: &Region<'m>, is_asked: impl Fn(FeatureId) -> bool) -> Option<FeatureId> {
        let mut common: BTreeMap<FeatureId, Sum> = BTreeMap::new();
        for h in border(&region.faces) {
            let is_other = |other: &FeatureId| Some(*other) != region.owner && is_asked(*other);
            if let Some(other) = self.owner(h.twin().face()).filter(is_other) {
                common.entry(other).or_default().add(length(self.map, h));
            }
        }
        let longest = common.into_iter().map(|(feature, sum)| (feature, sum.value()));
        // The first of several equally long ones.
        longest.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(feature, _)| feature)
    }
}
