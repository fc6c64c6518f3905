//! Applying a diff: editing one map until it equals the other.

use super::Diff;
use super::error::ApplyError;
use super::ids::{Column, Ids, Index};
use super::record::{Change, Record};
use crate::edit::EditError;
use crate::feature_tries::SetId;
use crate::{FeatureId, PlanarMap};
use slotmap::{Key, KeyData};
use std::collections::{BTreeMap, BTreeSet};
use std::mem;
use twinedge::dcel::extend::Kind;
use twinedge::dcel::{HalfEdge, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;

impl Diff {
    /// Turns the first map into the second one, up to keys. Surviving records keep their keys, except vertices that cannot move
    /// straight to their new coordinates, and faces that were both split and merged.
    ///
    /// [Policies](twinedge::dcel::Policy) of vertices, half-edges, edges, corners and faces do not apply: compared values become
    /// the values of the second map, other values stay with their records, and new records have none. Features are added and
    /// removed as by [`add_feature`](PlanarMap::add_feature) and [`remove_feature`](PlanarMap::remove_feature). A
    /// [`History`](twinedge::dcel::History) records an ordinary change. O(n log n) for the map, plus the edits.
    ///
    /// # Errors
    /// [`ApplyError`], with the map unchanged.
    pub fn apply(&self, map: &mut PlanarMap, ids: &Ids) -> Result<(), ApplyError> {
        let base = Index::new(map, ids)?;
        self.is_of(map, &base, ids)?;
        let contents = self.contents(map, &base, ids);
        map.rewinding(|map| {
            // While lines are erased and drawn, the faces between them have no owners.
            let attributes = map.dcel.replace_attributes(None);
            let mut drawing = Drawing::new(map, base);
            let drawn = drawing.draw(self).and_then(|()| drawing.name_faces(self, &contents));
            let Drawing { index, moved, .. } = drawing;
            map.dcel.replace_attributes(attributes);
            drawn?;
            if let Some(attributes) = map.dcel.attributes_mut() {
                attributes.transfer(&moved);
            }
            self.label(map, &index, ids)
        })
    }

    /// Checks that the map equals the first map wherever the diff changes it.
    fn is_of(&self, map: &PlanarMap, base: &Index, ids: &Ids) -> Result<(), ApplyError> {
        if self.features != map.features().count() {
            return Err(super::DiffError::Features(self.features.min(map.features().count())).into());
        }
        let made: BTreeSet<Record> = self.changes.iter().filter(|one| one.1.makes()).map(|one| one.0).collect();
        for (record, change) in &self.changes {
            let key = base.key(map, *record);
            let is_as_it_was = match change {
                change if change.makes() => key.is_none(),
                Change::Moved { from, .. } => key.is_some_and(|v| map.position(v.into()) == Ok(*from)),
                Change::Features { from, .. } => base.features(map, *record) == *from,
                Change::Value { name, from, .. } => {
                    key.and_then(|key| (column(ids, *record, name)?.get)(map, key)) == *from
                }
                _ => key.is_some(),
            };
            let is_as_it_was =
                is_as_it_was && change.stage(*record).is_some() && (key.is_some() || made.contains(record));
            if !is_as_it_was {
                return Err(ApplyError::AnotherMap(*record));
            }
        }
        Ok(())
    }

    /// Assigns ids, features and values to the records.
    fn label(&self, map: &mut PlanarMap, index: &Index, ids: &Ids) -> Result<(), ApplyError> {
        for name in &self.names {
            map.add_feature(name.clone());
        }
        for (record, change) in &self.changes {
            let Some(key) = index.key(map, *record) else { continue };
            let done = match (*record, change) {
                (Record::Vertex(id), Change::Added(_)) => (ids.vertices.put)(map, key, Some(id)),
                (Record::Face(id), Change::Made(_)) => (ids.faces.put)(map, key, Some(id)),
                (Record::Feature(_), Change::Dropped) => map.remove_feature(key.into()).map(|_| true)?,
                (_, Change::Features { to, .. }) => {
                    let to = to.iter().map(|f| FeatureId::new(u32::try_from(*f).unwrap_or(u32::MAX)));
                    match record {
                        Record::Edge(..) => map.set_features_along(key.into(), to)?,
                        _ => map.set_features_of(key.into(), to)?,
                    }
                    true
                }
                (_, Change::Value { name, to, .. }) => {
                    column(ids, *record, name).is_some_and(|column| (column.put)(map, key, to.clone()))
                }
                _ => true,
            };
            if !done {
                let name = if let Change::Value { name, .. } = change { name.clone() } else { "id".into() };
                return Err(ApplyError::Value { record: *record, name });
            }
        }
        Ok(())
    }
}

impl Change {
    const fn makes(&self) -> bool {
        matches!(self, Self::Added(_) | Self::Drawn | Self::Made(_))
    }
}

fn column<'a>(ids: &'a Ids, of: Record, name: &str) -> Option<&'a Column<String>> {
    ids.values.iter().find(|column| column.name == name && column.kind == of.kind())
}

