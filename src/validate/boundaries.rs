//! B1 and B2: cycles and isolated vertices as boundary components.
//!
//! ```text
//!   B1                                   B2
//!   ┌──► 4 ──► 4 ──► 4 ──┐ start of 4    ·v   isolated(v) = 7 ◄──► start(7) = v
//!   └────────────────────┘
//!   one component all along the cycle, no other cycle of component 4
//! ```

use super::report::{Flow, Halt};
use super::run::{NIL, Run, column};
use super::{Part, Record, Rule, Start, Unchecked, View, Violation};
use alloc::vec::Vec;

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs B1 and B2.
    pub(super) fn boundaries(&mut self) -> Result<(), Halt> {
        if !self.expect.has(Part::Faces) {
            self.findings.not_checked(Rule::B1, Unchecked::Lacks(Part::Faces));
            self.findings.not_checked(Rule::B2, Unchecked::Lacks(Part::Faces));
            return Ok(());
        }
        if self.expect.has(Part::BoundaryComponents) {
            self.constant_along_next()?;
            self.components_have_one_cycle()?;
        } else {
            self.cycles_have_one_face()?;
        }
        if self.expect.has(Part::Holes) {
            self.isolated()
        } else {
            self.findings.not_checked(Rule::B2, Unchecked::Lacks(Part::Holes));
            Ok(())
        }
    }

    fn constant_along_next(&mut self) -> Result<(), Halt> {
        self.sizes = column(self.boundaries, 0)?;
        let mut checked = 0;
        for h in 0..self.half_edges {
            if !self.live_half_edge(h) {
                continue;
            }
            let (b, n) = (self.boundary(h), self.next(h));
            if let Some(size) = self.sizes.get_mut(b as usize) {
                *size += 1;
            }
            if !self.live_half_edge(n) {
                continue;
            }
            checked += 1;
            let of_next = self.boundary(n);
            if b == of_next {
                continue;
            }
            let (boundary, found) = (self.view.boundary(h as usize), self.view.boundary(n as usize));
            // What dangles is R1's to report; nil meets something else only at an open boundary.
            let dangles = [(boundary, b), (found, of_next)].iter().any(|(link, slot)| link.is_some() && *slot == NIL);
            let needed = !self.expect.is_open() && (boundary.is_none() || found.is_none());
            if !dangles && !needed {
                let (half_edge, next) = (h as usize, n as usize);
                self.findings.add(Violation::BoundaryChanges { half_edge, next, boundary, found })?;
            }
        }
        self.findings.checked(Rule::B1, checked);
        Ok(())
    }

    fn components_have_one_cycle(&mut self) -> Flow {
        let constant_along_next = self.findings.holds(Rule::B1);
        let walkable = self.map_is_live && self.findings.holds(Rule::L2) && constant_along_next;
        for b in 0..self.boundaries {
            if !self.live_boundary(b) {
                continue;
            }
            let Some(Start::HalfEdge(start)) = self.view.boundary_start(b as usize) else {
                continue;
            };
            if start >= self.half_edges as usize || !self.view.is_half_edge(start) {
                continue;
            }
            if self.boundary(start as u32) != b {
                self.findings.add(Violation::StartElsewhere {
                    boundary: b as usize,
                    half_edge: start,
                    found: self.view.boundary(start),
                })?;
            } else if walkable {
                let half_edges = self.sizes[b as usize];
                let cycle = self.cycle_length(start as u32, half_edges);
                if cycle < half_edges {
                    let (cycle, half_edges) = (cycle as usize, half_edges as usize);
                    self.findings.add(Violation::SecondCycle { boundary: b as usize, cycle, half_edges })?;
                }
            }
        }
        // A component that starts at a vertex has no half-edges of its own.
        for b in 0..self.boundaries {
            if self.sizes[b as usize] > 0
                && self.live_boundary(b)
                && let Some(Start::Vertex(_)) = self.view.boundary_start(b as usize)
            {
                let half_edges = self.sizes[b as usize] as usize;
                self.findings.add(Violation::SecondCycle { boundary: b as usize, cycle: 0, half_edges })?;
            }
        }
        if !walkable && constant_along_next {
            let first = if self.map_is_live { Rule::L2 } else { Rule::R1 };
            self.findings.not_checked(Rule::B1, Unchecked::Broken(first));
        }
        Ok(())
    }

    /// The length of the cycle through `start`, walking no further than `limit`.
    fn cycle_length(&self, start: u32, limit: u32) -> u32 {
        let mut length = 0;
        let mut h = start;
        while h != NIL && length < limit {
            length += 1;
            h = self.next(h);
            if h == start {
                break;
            }
        }
        length
    }

    fn cycles_have_one_face(&mut self) -> Flow {
        let mut checked = 0;
        for h in 0..self.half_edges as usize {
            if !self.view.is_half_edge(h) {
                continue;
            }
            let n = self.next(h as u32);
            if !self.live_half_edge(n) {
                continue;
            }
            checked += 1;
            let (face, found) = (self.view.face(h), self.view.face(n as usize));
            if face != found && self.is_sound_face_link(face) && self.is_sound_face_link(found) {
                self.findings.add(Violation::FaceChanges { half_edge: h, next: n as usize, face, found })?;
            }
        }
        self.findings.checked(Rule::B1, checked);
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            if let Some(h) = self.view.outer_half_edge(f) {
                self.lists_own_half_edge(f, h)?;
            }
        }
        self.for_each_inner_start(|run, f, _, start| match start {
            Start::HalfEdge(h) => run.lists_own_half_edge(f, h),
            Start::Vertex(_) => Ok(()),
        })
    }

    /// Whether the face link of a half-edge is live, or legally nil.
    fn is_sound_face_link(&self, link: Option<usize>) -> bool {
        link.map_or(self.expect.is_open(), |f| f < self.faces as usize && self.view.is_face(f))
    }

    fn lists_own_half_edge(&mut self, f: usize, h: usize) -> Flow {
        if h >= self.half_edges as usize || !self.view.is_half_edge(h) {
            return Ok(());
        }
        let found = self.view.face(h);
        if found == Some(f) || !self.is_sound_face_link(found) {
            return Ok(());
        }
        self.findings.add(Violation::ListedElsewhere { face: f, half_edge: h, found })
    }

    /// Calls `visit` with each face, position and start of the inner lists, for structures without boundary components.
    pub(super) fn for_each_inner_start(
        &mut self,
        mut visit: impl FnMut(&mut Self, usize, usize, Start) -> Flow,
    ) -> Flow {
        if !self.expect.has(Part::Holes) {
            return Ok(());
        }
        let mut budget = self.list_budget;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            let listed = self.view.inner_count(f).min(budget);
            budget -= listed;
            for i in 0..listed {
                if let Some(start) = self.view.inner_start(f, i) {
                    visit(self, f, i, start)?;
                }
            }
        }
        Ok(())
    }

    /// Runs B2: claims are gathered per vertex, then each vertex is asked.
    fn isolated(&mut self) -> Result<(), Halt> {
        let by_record = self.expect.has(Part::BoundaryComponents);
        // The boundary component, or the face, by which a vertex is claimed as isolated.
        let mut claimed: Vec<u32> = column(self.vertices, NIL)?;
        if by_record {
            for b in 0..self.boundaries {
                if self.live_boundary(b)
                    && let Some(Start::Vertex(v)) = self.view.boundary_start(b as usize)
                {
                    self.claim(&mut claimed, v, b, Record::Boundary)?;
                }
            }
        } else {
            self.for_each_inner_start(|run, f, _, start| match start {
                Start::Vertex(v) => run.claim(&mut claimed, v, f as u32, Record::Face),
                Start::HalfEdge(_) => Ok(()),
            })?;
        }
        let mut checked = 0;
        for v in 0..self.vertices {
            if !self.live_vertex(v) {
                continue;
            }
            checked += 1;
            let vertex = v as usize;
            let claim = claimed[vertex];
            let names = if by_record { self.view.isolated(vertex) } else { None };
            if self.fans[vertex].degree > 0 {
                if let Some(boundary) = names {
                    self.findings.add(Violation::ConnectedNamesBoundary { vertex, boundary })?;
                }
            } else if claim == NIL {
                // Where the unbounded face is no record, nothing can start at a vertex that lies in it.
                if names.is_none() && !self.expect.has(Part::UnboundedFace) {
                    continue;
                }
                self.findings.add(Violation::IsolatedUnclaimed { vertex })?;
            } else if by_record && names != Some(claim as usize) {
                self.findings.add(Violation::IsolatedMismatch { vertex, boundary: claim as usize, found: names })?;
            }
        }
        self.findings.checked(Rule::B2, checked);
        Ok(())
    }

    fn claim(&mut self, claimed: &mut [u32], v: usize, by: u32, kind: fn(usize) -> Record) -> Flow {
        if v >= claimed.len() || !self.view.is_vertex(v) {
            return Ok(());
        }
        let record = kind(by as usize);
        if self.fans[v].degree > 0 {
            self.findings.add(Violation::StartsAtConnected { record, vertex: v })
        } else if claimed[v] == NIL {
            claimed[v] = by;
            Ok(())
        } else {
            let first = kind(claimed[v] as usize);
            self.findings.add(Violation::IsolatedTwice { vertex: v, first, second: record })
        }
    }
}
