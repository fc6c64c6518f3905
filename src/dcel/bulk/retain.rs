//! Keeps some vertices and edges, and removes all others.

use super::nest::{Cycle, Group, Groups};
use crate::dcel::access::OperatorError;
use crate::dcel::elements::{HalfEdge, Vertex};
use crate::dcel::structure::Dcel;
use crate::numbers::NIL;
use crate::store::{
    BoundaryKey, BoundarySlot, BoundaryStart, FaceKey, FaceSlot, HalfEdgeKey, HalfEdgeSlot, OUTER, Room, Store,
    VertexKey, VertexLink, VertexSlot,
};
use alloc::vec;
use alloc::vec::Vec;

/// The records that [`Dcel::retain`] removed and made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Retained {
    /// The removed vertices.
    pub vertices: Vec<VertexKey>,
    /// The removed edges, each given by the half-edge with the smaller index.
    pub edges: Vec<HalfEdgeKey>,
    /// The removed faces, each with the face that contains it now.
    pub faces: Vec<MergedFace>,
    /// The removed boundary components.
    pub dropped: Vec<BoundaryKey>,
    /// The new boundary components.
    pub made: Vec<BoundaryKey>,
}

/// A face removed by [`Dcel::retain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MergedFace {
    /// Its key.
    pub dropped: FaceKey,
    /// The face that contains it now.
    pub kept: FaceKey,
}

