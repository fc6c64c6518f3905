//! Regions: faces that hang together and are claimed alike, from which findings are made.
//!
//! | region | faces | becomes |
//! | --- | --- | --- |
//! | unclaimed | that no feature covers | a gap (C2), or a space between near misses (C3) |
//! | part | that a feature covers, whatever else does | a sliver (C4) |
//! | overlap | that the same features cover, two or more | an overlap (C1), a duplicate (C5) |
//!
//! What a finding says of its place is not a sum, so a region that may be one has all edges of its faces.

use super::ends::{Ends, compare_edges, compare_points};
use crate::region::finding;
use crate::sliver::is_thin;
use crate::{CoverageRule, Finding, Limits};
use core::cmp::Ordering;
use twinedge::dcel::{Face, HalfEdge};
use twinedge_algorithm::area::Sum;
use twinedge_geometry::Point;
use twinedge_map::{Builder, Embedding as _, Feature, FeatureId, PlanarMap, Shape};

/// The way in which the faces of a region are claimed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Claim {
    /// By nobody.
    Unclaimed,
    /// By this feature, and perhaps others.
    Part(u32),
    /// By these features, two or more, and no others.
    Overlap(Vec<u32>),
}

impl Claim {
    /// The claims of a face that these features cover, in order.
    pub(super) fn all(features: &[u32]) -> Vec<Self> {
        let overlap = (features.len() > 1).then(|| Self::Overlap(features.to_vec()));
        let unclaimed = features.is_empty().then_some(Self::Unclaimed);
        features.iter().copied().map(Self::Part).chain(overlap).chain(unclaimed).collect()
    }

    /// Those of the features beside an edge by which it is seen whether the faces there are claimed so; of all but parts, findings name the others, too.
    pub(super) fn kept_of(&self, features: &[u32]) -> Vec<u32> {
        match self {
            Self::Part(feature) if self.is_of(features) => vec![*feature],
            Self::Part(_) => Vec::new(),
            _ => features.to_vec(),
        }
    }

    /// Returns true if a face that these features cover is claimed so.
    fn is_of(&self, features: &[u32]) -> bool {
        match self {
            Self::Unclaimed => features.is_empty(),
            Self::Part(feature) => features.binary_search(feature).is_ok(),
            Self::Overlap(all) => all == features,
        }
    }
}

/// An edge, and the features that cover the faces on its left and right, as it leaves its smaller end; [of a part](Claim::kept_of), no others.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Edge {
    pub(super) ends: Ends,
    pub(super) sides: [Vec<u32>; 2],
}

/// A set of faces that hang together and are claimed alike.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Region {
    pub(super) claim: Claim,
    pub(super) is_unbounded: bool,
    /// True of a part that is larger than slivers are: then it has no edges.
    pub(super) is_large: bool,
    /// The edges of its faces, in order.
    pub(super) edges: Vec<Edge>,
}

impl Region {
    pub(super) const fn new(claim: Claim) -> Self {
        Self { claim, is_unbounded: false, is_large: false, edges: Vec::new() }
    }

    /// Adds another part of the region. To be [sorted](Self::sort) then.
    pub(super) fn add(&mut self, mut other: Self) {
        self.is_unbounded |= other.is_unbounded;
        self.is_large |= other.is_large;
        self.edges.append(&mut other.edges);
    }

    pub(super) fn sort(&mut self) {
        if self.is_large {
            self.edges = Vec::new();
        }
        sort_edges(&mut self.edges);
    }

    pub(super) fn compare(&self, other: &Self) -> Ordering {
        self.claim.cmp(&other.claim).then_with(|| match (self.edges.first(), other.edges.first()) {
            (Some(a), Some(b)) => compare_edges(&a.ends, &b.ends),
            (a, b) => a.is_some().cmp(&b.is_some()),
        })
    }

    /// The features across its border, in order.
    pub(super) fn around(&self) -> Vec<u32> {
        let beyond = |edge: &Edge| {
            let is_of = edge.sides.each_ref().map(|side| self.claim.is_of(side));
            let side = usize::from(is_of[0]);
            if is_of[side] { Vec::new() } else { edge.sides[side].clone() }
        };
        let mut features: Vec<u32> = self.edges.iter().flat_map(beyond).collect();
        features.sort_unstable();
        features.dedup();
        features
    }

