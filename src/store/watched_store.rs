//! A store that notes which records are written.

use super::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use super::links::{BoundaryStart, Links, Need, RecordKind, Store, VertexLink};
use crate::validate::near::WriteSet;

/// Another store, with a note of each record that was written.
///
/// [`Audited`](crate::dcel::Audited) keeps its structure in one.
#[derive(Clone, Debug)]
pub struct WatchedStore<S> {
    pub(crate) store: S,
    pub(crate) written: WriteSet,
}

impl<S: Links> WatchedStore<S> {
    fn vertex(&mut self, v: S::Vertex) {
        self.written.vertices.push(self.store.vertex_index(v));
    }
    fn half_edge(&mut self, h: S::HalfEdge) {
        self.written.half_edges.push(self.store.half_edge_index(h));
    }
    fn edge(&mut self, h: S::HalfEdge) {
        self.half_edge(h);
        self.half_edge(self.store.twin(h));
    }
    fn record(&mut self, b: S::Boundary) {
        self.written.boundaries.push(self.store.boundary_index(b));
    }
    fn list(&mut self, f: S::Face) {
        self.written.faces.push(self.store.face_index(f));
    }
    /// An entry of the list in which the boundary component is, and the face.
    fn entry(&mut self, b: S::Boundary) {
        let f = self.store.face(b);
        self.record(b);
        self.list(f);
        if self.store.outer(f) != Some(b) {
            self.written.listed.push((self.store.face_index(f), self.store.place(b) as usize));
        }
    }
}

impl<S: Store> Store for WatchedStore<S> {}

/// Questions, which are handed on.
macro_rules! questions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $answer:ty;)*) => {
        $(#[inline]
        fn $name(&self, $($argument: $type),*) -> $answer {
            self.store.$name($($argument),*)
        })*
    };
}

/// Records that are added, and then noted.
macro_rules! additions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $record:ty, $note:ident;)*) => {
        $(fn $name(&mut self, $($argument: $type),*) -> $record {
            let record = self.store.$name($($argument),*);
            self.$note(record);
            record
        })*
    };
}

/// Changes of records, which are noted first, while they are still there.
macro_rules! changes {
    ($($name:ident($($argument:ident: $type:ty),*), $($note:ident($noted:ident)),*;)*) => {
        $(fn $name(&mut self, $($argument: $type),*) {
            $(self.$note($noted);)*
            self.store.$name($($argument),*);
        })*
    };
}

impl<S: Links> Links for WatchedStore<S> {
    type Vertex = S::Vertex;
    type HalfEdge = S::HalfEdge;
    type Boundary = S::Boundary;
    type Face = S::Face;

    fn with_room(need: Need) -> Self {
        Self { store: S::with_room(need), written: WriteSet::default() }
    }

    questions! {
        unbounded() -> S::Face;
        room_for(need: Need) -> Result<(), RecordKind>;

        find_vertex(key: VertexKey) -> Option<S::Vertex>; find_half_edge(key: HalfEdgeKey) -> Option<S::HalfEdge>;
        find_boundary(key: BoundaryKey) -> Option<S::Boundary>; find_face(key: FaceKey) -> Option<S::Face>;
        vertex_key(v: S::Vertex) -> VertexKey; half_edge_key(h: S::HalfEdge) -> HalfEdgeKey;
        boundary_key(b: S::Boundary) -> BoundaryKey; face_key(f: S::Face) -> FaceKey;

        vertex_count() -> usize; edge_count() -> usize; boundary_count() -> usize; face_count() -> usize;
        vertex_slots() -> usize; half_edge_slots() -> usize; boundary_slots() -> usize; face_slots() -> usize;
        vertex_at(index: usize) -> Option<S::Vertex>; half_edge_at(index: usize) -> Option<S::HalfEdge>;
        boundary_at(index: usize) -> Option<S::Boundary>; face_at(index: usize) -> Option<S::Face>;
        origin_in(index: usize) -> Option<usize>; twin_in(index: usize) -> Option<usize>;
        next_in(index: usize) -> Option<usize>; prev_in(index: usize) -> Option<usize>;
        boundary_in(index: usize) -> Option<usize>;
        vertex_index(v: S::Vertex) -> usize; half_edge_index(h: S::HalfEdge) -> usize;
        boundary_index(b: S::Boundary) -> usize; face_index(f: S::Face) -> usize;

        origin(h: S::HalfEdge) -> S::Vertex; twin(h: S::HalfEdge) -> S::HalfEdge;
        next(h: S::HalfEdge) -> S::HalfEdge; prev(h: S::HalfEdge) -> S::HalfEdge;
        boundary(h: S::HalfEdge) -> S::Boundary;
        vertex_link(v: S::Vertex) -> VertexLink<S::HalfEdge, S::Boundary>;
        face(b: S::Boundary) -> S::Face;
        start(b: S::Boundary) -> BoundaryStart<S::HalfEdge, S::Vertex>;
        place(b: S::Boundary) -> u32;
        outer(f: S::Face) -> Option<S::Boundary>; outer_half_edge(f: S::Face) -> Option<S::HalfEdge>;
        inner_count(f: S::Face) -> usize; inner(f: S::Face, position: usize) -> Option<S::Boundary>;
    }

    additions! {
        add_vertex(link: VertexLink<S::HalfEdge, S::Boundary>) -> S::Vertex, vertex;
        add_edge(from: S::Vertex, to: S::Vertex, b: S::Boundary) -> S::HalfEdge, edge;
        add_boundary(f: S::Face, start: BoundaryStart<S::HalfEdge, S::Vertex>) -> S::Boundary, record;
        add_face() -> S::Face, list;
    }

    changes! {
        remove_vertex(v: S::Vertex), vertex(v);
        remove_edge(h: S::HalfEdge), edge(h);
        remove_boundary(b: S::Boundary), record(b);
        remove_face(f: S::Face), list(f);
        set_origin(h: S::HalfEdge, v: S::Vertex), half_edge(h);
        join(h: S::HalfEdge, n: S::HalfEdge), half_edge(h), half_edge(n);
        set_boundary(h: S::HalfEdge, b: S::Boundary), half_edge(h);
        set_vertex_link(v: S::Vertex, link: VertexLink<S::HalfEdge, S::Boundary>), vertex(v);
        set_start(b: S::Boundary, start: BoundaryStart<S::HalfEdge, S::Vertex>), record(b);
        set_place(b: S::Boundary, place: u32), record(b);
        list_outer(f: S::Face, b: S::Boundary), record(b), list(f);
    }

    fn add_isolated(&mut self, f: S::Face) -> (S::Vertex, S::Boundary) {
        let (v, b) = self.store.add_isolated(f);
        self.vertex(v);
        self.entry(b);
        (v, b)
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
