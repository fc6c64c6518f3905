//! The trait of those who are told what operators write.

use super::links::{Links, Store};
use crate::validate::near::WriteSet;

/// Is told of everything that is written to a store just before it happens, and of records that are added once they are there, too.
///
/// Public in name only, as [`Links`] is.
#[allow(missing_docs, reason = "one method for each that writes to a store, by its name")]
pub trait Watch<S: Links>: Default {
    /// True if the log of attributes is taken after each operator.
    const RECORDS: bool = false;

    fn add_vertex(&mut self, _store: &mut S) {}
    fn add_isolated(&mut self, _store: &mut S) {}
    fn add_edge(&mut self, _store: &mut S) {}
    fn add_boundary(&mut self, _store: &mut S) {}
    fn added_vertex(&mut self, store: &mut S, v: S::Vertex);
    fn added_isolated(&mut self, store: &mut S, v: S::Vertex, b: S::Boundary);
    /// One of the two half-edges is named, here and below.
    fn added_edge(&mut self, store: &mut S, h: S::HalfEdge);
    fn added_boundary(&mut self, store: &mut S, b: S::Boundary);
    fn added_face(&mut self, store: &mut S, f: S::Face);

    fn remove_vertex(&mut self, store: &S, v: S::Vertex);
    fn remove_edge(&mut self, store: &S, h: S::HalfEdge);
    fn remove_boundary(&mut self, store: &S, b: S::Boundary);
    fn remove_face(&mut self, store: &S, f: S::Face);

    fn set_origin(&mut self, store: &S, h: S::HalfEdge);
    fn join(&mut self, store: &S, h: S::HalfEdge, n: S::HalfEdge);
    fn set_boundary(&mut self, store: &S, h: S::HalfEdge);
    fn set_vertex_link(&mut self, store: &S, v: S::Vertex);
    fn set_start(&mut self, store: &S, b: S::Boundary);
    fn set_place(&mut self, store: &S, b: S::Boundary);
    fn list_outer(&mut self, store: &S, f: S::Face, b: S::Boundary);
    fn list_inner(&mut self, store: &S, f: S::Face, b: S::Boundary);
    fn unlist(&mut self, store: &S, b: S::Boundary);
}

impl WriteSet {
    fn vertex<S: Links>(&mut self, store: &S, v: S::Vertex) {
        self.vertices.push(store.vertex_index(v));
    }

    fn half_edge<S: Links>(&mut self, store: &S, h: S::HalfEdge) {
        self.half_edges.push(store.half_edge_index(h));
    }

    fn edge<S: Links>(&mut self, store: &S, h: S::HalfEdge) {
        self.half_edge(store, h);
        self.half_edge(store, store.twin(h));
    }

    fn record<S: Links>(&mut self, store: &S, b: S::Boundary) {
        self.boundaries.push(store.boundary_index(b));
    }

    fn list<S: Links>(&mut self, store: &S, f: S::Face) {
        self.faces.push(store.face_index(f));
    }

    /// An entry of the list in which the boundary component is, and the face.
    fn entry<S: Links>(&mut self, store: &S, b: S::Boundary) {
        let f = store.face(b);
        self.record(store, b);
        self.list(store, f);
        if store.outer(f) != Some(b) {
            self.listed.push((store.face_index(f), store.place(b) as usize));
        }
    }
}

/// Records that are written, and named by one method.
macro_rules! noted {
    ($($name:ident($store:ty, $($record:ident: $type:ty),*), $($note:ident($noted:ident)),*;)*) => {
        $(fn $name(&mut self, store: $store, $($record: $type),*) {
            $(self.$note(store, $noted);)*
        })*
    };
}

/// Notes the records.
impl<S: Store> Watch<S> for WriteSet {
    noted! {
        added_vertex(&mut S, v: S::Vertex), vertex(v);
        added_isolated(&mut S, v: S::Vertex, b: S::Boundary), vertex(v), entry(b);
        added_edge(&mut S, h: S::HalfEdge), edge(h);
        added_boundary(&mut S, b: S::Boundary), record(b);
        added_face(&mut S, f: S::Face), list(f);
        remove_vertex(&S, v: S::Vertex), vertex(v);
        remove_edge(&S, h: S::HalfEdge), edge(h);
        remove_boundary(&S, b: S::Boundary), record(b);
        remove_face(&S, f: S::Face), list(f);
        set_origin(&S, h: S::HalfEdge), half_edge(h);
        join(&S, h: S::HalfEdge, n: S::HalfEdge), half_edge(h), half_edge(n);
        set_boundary(&S, h: S::HalfEdge), half_edge(h);
        set_vertex_link(&S, v: S::Vertex), vertex(v);
        set_start(&S, b: S::Boundary), record(b);
        set_place(&S, b: S::Boundary), record(b);
        list_outer(&S, f: S::Face, b: S::Boundary), record(b), list(f);
    }

    fn list_inner(&mut self, store: &S, f: S::Face, b: S::Boundary) {
        self.record(store, b);
        self.list(store, f);
        self.listed.push((store.face_index(f), store.inner_count(f)));
    }

    fn unlist(&mut self, store: &S, b: S::Boundary) {
        let f = store.face(b);
        // The last of the list moves to its place.
        if let Some(last) = store.inner_count(f).checked_sub(1).and_then(|last| store.inner(f, last)) {
            self.entry(store, last);
        }
        self.entry(store, b);
    }
}