    /// Its area and the length of its border.
    fn size(&self) -> (f64, f64) {
        let origin = self.edges.first().map_or_else(Point::default, |edge| edge.ends[0]);
        let (mut twice, mut length) = (Sum::default(), Sum::default());
        for Edge { ends: [a, b], sides } in &self.edges {
            let is_of = sides.each_ref().map(|side| self.claim.is_of(side));
            if is_of[0] == is_of[1] {
                continue;
            }
            let cross = (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
            twice.add(if is_of[0] { cross } else { -cross });
            length.add((b.x - a.x).hypot(b.y - a.y));
        }
        (twice.value() / 2.0, length.value())
    }
}

/// Sorts edges, each once.
pub(super) fn sort_edges(edges: &mut Vec<Edge>) {
    edges.sort_by(|e, f| compare_edges(&e.ends, &f.ends));
    edges.dedup_by(|e, f| compare_edges(&e.ends, &f.ends).is_eq());
}

/// A thin part of a feature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Sliver {
    pub(super) feature: u32,
    pub(super) area: f64,
    pub(super) width: f64,
    pub(super) length: f64,
    pub(super) at: Point,
    pub(super) corner: Point,
}

impl Sliver {
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        self.feature.cmp(&other.feature).then_with(|| compare_points(self.at, other.at))
    }
}

/// The area of a part of a feature, and the sliver that it is if it is one.
pub(super) fn examined(part: &Region, limits: &Limits) -> (f64, Option<Sliver>) {
    let (area, length) = part.size();
    let Claim::Part(feature) = part.claim else { return (area, None) };
    let is_small = |area: f64| limits.sliver_area.is_none_or(|limit| area < limit);
    // Rounding makes no difference yet.
    let less = area * (1.0 - 1e-6);
    if !is_small(less) || !is_thin(less, length, limits) {
        return (area, None);
    }
    let sliver = Drawing::new(&part.edges).map(|drawing| {
        let Finding { area, width, length, at, corner, .. } =
            drawing.finding(CoverageRule::Sliver, &[feature], &|features| part.claim.is_of(features));
        Sliver { feature, area, width, length, at, corner }
    });
    (area, sliver.filter(|sliver| is_small(sliver.area) && is_thin(sliver.area, sliver.length, limits)))
}

/// The map of some edges, of which it is known what covers the faces beside them.
pub(super) struct Drawing<'a> {
    pub(super) map: PlanarMap,
    edges: &'a [Edge],
    /// The edge of each half-edge by half its index, and true if the half-edge with the even index leaves its smaller end.
    of: Vec<Option<(usize, bool)>>,
}

impl<'a> Drawing<'a> {
    /// `edges` are sorted. None if they are no map. O(n log n).
    pub(super) fn new(edges: &'a [Edge]) -> Option<Self> {
        let shapes = edges.iter().map(|edge| Shape::line(edge.ends)).collect();
        let mut builder = Builder::new();
        builder.feature(&Feature { shapes, ..Feature::default() }).ok()?;
        let map = builder.build().ok().filter(PlanarMap::is_plane)?;
        let mut found = Vec::new();
        for h in map.dcel().half_edges().filter(|h| h.index().is_multiple_of(2)) {
            let mut ends = [h.origin(), h.target()].map(|v| map.point(v.index()));
            let is_forth = compare_points(ends[0], ends[1]).is_le();
            if !is_forth {
                ends.reverse();
            }
            let edge = edges.binary_search_by(|edge| compare_edges(&edge.ends, &ends)).ok()?;
            found.resize(h.index() / 2, None);
            found.push(Some((edge, is_forth)));
        }
        Some(Self { map, edges, of: found })
    }

    /// The number of the edge of a half-edge, and the features that cover the face on its left.
    pub(super) fn left(&self, h: HalfEdge<'_>) -> Option<(usize, &'a [u32])> {
        let (edge, is_forth) = self.of.get(h.index() / 2).copied().flatten()?;
        let is_left = h.index().is_multiple_of(2) == is_forth;
        Some((edge, &self.edges[edge].sides[usize::from(!is_left)]))
    }

    /// The faces beside edges that are covered so, in order of their indices.
    pub(super) fn faces(&self, is_of: &dyn Fn(&[u32]) -> bool) -> Vec<Face<'_>> {
        let is_beside = |face: &Face<'_>| {
            let mut half_edges = face.half_edges();
            half_edges.next().and_then(|h| self.left(h)).is_some_and(|(_, features)| is_of(features))
        };
        self.map.dcel().faces().filter(is_beside).collect()
    }

    /// The finding that the faces are which are covered so.
    pub(super) fn finding(&self, rule: CoverageRule, features: &[u32], is_of: &dyn Fn(&[u32]) -> bool) -> Finding {
        let faces = self.faces(is_of);
        let features = features.iter().copied().map(FeatureId::new).collect();
        Finding { faces: Vec::new(), ..finding(&self.map, rule, features, &faces) }
    }
}
