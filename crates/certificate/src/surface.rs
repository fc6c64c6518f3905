//! The checker for surfaces of any genus. Each rotation and each cycle is one orbit: for genus 0 by Euler's formula, otherwise by positions.
//!
//! Each function is a row of the table of surfaces in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/certificates/Surface.v`,
//! under the same name. Boundary components are the faces: if half-edges name their face, the face takes that role.

use super::answers::Answers;
use super::columns::{Column, Labels};
use super::fast::{Asked, HalfEdges, Lent, Star};
use super::storage::{Columns, Entries as _, Numbers as _};
use super::sums::Sums;
use super::test::{Failure, Failures, Noted, Test, UntilFailure};
use crate::NIL;
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Link, View};

/// Checks the labels of a structure on closed surfaces, whose genera are claimed to add up to `genus`. If all tests pass, the
/// structure keeps R1 … T4 of [`Expectation::surface`](twinedge::validate::Expectation::surface), and M7 with this genus.
///
/// The labels and the structure may be arbitrary, as for [`check`](super::check()). O(n).
///
/// # Errors
/// The failed tests.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Labels, Test, check_surface};
/// // One vertex with two loops that cross: a torus with one face.
/// let torus: Table = "P 3 prev leaving faces V 1 0 - H 4 0 2 1 3 - 0 3 2 0 - 0 0 3 1 - 0 1 0 2 - B 0 F 1 - 0 HF 4 0 0 0 0 FH 1 0 0".parse()?;
/// let (labels, genus) = Labels::of_surface(&torus)?;
/// assert_eq!((check_surface(&torus, &labels, genus), genus), (Ok(()), 1));
/// let failures = check_surface(&torus, &labels, 0).unwrap_err();
/// assert_eq!(failures[0].test(), Test::GenusOk);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_surface<V: View + ?Sized, C: Columns>(view: &V, labels: &C, genus: usize) -> Result<(), Vec<Failure>> {
    Surface(Answers::new(view, labels)).check(false, Some(genus)).map(|_| ())
}

/// Returns true if all tests pass, like [`check_surface`] without the failures. Stops reading at the first failing test.
///
/// O(n). No memory is allocated.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Labels, passes_surface};
/// let torus: Table = "P 3 prev leaving faces V 1 0 - H 4 0 2 1 3 - 0 3 2 0 - 0 0 3 1 - 0 1 0 2 - B 0 F 1 - 0 HF 4 0 0 0 0 FH 1 0 0".parse()?;
/// let (labels, _) = Labels::of_surface(&torus)?;
/// assert!(passes_surface(&torus, &labels, 1));
/// assert!(!passes_surface(&torus, &labels, 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn passes_surface<V: View + ?Sized, C: Columns>(view: &V, labels: &C, genus: usize) -> bool {
    let s = Surface(Answers::new(view, labels));
    s.pass(false, Some(genus)).is_some()
}

/// A structure whose faces serve as boundary components, if it does not store these.
pub(super) struct Surface<'a, V: ?Sized, C = Labels>(pub(super) Answers<'a, V, C>);

