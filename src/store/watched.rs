//! A store that notes which records are written.

use super::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use super::links::{BoundaryStart, Links, Need, RecordKind, Store, VertexLink};
use crate::validate::near::Touched;

/// Another store, with a note of each record that was written since the notes were last taken.
///
/// [`Audited`](crate::dcel::Audited) keeps its structure in one.
#[derive(Clone, Debug)]
pub struct Watched<S> {
    store: S,
    touched: Touched,
}

impl<S: Links> Watched<S> {
    pub(crate) fn new(store: S) -> Self {
        Self { store, touched: Touched::default() }
    }

    /// One that goes on with notes.
    #[cfg(feature = "map")]
    pub(crate) const fn with_notes(store: S, touched: Touched) -> Self {
        Self { store, touched }
    }

    pub(crate) fn into_inner(self) -> S {
        self.store
    }

    /// The store, and what was written.
    #[cfg(feature = "map")]
    pub(crate) fn into_parts(self) -> (S, Touched) {
        (self.store, self.touched)
    }

    /// Returns the records written since this was last cleared.
    pub(crate) const fn touched(&self) -> &Touched {
        &self.touched
    }

    /// The same, to be cleared.
    pub(crate) const fn touched_mut(&mut self) -> &mut Touched {
        &mut self.touched
    }

    fn vertex(&mut self, v: S::Vertex) {
        self.touched.vertices.push(self.store.vertex_index(v));
    }
    fn half_edge(&mut self, h: S::HalfEdge) {
        self.touched.half_edges.push(self.store.half_edge_index(h));
    }
    fn edge(&mut self, h: S::HalfEdge) {
        self.half_edge(h);
        self.half_edge(self.store.twin(h));
    }
    fn record(&mut self, b: S::Boundary) {
        self.touched.boundaries.push(self.store.boundary_index(b));
    }
    fn list(&mut self, f: S::Face) {
        self.touched.faces.push(self.store.face_index(f));
    }
    /// An entry of the list in which the boundary component is, and the face.
    fn entry(&mut self, b: S::Boundary) {
        let f = self.store.face(b);
        self.record(b);
        self.list(f);
        if self.store.outer(f) != Some(b) {
            self.touched.listed.push((self.store.face_index(f), self.store.place(b) as usize));
        }
    }
}

impl<S: Store> Store for Watched<S> {}

/// Delegates the methods that only read.
macro_rules! read {
    ($($name:ident($($argument:ident: $type:ty),*) -> $answer:ty;)*) => {
        $(#[inline]
        fn $name(&self, $($argument: $type),*) -> $answer {
            self.store.$name($($argument),*)
        })*
    };
}

impl<S: Links> Links for Watched<S> {
    type Vertex = S::Vertex;
    type HalfEdge = S::HalfEdge;
    type Boundary = S::Boundary;
    type Face = S::Face;

    fn with_room(need: Need) -> Self {
        Self::new(S::with_room(need))
    }

    read! {
        unbounded() -> S::Face;
        room_for(need: Need) -> Result<(), RecordKind>;
        find_vertex(key: VertexKey) -> Option<S::Vertex>;
        find_half_edge(key: HalfEdgeKey) -> Option<S::HalfEdge>;
        find_boundary(key: BoundaryKey) -> Option<S::Boundary>;
        find_face(key: FaceKey) -> Option<S::Face>;
        vertex_key(v: S::Vertex) -> VertexKey;
        half_edge_key(h: S::HalfEdge) -> HalfEdgeKey;
        boundary_key(b: S::Boundary) -> BoundaryKey;
        face_key(f: S::Face) -> FaceKey;
        vertex_count() -> usize;
        edge_count() -> usize;
        boundary_count() -> usize;
        face_count() -> usize;
        vertex_slots() -> usize;
        half_edge_slots() -> usize;
        boundary_slots() -> usize;
        face_slots() -> usize;
        vertex_at(index: usize) -> Option<S::Vertex>;
        half_edge_at(index: usize) -> Option<S::HalfEdge>;
        boundary_at(index: usize) -> Option<S::Boundary>;
        face_at(index: usize) -> Option<S::Face>;
        origin_in(index: usize) -> Option<usize>;
        twin_in(index: usize) -> Option<usize>;
        next_in(index: usize) -> Option<usize>;
        prev_in(index: usize) -> Option<usize>;
        boundary_in(index: usize) -> Option<usize>;
        vertex_index(v: S::Vertex) -> usize;
        half_edge_index(h: S::HalfEdge) -> usize;
        boundary_index(b: S::Boundary) -> usize;
        face_index(f: S::Face) -> usize;
        origin(h: S::HalfEdge) -> S::Vertex;
        twin(h: S::HalfEdge) -> S::HalfEdge;
        next(h: S::HalfEdge) -> S::HalfEdge;
        prev(h: S::HalfEdge) -> S::HalfEdge;
        boundary(h: S::HalfEdge) -> S::Boundary;
        vertex_link(v: S::Vertex) -> VertexLink<S::HalfEdge, S::Boundary>;
        face(b: S::Boundary) -> S::Face;
        start(b: S::Boundary) -> BoundaryStart<S::HalfEdge, S::Vertex>;
        place(b: S::Boundary) -> u32;
        outer(f: S::Face) -> Option<S::Boundary>;
        outer_half_edge(f: S::Face) -> Option<S::HalfEdge>;
        inner_count(f: S::Face) -> usize;
        inner(f: S::Face, position: usize) -> Option<S::Boundary>;
    }

