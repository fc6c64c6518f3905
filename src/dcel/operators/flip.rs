//! Turns an edge inside the two faces that it separates.

use crate::dcel::access::OperatorError;
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryStart, HalfEdgeKey, HalfEdgeSlot, VertexLink};

/// The direction in which an edge turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Turn {
    /// Each end moves to the next vertex counter-clockwise, as seen from the middle of the edge.
    CounterClockwise,
    /// Each end moves to the next vertex clockwise.
    Clockwise,
}

impl Turn {
    /// Returns the opposite direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::CounterClockwise => Self::Clockwise,
            Self::Clockwise => Self::CounterClockwise,
        }
    }
}

impl Dcel {
    /// Turns an edge one step: each end moves to the next vertex along the boundary of the two faces that the edge
    /// separates. In a triangulation this flips a diagonal.
    ///
    #[doc = include_str!("../pictures/flip_edge.svg")]
    ///
    /// A loop that alone bounds one face slides along the boundary of the face on its other side. O(1).
    ///
    /// Inverse: `flip_edge` with [`Turn::reversed`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NotSeparating`] if both sides of the edge lie on the same boundary component.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, Split, Turn};
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let (v, h) = (keys.vertex(0).unwrap(), keys.half_edge(0).unwrap());
    /// // A fourth vertex, and a diagonal.
    /// map.split_edge(h)?;
    /// let third = map.half_edge(h)?.next().next().key();
    /// let diagonal = map.connect(h, third, Split::default())?.half_edge;
    /// let ends = |map: &Dcel| map.half_edge(diagonal).map(|h| [h.origin().key(), h.target().key()]);
    /// let before = ends(&map)?;
    /// map.flip_edge(diagonal, Turn::CounterClockwise)?;
    /// assert!(ends(&map)?.iter().all(|v| !before.contains(v)));
    /// map.flip_edge(diagonal, Turn::Clockwise)?;
    /// assert_eq!(ends(&map)?, before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), OperatorError> {
        let n = self.half_edge_slot(half_edge)?;
        let t = self.store.twin(n);
        let (bn, bt) = (self.store.boundary(n), self.store.boundary(t));
        if bn == bt {
            return Err(OperatorError::NotSeparating(half_edge));
        }
        match (self.store.next(n) == n, self.store.next(t) == t) {
            (true, true) => return Ok(()),
            (true, false) => self.slide(n, t, turn)?,
            (false, true) => self.slide(t, n, turn)?,
            (false, false) => {
                self.follow(move |dcel| dcel.steps_to_flip([n, t], turn))?;
                self.release_end(n);
                self.release_end(t);
                match turn {
                    Turn::CounterClockwise => self.turn_counter_clockwise(n, t),
                    Turn::Clockwise => self.turn_clockwise(n, t),
                }
            }
        }
        self.store.set_start(bn, BoundaryStart::HalfEdge(n));
        self.store.set_start(bt, BoundaryStart::HalfEdge(t));
        Ok(())
    }

    fn release_end(&mut self, h: HalfEdgeSlot) {
        let other = self.store.next(self.store.twin(h));
        self.store.set_vertex_link(self.store.origin(h), VertexLink::Leaving(other));
    }

    /// `x` and `y`, the first half-edges after `n` and `t`, change sides.
    fn turn_counter_clockwise(&mut self, n: HalfEdgeSlot, t: HalfEdgeSlot) {
        let (x, y) = (self.store.next(n), self.store.next(t));
        let (before_n, before_t) = (self.store.prev(n), self.store.prev(t));
        // Without the edge there is one cycle …
        self.store.join(before_n, y);
        self.store.join(before_t, x);
        let (after_x, after_y) = (self.store.next(x), self.store.next(y));
        // … which is cut again one step further.
        self.store.join(y, n);
        self.store.join(n, after_x);
        self.store.join(x, t);
        self.store.join(t, after_y);
        self.store.set_origin(n, self.store.origin(after_y));
        self.store.set_origin(t, self.store.origin(after_x));
        self.swap_sides(x, y);
    }

    /// `x` and `y`, the last half-edges before `n` and `t`, change sides.
    fn turn_clockwise(&mut self, n: HalfEdgeSlot, t: HalfEdgeSlot) {
        let (x, y) = (self.store.prev(n), self.store.prev(t));
        let (after_n, after_t) = (self.store.next(n), self.store.next(t));
        self.store.join(x, after_t);
        self.store.join(y, after_n);
        let (before_x, before_y) = (self.store.prev(x), self.store.prev(y));
        self.store.join(n, y);
        self.store.join(before_x, n);
        self.store.join(t, x);
        self.store.join(before_y, t);
        self.store.set_origin(n, self.store.origin(x));
        self.store.set_origin(t, self.store.origin(y));
        self.swap_sides(x, y);
    }

    fn swap_sides(&mut self, x: HalfEdgeSlot, y: HalfEdgeSlot) {
        let (bx, by) = (self.store.boundary(x), self.store.boundary(y));
        self.store.set_boundary(x, by);
        self.store.set_boundary(y, bx);
    }

    /// Slides a loop, which alone forms the cycle on the side of `lone`, along the cycle on the side of `t`.
    fn slide(&mut self, lone: HalfEdgeSlot, t: HalfEdgeSlot, turn: Turn) -> Result<(), OperatorError> {
        let (before, after) = (self.store.prev(t), self.store.next(t));
        self.follow(move |dcel| dcel.steps_to_slide([lone, t], turn))?;
        self.store.set_vertex_link(self.store.origin(t), VertexLink::Leaving(after));
        self.store.join(before, after);
        let (last, first) = match turn {
            Turn::CounterClockwise => (after, self.store.next(after)),
            Turn::Clockwise => (self.store.prev(before), before),
        };
        self.store.join(last, t);
        self.store.join(t, first);
        let v = self.store.origin(first);
        self.store.set_origin(t, v);
        self.store.set_origin(lone, v);
        Ok(())
    }
}
