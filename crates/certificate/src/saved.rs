//! A self-contained certificate: the structure and its labels as columns.

use super::answers::Answers;
use super::columns::{Column, DEAD, Labels, LabelsError, VACANT};
use super::storage::{Columns, Entries as _, Numbers as _};
use super::test::Failure;
use crate::NIL;
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Link, Parts, Start, View};

/// A structure with every part, and its ranks, as columns of 32-bit numbers: the files of a certificate.
///
/// Records keep their numbers from the structure, so slots may be vacant: then the first column of their kind contains
/// `u32::MAX - 1`. A certificate is a [`View`] and contains its own labels. The numbers may be arbitrary.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Certificate, Column, Labels};
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let certificate = Certificate::new(&edge, &Labels::new(&edge)?)?;
/// assert_eq!(certificate.columns().column(Column::HalfEdgeTwin), [1, 0]);
/// assert_eq!(certificate.check(), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Certificate<C = Labels> {
    pub(super) columns: C,
}

impl Certificate {
    /// Creates the certificate of a structure with these labels. O(n) for n slots and list entries; 24 bytes for each half-edge.
    ///
    /// Links that do not fit into 32 bits lead nowhere in it. A certificate has boundary components, and no columns for the names
    /// by which half-edges and faces name each other without them: if such a name differs from that given by the boundary
    /// component, there is no certificate. So [`check`](Self::check) passes only if [the check](super::check()) of the structure
    /// with these labels does.
    ///
    /// # Errors
    /// [`LabelsError::FaceOfHalfEdge`], [`LabelsError::StartsOfFace`], [`LabelsError::TooLarge`], [`LabelsError::OutOfMemory`].
    pub fn new<V: View + ?Sized>(view: &V, labels: &Labels) -> Result<Self, LabelsError> {
        let s = Answers::new(view, labels);
        let mut named = (0..s.half_edges).filter(|h| s.is_half_edge(*h));
        if let Some(h) = named.find(|h| !s.face_name_ok(*h, s.boundary(*h))) {
            return Err(LabelsError::FaceOfHalfEdge(h));
        }
        let mut naming = (0..s.faces).filter(|f| s.is_face(*f));
        if let Some(f) = naming.find(|f| !s.face_starts_ok(*f)) {
            return Err(LabelsError::StartsOfFace(f));
        }
        let mut columns = Labels::default();
        let mut fill = |column, slots: usize, number: &dyn Fn(usize) -> u32| -> Result<(), LabelsError> {
            let filled: &mut Vec<u32> = columns.column_mut(column);
            filled.try_reserve_exact(slots).map_err(|_| LabelsError::OutOfMemory)?;
            filled.extend((0..slots).map(number));
            Ok(())
        };
        let or_vacant = |live: bool, l: Link| if live { number(l) } else { VACANT };
        let cycle_start = |b| match s.start(b) {
            Some(Start::HalfEdge(h)) => Some(h),
            _ => None,
        };
        let vertex = |b| match s.start(b) {
            Some(Start::Vertex(v)) => Some(v),
            _ => None,
        };
        let place = |b| match s.place(b) {
            Some(BoundaryPlace::Inner(i)) => number(Some(i)),
            Some(BoundaryPlace::Outer) => NIL,
            None => DEAD,
        };
        fill(Column::HalfEdgeOrigin, s.half_edges, &|h| or_vacant(s.is_half_edge(h), s.origin(h)))?;
        fill(Column::HalfEdgeTwin, s.half_edges, &|h| number(s.twin(h)))?;
        fill(Column::HalfEdgeNext, s.half_edges, &|h| number(s.next(h)))?;
        fill(Column::HalfEdgePrev, s.half_edges, &|h| number(s.prev(h)))?;
        fill(Column::HalfEdgeBoundary, s.half_edges, &|h| number(s.boundary(h)))?;
        fill(Column::HalfEdgeRank, s.half_edges, &|h| labels.number(Column::HalfEdgeRank, h))?;
        fill(Column::VertexLeaving, s.vertices, &|v| or_vacant(s.is_vertex(v), s.leaving(v)))?;
        fill(Column::VertexIsolated, s.vertices, &|v| number(s.isolated(v)))?;
        fill(Column::BoundaryFace, s.boundaries, &|b| or_vacant(s.is_boundary(b), s.boundary_face(b)))?;
        fill(Column::BoundaryStart, s.boundaries, &|b| number(cycle_start(b)))?;
        fill(Column::BoundaryVertex, s.boundaries, &|b| number(vertex(b)))?;
        fill(Column::BoundaryPlace, s.boundaries, &place)?;
        fill(Column::FaceOuter, s.faces, &|f| or_vacant(s.is_face(f), s.outer(f)))?;
        for f in 0..s.faces {
            let listed = columns.column(Column::FaceInner).len();
            let end =
                listed.checked_add(s.inner_count(f)).filter(|end| *end < DEAD as usize).ok_or(LabelsError::TooLarge)?;
            let inner = columns.column_mut(Column::FaceInner);
            inner.try_reserve(end - listed).map_err(|_| LabelsError::OutOfMemory)?;
            inner.extend((0..end - listed).map(|i| number(s.inner(f, i))));
            columns.column_mut(Column::FaceEnd).push(end as u32);
        }
        Ok(Self { columns })
    }
}

