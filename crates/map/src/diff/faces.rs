//! Assigning faces to ids on a map that has been drawn.
//!
//! Each side lists half-edges that bound a face. If two sides cut one face, neither knows the lines of the other, so one
//! half-edge may bound a part with one id for the first side, and with another id for the second.
//!
//! ```text
//!     ┌─────┬─────┬─────┐     one side draws the left line, and calls the parts 1 and 2,
//!     │  1  │ 1 2 │ 2 3 │     the other one the right line: 1 and 3
//!     └─────┴─────┴─────┘
//! ```
//!
//! So several ids may claim a face, and an id may claim several faces. A face claimed by a single id gets this id, and an id that
//! claims a single face gets this face. Dropping the other claims on both may in turn leave others with a single claim. Here 1 is
//! to the left, 3 to the right, and 2 between:
//!
//! Cycles of claims remain: for one side 1 is to the left and 2 to the right, and for the other side the reverse. Both
//! assignments give each face an id, and both are valid if the faces have the same features and values: only ids tell them apart.

use super::Diff;
use super::apply::Drawing;
use super::error::ApplyError;
use super::ids::{Ids, Index};
use super::record::{Change, Record};
use crate::PlanarMap;
use rustc_hash::FxHashMap;
use slotmap::Key;
use std::collections::{BTreeMap, BTreeSet};
use std::mem;
use twinedge::dcel::extend::Kind;
use twinedge::dcel::{FaceKey, HalfEdge};

/// The ids of the ends of a half-edge. The smallest such pair among the half-edges said to bound a face stands for the face.
type Ends = (u128, u128);

/// The features and values of faces, by id.
pub(super) type Contents = BTreeMap<u128, (Vec<usize>, BTreeMap<String, String>)>;

impl Diff {
    /// Returns the final contents of new faces and of faces that both sides reshaped.
    pub(super) fn contents(&self, map: &PlanarMap, base: &Index, ids: &Ids) -> Contents {
        let (mut all, mut reshaped) = (Contents::new(), BTreeSet::new());
        for (record, change) in &self.changes {
            let Record::Face(id) = *record else { continue };
            match change {
                Change::Made(_) => drop(all.entry(id).or_default()),
                Change::Reshaped(_) if !reshaped.insert(id) => {
                    let value = |name: &String, get: &dyn Fn(&PlanarMap, _) -> Option<String>| {
                        Some((name.clone(), get(map, base.key(map, *record)?)?))
                    };
                    let columns = ids.values.iter().filter(|column| column.kind == Kind::Face);
                    let values = columns.filter_map(|column| value(&column.name, &column.get)).collect();
                    all.insert(id, (base.features(map, *record), values));
                }
                Change::Features { to, .. } => {
                    all.entry(id).and_modify(|(features, _)| features.clone_from(to));
                }
                Change::Value { name, to, .. } => {
                    all.entry(id).and_modify(|(_, values)| {
                        values.remove(name);
                        values.extend(to.clone().map(|to| (name.clone(), to)));
                    });
                }
                _ => {}
            }
        }
        all
    }

    /// Returns the half-edges said to bound the face of each id.
    fn outlines(&self, drawing: &Drawing<'_>) -> Result<BTreeMap<u128, Vec<Ends>>, ApplyError> {
        let kept = drawing.faces.iter().map(|(id, (from, to, _))| (*id, vec![(*from, *to)]));
        let mut outlines: BTreeMap<u128, Vec<Ends>> = kept.collect();
        let mut shaped = BTreeSet::new();
        for (record, change) in &self.changes {
            match (*record, change) {
                (Record::Face(id), Change::Dropped) => drop(outlines.remove(&id)),
                (Record::Face(id), Change::Made(outline) | Change::Reshaped(outline)) => {
                    let known = outlines.entry(id).or_default();
                    if shaped.insert(id) {
                        known.clear();
                    } else if matches!(change, Change::Made(_)) {
                        return Err(ApplyError::NotOneFace(*record));
                    }
                    known.extend(outline.iter().copied().zip(outline.iter().copied().cycle().skip(1)));
                }
                _ => {}
            }
        }
        Ok(outlines)
    }
}

