//! References to records, and equality of structures. The key has been checked, so steps between records need no checks.

use super::structure::Dcel;
use crate::store::{
    BoundaryKey, BoundarySlot, BoundaryStart, FaceKey, FaceSlot, HalfEdgeKey, HalfEdgeSlot, OUTER, VertexKey,
    VertexLink, VertexSlot,
};
use core::fmt;
use core::hash::{Hash, Hasher};
use core::iter::FusedIterator;

macro_rules! element {
    ($(#[$doc:meta])* $name:ident, $slot:ident, $key:ident, $key_of:ident, $slots:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name<'a> {
            dcel: &'a Dcel,
            slot: $slot,
        }

        /// Two references are equal if they name the same record of the same structure.
        impl PartialEq for $name<'_> {
            fn eq(&self, other: &Self) -> bool {
                core::ptr::eq(self.dcel, other.dcel) && self.slot == other.slot
            }
        }

        impl Eq for $name<'_> {}

        impl Hash for $name<'_> {
            fn hash<H: Hasher>(&self, state: &mut H) {
                self.index().hash(state);
            }
        }

        impl fmt::Debug for $name<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.key().fmt(f)
            }
        }

        impl<'a> $name<'a> {
            #[inline]
            pub(super) const fn new(dcel: &'a Dcel, slot: $slot) -> Self {
                Self { dcel, slot }
            }

            /// Returns the key. O(1).
            #[must_use]
            #[inline]
            pub fn key(self) -> $key {
                self.dcel.store.$key_of(self.slot)
            }

            /// Returns the index. O(1). Reports name records by index, and as long as nothing is removed it can index a
            /// plain array.
            ///
            #[doc = concat!("It is less than [`Dcel::", $slots, "`](Dcel::", $slots, "). An index is used again once its record is removed.")]
            #[must_use]
            #[inline]
            pub fn index(self) -> usize {
                self.slot.index()
            }
        }
    };
}

element! {
    /// A vertex.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let v = keys.vertex(0).unwrap();
    /// let v = map.vertex(v)?;
    /// let leaving = v.leaving().unwrap();
    /// assert_eq!(leaving.origin(), v);
    /// assert!(v.isolated().is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Vertex, VertexSlot, VertexKey, vertex_key, "vertex_slots"
}
element! {
    /// A half-edge.
    ///
    /// ```text
    ///             face
    ///    prev             next
    ///   ──────► · ──────► · ──────►
    ///        origin     target
    ///           · ◄────── ·
    ///             twin
    /// ```
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let h = map.half_edge(h)?;
    /// assert_eq!(h.next().prev(), h);
    /// assert_eq!(h.twin().twin(), h);
    /// assert_eq!(h.next().origin(), h.target());
    /// assert_eq!(h.clockwise().origin(), h.origin());
    /// assert!(!h.face().is_unbounded() && h.twin().face().is_unbounded());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    HalfEdge, HalfEdgeSlot, HalfEdgeKey, half_edge_key, "half_edge_slots"
}
element! {
    /// A boundary component: a cycle of half-edges, or one isolated vertex.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let boundary = map.half_edge(h)?.boundary();
    /// assert!(boundary.is_outer());
    /// assert_eq!(boundary.start().unwrap().boundary(), boundary);
    /// // The other side of the same edges is an inner boundary component of the unbounded face.
    /// let other = map.half_edge(h)?.twin().boundary();
    /// assert!(!other.is_outer());
    /// assert!(other.face().is_unbounded());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Boundary, BoundarySlot, BoundaryKey, boundary_key, "boundary_slots"
}
element! {
    /// A face.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let triangle = map.half_edge(h)?.face();
    /// assert_eq!(triangle.outer(), Some(map.half_edge(h)?.boundary()));
    /// assert_eq!(triangle.outer_half_edge().unwrap().face(), triangle);
    /// assert_eq!(triangle.inner_count(), 0);
    /// assert!(map.unbounded_face().outer().is_none());
    /// assert_eq!(map.unbounded_face().inner().count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Face, FaceSlot, FaceKey, face_key, "face_slots"
}

impl<'a> Vertex<'a> {
    /// Returns a half-edge that leaves the vertex; `None` if the vertex is isolated. O(1).
    #[must_use]
    pub fn leaving(self) -> Option<HalfEdge<'a>> {
        match self.dcel.store.vertex_link(self.slot) {
            VertexLink::Leaving(h) => Some(HalfEdge::new(self.dcel, h)),
            VertexLink::Isolated(_) => None,
        }
    }

    /// Returns the boundary component of an isolated vertex. O(1).
    #[must_use]
    pub fn isolated(self) -> Option<Boundary<'a>> {
        match self.dcel.store.vertex_link(self.slot) {
            VertexLink::Leaving(_) => None,
            VertexLink::Isolated(b) => Some(Boundary::new(self.dcel, b)),
        }
    }
}

