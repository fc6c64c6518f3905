//! Drawing points, segments and rings at their exact coordinates.

use super::at::At;
use super::error::EditError;
use super::outcome::Edited;
use crate::planar_map::PlanarMap;

impl PlanarMap {
    /// Inserts a vertex at a point. Reuses an existing vertex, splits the edge at the point, or adds an isolated vertex.
    ///
    /// [`Edited::vertices`] contains the vertex; [`Edited::vertices_made`] is empty if the vertex existed.
    ///
    /// O(1) after the point is located; see [`At`].
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_segment([0.0, 0.0], [2.0, 2.0])?;
    /// let on_the_edge = map.insert_point([1.0, 1.0])?;
    /// assert_eq!(on_the_edge.edges_split.len(), 1);
    /// assert_eq!(map.insert_point([1.0, 1.0])?.vertices, on_the_edge.vertices);
    /// // Only just off the edge is in the face.
    /// let isolated = map.insert_point([0.5, 0.5 + f64::EPSILON])?;
    /// assert!(isolated.edges_split.is_empty());
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`], [`EditError::NotFinite`], [`EditError::OutOfRange`], [`EditError::Operator`] for a stale key or a
    /// full map.
    pub fn insert_point(&mut self, at: impl Into<At>) -> Result<Edited, EditError> {
        self.draw(&[at.into()], false)
    }

    /// Inserts a segment, exactly.
    ///
    /// ```text
    ///   ·─────┬─────·               ·─────┬─────·
    ///   │     │     │               │     │     │
    ///   ├─────┼─────┤      ──►      ├─────┼─────┤
    ///   │     │     │               │     │  ╱  │
    ///   ·─────┴─────·               ·─────┴─╱───·
    ///                                      ╱
    /// ```
    ///
    /// Vertices on the segment divide it into several edges. An end inside an edge splits the edge. An edge along the segment is
    /// reused. A crossing with an edge is refused, since in general no double is exactly at the crossing;
    /// [`insert_segment_snapped`](Self::insert_segment_snapped) rounds crossings.
    ///
    /// When a bounded face is split, the part with the shorter outer boundary is the new face; on a tie, the left part.
    ///
    /// The cost of finding the obstacles on the segment in the index ([costs](crate::edit#costs)), after its first point is
    /// located; see [`At`]. For each face split into parts with boundaries of lengths s and t, s ≤ t, at most O(k + (s + j) log
    /// (s + j)), where j of its k inner boundary components meet the box around the first part.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::edit::EditError;
    ///
    /// let mut map = PlanarMap::new();
    /// let wall = map.insert_segment([0.0, 0.0], [4.0, 0.0])?.way[0];
    /// assert_eq!(map.insert_segment([1.0, 1.0], [1.0, -1.0]), Err(EditError::Crosses(wall)));
    /// // Of this the middle is there.
    /// let longer = map.insert_segment([-2.0, 0.0], [6.0, 0.0])?;
    /// assert_eq!((longer.way.len(), longer.way[1], longer.edges_made.len()), (3, wall, 2));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::NotFinite`]; [`EditError::OutOfRange`]; [`EditError::NoLength`];
    /// [`EditError::Crosses`]; [`EditError::Operator`] for a stale key or a full map.
    pub fn insert_segment(&mut self, from: impl Into<At>, to: impl Into<At>) -> Result<Edited, EditError> {
        self.draw(&[from.into(), to.into()], false)
    }

    /// Inserts a closed chain of segments by [`insert_segment`](Self::insert_segment), all or none. The last may repeat the
    /// first.
    ///
    /// The ring may touch itself and run along itself, but not cross itself.
    ///
    /// O(sizes of the faces that each of its m segments passes + m log m) after the first point is located, plus the cost of each
    /// face split. O(m²) if the ring touches itself other than at its points. Atomicity needs no copies: the ring is checked
    /// against the map and against itself before anything changes.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_ring([[0.0, 0.0], [8.0, 0.0], [0.0, 8.0], [0.0, 0.0]])?;
    /// let lake = map.insert_ring([[1.0, 1.0], [3.0, 1.0], [1.0, 3.0]])?;
    /// assert_eq!((lake.way.len(), map.dcel().face_count()), (3, 3));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotARing`]; [`EditError::SelfCrossing`]; and the errors of [`insert_segment`](Self::insert_segment).
    pub fn insert_ring(&mut self, points: impl IntoIterator<Item = impl Into<At>>) -> Result<Edited, EditError> {
        let mut points: Vec<At> = points.into_iter().map(Into::into).collect();
        let repeats_first = match points[..] {
            [first, .., last] => self.point_of(first)? == self.point_of(last)?,
            _ => false,
        };
        if repeats_first {
            points.pop();
        }
        if points.len() < 3 {
            return Err(EditError::NotARing { points: points.len() });
        }
        self.draw(&points, true)
    }
}
