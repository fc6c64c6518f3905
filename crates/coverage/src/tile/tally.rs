//! The summary of one tile, from the map of the features that meet it.

use super::NIL;
use super::claimed::{Claimed, compare};
use super::clip::Bounds;
use super::cuts::Cuts;
use super::error::TileError;
use super::extent::{around, corners, points, rings};
use super::grid::{Grid, Tile};
use super::large::areas;
use super::local::Local;
use super::pieces::Pieces;
use super::region::{Claim, Edge, Region};
use super::side::Side;
use super::summary::{Border, Component, Contact, Joins, Summary};
use crate::mismatch::apart;
use crate::{Limits, defects};
use petgraph::unionfind::UnionFind;
use twinedge::dcel::{HalfEdge, Vertex};
use twinedge_map::{BuildError, Builder, Embedding as _, Feature, FeatureId, UnmatchedVertex};

impl Summary {
    /// Creates the summary of a tile. `features` are all that meet it, with their numbers in the whole; others have no effect.
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
        let features = meeting(grid, tile, 0.0, features)?;
        let (map, numbers) = (builder(&features)?.build()?, numbers(&features));
        let local = Local::new(&map, &numbers, grid.bounds(tile));
        let mut summary = Self::of_tile(*grid, tile, limits, &features);
        summary.note_shapes(tile, &features);
        summary.is_plane = map.is_plane();
        summary.crossings = local.crossings();
        Ok(local.summarize(tile, summary))
    }

    /// Creates the summary of a tile whose edges are cut where they meet, by complete [`Cuts`]. `features` are all features that
    /// [`Cuts::tiles_of`] assigns to the tile. The summary has no defects (C6), which belong to the input, but has the unmatched
    /// vertices (C7). If a tile was left out of a round of cuts, edges still meet other than at vertices there.
    ///
    /// O(n log n) for the features that come near the tile.
    ///
    /// # Errors
    /// [`TileError`]; with [`BuildError::OutOfReach`](twinedge_map::BuildError::OutOfReach) for larger coordinates.
    pub fn cut<'f>(
        grid: &Grid,
        tile: Tile,
        features: impl IntoIterator<Item = (u32, &'f Feature)>,
        limits: &Limits,
        cuts: &Cuts,
    ) -> Result<Self, TileError> {
        let features = meeting(grid, tile, cuts.margin(), features)?;
        let cut = |(number, feature): &(u32, &Feature)| {
            cuts.check(feature)?;
            Ok((*number, cuts.cut(feature)))
        };
        let of_cut = features.iter().map(cut).collect::<Result<Vec<(u32, Feature)>, BuildError>>()?;
        let of_cut: Vec<(u32, &Feature)> = of_cut.iter().map(|(number, feature)| (*number, feature)).collect();
        let (map, numbers) = (builder(&of_cut)?.build()?, numbers(&features));
        let local = Local::new(&map, &numbers, grid.bounds(tile));
        let mut summary = Self::of_tile(*grid, tile, limits, &meeting(grid, tile, 0.0, of_cut)?);
        summary.is_plane = map.is_plane();
        if summary.is_plane {
            let mut unmatched = builder(&features)?.unmatched();
            unmatched.retain(|one| local.bounds.contains(one.at));
            let in_whole = |mut one: UnmatchedVertex| {
                for feature in [&mut one.of, &mut one.lacked_by] {
                    *feature = FeatureId::new(numbers[feature.index()]);
                }
                one
            };
            summary.unmatched = apart(&map, &unmatched, |p| cuts.snapped(p)).map(in_whole).collect();
        }
        summary.crossings = local.crossings();
        Ok(local.summarize(tile, summary))
    }
}

/// Returns the features within a distance of a tile, by their numbers.
fn meeting<'f>(
    grid: &Grid,
    tile: Tile,
    distance: f64,
    features: impl IntoIterator<Item = (u32, &'f Feature)>,
) -> Result<Vec<(u32, &'f Feature)>, TileError> {
    if !grid.has(tile) {
        return Err(TileError::NoSuchTile(tile));
    }
    let bounds = grid.bounds(tile).grown(distance);
    let mut features: Vec<(u32, &Feature)> =
        features.into_iter().filter(|(_, feature)| meets(&bounds, feature)).collect();
    features.sort_by_key(|(number, _)| *number);
    match features.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => Err(TileError::SameNumber(pair[0].0)),
        None => Ok(features),
    }
}

fn builder(features: &[(u32, &Feature)]) -> Result<Builder, BuildError> {
    let mut builder = Builder::new();
    for (_, feature) in features {
        builder.feature(feature)?;
    }
    Ok(builder)
}

fn numbers(features: &[(u32, &Feature)]) -> Vec<u32> {
    features.iter().map(|(number, _)| *number).collect()
}

impl Summary {
    /// Creates a summary of a tile that knows only its features.
    fn of_tile(grid: Grid, tile: Tile, limits: &Limits, features: &[(u32, &Feature)]) -> Self {
        let claimed = |(number, feature): &(u32, &Feature)| {
            let (low, high) = corners(feature)?;
            Some(Claimed { feature: *number, like: None, between: [low, high].map(|p| grid.tile_of(p)), seen: 1 })
        };
        let claimed = features.iter().filter_map(claimed).collect();
        let corners = around(features.iter().flat_map(|(_, feature)| &feature.shapes).flat_map(points));
        Self { tiles: vec![tile], corners, claimed, ..Self::empty(grid, limits.clone()) }
    }

