//! Splits an edge by a new vertex, and joins two edges.

use crate::dcel::access::OperatorError;
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryStart, HalfEdgeKey, Room, VertexKey, VertexLink};

/// The records made by [`Dcel::split_edge`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SplitEdge {
    /// The new vertex.
    pub vertex: VertexKey,
    /// The new half-edge, from the new vertex to the old target.
    pub half_edge: HalfEdgeKey,
}

/// The records dropped by [`Dcel::join_edges`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct JoinedEdges {
    /// The vertex between the two edges.
    pub vertex: VertexKey,
    /// The following half-edge, whose edge was removed.
    pub half_edge: HalfEdgeKey,
}

impl Dcel {
    /// Puts a new vertex on an edge. The given half-edge keeps its origin and ends at the new vertex. O(1).
    ///
    #[doc = include_str!("../pictures/split_edge.svg")]
    ///
    /// Inverse: [`Dcel::join_edges`] on the same half-edge.
    ///
    /// # Errors
    /// A stale key; [`OperatorError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let split = map.split_edge(h)?;
    /// assert_eq!(map.half_edge(h)?.target().key(), split.vertex);
    /// assert_eq!(map.half_edge(h)?.next().key(), split.half_edge);
    /// assert_eq!(map.half_edge(h)?.boundary_cycle().count(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "MEV")]
    pub fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<SplitEdge, OperatorError> {
        let h = self.half_edge_slot(half_edge)?;
        self.room_for(Room { vertices: 1, edges: 1, ..Room::NONE })?;
        self.follow(move |dcel| dcel.steps_to_split_edge(h))?;
        let t = self.store.twin(h);
        let b = self.store.origin(t);
        let (after_h, before_t) = (self.store.next(h), self.store.prev(t));

        let n = self.store.add_edge(b, b, self.store.boundary(h));
        let m = self.store.twin(n);
        let w = self.store.add_vertex(VertexLink::Leaving(n));
        self.store.set_origin(n, w);
        self.store.set_origin(t, w);
        self.store.set_boundary(m, self.store.boundary(t));
        if after_h != t {
            self.store.join(n, after_h);
            self.store.join(before_t, m);
        }
        self.store.join(h, n);
        self.store.join(m, t);
        if self.store.vertex_link(b) == VertexLink::Leaving(t) {
            self.store.set_vertex_link(b, VertexLink::Leaving(m));
        }
        Ok(SplitEdge { vertex: self.store.vertex_key(w), half_edge: self.store.half_edge_key(n) })
    }

    /// Joins the edge of a half-edge with the following edge, removing the vertex of degree 2 between them. O(1).
    ///
    #[doc = include_str!("../pictures/join_edges.svg")]
    ///
    /// Inverse: [`Dcel::split_edge`] on the same half-edge.
    ///
    /// # Errors
    /// A stale key; [`OperatorError::DegreeNotTwo`] if the degree of the half-edge's target is not 2;
    /// [`OperatorError::Loop`] if both half-edges leaving it belong to one edge.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let split = map.split_edge(h)?;
    /// let joined = map.join_edges(h)?;
    /// assert_eq!((joined.vertex, joined.half_edge), (split.vertex, split.half_edge));
    /// assert_eq!(map.half_edge(h)?.boundary_cycle().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "KEV")]
    pub fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<JoinedEdges, OperatorError> {
        let h = self.half_edge_slot(half_edge)?;
        let t = self.store.twin(h);
        let n = self.store.next(h);
        let m = self.store.twin(n);
        if n == t || self.store.next(m) != t {
            return Err(OperatorError::DegreeNotTwo(half_edge));
        }
        if n == h || m == h {
            return Err(OperatorError::Loop(half_edge));
        }
        self.follow(move |dcel| dcel.steps_to_join(h, n))?;
        let v = self.store.origin(t);
        let b = self.store.origin(m);
        let (after_n, before_m) = (self.store.next(n), self.store.prev(m));
        if after_n == m {
            self.store.join(h, t);
        } else {
            self.store.join(h, after_n);
            self.store.join(before_m, t);
        }
        self.store.set_origin(t, b);
        if self.store.vertex_link(b) == VertexLink::Leaving(m) {
            self.store.set_vertex_link(b, VertexLink::Leaving(t));
        }
        for (gone, stays) in [(n, h), (m, t)] {
            let component = self.store.boundary(gone);
            if self.store.start(component) == BoundaryStart::HalfEdge(gone) {
                self.store.set_start(component, BoundaryStart::HalfEdge(stays));
            }
        }
        let joined = JoinedEdges { vertex: self.store.vertex_key(v), half_edge: self.store.half_edge_key(n) };
        self.store.remove_edge(n);
        self.store.remove_vertex(v);
        Ok(joined)
    }
}
