//! A structure as plain tables, like those in textbooks. Every field can have any value.

mod text;

pub use text::ParseTableError;

use super::structure::{BoundaryPlace, Link, Parts, Start, View};
use alloc::vec::Vec;

/// A row of the vertex table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VertexRow {
    /// A half-edge that leaves the vertex.
    pub leaving: Link,
    /// The boundary component of an isolated vertex.
    pub isolated: Link,
}

/// A row of the half-edge table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HalfEdgeRow {
    /// The vertex where it starts.
    pub origin: Link,
    /// The other half-edge of the edge.
    pub twin: Link,
    /// The half-edge that follows on the cycle.
    pub next: Link,
    /// The half-edge that precedes on the cycle.
    pub prev: Link,
    /// Its boundary component.
    pub boundary: Link,
    /// The face to its left, in tables without boundary components.
    pub face: Link,
}

/// A row of the boundary component table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BoundaryRow {
    /// The face that it bounds.
    pub face: Link,
    /// Its start.
    pub start: Option<Start>,
    /// Its place in the list of its face.
    pub place: Option<BoundaryPlace>,
}

/// A row of the face table.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FaceRow {
    /// The outer boundary component.
    pub outer: Link,
    /// The inner boundary components.
    pub inner: Vec<Link>,
    /// A half-edge of the outer cycle, in tables without boundary components.
    pub outer_half_edge: Link,
    /// The starts of the inner boundary components, in tables without boundary components.
    pub inner_starts: Vec<Option<Start>>,
}

/// A structure as plain tables. A row that is `None` is vacant.
///
/// `Display` and `FromStr` write and read it as one line of text.
///
/// ```
/// use twinedge::validate::{BoundaryRow, Collect, Expectation, FaceRow, BoundaryPlace, Start, Table, VertexRow, validate};
/// // The smallest map: one isolated vertex in the unbounded face.
/// let table = Table {
///     vertices: vec![Some(VertexRow { leaving: None, isolated: Some(0) })],
///     boundaries: vec![Some(BoundaryRow {
///         face: Some(0),
///         start: Some(Start::Vertex(0)),
///         place: Some(BoundaryPlace::Inner(0)),
///     })],
///     faces: vec![Some(FaceRow { inner: vec![Some(0)], ..FaceRow::default() })],
///     ..Table::default()
/// };
/// assert!(validate(&table, &Expectation::plane(), Collect::All).is_valid());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Table {
    /// The stored parts, as [`View::parts`] answers. The default is all parts.
    #[cfg_attr(feature = "serde", serde(default))]
    pub parts: Parts,
    /// The vertex table.
    pub vertices: Vec<Option<VertexRow>>,
    /// The half-edge table.
    pub half_edges: Vec<Option<HalfEdgeRow>>,
    /// The boundary component table.
    pub boundaries: Vec<Option<BoundaryRow>>,
    /// The face table.
    pub faces: Vec<Option<FaceRow>>,
}

/// Creates `n` rows; `None` if memory runs out.
fn rows<T>(n: usize, row: impl FnMut(usize) -> T) -> Option<Vec<T>> {
    let mut rows = Vec::new();
    rows.try_reserve_exact(n).ok()?;
    rows.extend((0..n).map(row));
    Some(rows)
}

impl Table {
    /// Copies all answers of a structure. `None` if there is no memory for its claimed size. O(n) for n slots and list
    /// entries.
    #[must_use]
    pub fn copy_of<V: View + ?Sized>(view: &V) -> Option<Self> {
        let vertices = rows(view.vertex_slots(), |v| {
            view.is_vertex(v).then(|| VertexRow { leaving: view.leaving(v), isolated: view.isolated(v) })
        })?;
        let half_edges = rows(view.half_edge_slots(), |h| {
            view.is_half_edge(h).then(|| HalfEdgeRow {
                origin: view.origin(h),
                twin: view.twin(h),
                next: view.next(h),
                prev: view.prev(h),
                boundary: view.boundary(h),
                face: view.face(h),
            })
        })?;
        let boundaries = rows(view.boundary_slots(), |b| {
            view.is_boundary(b).then(|| BoundaryRow {
                face: view.boundary_face(b),
                start: view.boundary_start(b),
                place: view.boundary_place(b),
            })
        })?;
        let mut faces = rows(view.face_slots(), |_| None)?;
        for (f, row) in faces.iter_mut().enumerate().filter(|(f, _)| view.is_face(*f)) {
            let listed = view.inner_count(f);
            let mut inner = rows(listed, |i| view.inner(f, i))?;
            let mut inner_starts = rows(listed, |i| view.inner_start(f, i))?;
            // A structure answers one of the two questions, and nil to the other.
            if inner_starts.iter().all(Option::is_none) {
                inner_starts.clear();
            } else if inner.iter().all(Option::is_none) {
                inner.clear();
            }
            *row =
                Some(FaceRow { outer: view.outer(f), inner, outer_half_edge: view.outer_half_edge(f), inner_starts });
        }
        Some(Self { parts: view.parts(), vertices, half_edges, boundaries, faces })
    }

    fn half_edge(&self, h: usize) -> HalfEdgeRow {
        self.half_edges.get(h).copied().flatten().unwrap_or_default()
    }

    fn vertex(&self, v: usize) -> VertexRow {
        self.vertices.get(v).copied().flatten().unwrap_or_default()
    }

    fn boundary_row(&self, b: usize) -> BoundaryRow {
        self.boundaries.get(b).copied().flatten().unwrap_or_default()
    }

    fn face_row(&self, f: usize) -> Option<&FaceRow> {
        self.faces.get(f)?.as_ref()
    }
}

impl View for Table {
    fn parts(&self) -> Parts {
        self.parts
    }
    fn vertex_slots(&self) -> usize {
        self.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.boundaries.len()
    }
    fn face_slots(&self) -> usize {
        self.faces.len()
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        matches!(self.vertices.get(vertex), Some(Some(_)))
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        matches!(self.half_edges.get(half_edge), Some(Some(_)))
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        matches!(self.boundaries.get(boundary), Some(Some(_)))
    }
    fn is_face(&self, face: usize) -> bool {
        matches!(self.faces.get(face), Some(Some(_)))
    }
    fn origin(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).origin
    }
    fn twin(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).twin
    }
    fn next(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).next
    }
    fn prev(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).prev
    }
    fn boundary(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).boundary
    }
    fn face(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).face
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.vertex(vertex).leaving
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.vertex(vertex).isolated
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.boundary_row(boundary).face
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        self.boundary_row(boundary).start
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        self.boundary_row(boundary).place
    }
    fn outer(&self, face: usize) -> Link {
        self.face_row(face)?.outer
    }
    fn inner_count(&self, face: usize) -> usize {
        self.face_row(face).map_or(0, |row| row.inner.len().max(row.inner_starts.len()))
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        self.face_row(face)?.inner.get(position).copied().flatten()
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        self.face_row(face)?.outer_half_edge
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        self.face_row(face)?.inner_starts.get(position).copied().flatten()
    }
}
