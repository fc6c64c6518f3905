//! A structure that changes its mind.

use std::cell::Cell;
use twinedge::validate::{BoundaryPlace, Link, Start, Table, View};

/// A table that answers as it is for a while, and then anything, differently each time. It insists on being asked about
/// slots that it has only.
pub(crate) struct Moody<'a> {
    pub(crate) table: &'a Table,
    pub(crate) questions: Cell<u64>,
    /// What it last said of the length of a list.
    listed: Cell<usize>,
    patience: u64,
    seed: u64,
}

impl<'a> Moody<'a> {
    /// One that begins to lie after that many questions.
    pub(crate) fn new(table: &'a Table, patience: u64, seed: u64) -> Self {
        Self { table, questions: Cell::new(0), listed: Cell::new(0), patience, seed }
    }

    /// Something between 0 and `n`, or the answer of the table while patience lasts.
    fn link(&self, answer: Link, n: usize) -> Link {
        let mood = self.mood()?;
        if mood == u64::MAX { answer } else { Some((mood % (n as u64 + 1)) as usize) }
    }

    /// [`u64::MAX`] while patience lasts; then pseudorandom, and nil now and then.
    pub(crate) fn mood(&self) -> Option<u64> {
        let asked = self.questions.get() + 1;
        self.questions.set(asked);
        if asked <= self.patience {
            return Some(u64::MAX);
        }
        // A step of SplitMix64.
        let mut z = (self.seed << 32 | asked).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let z = (z ^ (z >> 31)) >> 1;
        (!z.is_multiple_of(16)).then_some(z >> 4)
    }

    fn is(&self, answer: bool) -> bool {
        match self.mood() {
            Some(u64::MAX) => answer,
            mood => mood.is_some(),
        }
    }

    fn start(&self, answer: Option<Start>) -> Option<Start> {
        match self.mood()? {
            u64::MAX => answer,
            mood if mood.is_multiple_of(3) => self.link(None, self.table.vertices.len()).map(Start::Vertex),
            _ => self.link(None, self.table.half_edges.len()).map(Start::HalfEdge),
        }
    }

    fn vertex(&self, v: usize) -> usize {
        assert!(v < self.table.vertices.len());
        v
    }

    fn half_edge(&self, h: usize) -> usize {
        assert!(h < self.table.half_edges.len());
        h
    }

    fn boundary_slot(&self, b: usize) -> usize {
        assert!(b < self.table.boundaries.len());
        b
    }

    fn position(&self, i: usize) -> usize {
        assert!(i < self.listed.get());
        i
    }

    fn face_slot(&self, f: usize) -> usize {
        assert!(f < self.table.faces.len());
        f
    }
}

impl View for Moody<'_> {
    fn vertex_slots(&self) -> usize {
        self.table.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.table.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.table.boundaries.len()
    }
    fn face_slots(&self) -> usize {
        self.table.faces.len()
    }
    fn is_vertex(&self, v: usize) -> bool {
        self.is(self.table.is_vertex(self.vertex(v)))
    }
    fn is_half_edge(&self, h: usize) -> bool {
        self.is(self.table.is_half_edge(self.half_edge(h)))
    }
    fn is_boundary(&self, b: usize) -> bool {
        self.is(self.table.is_boundary(self.boundary_slot(b)))
    }
    fn is_face(&self, f: usize) -> bool {
        self.is(self.table.is_face(self.face_slot(f)))
    }
    fn origin(&self, h: usize) -> Link {
        self.link(self.table.origin(self.half_edge(h)), self.table.vertices.len())
    }
    fn twin(&self, h: usize) -> Link {
        self.link(self.table.twin(self.half_edge(h)), self.table.half_edges.len())
    }
    fn next(&self, h: usize) -> Link {
        self.link(self.table.next(self.half_edge(h)), self.table.half_edges.len())
    }
    fn prev(&self, h: usize) -> Link {
        self.link(self.table.prev(self.half_edge(h)), self.table.half_edges.len())
    }
    fn boundary(&self, h: usize) -> Link {
        self.link(self.table.boundary(self.half_edge(h)), self.table.boundaries.len())
    }
    fn face(&self, h: usize) -> Link {
        self.link(self.table.face(self.half_edge(h)), self.table.faces.len())
    }
    fn leaving(&self, v: usize) -> Link {
        self.link(self.table.leaving(self.vertex(v)), self.table.half_edges.len())
    }
    fn isolated(&self, v: usize) -> Link {
        self.link(self.table.isolated(self.vertex(v)), self.table.boundaries.len())
    }
    fn boundary_face(&self, b: usize) -> Link {
        self.link(self.table.boundary_face(self.boundary_slot(b)), self.table.faces.len())
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        self.start(self.table.boundary_start(self.boundary_slot(b)))
    }
    fn boundary_place(&self, b: usize) -> Option<BoundaryPlace> {
        self.table.boundary_place(self.boundary_slot(b))
    }
    fn outer(&self, f: usize) -> Link {
        self.link(self.table.outer(self.face_slot(f)), self.table.boundaries.len())
    }
    fn inner_count(&self, f: usize) -> usize {
        self.listed.set(self.link(Some(self.table.inner_count(self.face_slot(f))), 5).unwrap_or(usize::MAX));
        self.listed.get()
    }
    fn inner(&self, f: usize, i: usize) -> Link {
        self.link(self.table.inner(self.face_slot(f), self.position(i)), self.table.boundaries.len())
    }
    fn outer_half_edge(&self, f: usize) -> Link {
        self.link(self.table.outer_half_edge(self.face_slot(f)), self.table.half_edges.len())
    }
    fn inner_start(&self, f: usize, i: usize) -> Option<Start> {
        self.start(self.table.inner_start(self.face_slot(f), self.position(i)))
    }
}