impl Dcel {
    /// Removes all vertices and edges that fail a condition, in one pass. Removing a vertex removes its edges.
    ///
    /// The condition is evaluated first for the vertices, in order, then for each edge between kept vertices, given by the half-edge
    /// with the smaller index. Vertices without a remaining edge become isolated. The result is that of
    /// [`remove_edge`](Dcel::remove_edge) and [`remove_isolated_vertex`](Dcel::remove_isolated_vertex) in any order:
    ///
    /// - Kept vertices and half-edges keep their keys.
    /// - Of merged faces the unbounded face survives. Without it, the face to the left of the half-edge with the smallest index on the
    ///   new outer boundary component survives; no other merged face surrounds it.
    /// - A cycle keeps the boundary component whose start lies on it; of several, the one with the smallest index.
    ///
    /// The order of the inner boundary components changes in faces that lost an edge.
    ///
    /// O(slots α(slots)) time and O(slots) memory, no matter how many records are removed; α is the inverse of Ackermann's function, at
    /// most 4. To remove a few edges, remove them one by one.
    ///
    /// # Errors
    /// [`OperatorError::Full`] if there is no room for the additional boundary components.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// // Two triangles side by side, without the edge between them.
    /// let (mut map, keys) = Dcel::from_faces(4, [[0, 1, 2], [0, 2, 3]])?;
    /// let retained = map.retain(|_| true, |edge| edge.face().is_unbounded() || edge.twin().face().is_unbounded())?;
    /// assert_eq!(retained.edges, [keys.half_edge(2).unwrap()]);
    /// assert_eq!((retained.faces[0].dropped, retained.faces[0].kept), (keys.face(1).unwrap(), keys.face(0).unwrap()));
    /// assert_eq!((map.edge_count(), map.face_count()), (4, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn retain(
        &mut self,
        mut vertices: impl FnMut(Vertex<'_>) -> bool,
        mut edges: impl FnMut(HalfEdge<'_>) -> bool,
    ) -> Result<Retained, OperatorError> {
        let store = &self.store;
        let mut vertex_goes = vec![false; store.vertex_slots()];
        let mut goes = vec![false; store.half_edge_slots()];
        let mut removed = Vec::new();
        let mut retained = Retained::default();
        for v in self.vertices().filter(|v| !vertices(*v)) {
            vertex_goes[v.index()] = true;
            retained.vertices.push(v.key());
        }
        let any_goes = !retained.vertices.is_empty();
        for h in self.edges() {
            let loses_end = any_goes && (vertex_goes[h.origin().index()] || vertex_goes[h.target().index()]);
            if loses_end || !edges(h) {
                goes[h.index()] = true;
                goes[h.twin().index()] = true;
                retained.edges.push(h.key());
                removed.extend(store.half_edge_at(h.index()));
            }
        }
        if retained.vertices.is_empty() && retained.edges.is_empty() {
            return Ok(retained);
        }
        let groups = Groups::without(store, &removed);
        // Euler's formula yields the numbers of components and of boundary components.
        let [vertices, edges] = [self.vertex_count() - retained.vertices.len(), self.edge_count() - removed.len()];
        let boundaries = (vertices + 2 * groups.all.len() - 2 - edges).saturating_sub(self.boundary_count());
        self.room_for(Room { boundaries, ..Room::NONE })?;
        if self.attributes().is_some() {
            let merged = self.would_merge(&vertex_goes, &goes)?;
            self.follow(|dcel| dcel.steps_to_retain(&vertex_goes, &goes, &merged))?;
        }
        let mut work = Work { groups, goes, vertex_goes, retained };
        work.apply(self, &removed);
        Ok(work.retained)
    }
}

impl Dcel {
    /// Returns the faces that would merge. Policies of attributes must be consulted before anything changes, but the surviving faces
    /// are known only afterwards, so this runs on a copy. O(slots α(slots)).
    #[cold]
    fn would_merge(&self, vertex_goes: &[bool], goes: &[bool]) -> Result<Vec<MergedFace>, OperatorError> {
        let store = self.store.without_attributes();
        Ok(Dcel { store }.retain(|v| !vertex_goes[v.index()], |h| !goes[h.index()])?.faces)
    }
}

/// In place of a cycle number: a group with several cycles, a group whose cycle turned out to contain no component's start, and an
/// unchanged group.
const SEVERAL: u32 = NIL - 1;
const FRESH: u32 = NIL - 2;
const UNCHANGED: u32 = NIL - 3;

/// The work in progress, after room has been ensured.
struct Work {
    groups: Groups,
    /// True if the half-edge is removed or already has its boundary component.
    goes: Vec<bool>,
    vertex_goes: Vec<bool>,
    retained: Retained,
}

impl Work {
    fn apply(&mut self, dcel: &mut Dcel, removed: &[HalfEdgeSlot]) {
        let isolated = self.splice(dcel, removed);
        let store = &mut dcel.store;
        let mut islands = Vec::new();
        let (mut cycles, numbers) = self.keep_boundaries(store, &mut islands);
        let fresh = self.relabel_others(store, &mut cycles, numbers);
        for h in removed {
            store.remove_edge(*h);
        }
        for key in &self.retained.vertices {
            store.find_vertex(*key).into_iter().for_each(|v| store.remove_vertex(v));
        }
        for key in &self.retained.dropped {
            store.find_boundary(*key).into_iter().for_each(|b| store.remove_boundary(b));
        }
        for (start, group, face) in fresh {
            let boundary = store.add_boundary(face, BoundaryStart::HalfEdge(start));
            self.retained.made.push(store.boundary_key(boundary));
            let mut h = start;
            loop {
                store.set_boundary(h, boundary);
                h = store.next(h);
                if h == start {
                    break;
                }
            }
            cycles.push(Cycle { boundary, group: group as u32, face: Some(face) });
        }
        let outer = self.groups.outer(store, &cycles);
        let mut kept = vec![store.unbounded(); self.groups.all.len()];
        for Cycle { boundary, group, face } in &cycles {
            if outer[*group as usize] as usize == boundary.index() {
                let kept = &mut kept[*group as usize];
                *kept = face.unwrap_or(*kept);
                store.list_outer(*kept, *boundary);
            }
        }
        for Cycle { boundary, group, .. } in cycles {
            if outer[group as usize] as usize != boundary.index() {
                store.list_inner(kept[group as usize], boundary);
            }
        }
        for (v, group) in isolated {
            let made = store.add_boundary(kept[group], BoundaryStart::Vertex(v));
            self.retained.made.push(store.boundary_key(made));
            store.set_vertex_link(v, VertexLink::Isolated(made));
            store.list_inner(kept[group], made);
        }
        for (b, group) in islands {
            store.list_inner(kept[group], b);
        }
        self.merge_faces(store, &kept);
    }

    /// Unlinks the edges. Returns the kept vertices that become isolated, with their groups.
    fn splice(&mut self, dcel: &mut Dcel, removed: &[HalfEdgeSlot]) -> Vec<(VertexSlot, usize)> {
        let mut last = Vec::new();
        for h in removed {
            dcel.splice_out(*h, &mut last);
        }
        let store = &dcel.store;
        for v in self.retained.vertices.iter().filter_map(|key| store.find_vertex(*key)) {
            if let VertexLink::Isolated(b) = store.vertex_link(v) {
                self.groups.change(store, b);
            }
        }
        let mut isolated = Vec::new();
        for h in last {
            let (v, group) = (store.origin(h), self.groups.of_boundary(store, store.boundary(h)));
            self.groups.all[group].cycles -= 1;
            if !self.vertex_goes[v.index()] {
                isolated.push((v, group));
            }
        }
        isolated
    }

