//! A structure whose answers change.

use std::cell::Cell;
use twinedge::delegate_view;
use twinedge::validate::{BoundaryPlace, Link, Start, Table, View};

/// A table that answers consistently a number of times, and then pseudorandomly, differently each time. It panics when
/// asked about a missing slot.
pub(crate) struct Inconsistent<'a> {
    pub(crate) table: &'a Table,
    pub(crate) questions: Cell<u64>,
    /// The last list length that it answered.
    listed: Cell<usize>,
    consistent_answers: u64,
    seed: u64,
}

impl<'a> Inconsistent<'a> {
    /// Answers like the table `consistent_answers` times.
    pub(crate) fn new(table: &'a Table, consistent_answers: u64, seed: u64) -> Self {
        Self { table, questions: Cell::new(0), listed: Cell::new(0), consistent_answers, seed }
    }

    /// The table's answer while answers are consistent, then an index from 0 to `n` or nil.
    fn link(&self, answer: Link, n: usize) -> Link {
        let noise = self.noise()?;
        if noise == u64::MAX { answer } else { Some((noise % (n as u64 + 1)) as usize) }
    }

    /// [`u64::MAX`] while answers are consistent; then pseudorandom, and `None` one time in 16.
    pub(crate) fn noise(&self) -> Option<u64> {
        let asked = self.questions.get() + 1;
        self.questions.set(asked);
        if asked <= self.consistent_answers {
            return Some(u64::MAX);
        }
        // A step of SplitMix64.
        let mut z = (self.seed << 32 | asked).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let z = (z ^ (z >> 31)) >> 1;
        (z & 15 != 0).then_some(z >> 4)
    }

    fn is(&self, answer: bool) -> bool {
        match self.noise() {
            Some(u64::MAX) => answer,
            noise => noise.is_some(),
        }
    }

    fn start(&self, answer: Option<Start>) -> Option<Start> {
        match self.noise()? {
            u64::MAX => answer,
            noise if noise % 3 == 0 => self.link(None, self.table.vertices.len()).map(Start::Vertex),
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

impl View for Inconsistent<'_> {
    delegate_view!(|this| this.table; only parts, vertex_slots, half_edge_slots, boundary_slots, face_slots);

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
