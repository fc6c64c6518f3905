//! The checker: a scan that reads each record once, with the records named by its links.
//!
//! Each function is a row of the tables in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/certificates/Labels.v`, under the same
//! name. It has no walk, no set and no order, and does not contain the rules.

use super::answers::Answers;
use super::storage::Columns;
use super::sums::Sums;
use super::test::{Failure, Failures, Noted, Test, UntilFailure};
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Link, Start, View};

/// Checks the labels of a structure. If all tests pass, the structure keeps R1 … T4 of
/// [`Expectation::plane`](twinedge::validate::Expectation::plane).
///
/// The labels may be invalid, even of incorrect length, and the structure may be anything, as for
/// [`validate`](twinedge::validate::validate). A failed check does not imply a broken structure: the labels may be another's.
///
/// Cost: O(n) for n slots and list entries. Only failures allocate memory.
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
    let mut failures = Failures::new();
    run(view, labels, &mut failures);
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
    run(view, labels, &mut UntilFailure).is_some()
}

/// Runs every test. Returns `None` if the check ended early.
#[inline(always)]
fn run<V: View + ?Sized, C: Columns>(view: &V, labels: &C, noted: &mut impl Noted) -> Option<()> {
    let s = Answers::new(view, labels);
    let readable = s.readable();
    noted.note(Test::Readable, 0, readable)?;
    if readable { scan(&s, noted)?.note(noted) } else { None }
}

/// Runs every test of single records. Returns `None` if the check ended early.
#[inline(always)]
pub(super) fn scan<V: View + ?Sized, C: Columns>(s: &Answers<'_, V, C>, noted: &mut impl Noted) -> Option<Sums> {
    let mut sums = Sums::default();
    for h in (0..s.half_edges).filter(|h| s.is_half_edge(*h)) {
        sums.half_edges += 1;
        s.half_edge(h, noted)?;
    }
    for v in (0..s.vertices).filter(|v| s.is_vertex(*v)) {
        sums.rotations += usize::from(s.leaving(v).is_some());
        noted.note(Test::VertexOk, v, s.vertex_ok(v))?;
    }
    for b in (0..s.boundaries).filter(|b| s.is_boundary(*b)) {
        let is_cycle = s.cycle_start(b).is_some();
        sums.cycles += usize::from(is_cycle);
        sums.roots += usize::from(is_cycle && s.is_inner(b));
        noted.note(Test::StartOk, b, s.start_ok(b))?;
        noted.note(Test::PlaceOk, b, s.place_ok(b))?;
    }
    // A boundary component has one place. More entries can only be valid if answers change.
    let mut entries = s.boundaries;
    for f in (0..s.faces).filter(|f| s.is_face(*f)) {
        sums.unbounded += usize::from(s.outer(f).is_none());
        noted.note(Test::FaceOk, f, s.face_ok(f, &mut entries))?;
        noted.note(Test::FaceStartsOk, f, s.face_starts_ok(f))?;
    }
    Some(sums)
}

