//! The checker: a scan that reads each record once, with the records named by its links.
//!
//! Each function is a row of the tables in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/certificates/Labels.v`, under the same
//! name. It has no walk, no set and no order, and does not contain the rules.

use super::answers::Answers;
use super::fast;
use super::storage::Columns;
use super::sums::Sums;
use super::test::{Failure, Failures, Noted as _, Test};
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Link, Start, View};

/// Checks the labels of a structure. If all tests pass, the structure keeps R1 … T4 of
/// [`Expectation::plane`](twinedge::validate::Expectation::plane).
///
/// The labels may be invalid, even of incorrect length, and the structure may be anything, as for
/// [`validate`](twinedge::validate::validate). A failed check does not imply a broken structure: the labels may be another's.
///
/// Cost: O(n) for n slots and list entries. Only failures allocate memory. If the structure [lends](View::half_edge_columns) its
/// half-edges, they are read from the columns.
///
/// # Errors
/// The failed tests, each with the number of failing records and the first of them.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Labels, Test, check};
/// // A loop that lies in its own inside keeps every rule that looks at single records.
/// let table: Table = "V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 1 h1 i0 F 2 - 0 0 1 1".parse()?;
/// let failures = check(&table, &Labels::new(&table)?).unwrap_err();
/// assert_eq!(failures[0].test(), Test::RankOk);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check<V: View + ?Sized, C: Columns>(view: &V, labels: &C) -> Result<(), Vec<Failure>> {
    let s = Answers::new(view, labels);
    if fast::plane(&s).is_some() {
        return Ok(());
    }
    let mut failures = Failures::new();
    if s.readable() {
        scan(&s, &mut failures);
    } else {
        failures.note(Test::Readable, 0, false);
    }
    failures.into_result()
}

/// Returns true if all tests pass, like [`check`] without the failures. Stops reading at the first failing test.
///
/// Cost: O(n) for n slots and list entries. No memory is allocated.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Column, Labels, passes};
/// // An edge between two vertices.
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let mut labels = Labels::new(&edge)?;
/// assert!(passes(&edge, &labels));
/// // Half-edge 1 lies on the way from the start, and so not before it.
/// labels.column_mut(Column::HalfEdgeRank).swap(0, 1);
/// assert!(!passes(&edge, &labels));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn passes<V: View + ?Sized, C: Columns>(view: &V, labels: &C) -> bool {
    fast::plane(&Answers::new(view, labels)).is_some()
}

/// Runs every test.
pub(super) fn scan<V: View + ?Sized, C: Columns>(s: &Answers<'_, V, C>, failures: &mut Failures) {
    let mut sums = Sums::default();
    for h in (0..s.half_edges).filter(|h| s.is_half_edge(*h)) {
        sums.half_edges += 1;
        s.note_half_edge(h, failures);
    }
    for v in (0..s.vertices).filter(|v| s.is_vertex(*v)) {
        sums.rotations += usize::from(s.leaving(v).is_some());
        failures.note(Test::VertexOk, v, s.vertex_ok(v));
    }
    for b in (0..s.boundaries).filter(|b| s.is_boundary(*b)) {
        let is_cycle = s.cycle_start(b).is_some();
        sums.cycles += usize::from(is_cycle);
        sums.roots += usize::from(is_cycle && s.is_inner(b));
        failures.note(Test::StartOk, b, s.start_ok(b));
        failures.note(Test::PlaceOk, b, s.place_ok(b));
    }
    // A boundary component has one place. More entries can only be valid if answers change.
    let mut entries = s.boundaries;
    for f in (0..s.faces).filter(|f| s.is_face(*f)) {
        sums.unbounded += usize::from(s.outer(f).is_none());
        failures.note(Test::FaceOk, f, s.face_ok(f, &mut entries));
        failures.note(Test::FaceStartsOk, f, s.face_starts_ok(f));
    }
    failures.note(Test::OneUnbounded, 0, sums.unbounded == 1);
    failures.note(Test::EulerOk, 0, sums.fit(0));
}

