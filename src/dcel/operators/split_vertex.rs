//! Splits a vertex in two, and contracts an edge.

use super::corner::{CheckedCorner, Corner};
use super::walk::OneOfTwo;
use crate::dcel::access::OperatorError;
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryStart, HalfEdgeKey, HalfEdgeSlot, Room, VertexKey, VertexLink, VertexSlot};

/// The records made by [`Dcel::split_vertex`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SplitVertex {
    /// The new vertex, which gets the smaller number of half-edges.
    pub vertex: VertexKey,
    /// The new half-edge, to the vertex with the half-edges counter-clockwise between the corners.
    pub half_edge: HalfEdgeKey,
}

/// The records kept and dropped by [`Dcel::contract_edge`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ContractedEdge {
    /// The surviving vertex: the one with more half-edges, or the origin if both have the same number.
    pub kept: VertexKey,
    /// The removed vertex.
    pub dropped: VertexKey,
}

impl Dcel {
    /// Splits a vertex in two, joined by a new edge between two of its corners.
    ///
    /// The half-edges met when turning counter-clockwise from the first corner to the second move to the target of the new
    /// half-edge, the others to its origin. Equal corners make the target a leaf in that corner. An isolated vertex becomes
    /// an edge.
    ///
    #[doc = include_str!("../pictures/split_vertex.svg")]
    ///
    /// O(size of the smaller rotation): both rotations are walked in step, and the smaller one, or the target's if they are
    /// equally large, moves to the new vertex.
    ///
    /// Inverse: [`Dcel::contract_edge`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NotIsolated`]; [`OperatorError::VerticesDiffer`]; [`OperatorError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// // Between a corner and itself: a leaf grows into the face.
    /// let leaf = map.split_vertex(h, h)?;
    /// assert_eq!(map.half_edge(leaf.half_edge)?.target().key(), leaf.vertex);
    /// assert_eq!(map.vertex(leaf.vertex)?.degree(), 1);
    /// assert_eq!(map.half_edge(h)?.boundary_cycle().count(), 5);
    /// // Between the two corners of a vertex of degree 2: another edge on the way around.
    /// let other = map.half_edge(h)?.next();
    /// let (inside, beyond) = (other.key(), other.twin().next().key());
    /// map.split_vertex(inside, beyond)?;
    /// assert_eq!(map.half_edge(h)?.boundary_cycle().count(), 6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "MEV")]
    pub fn split_vertex(
        &mut self,
        from: impl Into<Corner>,
        to: impl Into<Corner>,
    ) -> Result<SplitVertex, OperatorError> {
        let (from, to) = (self.checked_corner(from.into())?, self.checked_corner(to.into())?);
        let (v, other) = (from.vertex(&self.store), to.vertex(&self.store));
        if v != other {
            return Err(OperatorError::VerticesDiffer(self.store.vertex_key(v), self.store.vertex_key(other)));
        }
        self.room_for(Room { vertices: 1, edges: 1, ..Room::NONE })?;
        self.follow(move |dcel| dcel.steps_to_split_vertex(v, [from, to]))?;
        let b = from.boundary(&self.store);
        let n = self.store.add_edge(v, v, to.boundary(&self.store));
        let t = self.store.twin(n);
        self.store.set_boundary(t, b);
        let w = self.store.add_vertex(VertexLink::Leaving(t));
        if let (CheckedCorner::At(ha), CheckedCorner::At(hb)) = (from, to) {
            let (before_a, before_b) = (self.store.prev(ha), self.store.prev(hb));
            self.store.join(t, ha);
            self.store.join(before_b, n);
            if ha == hb {
                self.store.join(n, t);
            } else {
                self.store.join(n, hb);
                self.store.join(before_a, t);
            }
        } else {
            self.store.set_start(b, BoundaryStart::HalfEdge(n));
        }
        // The edge is in place; all half-edges but `t` still leave `v`, even if they should leave `w`.
        match self.smaller_rotation(n, t) {
            OneOfTwo::Second => {
                self.hand_over(t, w);
                self.store.set_vertex_link(v, VertexLink::Leaving(n));
            }
            OneOfTwo::First => {
                self.hand_over(n, w);
                self.store.set_vertex_link(v, VertexLink::Leaving(t));
                self.store.set_vertex_link(w, VertexLink::Leaving(n));
            }
        }
        Ok(SplitVertex { vertex: self.store.vertex_key(w), half_edge: self.store.half_edge_key(n) })
    }

    /// Returns the smaller of two rotations of different vertices; the second if they are equally large. O(smaller).
    fn smaller_rotation(&self, first: HalfEdgeSlot, second: HalfEdgeSlot) -> OneOfTwo {
        let turn = |h: HalfEdgeSlot| self.store.next(self.store.twin(h));
        let (mut a, mut b) = (first, second);
        loop {
            b = turn(b);
            if b == second {
                return OneOfTwo::Second;
            }
            a = turn(a);
            if a == first {
                return OneOfTwo::First;
            }
        }
    }

    fn hand_over(&mut self, first: HalfEdgeSlot, v: VertexSlot) {
        let mut h = first;
        loop {
            self.store.set_origin(h, v);
            h = self.store.next(self.store.twin(h));
            if h == first {
                return;
            }
        }
    }

    /// Contracts an edge to a point, merging its two vertices.
    ///
    #[doc = include_str!("../pictures/contract_edge.svg")]
    ///
    /// O(size of the smaller rotation).
    ///
    /// Inverse: [`Dcel::split_vertex`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::Loop`] if the edge starts and ends at the same vertex.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let contracted = map.contract_edge(h)?;
    /// assert!(map.half_edge(h).is_err());
    /// assert!(map.vertex(contracted.dropped).is_err());
    /// // Two parallel edges are left.
    /// assert_eq!(map.vertex(contracted.kept)?.degree(), 2);
    /// assert_eq!(map.edge_count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "KEV")]
    pub fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<ContractedEdge, OperatorError> {
        let n = self.half_edge_slot(half_edge)?;
        let t = self.store.twin(n);
        let (origin, target) = (self.store.origin(n), self.store.origin(t));
        if origin == target {
            return Err(OperatorError::Loop(half_edge));
        }
        let (kept, dropped) = match self.smaller_rotation(n, t) {
            OneOfTwo::Second => (origin, target),
            OneOfTwo::First => (target, origin),
        };
        self.follow(move |dcel| dcel.steps_to_contract(n, [kept, dropped]))?;
        self.hand_over(if dropped == target { t } else { n }, kept);
        let stays = [self.store.next(t), self.store.next(n)].into_iter().find(|h| *h != n && *h != t);
        for h in [n, t] {
            let (before, after) = (self.store.prev(h), self.store.next(h));
            let component = self.store.boundary(h);
            if self.store.start(component) == BoundaryStart::HalfEdge(h) {
                // If that is `t`, it is removed next; a cycle of only this edge is settled below, at the isolated vertex.
                self.store.set_start(component, BoundaryStart::HalfEdge(after));
            }
            self.store.join(before, after);
        }
        if let Some(h) = stays {
            self.store.set_vertex_link(kept, VertexLink::Leaving(h));
        } else {
            let component = self.store.boundary(n);
            self.store.set_start(component, BoundaryStart::Vertex(kept));
            self.store.set_vertex_link(kept, VertexLink::Isolated(component));
        }
        let contracted = ContractedEdge { kept: self.store.vertex_key(kept), dropped: self.store.vertex_key(dropped) };
        self.store.remove_edge(n);
        self.store.remove_vertex(dropped);
        Ok(contracted)
    }
}