    /// Records the defects of features that begin in the tile, and the extents of their edges.
    fn note_shapes(&mut self, tile: Tile, features: &[(u32, &Feature)]) {
        for (number, feature) in features {
            let first = feature.shapes.iter().flat_map(points).next();
            if first.is_some_and(|p| self.grid.tile_of(p) == tile) {
                let found = defects(&feature.shapes);
                self.defects.extend((!found.is_empty()).then_some((*number, found)));
                for pair in feature.shapes.iter().flat_map(rings).flat_map(|ring| ring.windows(2)) {
                    let extent = (pair[0].x - pair[1].x).abs().max((pair[0].y - pair[1].y).abs());
                    self.count_edges((extent.to_bits() >> (f64::MANTISSA_DIGITS - 1)) as u16, 1);
                }
            }
        }
    }
}

fn meets(bounds: &Bounds, feature: &Feature) -> bool {
    corners(feature).is_some_and(|(low, high)| bounds.meets(low, high))
}

impl Local<'_> {
    /// Counts records inside the tile, and lists records cut by the border.
    fn summarize(&self, tile: Tile, mut summary: Summary) -> Summary {
        let (leaves, closed) = self.trace();
        // Parts of edges first, then vertices.
        let dcel = self.map.dcel();
        let of_vertex = |v: Vertex<'_>| (self.parts.len() + v.index()) as u32;
        let most = dcel.vertices().last().map_or(0, |v| v.index() + 1);
        let mut sets = UnionFind::new(self.parts.len() + most);
        let mut components = vec![Component::default(); self.parts.len() + most];
        let inside = |h: usize| self.half_edge(h).map(HalfEdge::origin).filter(|origin| self.vertex_is_inside(*origin));
        for (number, part) in (0..).zip(&self.parts) {
            for vertex in part.half_edges.into_iter().filter_map(inside) {
                sets.union(number, of_vertex(vertex));
            }
        }
        for vertex in dcel.vertices().filter(|v| self.vertex_is_inside(*v)) {
            let least = Some(self.map.point(vertex.index()));
            let root = sets.find_mut(of_vertex(vertex)) as usize;
            components[root].add(&Component { vertices: 1, least, ..Component::default() });
        }
        for (number, part) in (0..).zip(&self.parts) {
            let root = sets.find_mut(number) as usize;
            components[root].edges += u64::from(self.bounds.contains(part.ends[0]));
        }
        for start in &closed {
            components[sets.find_mut(self.part_of[*start]) as usize].cycles += 1;
        }
        let mut number_of = vec![NIL; components.len()];
        for (_, part, _) in &self.contacts {
            let root = sets.find_mut(*part) as usize;
            if number_of[root] == NIL {
                number_of[root] = summary.components.len() as u32;
                summary.components.push(components[root]);
            }
        }
        for root in 0..components.len() {
            let component = &components[root];
            if sets.find_mut(root as u32) as usize == root && number_of[root] == NIL && component.vertices > 0 {
                summary.close(component);
            }
        }
        // A cycle has the number of the contact where it enters.
        let mut enters = vec![0; leaves.len()];
        for (enter, leave) in (0..).zip(&leaves) {
            enters[*leave as usize] = enter;
        }
        let mut component_of = |part: u32| number_of[sets.find_mut(part) as usize];
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
                let features = self.features_along(self.parts[part as usize].half_edges[0]);
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
            Some(pieces) => self.claim(&pieces, &mut summary),
            None => Joins::new(&summary),
        };
        summary.settled(&mut joins)
    }

    /// Finds the regions of the pieces, and joins equal ones.
    fn claim(&self, pieces: &Pieces, summary: &mut Summary) -> Joins {
        let mut regions = Vec::new();
        let mut faces = pieces.faces.clone();
        let mut covered = vec![Vec::new(); summary.claimed.len()];
        for (number, face) in (0..).zip(&mut faces) {
            for claim in Claim::all(&face.features) {
                face.regions.push(regions.len() as u32);
                regions.push(Region { is_unbounded: face.is_unbounded, ..Region::new(claim) });
            }
            for feature in &face.features {
                if let Ok(place) = summary.claimed.binary_search_by_key(feature, |one| one.feature) {
                    covered[place].push(number);
                }
            }
        }
        compare(&mut summary.claimed, covered);
        for part in &self.parts {
            if !self.bounds.contains(part.ends[0]) {
                continue;
            }
            let [left, right] = pieces.beside(part).map(|piece| &faces[piece as usize]);
            for region in left.regions.iter().chain(&right.regions) {
                let region = &mut regions[*region as usize];
                let sides = [left, right].map(|face| region.claim.kept_of(&face.features));
                region.edges.push(Edge { ends: part.ends, sides });
            }
            if summary.limits.gap_width.is_none() {
                let [a, b] = part.ends;
                summary.lengths.push((b.x - a.x).hypot(b.y - a.y));
            }
        }
        if let Some(limit) = summary.limits.sliver_area {
            let areas = areas(self, pieces);
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
            let claim = |region: u32| &summary.regions[region as usize].claim;
            let (mut left, mut right) = (&left.regions[..], &right.regions[..]);
            // Both are in order of their claims.
            while let ([one, rest @ ..], [other, others @ ..]) = (left, right) {
                let order = claim(*one).cmp(claim(*other));
                if order.is_eq() {
                    joins.regions.union(*one, *other);
                }
                left = if order.is_le() { rest } else { left };
                right = if order.is_ge() { others } else { right };
            }
        }
        joins
    }
}
