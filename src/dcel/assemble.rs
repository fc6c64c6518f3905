//! The one place where a whole structure is put together at once, from columns of numbers.
//!
//! ```text
//!   a view   ─► import ────┐
//!   segments ─► arrange ───┼─► Assembly ─► Dcel
//!   saved    ─► deserialize┘
//! ```

use super::structure::Dcel;
use crate::store::{BoundaryStart, InOrder, Numbered, RecordKind, Room, Store, VertexLink};

/// A planar subdivision as columns. Records are numbered from 0 without gaps, and every number is in range.
///
/// Nothing is checked here: the columns must keep the rules R1 … T4, by the way in which they were made or by validation
/// before or after.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Assembly<'a> {
    /// By vertex: a half-edge that leaves it, or the boundary component that it is.
    pub(crate) vertices: &'a [VertexLink<u32, u32>],
    /// By half-edge: its origin. The two half-edges of an edge have the numbers 2e and 2e + 1.
    pub(crate) origin: &'a [u32],
    /// By half-edge: the one that follows. `prev` comes from it.
    pub(crate) next: &'a [u32],
    /// By half-edge: its boundary component.
    pub(crate) boundary: &'a [u32],
    /// By boundary component: where it starts.
    pub(crate) starts: &'a [BoundaryStart<u32, u32>],
    /// By bounded face, which have the numbers 1 .. : the outer boundary component. Face 0 is the unbounded one.
    pub(crate) outer: &'a [u32],
    /// Each inner boundary component after the face that lists it, in the order of the lists.
    pub(crate) inner: &'a [(u32, u32)],
}

impl Assembly<'_> {
    /// Returns the number of records of each kind, without the unbounded face.
    fn need(&self) -> Room {
        Room {
            vertices: self.vertices.len(),
            edges: self.origin.len() / 2,
            boundaries: self.starts.len(),
            faces: self.outer.len(),
        }
    }

    /// The structure. O(n). Record `i` of each kind gets the `i`-th slot, so that
    /// [`vertex_index`](Self::vertex_index) and its kin tell its index.
    ///
    /// # Errors
    /// The kind of record of which there are more than a store can hold.
    pub(crate) fn assemble(&self) -> Result<Dcel, RecordKind> {
        Ok(self.link(Store::with_records(self.need())?, &InOrder))
    }

    /// The index of the vertex with this number.
    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn vertex_index(number: u32) -> u32 {
        number + 1
    }

    /// The index of the half-edge with this number.
    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn half_edge_index(number: u32) -> u32 {
        number + 2
    }

    /// Sets the links of all records, of which those with the numbers of this assembly have these slots.
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