impl Drawing<'_> {
    /// Finds the face of each id and moves the features of the id to it.
    pub(super) fn name_faces(&mut self, diff: &Diff, contents: &Contents) -> Result<(), ApplyError> {
        let unbounded = self.map.dcel.unbounded_face();
        let mut sets = vec![(unbounded.index(), self.unbounded)];
        let mut faces = BTreeMap::new();
        for (id, face) in self.matched(diff, contents)? {
            faces.insert(id, face);
            let set = self.faces.get(&id).map(|(_, _, set)| *set).unwrap_or_default();
            sets.push((self.map.dcel.face(face)?.index(), set));
        }
        if sets.len() < self.map.dcel.face_count() {
            let named: BTreeSet<FaceKey> = faces.values().copied().chain([unbounded.key()]).collect();
            let face = self.map.dcel.faces().find(|face| !named.contains(&face.key()));
            let edge = face.and_then(|face| face.outer_half_edge()).map(|h| self.index.edge(h));
            return Err(ApplyError::Unnamed(edge.unwrap_or(Record::Unbounded)));
        }
        for (face, set) in sets {
            if self.map.features.of_face(face) != set {
                self.map.cover_face(face, set);
            }
        }
        let old = mem::replace(&mut self.index.faces, faces);
        let data = |id| self.index.faces.get(id).map(|face: &FaceKey| face.data());
        let moved = old.iter().map(|(id, key)| (Kind::Face, key.data(), data(id)));
        self.moved.extend(moved.filter(|(_, from, to)| Some(*from) != *to));
        Ok(())
    }

    /// Returns the face of each id. O(n log n).
    fn matched(&self, diff: &Diff, contents: &Contents) -> Result<Vec<(u128, FaceKey)>, ApplyError> {
        let mut said = Vec::new();
        let mut ends_of: FxHashMap<FaceKey, Ends> = FxHashMap::default();
        for (id, outline) in diff.outlines(self)? {
            let mut error = ApplyError::NotOneFace(Record::Face(id));
            let before = said.len();
            for ends in outline {
                // A side may know only part of the outline of a face.
                let Some(face) = self.index.half_edge(self.map, ends.0, ends.1).map(HalfEdge::face) else { continue };
                if face.is_unbounded() {
                    error = ApplyError::OneFace(Record::Unbounded, Record::Face(id));
                    continue;
                }
                let least = ends_of.entry(face.key()).or_insert(ends);
                *least = ends.min(*least);
                said.push((id, face.key()));
            }
            if said.len() == before {
                return Err(error);
            }
        }
        let mut open = Open::default();
        for (id, face) in said {
            open.faces_of.entry(id).or_default().insert(ends_of[&face]);
            open.ids_of.entry(ends_of[&face]).or_default().insert(id);
        }
        let are_alike = |ids: &BTreeSet<u128>| {
            let mut all = ids.iter().map(|id| contents.get(id));
            let first = all.next().flatten();
            first.is_some()
                && all.all(|other| other == first)
                && ids.iter().filter(|id| self.faces.contains_key(id)).count() < 2
        };
        let face = |(id, ends): (u128, Ends)| Some((id, self.index.half_edge(self.map, ends.0, ends.1)?.face().key()));
        Ok(open.matched(are_alike)?.into_iter().filter_map(face).collect())
    }
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Node {
    Face(Ends),
    Id(u128),
}

/// Faces and ids that still claim several of each other.
#[derive(Default)]
struct Open {
    faces_of: BTreeMap<u128, BTreeSet<Ends>>,
    ids_of: BTreeMap<Ends, BTreeSet<u128>>,
}

impl Open {
    /// Assigns a face to each id. Some faces may remain.
    fn matched(mut self, are_alike: impl Fn(&BTreeSet<u128>) -> bool) -> Result<Vec<(u128, Ends)>, ApplyError> {
        let mut matched = Vec::new();
        let faces = self.ids_of.iter().filter(|(_, ids)| ids.len() == 1).map(|(face, _)| Node::Face(*face));
        let ids = self.faces_of.iter().filter(|(_, faces)| faces.len() == 1).map(|(id, _)| Node::Id(*id));
        // Faces and ids with a single claim left.
        let mut ready: BTreeSet<Node> = faces.chain(ids).collect();
        loop {
            let next = match ready.pop_first() {
                Some(Node::Face(face)) => self.ids_of.get(&face).and_then(|ids| Some((*ids.first()?, face))),
                Some(Node::Id(id)) => self.faces_of.get(&id).and_then(|faces| Some((id, *faces.first()?))),
                None => {
                    let Some((id, faces)) = self.faces_of.first_key_value() else { return Ok(matched) };
                    let face = faces.first().filter(|_| are_alike(&self.ring(*id)));
                    Some((*id, *face.ok_or(ApplyError::NotOneFace(Record::Face(*id)))?))
                }
            };
            let Some((id, face)) = next else { continue };
            matched.push((id, face));
            for other in self.faces_of.remove(&id).into_iter().flatten().filter(|other| *other != face) {
                let ids = self.ids_of.entry(other).or_default();
                ids.remove(&id);
                if ids.len() == 1 {
                    ready.insert(Node::Face(other));
                }
            }
            for other in self.ids_of.remove(&face).into_iter().flatten().filter(|other| *other != id) {
                let faces = self.faces_of.entry(other).or_default();
                faces.remove(&face);
                match faces.len() {
                    0 => return Err(ApplyError::OneFace(Record::Face(id), Record::Face(other))),
                    1 => drop(ready.insert(Node::Id(other))),
                    _ => {}
                }
            }
        }
    }

    /// Returns the ids reachable from this id through shared faces.
    fn ring(&self, id: u128) -> BTreeSet<u128> {
        let (mut reached, mut ahead) = (BTreeSet::from([id]), vec![id]);
        while let Some(id) = ahead.pop() {
            for face in self.faces_of.get(&id).into_iter().flatten() {
                ahead.extend(self.ids_of.get(face).into_iter().flatten().filter(|other| reached.insert(**other)));
            }
        }
        reached
    }
}

#[cfg(test)]
mod tests;
