//! The checker for surfaces of any genus: positions say that each rotation and each cycle is one orbit.
//!
//! Each function is a row of the table of surfaces in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/Surface.v`, under the same
//! name. Boundary components are the faces: where half-edges name their face, that is taken for one.

use super::answers::Answers;
use super::columns::{Column, Labels};
use super::test::{Failure, Failures, Test};
use crate::validate::structure::{BoundaryPlace, Link, View};
use alloc::vec::Vec;
use core::fmt;

/// Checks the labels of a structure on closed surfaces, the genera of whose components are claimed to add up to `genus`. If all tests pass,
/// it keeps R1 … T4 of [`Expectation::surface`](crate::validate::Expectation::surface), and M7 with this genus.
///
/// The labels may be anything, and so may the structure, as for [`check`](super::check()). O(n).
///
/// # Errors
/// The tests that fail.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge::validate::certificate::{Labels, Test, check_surface};
/// // One vertex with two loops that cross: a torus with one face.
/// let torus: Table = "P 3 prev leaving faces V 1 0 - H 4 0 2 1 3 - 0 3 2 0 - 0 0 3 1 - 0 1 0 2 - B 0 F 1 - 0 HF 4 0 0 0 0 FH 1 0 0".parse()?;
/// let (labels, genus) = Labels::of_surface(&torus)?;
/// assert_eq!((check_surface(&torus, &labels, genus), genus), (Ok(()), 1));
/// let failures = check_surface(&torus, &labels, 0).unwrap_err();
/// assert_eq!(failures[0].test(), Test::GenusOk);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_surface<V: View + ?Sized>(view: &V, labels: &Labels, genus: usize) -> Result<(), Vec<Failure>> {
    let s = Surface(Answers::new(view, labels));
    let mut failures = Failures::new();
    failures.note(Test::Readable, 0, s.0.readable());
    if s.0.readable() {
        let sums = s.scan(false, &mut failures);
        failures.note(Test::GenusOk, 0, sums.fit(genus));
    }
    failures.into_result()
}

/// A structure whose faces are taken for boundary components, if it has no records for these.
pub(super) struct Surface<'a, V: ?Sized>(pub(super) Answers<'a, V>);

/// What is certified of a structure on surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SurfaceCounts {
    /// The sum of the genera of the components, once their holes are filled.
    pub genus: usize,
    /// The number of components with edges.
    pub components: usize,
    /// The number of holes, which is that of border loops.
    pub holes: usize,
    /// The number of vertices with edges.
    pub vertices: usize,
    /// The number of edges.
    pub edges: usize,
    /// The number of faces.
    pub faces: usize,
}

/// In the words of Coq's checker.
impl fmt::Display for SurfaceCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { genus, components, holes, .. } = self;
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        write!(f, "a surface of genus {genus} with {components} component{}, ", plural(*components))?;
        match holes {
            0 => f.write_str("closed"),
            _ => write!(f, "open at {holes} hole{}", plural(*holes)),
        }
    }
}

/// The numbers of live records, and of those by which components and the genus are counted.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    half_edges: u128,
    rotations: u128,
    cycles: u128,
    roots: u128,
    holes: u128,
}

impl Sums {
    /// The genus is the one that fits, if there is one.
    pub(super) const fn counts(&self) -> SurfaceCounts {
        let genus = (self.half_edges + 4 * self.roots).saturating_sub(2 * (self.rotations + self.cycles)) / 4;
        SurfaceCounts {
            genus: genus as usize,
            components: self.roots as usize,
            holes: self.holes as usize,
            vertices: self.rotations as usize,
            edges: (self.half_edges / 2) as usize,
            faces: self.cycles.saturating_sub(self.holes) as usize,
        }
    }

    pub(super) const fn fit(&self, genus: usize) -> bool {
        2 * (self.rotations + self.cycles) + 4 * genus as u128 == self.half_edges + 4 * self.roots
    }
}