impl<'a> HalfEdge<'a> {
    /// Compares two half-edges of the same structure.
    #[inline]
    pub(super) fn is(self, other: Self) -> bool {
        self.slot == other.slot
    }

    /// Returns the vertex where the half-edge starts. O(1).
    #[must_use]
    #[inline]
    pub fn origin(self) -> Vertex<'a> {
        Vertex::new(self.dcel, self.dcel.store.origin(self.slot))
    }

    /// Returns the vertex where the half-edge ends. O(1).
    #[must_use]
    #[inline]
    pub fn target(self) -> Vertex<'a> {
        self.twin().origin()
    }

    /// Returns the other half-edge of the edge. O(1).
    #[must_use]
    #[inline]
    pub fn twin(self) -> Self {
        Self::new(self.dcel, self.dcel.store.twin(self.slot))
    }

    /// Returns the next half-edge on the cycle. O(1).
    #[must_use]
    #[inline]
    pub fn next(self) -> Self {
        Self::new(self.dcel, self.dcel.store.next(self.slot))
    }

    /// Returns the previous half-edge on the cycle. O(1).
    #[must_use]
    #[inline]
    pub fn prev(self) -> Self {
        Self::new(self.dcel, self.dcel.store.prev(self.slot))
    }

    /// Returns the next half-edge counter-clockwise around the origin: `twin(prev(h))`. O(1).
    #[must_use]
    #[inline]
    pub fn counter_clockwise(self) -> Self {
        self.prev().twin()
    }

    /// Returns the next half-edge clockwise around the origin: `next(twin(h))`. O(1).
    #[must_use]
    #[inline]
    pub fn clockwise(self) -> Self {
        self.twin().next()
    }

    /// Returns the boundary component of the half-edge. O(1).
    #[must_use]
    #[inline]
    pub fn boundary(self) -> Boundary<'a> {
        Boundary::new(self.dcel, self.dcel.store.boundary(self.slot))
    }

    /// Returns the face to the left. O(1).
    #[must_use]
    #[inline]
    pub fn face(self) -> Face<'a> {
        self.boundary().face()
    }
}

impl<'a> Boundary<'a> {
    /// Returns the face that the component bounds. O(1).
    #[must_use]
    #[inline]
    pub fn face(self) -> Face<'a> {
        Face::new(self.dcel, self.dcel.store.face(self.slot))
    }

    /// Tells whether this is the outer boundary component of its face. O(1).
    #[must_use]
    pub fn is_outer(self) -> bool {
        self.dcel.store.place(self.slot) == OUTER
    }

    /// Returns the half-edge where the cycle starts; `None` for an isolated vertex. O(1).
    #[must_use]
    #[inline]
    pub fn start(self) -> Option<HalfEdge<'a>> {
        match self.dcel.store.start(self.slot) {
            BoundaryStart::HalfEdge(h) => Some(HalfEdge::new(self.dcel, h)),
            BoundaryStart::Vertex(_) => None,
        }
    }

    /// Returns the isolated vertex; `None` for a cycle. O(1).
    #[must_use]
    pub fn isolated_vertex(self) -> Option<Vertex<'a>> {
        match self.dcel.store.start(self.slot) {
            BoundaryStart::HalfEdge(_) => None,
            BoundaryStart::Vertex(v) => Some(Vertex::new(self.dcel, v)),
        }
    }
}

impl<'a> Face<'a> {
    /// Tells whether this is the unbounded face. O(1).
    #[must_use]
    pub fn is_unbounded(self) -> bool {
        self.slot == self.dcel.store.unbounded()
    }

    /// Returns the outer boundary component; `None` for the unbounded face. O(1).
    #[must_use]
    #[inline]
    pub fn outer(self) -> Option<Boundary<'a>> {
        self.dcel.store.outer(self.slot).map(|b| Boundary::new(self.dcel, b))
    }

    /// Returns a half-edge of the outer boundary component, the textbooks' `OuterComponent`; `None` for the unbounded
    /// face. O(1).
    #[must_use]
    #[inline]
    pub fn outer_half_edge(self) -> Option<HalfEdge<'a>> {
        self.dcel.store.outer_half_edge(self.slot).map(|h| HalfEdge::new(self.dcel, h))
    }

    /// Returns the number of inner boundary components. O(1).
    #[must_use]
    pub fn inner_count(self) -> usize {
        self.dcel.store.inner_count(self.slot)
    }

    /// Returns the inner boundary components: holes and isolated vertices. O(1) per step.
    pub fn inner(self) -> impl Iterator<Item = Boundary<'a>> {
        (0..self.inner_count()).filter_map(move |position| self.inner_at(position))
    }

    #[inline]
    pub(super) fn inner_at(self, position: usize) -> Option<Boundary<'a>> {
        self.dcel.store.inner(self.slot, position).map(|b| Boundary::new(self.dcel, b))
    }
}

