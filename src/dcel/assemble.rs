//! Builds a whole structure at once from columns of numbers.
//!
//! ```text
//!   a view   ─► import ────┐
//!   segments ─► `map` ─────┼─► Assembly ─► Dcel
//!   saved    ─► deserialize┘
//! ```

use super::structure::Dcel;
use crate::store::{BoundaryStart, InOrder, Numbered, RecordKind, Room, Store, VertexLink};
use alloc::vec;
use thiserror::Error;

/// The reason why columns cannot be [assembled](Assembly::assemble).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// There are too many records of this kind.
    #[error("there is no room for so many {0}")]
    Full(RecordKind),
    /// A row of a column is missing, is out of range, or contradicts another row.
    #[error("row {row} of the column `{column}` is wrong")]
    Wrong {
        /// The name of the column.
        column: &'static str,
        /// The number of the row.
        row: usize,
    },
}

/// A planar subdivision as columns. Records are numbered from 0 without gaps, and every number is in range.
///
/// Meant for structures that already have such columns. [`Dcel::from_faces`], [`Dcel::from_rotations`] and
/// [`Dcel::from_view`] take more common input, and check all rules.
#[derive(Clone, Copy, Debug)]
pub struct Assembly<'a> {
    /// By vertex: a half-edge that leaves it, or its boundary component if it is isolated.
    pub vertices: &'a [VertexLink<u32, u32>],
    /// By half-edge: its origin. The two half-edges of an edge have the numbers 2e and 2e + 1.
    pub origin: &'a [u32],
    /// By half-edge: the next half-edge. `prev` is derived.
    pub next: &'a [u32],
    /// By half-edge: its boundary component.
    pub boundary: &'a [u32],
    /// By boundary component: where it starts.
    pub starts: &'a [BoundaryStart<u32, u32>],
    /// By bounded face, numbered from 1: the outer boundary component. Face 0 is the unbounded face.
    pub outer: &'a [u32],
    /// The face and number of each inner boundary component, in the order of the lists.
    pub inner: &'a [(u32, u32)],
}