    /// Unlists all boundary components of changed groups. Returns those that remain cycles, and for each group the number of its only
    /// cycle, nil if unknown, or a special number. Appends remaining isolated vertices to `islands`, with their groups.
    fn keep_boundaries(
        &mut self,
        store: &mut Store,
        islands: &mut Vec<(BoundarySlot, usize)>,
    ) -> (Vec<Cycle>, Vec<u32>) {
        let number = |group: &Group| match group {
            Group { changes: false, .. } => UNCHANGED,
            Group { cycles: 1, .. } => NIL,
            _ => SEVERAL,
        };
        let mut numbers: Vec<u32> = self.groups.all.iter().map(number).collect();
        let mut cycles = Vec::new();
        for index in 0..store.boundary_slots() {
            let Some(boundary) = store.boundary_at(index) else { continue };
            let group = self.groups.of_boundary(store, boundary);
            let number = &mut numbers[group];
            if *number == UNCHANGED {
                continue;
            }
            // An outer one is removed with its face or replaced.
            if store.place(boundary) != OUTER {
                store.unlist(boundary);
            }
            match store.start(boundary) {
                BoundaryStart::HalfEdge(h) if (*number == NIL || *number == SEVERAL) && !self.goes[h.index()] => {
                    let face = if *number == SEVERAL {
                        Some(self.relabel(store, h, boundary))
                    } else {
                        *number = cycles.len() as u32;
                        None
                    };
                    cycles.push(Cycle { boundary, group: group as u32, face });
                }
                BoundaryStart::Vertex(v) if !self.vertex_goes[v.index()] => islands.push((boundary, group)),
                _ => self.retained.dropped.push(store.boundary_key(boundary)),
            }
        }
        (cycles, numbers)
    }

    /// Sets the boundary component of a cycle. Returns the old face to the left of its half-edge with the smallest index.
    fn relabel(&mut self, store: &mut Store, start: HalfEdgeSlot, boundary: BoundarySlot) -> FaceSlot {
        let mut least = (usize::MAX, boundary);
        let mut h = start;
        loop {
            let (index, before) = (h.index(), store.boundary(h));
            self.goes[index] = true;
            if index < least.0 {
                least = (index, before);
            }
            if before != boundary {
                store.set_boundary(h, boundary);
            }
            h = store.next(h);
            if h == start {
                return store.face(least.1);
            }
        }
    }

    /// Sets the boundary component of the half-edges of each group with one cycle, without a walk. Returns the cycles that contain no
    /// component's start, each with its half-edge of smallest index, the group, and the old face to the left of that half-edge.
    fn relabel_others(
        &mut self,
        store: &mut Store,
        cycles: &mut [Cycle],
        mut numbers: Vec<u32>,
    ) -> Vec<(HalfEdgeSlot, usize, FaceSlot)> {
        let mut fresh = Vec::new();
        for index in 0..self.goes.len() {
            if self.goes[index] {
                continue;
            }
            let Some(start) = store.half_edge_at(index) else { continue };
            let before = store.boundary(start);
            let face = store.face(before);
            let group = self.groups.of_face(face);
            let number = &mut numbers[group];
            if let Some(Cycle { boundary, face: of_first, .. }) = cycles.get_mut(*number as usize) {
                of_first.get_or_insert(face);
                if before != *boundary {
                    store.set_boundary(start, *boundary);
                }
                continue;
            }
            match *number {
                SEVERAL => {}
                NIL => *number = FRESH,
                _ => continue,
            }
            fresh.push((start, group, face));
            if *number == FRESH {
                continue;
            }
            let mut h = start;
            loop {
                self.goes[h.index()] = true;
                h = store.next(h);
                if h == start {
                    break;
                }
            }
        }
        fresh
    }

    fn merge_faces(&mut self, store: &mut Store, kept: &[FaceSlot]) {
        for index in 0..store.face_slots() {
            let Some(f) = store.face_at(index) else { continue };
            let group = self.groups.of_face(f);
            if self.groups.all[group].changes && kept[group] != f {
                self.retained.faces.push(MergedFace { dropped: store.face_key(f), kept: store.face_key(kept[group]) });
                store.remove_face(f);
            }
        }
    }
}