macro_rules! circulator {
    ($(#[$doc:meta])* $name:ident, $forward:ident, $backward:ident) => {
        $(#[$doc])*
        #[derive(Clone)]
        pub struct $name<'a> {
            /// The next half-edge from the front, and the last half-edge returned from the back; `None` once they have
            /// met. Both are initially the start, so no link is followed before it is needed.
            ends: Option<(HalfEdge<'a>, HalfEdge<'a>)>,
        }

        impl core::fmt::Debug for $name<'_> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_list().entries(self.clone()).finish()
            }
        }

        impl<'a> $name<'a> {
            #[inline]
            pub(super) fn new(start: Option<HalfEdge<'a>>) -> Self {
                Self { ends: start.map(|start| (start, start)) }
            }
        }

        impl<'a> Iterator for $name<'a> {
            type Item = HalfEdge<'a>;

            #[inline]
            fn next(&mut self) -> Option<Self::Item> {
                let (front, back) = self.ends?;
                let after = front.$forward();
                self.ends = if after.is(back) { None } else { Some((after, back)) };
                Some(front)
            }
        }

        impl DoubleEndedIterator for $name<'_> {
            #[inline]
            fn next_back(&mut self) -> Option<Self::Item> {
                let (front, back) = self.ends?;
                let before = back.$backward();
                self.ends = if before.is(front) { None } else { Some((front, before)) };
                Some(before)
            }
        }

        impl FusedIterator for $name<'_> {}
    };
}

circulator! {
    /// The half-edges of one cycle, in order of `next`; `rev()` for `prev`.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let (v, h) = (keys.vertex(0).unwrap(), keys.half_edge(0).unwrap());
    /// let cycle = map.half_edge(h)?.boundary_cycle();
    /// let vertices: Vec<_> = cycle.clone().map(|h| h.origin().key()).collect();
    /// assert_eq!((vertices.len(), vertices[0]), (3, v));
    /// // The half-edge itself comes last on the way back.
    /// assert_eq!(cycle.rev().last().map(|h| h.key()), Some(h));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Cycle, next, prev
}

circulator! {
    /// The half-edges that leave one vertex, counter-clockwise; `rev()` for clockwise.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let h = map.half_edge(h)?;
    /// let mut rotation = h.rotation();
    /// assert_eq!(rotation.next(), Some(h));
    /// assert_eq!(rotation.next(), Some(h.prev().twin()));
    /// assert_eq!(rotation.next(), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Rotation, counter_clockwise, clockwise
}

/// Two structures are equal if they have the same records under the same keys, with the same links, and lists in the same order.
/// Vacant slots do not matter. O(n).
///
/// ```
/// use twinedge::dcel::Dcel;
///
/// let mut map = Dcel::new();
/// let before = map.clone();
/// let made = map.add_isolated_vertex(map.unbounded_face().key())?;
/// assert_ne!(map, before);
/// map.remove_isolated_vertex(made.vertex)?;
/// assert_eq!(map, before);
/// # Ok::<(), twinedge::dcel::OperatorError>(())
/// ```
impl PartialEq for Dcel {
    fn eq(&self, other: &Self) -> bool {
        self.vertices().map(vertex).eq(other.vertices().map(vertex))
            && self.half_edges().map(half_edge).eq(other.half_edges().map(half_edge))
            && self.boundaries().map(boundary).eq(other.boundaries().map(boundary))
            && self.faces().map(face).eq(other.faces().map(face))
            && self.faces().zip(other.faces()).all(|(a, b)| a.inner().map(|b| b.key()).eq(b.inner().map(|b| b.key())))
    }
}

impl Eq for Dcel {}

fn vertex(v: Vertex<'_>) -> (VertexKey, Option<HalfEdgeKey>, Option<BoundaryKey>) {
    (v.key(), v.leaving().map(|h| h.key()), v.isolated().map(|b| b.key()))
}

fn half_edge(h: HalfEdge<'_>) -> ([HalfEdgeKey; 4], VertexKey, BoundaryKey) {
    let links = [h, h.twin(), h.next(), h.prev()].map(|h| h.key());
    (links, h.origin().key(), h.boundary().key())
}

fn boundary(b: Boundary<'_>) -> (BoundaryKey, FaceKey, Option<HalfEdgeKey>, Option<VertexKey>) {
    (b.key(), b.face().key(), b.start().map(|h| h.key()), b.isolated_vertex().map(|v| v.key()))
}

fn face(f: Face<'_>) -> (FaceKey, Option<BoundaryKey>) {
    (f.key(), f.outer().map(|b| b.key()))
}
