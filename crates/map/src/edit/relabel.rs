//! The features of faces after edges came to lie on each other.

use super::error::EditError;
use super::outcome::Edited;
use super::plan::{EdgeChange, SnapPlan};
use super::trace::Towards;
use crate::feature_tries::SetId;
use crate::planar_map::PlanarMap;
use rustc_hash::FxHashMap;
use twinedge::dcel::{FaceKey, VertexKey};

/// An edge of the map after the edit.
#[derive(Default)]
struct Border {
    /// The features that cover only one of its two sides.
    turns: SetId,
    /// The number of edges of the region that now run here.
    users: usize,
}

/// The features that cover each face, as far as they are known.
#[derive(Default)]
struct KnownCovers {
    sets: FxHashMap<FaceKey, SetId>,
    /// The faces in the order in which they became known.
    order: Vec<FaceKey>,
}

impl KnownCovers {
    fn learn(&mut self, face: FaceKey, set: SetId) {
        if self.sets.insert(face, set).is_none() {
            self.order.push(face);
        }
    }
}

impl PlanarMap {
    /// Recomputes the features of the faces of a region. `outside` covered the unbounded face before.
    ///
    /// Crossing an edge of the old drawing turned some features on or off. The deformed drawing does the same, one edge after the
    /// other where several coincide. So known features of faces propagate across the edges. O(size of the region).
    pub(super) fn relabel(&mut self, plan: &SnapPlan, outside: SetId, edited: &mut Edited) -> Result<(), EditError> {
        let changed: FxHashMap<usize, &EdgeChange> = plan.changes.iter().map(|change| (change.edge, change)).collect();
        let between = |pair: &[u32]| [plan.vertices[&pair[0]], plan.vertices[&pair[1]]];
        let mut borders: FxHashMap<usize, Border> = FxHashMap::default();
        for (i, edge) in plan.region.edges.iter().enumerate() {
            let turns = self.features.differing(edge.covers[0], edge.covers[1]);
            let pieces: Vec<[VertexKey; 2]> = match changed.get(&i) {
                Some(change) => change.chain.windows(2).map(between).collect(),
                None => vec![edge.ends],
            };
            for piece in pieces {
                let border = borders.entry(self.edge_between(piece)?).or_default();
                border.turns = self.features.differing(border.turns, turns);
                border.users += 1;
            }
        }
        for pair in plan.way.windows(2) {
            borders.entry(self.edge_between(between(pair))?).or_default();
        }

        let mut known = KnownCovers::default();
        known.learn(self.dcel.unbounded_face().key(), outside);
        for (i, edge) in plan.region.edges.iter().enumerate() {
            if changed.contains_key(&i) {
                continue;
            }
            let h = self.dcel.half_edge(edge.key)?;
            let alone = borders.get(&(h.index() / 2)).is_some_and(|border| border.users == 1);
            for ((side, set), inside) in [h, h.twin()].into_iter().zip(edge.covers).zip(edge.inside) {
                if alone || !inside {
                    known.learn(side.face().key(), set);
                }
            }
        }
        let mut next = 0;
        while let Some(key) = known.order.get(next).copied() {
            next += 1;
            let set = known.sets[&key];
            for h in self.dcel.face(key)?.half_edges() {
                let across = h.twin().face().key();
                let border = borders.get(&(h.index() / 2)).filter(|_| !known.sets.contains_key(&across));
                if let Some(border) = border {
                    known.learn(across, self.features.differing(set, border.turns));
                }
            }
        }
        for face in known.order {
            let index = self.dcel.face(face)?.index();
            let set = known.sets[&face];
            if self.features.of_face(index) != set {
                self.cover_face(index, set);
                edited.faces_relabelled.push(face);
            }
        }
        Ok(())
    }

    /// Returns the edge between two vertices, as half the index of its half-edges.
    fn edge_between(&self, [v, w]: [VertexKey; 2]) -> Result<usize, EditError> {
        let (v, w) = (self.dcel.vertex(v)?, self.dcel.vertex(w)?);
        match self.towards(v, self.at(w)) {
            Towards::Along(h) => Ok(h.index() / 2),
            Towards::Corner(_) | Towards::Isolated => Ok(usize::MAX),
        }
    }
}