impl<V: View + ?Sized, C: Columns> Answers<'_, V, C> {
    /// Checks that the links of a half-edge, its neighbours and its origin fit together. Runs tests while `passes` returns true.
    #[inline(always)]
    pub(super) fn links_ok(
        &self,
        h: usize,
        [twin, next, prev]: [Link; 3],
        kept: Link,
        passes: &mut impl FnMut(Test, bool) -> bool,
    ) -> bool {
        passes(Test::TwinOk, twin.and_then(|t| self.twin(t)) == Some(h) && twin != Some(h))
            && passes(Test::NextOk, {
                next.and_then(|n| self.prev(n)) == Some(h) && prev.and_then(|p| self.next(p)) == Some(h)
            })
            && passes(Test::TargetOk, next.and_then(|n| self.origin(n)) == twin.and_then(|t| self.origin(t)))
            && passes(Test::OriginOk, kept.is_some())
    }

    /// Runs all tests of a half-edge. Links are rarely nil: reading them first spares the compiler repeated checks.
    #[inline(always)]
    fn half_edge(&self, h: usize, noted: &mut impl Noted) -> Option<()> {
        let whole_star = || {
            let ([t, n, p], kept, b) = (self.live_links(h)?, self.kept(h)?, self.boundary(h)?);
            Some(([Some(t), Some(n), Some(p)], Some(kept), Some(b)))
        };
        if whole_star().is_some_and(|(links, kept, b)| self.half_edge_ok(h, links, kept, b, |_, passes| passes)) {
            Some(())
        } else {
            noted.note_each(|noted| self.note_half_edge(h, noted))
        }
    }

    #[cold]
    #[inline(never)]
    fn note_half_edge(&self, h: usize, noted: &mut impl Noted) {
        self.half_edge_ok(h, self.links(h), self.kept(h), self.boundary(h), |test, passes| {
            noted.note(test, h, passes).is_some()
        });
    }

    /// Runs the tests of a half-edge until `passes` returns false.
    #[inline(always)]
    fn half_edge_ok(
        &self,
        h: usize,
        links: [Link; 3],
        kept: Link,
        boundary: Link,
        mut passes: impl FnMut(Test, bool) -> bool,
    ) -> bool {
        let [twin, next, prev] = links;
        let lower = |link: Link| self.is_lower(link, h);
        self.links_ok(h, links, kept, &mut passes)
            && passes(Test::CycleOk, {
                next.and_then(|n| self.boundary(n)) == boundary && boundary.and_then(|b| self.cycle_start(b)).is_some()
            })
            && passes(Test::RankOk, {
                lower(next) || lower(prev) || lower(twin) || boundary.is_some_and(|b| self.is_root(h, b))
            })
            && passes(Test::FaceNameOk, self.face_name_ok(h, boundary))
    }

    /// Without stored boundary components: the half-edge names the face of its boundary component.
    #[inline(always)]
    pub(super) fn face_name_ok(&self, h: usize, boundary: Link) -> bool {
        !self.by_name() || self.view.face(h) == boundary.and_then(|b| self.boundary_face(b))
    }

    /// `h` starts an inner boundary component of the unbounded face, or of a face whose outer cycle starts with a lower rank.
    fn is_root(&self, h: usize, b: usize) -> bool {
        let lies_lower = |f| self.outer(f).is_none_or(|outer| self.is_lower(self.cycle_start(outer), h));
        self.cycle_start(b) == Some(h) && self.is_inner(b) && self.boundary_face(b).is_some_and(lies_lower)
    }

    /// The vertex keeps a half-edge that leaves it, or names its own boundary component.
    fn vertex_ok(&self, v: usize) -> bool {
        let isolated = self.isolated(v);
        match self.leaving(v) {
            Some(h) => self.origin(h) == Some(v) && isolated.is_none(),
            None => isolated.is_some_and(|b| self.start(b) == Some(Start::Vertex(v))),
        }
    }

    /// The component starts with one of its half-edges, or is an isolated vertex and an inner one.
    fn start_ok(&self, b: usize) -> bool {
        match self.start(b) {
            Some(Start::HalfEdge(h)) => self.boundary(h) == Some(b),
            Some(Start::Vertex(v)) => {
                self.is_vertex(v) && self.leaving(v).is_none() && self.isolated(v) == Some(b) && self.is_inner(b)
            }
            None => false,
        }
    }

    fn place_ok(&self, b: usize) -> bool {
        match (self.boundary_face(b), self.place(b)) {
            (Some(f), Some(BoundaryPlace::Outer)) => self.outer(f) == Some(b),
            (Some(f), Some(BoundaryPlace::Inner(i))) => self.inner(f, i) == Some(b),
            _ => false,
        }
    }

    /// The entries of the list name the face and their places. `entries` is the number of entries that may still be valid.
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