impl<V: View + ?Sized> Surface<'_, V> {
    /// Runs every test but that of the genus. An open surface may have holes: boundary components without face.
    pub(super) fn scan(&self, open: bool, failures: &mut Failures) -> Sums {
        let mut sums = Sums::default();
        for h in (0..self.0.half_edges).filter(|h| self.0.is_half_edge(*h)) {
            sums.half_edges += 1;
            sums.roots += u128::from(self.component(h) == Some(h));
            let boundary = self.boundary(h);
            self.0.links_ok(h, failures);
            let cycle_ok = self.0.next(h).and_then(|n| self.boundary(n)) == boundary
                && boundary.and_then(|b| self.start(b)).is_some();
            failures.note(Test::CycleOk, h, cycle_ok);
            failures.note(Test::TurnOk, h, self.turn_ok(h));
            failures.note(Test::StepOk, h, self.step_ok(h));
            failures.note(Test::ComponentOk, h, self.component_ok(h));
            failures.note(Test::BorderOk, h, !open || self.border_ok(h));
        }
        for v in (0..self.0.vertices).filter(|v| self.0.is_vertex(*v)) {
            let leaving = self.0.leaving(v);
            sums.rotations += u128::from(leaving.is_some());
            failures.note(Test::SurfaceVertexOk, v, leaving.is_none_or(|h| self.0.origin(h) == Some(v)));
        }
        for b in (0..self.boundaries()).filter(|b| self.is_boundary(*b)) {
            let is_hole = open && self.0.boundary_face(b).is_none();
            sums.cycles += u128::from(self.start(b).is_some());
            sums.holes += u128::from(is_hole);
            let starts_there = self.start(b).is_some_and(|h| self.boundary(h) == Some(b));
            failures.note(Test::SurfaceBoundaryOk, b, starts_there && (is_hole || self.bounds_its_face(b)));
        }
        for f in (0..self.0.faces).filter(|f| self.0.by_record() && self.0.is_face(*f)) {
            let face_ok = self.0.outer(f).is_some_and(|b| self.0.boundary_face(b) == Some(f));
            failures.note(Test::SurfaceFaceOk, f, face_ok);
        }
        sums
    }

    pub(super) fn boundaries(&self) -> usize {
        if self.0.by_name() { self.0.faces } else { self.0.boundaries }
    }

    pub(super) fn is_boundary(&self, b: usize) -> bool {
        if self.0.by_name() { self.0.is_face(b) } else { self.0.is_boundary(b) }
    }

    pub(super) fn boundary(&self, h: usize) -> Link {
        match self.0.by_name() {
            true if self.0.is_half_edge(h) => self.0.view.face(h),
            true => None,
            false => self.0.boundary(h),
        }
    }

    /// The half-edge with which the boundary component starts.
    pub(super) fn start(&self, b: usize) -> Link {
        match self.0.by_name() {
            true if self.0.is_face(b) => self.0.view.outer_half_edge(b),
            true => None,
            false => self.0.cycle_start(b),
        }
    }

    /// It is the outer one of its face.
    fn bounds_its_face(&self, b: usize) -> bool {
        let is_outer = |f| self.0.outer(f) == Some(b);
        !self.0.by_record()
            || self.0.boundary_face(b).is_some_and(is_outer) && self.0.place(b) == Some(BoundaryPlace::Outer)
    }

    fn is_in_hole(&self, h: usize) -> bool {
        self.boundary(h).is_some_and(|b| self.0.boundary_face(b).is_none())
    }

    /// A half-edge of a hole is the one that the border of its origin names, and its twin bounds a face.
    fn border_ok(&self, h: usize) -> bool {
        let named = |v| self.0.labels.link(Column::VertexBorder, v);
        !self.is_in_hole(h)
            || self.0.origin(h).and_then(named) == Some(h) && self.0.twin(h).is_some_and(|t| !self.is_in_hole(t))
    }

    fn component(&self, h: usize) -> Link {
        self.0.labels.link(Column::HalfEdgeComponent, h)
    }

    /// A label of the second half-edge is greater.
    fn grows(&self, column: Column, h: usize, to: usize) -> bool {
        let labels = self.0.labels.column(column);
        labels.get(h).zip(labels.get(to)).is_some_and(|(before, after)| before < after)
    }

    /// The next half-edge around the origin is the one that this vertex keeps, or has a greater turn.
    fn turn_ok(&self, h: usize) -> bool {
        let kept = self.0.origin(h).and_then(|v| self.0.leaving(v));
        let turned = self.0.twin(h).and_then(|t| self.0.next(t));
        turned.is_some_and(|g| kept == Some(g) || self.grows(Column::HalfEdgeTurn, h, g))
    }

    /// The next half-edge is the start of the boundary component, or has a greater step.
    fn step_ok(&self, h: usize) -> bool {
        let start = self.boundary(h).and_then(|b| self.start(b));
        self.0.next(h).is_some_and(|n| start == Some(n) || self.grows(Column::HalfEdgeStep, h, n))
    }

    /// Neighbours have the same component, and one of them a lower rank, but for the root.
    fn component_ok(&self, h: usize) -> bool {
        let component = self.component(h);
        let is_same = |link: Link| link.is_some_and(|l| self.component(l) == component);
        let (next, prev, twin) = (self.0.next(h), self.0.prev(h), self.0.twin(h));
        let lower = |link| self.0.is_lower(link, h);
        component.is_some()
            && is_same(next)
            && is_same(twin)
            && (component == Some(h) || lower(next) || lower(prev) || lower(twin))
    }
}
