//! F1 and F2: faces and their lists of boundary components.
//!
//! ```text
//!   face 2 ── outer ───► component 5 ── face ──► 2, place: outer
//!          └─ inner[0] ► component 8 ── face ──► 2, place: inner 0
//!
//!   F1  a bounded face has an outer component, a cycle; the one unbounded face has none
//!   F2  each component is listed once, by the face that it names, where it says
//! ```

use super::report::{Flow, Halt};
use super::run::{NIL, Run, column};
use super::{BoundaryPlace, Part, Record, Rule, Start, Unchecked, View, Violation};

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs F1 and F2.
    pub(super) fn faces(&mut self) -> Result<(), Halt> {
        if !self.expect.has(Part::Faces) {
            self.findings.not_checked(Rule::F1, Unchecked::Lacks(Part::Faces));
            self.findings.not_checked(Rule::F2, Unchecked::Lacks(Part::Faces));
            return Ok(());
        }
        self.outer()?;
        if self.expect.has(Part::BoundaryComponents) { self.components_listed() } else { self.cycles_listed() }
    }

    /// The outer boundary component, or half-edge, that the face names.
    fn outer_link(&self, f: usize) -> Option<usize> {
        if self.expect.has(Part::BoundaryComponents) { self.view.outer(f) } else { self.view.outer_half_edge(f) }
    }

    fn outer(&mut self) -> Flow {
        let mut unbounded = None;
        let mut checked = 0;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            checked += 1;
            match self.outer_link(f) {
                None if !self.expect.has(Part::UnboundedFace) => self.findings.add(Violation::NoOuter { face: f })?,
                None => match unbounded {
                    None => unbounded = Some(f),
                    Some(first) => self.findings.add(Violation::SecondUnboundedFace { first, second: f })?,
                },
                Some(b) => {
                    self.counts.outer_boundaries += 1;
                    if self.expect.has(Part::BoundaryComponents)
                        && b < self.boundaries as usize
                        && self.view.is_boundary(b)
                        && matches!(self.view.boundary_start(b), Some(Start::Vertex(_)))
                    {
                        self.findings.add(Violation::OuterIsVertex { face: f, boundary: b })?;
                    }
                }
            }
        }
        self.findings.checked(Rule::F1, checked);
        if unbounded.is_none() && self.expect.has(Part::UnboundedFace) {
            self.findings.add(Violation::NoUnboundedFace)?;
        }
        Ok(())
    }

    fn components_listed(&mut self) -> Result<(), Halt> {
        let mut listed = column(self.boundaries, false)?;
        let mut budget = self.list_budget;
        let mut cut_short = false;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            if let Some(b) = self.view.outer(f) {
                self.entry(&mut listed, f, b, BoundaryPlace::Outer)?;
            }
            if !self.expect.has(Part::Holes) {
                continue;
            }
            let claimed = self.view.inner_count(f);
            let read = claimed.min(budget);
            budget -= read;
            self.counts.inner_boundaries += read;
            for i in 0..read {
                if let Some(b) = self.view.inner(f, i) {
                    self.entry(&mut listed, f, b, BoundaryPlace::Inner(i))?;
                }
            }
            if read < claimed {
                cut_short = true;
                self.list_not_read(f, claimed)?;
            }
        }
        let mut checked = 0;
        for (b, listed) in listed.into_iter().enumerate() {
            if !self.view.is_boundary(b) {
                continue;
            }
            checked += 1;
            if !listed && !cut_short {
                let face = self.view.boundary_face(b);
                self.findings.add(Violation::NotListed { boundary: b, face })?;
            }
        }
        self.findings.checked(Rule::F2, checked);
        Ok(())
    }

    /// One entry of a list. What dangles is R1's to report.
    fn entry(&mut self, listed: &mut [bool], f: usize, b: usize, place: BoundaryPlace) -> Flow {
        if b >= listed.len() || !self.view.is_boundary(b) {
            return Ok(());
        }
        if core::mem::replace(&mut listed[b], true) {
            self.findings.add(Violation::ListedTwice { record: Record::Boundary(b), face: f })?;
        }
        let names = self.view.boundary_face(b);
        if names != Some(f) && names.is_some_and(|g| g < self.faces as usize && self.view.is_face(g)) {
            self.findings.add(Violation::ListedByOther { boundary: b, face: f, found: names })?;
        }
        if self.expect.has(Part::Places) {
            let says = self.view.boundary_place(b);
            if says != Some(place) {
                self.findings.add(Violation::WrongPlace { boundary: b, place: says, listed: place })?;
            }
        }
        Ok(())
    }

    /// Without records for boundary components: each cycle with a face is listed exactly once. That it is by its own face
    /// is B1's doing.
    fn cycles_listed(&mut self) -> Result<(), Halt> {
        let broken = if self.map_is_live { self.findings.broken(&[Rule::L2]) } else { Some(Rule::R1) };
        if let Some(rule) = broken {
            self.findings.not_checked(Rule::F2, Unchecked::Broken(rule));
            return Ok(());
        }
        let mut listed = column(self.half_edges, false)?;
        for f in 0..self.faces as usize {
            if self.view.is_face(f)
                && let Some(h) = self.view.outer_half_edge(f)
            {
                self.list_cycle(&mut listed, f, h)?;
            }
        }
        let mut entries = 0;
        self.for_each_inner_start(|run, f, _, start| {
            entries += 1;
            match start {
                Start::HalfEdge(h) => run.list_cycle(&mut listed, f, h),
                Start::Vertex(_) => Ok(()),
            }
        })?;
        self.counts.inner_boundaries = entries;
        if self.expect.has(Part::Holes) {
            self.lists_end(entries)?;
        }
        let mut checked = (self.counts.outer_boundaries + entries) as u64;
        for h in 0..self.half_edges {
            if listed[h as usize] || !self.live_half_edge(h) || self.view.face(h as usize).is_none() {
                continue;
            }
            checked += 1;
            self.findings.add(Violation::CycleNotListed { half_edge: h as usize })?;
            self.mark_cycle(&mut listed, h);
        }
        self.findings.checked(Rule::F2, checked);
        Ok(())
    }

    /// What stands in the rest of a list is not known. R1 has said so, unless the list has grown since.
    fn list_not_read(&mut self, face: usize, claimed: usize) -> Flow {
        self.findings.not_checked(Rule::F2, Unchecked::ListTooLong);
        if self.findings.unchecked(Rule::R1).is_none() { self.list_too_long(face, claimed) } else { Ok(()) }
    }

    /// Finds the face at which the budget for list entries ran out, if it did.
    fn lists_end(&mut self, entries: usize) -> Flow {
        if entries < self.list_budget {
            return Ok(());
        }
        let mut read = 0_usize;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            let claimed = self.view.inner_count(f);
            read = read.saturating_add(claimed);
            if read > self.list_budget {
                return self.list_not_read(f, claimed);
            }
        }
        Ok(())
    }

    fn list_cycle(&mut self, listed: &mut [bool], f: usize, h: usize) -> Flow {
        if h >= listed.len() || !self.view.is_half_edge(h) {
            return Ok(());
        }
        if listed[h] {
            return self.findings.add(Violation::ListedTwice { record: Record::HalfEdge(h), face: f });
        }
        self.mark_cycle(listed, h as u32);
        Ok(())
    }

    fn mark_cycle(&self, listed: &mut [bool], start: u32) {
        let mut h = start;
        while h != NIL && !listed[h as usize] {
            listed[h as usize] = true;
            h = self.next(h);
        }
    }
}
