//! Data stored alongside a map, updated only from the reports of edits: it stays valid if they are true.

use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge_map::edit::Edited;
use twinedge_map::{FeatureId, PlanarMap};

type Set = BTreeSet<FeatureId>;

#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Shadow {
    vertices: BTreeSet<VertexKey>,
    /// Both half-edges of each edge, each with its twin and the features of the edge.
    edges: BTreeMap<HalfEdgeKey, (HalfEdgeKey, Set)>,
    faces: BTreeMap<FaceKey, Set>,
}

impl Shadow {
    pub(crate) fn of(map: &PlanarMap) -> Self {
        let along = |h: HalfEdgeKey| map.features_along(h).expect("it is of this map").collect();
        let covers = |f: FaceKey| map.features_of(f).expect("it is of this map").collect();
        Self {
            vertices: map.dcel().vertices().map(|v| v.key()).collect(),
            edges: map.dcel().half_edges().map(|h| (h.key(), (h.twin().key(), along(h.key())))).collect(),
            faces: map.dcel().faces().map(|f| (f.key(), covers(f.key()))).collect(),
        }
    }

    fn add_edge(&mut self, map: &PlanarMap, h: HalfEdgeKey, set: &Set) {
        let twin = map.dcel().half_edge(h).expect("it was made and is there").twin().key();
        for (h, twin) in [(h, twin), (twin, h)] {
            assert!(self.edges.insert(h, (twin, set.clone())).is_none(), "{h:?} is not new");
        }
    }

    /// Follows an edit that resulted in `map`.
    pub(crate) fn follow(&mut self, map: &PlanarMap, edited: &Edited) {
        for v in &edited.vertices_made {
            assert!(self.vertices.insert(*v), "{v:?} is not new");
        }
        for v in &edited.vertices_dropped {
            assert!(self.vertices.remove(v), "{v:?} was not there");
        }
        for (old, new) in &edited.edges_split {
            let set = self.edges[old].1.clone();
            self.add_edge(map, *new, &set);
        }
        for h in &edited.edges_dropped {
            let (twin, _) = self.edges.remove(h).expect("it was there");
            self.edges.remove(&twin);
        }
        let mut dropped = BTreeSet::new();
        for (kept, gone) in &edited.faces_merged {
            let other = self.faces.remove(gone).expect("it was there");
            let set = self.faces.get_mut(kept).expect("it was there");
            let common: Set = set.intersection(&other).copied().collect();
            dropped.extend(set.difference(&common).map(|feature| (*kept, *feature)));
            dropped.extend(other.difference(&common).map(|feature| (*gone, *feature)));
            *set = common;
        }
        assert_eq!(dropped, edited.features_dropped.iter().copied().collect());
        for h in &edited.edges_made {
            self.add_edge(map, *h, &Set::new());
        }
        for (old, new) in &edited.faces_split {
            let set = self.faces[old].clone();
            assert!(self.faces.insert(*new, set).is_none(), "{new:?} is not new");
        }
        for h in &edited.edges_relabelled {
            let set: Set = map.features_along(*h).expect("it is there").collect();
            let (twin, _) = self.edges[h];
            for (h, twin) in [(*h, twin), (twin, *h)] {
                self.edges.insert(h, (twin, set.clone()));
            }
        }
        for f in &edited.faces_relabelled {
            self.faces.insert(*f, map.features_of(*f).expect("it is there").collect());
        }
    }
}
