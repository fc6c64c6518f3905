//! The part of a map that lies in a tile.

use super::NIL;
use super::clip::{Bounds, compare_along};
use super::ends::{Ends, compare_edges, compare_points};
use super::fault::{Crossing, CrossingKind};
use super::side::Side;
use rustc_hash::FxHashMap;
use twinedge::dcel::{FaceKey, HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::crossing::{Clash, clashes};
use twinedge_map::{Embedding as _, FeatureId, PlanarMap};

pub(super) struct Part {
    /// The half-edge that leaves the smaller end, by index, and its twin.
    pub(super) half_edges: [usize; 2],
    pub(super) ends: Ends,
    /// The contacts where the first half-edge enters and leaves the tile.
    pub(super) entry: Option<u32>,
    pub(super) exit: Option<u32>,
}

pub(super) struct Local<'a> {
    pub(super) map: &'a PlanarMap,
    pub(super) numbers: &'a [u32],
    pub(super) bounds: Bounds,
    pub(super) parts: Vec<Part>,
    pub(super) part_of: Vec<u32>,
    /// The contacts counter-clockwise from the lower left corner: the side, the part, true if its first half-edge enters.
    pub(super) contacts: Vec<(Side, u32, bool)>,
}

impl<'a> Local<'a> {
    pub(super) fn new(map: &'a PlanarMap, numbers: &'a [u32], bounds: Bounds) -> Self {
        let dcel = map.dcel();
        let mut local = Self {
            map,
            numbers,
            bounds,
            parts: Vec::new(),
            part_of: vec![NIL; dcel.half_edges().last().map_or(0, |h| h.index() + 1)],
            contacts: Vec::new(),
        };
        let mut sides: [Vec<(u32, bool)>; 4] = Default::default();
        for h in dcel.edges() {
            let mut half_edges = [h, h.twin()];
            let mut ends = half_edges.map(|h| map.point(h.origin().index()));
            if compare_points(ends[0], ends[1]).is_gt() {
                half_edges.reverse();
                ends.reverse();
            }
            let met = bounds.crossings(ends);
            if met.entry.is_none() && met.exit.is_none() && !bounds.contains(ends[0]) {
                continue;
            }
            let number = local.parts.len() as u32;
            for (side, is_entry) in [(met.entry, true), (met.exit, false)] {
                if let Some(side) = side {
                    sides[side as usize].push((number, is_entry));
                }
            }
            for h in half_edges {
                local.part_of[h.index()] = number;
            }
            let half_edges = half_edges.map(|h| h.index());
            local.parts.push(Part { half_edges, ends, entry: None, exit: None });
        }
        for (side, mut along) in Side::ALL.into_iter().zip(sides) {
            let ends = |part: u32| local.parts[part as usize].ends;
            if map.is_plane() {
                along.sort_by(|a, b| compare_along(side, ends(a.0), ends(b.0)));
            }
            if matches!(side, Side::Top | Side::Left) {
                along.reverse();
            }
            local.contacts.extend(along.into_iter().map(|(part, is_entry)| (side, part, is_entry)));
        }
        for (contact, (_, part, is_entry)) in (0..).zip(&local.contacts) {
            let part = &mut local.parts[*part as usize];
            *(if *is_entry { &mut part.entry } else { &mut part.exit }) = Some(contact);
        }
        local
    }

