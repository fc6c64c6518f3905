//! Iterators that walk around until they return to the start.

use super::elements::HalfEdge;
use core::iter::FusedIterator;

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
    /// use twinedge::dcel::{Dcel, Split};
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// // A triangle: a loop with two more vertices on it. Its face lies to the left of h.
    /// let v = map.add_isolated_vertex(outside)?.vertex;
    /// let h = map.connect(v, v, Split::default())?.half_edge;
    /// map.split_edge(h)?;
    /// map.split_edge(h)?;
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
    /// use twinedge::dcel::{Dcel, Split};
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// // A triangle: a loop with two more vertices on it. Its face lies to the left of h.
    /// let v = map.add_isolated_vertex(outside)?.vertex;
    /// let h = map.connect(v, v, Split::default())?.half_edge;
    /// map.split_edge(h)?;
    /// map.split_edge(h)?;
    /// let h = map.half_edge(h)?;
    /// let mut rotation = h.rotation();
    /// assert_eq!(rotation.next(), Some(h));
    /// assert_eq!(rotation.next(), Some(h.prev().twin()));
    /// assert_eq!(rotation.next(), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Rotation, counter_clockwise, clockwise
}
