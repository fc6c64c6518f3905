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

/// An edge, with the features that cover the faces on its left and right, seen from its smaller end, by their indices in the
/// region; [for a part](Claim::kept_of), only its own feature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Edge {
    pub(super) ends: Ends,
    pub(super) sides: [u32; 2],
}

/// A set of connected faces with equal claims.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Region {
    pub(super) claim: Claim,
    pub(super) is_unbounded: bool,
    /// True for a part larger than slivers, which has no edges.
    pub(super) is_large: bool,
    /// The sets of features next to its edges: distinct and in order, once it is [sorted](Self::sort).
    pub(super) sets: Vec<Vec<u32>>,
    pub(super) edges: Vec<Edge>,
}

impl Region {
    pub(super) const fn new(claim: Claim) -> Self {
        Self { claim, is_unbounded: false, is_large: false, sets: Vec::new(), edges: Vec::new() }
    }

    /// Returns the region of all edges of others, with the claim of the first; `None` if there are none.
    pub(super) fn joined<'r>(others: impl IntoIterator<Item = &'r Self>) -> Option<Self> {
        let all = others.into_iter().cloned().reduce(|mut all, other| {
            all.add(other);
            all
        });
        all.map(|mut all| {
            all.sort();
            all
        })
    }

    /// Adds an edge, with the features on both sides. The region must be [sorted](Self::sort) afterwards.
    pub(super) fn put(&mut self, ends: Ends, sides: [&[u32]; 2]) {
        let sides = sides.map(|features| {
            let features = self.claim.kept_of(features);
            // Edges that follow each other have the same features.
            let known = self.sets.iter().rev().take(4).position(|set| *set == features);
            let from_last = known.unwrap_or_else(|| {
                self.sets.push(features);
                0
            });
            (self.sets.len() - 1 - from_last) as u32
        });
        self.edges.push(Edge { ends, sides });
    }

    /// Adds another part of the region. The region must be [sorted](Self::sort) afterwards.
    pub(super) fn add(&mut self, mut other: Self) {
        self.is_unbounded |= other.is_unbounded;
        self.is_large |= other.is_large;
        let before = self.sets.len() as u32;
        self.sets.append(&mut other.sets);
        self.edges.extend(other.edges.iter().map(|edge| Edge { sides: edge.sides.map(|set| set + before), ..*edge }));
    }

    pub(super) fn sort(&mut self) {
        if self.is_large {
            self.edges = Vec::new();
        }
        self.edges.sort_by(|e, f| compare_edges(&e.ends, &f.ends));
        self.edges.dedup_by(|e, f| compare_edges(&e.ends, &f.ends).is_eq());
        let mut is_used = vec![false; self.sets.len()];
        for set in self.edges.iter().flat_map(|edge| edge.sides) {
            is_used[set as usize] = true;
        }
        let used = self.sets.iter().zip(is_used).filter(|(_, is_used)| *is_used);
        let mut sets: Vec<Vec<u32>> = used.map(|(set, _)| set.clone()).collect();
        sets.sort_unstable();
        sets.dedup();
        let place: Vec<u32> = self.sets.iter().map(|set| sets.binary_search(set).unwrap_or_default() as u32).collect();
        for edge in &mut self.edges {
            edge.sides = edge.sides.map(|set| place[set as usize]);
        }
        self.sets = sets;
    }

    /// Returns the features on the left and right of an edge.
    fn beside(&self, edge: &Edge) -> [&[u32]; 2] {
        edge.sides.map(|set| &self.sets[set as usize][..])
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
            let beside = self.beside(edge);
            let side = usize::from(self.claim.is_of(beside[0]));
            if self.claim.is_of(beside[side]) { &[] } else { beside[side] }
        };
        let mut features: Vec<u32> = self.edges.iter().flat_map(beyond).copied().collect();
        features.sort_unstable();
        features.dedup();
        features
    }

    fn size(&self) -> (f64, f64) {
        let origin = self.edges.first().map_or_else(Point::default, |edge| edge.ends[0]);
        let (mut twice, mut length) = (Sum::default(), Sum::default());
        for edge in &self.edges {
            let (is_of, [a, b]) = (self.beside(edge).map(|features| self.claim.is_of(features)), edge.ends);
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
    let sliver = Drawing::new(part).map(|drawing| {
        let Finding { area, width, length, at, corner, .. } =
            drawing.finding(CoverageRule::Sliver, &[feature], &|features| part.claim.is_of(features));
        Sliver { feature, area, width, length, at, corner }
    });
    (area, sliver.filter(|sliver| is_small(sliver.area) && is_thin(sliver.area, sliver.length, limits)))
}

/// A map built from the edges of a region.
pub(super) struct Drawing<'a> {
    pub(super) map: PlanarMap,
    region: &'a Region,
    /// The edge of each half-edge by half its index, and true if the half-edge with the even index leaves its smaller end.
    of: Vec<Option<(usize, bool)>>,
}

impl<'a> Drawing<'a> {
    /// Builds the map. The region must be sorted. Returns `None` if its edges do not form a map. O(n log n).
    pub(super) fn new(region: &'a Region) -> Option<Self> {
        let edges = &region.edges;
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
        Some(Self { map, region, of: found })
    }

    /// Returns the number of the edge of a half-edge, and the features that cover the face on its left.
    pub(super) fn left(&self, h: HalfEdge<'_>) -> Option<(usize, &'a [u32])> {
        let (edge, is_forth) = self.of.get(h.index() / 2).copied().flatten()?;
        let is_left = h.index().is_multiple_of(2) == is_forth;
        Some((edge, self.region.beside(&self.region.edges[edge])[usize::from(!is_left)]))
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
