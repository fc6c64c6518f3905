//! The summary of one tile, from the map of the features that meet it.

use super::claimed::Claimed;
use super::clip::{Bounds, Ends, compare_along};
use super::error::TileError;
use super::fault::{Crossing, CrossingKind};
use super::grid::{Grid, Side, Tile};
use super::large::areas;
use super::pieces::Pieces;
use super::region::{Claim, Edge, Region};
use super::summary::{Border, Component, Contact, Joins, Summary, compare_points};
use crate::algorithm::coverage::{Limits, defects};
use crate::dcel::{FaceKey, HalfEdge, Vertex};
use crate::geometry::Point;
use crate::geometry::crossing::{Clash, clashes};
use crate::map::{Builder, Feature, FeatureId, PlanarMap, Shape};
use crate::slots::{NIL, Sets};
use crate::validate::Embedding as _;

/// The part of an edge that lies in the tile.
pub(super) struct Part {
    /// The half-edge that leaves the smaller end, by index, and the other one.
    pub(super) half_edges: [usize; 2],
    pub(super) ends: Ends,
    /// The contacts where the first half-edge enters and leaves the tile.
    pub(super) entry: Option<u32>,
    pub(super) exit: Option<u32>,
}

/// The part of a map that lies in a tile.
pub(super) struct Local<'a> {
    pub(super) map: &'a PlanarMap,
    /// The numbers of its features.
    pub(super) numbers: &'a [u32],
    pub(super) bounds: Bounds,
    pub(super) parts: Vec<Part>,
    /// The part of each half-edge, by index.
    pub(super) part_of: Vec<u32>,
    /// The contacts counter-clockwise from the lower left corner: the side, the part, and true if its first half-edge enters there.
    pub(super) contacts: Vec<(Side, u32, bool)>,
}

impl Summary {
    /// The summary of a tile. `features` are all that meet it, with their numbers in the whole; others make no difference.
    ///
    /// O(n log n) for the features that meet the tile.
    ///
    /// # Errors
    /// [`TileError`].
    pub fn new<'f>(
        grid: &Grid,
        tile: Tile,
        features: impl IntoIterator<Item = (u32, &'f Feature)>,
        limits: &Limits,
    ) -> Result<Self, TileError> {
        if !grid.has(tile) {
            return Err(TileError::NoSuchTile(tile));
        }
        let bounds = grid.bounds(tile);
        let mut features: Vec<(u32, &Feature)> =
            features.into_iter().filter(|(_, feature)| meets(&bounds, feature)).collect();
        features.sort_by_key(|(number, _)| *number);
        if let Some(pair) = features.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(TileError::SameNumber(pair[0].0));
        }
        let mut builder = Builder::new();
        for (_, feature) in &features {
            builder.feature(feature)?;
        }
        let map = builder.build()?;
        let numbers: Vec<u32> = features.iter().map(|(number, _)| *number).collect();
        let local = Local::new(&map, &numbers, bounds);
        let mut summary = Self::empty(*grid, limits.clone());
        summary.tiles.push(tile);
        summary.note(tile, &features);
        summary.is_plane = map.is_plane();
        summary.crossings = local.crossings();
        Ok(local.summarize(tile, summary))
    }
}

impl Summary {
    /// Notes which features the tile was given, and what is wrong with the shapes of those that begin in it.
    fn note(&mut self, tile: Tile, features: &[(u32, &Feature)]) {
        for (number, feature) in features {
            let Some((low, high)) = corners(feature) else { continue };
            let of = self.grid.tiles_of(low, high).count() as u64;
            self.claimed.push(Claimed { feature: *number, with: None, seen: 1, of });
            let first = feature.shapes.iter().flat_map(points).next();
            if first.is_some_and(|p| self.grid.tile_of(p) == tile) {
                let found = defects(&feature.shapes);
                self.defects.extend((!found.is_empty()).then_some((*number, found)));
            }
        }
    }
}

/// Returns true if the box around a feature meets the tile.
fn meets(bounds: &Bounds, feature: &Feature) -> bool {
    corners(feature).is_some_and(|(low, high)| bounds.meets(low, high))
}

