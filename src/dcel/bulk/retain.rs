//! Keeping some vertices and edges and removing all others.

use super::nest::{Nest, Rest};
use crate::dcel::elements::{HalfEdge, Vertex};
use crate::dcel::error::OperatorError;
use crate::dcel::import::gather::NIL;
use crate::dcel::structure::Dcel;
use crate::store::links::{BoundaryStart, Need, VertexLink};
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, Store, VertexKey};
use alloc::vec;
use alloc::vec::Vec;

/// What [`Dcel::retain`] dropped, and what it made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Retained {
    /// The vertices that were removed.
    pub vertices: Vec<VertexKey>,
    /// The edges that were removed: of each the half-edge with the smaller index.
    pub edges: Vec<HalfEdgeKey>,
    /// The faces that were removed, each with the one that it is part of now.
    pub faces: Vec<MergedFace>,
    /// The boundary components that were removed.
    pub dropped: Vec<BoundaryKey>,
    /// The boundary components that are new.
    pub made: Vec<BoundaryKey>,
}

/// A face that was removed by [`Dcel::retain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MergedFace {
    /// Its key.
    pub dropped: FaceKey,
    /// The face that has its place now.
    pub kept: FaceKey,
}

impl<S: Store> Dcel<S> {
    /// Removes all vertices and edges for which a condition does not hold, in one pass. An edge goes with either of its ends.
    ///
    /// The vertices are asked first, in order; then of each edge whose ends stay the half-edge with the smaller index. Vertices
    /// that have no edge left become isolated. What is left is what [`remove_edge`](Dcel::remove_edge) and
    /// [`remove_isolated_vertex`](Dcel::remove_isolated_vertex) leave, one after the other, in any order:
    ///
    /// - Vertices and half-edges that stay keep their keys.
    /// - Of faces that become one the unbounded face is kept. If it is not among them, it is the one to the left of the
    ///   half-edge with the smallest index on the new outer boundary component: never one that another of them surrounds.
    /// - A boundary component is kept by the cycle on which its start is then. If several starts come to lie on one cycle,
    ///   that with the smallest index is kept.
    ///
    /// The order of the inner boundary components of a face that lost an edge changes.
    ///
    /// O(slots) time and memory, however much goes. So a few edges are better removed one by one, and so are edges that separate
    /// short cycles, one place after the other.
    ///
    /// # Errors
    /// [`OperatorError::Full`] if more boundary components are made than dropped, and there is no room for them.
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
        mut vertices: impl FnMut(Vertex<'_, S>) -> bool,
        mut edges: impl FnMut(HalfEdge<'_, S>) -> bool,
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
        for h in self.edges() {
            if vertex_goes[h.origin().index()] || vertex_goes[h.target().index()] || !edges(h) {
                goes[h.index()] = true;
                goes[h.twin().index()] = true;
                retained.edges.push(h.key());
                removed.extend(store.half_edge_at(h.index()));
            }
        }
        if retained.vertices.is_empty() && retained.edges.is_empty() {
            return Ok(retained);
        }
        let rest = Rest { dcel: self, goes: &goes, edges: &removed };
        let nest = rest.nest();
        let plan = Plan::new(&rest, &nest, &vertex_goes);
        let boundaries = plan.made.saturating_sub(plan.dropped.len());
        self.room_for(Need { boundaries, ..Need::NONE })?;
        plan.apply(&mut self.store, &nest, &removed, &mut retained);
        Ok(retained)
    }
}

/// What is to be done, found out before anything is changed.
struct Plan<S: Store> {
    /// By group, whether it loses an edge or a vertex. What belongs to the others stays as it is.
    changes: Vec<bool>,
    /// By group the face that is kept.
    kept: Vec<S::Face>,
    vertices: Vec<S::Vertex>,
    faces: Vec<S::Face>,
    dropped: Vec<S::Boundary>,
    /// How many boundary components are new.
    made: usize,
    /// By cycle the boundary component that it keeps.
    cycles: Vec<Option<S::Boundary>>,
    /// Vertices that keep another half-edge.
    leaving: Vec<(S::Vertex, S::HalfEdge)>,
    /// Vertices that become isolated, and their groups.
    isolated: Vec<(S::Vertex, u32)>,
    /// The boundary components of isolated vertices that stay, and their groups.
    islands: Vec<(S::Boundary, u32)>,
}

impl<S: Store> Plan<S> {
    fn new(rest: &Rest<'_, S>, nest: &Nest<S>, vertex_goes: &[bool]) -> Self {
        let store = &rest.dcel.store;
        let face_at = |h: S::HalfEdge| store.face(store.boundary(h));
        let group = |f: S::Face| nest.group_of[store.face_index(f)];
        let kept = core::iter::once(store.unbounded())
            .chain(nest.outer.iter().skip(1).map(|cycle| face_at(nest.starts[*cycle as usize])));
        let mut plan = Self {
            changes: vec![false; nest.outer.len()],
            kept: kept.collect(),
            vertices: Vec::new(),
            faces: Vec::new(),
            dropped: Vec::new(),
            made: 0,
            cycles: vec![None; nest.starts.len()],
            leaving: Vec::new(),
            isolated: Vec::new(),
            islands: Vec::new(),
        };
        for h in rest.edges {
            plan.changes[group(face_at(*h)) as usize] = true;
        }
        for (v, goes) in vertex_goes.iter().enumerate().filter_map(|(i, goes)| Some((store.vertex_at(i)?, *goes))) {
            match store.vertex_link(v) {
                _ if goes => plan.vertices.push(v),
                VertexLink::Leaving(h) if rest.goes(h) => match rest.leaving(v) {
                    Some(h) => plan.leaving.push((v, h)),
                    None => plan.isolated.push((v, group(face_at(h)))),
                },
                _ => {}
            }
            if let (true, VertexLink::Isolated(b)) = (goes, store.vertex_link(v)) {
                plan.changes[group(store.face(b)) as usize] = true;
            }
        }
        plan.boundaries(rest, nest, vertex_goes);
        let is_dropped = |f: &S::Face| plan.kept[group(*f) as usize] != *f;
        plan.faces = (0..store.face_slots()).filter_map(|i| store.face_at(i)).filter(is_dropped).collect();
        plan
    }