impl Assembly<'_> {
    fn need(&self) -> Room {
        Room {
            vertices: self.vertices.len(),
            edges: self.origin.len() / 2,
            boundaries: self.starts.len(),
            faces: self.outer.len(),
        }
    }

    /// Builds the structure. O(n). Record `i` of each kind gets the `i`-th slot; [`vertex_index`](Self::vertex_index) and
    /// [`half_edge_index`](Self::half_edge_index) return its index.
    ///
    /// Only the conditions that make walks terminate are checked: numbers are in range, successive half-edges meet at one
    /// vertex and share a boundary component, every half-edge has a predecessor, and every boundary component is listed
    /// once. [`Dcel::validate`] checks the other rules.
    ///
    /// ```
    /// use twinedge::dcel::extend::{Assembly, BoundaryStart, VertexLink};
    ///
    /// // An edge between two vertices.
    /// let assembly = Assembly {
    ///     vertices: &[VertexLink::Leaving(0), VertexLink::Leaving(1)],
    ///     origin: &[0, 1],
    ///     next: &[1, 0],
    ///     boundary: &[0, 0],
    ///     starts: &[BoundaryStart::HalfEdge(0)],
    ///     outer: &[],
    ///     inner: &[(0, 0)],
    /// };
    /// assert!(assembly.assemble()?.validate().is_valid());
    /// assert!(Assembly { next: &[0, 0], ..assembly }.assemble().is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`AssemblyError`] if the structure cannot hold this number of records, or if the columns fail a check.
    pub fn assemble(&self) -> Result<Dcel, AssemblyError> {
        self.check()?;
        self.assemble_right().map_err(AssemblyError::Full)
    }

    /// Assembles columns known to be valid.
    pub(super) fn assemble_right(&self) -> Result<Dcel, RecordKind> {
        Ok(self.link(Store::with_records(self.need())?, &InOrder))
    }

    fn check(&self) -> Result<(), AssemblyError> {
        let [vertices, half_edges, boundaries, faces] =
            [self.vertices.len(), self.origin.len(), self.starts.len(), self.outer.len() + 1];
        let is_below = |number: u32, count: usize| (number as usize) < count;
        let holds = |holds: bool, column: &'static str, row: usize| {
            if holds { Ok(()) } else { Err(AssemblyError::Wrong { column, row }) }
        };
        holds(half_edges & 1 == 0, "origin", half_edges)?;
        holds(self.next.len() == half_edges, "next", self.next.len())?;
        holds(self.boundary.len() == half_edges, "boundary", self.boundary.len())?;
        for h in 0..half_edges {
            holds(is_below(self.origin[h], vertices), "origin", h)?;
            holds(is_below(self.boundary[h], boundaries), "boundary", h)?;
        }
        let mut has_prev = vec![false; half_edges];
        for h in 0..half_edges {
            let next = self.next[h] as usize;
            let follows = next < half_edges
                && self.origin[next] == self.origin[h ^ 1]
                && self.boundary[next] == self.boundary[h]
                && !core::mem::replace(&mut has_prev[next], true);
            holds(follows, "next", h)?;
        }
        for (v, link) in self.vertices.iter().enumerate() {
            let is_own = match *link {
                VertexLink::Leaving(h) => self.origin.get(h as usize) == Some(&(v as u32)),
                VertexLink::Isolated(b) => self.starts.get(b as usize) == Some(&BoundaryStart::Vertex(v as u32)),
            };
            holds(is_own, "vertices", v)?;
        }
        for (b, start) in self.starts.iter().enumerate() {
            let is_own = match *start {
                BoundaryStart::HalfEdge(h) => self.boundary.get(h as usize) == Some(&(b as u32)),
                BoundaryStart::Vertex(v) => self.vertices.get(v as usize) == Some(&VertexLink::Isolated(b as u32)),
            };
            holds(is_own, "starts", b)?;
        }
        let mut is_listed = vec![false; boundaries];
        let mut is_new = |b: u32| is_listed.get_mut(b as usize).is_some_and(|listed| !core::mem::replace(listed, true));
        for (row, b) in self.outer.iter().enumerate() {
            let is_cycle = matches!(self.starts.get(*b as usize), Some(BoundaryStart::HalfEdge(_)));
            holds(is_new(*b) && is_cycle, "outer", row)?;
        }
        for (row, (f, b)) in self.inner.iter().enumerate() {
            holds(is_below(*f, faces) && is_new(*b), "inner", row)?;
        }
        let unlisted = is_listed.iter().position(|listed| !listed);
        unlisted.map_or(Ok(()), |b| holds(false, "starts", b))
    }

    /// Returns the index of the vertex with this number. O(1).
    #[must_use]
    pub const fn vertex_index(number: u32) -> u32 {
        number.saturating_add(1)
    }

    /// Returns the index of the half-edge with this number. O(1).
    #[must_use]
    pub const fn half_edge_index(number: u32) -> u32 {
        number.saturating_add(2)
    }

    /// Sets the links of all records; `slots` maps the numbers of this assembly to slots.
    pub(super) fn link(&self, mut store: Store, slots: &impl Numbered) -> Dcel {
        for (v, link) in (0..).zip(self.vertices) {
            store.set_vertex_link(
                slots.vertex(v),
                match *link {
                    VertexLink::Leaving(h) => VertexLink::Leaving(slots.half_edge(h)),
                    VertexLink::Isolated(b) => VertexLink::Isolated(slots.boundary(b)),
                },
            );
        }
        let columns = self.origin.iter().zip(self.next).zip(self.boundary);
        for (h, ((origin, next), b)) in (0..).zip(columns) {
            let h = slots.half_edge(h);
            store.set_origin(h, slots.vertex(*origin));
            store.set_boundary(h, slots.boundary(*b));
            store.join(h, slots.half_edge(*next));
        }
        for (b, start) in (0..).zip(self.starts) {
            store.set_start(
                slots.boundary(b),
                match *start {
                    BoundaryStart::HalfEdge(h) => BoundaryStart::HalfEdge(slots.half_edge(h)),
                    BoundaryStart::Vertex(v) => BoundaryStart::Vertex(slots.vertex(v)),
                },
            );
        }
        for (f, b) in (1..).zip(self.outer) {
            store.list_outer(slots.face(f), slots.boundary(*b));
        }
        for (f, b) in self.inner {
            store.list_inner(slots.face(*f), slots.boundary(*b));
        }
        Dcel { store }
    }
}
