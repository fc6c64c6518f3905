//! The links of columns, in a form that is fast for the given columns.

use crate::boundaries::Lists;
use crate::column::Links;
use twinedge::validate::{HalfEdgeColumns, Link, Parts, Start, View};

/// The answers of a structure of columns. `C` is the way to read a column. If it is `PLAIN`, all records are live, and there are
/// no records of boundary components: neither is checked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Form<'a, C, const PLAIN: bool> {
    pub(crate) vertices: usize,
    pub(crate) half_edges: usize,
    pub(crate) faces: usize,
    pub(crate) next: C,
    /// `None`: twins are paired.
    pub(crate) twin: Option<C>,
    pub(crate) parts: Parts,
    pub(crate) origin: C,
    pub(crate) target: C,
    pub(crate) prev: C,
    pub(crate) face: C,
    pub(crate) leaving: C,
    pub(crate) outer_half_edge: C,
    pub(crate) lists: Option<Lists<C>>,
    /// Marks of the live vertices, half-edges, boundary components and faces; `None` if all are live.
    pub(crate) live: [Option<&'a [bool]>; 4],
}

impl<'a, C: Links, const PLAIN: bool> Form<'a, C, PLAIN> {
    /// Converts every column to another kind, if possible, and to a plain form if requested and true.
    pub(crate) fn map<D, const TO_PLAIN: bool>(&self, to: impl Fn(C) -> Option<D>) -> Option<Form<'a, D, TO_PLAIN>> {
        if TO_PLAIN && (self.lists.is_some() || self.live.iter().any(Option::is_some)) {
            return None;
        }
        Some(Form {
            vertices: self.vertices,
            half_edges: self.half_edges,
            faces: self.faces,
            next: to(self.next)?,
            twin: match self.twin {
                None => None,
                Some(twin) => Some(to(twin)?),
            },
            origin: to(self.origin)?,
            target: to(self.target)?,
            prev: to(self.prev)?,
            face: to(self.face)?,
            leaving: to(self.leaving)?,
            outer_half_edge: to(self.outer_half_edge)?,
            lists: match &self.lists {
                None => None,
                Some(lists) => Some(lists.map(&to)?),
            },
            parts: self.parts,
            live: self.live,
        })
    }

    pub(crate) fn target(&self, half_edge: usize) -> Link {
        self.target.at(half_edge)
    }

    const fn lists(&self) -> Option<&Lists<C>> {
        if PLAIN { None } else { self.lists.as_ref() }
    }

    /// Returns true for a live slot: all below `slots` are live, unless there are marks.
    fn is_live(&self, kind: usize, slot: usize, slots: usize) -> bool {
        match self.live[kind] {
            Some(live) if !PLAIN => live.get(slot).is_some_and(|live| *live),
            _ => slot < slots,
        }
    }
}

impl<C: Links, const PLAIN: bool> View for Form<'_, C, PLAIN> {
    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        let paired = match &self.twin {
            None => true,
            Some(twin) => twin.numbers()?.iter().zip(0..).all(|(t, h)| *t == h ^ 1),
        };
        if !paired || self.live[1].is_some() {
            return None;
        }
        let boundary = match self.lists() {
            Some(lists) => lists.boundary.numbers()?,
            None => &[],
        };
        Some(HalfEdgeColumns {
            origin: self.origin.numbers()?,
            next: self.next.numbers()?,
            prev: self.prev.numbers()?,
            boundary,
            face: self.face.numbers()?,
            live_edges: None,
        })
    }

    fn parts(&self) -> Parts {
        self.parts
    }
    fn vertex_slots(&self) -> usize {
        self.vertices
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges
    }
    fn face_slots(&self) -> usize {
        self.faces
    }
    fn boundary_slots(&self) -> usize {
        self.lists().map_or(0, Lists::slots)
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        self.is_live(0, vertex, self.vertices)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.is_live(1, half_edge, self.half_edges)
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        self.is_live(2, boundary, self.boundary_slots())
    }
    fn is_face(&self, face: usize) -> bool {
        self.is_live(3, face, self.faces)
    }

    fn origin(&self, half_edge: usize) -> Link {
        self.origin.at(half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        match self.twin {
            Some(twin) => twin.at(half_edge),
            None => Some(half_edge ^ 1),
        }
    }
    fn next(&self, half_edge: usize) -> Link {
        self.next.at(half_edge)
    }
    fn prev(&self, half_edge: usize) -> Link {
        self.prev.at(half_edge)
    }
    fn face(&self, half_edge: usize) -> Link {
        self.face.at(half_edge)
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.leaving.at(vertex)
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        self.outer_half_edge.at(face)
    }

    fn boundary(&self, half_edge: usize) -> Link {
        self.lists()?.boundary.at(half_edge)
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.lists()?.isolated.at(vertex)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.lists()?.face.at(boundary)
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        self.lists()?.start(boundary)
    }
    fn outer(&self, face: usize) -> Link {
        self.lists()?.outer.at(face)
    }
    fn inner_count(&self, face: usize) -> usize {
        self.lists().map_or(0, |lists| lists.inner_count(face))
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        self.lists()?.inner(face, position)
    }
}