/// An edge: the half-edges from the end with the smaller id and from the other end, and the one whose key holds the values.
#[derive(Clone, Copy)]
struct Sides {
    half_edges: [HalfEdgeKey; 2],
    edge: HalfEdgeKey,
}

/// A map without attributes, while the diff is drawn on it.
pub(super) struct Drawing<'a> {
    pub(super) map: &'a mut PlanarMap,
    pub(super) index: Index,
    /// For each face, a half-edge on its outer boundary by its ends, and the face's features.
    pub(super) faces: BTreeMap<u128, (u128, u128, SetId)>,
    pub(super) unbounded: SetId,
    /// Edges erased so that a vertex can move, by their ends, with their features.
    lifted: Vec<(u128, u128, Sides, SetId)>,
    /// The keys of dropped records, and of records that got new keys.
    pub(super) moved: Vec<(Kind, KeyData, Option<KeyData>)>,
}

impl<'a> Drawing<'a> {
    fn new(map: &'a mut PlanarMap, index: Index) -> Self {
        let faces = index.faces.iter().filter_map(|(id, f)| {
            let f = map.dcel.face(*f).ok()?;
            let (from, to) = index.ends(f.outer_half_edge()?);
            Some((*id, (from, to, map.features.of_face(f.index()))))
        });
        let faces = faces.collect();
        let unbounded = map.features.of_face(map.dcel.unbounded_face().index());
        Self { map, index, faces, unbounded, lifted: Vec::new(), moved: Vec::new() }
    }

    /// Draws in an order that keeps the way clear: edges and vertices are dropped first. Vertices that cannot move straight to
    /// their new coordinates are dropped with their edges and drawn anew.
    fn draw(&mut self, diff: &Diff) -> Result<(), ApplyError> {
        let (mut added, mut drawn) = (Vec::new(), Vec::new());
        for (record, change) in &diff.changes {
            match (*record, change) {
                (Record::Edge(a, b), Change::Dropped) => {
                    let (sides, _) = self.erase(a, b)?;
                    self.rename_edge(sides, None);
                }
                (Record::Vertex(v), Change::Dropped) => {
                    let key = self.drop_vertex(v)?;
                    self.moved.push((Kind::Vertex, key.data(), None));
                }
                (Record::Vertex(v), Change::Moved { to, .. }) => match self.map.move_vertex(self.vertex(v)?, *to) {
                    Err(EditError::VertexInTheWay(_) | EditError::EdgeInTheWay(_)) => {
                        let old = self.lift(v)?;
                        added.push((v, *to, Some(old)));
                    }
                    moved => moved?,
                },
                (Record::Vertex(v), Change::Added(at)) => added.push((v, *at, None)),
                (Record::Edge(a, b), Change::Drawn) => drawn.push((a, b)),
                _ => {}
            }
        }
        for (v, at, old) in added {
            let key = self.add(v, at)?;
            self.moved.extend(old.map(|old| (Kind::Vertex, old.data(), Some(key.data()))));
        }
        for (a, b, old, set) in mem::take(&mut self.lifted) {
            let sides = self.connect(a, b)?;
            self.map.cover_edge(self.map.dcel.half_edge(sides.edge)?.index(), set);
            self.rename_edge(old, Some(sides));
        }
        for (a, b) in drawn {
            self.connect(a, b)?;
        }
        Ok(())
    }

    fn vertex(&self, id: u128) -> Result<VertexKey, ApplyError> {
        self.index.vertices.get(&id).copied().ok_or(ApplyError::AnotherMap(Record::Vertex(id)))
    }

