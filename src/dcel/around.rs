//! Walks from an element: around its vertex, along its cycle, over its face.

use super::circulators::{Cycle, Rotation};
use super::elements::{Boundary, Face, HalfEdge, Vertex};

impl<'a> Vertex<'a> {
    /// The half-edges that leave the vertex, counter-clockwise; `rev()` for clockwise. O(1) per step.
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
    /// let v = map.vertex(v)?;
    /// assert_eq!(v.rotation().count(), 2);
    /// assert!(v.rotation().all(|leaving| leaving.origin() == v));
    /// // Counter-clockwise from here, clockwise from there.
    /// assert_eq!(v.rotation().last(), v.rotation().next_back());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn rotation(self) -> Rotation<'a> {
        Rotation::new(self.leaving())
    }

    /// The vertices at the other ends of its edges, counter-clockwise. Parallel edges give the same vertex several times. A
    /// loop gives the vertex itself, twice. O(1) per step.
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
    /// let v = map.vertex(v)?;
    /// assert_eq!(v.neighbours().count(), 2);
    /// assert!(v.neighbours().all(|neighbour| neighbour != v));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn neighbours(self) -> impl Iterator<Item = Self> {
        self.rotation().map(HalfEdge::target)
    }

    /// Returns the number of half-edges that leave the vertex: a loop counts twice. O(degree).
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
    /// assert_eq!(map.vertex(v)?.degree(), 2);
    /// // A loop counts twice.
    /// map.connect(h, h, Split::default())?;
    /// assert_eq!(map.vertex(v)?.degree(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn degree(self) -> usize {
        self.rotation().count()
    }
}

impl<'a> HalfEdge<'a> {
    /// The half-edges that leave the same vertex, counter-clockwise from this one on. O(1) per step.
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
    /// assert_eq!(h.rotation().next(), Some(h));
    /// assert_eq!(h.rotation().nth(1), Some(h.counter_clockwise()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn rotation(self) -> Rotation<'a> {
        Rotation::new(Some(self))
    }

    /// The half-edges of its cycle, from this one on; `rev()` goes the other way. O(1) per step.
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
    /// assert!(h.boundary_cycle().eq([h, h.next(), h.prev()]));
    /// assert!(h.boundary_cycle().rev().eq([h.prev(), h.next(), h]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn boundary_cycle(self) -> Cycle<'a> {
        Cycle::new(Some(self))
    }
}

impl<'a> Boundary<'a> {
    /// The half-edges of its cycle; none if it is an isolated vertex. O(1) per step.
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
    /// let boundary = map.half_edge(h)?.boundary();
    /// assert!(boundary.half_edges().all(|h| h.boundary() == boundary));
    /// assert_eq!(boundary.half_edges().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn half_edges(self) -> Cycle<'a> {
        Cycle::new(self.start())
    }
}

impl<'a> Face<'a> {
    /// All its boundary components, the outer one first. O(1) per step.
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
    /// let triangle = map.half_edge(h)?.face().key();
    /// map.add_isolated_vertex(triangle)?;
    /// let places: Vec<_> = map.face(triangle)?.boundaries().map(|b| b.is_outer()).collect();
    /// assert_eq!(places, [true, false]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn boundaries(self) -> impl Iterator<Item = Boundary<'a>> {
        self.outer().into_iter().chain(self.inner())
    }

    /// All half-edges that have the face to their left. O(1) per step.
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
    /// assert_eq!(map.half_edge(h)?.face().half_edges().count(), 3);
    /// assert_eq!(map.unbounded_face().half_edges().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn half_edges(self) -> impl Iterator<Item = HalfEdge<'a>> {
        self.boundaries().flat_map(Boundary::half_edges)
    }

    /// The faces on the other sides of its half-edges. A face that shares several edges comes several times, and the face
    /// itself comes wherever both sides of an edge lie in it. O(1) per step.
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
    /// let triangle = map.half_edge(h)?.face();
    /// assert!(triangle.neighbours().all(|f| f.is_unbounded()));
    /// assert_eq!(triangle.neighbours().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn neighbours(self) -> impl Iterator<Item = Self> {
        self.half_edges().map(|h| h.twin().face())
    }
}
