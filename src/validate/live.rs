//! R1: every link that a record needs is there, and every link leads to a live record.
//!
//! ```text
//!   half-edge 3 ── next ──► 7     ok if slot 7 holds a half-edge
//!                  next ──► nil   a cycle that ends
//!                  next ──► 99    past the end, or a retired record
//! ```

use super::report::{Flow, Halt};
use super::run::{Fan, NIL, Run, column};
use super::{Field, Link, Part, Record, Rule, Start, Unchecked, View, Violation};

/// The kind of record that a link leads to.
#[derive(Clone, Copy)]
enum Kind {
    Vertex,
    HalfEdge,
    Boundary,
    Face,
}

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs R1, and counts what there is while at it.
    pub(super) fn live(&mut self) -> Result<(), Halt> {
        self.fans = column(self.vertices, Fan { degree: 0, leaving: NIL })?;
        self.live_half_edges()?;
        self.map_is_live = self.findings.holds(Rule::R1);
        self.live_vertices()?;
        self.live_boundaries()?;
        self.live_faces()
    }

    /// Whether the link leads to a live record of that kind.
    #[inline]
    fn leads(&self, link: usize, kind: Kind) -> bool {
        match kind {
            Kind::Vertex => link < self.vertices as usize && self.view.is_vertex(link),
            Kind::HalfEdge => link < self.half_edges as usize && self.view.is_half_edge(link),
            Kind::Boundary => link < self.boundaries as usize && self.view.is_boundary(link),
            Kind::Face => link < self.faces as usize && self.view.is_face(link),
        }
    }

    /// Checks one link; nil is a violation only where the record needs it.
    #[inline]
    fn link(&mut self, record: Record, field: Field, link: Link, kind: Kind, needed: bool) -> Flow {
        match link {
            Some(value) if self.leads(value, kind) => Ok(()),
            Some(value) => self.findings.add(Violation::Dangling { record, field, value }),
            None if needed => self.findings.add(Violation::Nil { record, field }),
            None => Ok(()),
        }
    }

    fn live_half_edges(&mut self) -> Flow {
        let with_prev = self.expect.has(Part::Prev);
        let with_boundary = self.expect.has(Part::BoundaryComponents);
        let with_face = self.expect.has(Part::Faces) && !with_boundary;
        let closed = !self.expect.is_open();
        let links = 3 + u64::from(with_prev) + u64::from(with_boundary || with_face);
        let (mut live, mut without_twin) = (0, 0);
        for h in 0..self.half_edges as usize {
            if !self.view.is_half_edge(h) {
                continue;
            }
            live += 1;
            let record = Record::HalfEdge(h);
            let origin = self.view.origin(h);
            self.link(record, Field::Origin, origin, Kind::Vertex, true)?;
            if let Some(v) = origin.filter(|v| *v < self.vertices as usize) {
                self.fans[v] = Fan { degree: self.fans[v].degree + 1, leaving: h as u32 };
            }
            let twin = self.view.twin(h);
            without_twin += usize::from(twin.is_none());
            self.link(record, Field::Twin, twin, Kind::HalfEdge, closed)?;
            self.link(record, Field::Next, self.view.next(h), Kind::HalfEdge, true)?;
            if with_prev {
                self.link(record, Field::Prev, self.view.prev(h), Kind::HalfEdge, true)?;
            }
            if with_boundary {
                self.link(record, Field::Boundary, self.view.boundary(h), Kind::Boundary, closed)?;
            } else if with_face {
                self.link(record, Field::Face, self.view.face(h), Kind::Face, closed)?;
            }
        }
        self.counts.half_edges = live;
        self.counts.edges = (live - without_twin) / 2 + without_twin;
        self.findings.checked(Rule::R1, live as u64 * links);
        Ok(())
    }

    fn live_vertices(&mut self) -> Flow {
        let with_leaving = self.expect.has(Part::Leaving);
        let with_isolated = self.expect.has(Part::BoundaryComponents) && self.expect.has(Part::Holes);
        let links = u64::from(with_leaving || with_isolated);
        let mut live = 0;
        for v in 0..self.vertices as usize {
            if !self.view.is_vertex(v) {
                continue;
            }
            live += 1;
            let connected = self.fans[v].degree > 0;
            self.counts.isolated_vertices += usize::from(!connected);
            let record = Record::Vertex(v);
            if with_leaving {
                self.link(record, Field::Leaving, self.view.leaving(v), Kind::HalfEdge, connected)?;
            }
            if with_isolated {
                // Whether a vertex without half-edges may lack it is the business of B2.
                self.link(record, Field::Isolated, self.view.isolated(v), Kind::Boundary, false)?;
            }
        }
        self.counts.vertices = live;
        self.findings.checked(Rule::R1, live as u64 * links);
        Ok(())
    }

    fn live_boundaries(&mut self) -> Flow {
        let mut live = 0;
        for b in 0..self.boundaries as usize {
            if !self.view.is_boundary(b) {
                continue;
            }
            live += 1;
            let record = Record::Boundary(b);
            self.link(record, Field::Face, self.view.boundary_face(b), Kind::Face, true)?;
            self.start(record, Field::Start, self.view.boundary_start(b))?;
        }
        self.findings.checked(Rule::R1, live as u64 * 2);
        // Each boundary component is listed once, so a sound structure stays far below this, and a corrupt one is read
        // far enough to find what it lists twice.
        let records = if self.expect.has(Part::BoundaryComponents) {
            live
        } else {
            self.counts.half_edges + self.counts.vertices
        };
        self.list_budget = 2 * records + 16;
        Ok(())
    }

    fn start(&mut self, record: Record, field: Field, start: Option<Start>) -> Flow {
        let (link, kind) = match start {
            Some(Start::Vertex(v)) => (Some(v), Kind::Vertex),
            Some(Start::HalfEdge(h)) => (Some(h), Kind::HalfEdge),
            None => (None, Kind::HalfEdge),
        };
        self.link(record, field, link, kind, true)
    }

    /// Reports a list that is not read to its end. Links that are not read cannot be said to be live.
    pub(super) fn list_too_long(&mut self, face: usize, claimed: usize) -> Flow {
        self.findings.not_checked(Rule::R1, Unchecked::ListTooLong);
        self.findings.add(Violation::ListTooLong { face, claimed })
    }

    fn live_faces(&mut self) -> Flow {
        let by_record = self.expect.has(Part::BoundaryComponents);
        let with_inner = self.expect.has(Part::Holes);
        let mut budget = self.list_budget;
        let (mut live, mut links) = (0, 0);
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            live += 1;
            let record = Record::Face(f);
            if by_record {
                self.link(record, Field::Outer, self.view.outer(f), Kind::Boundary, false)?;
            } else {
                self.link(record, Field::Outer, self.view.outer_half_edge(f), Kind::HalfEdge, false)?;
            }
            links += 1;
            let claimed = if with_inner { self.view.inner_count(f) } else { 0 };
            let listed = claimed.min(budget);
            for i in 0..listed {
                if by_record {
                    self.link(record, Field::Inner(i), self.view.inner(f, i), Kind::Boundary, true)?;
                } else {
                    self.start(record, Field::Inner(i), self.view.inner_start(f, i))?;
                }
            }
            budget -= listed;
            links += listed as u64;
            if listed < claimed && self.findings.unchecked(Rule::R1).is_none() {
                self.list_too_long(f, claimed)?;
            }
        }
        self.counts.faces = live;
        self.findings.checked(Rule::R1, links);
        Ok(())
    }
}
