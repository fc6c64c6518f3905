//! Walks from an element: around its vertex, along its cycle, over its face.

use super::elements::{Boundary, Cycle, Face, HalfEdge, Rotation, Vertex};

impl<'a> Vertex<'a> {
    /// Returns the half-edges that leave the vertex, counter-clockwise; `rev()` for clockwise. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let v = keys.vertex(0).unwrap();
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

    /// Returns the neighbours of the vertex, counter-clockwise. A neighbour is repeated for each parallel edge; a loop
    /// yields the vertex itself, twice. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let v = keys.vertex(0).unwrap();
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
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let (v, h) = (keys.vertex(0).unwrap(), keys.half_edge(0).unwrap());
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
    /// Returns the half-edges that leave the same vertex, counter-clockwise from this one. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
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

    /// Returns the half-edges of the cycle from this one on; `rev()` goes the other way. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
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
    /// Returns the half-edges of the cycle; none for an isolated vertex. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
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
    /// Returns all boundary components of the face, the outer one first. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let triangle = map.half_edge(h)?.face().key();
    /// map.add_isolated_vertex(triangle)?;
    /// let places: Vec<_> = map.face(triangle)?.boundaries().map(|b| b.is_outer()).collect();
    /// assert_eq!(places, [true, false]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn boundaries(self) -> impl Iterator<Item = Boundary<'a>> {
        self.outer().into_iter().chain(self.inner())
    }

    /// Returns all half-edges with the face to their left, those of the outer boundary component first. O(1) per step. For that component alone,
    /// the [cycle](HalfEdge::boundary_cycle) of [`outer_half_edge`](Self::outer_half_edge) takes half the time.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// assert_eq!(map.half_edge(h)?.face().half_edges().count(), 3);
    /// assert_eq!(map.unbounded_face().half_edges().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn half_edges(self) -> impl Iterator<Item = HalfEdge<'a>> {
        let (mut cycle, mut position) = (Cycle::new(self.outer_half_edge()), 0);
        core::iter::from_fn(move || {
            loop {
                if let Some(h) = cycle.next() {
                    return Some(h);
                }
                // An isolated vertex has no half-edges.
                cycle = Boundary::half_edges(self.inner_at(position)?);
                position += 1;
            }
        })
    }

    /// Returns the faces on the other sides of the face's half-edges. A face is repeated for each shared edge, and the face
    /// itself is included where both sides of an edge lie in it. O(1) per step.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let (map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let triangle = map.half_edge(h)?.face();
    /// assert!(triangle.neighbours().all(|f| f.is_unbounded()));
    /// assert_eq!(triangle.neighbours().count(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn neighbours(self) -> impl Iterator<Item = Self> {
        self.half_edges().map(|h| h.twin().face())
    }
}
