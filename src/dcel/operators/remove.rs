//! Removes edges.

use super::walk::OneOfTwo;
use crate::dcel::access::OperatorError;
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryKey, BoundaryStart, FaceKey, HalfEdgeKey, HalfEdgeSlot, Room, VertexLink};

/// The result of [`Dcel::remove_edge`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RemovedEdge {
    /// Two faces became one, and two cycles one.
    Merged {
        /// The surviving face.
        kept_face: FaceKey,
        /// The removed face.
        dropped_face: FaceKey,
        /// The boundary component of the joined cycle.
        kept: BoundaryKey,
        /// The removed boundary component.
        dropped: BoundaryKey,
    },
    /// One boundary component became two, and one component two.
    Parted {
        /// The old boundary component. It keeps the longer of the two parts.
        kept: BoundaryKey,
        /// The new boundary component, with the other part.
        made: BoundaryKey,
    },
}

struct Neighbourhood<H> {
    n: H,
    t: H,
    before_n: H,
    after_n: H,
    before_t: H,
    after_t: H,
}

impl Dcel {
    /// Removes an edge. Its vertices stay; a vertex without another edge becomes isolated.
    ///
    /// If the edge separates two faces, they merge. If it lies on the outer boundary of both, the face to the left of
    /// `half_edge` survives. Otherwise one face surrounds the other and survives. The inner boundary components of the dropped
    /// face move to the survivor.
    ///
    /// If both sides of the edge lie on the same cycle, the edge is a bridge, and its component falls into two. If the cycle is
    /// an outer one, the part with the outside of the component keeps the outer boundary component, and the other part becomes
    /// an inner one.
    ///
    #[doc = include_str!("../pictures/remove_edge.svg")]
    ///
    /// Merging takes O(length of the shorter cycle + inner boundary components of the dropped face). Parting takes O(length of
    /// the shorter part of the cycle), plus, on an outer cycle, a search of both parts in step for the outside, O(size of the
    /// smaller part). The part is not an argument because only one answer keeps rule T1.
    ///
    /// Inverse: [`Dcel::connect`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::Full`] if parting has no room for a boundary component.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, RemovedEdge};
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let outside = map.unbounded_face().key();
    /// // The edge separates the triangle from the unbounded face: both become one.
    /// assert!(matches!(map.remove_edge(h)?, RemovedEdge::Merged { kept_face, .. } if kept_face == outside));
    /// // What is left is a path. Without one of its edges it falls in two.
    /// let path = map.half_edges().next().unwrap().key();
    /// assert!(matches!(map.remove_edge(path)?, RemovedEdge::Parted { .. }));
    /// assert_eq!((map.edge_count(), map.boundary_count()), (1, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "KEF")]
    #[doc(alias = "KEMR")]
    pub fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<RemovedEdge, OperatorError> {
        let n = self.half_edge_slot(half_edge)?;
        let t = self.store.twin(n);
        let around = Neighbourhood {
            n,
            t,
            before_n: self.store.prev(n),
            after_n: self.store.next(n),
            before_t: self.store.prev(t),
            after_t: self.store.next(t),
        };
        if self.store.boundary(n) != self.store.boundary(t) {
            return self.merge(&around);
        }
        self.room_for(Room { boundaries: 1, ..Room::NONE })?;
        self.follow(move |dcel| dcel.steps_to_remove_edge(n, None))?;
        Ok(self.part(&around))
    }

    /// Sets other leaving half-edges for the ends of the edge, if they have any.
    fn release_ends(&mut self, around: &Neighbourhood<HalfEdgeSlot>) {
        let Neighbourhood { n, t, after_n, after_t, .. } = *around;
        let (a, b) = (self.store.origin(n), self.store.origin(t));
        // Where these start is known, so their records are not read.
        let others = [(after_t, a), (after_n, b)];
        for end in [a, b] {
            if let Some((h, _)) = others.into_iter().find(|(h, v)| *h != n && *h != t && *v == end) {
                self.store.set_vertex_link(end, VertexLink::Leaving(h));
            }
        }
    }