    fn drop_vertex(&mut self, id: u128) -> Result<VertexKey, ApplyError> {
        let key = self.vertex(id)?;
        if self.map.dcel.vertex(key)?.isolated().is_none() {
            return Err(ApplyError::AnotherMap(Record::Vertex(id)));
        }
        self.map.remove_vertex(key)?;
        self.index.vertices.remove(&id);
        Ok(key)
    }

    /// Drops a vertex that will be moved, with its edges.
    fn lift(&mut self, id: u128) -> Result<VertexKey, ApplyError> {
        let around = self.map.dcel.vertex(self.vertex(id)?)?.rotation();
        let edges: Vec<_> = around.map(|h| self.index.ends(h)).collect();
        for (a, b) in edges {
            let (a, b) = (a.min(b), a.max(b));
            let (sides, set) = self.erase(a, b)?;
            self.lifted.push((a, b, sides, set));
        }
        self.drop_vertex(id)
    }

    fn add(&mut self, id: u128, at: Point) -> Result<VertexKey, ApplyError> {
        if self.index.vertices.contains_key(&id) {
            return Err(ApplyError::AnotherMap(Record::Vertex(id)));
        }
        let edited = self.map.insert_point(at)?;
        let overlap = |with| Err(ApplyError::Overlap { drawn: Record::Vertex(id), with });
        let key = match edited.vertices[..] {
            [key] if !edited.vertices_made.is_empty() => key,
            [key] => return overlap(Record::Vertex(self.index.ids.get(key).copied().unwrap_or_default())),
            _ => return Err(ApplyError::AnotherMap(Record::Vertex(id))),
        };
        if let Some((before, after)) = edited.edges_split.first() {
            let [from, to] = [self.map.dcel.half_edge(*before)?.origin(), self.map.dcel.half_edge(*after)?.target()];
            let [a, b] = [from, to].map(|v| self.index.ids.get(v.key()).copied().unwrap_or_default());
            return overlap(Record::Edge(a.min(b), a.max(b)));
        }
        self.index.vertices.insert(id, key);
        self.index.ids.insert(key, id);
        Ok(key)
    }

    /// Erases an edge. Returns its half-edges and its features.
    fn erase(&mut self, a: u128, b: u128) -> Result<(Sides, SetId), ApplyError> {
        let key = self.index.edges.remove(&(a, b)).ok_or(ApplyError::AnotherMap(Record::Edge(a, b)))?;
        let h = self.map.dcel.half_edge(key)?;
        let erased = (Sides::new(h), self.map.features.along(h.index()));
        self.map.remove_edge(key)?;
        Ok(erased)
    }

    fn connect(&mut self, a: u128, b: u128) -> Result<Sides, ApplyError> {
        let (from, to) = (self.vertex(a.min(b))?, self.vertex(a.max(b))?);
        let drawn = Record::Edge(a.min(b), a.max(b));
        let edited = match self.map.insert_segment(from, to) {
            Err(EditError::Crosses(h)) => {
                let with = self.index.edge(self.map.dcel.half_edge(h)?);
                return Err(ApplyError::Overlap { drawn, with });
            }
            edited => edited?,
        };
        let dcel = &self.map.dcel;
        match edited.way[..] {
            [h] if !edited.edges_made.is_empty() => {
                let h = dcel.half_edge(h)?;
                self.index.put_edge(h);
                Ok(Sides::new(h))
            }
            [h, _, ..] => {
                let on_the_way = self.index.ends(dcel.half_edge(h)?).1;
                Err(ApplyError::Overlap { drawn, with: Record::Vertex(on_the_way) })
            }
            _ => Err(ApplyError::AnotherMap(drawn)),
        }
    }

    fn rename_edge(&mut self, old: Sides, new: Option<Sides>) {
        self.moved.push((Kind::Edge, old.edge.data(), new.map(|new| new.edge.data())));
        for side in 0..2 {
            let to = new.map(|new| new.half_edges[side].data());
            for kind in [Kind::HalfEdge, Kind::Corner] {
                self.moved.push((kind, old.half_edges[side].data(), to));
            }
        }
    }
}

impl Sides {
    /// The sides of the edge of `h`, which leaves the end with the smaller id.
    fn new(h: HalfEdge<'_>) -> Self {
        let twin = h.twin();
        let edge = if h.index() < twin.index() { h } else { twin };
        Self { half_edges: [h.key(), twin.key()], edge: edge.key() }
    }
}