impl<V: View + ?Sized, C: Columns> Surface<'_, V, C> {
    /// Runs every test, and returns the counts if all pass. Open surfaces may have holes, without a face. Without a claim, the genus is
    /// that of the counts.
    pub(super) fn check(&self, open: bool, genus: Option<usize>) -> Result<Sums, Vec<Failure>> {
        if let Some(sums) = self.pass(open, genus) {
            return Ok(sums);
        }
        let mut failures = Failures::new();
        if !self.0.readable() {
            failures.note(Test::Readable, 0, false);
            return failures.into_result().map(|()| Sums::default());
        }
        let sums = self.records(self.counted(self.asked()), open, &mut failures).unwrap_or_default();
        let genus = genus.unwrap_or(sums.counts().genus);
        for h in (0..self.0.half_edges).filter(|h| self.0.is_half_edge(*h)) {
            self.note_half_edge(h, open, genus, &mut failures);
        }
        failures.note(Test::GenusOk, 0, sums.fit(genus));
        failures.into_result().map(|()| sums)
    }

    /// The fast pass: returns the counts if all tests pass. It leaves out what follows (`proofs/coq/certificates/Fewer.v`): that
    /// `next(prev(h)) = h`, and for genus 0 that the vertex keeps a half-edge and the boundary component starts with one.
    #[inline(always)]
    fn pass(&self, open: bool, genus: Option<usize>) -> Option<Sums> {
        self.0.readable().then_some(())?;
        match Lent::of(&self.0, self.0.by_record() || self.0.by_name()) {
            Some(lent) => self.pass_over(open, genus, lent),
            None => self.pass_over(open, genus, self.asked()),
        }
    }

    #[inline(always)]
    fn pass_over(&self, open: bool, genus: Option<usize>, links: impl HalfEdges) -> Option<Sums> {
        let sums = self.records(self.counted(links), open, &mut UntilFailure)?;
        let genus = genus.unwrap_or(sums.counts().genus);
        sums.fit(genus).then_some(())?;
        let one = self.one_component();
        for h in (0..self.0.half_edges).filter(|h| links.is_live(*h)) {
            let star = links.star(h)?;
            let (t, n, _) = star;
            let component = if one.is_some() { one } else { self.component(h) };
            component?;
            (one.is_some() || self.component(n) == component && self.component(t) == component).then_some(())?;
            (component == Some(h) || self.0.is_ranked(h, star)).then_some(())?;
            (genus == 0 || self.is_placed(h, star, links)).then_some(())?;
            (!open || self.border_ok(h)).then_some(())?;
        }
        Some(sums)
    }

    /// Returns true if the positions of the next half-edge around the origin, and of the next one on the cycle, are greater, or these are the first.
    #[inline(always)]
    fn is_placed(&self, h: usize, (t, n, _): Star, links: impl HalfEdges) -> bool {
        let (kept, start) = (self.0.leaving(links.origin(h)), self.start(links.name(h)));
        let turned = links.next(t);
        kept.is_some_and(|g| g == turned || links.is_live(turned) && self.grows(Column::HalfEdgeTurn, h, turned))
            && start.is_some_and(|g| g == n || self.grows(Column::HalfEdgeStep, h, n))
    }

    fn asked(&self) -> Asked<'_, V, C, impl Fn(usize) -> Link + Copy> {
        Asked { s: &self.0, name: |h| self.boundary(h) }
    }

    /// Returns the numbers of half-edges and of roots.
    #[inline(always)]
    fn counted(&self, links: impl HalfEdges) -> Sums {
        let half_edges = || (0..self.0.half_edges).filter(|h| links.is_live(*h));
        let roots = match self.one_component() {
            Some(root) => usize::from(links.is_live(root)),
            None => half_edges().filter(|h| self.component(*h) == Some(*h)).count(),
        };
        Sums { half_edges: half_edges().count(), roots, ..Sums::default() }
    }

    /// Returns the component of all half-edges, if one entry stands for them.
    #[inline(always)]
    fn one_component(&self) -> Link {
        if self.0.labels.column(Column::HalfEdgeComponent).count() == 1 { self.component(0) } else { None }
    }

    /// Runs every test of vertices, boundary components and faces, and counts them. Returns `None` if the check ended early.
    #[inline(always)]
    fn records(&self, mut sums: Sums, open: bool, noted: &mut impl Noted) -> Option<Sums> {
        for v in (0..self.0.vertices).filter(|v| self.0.is_vertex(*v)) {
            let leaving = self.0.leaving(v);
            sums.rotations += usize::from(leaving.is_some());
            noted.note(Test::SurfaceVertexOk, v, leaving.is_none_or(|h| self.0.origin(h) == Some(v)))?;
        }
        for b in (0..self.boundaries()).filter(|b| self.is_boundary(*b)) {
            let is_hole = open && self.0.boundary_face(b).is_none();
            sums.cycles += usize::from(self.start(b).is_some());
            sums.holes += usize::from(is_hole);
            let starts_there = self.start(b).is_some_and(|h| self.boundary(h) == Some(b));
            noted.note(Test::SurfaceBoundaryOk, b, starts_there && (is_hole || self.bounds_its_face(b)))?;
        }
        for f in (0..self.0.faces).filter(|f| self.0.by_record() && self.0.is_face(*f)) {
            let face_ok = self.0.outer(f).is_some_and(|b| self.0.boundary_face(b) == Some(f));
            noted.note(Test::SurfaceFaceOk, f, face_ok)?;
        }
        Some(sums)
    }

    pub(super) fn boundaries(&self) -> usize {
        if self.0.by_name() { self.0.faces } else { self.0.boundaries }
    }

    pub(super) fn is_boundary(&self, b: usize) -> bool {
        if self.0.by_name() { self.0.is_face(b) } else { self.0.is_boundary(b) }
    }

    #[inline(always)]
    pub(super) fn boundary(&self, h: usize) -> Link {
        match self.0.by_name() {
            true if self.0.is_half_edge(h) => self.0.view.face(h),
            true => None,
            false => self.0.boundary(h),
        }
    }

    /// Returns the half-edge at the start of the boundary component.
    #[inline(always)]
    pub(super) fn start(&self, b: usize) -> Link {
        match self.0.by_name() {
            true if self.0.is_face(b) => self.0.view.outer_half_edge(b),
            true => None,
            false => self.0.cycle_start(b),
        }
    }

    /// Returns true if the boundary component is the outer one of its face.
    fn bounds_its_face(&self, b: usize) -> bool {
        let is_outer = |f| self.0.outer(f) == Some(b);
        !self.0.by_record()
            || self.0.boundary_face(b).is_some_and(is_outer) && self.0.place(b) == Some(BoundaryPlace::Outer)
    }

    fn is_in_hole(&self, h: usize) -> bool {
        self.boundary(h).is_some_and(|b| self.0.boundary_face(b).is_none())
    }

    /// A half-edge of a hole is the border half-edge of its origin, and its twin bounds a face.
    fn border_ok(&self, h: usize) -> bool {
        let named = |v| self.0.labels.link(Column::VertexBorder, v);
        !self.is_in_hole(h)
            || self.0.origin(h).and_then(named) == Some(h) && self.0.twin(h).is_some_and(|t| !self.is_in_hole(t))
    }

    /// Returns the component of the half-edge. The last entry applies to all later half-edges: one suffices for one component.
    #[inline(always)]
    fn component(&self, h: usize) -> Link {
        let component = self.0.labels.column(Column::HalfEdgeComponent);
        let last = || component.at(component.count().checked_sub(1)?).filter(|_| h < self.0.half_edges);
        component.at(h).or_else(last).filter(|root| *root != NIL).map(|root| root as usize)
    }

    /// Returns true if the second half-edge has a greater label.
    #[inline(always)]
    fn grows(&self, column: Column, h: usize, to: usize) -> bool {
        let labels = self.0.labels.column(column);
        labels.at(h).zip(labels.at(to)).is_some_and(|(before, after)| before < after)
    }

    /// Runs all tests of a half-edge.
    fn note_half_edge(&self, h: usize, open: bool, genus: usize, failures: &mut Failures) {
        let ([twin, next, prev], boundary) = (self.0.links(h), self.boundary(h));
        let (kept, turned) = (self.0.kept(h), twin.and_then(|t| self.0.next(t)));
        let start = boundary.and_then(|b| self.start(b));
        let component = self.component(h);
        let is_same = |link: Link| link.is_some_and(|l| self.component(l) == component);
        let lower = |link| self.0.is_lower(link, h);
        self.0.note_links(h, failures);
        failures.note(Test::CycleOk, h, next.and_then(|n| self.boundary(n)) == boundary && start.is_some());
        // Unless the genus is 0, the next half-edge around the origin is the one kept by the vertex, or has a greater turn.
        failures.note(Test::TurnOk, h, {
            genus == 0 || turned.is_some_and(|g| kept == Some(g) || self.grows(Column::HalfEdgeTurn, h, g))
        });
        // Unless the genus is 0, the next half-edge on the cycle is the start of the boundary component, or has a greater step.
        failures.note(Test::StepOk, h, {
            genus == 0 || next.is_some_and(|n| start == Some(n) || self.grows(Column::HalfEdgeStep, h, n))
        });
        failures.note(Test::ComponentOk, h, {
            let ranked = component == Some(h) || lower(next) || lower(prev) || lower(twin);
            component.is_some() && is_same(next) && is_same(twin) && ranked
        });
        failures.note(Test::BorderOk, h, !open || self.border_ok(h));
    }
}
