//! Connecting two corners by an edge.

use super::corner::{CheckedCorner, Corner};
use super::walk::OneOfTwo;
use crate::dcel::access::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryKey, BoundaryStart, FaceKey, HalfEdgeKey, HalfEdgeSlot, Room, VertexLink};

/// A side of a half-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// The side of its own face.
    #[default]
    Left,
    /// The side of its twin's face.
    Right,
}

/// Options of [`Dcel::connect`] for splitting a face. A bridge ignores them, but stale keys are still errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Split<'a> {
    /// The side of the new edge on which the new face lies. The old face keeps the other side.
    ///
    /// If an inner cycle is split, the new face is the enclosed part.
    pub new_face: Side,
    /// The inner boundary components of the old face that move to the new one.
    pub inner: &'a [BoundaryKey],
}

/// The change that [`Dcel::connect`] made to the boundary components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Connection {
    /// Two boundary components became one.
    Bridge {
        /// The component of all half-edges now: the longer of the two, or the second corner's if they are equally long.
        kept: BoundaryKey,
        /// The removed component.
        dropped: BoundaryKey,
    },
    /// One cycle became two, and one face two.
    Split {
        /// The split boundary component. It keeps the longer of the two cycles, or the left one if they are equally long.
        kept: BoundaryKey,
        /// The new boundary component, with the other cycle.
        made: BoundaryKey,
        /// The new face.
        face: FaceKey,
    },
}

/// The result of [`Dcel::connect`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Connected {
    /// The new half-edge, from the first corner to the second.
    pub half_edge: HalfEdgeKey,
    /// The change to the boundary components.
    pub connection: Connection,
}

impl Connected {
    /// Returns the new face, if a face was split.
    #[must_use]
    pub const fn new_face(&self) -> Option<FaceKey> {
        match self.connection {
            Connection::Split { face, .. } => Some(face),
            Connection::Bridge { .. } => None,
        }
    }
}

impl Dcel {
    /// Connects two corners of one face by a new edge.
    ///
    /// If the corners lie on different boundary components, the edge is a bridge that joins them. If they lie on the same
    /// component, the edge splits the face.
    ///
    #[doc = include_str!("../pictures/connect.svg")]
    ///
    /// Equal corners yield a loop. The old cycle continues to the left of the new half-edge, and the loop alone lies to the
    /// right. [`Split::new_face`] still chooses the side of the new face.
    ///
    /// O(length of the shorter cycle + boundary components moved to the new face): both sides are walked in step, and only the
    /// shorter one is relabelled. O(1) to or from an isolated vertex.
    ///
    /// Inverse: [`Dcel::remove_edge`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NotIsolated`]; [`OperatorError::FacesDiffer`]; [`OperatorError::NotInner`] if a component
    /// to be moved is not another inner one of the face; [`OperatorError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::{Connection, Dcel, Side, Split};
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// let [a, b, c] = [(); 3].map(|()| map.add_isolated_vertex(outside).map(|added| added.vertex));
    /// // Two bridges …
    /// let ab = map.connect(a?, b?, Split::default())?.half_edge;
    /// let ba = map.half_edge(ab)?.twin().key();
    /// let bc = map.connect(ba, c?, Split::default())?;
    /// assert!(matches!(bc.connection, Connection::Bridge { .. }));
    /// // … and an edge that closes the triangle. The new face lies to its left.
    /// let cb = map.half_edge(bc.half_edge)?.twin().key();
    /// let ca = map.connect(cb, ab, Split { new_face: Side::Left, inner: &[] })?;
    /// assert_eq!(ca.new_face(), Some(map.half_edge(ab)?.face().key()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "MEF")]
    #[doc(alias = "MEKR")]
    pub fn connect(
        &mut self,
        from: impl Into<Corner>,
        to: impl Into<Corner>,
        split: Split<'_>,
    ) -> Result<Connected, OperatorError> {
        let (from, to) = (self.checked_corner(from.into())?, self.checked_corner(to.into())?);
        let (ba, bb) = (from.boundary(&self.store), to.boundary(&self.store));
        let (fa, fb) = (self.store.face(ba), self.store.face(bb));
        // A bridge ignores these, but a stale key is still an error.
        let mut not_inner = None;
        for key in split.inner {
            let b = self.store.find_boundary(*key).ok_or(StaleKey::Boundary(*key))?;
            if b == ba || self.store.face(b) != fa || self.is_outer(b) {
                not_inner = not_inner.or(Some(*key));
            }
        }
        if fa != fb {
            return Err(OperatorError::FacesDiffer(self.store.face_key(fa), self.store.face_key(fb)));
        }
        if ba != bb {
            self.room_for(Room { edges: 1, ..Room::NONE })?;
            self.follow(move |dcel| dcel.steps_to_connect([from, to], None))?;
            return Ok(self.bridge(from, to));
        }
        self.room_for(Room { edges: 1, boundaries: 1, faces: 1, ..Room::NONE })?;
        if let Some(key) = not_inner {
            return Err(OperatorError::NotInner(key));
        }
        self.follow(move |dcel| dcel.steps_to_connect([from, to], Some(fa)))?;
        Ok(self.split_face(from, to, split))
    }