    fn add_vertex(&mut self, link: VertexLink<S::HalfEdge, S::Boundary>) -> S::Vertex {
        let v = self.store.add_vertex(link);
        self.vertex(v);
        v
    }
    fn add_isolated(&mut self, f: S::Face) -> (S::Vertex, S::Boundary) {
        let (v, b) = self.store.add_isolated(f);
        self.vertex(v);
        self.entry(b);
        (v, b)
    }
    fn add_edge(&mut self, from: S::Vertex, to: S::Vertex, b: S::Boundary) -> S::HalfEdge {
        let h = self.store.add_edge(from, to, b);
        self.edge(h);
        h
    }
    fn add_boundary(&mut self, f: S::Face, start: BoundaryStart<S::HalfEdge, S::Vertex>) -> S::Boundary {
        let b = self.store.add_boundary(f, start);
        self.record(b);
        b
    }
    fn add_face(&mut self) -> S::Face {
        let f = self.store.add_face();
        self.list(f);
        f
    }

    fn remove_vertex(&mut self, v: S::Vertex) {
        self.vertex(v);
        self.store.remove_vertex(v);
    }
    fn remove_edge(&mut self, h: S::HalfEdge) {
        self.edge(h);
        self.store.remove_edge(h);
    }
    fn remove_boundary(&mut self, b: S::Boundary) {
        self.record(b);
        self.store.remove_boundary(b);
    }
    fn remove_face(&mut self, f: S::Face) {
        self.list(f);
        self.store.remove_face(f);
    }

    fn set_origin(&mut self, h: S::HalfEdge, v: S::Vertex) {
        self.half_edge(h);
        self.store.set_origin(h, v);
    }
    fn join(&mut self, h: S::HalfEdge, n: S::HalfEdge) {
        self.half_edge(h);
        self.half_edge(n);
        self.store.join(h, n);
    }
    fn set_boundary(&mut self, h: S::HalfEdge, b: S::Boundary) {
        self.half_edge(h);
        self.store.set_boundary(h, b);
    }
    fn set_vertex_link(&mut self, v: S::Vertex, link: VertexLink<S::HalfEdge, S::Boundary>) {
        self.vertex(v);
        self.store.set_vertex_link(v, link);
    }
    fn set_start(&mut self, b: S::Boundary, start: BoundaryStart<S::HalfEdge, S::Vertex>) {
        self.record(b);
        self.store.set_start(b, start);
    }
    fn set_place(&mut self, b: S::Boundary, place: u32) {
        self.record(b);
        self.store.set_place(b, place);
    }

    fn list_outer(&mut self, f: S::Face, b: S::Boundary) {
        self.record(b);
        self.list(f);
        self.store.list_outer(f, b);
    }
    fn list_inner(&mut self, f: S::Face, b: S::Boundary) {
        self.store.list_inner(f, b);
        self.entry(b);
    }
    fn unlist(&mut self, b: S::Boundary) {
        let f = self.store.face(b);
        // The last of the list moves to its place.
        if let Some(last) = self.store.inner_count(f).checked_sub(1).and_then(|last| self.store.inner(f, last)) {
            self.entry(last);
        }
        self.entry(b);
        self.store.unlist(b);
    }
}