impl<V: View + ?Sized, C: Columns> Answers<'_, V, C> {
    /// Runs the tests of the links of a half-edge, its neighbours and its origin.
    pub(super) fn note_links(&self, h: usize, failures: &mut Failures) {
        let [twin, next, prev] = self.links(h);
        failures.note(Test::TwinOk, h, twin.and_then(|t| self.twin(t)) == Some(h) && twin != Some(h));
        failures.note(Test::NextOk, h, {
            next.and_then(|n| self.prev(n)) == Some(h) && prev.and_then(|p| self.next(p)) == Some(h)
        });
        let target = twin.and_then(|t| self.origin(t));
        failures.note(Test::TargetOk, h, next.and_then(|n| self.origin(n)) == target);
        failures.note(Test::OriginOk, h, self.kept(h).is_some());
    }

    /// Runs all tests of a half-edge.
    fn note_half_edge(&self, h: usize, failures: &mut Failures) {
        let ([twin, next, prev], boundary) = (self.links(h), self.boundary(h));
        let lower = |link: Link| self.is_lower(link, h);
        self.note_links(h, failures);
        failures.note(Test::CycleOk, h, {
            next.and_then(|n| self.boundary(n)) == boundary && boundary.and_then(|b| self.cycle_start(b)).is_some()
        });
        failures.note(Test::RankOk, h, {
            lower(next) || lower(prev) || lower(twin) || boundary.is_some_and(|b| self.is_root(h, b))
        });
        failures.note(Test::FaceNameOk, h, self.face_name_ok(h, boundary));
    }

    /// Without stored boundary components: the half-edge names the face of its boundary component.
    #[inline(always)]
    pub(super) fn face_name_ok(&self, h: usize, boundary: Link) -> bool {
        !self.by_name() || self.view.face(h) == boundary.and_then(|b| self.boundary_face(b))
    }

    /// `h` starts an inner boundary component of the unbounded face, or of a face whose outer cycle starts with a lower rank.
    #[inline(always)]
    pub(super) fn is_root(&self, h: usize, b: usize) -> bool {
        let lies_lower = |f| self.outer(f).is_none_or(|outer| self.is_lower(self.cycle_start(outer), h));
        self.cycle_start(b) == Some(h) && self.is_inner(b) && self.boundary_face(b).is_some_and(lies_lower)
    }

    /// The vertex keeps a half-edge that leaves it, or names its own boundary component.
    #[inline(always)]
    pub(super) fn vertex_ok(&self, v: usize) -> bool {
        let isolated = self.isolated(v);
        match self.leaving(v) {
            Some(h) => self.origin(h) == Some(v) && isolated.is_none(),
            None => isolated.is_some_and(|b| self.start(b) == Some(Start::Vertex(v))),
        }
    }

    /// The component starts with one of its half-edges, or is an isolated vertex and an inner one.
    #[inline(always)]
    pub(super) fn start_ok(&self, b: usize) -> bool {
        match self.start(b) {
            Some(Start::HalfEdge(h)) => self.boundary(h) == Some(b),
            Some(Start::Vertex(v)) => {
                self.is_vertex(v) && self.leaving(v).is_none() && self.isolated(v) == Some(b) && self.is_inner(b)
            }
            None => false,
        }
    }

    #[inline(always)]
    pub(super) fn place_ok(&self, b: usize) -> bool {
        match (self.boundary_face(b), self.place(b)) {
            (Some(f), Some(BoundaryPlace::Outer)) => self.outer(f) == Some(b),
            (Some(f), Some(BoundaryPlace::Inner(i))) => self.inner(f, i) == Some(b),
            _ => false,
        }
    }

    /// The entries of the list name the face and their places. `entries` is the number of entries that may still be valid.
    #[inline(always)]
    fn face_ok(&self, f: usize, entries: &mut usize) -> bool {
        let named = |b: usize, place| self.boundary_face(b) == Some(f) && self.place(b) == Some(place);
        self.outer(f).is_none_or(|b| named(b, BoundaryPlace::Outer))
            && (0..self.inner_count(f)).all(|i| {
                let may_be = *entries > 0;
                *entries = entries.saturating_sub(1);
                may_be && self.inner(f, i).is_some_and(|b| named(b, BoundaryPlace::Inner(i)))
            })
    }

    /// Without stored boundary components: the half-edges and vertices named by the face are on its components, in order.
    pub(super) fn face_starts_ok(&self, f: usize) -> bool {
        if !self.by_name() {
            return true;
        }
        let starts = |start: Option<Start>, b: usize| match start {
            Some(Start::HalfEdge(named)) => self.boundary(named) == Some(b),
            Some(Start::Vertex(named)) => self.isolated(named) == Some(b),
            None => false,
        };
        let outer = match (self.view.outer_half_edge(f), self.outer(f)) {
            (None, outer) => outer.is_none(),
            (Some(h), outer) => outer.is_some_and(|b| starts(Some(Start::HalfEdge(h)), b)),
        };
        outer
            && self.view.inner_count(f) == self.inner_count(f)
            && (0..self.inner_count(f))
                .all(|i| self.inner(f, i).is_some_and(|b| starts(self.view.inner_start(f, i), b)))
    }
}