    pub(super) fn half_edge(&self, h: usize) -> Option<HalfEdge<'a>> {
        self.map.dcel().half_edge_at(h)
    }

    pub(super) fn vertex_is_inside(&self, vertex: Vertex<'_>) -> bool {
        self.bounds.contains(self.map.point(vertex.index()))
    }

    pub(super) fn entering(&self, contact: u32) -> usize {
        let (_, part, is_entry) = self.contacts[contact as usize];
        self.parts[part as usize].half_edges[usize::from(!is_entry)]
    }

    /// Returns the contact at which a half-edge leaves the tile, if it does.
    pub(super) fn leaves_at(&self, h: usize) -> Option<u32> {
        let part = &self.parts[self.part_of[h] as usize];
        if part.half_edges[0] == h { part.exit } else { part.entry }
    }

    pub(super) fn numbers(&self, features: impl Iterator<Item = FeatureId>) -> Vec<u32> {
        features.map(|feature| self.numbers[feature.index()]).collect()
    }

    /// Returns the numbers of the features that cover a face.
    pub(super) fn covering(&self, face: Option<FaceKey>) -> Vec<u32> {
        let features = face.and_then(|face| self.map.features_of(face).ok());
        features.map(|features| self.numbers(features)).unwrap_or_default()
    }

    pub(super) fn features_along(&self, h: usize) -> Vec<u32> {
        let along = self.half_edge(h).and_then(|h| self.map.features_along(h.key()).ok());
        along.map(|along| self.numbers(along)).unwrap_or_default()
    }

    /// Returns the numbers of the features along the edges at a vertex.
    fn features_at(&self, vertex: &Vertex<'_>) -> Vec<u32> {
        vertex.rotation().flat_map(|h| self.features_along(h.index())).collect()
    }

    /// Returns the pairs of edges that meet other than at shared endpoints.
    pub(super) fn crossings(&self) -> Vec<Crossing> {
        if self.map.is_plane() {
            return Vec::new();
        }
        let points: Vec<Point> = self.parts.iter().flat_map(|part| part.ends).collect();
        let alone = self.map.dcel().vertices().filter(|v| v.leaving().is_none() && self.vertex_is_inside(*v));
        let mut points: Vec<Point> = points.into_iter().chain(alone.map(|v| self.map.point(v.index()))).collect();
        points.sort_by(|a, b| compare_points(*a, *b));
        points.dedup();
        let number = |p: Point| points.binary_search_by(|q| compare_points(*q, p)).unwrap_or_default() as u32;
        let segments: Vec<[u32; 2]> = self.parts.iter().map(|part| part.ends.map(number)).collect();
        let ends = |segment: u32| self.parts[segment as usize].ends;
        let vertices = self.map.dcel().vertices().filter(|v| self.vertex_is_inside(*v));
        let vertices: FxHashMap<(u64, u64), Vertex<'_>> =
            vertices.map(|v| (self.map.point(v.index()).hash_key(), v)).collect();
        let along = |segment: u32| self.features_along(self.parts[segment as usize].half_edges[0]);
        let crossing = |clash: Clash| {
            let (kind, a, b, mut features) = match clash {
                Clash::Cross { a, b } => (CrossingKind::Cross, ends(a), ends(b), [along(a), along(b)].concat()),
                Clash::Overlap { a, b } => (CrossingKind::Overlap, ends(a), ends(b), [along(a), along(b)].concat()),
                Clash::Touch { vertex, segment } => {
                    let at = points[vertex as usize];
                    // The tile of a vertex knows the edges that end at it.
                    let vertex = vertices.get(&at.hash_key())?;
                    (CrossingKind::Touch, [at; 2], ends(segment), [self.features_at(vertex), along(segment)].concat())
                }
                Clash::SamePlace { .. } => return None,
            };
            features.sort_unstable();
            features.dedup();
            let is_in_order = kind == CrossingKind::Touch || compare_edges(&a, &b).is_le();
            let [first, second] = if is_in_order { [a, b] } else { [b, a] };
            Some(Crossing { kind, first, second, features })
        };
        let (found, _) = clashes(&points, &segments, usize::MAX).unwrap_or_default();
        found.into_iter().filter_map(crossing).collect()
    }

    /// Returns the cycles: for each contact, the contact where the half-edge that enters there leaves again; and the first
    /// half-edge of each cycle that no border cuts.
    pub(super) fn trace(&self) -> (Vec<u32>, Vec<usize>) {
        let mut is_passed = vec![false; self.part_of.len()];
        let mut leaves = Vec::with_capacity(self.contacts.len());
        let next = |h: usize| self.half_edge(h).map_or(h, |h| h.next().index());
        for contact in 0..self.contacts.len() as u32 {
            let mut h = self.entering(contact);
            loop {
                is_passed[h] = true;
                if let Some(contact) = self.leaves_at(h) {
                    leaves.push(contact);
                    break;
                }
                h = next(h);
            }
        }
        let mut closed = Vec::new();
        for start in self.parts.iter().flat_map(|part| part.half_edges) {
            let mut h = start;
            if !is_passed[h] {
                closed.push(start);
            }
            while !is_passed[h] {
                is_passed[h] = true;
                h = next(h);
            }
        }
        (leaves, closed)
    }
}
