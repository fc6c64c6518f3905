//! Regions: connected faces with equal claims, from which findings are made.
//!
//! | region | faces | becomes |
//! | --- | --- | --- |
//! | unclaimed | covered by no feature | a gap (C2), or a space between near misses (C3) |
//! | part | covered by a feature, perhaps with others | a sliver (C4) |
//! | overlap | covered by the same two or more features | an overlap (C1), a duplicate (C5) |
//!
//! The location in a finding is not a sum, so a region that may become a finding stores all edges of its faces.

use super::ends::{Ends, compare_edges, compare_points};
use crate::region::finding;
use crate::sliver::is_thin;
use crate::{CoverageRule, Finding, Limits};
use core::cmp::Ordering;
use twinedge::dcel::{Face, HalfEdge};
use twinedge_algorithm::area::Sum;
use twinedge_geometry::Point;
use twinedge_map::{Builder, Embedding as _, Feature, FeatureId, PlanarMap, Shape};

/// The kind of claim on the faces of a region.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Claim {
    Unclaimed,
    Part(u32),
    /// By these features, two or more, and no others.
    Overlap(Vec<u32>),
}

impl Claim {
    /// Returns the claims on a face that these features cover, in order.
    pub(super) fn all(features: &[u32]) -> Vec<Self> {
        let overlap = (features.len() > 1).then(|| Self::Overlap(features.to_vec()));
        let unclaimed = features.is_empty().then_some(Self::Unclaimed);
        features.iter().copied().map(Self::Part).chain(overlap).chain(unclaimed).collect()
    }

    /// Returns the features next to an edge that are needed to see whether the face there has this claim. For a part, this is
    /// only its own feature; other findings also name the others.
    pub(super) fn kept_of(&self, features: &[u32]) -> Vec<u32> {
        match self {
            Self::Part(feature) if self.is_of(features) => vec![*feature],
            Self::Part(_) => Vec::new(),
            _ => features.to_vec(),
        }
    }

    /// Returns true if a face that these features cover has this claim.
    fn is_of(&self, features: &[u32]) -> bool {
        match self {
            Self::Unclaimed => features.is_empty(),
            Self::Part(feature) => features.binary_search(feature).is_ok(),
            Self::Overlap(all) => all == features,
        }
    }
}

/// An edge, with the features that cover the faces on its left and right, seen from its smaller end; [for a
/// part](Claim::kept_of), only its own feature.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Edge {
    pub(super) ends: Ends,
    pub(super) sides: [Vec<u32>; 2],
}

/// A set of connected faces with equal claims.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Region {
    pub(super) claim: Claim,
    pub(super) is_unbounded: bool,
    /// True for a part larger than slivers, which has no edges.
    pub(super) is_large: bool,
    pub(super) edges: Vec<Edge>,
}

impl Region {
    pub(super) const fn new(claim: Claim) -> Self {
        Self { claim, is_unbounded: false, is_large: false, edges: Vec::new() }
    }

    /// Adds another part of the region. The region must be [sorted](Self::sort) afterwards.
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

    /// Returns the features across its border, in order.
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

pub(super) fn sort_edges(edges: &mut Vec<Edge>) {
    edges.sort_by(|e, f| compare_edges(&e.ends, &f.ends));
    edges.dedup_by(|e, f| compare_edges(&e.ends, &f.ends).is_eq());
}

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

/// Returns the area of a part of a feature, and its sliver if it is one.
pub(super) fn examined(part: &Region, limits: &Limits) -> (f64, Option<Sliver>) {
    let (area, length) = part.size();
    let Claim::Part(feature) = part.claim else { return (area, None) };
    let is_small = |area: f64| limits.sliver_area.is_none_or(|limit| area < limit);
    // Leaves a margin for rounding.
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

/// A map built from edges whose adjacent coverage is already known.
pub(super) struct Drawing<'a> {
    pub(super) map: PlanarMap,
    edges: &'a [Edge],
    /// The edge of each half-edge by half its index, and true if the half-edge with the even index leaves its smaller end.
    of: Vec<Option<(usize, bool)>>,
}

impl<'a> Drawing<'a> {
    /// Builds the map. `edges` must be sorted. Returns `None` if they do not form a map. O(n log n).
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

    /// Returns the number of the edge of a half-edge, and the features that cover the face on its left.
    pub(super) fn left(&self, h: HalfEdge<'_>) -> Option<(usize, &'a [u32])> {
        let (edge, is_forth) = self.of.get(h.index() / 2).copied().flatten()?;
        let is_left = h.index().is_multiple_of(2) == is_forth;
        Some((edge, &self.edges[edge].sides[usize::from(!is_left)]))
    }

    /// Returns the faces next to edges whose features satisfy `is_of`, in order of their indices.
    pub(super) fn faces(&self, is_of: &dyn Fn(&[u32]) -> bool) -> Vec<Face<'_>> {
        let is_beside = |face: &Face<'_>| {
            let mut half_edges = face.half_edges();
            half_edges.next().and_then(|h| self.left(h)).is_some_and(|(_, features)| is_of(features))
        };
        self.map.dcel().faces().filter(is_beside).collect()
    }

    /// Makes the finding of the faces whose features satisfy `is_of`.
    pub(super) fn finding(&self, rule: CoverageRule, features: &[u32], is_of: &dyn Fn(&[u32]) -> bool) -> Finding {
        let faces = self.faces(is_of);
        let features = features.iter().copied().map(FeatureId::new).collect();
        Finding { faces: Vec::new(), ..finding(&self.map, rule, features, &faces) }
    }
}