/// The corners of the box around a feature.
fn corners(feature: &Feature) -> Option<(Point, Point)> {
    let mut points = feature.shapes.iter().flat_map(points);
    let first = points.next()?;
    Some(points.fold((first, first), |(low, high), p| {
        (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
    }))
}

fn points(shape: &Shape) -> Box<dyn Iterator<Item = Point> + '_> {
    match shape {
        Shape::Polygon(rings) => Box::new(rings.iter().flatten().copied()),
        Shape::Line(points) => Box::new(points.iter().copied()),
        Shape::Point(point) => Box::new(core::iter::once(*point)),
    }
}

impl<'a> Local<'a> {
    fn new(map: &'a PlanarMap, numbers: &'a [u32], bounds: Bounds) -> Self {
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

    fn vertex_is_inside(&self, vertex: Vertex<'_>) -> bool {
        self.bounds.contains(self.map.point(vertex.index()))
    }

    /// The half-edge that enters at a contact.
    pub(super) fn entering(&self, contact: u32) -> usize {
        let (_, part, is_entry) = self.contacts[contact as usize];
        self.parts[part as usize].half_edges[usize::from(!is_entry)]
    }

    /// The contact at which a half-edge leaves the tile, if it does.
    pub(super) fn leaves_at(&self, h: usize) -> Option<u32> {
        let part = &self.parts[self.part_of[h] as usize];
        if part.half_edges[0] == h { part.exit } else { part.entry }
    }

    /// The numbers of features of the map.
    pub(super) fn numbers(&self, features: impl Iterator<Item = FeatureId>) -> Vec<u32> {
        features.map(|feature| self.numbers[feature.index()]).collect()
    }

    /// The numbers of the features that cover a face.
    pub(super) fn covering(&self, face: Option<FaceKey>) -> Vec<u32> {
        let features = face.and_then(|face| self.map.features_of(face).ok());
        features.map(|features| self.numbers(features)).unwrap_or_default()
    }

    /// The pairs of edges that meet elsewhere than at shared endpoints.
    fn crossings(&self) -> Vec<Crossing> {
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
        let crossing = |clash: Clash| {
            let (kind, a, b) = match clash {
                Clash::Cross { a, b } => (CrossingKind::Cross, ends(a), ends(b)),
                Clash::Overlap { a, b } => (CrossingKind::Overlap, ends(a), ends(b)),
                Clash::Touch { vertex, segment } => {
                    (CrossingKind::Touch, [points[vertex as usize]; 2], ends(segment))
                }
                Clash::SamePlace { .. } => return None,
            };
            let is_in_order = kind == CrossingKind::Touch || super::summary::compare_edges(&a, &b).is_le();
            let [first, second] = if is_in_order { [a, b] } else { [b, a] };
            Some(Crossing { kind, first, second })
        };
        let (found, _) = clashes(&points, &segments, usize::MAX).unwrap_or_default();
        found.into_iter().filter_map(crossing).collect()
    }

    /// The cycles: for each contact the contact where the half-edge that enters there leaves again, and for each cycle that no border
    /// cuts its first half-edge.
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

    /// Counts what lies inside, and lists what the border cuts.
    fn summarize(&self, tile: Tile, mut summary: Summary) -> Summary {
        let (leaves, closed) = self.trace();
        // Parts of edges first, then vertices.
        let dcel = self.map.dcel();
        let of_vertex = |v: Vertex<'_>| (self.parts.len() + v.index()) as u32;
        let most = dcel.vertices().last().map_or(0, |v| v.index() + 1);
        let mut sets = Sets::new(self.parts.len() + most);
        let mut components = vec![Component::default(); self.parts.len() + most];
        let inside = |h: usize| {
            self.half_edge(h).map(HalfEdge::origin).filter(|origin| self.vertex_is_inside(*origin))
        };
        for (number, part) in (0..).zip(&self.parts) {
            for vertex in part.half_edges.into_iter().filter_map(inside) {
                sets.join(number, of_vertex(vertex));
            }
        }
        for vertex in dcel.vertices().filter(|v| self.vertex_is_inside(*v)) {
            let least = Some(self.map.point(vertex.index()));
            let root = sets.find(of_vertex(vertex)) as usize;
            components[root].add(&Component { vertices: 1, least, ..Component::default() });
        }
        for (number, part) in (0..).zip(&self.parts) {
            let root = sets.find(number) as usize;
            components[root].edges += u64::from(self.bounds.contains(part.ends[0]));
        }
        for start in &closed {
            components[sets.find(self.part_of[*start]) as usize].cycles += 1;
        }
        let mut number_of = vec![NIL; components.len()];
        for (_, part, _) in &self.contacts {
            let root = sets.find(*part) as usize;
            if number_of[root] == NIL {
                number_of[root] = summary.components.len() as u32;
                summary.components.push(components[root]);
            }
        }
        for root in 0..components.len() {
            let component = &components[root];
            if sets.find(root as u32) as usize == root && number_of[root] == NIL && component.vertices > 0 {
                summary.close(component);
            }
        }
        // A cycle has the number of the contact where it enters.
        let mut enters = vec![0; leaves.len()];
        for (enter, leave) in (0..).zip(&leaves) {
            enters[*leave as usize] = enter;
        }
        let mut component_of = |part: u32| number_of[sets.find(part) as usize];
        summary.cycles = self.contacts.iter().map(|(_, part, _)| component_of(*part)).collect();
        let pieces = self.map.is_plane().then(|| Pieces::new(self, &leaves, &closed));
        let mut first = 0;
        for side in Side::ALL {
            let count = self.contacts[first..].iter().take_while(|contact| contact.0 == side).count();
            let along = first..first + count;
            first += count;
            if summary.grid.neighbour(tile, side).is_none() {
                continue;
            }
            let contact = |contact: usize| {
                let (_, part, is_entry) = self.contacts[contact];
                let [forth, _] = self.parts[part as usize].half_edges;
                let along = self.half_edge(forth).and_then(|h| self.map.features_along(h.key()).ok());
                let features = along.map(|along| self.numbers(along)).unwrap_or_default();
                let cycles = [contact as u32, enters[contact]];
                Contact {
                    edge: self.parts[part as usize].ends,
                    features,
                    component: component_of(part),
                    cycles: if is_entry { cycles } else { [cycles[1], cycles[0]] },
                }
            };
            let mut border = Border {
                tile,
                side,
                contacts: along.clone().map(contact).collect(),
                faces: pieces.as_ref().map(|pieces| pieces.along(along)).unwrap_or_default(),
            };
            if matches!(side, Side::Top | Side::Left) {
                border.contacts.reverse();
                border.faces.reverse();
            }
            summary.borders.push(border);
        }
        let mut joins = match pieces {
            Some(pieces) => self.claim(pieces, &mut summary),
            None => Joins::new(&summary),
        };
        summary.settled(&mut joins)
    }

    /// Finds the regions of the pieces, and which of them are the same.
    fn claim(&self, pieces: Pieces, summary: &mut Summary) -> Joins {
        let mut regions = Vec::new();
        let mut faces = pieces.faces.clone();
        for face in &mut faces {
            for claim in Claim::all(&face.features) {
                face.regions.push(regions.len() as u32);
                regions.push(Region { is_unbounded: face.is_unbounded, ..Region::new(claim) });
            }
            for feature in &face.features {
                if let Ok(place) = summary.claimed.binary_search_by_key(feature, |one| one.feature) {
                    summary.claimed[place].meet(&face.features);
                }
            }
        }
        for part in &self.parts {
            if !self.bounds.contains(part.ends[0]) {
                continue;
            }
            let [left, right] = pieces.beside(part).map(|piece| &faces[piece as usize]);
            let edge = Edge { ends: part.ends, sides: [left, right].map(|face| face.features.clone()) };
            for region in left.regions.iter().chain(&right.regions) {
                regions[*region as usize].edges.push(edge.clone());
            }
            if summary.limits.gap_width.is_none() {
                let [a, b] = part.ends;
                summary.lengths.push((b.x - a.x).hypot(b.y - a.y));
            }
        }
        if let Some(limit) = summary.limits.sliver_area {
            let areas = areas(self, &pieces);
            // Twice as large, since these areas are rounded.
            for (face, _) in faces.iter().zip(areas).filter(|(_, area)| *area > 2.0 * limit) {
                for region in &face.regions {
                    let region = &mut regions[*region as usize];
                    region.is_large = matches!(region.claim, Claim::Part(_));
                }
            }
        }
        (summary.faces, summary.regions) = (faces, regions);
        let mut joins = Joins::new(summary);
        for part in &self.parts {
            let [left, right] = pieces.beside(part).map(|piece| &summary.faces[piece as usize]);
            for one in &left.regions {
                let claim = &summary.regions[*one as usize].claim;
                let is_same = |other: &&u32| summary.regions[**other as usize].claim == *claim;
                if let Some(other) = right.regions.iter().find(is_same) {
                    joins.regions.join(*one, *other);
                }
            }
        }
        joins
    }
}