impl<C: Columns> Certificate<C> {
    /// Creates the certificate with these columns. `None` if columns of one kind of record have different lengths.
    ///
    /// ```
    /// use twinedge_certificate::{Certificate, Column, Labels};
    /// let mut columns = Labels::default();
    /// assert!(Certificate::from_columns(columns.clone()).is_some());
    /// columns.column_mut(Column::HalfEdgeTwin).push(0);
    /// assert!(Certificate::from_columns(columns).is_none());
    /// ```
    #[must_use]
    pub fn from_columns(columns: C) -> Option<Self> {
        let kinds = [
            &[
                Column::HalfEdgeOrigin,
                Column::HalfEdgeTwin,
                Column::HalfEdgeNext,
                Column::HalfEdgePrev,
                Column::HalfEdgeBoundary,
                Column::HalfEdgeRank,
            ][..],
            &[Column::VertexLeaving, Column::VertexIsolated],
            &[Column::BoundaryFace, Column::BoundaryStart, Column::BoundaryVertex, Column::BoundaryPlace],
            &[Column::FaceOuter, Column::FaceEnd],
        ];
        let fits = kinds.iter().all(|kind| have_one_length(&columns, kind));
        fits.then_some(Self { columns })
    }

    /// Returns the columns.
    #[must_use]
    pub const fn columns(&self) -> &C {
        &self.columns
    }

    /// Checks the certificate, like [`check`](super::check()).
    ///
    /// # Errors
    /// The failed tests.
    pub fn check(&self) -> Result<(), Vec<Failure>> {
        super::check(self, &self.columns)
    }

    /// Returns true if the slot exists and is not vacant, given the first column of the kind of record.
    fn is_live(&self, column: Column, i: usize) -> bool {
        self.columns.column(column).at(i).is_some_and(|number| number != VACANT)
    }
}

pub(super) fn have_one_length<C: Columns>(columns: &C, kind: &[Column]) -> bool {
    kind.windows(2).all(|pair| columns.column(pair[0]).count() == columns.column(pair[1]).count())
}

pub(super) fn number(link: Link) -> u32 {
    match link {
        None => NIL,
        Some(to) => u32::try_from(to).unwrap_or(DEAD).min(DEAD),
    }
}

impl<C: Columns> View for Certificate<C> {
    fn parts(&self) -> Parts {
        Parts::ALL
    }
    fn vertex_slots(&self) -> usize {
        self.columns.column(Column::VertexLeaving).count()
    }
    fn half_edge_slots(&self) -> usize {
        self.columns.column(Column::HalfEdgeOrigin).count()
    }
    fn boundary_slots(&self) -> usize {
        self.columns.column(Column::BoundaryFace).count()
    }
    fn face_slots(&self) -> usize {
        self.columns.column(Column::FaceOuter).count()
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        self.is_live(Column::VertexLeaving, vertex)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.is_live(Column::HalfEdgeOrigin, half_edge)
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        self.is_live(Column::BoundaryFace, boundary)
    }
    fn is_face(&self, face: usize) -> bool {
        self.is_live(Column::FaceOuter, face)
    }
    fn origin(&self, half_edge: usize) -> Link {
        self.columns.link(Column::HalfEdgeOrigin, half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        self.columns.link(Column::HalfEdgeTwin, half_edge)
    }
    fn next(&self, half_edge: usize) -> Link {
        self.columns.link(Column::HalfEdgeNext, half_edge)
    }
    fn prev(&self, half_edge: usize) -> Link {
        self.columns.link(Column::HalfEdgePrev, half_edge)
    }
    fn boundary(&self, half_edge: usize) -> Link {
        self.columns.link(Column::HalfEdgeBoundary, half_edge)
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.columns.link(Column::VertexLeaving, vertex)
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.columns.link(Column::VertexIsolated, vertex)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.columns.link(Column::BoundaryFace, boundary)
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        let start = self.columns.link(Column::BoundaryStart, boundary);
        match (start, self.columns.link(Column::BoundaryVertex, boundary)) {
            (Some(h), None) => Some(Start::HalfEdge(h)),
            (None, Some(v)) => Some(Start::Vertex(v)),
            _ => None,
        }
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        let place = self.columns.link(Column::BoundaryPlace, boundary);
        Some(place.map_or(BoundaryPlace::Outer, BoundaryPlace::Inner))
    }
    fn outer(&self, face: usize) -> Link {
        self.columns.link(Column::FaceOuter, face)
    }
    fn inner_count(&self, face: usize) -> usize {
        let (begin, end) = self.columns.list(face);
        end.saturating_sub(begin)
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        self.columns.link(Column::FaceInner, self.columns.list(face).0.checked_add(position)?)
    }
}