    /// Finds out which boundary components stay, where something changes.
    fn boundaries(&mut self, rest: &Rest<'_, S>, nest: &Nest<S>, vertex_goes: &[bool]) {
        let store = &rest.dcel.store;
        for b in (0..store.boundary_slots()).filter_map(|i| store.boundary_at(i)) {
            let group = nest.group_of[store.face_index(store.face(b))];
            if !self.changes[group as usize] {
                continue;
            }
            match store.start(b) {
                BoundaryStart::Vertex(v) if !vertex_goes[store.vertex_index(v)] => self.islands.push((b, group)),
                BoundaryStart::HalfEdge(start) if !rest.goes(start) => {
                    let cycle = &mut self.cycles[nest.cycle_of[store.half_edge_index(start)] as usize];
                    if cycle.is_none() {
                        *cycle = Some(b);
                    } else {
                        self.dropped.push(b);
                    }
                }
                _ => self.dropped.push(b),
            }
        }
        let new = self.changing_cycles(nest).filter(|cycle| self.cycles[*cycle].is_none()).count();
        self.made = new + self.isolated.len();
    }

    /// The cycles of groups in which something changes.
    fn changing_cycles(&self, nest: &Nest<S>) -> impl Iterator<Item = usize> {
        (0..nest.starts.len()).filter(|cycle| self.changes[nest.group_of_cycle[*cycle] as usize])
    }

    fn apply(mut self, store: &mut S, nest: &Nest<S>, edges: &[S::HalfEdge], retained: &mut Retained) {
        for index in 0..store.boundary_slots() {
            let Some(b) = store.boundary_at(index) else { continue };
            if self.changes[nest.group_of[store.face_index(store.face(b))] as usize] {
                store.unlist(b);
            }
        }
        for [h, next] in &nest.joins {
            store.join(*h, *next);
        }
        for (v, h) in self.leaving {
            store.set_vertex_link(v, VertexLink::Leaving(h));
        }
        for h in edges {
            store.remove_edge(*h);
        }
        for v in self.vertices {
            store.remove_vertex(v);
        }
        for b in self.dropped {
            retained.dropped.push(store.boundary_key(b));
            store.remove_boundary(b);
        }
        for (cycle, group) in (0..).zip(&nest.group_of_cycle) {
            if !self.changes[*group as usize] {
                continue;
            }
            let face = self.kept[*group as usize];
            let b = *self.cycles[cycle].get_or_insert_with(|| {
                let made = store.add_boundary(face, BoundaryStart::HalfEdge(nest.starts[cycle]));
                retained.made.push(store.boundary_key(made));
                made
            });
            if nest.outer[*group as usize] == cycle as u32 {
                store.list_outer(face, b);
            } else {
                store.list_inner(face, b);
            }
        }
        for (index, cycle) in nest.cycle_of.iter().enumerate().filter(|(_, cycle)| **cycle != NIL) {
            let (Some(h), Some(b)) = (store.half_edge_at(index), self.cycles[*cycle as usize]) else { continue };
            if store.boundary(h) != b {
                store.set_boundary(h, b);
            }
        }
        for (v, group) in self.isolated {
            let face = self.kept[group as usize];
            let made = store.add_boundary(face, BoundaryStart::Vertex(v));
            retained.made.push(store.boundary_key(made));
            store.set_vertex_link(v, VertexLink::Isolated(made));
            store.list_inner(face, made);
        }
        for (b, group) in self.islands {
            store.list_inner(self.kept[group as usize], b);
        }
        for f in self.faces {
            let kept = self.kept[nest.group_of[store.face_index(f)] as usize];
            retained.faces.push(MergedFace { dropped: store.face_key(f), kept: store.face_key(kept) });
            store.remove_face(f);
        }
    }
}
