//! The model as the validator sees it: the index of a record is its place in its list.

use super::{Beginning, Owned, Pointer, PointerModel};
use crate::validate::{BoundaryPlace, Link, Parts, Start, View};
use core::cell::Ref;

/// The record with this index, read.
fn read<T, U>(list: &[Owned<T>], index: usize, answer: impl FnOnce(Ref<'_, T>) -> Option<U>) -> Option<U> {
    answer(list.get(index)?.borrow())
}

/// The index of the record to which a link leads, and nil if it leads nowhere.
fn index<T>(link: &Pointer<T>, of: impl FnOnce(Ref<'_, T>) -> usize) -> Link {
    Some(of(link.upgrade()?.borrow()))
}

impl View for PointerModel {
    fn parts(&self) -> Parts {
        Parts::ALL
    }
    fn vertex_slots(&self) -> usize {
        self.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.boundaries.len()
    }
    fn face_slots(&self) -> usize {
        self.faces.len()
    }
    fn origin(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.origin, |v| v.index))
    }
    fn twin(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.twin, |t| t.index))
    }
    fn next(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.next, |n| n.index))
    }
    fn prev(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.prev, |p| p.index))
    }
    fn boundary(&self, half_edge: usize) -> Link {
        read(&self.half_edges, half_edge, |h| index(&h.boundary, |b| b.index))
    }
    fn leaving(&self, vertex: usize) -> Link {
        read(&self.vertices, vertex, |v| index(v.leaving.as_ref()?, |h| h.index))
    }
    fn isolated(&self, vertex: usize) -> Link {
        read(&self.vertices, vertex, |v| index(v.isolated.as_ref()?, |b| b.index))
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        read(&self.boundaries, boundary, |b| index(&b.face, |f| f.index))
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        read(&self.boundaries, boundary, |b| match &b.start {
            Beginning::HalfEdge(h) => index(h, |h| h.index).map(Start::HalfEdge),
            Beginning::Vertex(v) => index(v, |v| v.index).map(Start::Vertex),
        })
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        read(&self.boundaries, boundary, |b| Some(b.place))
    }
    fn outer(&self, face: usize) -> Link {
        read(&self.faces, face, |f| index(f.outer.as_ref()?, |b| b.index))
    }
    fn inner_count(&self, face: usize) -> usize {
        self.faces.get(face).map_or(0, |f| f.borrow().inner.len())
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        read(&self.faces, face, |f| index(f.inner.get(position)?, |b| b.index))
    }
}