    /// Makes an edge between two corners, which may be equal, and returns the half-edge from the first to the second. The
    /// caller sets its boundary component.
    fn attach(&mut self, from: CheckedCorner, to: CheckedCorner) -> HalfEdgeSlot {
        let (va, vb) = (from.vertex(&self.store), to.vertex(&self.store));
        let n = self.store.add_edge(va, vb, from.boundary(&self.store));
        let t = self.store.twin(n);
        match (from, to) {
            (CheckedCorner::Isolated(v, _), CheckedCorner::Isolated(w, _)) if v == w => {
                self.store.join(n, n);
                self.store.join(t, t);
            }
            (CheckedCorner::At(ha), CheckedCorner::At(hb)) if ha == hb => {
                let before = self.store.prev(ha);
                self.store.join(before, n);
                self.store.join(n, ha);
                self.store.join(t, t);
            }
            _ => {
                // A new edge is its own next and prev, as required at an isolated vertex.
                let before = |corner| match corner {
                    CheckedCorner::At(h) => Some((self.store.prev(h), h)),
                    CheckedCorner::Isolated(..) => None,
                };
                let (at_from, at_to) = (before(from), before(to));
                if let Some((before, after)) = at_from {
                    self.store.join(before, n);
                    self.store.join(t, after);
                }
                if let Some((before, after)) = at_to {
                    self.store.join(before, t);
                    self.store.join(n, after);
                }
            }
        }
        for (corner, leaving) in [(from, n), (to, t)] {
            if let CheckedCorner::Isolated(v, _) = corner {
                self.store.set_vertex_link(v, VertexLink::Leaving(leaving));
            }
        }
        n
    }

    fn bridge(&mut self, from: CheckedCorner, to: CheckedCorner) -> Connected {
        let (ba, bb) = (from.boundary(&self.store), to.boundary(&self.store));
        let stretch = |corner: CheckedCorner| match corner {
            CheckedCorner::At(h) => Some(h),
            CheckedCorner::Isolated(..) => None,
        };
        let (sa, sb) = (stretch(from), stretch(to));
        let shorter = match (sa, sb) {
            (Some(a), Some(b)) => self.shorter_or_first(a, b),
            (Some(_), None) => OneOfTwo::Second,
            (None, _) => OneOfTwo::First,
        };
        let (kept, dropped, relabelled) = match shorter {
            OneOfTwo::First => (bb, ba, sa),
            OneOfTwo::Second => (ba, bb, sb),
        };
        if let Some(h) = relabelled {
            self.relabel(h, self.store.prev(h), kept);
        }
        let n = self.attach(from, to);
        let t = self.store.twin(n);
        self.store.set_boundary(n, kept);
        self.store.set_boundary(t, kept);
        if let BoundaryStart::Vertex(_) = self.store.start(kept) {
            self.store.set_start(kept, BoundaryStart::HalfEdge(n));
        }
        let f = self.store.face(kept);
        if self.is_outer(dropped) {
            self.store.unlist(kept);
            self.store.unlist(dropped);
            self.store.list_outer(f, kept);
        } else {
            self.store.unlist(dropped);
        }
        let connection =
            Connection::Bridge { kept: self.store.boundary_key(kept), dropped: self.store.boundary_key(dropped) };
        self.store.remove_boundary(dropped);
        Connected { half_edge: self.store.half_edge_key(n), connection }
    }

    /// Returns the shorter of two whole cycles, the first if they are equally long. O(shorter).
    fn shorter_or_first(&self, a: HalfEdgeSlot, b: HalfEdgeSlot) -> OneOfTwo {
        match self.shorter_or_second((Some(b), self.store.prev(b)), (Some(a), self.store.prev(a))) {
            OneOfTwo::First => OneOfTwo::Second,
            OneOfTwo::Second => OneOfTwo::First,
        }
    }

    fn split_face(&mut self, from: CheckedCorner, to: CheckedCorner, split: Split<'_>) -> Connected {
        let kept = from.boundary(&self.store);
        let f = self.store.face(kept);
        let was_outer = self.is_outer(kept);
        let n = self.attach(from, to);
        let t = self.store.twin(n);
        self.store.set_boundary(n, kept);
        self.store.set_boundary(t, kept);
        let (before_n, before_t) = (self.store.prev(n), self.store.prev(t));
        let shorter = self.shorter_or_second((Some(n), before_n), (Some(t), before_t));
        let (made_start, made_last, kept_start) = match shorter {
            OneOfTwo::First => (n, before_n, t),
            OneOfTwo::Second => (t, before_t, n),
        };
        let made = self.store.add_boundary(f, BoundaryStart::HalfEdge(made_start));
        self.relabel(made_start, made_last, made);
        self.store.set_start(kept, BoundaryStart::HalfEdge(kept_start));

        let g = self.store.add_face();
        let new_side = match split.new_face {
            Side::Left => n,
            Side::Right => t,
        };
        let (of_new, of_old) = if made_start == new_side { (made, kept) } else { (kept, made) };
        if !was_outer {
            self.store.unlist(kept);
        }
        self.store.list_outer(g, of_new);
        self.list(f, of_old, was_outer);
        for key in split.inner {
            let named = self.store.find_boundary(*key);
            // A component named twice has moved already.
            if let Some(b) = named.filter(|b| self.store.face(*b) != g) {
                self.store.unlist(b);
                self.store.list_inner(g, b);
            }
        }
        Connected {
            half_edge: self.store.half_edge_key(n),
            connection: Connection::Split {
                kept: self.store.boundary_key(kept),
                made: self.store.boundary_key(made),
                face: self.store.face_key(g),
            },
        }
    }
}