    fn merge(&mut self, around: &Neighbourhood<HalfEdgeSlot>) -> Result<RemovedEdge, OperatorError> {
        let Neighbourhood { n, t, before_n, after_n, before_t, after_t } = *around;
        let (bn, bt) = (self.store.boundary(n), self.store.boundary(t));
        let (fn_, ft) = (self.store.face(bn), self.store.face(bt));
        // A surrounding face has the cycle as an inner one. Of two faces side by side the left one survives.
        let (kept_face, dropped_face, outer) = match (self.is_outer(bn), self.is_outer(bt)) {
            (true, true) => (fn_, ft, true),
            (true, false) => (ft, fn_, false),
            (false, _) => (fn_, ft, false),
        };
        self.follow(move |dcel| dcel.steps_to_remove_edge(n, Some([kept_face, dropped_face])))?;
        // Read before the walks, so that these records are fetched while the half-edges are.
        let faces = [kept_face, dropped_face].map(|f| self.store.face_key(f));
        let [bn, bt] = [bn, bt].map(|b| (b, self.store.boundary_key(b)));
        let shorter = self.shorter_or_second((Some(n), before_n), (Some(t), before_t));
        let ((kept, kept_key), (dropped, dropped_key), first, last) = match shorter {
            OneOfTwo::First => (bt, bn, n, before_n),
            OneOfTwo::Second => (bn, bt, t, before_t),
        };
        self.relabel(first, last, kept);

        self.release_ends(around);
        let start = match (after_n == n, after_t == t) {
            (true, true) => None,
            (true, false) => {
                self.store.join(before_t, after_t);
                Some(after_t)
            }
            (false, true) => {
                self.store.join(before_n, after_n);
                Some(after_n)
            }
            (false, false) => {
                self.store.join(before_n, after_t);
                self.store.join(before_t, after_n);
                Some(after_t)
            }
        };
        let v = self.store.origin(n);
        self.store.set_start(kept, start.map_or(BoundaryStart::Vertex(v), BoundaryStart::HalfEdge));
        if start.is_none() {
            self.store.set_vertex_link(v, VertexLink::Isolated(kept));
        }
        if outer {
            // In place of both, as the other face goes.
            self.store.list_outer(kept_face, kept);
        } else {
            self.store.unlist(kept);
            self.store.unlist(dropped);
            self.store.list_inner(kept_face, kept);
        }
        // From the end, so no other component changes its place.
        while let Some(b) = self.store.last_inner(dropped_face) {
            self.store.unlist(b);
            self.store.list_inner(kept_face, b);
        }
        self.store.remove_boundary(dropped);
        self.store.remove_face(dropped_face);
        self.store.remove_edge(n);
        let [kept_face, dropped_face] = faces;
        Ok(RemovedEdge::Merged { kept_face, dropped_face, kept: kept_key, dropped: dropped_key })
    }

    fn part(&mut self, around: &Neighbourhood<HalfEdgeSlot>) -> RemovedEdge {
        let Neighbourhood { n, t, before_n, after_n, before_t, after_t } = *around;
        let kept = self.store.boundary(n);
        let f = self.store.face(kept);
        let (origin, target) = (self.store.origin(n), self.store.origin(t));
        let outside = self.is_outer(kept).then(|| self.part_with_outside(n, t));
        let at_origin = (after_t != n).then_some(after_t);
        let at_target = (after_n != t).then_some(after_n);
        let shorter = self.shorter_or_second((at_origin, before_n), (at_target, before_t));

        self.release_ends(around);
        if at_origin.is_some() {
            self.store.join(before_n, after_t);
        }
        if at_target.is_some() {
            self.store.join(before_t, after_n);
        }
        let made = self.store.add_boundary(f, BoundaryStart::Vertex(target));
        let (of_origin, of_target) = match shorter {
            OneOfTwo::First => (made, kept),
            OneOfTwo::Second => (kept, made),
        };
        for (b, start, vertex) in [(of_origin, at_origin, origin), (of_target, at_target, target)] {
            if let Some(h) = start {
                self.store.set_start(b, BoundaryStart::HalfEdge(h));
                if b == made {
                    self.relabel(h, self.store.prev(h), made);
                }
            } else {
                self.store.set_start(b, BoundaryStart::Vertex(vertex));
                self.store.set_vertex_link(vertex, VertexLink::Isolated(b));
            }
        }
        let stays_outer = outside.map(|which| match which {
            OneOfTwo::First => of_origin,
            OneOfTwo::Second => of_target,
        });
        self.store.unlist(kept);
        for b in [kept, made] {
            self.list(f, b, Some(b) == stays_outer);
        }
        self.store.remove_edge(n);
        RemovedEdge::Parted { kept: self.store.boundary_key(kept), made: self.store.boundary_key(made) }
    }
}
